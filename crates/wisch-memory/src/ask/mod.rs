//! Questions in Prolog: an engine in a process of its own, its needs answered from the memory.
//!
//! A query is sent as text. What it may call is listed in `prolog/listing.pl` and `prolog/guard.pl`; facts come over
//! by need and stay in the engine for the next query.

mod assertions;
mod definitions;
mod engine;
mod error;
mod facts;
mod host;
mod intervals;
mod join;
mod listing;
mod names;
mod printed;
mod query_text;
mod reply;
mod rows;
mod streams;
mod telemetry_predicates;
mod term;
mod trends;

pub use assertions::Assertions;
pub use engine::{AskLimits, EngineCommand};
pub use error::{AskError, QueryFault};
pub use listing::{Predicate, builtins, predicates};
pub use telemetry_predicates::TelemetryPredicates;
pub(crate) use telemetry_predicates::tool_of;
pub use term::{Term, TermError};

use crate::catalogue::Catalogue;
use crate::store::Memory;
use engine::Engine;
use host::Host;
use join::SolverBudget;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
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
    /// What the query printed.
    pub printed: String,
    /// What was left out, and why.
    pub remarks: Vec<String>,
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
    limits: AskLimits,
    host: Host,
    engine: Option<Engine>,
    /// What queries may call, as `member/2`.
    callable: Vec<String>,
    interrupt: Arc<AtomicBool>,
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
        let limits = AskLimits::default();
        Ok(Self::new(command, limits, catalogue, telemetry, assertions))
    }

    /// Asks these episodes. The engine is begun with the first query.
    pub fn new(
        command: EngineCommand,
        limits: AskLimits,
        catalogue: Arc<Catalogue>,
        telemetry: TelemetryPredicates,
        assertions: Assertions,
    ) -> Self {
        Self {
            command,
            limits,
            host: Host::new(catalogue, telemetry, assertions, limits.answers),
            engine: None,
            callable: callable(),
            interrupt: Arc::default(),
        }
    }

    /// Whether conjunctions of goals that ask for facts alone are joined by the program, as they are unless this says
    /// otherwise; the answers are the same.
    pub fn join_facts(&mut self, does: bool) {
        self.host.join_facts(does);
    }

    /// How many conjunctions the program has joined so far.
    pub fn joined_so_far(&self) -> u64 {
        self.host.joined_so_far()
    }

    /// What, set to true, ends the query that is being answered; the memory can be asked on.
    pub fn interrupt(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.interrupt)
    }

    /// The answers to a query such as `owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])`.
    ///
    /// What it tells is kept if it has answers, at most as many statements as there may be answers; otherwise nothing is.
    ///
    /// # Errors
    /// The query is no Prolog, names something that is not known, or uses more than it may. The memory can be asked
    /// on after each of these.
    pub fn ask(&mut self, query: &str) -> Result<Answers, AskError> {
        let mut result = self.converse(query);
        self.host.end_query();
        self.host.take_printed();
        self.host.take_remarks();
        if let Ok(answers) = &result
            && answers.holds()
            && let Err(error) = self.host.commit_assertions()
        {
            result = Err(error);
        }
        let is_rolled_back = self.host.roll_back_assertions();
        if is_rolled_back || !matches!(result, Ok(_) | Err(AskError::Fault(_))) {
            // It knows what does not hold, or nobody knows what it is at: the next query begins with a new one.
            self.engine = None;
            self.host.forget();
        }
        result
    }

    fn converse(&mut self, query: &str) -> Result<Answers, AskError> {
        let text = query_text::prepared(query)?;
        let deadline = Instant::now() + self.limits.time;
        let engine = match &mut self.engine {
            Some(engine) => engine,
            none => none.insert(Engine::start(&self.command, &self.limits)?),
        };
        self.interrupt.store(false, Ordering::Relaxed);
        let budget = SolverBudget {
            deadline,
            time: self.limits.time,
            interrupt: &self.interrupt,
            candidates: u64::MAX,
        };
        engine.begin_query(&asking(&text, self.limits.answers), self.limits.time)?;
        let mut answers = Answers::default();
        let mut reply = String::new();
        let mut is_cut_short = false;
        loop {
            let Some(message) = engine.receive(deadline, &self.interrupt)? else {
                return Err(AskError::Time(self.limits.time));
            };
            match message {
                Term::Compound(name, mut arguments) => match (name.as_str(), arguments.len()) {
                    ("rows", 1) => {
                        if let Term::List(rows) = arguments.remove(0) {
                            is_cut_short |=
                                self.command.cuts_short() && rows.iter().any(Term::is_cut_short);
                            answers.rows.extend(rows.into_iter().map(values));
                        }
                    }
                    ("need", 1) => {
                        reply.clear();
                        self.host.answer(&arguments[0], budget, &mut reply)?;
                        engine.send(&reply)?;
                    }
                    ("solve", 2) => {
                        let wanted = match arguments.remove(1) {
                            Term::List(wanted) => wanted,
                            other => return Err(AskError::unexpected(other)),
                        };
                        let most = self.limits.answers;
                        let solved = self.host.solve(&arguments[0], &wanted, most, budget)?;
                        engine.send(match &solved {
                            Some(solutions) if solutions.is_cut => "solved(limit)",
                            Some(_) => "solved(all)",
                            None => "declined",
                        })?;
                        answers.rows.extend(solved.unwrap_or_default().rows);
                    }
                    ("view", 1) => answers.views.append(&mut arguments),
                    ("names", 1) => {
                        if let Term::List(names) = &arguments[0] {
                            let names = names.iter().filter_map(Term::as_atom);
                            answers.names = names.map(str::to_owned).collect();
                        }
                    }
                    ("done", 1) if is_cut_short => return Err(QueryFault::cyclic().into()),
                    ("done", 1) => {
                        answers.is_cut = arguments[0].as_atom() == Some("limit");
                        answers.printed = self.host.take_printed();
                        answers.remarks = self.host.take_remarks();
                        // Nothing was found, and that is because nothing could be looked at.
                        if let (false, Some(why)) = (answers.holds(), answers.remarks.first()) {
                            let what = why.clone();
                            return Err(QueryFault::Recording { what }.into());
                        }
                        return Ok(answers);
                    }
                    ("error", 1) => {
                        return Err(QueryFault::of(&arguments[0], &self.callable).into());
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

/// What queries may call, this memory's own before Prolog's.
fn callable() -> Vec<String> {
    let own = predicates().into_iter();
    let own = own.map(|predicate| format!("{}/{}", predicate.name, predicate.arity));
    own.chain(builtins()).collect()
}

/// The values of a row, which come in groups; one without any is an atom.
fn values(row: Term) -> Vec<Term> {
    let arguments = |term| match term {
        Term::Compound(_, arguments) => arguments,
        _ => Vec::new(),
    };
    arguments(row).into_iter().flat_map(arguments).collect()
}

/// The order to answer a query, which has no full stop.
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
    text.push_str(&format!(" .\",{answers})"));
    text
}
