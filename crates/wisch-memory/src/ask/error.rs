//! Errors of queries.

use super::term::{Term, TermError};
use crate::store::MemoryError;
use std::fmt::Display;
use std::time::Duration;

/// A fault in the text of a query, which the user can correct.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QueryFault {
    /// A name is unknown.
    #[error("unknown {kind} {name}{}", nearest.as_ref().map_or_else(String::new, |n| format!("; did you mean {n}?")))]
    Unknown {
        /// "class", "property", "thing", "prefix" or "predicate".
        kind: String,
        /// The name.
        name: String,
        /// The nearest known name.
        nearest: Option<String>,
    },
    /// A term cannot be a name.
    #[error("{term} is not a name")]
    NoName {
        /// The term.
        term: String,
    },
    /// The query exceeds a limit.
    #[error("more than {limit} {what}")]
    TooMuch {
        /// The limited quantity.
        what: &'static str,
        /// The limit.
        limit: usize,
    },
    /// The requested telemetry does not exist.
    #[error("{what}")]
    Telemetry {
        /// Description.
        what: String,
    },
    /// Data of an episode cannot be read, or was never recorded.
    #[error("{what}")]
    Recording {
        /// Description.
        what: String,
    },
    /// The query is not valid Prolog.
    #[error("the query is not valid Prolog ({what})")]
    Syntax {
        /// Description by the engine.
        what: String,
    },
    /// Text follows the full stop of the query.
    #[error("text after the full stop, from {begin:?} on: ask one query at a time")]
    AfterStop {
        /// Start of the text.
        begin: String,
    },
    /// Another error by the engine.
    #[error("{what}")]
    Prolog {
        /// Description.
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
            what: "a term that contains itself cannot be an answer".to_owned(),
        }
    }

    pub(super) fn no_name(term: &Term) -> Self {
        Self::NoName {
            term: term.to_string(),
        }
    }

    /// Returns the term that the engine throws.
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
            Self::TooMuch { .. }
            | Self::Syntax { .. }
            | Self::AfterStop { .. }
            | Self::Prolog { .. } => Term::compound("prolog", [Term::atom(self.to_string())]),
        }
    }

    /// Parses the term that the engine threw.
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
                    "tell cannot change {property}: the ontology fixes classes, and the episodes fix parts"
                ),
            },
            Some(("unknown_predicate", [Term::Atom(name), Term::Integer(arity)])) => {
                Self::unknown_predicate(name, *arity, callable)
            }
            Some(("cyclic", [])) => Self::cyclic(),
            Some(("unbound", [what])) => Self::Prolog {
                what: format!(
                    "{} must be bound here; put the goal that binds it first",
                    text(what)
                ),
            },
            Some(("unbound", [variable, goal])) => Self::Prolog {
                what: format!(
                    "{} must be bound before {}, whose answer depends on it; put the goal that binds it first",
                    text(variable),
                    text(goal)
                ),
            },
            Some(("no_time", [Term::Atom(name), Term::Integer(arity)])) => Self::Prolog {
                what: format!(
                    "{name}/{arity} has no time: during, since and until limit statements about events"
                ),
            },
            Some(("backward", [start, end])) => Self::Prolog {
                what: format!(
                    "the time from {start} to {end} ends before it begins; expected [Start, End] with Start at most End"
                ),
            },
            Some(("untimed", [thing])) => Self::Prolog {
                what: format!(
                    "{thing} has no time: during, since and until limit statements about events"
                ),
            },
            Some(("error", [what, _])) => match what.parts() {
                Some(("syntax_error", [what])) => Self::Syntax {
                    what: what.to_string().replace('_', " "),
                },
                _ => Self::Prolog {
                    what: describe_error(what),
                },
            },
            _ => Self::Prolog {
                what: format!("the query threw {error}"),
            },
        }
    }

    /// Returns the error for an unknown predicate, with a predicate of the same or a similar name.
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

/// Describes a standard error of Prolog.
fn describe_error(error: &Term) -> String {
    match error.parts() {
        Some(("instantiation_error", [])) => {
            "a variable must be bound here; put the goal that binds it first".to_owned()
        }
        Some(("type_error", [kind, culprit])) => format!("{culprit} should be of type {kind}"),
        Some(("domain_error", [domain, culprit])) => {
            let domain = domain.to_string();
            let article = if domain.starts_with(['a', 'e', 'i', 'o', 'u']) {
                "an"
            } else {
                "a"
            };
            format!("{culprit} is not {article} {domain}")
        }
        Some(("evaluation_error", [what])) => format!("arithmetic: {what}").replace('_', " "),
        Some(("resource_error", [what])) => format!("out of {what}"),
        Some(("existence_error", [kind, what])) => format!("there is no {kind} {what}"),
        Some(("representation_error", [what])) => format!("{what} is exceeded").replace('_', " "),
        _ => error.to_string(),
    }
}

/// The reason why a query has no result.
#[derive(Debug, thiserror::Error)]
pub enum AskError {
    /// The query is faulty.
    #[error(transparent)]
    Fault(#[from] QueryFault),
    /// The query exceeded its time.
    #[error("the query took longer than {0:?}")]
    Time(Duration),
    /// The query was interrupted.
    #[error("the query was interrupted")]
    Interrupted,
    /// The engine cannot be started.
    #[error("the Prolog engine cannot be started: {0}")]
    CannotStart(std::io::Error),
    /// The engine ended: it exceeded its memory, or it crashed.
    #[error("the Prolog engine ended: {words}")]
    EngineEnded {
        /// The end of its standard error.
        words: String,
    },
    /// The engine sent an invalid term.
    #[error(transparent)]
    Term(#[from] TermError),
    /// The engine sent an unexpected term.
    #[error("the Prolog engine sent an unexpected line: {line}")]
    Protocol {
        /// The line.
        line: String,
    },
    /// The memory cannot be read.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// The file of statements cannot be read or written.
    #[error("{file}: {what}")]
    Assertions {
        /// Path of the file.
        file: String,
        /// Description of the fault.
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
