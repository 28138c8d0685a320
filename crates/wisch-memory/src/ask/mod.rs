//! Queries in Prolog: an engine in a separate process, whose requests the memory answers.
//!
//! A query is sent as text. `prolog/listing.pl` and `prolog/guard.pl` list the predicates that it may call. Facts are
//! fetched on demand, and stay in the engine for later queries.

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
mod place;
mod printed;
mod query_text;
mod reply;
mod rows;
mod streams;
mod telemetry_predicates;
mod term;
mod trends;
mod units;

pub use assertions::{ANNOTATIONS, Assertions};
pub use engine::{AskLimits, EngineCommand, command_ended_with_parent};
pub use error::{AskError, QueryFault};
pub use listing::{Predicate, builtins, predicates};
pub use place::{ErrorPlace, locate_fault};
pub use telemetry_predicates::TelemetryPredicates;
pub(crate) use telemetry_predicates::tool_of;
pub use term::{Term, TermError};
pub(crate) use units::units_of;

use crate::catalogue::Catalogue;
use crate::store::Memory;
use engine::Engine;
use host::Host;
use join::SolverBudget;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Predicates whose answers compare the times of episodes, or state them as dates.
const COMPARING_TIMES: [&str; 7] = [
    "during",
    "is_at",
    "last_episode",
    "local_time",
    "since",
    "tf",
    "until",
];

/// Predicates whose answers are performances, so that episodes without one are missing.
const COMPARING_PERFORMANCES: [&str; 6] = [
    "final_performance",
    "low_performance",
    "low_performance_round",
    "strategy_performance",
    "surface_performance",
    "tool_performance",
];

/// The answers to a query, with what it printed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answers {
    /// Variables of the query, except those that begin with `_`.
    pub names: Vec<String>,
    /// For each answer, a value for each variable.
    pub rows: Vec<Vec<Term>>,
    /// Whether the limit cut the answers.
    pub is_cut: bool,
    /// View commands, in the order in which the query gave them.
    pub views: Vec<Term>,
    /// Text that the query printed.
    pub printed: String,
    /// Remarks on episodes that are left out, with the reason, on episodes without a date where times are compared, and on
    /// episodes without a performance where performances are compared.
    pub remarks: Vec<String>,
}

impl Answers {
    /// Whether the query has an answer.
    pub fn holds(&self) -> bool {
        !self.rows.is_empty()
    }
}

/// Interface for queries to a memory. The engine runs, and keeps its facts, until this is dropped.
///
/// ```no_run
/// use wisch_memory::Memory;
/// use wisch_memory::ask::{EngineCommand, QuerySession};
///
/// let engine = EngineCommand::find().ok_or("there is no Prolog engine")?;
/// let mut session = QuerySession::open(Memory::open("episodes".as_ref())?, engine)?;
/// for row in &session.ask("low_performance_round(Round, Performance)")?.rows {
///     println!("{}: {}", row[0], row[1]);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct QuerySession {
    command: EngineCommand,
    limits: AskLimits,
    host: Host,
    engine: Option<Engine>,
    /// Predicates that queries may call, as `member/2`.
    callable: Vec<String>,
    interrupt: Arc<AtomicBool>,
}

impl QuerySession {
    /// Opens all episodes of a memory and the statements added by `tell`, with default limits.
    ///
    /// # Errors
    /// If the memory cannot be read.
    pub fn open(memory: Memory, command: EngineCommand) -> Result<Self, AskError> {
        let catalogue = Arc::new(memory.catalogue()?);
        let assertions = Assertions::read(memory.folder())?;
        let telemetry = TelemetryPredicates::new(memory);
        let limits = AskLimits::default();
        Ok(Self::new(command, limits, catalogue, telemetry, assertions))
    }

    /// Opens the given episodes. The engine starts with the first query.
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

    /// Returns remarks on the memory that apply to every query: episodes that are left out, and
    /// values that people have added besides recorded ones.
    pub fn remarks_on_memory(&self) -> Vec<String> {
        self.host.remarks_on_memory()
    }

    /// Sets whether this program joins conjunctions of goals that only look facts up (default: yes). The answers are
    /// the same.
    pub fn join_facts(&mut self, does: bool) {
        self.host.join_facts(does);
    }

    /// Number of conjunctions that the program has joined so far.
    pub fn join_count(&self) -> u64 {
        self.host.join_count()
    }

    /// Flag that ends the current query when it is set; later queries are possible.
    pub fn interrupt(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.interrupt)
    }

    /// Returns the answers to a query such as `owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])`.
    ///
    /// Statements by `tell` are stored if the query has answers, otherwise discarded. Their number is limited like that
    /// of answers.
    ///
    /// # Errors
    /// If the query is not valid Prolog, uses an unknown name, or exceeds a limit. Later queries are possible after
    /// each of these.
    pub fn ask(&mut self, query: &str) -> Result<Answers, AskError> {
        self.host.begin_query(query);
        let mut result = self.converse(query);
        if let Ok(answers) = &mut result {
            if calls_any(query, &COMPARING_TIMES) {
                answers.remarks.extend(self.host.describe_undated());
            }
            if calls_any(query, &COMPARING_PERFORMANCES) {
                let unknown = self.host.describe_unknown_performances();
                answers.remarks.extend(unknown);
            }
        }
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
            // The engine may hold discarded statements, or be in an unknown state: the next query starts a new one.
            self.engine = None;
            self.host.forget();
        }
        result
    }

    fn converse(&mut self, query: &str) -> Result<Answers, AskError> {
        let text = query_text::prepare_query(query)?;
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
        engine.begin_query(&query_command(&text, self.limits.answers), self.limits.time)?;
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
                        // No answer was found because no episode could be read, so the first remark is the error.
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

/// Whether a query contains the name of any of the predicates.
fn calls_any(query: &str, predicates: &[&str]) -> bool {
    let words = query.split(|c: char| !c.is_alphanumeric() && c != '_');
    words.into_iter().any(|word| predicates.contains(&word))
}

/// Returns the predicates that queries may call, this memory's own before Prolog's.
fn callable() -> Vec<String> {
    let own = predicates().into_iter();
    let own = own.map(|predicate| format!("{}/{}", predicate.name, predicate.arity));
    own.chain(builtins()).collect()
}

/// Returns the values of a row, which arrive in groups; a row without values is an atom.
fn values(row: Term) -> Vec<Term> {
    let arguments = |term| match term {
        Term::Compound(_, arguments) => arguments,
        _ => Vec::new(),
    };
    arguments(row).into_iter().flat_map(arguments).collect()
}

/// Returns the command to answer a query, which has no full stop.
fn query_command(query: &str, answers: usize) -> String {
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
