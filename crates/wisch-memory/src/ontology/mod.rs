//! Ontology of the names in an episode: classes, properties and shared things of wiping, below SOMA and DUL.
//!
//! The ontology is `ontology/semco.owl`. `ontology/upper.owl` states the axioms of SOMA and DUL on which it rests, so
//! that closures need no other files.

mod read;
#[cfg(test)]
mod tests;

pub use read::OntologyError;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use wisch::source_location::UnknownName;

/// Prefixes and their namespaces. A bare name is searched in this order.
const PREFIXES: [(&str, &str); 8] = [
    ("semco", "https://wisch-project.org/ont/semco.owl#"),
    ("soma", "http://www.ease-crc.org/ont/SOMA.owl#"),
    (
        "dul",
        "http://www.ontologydesignpatterns.org/ont/dul/DUL.owl#",
    ),
    ("justin", "https://wisch-project.org/ont/justin.owl#"),
    ("rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"),
    ("rdfs", "http://www.w3.org/2000/01/rdf-schema#"),
    ("owl", "http://www.w3.org/2002/07/owl#"),
    ("xsd", "http://www.w3.org/2001/XMLSchema#"),
];

/// The text of `ontology/semco.owl`, in RDF/XML.
pub const SEMCO_OWL: &str = include_str!("../../ontology/semco.owl");
const UPPER_OWL: &str = include_str!("../../ontology/upper.owl");

/// The kind of thing that a name denotes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TermKind {
    /// A class of things or events.
    Class,
    /// A relation to other things.
    ObjectProperty,
    /// A relation to numbers or texts.
    DataProperty,
    /// A thing that episodes share, for example `semco:sponge`.
    Individual,
}

impl TermKind {
    /// The word for the kind in messages.
    pub fn word(self) -> &'static str {
        match self {
            Self::Class => "class",
            Self::ObjectProperty | Self::DataProperty => "property",
            Self::Individual => "individual",
        }
    }

    /// Whether the name is that of a property.
    pub fn is_property(self) -> bool {
        matches!(self, Self::ObjectProperty | Self::DataProperty)
    }
}

/// The axioms of the ontology about one name.
#[derive(Debug, Clone, PartialEq)]
pub struct OntologyTerm {
    /// Kind of the name.
    pub kind: TermKind,
    /// Direct parents: classes of a class or individual, properties of a property.
    pub parents: Vec<String>,
    /// Class of a property's subjects.
    pub domain: Option<String>,
    /// Class or datatype of a property's objects.
    pub range: Option<String>,
    /// The individual for which it is another name.
    pub same_as: Option<String>,
    /// Label; empty for a term of SOMA or DUL.
    pub label: String,
    /// Meaning, with the unit if there is one; empty for a term of SOMA or DUL.
    pub comment: String,
}

/// Classes, properties and shared individuals by their names with prefix, such as `semco:Collision`.
///
/// ```
/// use wisch_memory::Ontology;
///
/// let ontology = Ontology::load();
/// assert!(ontology.superclasses("semco:HumanCollision")?.contains(&"dul:Process"));
/// assert_eq!(ontology.types_of("semco:sponge")?[..2], ["semco:Sponge", "semco:WipingTool"]);
/// assert_eq!(ontology.resolve("justin", "justin_robot1")?, "semco:humanoid");
/// assert_eq!(
///     ontology.resolve("semco", "Colision").unwrap_err().nearest(),
///     Some("semco:Collision")
/// );
/// # Ok::<(), wisch::source_location::UnknownName>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ontology {
    terms: BTreeMap<String, OntologyTerm>,
    children: BTreeMap<String, Vec<String>>,
}

impl Ontology {
    /// Returns the ontology of this program, which is parsed once.
    ///
    /// # Panics
    /// If a file that was compiled in is not an ontology, which a test excludes.
    pub fn load() -> &'static Self {
        static SHIPPED: LazyLock<Ontology> = LazyLock::new(|| {
            Ontology::read(&[
                ("ontology/upper.owl", UPPER_OWL),
                ("ontology/semco.owl", SEMCO_OWL),
            ])
            .expect("the shipped ontology is valid")
        });
        &SHIPPED
    }

    /// Reads files in RDF/XML, given as names and texts; parents may be in any of them.
    ///
    /// # Errors
    /// [`OntologyError`], at the first fault.
    pub fn read(files: &[(&str, &str)]) -> Result<Self, OntologyError> {
        let mut terms = BTreeMap::new();
        for (file, text) in files {
            read::read_file(file, text, &mut terms)?;
        }
        let mut children = BTreeMap::<String, Vec<String>>::new();
        for (name, term) in &terms {
            for parent in &term.parents {
                children
                    .entry(parent.clone())
                    .or_default()
                    .push(name.clone());
            }
        }
        let ontology = Self { terms, children };
        ontology.check()?;
        Ok(ontology)
    }

    /// Checks that parents exist and are of the right kind, and that there are no cycles.
    fn check(&self) -> Result<(), OntologyError> {
        for (name, term) in &self.terms {
            let kind = match term.kind {
                TermKind::Individual => TermKind::Class,
                kind => kind,
            };
            for parent in &term.parents {
                if self.kind(parent) != Some(kind) {
                    return Err(OntologyError::Parent {
                        name: name.clone(),
                        parent: parent.clone(),
                        kind: kind.word(),
                    });
                }
                if term.kind != TermKind::Individual && self.above(parent).contains(&name.as_str())
                {
                    return Err(OntologyError::Circle { name: name.clone() });
                }
            }
        }
        Ok(())
    }

    /// All terms, sorted by name, with prefix.
    pub fn terms(&self) -> impl Iterator<Item = (&str, &OntologyTerm)> {
        self.terms.iter().map(|(name, term)| (name.as_str(), term))
    }

    /// All classes, sorted by name, with prefix.
    pub fn classes(&self) -> impl Iterator<Item = &str> {
        self.of_kind(|kind| kind == TermKind::Class)
    }

    /// All properties, sorted by name, with prefix.
    pub fn properties(&self) -> impl Iterator<Item = &str> {
        self.of_kind(TermKind::is_property)
    }

    /// All shared individuals, sorted by name, with prefix.
    pub fn individuals(&self) -> impl Iterator<Item = &str> {
        self.of_kind(|kind| kind == TermKind::Individual)
    }

    fn of_kind(&self, wanted: impl Fn(TermKind) -> bool) -> impl Iterator<Item = &str> {
        self.terms()
            .filter(move |(_, term)| wanted(term.kind))
            .map(|(name, _)| name)
    }

    /// Axioms about a name, if it is known.
    pub fn term(&self, name: &str) -> Option<&OntologyTerm> {
        self.terms.get(name)
    }

    /// Kind of a name, if it is known.
    pub fn kind(&self, name: &str) -> Option<TermKind> {
        self.term(name).map(|term| term.kind)
    }

    /// Returns the class and all classes above it: itself first, then level by level.
    ///
    /// # Errors
    /// If the name is not a class.
    pub fn superclasses(&self, class: &str) -> Result<Vec<&str>, UnknownName> {
        let class = self.expect(class, "class", |kind| kind == TermKind::Class)?;
        Ok(self.above(class))
    }

    /// Returns the class and all classes below it: itself first, then level by level.
    ///
    /// # Errors
    /// If the name is not a class.
    pub fn subclasses(&self, class: &str) -> Result<Vec<&str>, UnknownName> {
        let class = self.expect(class, "class", |kind| kind == TermKind::Class)?;
        let below = self.below(class).into_iter();
        Ok(below
            .filter(|name| self.kind(name) == Some(TermKind::Class))
            .collect())
    }

    /// Returns the property and all properties above it: itself first, then level by level.
    ///
    /// # Errors
    /// If the name is not a property.
    pub fn superproperties(&self, property: &str) -> Result<Vec<&str>, UnknownName> {
        let property = self.expect(property, "property", TermKind::is_property)?;
        Ok(self.above(property))
    }

    /// Returns the property and all properties below it: itself first, then level by level.
    ///
    /// # Errors
    /// If the name is not a property.
    pub fn subproperties(&self, property: &str) -> Result<Vec<&str>, UnknownName> {
        let property = self.expect(property, "property", TermKind::is_property)?;
        Ok(self.below(property))
    }

    /// Returns all classes of a shared individual, the nearest first.
    ///
    /// # Errors
    /// If the name is not a shared individual.
    pub fn types_of(&self, individual: &str) -> Result<Vec<&str>, UnknownName> {
        let individual = self.expect(individual, "individual", |kind| {
            kind == TermKind::Individual
        })?;
        let mut types = self.above(individual);
        types.remove(0);
        Ok(types)
    }

    /// Returns the IRI of a name with prefix; the name need not be known.
    ///
    /// # Errors
    /// If the prefix is missing or unknown.
    pub fn expand(&self, name: &str) -> Result<String, UnknownName> {
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        Ok(format!("{}{local}", namespace(prefix)?))
    }

    /// Returns the name with prefix of an IRI, if its namespace has a prefix.
    pub fn compact(&self, iri: &str) -> Option<String> {
        compact(iri)
    }

    /// Returns the class, property or individual with this prefix and local name; synonyms resolve to the thing itself.
    ///
    /// # Errors
    /// If the prefix or name is unknown; the error states the nearest names.
    pub fn resolve(&self, prefix: &str, local: &str) -> Result<&str, UnknownName> {
        namespace(prefix)?;
        self.expect(
            &format!("{prefix}:{local}"),
            "class, property or individual",
            |_| true,
        )
        .map(|name| self.proper(name))
    }

    /// Returns the class, property or individual with this local name, searched in the order of the prefixes.
    ///
    /// # Errors
    /// If the name is unknown; the error states the nearest names.
    pub fn resolve_bare(&self, local: &str) -> Result<&str, UnknownName> {
        let found = PREFIXES
            .iter()
            .find_map(|(prefix, _)| self.terms.get_key_value(&format!("{prefix}:{local}")));
        match found {
            Some((name, _)) => Ok(self.proper(name)),
            None => Err(UnknownName::new(
                "class, property or individual",
                local,
                self.terms
                    .keys()
                    .filter_map(|name| name.split_once(':').map(|(_, local)| local)),
            )),
        }
    }

    fn proper<'a>(&'a self, name: &'a str) -> &'a str {
        self.term(name)
            .and_then(|term| term.same_as.as_deref())
            .unwrap_or(name)
    }

    fn expect(
        &self,
        name: &str,
        kind: &'static str,
        wanted: impl Fn(TermKind) -> bool,
    ) -> Result<&str, UnknownName> {
        match self.terms.get_key_value(name) {
            Some((name, term)) if wanted(term.kind) => Ok(name),
            _ => Err(UnknownName::new(kind, name, self.of_kind(wanted))),
        }
    }

    fn above<'a>(&'a self, name: &'a str) -> Vec<&'a str> {
        closure(name, |name| {
            self.terms
                .get(name)
                .map_or(&[], |term| term.parents.as_slice())
        })
    }

    fn below<'a>(&'a self, name: &'a str) -> Vec<&'a str> {
        closure(name, |name| {
            self.children.get(name).map_or(&[], Vec::as_slice)
        })
    }
}

/// Returns a name and everything reachable from it, level by level, each once.
fn closure<'a>(name: &'a str, next: impl Fn(&str) -> &'a [String]) -> Vec<&'a str> {
    let mut reached = vec![name];
    let mut done = 0;
    while let Some(&name) = reached.get(done) {
        for name in next(name) {
            if !reached.contains(&name.as_str()) {
                reached.push(name);
            }
        }
        done += 1;
    }
    reached
}

fn namespace(prefix: &str) -> Result<&'static str, UnknownName> {
    PREFIXES
        .iter()
        .find(|(known, _)| *known == prefix)
        .map(|(_, namespace)| *namespace)
        .ok_or_else(|| UnknownName::new("prefix", prefix, PREFIXES.map(|(prefix, _)| prefix)))
}

fn compact(iri: &str) -> Option<String> {
    PREFIXES.iter().find_map(|(prefix, namespace)| {
        let local = iri.strip_prefix(namespace)?;
        (!local.is_empty()).then(|| format!("{prefix}:{local}"))
    })
}
