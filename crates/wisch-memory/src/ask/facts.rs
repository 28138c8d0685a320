//! Facts in an engine, each sent once.

use super::rows::{individual_row, name_of, relation_row, share_row, value_row, values};
use super::streams::Knowledge;
use super::term::Term;
use crate::catalogue::{Catalogue, IndividualId, entries};
use std::collections::{HashMap, HashSet};

/// Number of names in one fact about a class.
const NAMES_IN_A_FACT: usize = 512;
/// Number of individuals that are sent at once: the requested one and its neighbours, mostly of the same episode.
const INDIVIDUALS_AT_ONCE: usize = 8;
/// Number of values of a property that are sent at once.
const VALUES_AT_ONCE: usize = 64;

/// Record of the facts that an engine has.
#[derive(Debug, Default)]
pub struct SentFacts {
    individuals: HashSet<IndividualId>,
    shared: HashSet<String>,
    /// Episodes whose parts were all sent.
    episodes: HashSet<String>,
    values: HashMap<String, HashSet<IndividualId>>,
    statements: HashSet<IndividualId>,
    assertions: HashSet<String>,
}

impl SentFacts {
    /// Returns the members of exactly this class.
    pub fn members(&mut self, known: &Knowledge, class: &str) -> Vec<Term> {
        let mut facts = Vec::new();
        let members = known.catalogue.individuals_of_class(class);
        let mut names: Vec<Term> = Vec::with_capacity(members.len());
        for &id in members {
            self.send_individual(&known.catalogue, id, &mut facts);
            names.push(name_of(&known.catalogue, id));
        }
        for name in known.names.share_names(class) {
            self.send_shared(&name, class, &mut facts);
            names.push(Term::Atom(name));
        }
        facts.extend(list_facts("c", &Term::atom(class), names));
        facts
    }

    fn send_individual(&mut self, catalogue: &Catalogue, id: IndividualId, facts: &mut Vec<Term>) {
        if self.individuals.insert(id) {
            facts.push(individual_row(catalogue, id));
        }
    }

    fn send_shared(&mut self, name: &str, class: &str, facts: &mut Vec<Term>) {
        if self.shared.insert(name.to_owned()) {
            facts.push(share_row(name, class));
        }
    }

    /// Returns the facts about an individual and its neighbours of the same class, which queries mostly need next.
    pub fn individual(&mut self, known: &Knowledge, name: &str) -> Vec<Term> {
        let mut facts = Vec::new();
        if let Some(id) = known.names.individual(name) {
            for &other in neighbours(&known.catalogue, id, INDIVIDUALS_AT_ONCE) {
                self.send_individual(&known.catalogue, other, &mut facts);
            }
        } else if let Some(class) = known.names.class_of_shared(name) {
            self.send_shared(name, &class, &mut facts);
        }
        facts
    }

    /// Returns the parts of an individual, and of all others of its episode.
    pub fn parts(&mut self, known: &Knowledge, name: &str) -> Vec<Term> {
        let catalogue = &known.catalogue;
        let mut facts = Vec::new();
        let Some(id) = known.names.individual(name) else {
            return facts;
        };
        let episode = catalogue.episode_of(id);
        if !self.episodes.insert(episode.id.clone()) {
            return facts;
        }
        for id in episode.first..episode.first + episode.len {
            self.send_individual(catalogue, id, &mut facts);
            let name = name_of(catalogue, id);
            if let Some(parent) = catalogue.parent(id) {
                let parent = name_of(catalogue, parent);
                facts.push(Term::compound("k", [parent, name.clone()]));
            }
            let request = Term::compound("parts", [name]);
            facts.push(Term::compound("loaded", [request]));
        }
        facts
    }

    /// Returns values and relations of a thing.
    pub fn statements(&mut self, known: &Knowledge, name: &str) -> Vec<Term> {
        let catalogue = &known.catalogue;
        let mut facts = self.assertions(known, name);
        let Some(id) = known.names.individual(name) else {
            return facts;
        };
        if !self.statements.insert(id) {
            return facts;
        }
        for property in catalogue.properties() {
            let relations = entries(catalogue.relations(property), id).iter();
            facts.extend(relations.map(|(_, node)| relation_row(catalogue, id, property, *node)));
            if self.is_new_value(property, id) {
                let values = values(catalogue, property, id);
                facts.extend(values.map(|value| value_row(Term::atom(name), property, value)));
            }
        }
        facts
    }

    /// Returns people's statements about a thing, together with the recorded values of the same
    /// properties: an engine that has one value of a property does not ask for further ones.
    pub fn assertions(&mut self, known: &Knowledge, name: &str) -> Vec<Term> {
        if !self.assertions.insert(name.to_owned()) {
            return Vec::new();
        }
        let mut facts = known.assertions.statements_about(name);
        for property in known.assertions.properties_of(name) {
            facts.extend(self.read_recorded(known, name, property));
        }
        facts
    }

    /// Returns the recorded values of a property of a thing, if the engine does not have them.
    fn read_recorded(&mut self, known: &Knowledge, name: &str, property: &str) -> Vec<Term> {
        let catalogue = &known.catalogue;
        let id = (known.names.individual(name)).filter(|id| self.is_new_value(property, *id));
        let recorded = id
            .into_iter()
            .flat_map(|id| values(catalogue, property, id));
        let facts = recorded.map(|value| value_row(Term::atom(name), property, value));
        facts.collect()
    }

    fn is_new_value(&mut self, property: &str, id: IndividualId) -> bool {
        if let Some(sent) = self.values.get_mut(property) {
            return sent.insert(id);
        }
        let sent = HashSet::from([id]);
        self.values.insert(property.to_owned(), sent);
        true
    }

    /// Returns the values of a property of a thing and its neighbours of the same class.
    pub fn values_of(&mut self, known: &Knowledge, name: &str, property: &str) -> Vec<Term> {
        let catalogue = &known.catalogue;
        let mut facts = self.assertions(known, name);
        let Some(id) = known.names.individual(name) else {
            return facts;
        };
        for &other in neighbours(catalogue, id, VALUES_AT_ONCE) {
            let mut values = values(catalogue, property, other).peekable();
            if values.peek().is_some() && self.is_new_value(property, other) {
                let name = name_of(catalogue, other);
                facts.extend(values.map(|value| value_row(name.clone(), property, value)));
                // The engine asks for no other value of the neighbour.
                facts.extend(
                    name.as_atom()
                        .map_or_else(Vec::new, |name| self.assertions(known, name)),
                );
            }
        }
        facts
    }
}

/// Returns the block of `count` individuals of the same class that contains an individual.
fn neighbours(catalogue: &Catalogue, id: IndividualId, count: usize) -> &[IndividualId] {
    let alike = catalogue.individuals_of_class(catalogue.class(id));
    let first = alike.partition_point(|other| *other < id) / count * count;
    &alike[first..alike.len().min(first + count)]
}

/// Returns names as facts `fact(of, Names)`, with several hundred names in each.
pub fn list_facts(fact: &str, of: &Term, names: Vec<Term>) -> Vec<Term> {
    let lists = names.chunks(NAMES_IN_A_FACT);
    let facts = lists.map(|names| Term::compound(fact, [of.clone(), Term::List(names.to_vec())]));
    facts.collect()
}
