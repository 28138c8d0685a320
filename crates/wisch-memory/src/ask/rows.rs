//! Rows of the catalogue as facts for the engine.

use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId, entries};

/// Returns an individual's name, with prefix.
pub fn name_of(catalogue: &Catalogue, id: IndividualId) -> Term {
    Term::Atom(format!("semco:{}", catalogue.name(id)))
}

/// Returns the name of a relation's object, with prefix.
pub fn node_name(catalogue: &Catalogue, node: CatalogueNode) -> Term {
    match node {
        CatalogueNode::Individual(id) => name_of(catalogue, id),
        CatalogueNode::Shared(number) => {
            Term::atom(&catalogue.shared_individuals()[number as usize])
        }
    }
}

/// Returns the values of an individual's property: numbers, then texts.
pub fn values<'a>(
    catalogue: &'a Catalogue,
    property: &str,
    id: IndividualId,
) -> impl Iterator<Item = Term> + use<'a> {
    let numbers = entries(catalogue.numbers(property), id).iter();
    let texts = entries(catalogue.texts(property), id).iter();
    let numbers = numbers.map(|(_, value)| Term::Float(*value));
    numbers.chain(texts.map(|(_, text)| Term::atom(text)))
}

/// Returns the fact about an individual: `i/6`.
pub fn individual_row(catalogue: &Catalogue, id: IndividualId) -> Term {
    let none = || Term::atom("none");
    let [start, end] = match catalogue.interval(id) {
        Some(interval) => interval.map(Term::Float),
        None => [none(), none()],
    };
    let parent = catalogue.parent(id);
    let parent = parent.map_or_else(none, |parent| name_of(catalogue, parent));
    let episode = name_of(catalogue, catalogue.episode_of(id).first);
    let class = Term::atom(catalogue.class(id));
    let name = name_of(catalogue, id);
    Term::compound("i", [name, class, start, end, parent, episode])
}

/// Returns the fact about a shared thing: `i/6`.
pub fn share_row(name: &str, class: &str) -> Term {
    let none = || Term::atom("none");
    let [name, class] = [name, class].map(Term::atom);
    Term::compound("i", [name, class, none(), none(), none(), none()])
}

/// Returns a value of a thing: `v/3`.
pub fn value_row(name: Term, property: &str, value: Term) -> Term {
    Term::compound("v", [name, Term::atom(property), value])
}

/// Returns a relation of an individual: `r/3`.
pub fn relation_row(
    catalogue: &Catalogue,
    id: IndividualId,
    property: &str,
    node: CatalogueNode,
) -> Term {
    let (name, object) = (name_of(catalogue, id), node_name(catalogue, node));
    Term::compound("r", [name, Term::atom(property), object])
}
