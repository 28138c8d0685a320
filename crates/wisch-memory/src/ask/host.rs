//! Answers to the engine's requests, from catalogue, ontology and telemetry.

use super::assertions::{Assertions, TYPE};
use super::error::{AskError, QueryFault};
use super::facts::{SentFacts, list_facts};
use super::intervals::{IntervalIndex, Relation};
use super::join::{Indices, Joins, Solutions, SolverBudget};
use super::names::Names;
use super::place::locate_fault;
use super::printed::format_answer;
use super::reply::{AnswerRows, Cursor, HostRefusal, Reply};
use super::rows::name_of;
use super::streams::Knowledge;
use super::telemetry_predicates::TelemetryPredicates;
use super::term::Term;
use super::trends::{causes, changes, channel_of, drifts, health_drifts, series};
use crate::catalogue::{Catalogue, IndividualId};
use crate::id::{is_date, local_date_and_time};
use crate::ontology::Ontology;
use std::collections::HashMap;
use std::sync::Arc;

/// Number of rows in the first chunk of a stream, and in the largest; each chunk is four times the previous one.
const CHUNK: [usize; 2] = [64, 512];
/// Number of facts sent at once: an engine takes longer per fact the more arrive together.
const FACTS_AT_ONCE: usize = 512;
/// Largest number of filtered individuals that the engine keeps; more are sent again each time.
const FILTERED_FACTS: usize = 20_000;
/// Largest number of members of a class that the engine keeps with times and parents; more are streamed by name.
const MOST_MEMBERS: usize = 30_000;

/// Largest number of joined solutions that the engine gets at once, and of candidates examined for them: it may need
/// only a few.
const MOST_JOINED: usize = 200_000;
const MOST_CANDIDATES: u64 = 5_000_000;

/// Largest size of the text that a query may print [bytes].
const MOST_PRINTED: usize = 1 << 20;

/// Host of one engine: answers its requests, and keeps track of the facts that it has.
pub struct Host {
    known: Knowledge,
    indices: Indices,
    /// Whether the host joins goals that only look facts up.
    joins_facts: bool,
    joined: u64,
    telemetry: TelemetryPredicates,
    sent: SentFacts,
    cursors: HashMap<i64, Cursor>,
    next_cursor: i64,
    /// Largest number of statements by a query.
    max_assertions: usize,
    /// Text that the query has printed.
    printed: String,
    /// Text of the current query.
    query: String,
}

impl Host {
    /// Creates the host of a new engine.
    pub fn new(
        catalogue: Arc<Catalogue>,
        telemetry: TelemetryPredicates,
        mut assertions: Assertions,
        max_assertions: usize,
    ) -> Self {
        assertions.retain_known(&catalogue);
        let mut names = Names::new(Arc::clone(&catalogue), Ontology::load());
        for (name, class) in assertions.individuals() {
            names.add_individual(name, class);
        }
        Self {
            known: Knowledge {
                names,
                catalogue,
                assertions,
            },
            indices: Indices::default(),
            joins_facts: true,
            joined: 0,
            telemetry,
            sent: SentFacts::default(),
            cursors: HashMap::new(),
            next_cursor: 0,
            max_assertions,
            printed: String::new(),
            query: String::new(),
        }
    }

    /// States which episodes have no date, if any.
    pub fn describe_undated(&self) -> Option<String> {
        self.known.catalogue.describe_undated()
    }

    /// States how many episodes have no performance, if any.
    pub fn describe_unknown_performances(&self) -> Option<String> {
        self.known.catalogue.describe_unknown_performances()
    }

    /// Returns remarks on the memory that apply to every query.
    pub fn remarks_on_memory(&self) -> Vec<String> {
        let catalogue = &self.known.catalogue;
        let mut remarks: Vec<String> = catalogue
            .omitted_episodes()
            .iter()
            .map(|why| format!("{why}: left out; wisch memory verify lists damaged files"))
            .collect();
        remarks.extend(self.known.describe_additions());
        remarks
    }

    /// Returns the text that the query has printed, and clears it.
    pub fn take_printed(&mut self) -> String {
        std::mem::take(&mut self.printed)
    }

    /// Returns the remarks on omitted episodes since the last call, and clears them.
    pub fn take_remarks(&mut self) -> Vec<String> {
        self.telemetry.take_remarks()
    }

    /// Commits the statements that the query added.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn commit_assertions(&mut self) -> Result<(), AskError> {
        self.known.assertions.commit()
    }

    /// Discards the query's statements. Returns whether the engine knows any of them.
    pub fn roll_back_assertions(&mut self) -> bool {
        let discarded = self.known.assertions.roll_back();
        for (name, property, _) in &discarded {
            if property == TYPE {
                self.known.names.remove_individual(name);
            }
        }
        !discarded.is_empty()
    }

    /// Resets the host for a new engine without facts.
    pub fn forget(&mut self) {
        self.sent = SentFacts::default();
        self.cursors.clear();
    }

    /// Begins a query with this text.
    pub fn begin_query(&mut self, query: &str) {
        query.clone_into(&mut self.query);
    }

    /// Drops streams that will not be read any more.
    pub fn end_query(&mut self) {
        self.cursors.clear();
    }

    /// Sets whether the host joins goals that only look facts up (default: yes).
    pub fn join_facts(&mut self, does: bool) {
        self.joins_facts = does;
    }

    /// Returns at most the wanted number of solutions of a list of goals, as values of the wanted terms; `None` if the
    /// engine must solve them.
    ///
    /// # Errors
    /// If the query must end.
    pub fn solve(
        &mut self,
        goals: &Term,
        wanted: &[Term],
        most: usize,
        budget: SolverBudget<'_>,
    ) -> Result<Option<Solutions>, AskError> {
        if !self.joins_facts {
            return Ok(None);
        }
        let joins = Joins {
            known: &self.known,
            indices: &mut self.indices,
            telemetry: &mut self.telemetry,
        };
        let solved = joins.solve(goals, wanted, most, budget)?;
        self.joined += u64::from(solved.is_some());
        Ok(solved)
    }

    /// Number of conjunctions that the host has joined.
    pub fn join_count(&self) -> u64 {
        self.joined
    }

    /// Returns all solutions of goals at the front of a query.
    fn solve_front(
        &mut self,
        goals: &Term,
        wanted: &[Term],
        budget: SolverBudget<'_>,
    ) -> Result<Option<AnswerRows>, AskError> {
        let budget = SolverBudget {
            candidates: MOST_CANDIDATES,
            ..budget
        };
        let solved = self.solve(goals, wanted, MOST_JOINED, budget)?;
        let all = solved.filter(|solutions| !solutions.is_cut);
        Ok(all.map(|solutions| Box::new(solutions.rows.into_iter().map(Term::List)) as AnswerRows))
    }

    /// Answers a request of the Prolog engine.
    ///
    /// # Errors
    /// If this program failed; a fault of the query is part of the answer.
    pub fn answer(
        &mut self,
        request: &Term,
        budget: SolverBudget<'_>,
        reply: &mut String,
    ) -> Result<(), AskError> {
        if let Some(("join", [goals, Term::List(wanted)])) = request.parts() {
            match self.solve_front(goals, wanted, budget)? {
                Some(rows) => {
                    let (rows, size) = (rows.peekable(), CHUNK[0]);
                    self.next_chunk(Cursor { rows, size }, reply);
                }
                None => reply.push_str("declined"),
            }
            return Ok(());
        }
        let (rows, size): (AnswerRows, usize) = match self.rows(request) {
            Ok(Reply::Facts(facts)) => (Box::new(facts.into_iter()), FACTS_AT_ONCE),
            Ok(Reply::Stream(rows)) => (rows, CHUNK[0]),
            Ok(Reply::More(cursor)) => {
                self.next_chunk(cursor, reply);
                return Ok(());
            }
            Err(HostRefusal::Fault(fault)) => {
                Term::compound("fault", [fault.to_term()]).write_quoted(reply);
                return Ok(());
            }
            Err(HostRefusal::Error(error)) => return Err(error),
        };
        let rows = rows.peekable();
        self.next_chunk(Cursor { rows, size }, reply);
        Ok(())
    }

    fn next_chunk(&mut self, mut cursor: Cursor, reply: &mut String) {
        let rows: Vec<Term> = cursor.rows.by_ref().take(cursor.size).collect();
        if cursor.rows.peek().is_none() {
            Term::compound("rows", [Term::List(rows)]).write_quoted(reply);
            return;
        }
        cursor.size = (cursor.size * 4).min(CHUNK[1]);
        let number = self.next_cursor;
        self.next_cursor += 1;
        self.cursors.insert(number, cursor);
        Term::compound("chunk", [Term::Integer(number), Term::List(rows)]).write_quoted(reply);
    }

    fn rows(&mut self, request: &Term) -> Result<Reply, HostRefusal> {
        let malformed = || HostRefusal::Error(AskError::unexpected(request));
        let (name, arguments) = request.parts().ok_or_else(malformed)?;
        let known = &self.known;
        let names = &known.names;
        let facts = match (name, arguments) {
            ("more", [Term::Integer(cursor)]) => {
                let rows = self.cursors.remove(cursor).ok_or_else(malformed)?;
                return Ok(Reply::More(rows));
            }
            ("resolve", [Term::Atom(kind), term]) => match names.resolve(kind, term) {
                Ok(name) => vec![Term::Atom(name)],
                // A value that the query itself has bound is no mistyped name.
                Err(fault) if is_bound_by(&self.query, term, &fault) => Vec::new(),
                Err(fault) => return Err(fault.into()),
            },
            ("subclasses", [Term::Atom(name)]) => names.subclasses(name),
            ("superclasses", [Term::Atom(name)]) => names.superclasses(name),
            ("subproperties", [Term::Atom(name)]) => names.subproperties(name),
            ("superproperties", [Term::Atom(name)]) => names.superproperties(name),
            ("classes", []) => Ontology::load().classes().map(Term::atom).collect(),
            ("members", [Term::Atom(class)]) => self.sent.members(known, class),
            ("individual", [Term::Atom(name)]) => self.sent.individual(known, name),
            ("parts", [Term::Atom(name)]) => self.sent.parts(known, name),
            ("statements", [Term::Atom(name)]) => self.sent.statements(known, name),
            ("values_of", [Term::Atom(name), Term::Atom(property)]) => {
                self.sent.values_of(known, name, property)
            }
            ("size", [of]) => vec![Term::atom(self.size(of)?)],
            ("filter", [Term::Atom(property), Term::Atom(operator), bound]) => {
                let (found, asserted) = self.filter(property, operator, bound)?;
                let is_many = found.len() > FILTERED_FACTS;
                let names = known.name_rows(found).chain(asserted);
                if is_many {
                    return Ok(Reply::Stream(Box::new(names)));
                }
                list_facts("f", request, names.collect())
            }
            ("last_episode", []) => self.last_episode(),
            ("drifts", [Term::Atom(drift), from, to]) => {
                let channel = channel_of(drift).ok_or_else(malformed)?;
                drifts(
                    &known.catalogue,
                    channel,
                    times(from, to).ok_or_else(malformed)?,
                )
            }
            ("changes", [Term::Atom(drift), from, to]) => {
                let channel = channel_of(drift).ok_or_else(malformed)?;
                changes(
                    &known.catalogue,
                    channel,
                    times(from, to).ok_or_else(malformed)?,
                )
            }
            ("causes", [from, to]) => {
                causes(&known.catalogue, times(from, to).ok_or_else(malformed)?)
            }
            ("health_drifts", []) => health_drifts(&known.catalogue),
            ("series", [Term::Atom(drift), Term::Atom(thing)]) => {
                let channel = channel_of(drift).ok_or_else(malformed)?;
                series(&known.catalogue, channel, thing)
            }
            ("local_time", [time]) => {
                let time = time.as_number().ok_or_else(malformed)?;
                let text = if is_date(time) {
                    local_date_and_time(time)
                } else {
                    format!("{time:.1} s from the start of the log, undated")
                };
                vec![Term::Atom(text)]
            }
            ("format", [format, arguments]) => vec![Term::Atom(format_answer(format, arguments)?)],
            ("print", [format, arguments]) => {
                let text = format_answer(format, arguments)?;
                if self.printed.len() + text.len() > MOST_PRINTED {
                    let (what, limit) = ("bytes printed", MOST_PRINTED);
                    return Err(QueryFault::TooMuch { what, limit }.into());
                }
                self.printed.push_str(&text);
                Vec::new()
            }
            ("tell", [subject, Term::Atom(property), object]) => {
                let subject = subject.as_atom().ok_or_else(malformed)?;
                // Earlier statements are included: each statement is sent once.
                let mut facts = self.sent.assertions(&self.known, subject);
                let assertions = &mut self.known.assertions;
                facts.push(assertions.add(subject, property, object, self.max_assertions)?);
                facts
            }
            ("introduce", [name, Term::Atom(class)]) => self.introduce(name, class)?,
            _ => match self.stream(request)? {
                Some(rows) => return Ok(Reply::Stream(rows)),
                None => self.telemetry.rows(&self.known.catalogue, request)?,
            },
        };
        Ok(Reply::Facts(facts))
    }

    /// Adds an individual of a class, and returns it as a fact; no fact if it is known and of this class.
    fn introduce(&mut self, name: &Term, class: &str) -> Result<Vec<Term>, QueryFault> {
        let Some(name) = self.known.names.check_new_individual(name, class)? else {
            return Ok(Vec::new());
        };
        let assertions = &mut self.known.assertions;
        assertions.add_individual(&name, class, self.max_assertions)?;
        self.known.names.add_individual(&name, class);
        Ok(self.sent.individual(&self.known, &name))
    }

    /// Returns the rows of a streaming request; `None` for other requests.
    fn stream(&mut self, request: &Term) -> Result<Option<AnswerRows>, AskError> {
        let malformed = || AskError::unexpected(request);
        let known = &self.known;
        Ok(Some(match request.parts().ok_or_else(malformed)? {
            ("individuals", []) => known.individuals(),
            ("named_members", [Term::Atom(class)]) => {
                let shared = known.names.share_names(class).into_iter().map(Term::Atom);
                let members = known.name_rows(known.catalogue.individuals_of_class(class).to_vec());
                Box::new(members.chain(shared))
            }
            ("values", []) => known.all_values(),
            ("values", [Term::Atom(property)]) => known.column(property),
            ("relations", []) => known.relations(None),
            ("relations", [Term::Atom(property)]) => known.relations(Some(property)),
            ("related_to", [Term::Atom(object)]) => known.related_to(object),
            ("at", [start, end]) => {
                let times = times(start, end).ok_or_else(malformed)?;
                let found = self.intervals().find_related(Relation::Equals, times);
                self.known.name_rows(found)
            }
            ("relation", [Term::Atom(relation), start, end]) => {
                let relation = Relation::from_name(relation).ok_or_else(malformed)?;
                let times = times(start, end).ok_or_else(malformed)?;
                let found = self.intervals().find_related(relation, times);
                self.known.interval_rows(found)
            }
            ("pairs", [Term::Atom(relation)]) => {
                let relation = Relation::from_name(relation).ok_or_else(malformed)?;
                let index = self.intervals();
                self.known.pairs(index, relation)
            }
            _ => return Ok(None),
        }))
    }

    fn intervals(&mut self) -> Arc<IntervalIndex> {
        let timeline = self.indices.timeline(&self.known.catalogue);
        Arc::clone(&timeline.intervals)
    }

    /// Whether the engine keeps the results of a request (`few`), or gets them each time (`many`).
    fn size(&self, request: &Term) -> Result<&'static str, HostRefusal> {
        let is_many = match request.parts() {
            Some(("members", [Term::Atom(class)])) => {
                self.known.catalogue.individuals_of_class(class).len() > MOST_MEMBERS
            }
            Some(("filter", [Term::Atom(property), Term::Atom(operator), bound])) => {
                self.filter(property, operator, bound)?.0.len() > FILTERED_FACTS
            }
            _ => return Err(AskError::unexpected(request).into()),
        };
        Ok(if is_many { "many" } else { "few" })
    }

    /// Returns individuals whose number of a property meets a comparison with a bound, including people's statements.
    fn filter(
        &self,
        property: &str,
        operator: &str,
        bound: &Term,
    ) -> Result<(Vec<IndividualId>, Vec<Term>), HostRefusal> {
        #[allow(clippy::float_cmp, reason = "the query asks for exact equality")]
        let matches: fn(f64, f64) -> bool = match operator {
            "=<" => |value, bound| value <= bound,
            ">=" => |value, bound| value >= bound,
            "<" => |value, bound| value < bound,
            ">" => |value, bound| value > bound,
            "=:=" => |value, bound| value == bound,
            _ => return Err(AskError::unexpected(format!("filter with {operator}")).into()),
        };
        let number = bound.as_number();
        let bound = number.ok_or_else(|| AskError::unexpected(format!("filter by {bound}")))?;
        let numbers = self.known.catalogue.numbers(property).iter();
        let matching = numbers.filter(|(_, value)| matches(*value, bound));
        let asserted = self.known.assertions.values(property).into_iter();
        let asserted = asserted.filter_map(|pair| match pair {
            Term::Compound(_, parts) => {
                let [value, name] = <[Term; 2]>::try_from(parts).ok()?;
                matches(value.as_number()?, bound).then_some(name)
            }
            _ => None,
        });
        let found: Vec<IndividualId> = matching.map(|(id, _)| *id).collect();
        // Once each, with however many values.
        let mut others: Vec<Term> = Vec::new();
        for name in asserted {
            let id = name
                .as_atom()
                .and_then(|name| self.known.names.individual(name));
            if !others.contains(&name) && id.is_none_or(|id| !found.contains(&id)) {
                others.push(name);
            }
        }
        Ok((found, others))
    }

    fn last_episode(&self) -> Vec<Term> {
        let row = self.known.last_episode().map(|episode| {
            let name = name_of(&self.known.catalogue, episode.first);
            Term::compound("-", [name, Term::Float(episode.interval[1])])
        });
        row.into_iter().collect()
    }
}

fn times(start: &Term, end: &Term) -> Option<[f64; 2]> {
    Some([start.as_number()?, end.as_number()?])
}

/// Whether a value that names nothing was bound by the query itself, and does not stand in its text.
fn is_bound_by(query: &str, term: &Term, fault: &QueryFault) -> bool {
    matches!(term, Term::Atom(_) | Term::Integer(_) | Term::Float(_))
        && locate_fault(fault, query).is_none()
}
