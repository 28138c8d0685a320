//! Questions in Prolog: an engine in a process of its own, its needs answered from the memory.
//!
//! A query is sent as text. What it may call is listed in `prolog/listing.pl` and `prolog/guard.pl`; facts come over
//! by need and stay in the engine for the next query.

mod assertions;
mod engine;
mod error;
mod facts;
mod host;
mod intervals;
mod listing;
mod names;
mod reply;
mod rows;
mod streams;
mod telemetry_predicates;
mod term;

pub use assertions::Assertions;
pub use engine::{EngineCommand, Limits};
pub use error::{AskError, QueryFault};
pub use listing::{Predicate, predicates};
pub use telemetry_predicates::TelemetryPredicates;
pub use term::{Term, TermError};

use crate::catalogue::Catalogue;
use crate::store::Memory;
use engine::Engine;
use host::Host;
use std::sync::Arc;
use std::time::Instant;

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

/// Asks a memory; the engine stays, and keeps what it has learnt, until this is dropped.
pub struct Asker {
    command: EngineCommand,
    limits: Limits,
    host: Host,
    engine: Option<Engine>,
    predicates: Vec<Predicate>,
}

impl Asker {
    /// Asks all episodes of a memory, and what was added to it by `tell`, within the usual limits.
    ///
    /// # Errors
    /// The memory cannot be read.
    pub fn open(memory: Memory, command: EngineCommand) -> Result<Self, AskError> {
        let catalogue = Arc::new(memory.catalogue()?);
        let assertions = Assertions::read(memory.folder())?;
        let telemetry = TelemetryPredicates::of(memory);
        let limits = Limits::default();
        Ok(Self::new(command, limits, catalogue, telemetry, assertions))
    }

    /// Asks these episodes. The engine is begun with the first query.
    pub fn new(
        command: EngineCommand,
        limits: Limits,
        catalogue: Arc<Catalogue>,
        telemetry: TelemetryPredicates,
        assertions: Assertions,
    ) -> Self {
        Self {
            command,
            limits,
            host: Host::new(catalogue, telemetry, assertions),
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
            let Some(message) = engine.receive(deadline)? else {
                return Err(AskError::Time(self.limits.time));
            };
            match message {
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
                        return Err(QueryFault::of(&arguments[0], &self.predicates).into());
                    }
                    _ => {
                        return Err(AskError::unexpected(Term::Compound(name, arguments)));
                    }
                },
                other => return Err(AskError::unexpected(other)),
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
