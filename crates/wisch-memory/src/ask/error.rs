//! Why there is no answer.

use super::term::{Term, TermError};
use crate::store::MemoryError;
use std::fmt::Display;
use std::time::Duration;

/// What is wrong with a query.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QueryFault {
    /// A name that is not known.
    #[error("unknown {kind} {name}{}", nearest.as_ref().map_or_else(String::new, |n| format!("; did you mean {n}?")))]
    Unknown {
        /// class, property, thing, prefix or predicate.
        kind: String,
        /// The name.
        name: String,
        /// The nearest that is known.
        nearest: Option<String>,
    },
    /// Something that cannot be a name.
    #[error("{term} is no name of anything")]
    NoName {
        /// What stands there.
        term: String,
    },
    /// More than a query may do.
    #[error("more than {limit} {what}")]
    TooMuch {
        /// Of what.
        what: &'static str,
        /// How much there may be.
        limit: usize,
    },
    /// There is no such telemetry.
    #[error("{what}")]
    Telemetry {
        /// Why.
        what: String,
    },
    /// What an episode holds cannot be read, or was never recorded.
    #[error("{what}")]
    Recording {
        /// Why.
        what: String,
    },
    /// What the engine says of it.
    #[error("{what}")]
    Prolog {
        /// In words.
        what: String,
    },
}

impl QueryFault {
    pub(super) fn unknown(kind: &str, term: &Term, nearest: Option<&str>) -> Self {
        let nearest = nearest.map(|name| Term::atom(name).to_string());
        Self::Unknown {
            kind: kind.to_owned(),
            name: term.to_string(),
            nearest,
        }
    }

    pub(super) fn cyclic() -> Self {
        Self::Prolog {
            what: "a term that contains itself cannot be written down".to_owned(),
        }
    }

    pub(super) fn no_name(term: &Term) -> Self {
        Self::NoName {
            term: term.to_string(),
        }
    }

    /// As the engine throws it.
    pub(super) fn to_term(&self) -> Term {
        match self {
            Self::Unknown {
                kind,
                name,
                nearest,
            } => {
                let nearest = nearest.as_deref().unwrap_or_default();
                Term::compound("unknown", [kind, name, nearest].map(Term::atom))
            }
            Self::NoName { term } => Term::compound("no_name", [Term::atom(term)]),
            Self::Telemetry { what } | Self::Recording { what } => {
                Term::compound("telemetry", [Term::atom(what)])
            }
            Self::TooMuch { .. } | Self::Prolog { .. } => {
                Term::compound("prolog", [Term::atom(self.to_string())])
            }
        }
    }

    /// From what the engine threw.
    pub(super) fn of(error: &Term, callable: &[String]) -> Self {
        let text = |term: &Term| {
            term.as_atom()
                .map_or_else(|| term.to_string(), str::to_owned)
        };
        match error.parts() {
            Some(("unknown", [kind, name, nearest])) => Self::Unknown {
                kind: text(kind),
                name: text(name),
                nearest: Some(text(nearest)).filter(|nearest| !nearest.is_empty()),
            },
            Some(("no_name", [term])) => Self::NoName { term: text(term) },
            Some(("telemetry", [what])) => Self::Telemetry { what: text(what) },
            Some(("prolog", [what])) => Self::Prolog { what: text(what) },
            Some(("untold", [property])) => Self::Prolog {
                what: format!(
                    "{property} cannot be told: classes and parts are what episodes say they are"
                ),
            },
            Some(("unknown_predicate", [Term::Atom(name), Term::Integer(arity)])) => {
                Self::unknown_predicate(name, *arity, callable)
            }
            Some(("cyclic", [])) => Self::cyclic(),
            Some(("unbound", [what])) => Self::Prolog {
                what: format!(
                    "{} must be known here: put the goal that finds it before",
                    text(what)
                ),
            },
            Some(("unbound", [variable, goal])) => Self::Prolog {
                what: format!(
                    "{} must be bound before {}, whose answer depends on it: put the goal that finds it first",
                    text(variable),
                    text(goal)
                ),
            },
            Some(("no_time", [Term::Atom(name), Term::Integer(arity)])) => Self::Prolog {
                what: format!(
                    "{name}/{arity} has no time: during, since and until limit statements about events"
                ),
            },
            Some(("untimed", [thing])) => Self::Prolog {
                what: format!(
                    "{thing} has no time: during, since and until limit statements about events"
                ),
            },
            Some(("error", [what, _])) => Self::Prolog {
                what: in_words(what),
            },
            _ => Self::Prolog {
                what: format!("the query threw {error}"),
            },
        }
    }

    /// With one of the same name, or one that is nearly written so.
    fn unknown_predicate(name: &str, arity: i64, known: &[String]) -> Self {
        let distance = |other: &String| {
            let other = other
                .rsplit_once('/')
                .map_or(other.as_str(), |(name, _)| name);
            strsim::levenshtein(name, other)
        };
        let likely = name.chars().count() / 3;
        let nearest = known.iter().min_by_key(|other| distance(other));
        Self::Unknown {
            kind: "predicate".to_owned(),
            name: format!("{name}/{arity}"),
            nearest: nearest.filter(|other| distance(other) <= likely).cloned(),
        }
    }
}

/// A standard error of Prolog.
fn in_words(error: &Term) -> String {
    match error.parts() {
        Some(("syntax_error", [what])) => {
            let what = what.to_string().replace('_', " ");
            format!("the query is no Prolog: {what}")
        }
        Some(("instantiation_error", [])) => {
            "a variable must be bound here: put the goal that finds it before".to_owned()
        }
        Some(("type_error", [kind, culprit])) => format!("{culprit} should be of type {kind}"),
        Some(("domain_error", [domain, culprit])) => format!("{culprit} is no {domain}"),
        Some(("evaluation_error", [what])) => format!("arithmetic: {what}").replace('_', " "),
        Some(("resource_error", [what])) => format!("out of {what}"),
        Some(("existence_error", [kind, what])) => format!("there is no {kind} {what}"),
        Some(("representation_error", [what])) => format!("{what} is exceeded").replace('_', " "),
        _ => error.to_string(),
    }
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum AskError {
    /// The query is at fault.
    #[error(transparent)]
    Fault(#[from] QueryFault),
    /// It took too long.
    #[error("the query took longer than {0:?}")]
    Time(Duration),
    /// Somebody interrupted it.
    #[error("the query was interrupted")]
    Interrupted,
    /// The engine cannot be begun.
    #[error("the Prolog engine cannot be begun: {0}")]
    CannotStart(std::io::Error),
    /// The engine ended: it used more memory than it may, or it is broken.
    #[error("the Prolog engine ended: {words}")]
    EngineEnded {
        /// Its last words.
        words: String,
    },
    /// The engine said something that is no term.
    #[error(transparent)]
    Term(#[from] TermError),
    /// The engine said something that is not expected.
    #[error("the Prolog engine said something unexpected: {line}")]
    Protocol {
        /// What.
        line: String,
    },
    /// The memory cannot be read.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// What people added to this memory cannot be read or written.
    #[error("{file}: {what}")]
    Assertions {
        /// Its file.
        file: String,
        /// Why.
        what: String,
    },
}

impl AskError {
    pub(super) fn unexpected(line: impl Display) -> Self {
        Self::Protocol {
            line: line.to_string(),
        }
    }
}
