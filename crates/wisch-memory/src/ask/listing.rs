//! The predicates that queries may call.

use super::term::Term;

/// A predicate that queries may call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Predicate {
    /// Its name.
    pub name: String,
    /// Its arity.
    pub arity: usize,
    /// Its form and meaning.
    pub meaning: String,
}

/// Returns Prolog's own predicates that queries may call, as `member/2`, sorted.
pub fn builtins() -> Vec<String> {
    let text = include_str!("../../prolog/guard.pl");
    let facts =
        (text.lines()).filter(|line| line.starts_with("builtin(") || line.starts_with("meta("));
    let parsed = facts.filter_map(|line| Term::parse(line).ok());
    let names = parsed.filter_map(|fact| match fact.parts()? {
        (_, [Term::Atom(name), Term::Integer(arity), ..]) => Some(format!("{name}/{arity}")),
        _ => None,
    });
    let mut names: Vec<String> = names.collect();
    let own = predicates();
    names.retain(|name| {
        !own.iter()
            .any(|p| *name == format!("{}/{}", p.name, p.arity))
    });
    names.sort_unstable();
    names
}

/// Returns the predicates of this memory, in the order of the manual, without Prolog's own.
pub fn predicates() -> Vec<Predicate> {
    let text = include_str!("../../prolog/listing.pl");
    let facts = text.lines().filter(|line| line.starts_with("predicate("));
    let parsed = facts.filter_map(|line| Term::parse(line).ok());
    let predicates = parsed.filter_map(|fact| match fact.parts()? {
        (_, [Term::Atom(name), Term::Integer(arity), Term::Atom(meaning)]) => Some(Predicate {
            name: name.clone(),
            arity: usize::try_from(*arity).ok()?,
            meaning: meaning.clone(),
        }),
        _ => None,
    });
    predicates.collect()
}
