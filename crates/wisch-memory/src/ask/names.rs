//! Resolution of names in a query: classes, properties and things of the memory.

use super::error::QueryFault;
use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId};
use crate::ontology::{Ontology, TermKind};
use crate::statements::individual_of;
use std::collections::BTreeMap;
use std::sync::Arc;
use wisch::source_location::UnknownName;

/// Concepts that classify events of a class: SOMA's `Collision` is a concept, `semco:Collision` the event, and both
/// find it.
const CLASSIFIED: [(&str, &str); 1] = [("soma:Collision", "semco:Collision")];
/// Properties that the catalogue stores in other ways.
const STRUCTURAL: [&str; 10] = [
    "rdfs:label",
    "rdfs:comment",
    "rdf:type",
    "rdfs:subClassOf",
    "dul:hasConstituent",
    "dul:isConstituentOf",
    "dul:isParticipantIn",
    "dul:isExecutedIn",
    "dul:classifies",
    "dul:hasParticipant",
];
/// Class of all events, whose individuals need a time.
const EVENT: &str = "dul:Event";
/// Largest number of characters of the name of an added individual.
const LONGEST_NAME: usize = 100;
/// Relations that imply the class of a shared thing that the ontology does not know.
const CLASS_BY_RELATION: [(&str, &str); 4] = [
    ("semco:usesTool", "semco:WipingTool"),
    ("semco:removesMedium", "semco:Medium"),
    ("semco:actsOnSurface", "semco:WipedSurface"),
    ("soma:isPerformedBy", "semco:WipingRobot"),
];

/// A resolver of the names that queries write.
pub struct Names {
    catalogue: Arc<Catalogue>,
    ontology: &'static Ontology,
    /// Classes of shared things.
    shared: BTreeMap<String, String>,
}

impl Names {
    /// Creates the resolver for these episodes.
    pub fn new(catalogue: Arc<Catalogue>, ontology: &'static Ontology) -> Self {
        let mut shared = BTreeMap::new();
        for name in ontology.individuals() {
            if let Some(class) = ontology.term(name).and_then(|term| term.parents.first()) {
                shared.insert(name.to_owned(), class.clone());
            }
        }
        for (property, class) in CLASS_BY_RELATION {
            for (_, node) in catalogue.relations(property) {
                if let CatalogueNode::Shared(number) = node {
                    let name = &catalogue.shared_individuals()[*number as usize];
                    if !shared.contains_key(name) {
                        shared.insert(name.clone(), class.to_owned());
                    }
                }
            }
        }
        Self {
            catalogue,
            ontology,
            shared,
        }
    }

    /// Returns the full name of a class, property or thing.
    pub fn resolve(&self, kind: &str, term: &Term) -> Result<String, QueryFault> {
        let unknown = |error: &UnknownName| {
            // With an unknown prefix, the prefix is the fault, not the name.
            let kind = if error.kind == "prefix" {
                "prefix"
            } else {
                kind
            };
            QueryFault::unknown(kind, term, error.nearest())
        };
        let found = match term {
            Term::Compound(colon, parts) if colon == ":" => match parts.as_slice() {
                [Term::Atom(prefix), Term::Atom(local)] => self
                    .with_prefix(prefix, local)
                    .map_err(|error| unknown(&error))?,
                _ => return Err(QueryFault::no_name(term)),
            },
            Term::Atom(name) => match (self.ontology.compact(name), name.split_once(':')) {
                (Some(name), _) => {
                    let (prefix, local) = name.split_once(':').unwrap_or(("", &name));
                    self.with_prefix(prefix, local)
                        .map_err(|error| unknown(&error))?
                }
                (None, Some((prefix, local))) => self
                    .with_prefix(prefix, local)
                    .map_err(|error| unknown(&error))?,
                (None, None) => self.bare(kind, name).map_err(|error| unknown(&error))?,
            },
            _ => return Err(QueryFault::no_name(term)),
        };
        self.of_kind(kind, found, term)
    }

    fn of_kind(&self, kind: &str, found: String, term: &Term) -> Result<String, QueryFault> {
        let known = self.ontology.kind(&found);
        let fits = match kind {
            "class" => known == Some(TermKind::Class),
            "property" => {
                known.is_some_and(TermKind::is_property) || STRUCTURAL.contains(&found.as_str())
            }
            _ => true,
        };
        if fits {
            return Ok(found);
        }
        let local = found
            .split_once(':')
            .map_or(found.as_str(), |(_, local)| local);
        let nearest = self.nearest(kind, local);
        Err(QueryFault::unknown(kind, term, nearest.as_deref()))
    }

    fn nearest(&self, kind: &str, local: &str) -> Option<String> {
        let names: Vec<&str> = match kind {
            "class" => self.ontology.classes().collect(),
            "property" => self.ontology.properties().collect(),
            _ => self.shared.keys().map(String::as_str).collect(),
        };
        let locals = names
            .iter()
            .filter_map(|name| name.split_once(':').map(|(_, local)| local));
        let error = UnknownName::new("name", local, locals);
        let nearest = error.nearest()?;
        let named = names
            .into_iter()
            .find(|name| name.ends_with(&format!(":{nearest}")));
        named.map(str::to_owned)
    }

    fn with_prefix(&self, prefix: &str, local: &str) -> Result<String, UnknownName> {
        let name = format!("{prefix}:{local}");
        if prefix == "semco" && self.catalogue.find(local).is_some()
            || self.shared.contains_key(&name) && self.ontology.term(&name).is_none()
            || STRUCTURAL.contains(&name.as_str())
        {
            return Ok(name);
        }
        self.ontology.resolve(prefix, local).map(str::to_owned)
    }

    fn bare(&self, kind: &str, local: &str) -> Result<String, UnknownName> {
        if self.catalogue.find(local).is_some() {
            return Ok(format!("semco:{local}"));
        }
        let shared = format!("semco:{local}");
        if self.shared.contains_key(&shared) {
            return Ok(shared);
        }
        let structural = STRUCTURAL.iter().find(|name| {
            name.split_once(':')
                .is_some_and(|(_, structural)| structural == local)
        });
        match (structural, self.ontology.resolve_bare(local)) {
            (Some(name), _) if kind == "property" => Ok((*name).to_owned()),
            (_, found) => found.map(str::to_owned),
        }
    }

    /// Returns the full name of an individual that a query adds; `None` if it is known and of this class.
    ///
    /// # Errors
    /// If it is known and of another class, the class is one of events, or the name is not a possible one.
    pub fn check_new_individual(
        &self,
        term: &Term,
        class: &str,
    ) -> Result<Option<String>, QueryFault> {
        let refuse = |what: String| Err(QueryFault::Prolog { what });
        if let Ok(name) = self.resolve("thing", term) {
            let own = match self.individual(&name) {
                Some(id) => Some(self.catalogue.class(id).to_owned()),
                None => self.class_of_shared(&name),
            };
            return match own {
                Some(own) if or_itself(&own, self.ontology.superclasses(&own)).contains(&class) => {
                    Ok(None)
                }
                Some(own) => refuse(format!(
                    "{name} is a {own}, and tell cannot make it a {class}; choose another name"
                )),
                None => refuse(format!(
                    "{name} is a class or a property of the ontology; choose another name"
                )),
            };
        }
        if or_itself(class, self.ontology.superclasses(class)).contains(&EVENT) {
            return refuse(format!(
                "{class} is a class of events, which only episodes add; tell adds tools, surfaces, media, robots and other things"
            ));
        }
        let (prefix, local) = match term {
            Term::Compound(colon, parts) if colon == ":" => match parts.as_slice() {
                [Term::Atom(prefix), Term::Atom(local)] => (prefix.as_str(), local.as_str()),
                _ => return Err(QueryFault::no_name(term)),
            },
            Term::Atom(name) => name.split_once(':').unwrap_or(("semco", name)),
            _ => return Err(QueryFault::no_name(term)),
        };
        let length = local.chars().count();
        let is_plain = local.starts_with(char::is_alphabetic)
            && local
                .chars()
                .all(|c| c.is_alphanumeric() || "_-.".contains(c));
        let name = format!("semco:{local}");
        if prefix != "semco" {
            refuse(format!(
                "{prefix}:{local}: new individuals have the prefix semco"
            ))
        } else if length > LONGEST_NAME {
            refuse(format!(
                "the name has {length} characters, but a new individual has at most {LONGEST_NAME}"
            ))
        } else if !is_plain {
            refuse(format!(
                "{name}: the name of a new individual begins with a letter, and consists of letters, digits, _, - and ."
            ))
        } else if individual_of(&name).is_some() {
            refuse(format!(
                "{name}: names of the form Class_episode-number belong to episodes; choose another name"
            ))
        } else {
            Ok(Some(name))
        }
    }

    /// Adds an individual by a person. The ontology's own individuals keep their classes.
    pub fn add_individual(&mut self, name: &str, class: &str) {
        if self.ontology.term(name).is_none() {
            self.shared.insert(name.to_owned(), class.to_owned());
        }
    }

    /// Removes an individual that a query added.
    pub fn remove_individual(&mut self, name: &str) {
        self.shared.remove(name);
    }

    /// Returns the individual with this full name.
    pub fn individual(&self, name: &str) -> Option<IndividualId> {
        self.catalogue.find(name.strip_prefix("semco:")?)
    }

    /// Returns the object of relations with this full name.
    pub fn node(&self, name: &str) -> Option<CatalogueNode> {
        if let Some(id) = self.individual(name) {
            return Some(CatalogueNode::Individual(id));
        }
        let place = self
            .catalogue
            .shared_individuals()
            .iter()
            .position(|shared| shared == name)?;
        u32::try_from(place).ok().map(CatalogueNode::Shared)
    }

    /// Returns the class of a shared thing.
    pub fn class_of_shared(&self, name: &str) -> Option<String> {
        self.shared.get(name).cloned()
    }

    /// Returns the shared things of exactly this class.
    pub fn share_names(&self, class: &str) -> Vec<String> {
        let of_class = self.shared.iter().filter(|(_, of)| *of == class);
        of_class.map(|(name, _)| name.clone()).collect()
    }

    pub fn subclasses(&self, name: &str) -> Vec<Term> {
        let mut found = or_itself(name, self.ontology.subclasses(name));
        for (concept, class) in CLASSIFIED {
            if found.contains(&concept) {
                found.extend(or_itself(class, self.ontology.subclasses(class)));
            }
        }
        found.into_iter().map(Term::atom).collect()
    }

    pub fn superclasses(&self, name: &str) -> Vec<Term> {
        let found = or_itself(name, self.ontology.superclasses(name));
        found.into_iter().map(Term::atom).collect()
    }

    pub fn subproperties(&self, name: &str) -> Vec<Term> {
        let found = or_itself(name, self.ontology.subproperties(name));
        found.into_iter().map(Term::atom).collect()
    }

    pub fn superproperties(&self, name: &str) -> Vec<Term> {
        let found = or_itself(name, self.ontology.superproperties(name));
        found.into_iter().map(Term::atom).collect()
    }
}

fn or_itself<'a>(name: &'a str, found: Result<Vec<&'a str>, UnknownName>) -> Vec<&'a str> {
    found.unwrap_or_else(|_| vec![name])
}
