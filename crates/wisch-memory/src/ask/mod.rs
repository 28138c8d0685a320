//! Questions in Prolog: an engine in a process of its own, its needs answered from the memory.
//!
//! A query is sent as text. What it may call is listed in `prolog/listing.pl` and `prolog/guard.pl`; facts come over
//! by need and stay in the engine for the next query.

mod engine;
mod host;
mod intervals;
mod names;
mod senses;
mod term;
mod told;
mod worker;

pub use engine::EngineCommand;
pub use senses::Senses;
pub use term::{Term, TermError};
pub use told::Told;
pub use worker::work;

use crate::catalogue::Catalogue;
use engine::Engine;
use host::Host;
use std::sync::Arc;
use std::time::{Duration, Instant};
use wisch::source_location::UnknownName;

/// The Prolog system that answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EngineKind {
    /// Scryer Prolog, part of this program.
    Scryer,
    /// SWI-Prolog, if it is installed.
    Swi,
}

/// What a query may use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Time for a query.
    pub time: Duration,
    /// Memory of the engine [bytes].
    pub memory: u64,
    /// Answers.
    pub answers: usize,
}

impl Default for Limits {
    /// A minute, 4 GiB and 10,000 answers.
    fn default() -> Self {
        Self {
            time: Duration::from_secs(60),
            memory: 4 << 30,
            answers: 10_000,
        }
    }
}

/// What a query found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answers {
    /// The query's variables, but for those that begin with `_`.
    pub names: Vec<String>,
    /// A value for each of them, by answer.
    pub rows: Vec<Vec<Term>>,
    /// Whether there are more than the limit.
    pub is_cut: bool,
    /// What is to be looked at, in the order in which the query said so.
    pub views: Vec<Term>,
}

impl Answers {
    /// Whether the query holds at all.
    pub fn holds(&self) -> bool {
        !self.rows.is_empty()
    }
}

/// What is wrong with a query.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Fault {
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
    /// Nothing was sensed there.
    #[error("{what}")]
    Sense {
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

impl Fault {
    fn unknown(kind: &str, term: &Term, nearest: Option<&str>) -> Self {
        let nearest = nearest.map(|name| Term::atom(name).to_string());
        Self::Unknown {
            kind: kind.to_owned(),
            name: term.to_string(),
            nearest,
        }
    }

    fn no_name(term: &Term) -> Self {
        Self::NoName {
            term: term.to_string(),
        }
    }

    /// As the engine throws it.
    fn to_term(&self) -> Term {
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
            Self::Sense { what } => Term::compound("sense", [Term::atom(what)]),
            Self::Prolog { what } => Term::compound("prolog", [Term::atom(what)]),
        }
    }

    /// From what the engine threw.
    fn of(error: &Term, predicates: &[Predicate]) -> Self {
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
            Some(("sense", [what])) => Self::Sense { what: text(what) },
            Some(("unknown_predicate", [Term::Atom(name), Term::Integer(arity)])) => {
                Self::unknown_predicate(name, *arity, predicates)
            }
            Some(("error", [what, _])) => Self::Prolog {
                what: in_words(what),
            },
            _ => Self::Prolog {
                what: error.to_string(),
            },
        }
    }

    fn unknown_predicate(name: &str, arity: i64, predicates: &[Predicate]) -> Self {
        let same = predicates.iter().find(|predicate| predicate.name == name);
        let nearest = same.or_else(|| {
            let names = predicates.iter().map(|predicate| predicate.name.as_str());
            let error = UnknownName::new("predicate", name, names);
            let nearest = error.nearest()?;
            predicates
                .iter()
                .find(|predicate| predicate.name == nearest)
        });
        Self::Unknown {
            kind: "predicate".to_owned(),
            name: format!("{name}/{arity}"),
            nearest: nearest.map(|predicate| format!("{}/{}", predicate.name, predicate.arity)),
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
            "something has to be known here that is not: put the goal that finds it before"
                .to_owned()
        }
        Some(("type_error", [kind, culprit])) => format!("{culprit} should be of type {kind}"),
        Some(("domain_error", [domain, culprit])) => format!("{culprit} is no {domain}"),
        Some(("evaluation_error", [what])) => format!("arithmetic: {what}").replace('_', " "),
        Some(("resource_error", [what])) => format!("out of {what}"),
        _ => error.to_string(),
    }
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum AskError {
    /// The query is at fault.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// It took too long.
    #[error("the query took longer than {0:?}")]
    Time(Duration),
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
    /// What people told this memory cannot be read or written.
    #[error("{file}: {what}")]
    Told {
        /// Its file.
        file: String,
        /// Why.
        what: String,
    },
}

impl AskError {
    fn cannot_start(error: std::io::Error) -> Self {
        Self::CannotStart(error)
    }
}

/// A predicate that queries may call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Predicate {
    /// Its name.
    pub name: String,
    /// How many arguments it takes.
    pub arity: usize,
    /// How it is called, and what it says.
    pub meaning: String,
}

/// The predicates of this memory, in the order of its manual; Prolog's own are not among them.
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

/// Asks a memory; the engine stays, and keeps what it has learnt, until this is dropped.
pub struct Asker {
    command: EngineCommand,
    limits: Limits,
    host: Host,
    engine: Option<Engine>,
    predicates: Vec<Predicate>,
}

impl Asker {
    /// Asks these episodes. The engine is begun with the first query.
    pub fn new(
        command: EngineCommand,
        limits: Limits,
        catalogue: Arc<Catalogue>,
        senses: Senses,
        told: Told,
    ) -> Self {
        Self {
            command,
            limits,
            host: Host::new(catalogue, senses, told),
            engine: None,
            predicates: predicates(),
        }
    }

    /// The answers to a query such as `owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])`.
    ///
    /// # Errors
    /// The query is no Prolog, names something that is not known, or uses more than it may. The memory can be asked
    /// on after each of these.
    pub fn ask(&mut self, query: &str) -> Result<Answers, AskError> {
        let result = self.converse(query);
        self.host.end_query();
        if !matches!(result, Ok(_) | Err(AskError::Fault(_))) {
            // Nobody knows what it is at: the next query begins with a new one.
            self.engine = None;
            self.host.forget();
        }
        result
    }

    fn converse(&mut self, query: &str) -> Result<Answers, AskError> {
        let deadline = Instant::now() + self.limits.time;
        let engine = match &mut self.engine {
            Some(engine) => engine,
            none => none.insert(Engine::start(&self.command, &self.limits)?),
        };
        let text = query.trim().trim_end_matches('.');
        engine.send(&asking(text, self.limits.answers))?;
        let mut answers = Answers::default();
        let mut reply = String::new();
        loop {
            let Some(said) = engine.hear(deadline)? else {
                return Err(AskError::Time(self.limits.time));
            };
            match said {
                Term::Compound(name, mut arguments) => match (name.as_str(), arguments.len()) {
                    ("rows", 1) => {
                        if let Term::List(rows) = arguments.remove(0) {
                            answers.rows.extend(rows.into_iter().map(values));
                        }
                    }
                    ("need", 1) => {
                        reply.clear();
                        self.host.answer(&arguments[0], &mut reply)?;
                        engine.send(&reply)?;
                    }
                    ("view", 1) => answers.views.append(&mut arguments),
                    ("names", 1) => {
                        if let Term::List(names) = &arguments[0] {
                            let names = names.iter().filter_map(Term::as_atom);
                            answers.names = names.map(str::to_owned).collect();
                        }
                    }
                    ("done", 1) => {
                        answers.is_cut = arguments[0].as_atom() == Some("limit");
                        return Ok(answers);
                    }
                    ("error", 1) => {
                        return Err(Fault::of(&arguments[0], &self.predicates).into());
                    }
                    _ => {
                        return Err(AskError::Protocol {
                            line: Term::Compound(name, arguments).to_string(),
                        });
                    }
                },
                other => {
                    return Err(AskError::Protocol {
                        line: other.to_string(),
                    });
                }
            }
        }
    }
}

/// The values of a row; one without variables is an atom.
fn values(row: Term) -> Vec<Term> {
    match row {
        Term::Compound(_, values) => values,
        _ => Vec::new(),
    }
}

/// The order to answer a query.
fn asking(query: &str, answers: usize) -> String {
    let mut text = String::from("ask(\"");
    for c in query.chars() {
        match c {
            '"' => text.push_str("\\\""),
            '\\' => text.push_str("\\\\"),
            '\n' => text.push_str("\\n"),
            '\t' => text.push_str("\\t"),
            c if c.is_control() => text.push(' '),
            c => text.push(c),
        }
    }
    text.push_str(&format!("\",{answers})"));
    text
}
