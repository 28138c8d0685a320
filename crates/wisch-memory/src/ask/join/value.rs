//! Values of variables in a join, and patterns in its goals.

use crate::ask::rows::name_of;
use crate::ask::term::Term;
use crate::catalogue::{Catalogue, IndividualId};
use std::cmp::Ordering;

/// The value of a variable that is bound.
#[derive(Debug, Clone, PartialEq)]
pub enum JoinValue {
    /// An individual of an episode.
    Individual(IndividualId),
    /// Something that episodes share: its index in [`Catalogue::shared`].
    Shared(u32),
    /// A whole number.
    Integer(i64),
    /// A floating-point number.
    Float(f64),
    /// Any other term without variables.
    Term(Term),
}

impl JoinValue {
    /// Converts a term without variables; names in it stay names.
    pub fn from_term(term: Term) -> Self {
        match term {
            Term::Integer(value) => Self::Integer(value),
            Term::Float(value) => Self::Float(value),
            other => Self::Term(other),
        }
    }

    /// Returns the value as a term for the engine.
    pub fn to_term(&self, catalogue: &Catalogue) -> Term {
        match self {
            Self::Individual(id) => name_of(catalogue, *id),
            Self::Shared(number) => Term::atom(&catalogue.shared_individuals()[*number as usize]),
            Self::Integer(value) => Term::Integer(*value),
            Self::Float(value) => Term::Float(*value),
            Self::Term(term) => term.clone(),
        }
    }

    /// Whether two values unify as terms.
    pub fn is_same(&self, other: &Self, catalogue: &Catalogue) -> bool {
        let names = |thing: &Self, term: &Term| {
            // All names of things have a prefix; most texts have none.
            term.as_atom().is_some_and(|name| name.contains(':'))
                && thing.to_term(catalogue) == *term
        };
        match (self, other) {
            (thing @ (Self::Individual(_) | Self::Shared(_)), Self::Term(term))
            | (Self::Term(term), thing @ (Self::Individual(_) | Self::Shared(_))) => {
                names(thing, term)
            }
            _ => self == other,
        }
    }

    /// Returns the numeric value, for a number.
    pub fn as_number(&self) -> Option<f64> {
        match self {
            Self::Integer(value) => Term::Integer(*value).as_number(),
            Self::Float(value) => Some(*value),
            _ => None,
        }
    }
}

/// Compares in the standard order of terms: numbers, then atoms, then compound terms. `None` where engines differ:
/// lists.
pub fn standard_order(a: &Term, b: &Term) -> Option<Ordering> {
    let rank = |term: &Term| match term {
        Term::Variable(_) | Term::List(_) => None,
        Term::Integer(_) | Term::Float(_) => Some(0),
        Term::Atom(_) => Some(1),
        Term::Compound(..) => Some(2),
    };
    let by_rank = rank(a)?.cmp(&rank(b)?);
    if by_rank.is_ne() {
        return Some(by_rank);
    }
    match (a, b) {
        (Term::Atom(a), Term::Atom(b)) => Some(a.cmp(b)),
        (Term::Compound(a, of_a), Term::Compound(b, of_b)) => {
            let heads = of_a.len().cmp(&of_b.len()).then_with(|| a.cmp(b));
            let mut order = heads;
            for (a, b) in of_a.iter().zip(of_b) {
                if order.is_ne() {
                    break;
                }
                order = standard_order(a, b)?;
            }
            Some(order)
        }
        _ => {
            let by_value = a.as_number()?.total_cmp(&b.as_number()?);
            let is_whole = |term: &Term| matches!(term, Term::Integer(_));
            Some(by_value.then(is_whole(a).cmp(&is_whole(b))))
        }
    }
}

/// Argument of a goal: a variable, a value, or a term with variables.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// A variable, by its index.
    Variable(usize),
    /// A value.
    JoinValue(JoinValue),
    /// A list with variables.
    List(Vec<Pattern>),
    /// A compound term with variables.
    Compound(String, Vec<Pattern>),
}

impl Pattern {
    /// Appends the variables of the pattern to `found`.
    pub fn variables(&self, found: &mut Vec<usize>) {
        match self {
            Self::Variable(number) => found.push(*number),
            Self::JoinValue(_) => {}
            Self::List(items) | Self::Compound(_, items) => {
                for item in items {
                    item.variables(found);
                }
            }
        }
    }
}
