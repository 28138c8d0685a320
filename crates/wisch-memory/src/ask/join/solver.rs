//! Solver of goals: depth first, solution by solution, like Prolog, with indices instead of names.

use super::compile::{find_thing, thing_of};
use super::expression::Expression;
use super::goal::{Aggregate, Block, Goal};
use super::indices::Indices;
use super::value::{JoinValue, Pattern};
use crate::ask::error::AskError;
use crate::ask::streams::Knowledge;
use crate::ask::telemetry_predicates::TelemetryPredicates;
use crate::ask::term::Term;
use crate::catalogue::IndividualId;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Largest number of solutions that are sorted back into their order; more are left to the engine.
const MOST_SORTED: usize = 1_000_000;
/// Number of candidates between two checks of the clock.
const CLOCK_CHECK: u64 = 4096;

/// Whether the caller wants more solutions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow {
    /// The next solution is wanted.
    Continue,
    /// No more solutions are wanted.
    Stop,
}

/// The reason why the solver ends before all solutions are found.
#[derive(Debug)]
pub enum Stop {
    /// The engine must solve the goals.
    Declined,
    /// The query ends.
    Error(AskError),
}

/// Limits of the solver's time and work.
#[derive(Debug, Clone, Copy)]
pub struct SolverBudget<'a> {
    /// Deadline of the query.
    pub deadline: Instant,
    /// Time limit of the query, for the error.
    pub time: Duration,
    /// Flag that ends the query when it is set.
    pub interrupt: &'a AtomicBool,
    /// Number of candidates above which the engine must solve the goals, since it searches no further than the wanted
    /// solutions.
    pub candidates: u64,
}

/// The callback that receives each solution.
pub type Next<'n, 's> = &'n mut dyn FnMut(&mut Solver<'s>, u64) -> Result<Flow, Stop>;

/// A solver of compiled goals over the catalogue's columns.
pub struct Solver<'s> {
    pub(super) known: &'s Knowledge,
    pub(super) indices: &'s mut Indices,
    pub(super) telemetry: &'s mut TelemetryPredicates,
    budget: SolverBudget<'s>,
    bindings: Vec<Option<JoinValue>>,
    trail: Vec<usize>,
    /// Number of the current solution of each goal, by which solutions are sorted if goals were moved.
    keys: Vec<u64>,
    candidates: u64,
}

impl<'s> Solver<'s> {
    /// Creates a solver for goals with this number of variables.
    pub fn new(
        known: &'s Knowledge,
        indices: &'s mut Indices,
        telemetry: &'s mut TelemetryPredicates,
        budget: SolverBudget<'s>,
        variables: usize,
    ) -> Self {
        Self {
            known,
            indices,
            telemetry,
            budget,
            bindings: vec![None; variables],
            trail: Vec::new(),
            keys: Vec::new(),
            candidates: 0,
        }
    }

    /// Passes all solutions of a block on, in Prolog's order.
    ///
    /// # Errors
    /// If the query must end, or the engine must solve the goals.
    pub fn solve(
        &mut self,
        block: &Block,
        next: &mut dyn FnMut(&mut Self) -> Result<Flow, Stop>,
    ) -> Result<Flow, Stop> {
        if block.stood.is_empty() {
            return self.goals(&block.goals, next);
        }
        let len = block.goals.len();
        let mut found: Vec<(Vec<u64>, Vec<Option<JoinValue>>)> = Vec::new();
        self.goals(&block.goals, &mut |solver| {
            solver.tick()?;
            if found.len() == MOST_SORTED {
                return Err(Stop::Declined);
            }
            let last = &solver.keys[solver.keys.len() - len..];
            let mut keys = vec![0; len];
            for (place, key) in block.stood.iter().zip(last) {
                keys[*place] = *key;
            }
            let values = block
                .binds
                .iter()
                .map(|&variable| solver.bindings[variable].clone());
            found.push((keys, values.collect()));
            Ok(Flow::Continue)
        })?;
        found.sort_by(|a, b| a.0.cmp(&b.0));
        for (_, values) in found {
            let mark = self.trail.len();
            for (variable, value) in block.binds.iter().zip(values) {
                if self.bindings[*variable].is_none()
                    && let Some(value) = value
                {
                    self.bind(*variable, value);
                }
            }
            let flow = next(self)?;
            self.undo(mark);
            if flow == Flow::Stop {
                return Ok(flow);
            }
        }
        Ok(Flow::Continue)
    }

    fn goals(
        &mut self,
        goals: &[Goal],
        next: &mut dyn FnMut(&mut Self) -> Result<Flow, Stop>,
    ) -> Result<Flow, Stop> {
        let Some((goal, rest)) = goals.split_first() else {
            return next(self);
        };
        self.goal(goal, &mut |solver, key| {
            solver.keys.push(key);
            let flow = solver.goals(rest, next);
            solver.keys.pop();
            flow
        })
    }

    fn goal(&mut self, goal: &Goal, next: Next<'_, 's>) -> Result<Flow, Stop> {
        match goal {
            Goal::Class { thing, classes } => self.class(thing, classes, next),
            Goal::Statement {
                subject,
                object,
                sources,
            } => self.statement(subject, object, sources, next),
            Goal::Compared {
                thing,
                properties,
                comparison,
                bound,
            } => self.compared(thing, properties, *comparison, bound, next),
            Goal::Timed { event, start, end } => self.timed(event, [start, end], next),
            Goal::Related {
                relation,
                first,
                second,
            } => self.related(*relation, first, second, next),
            Goal::PartBelow {
                whole,
                part,
                classes,
            } => self.part_below(whole, part, classes, next),
            Goal::Above {
                part,
                whole,
                classes,
            } => self.above(part, whole, classes, next),
            Goal::LastEpisode { episode, time } => self.last_episode(episode, time, next),
            Goal::Telemetry {
                episode,
                channel,
                when,
                statistic,
                value,
            } => self.telemetry_statistic([episode, channel, when, statistic, value], next),
            Goal::Is(result, expression) => self.assign(result, expression, next),
            Goal::Comparison(comparison, left, right) => {
                let (left, right) = (self.number(left)?, self.number(right)?);
                self.continue_if(comparison.holds(left, right), next)
            }
            Goal::Same(left, right) => self.equate(left, right, next),
            Goal::Number(pattern) => self.check_number(pattern, next),
            Goal::Length(list, len) => self.measure_length(list, len, next),
            Goal::Not(block) => self.solve_negation(block, next),
            Goal::Either(blocks) => self.solve_each(blocks, next),
            Goal::Once(block) => self.solve_once(block, next),
            Goal::Over {
                block,
                aggregate,
                result,
            } => self.aggregate(block, aggregate, result, next),
            Goal::MeanByKey {
                block,
                key,
                number,
                result,
            } => self.average_by_key(block, [key, number], result, next),
        }
    }

    /// Unifies a pattern with the value of an expression.
    fn assign(
        &mut self,
        result: &Pattern,
        expression: &Expression,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let value = self.evaluate(expression)?;
        self.candidate(&[(result, value)], 0, next)
    }

    /// Continues if two known patterns are equal, or unifies an unknown pattern with the other.
    fn equate(
        &mut self,
        left: &Pattern,
        right: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        match (self.instance(left), self.instance(right)) {
            (Some(left), Some(right)) => {
                let is_same = self.are_same(&left, &right).ok_or(Stop::Declined)?;
                self.continue_if(is_same, next)
            }
            (Some(value), None) => self.candidate(&[(right, value)], 0, next),
            (None, Some(value)) => self.candidate(&[(left, value)], 0, next),
            (None, None) => Err(Stop::Declined),
        }
    }

    /// Continues if a pattern is a number.
    fn check_number(&mut self, pattern: &Pattern, next: Next<'_, 's>) -> Result<Flow, Stop> {
        let value = self.instance(pattern);
        self.continue_if(value.is_some_and(|value| value.as_number().is_some()), next)
    }

    /// Unifies a pattern with the length of a known list.
    fn measure_length(
        &mut self,
        list: &Pattern,
        len: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let Some(JoinValue::Term(Term::List(items))) = self.instance(list) else {
            return Err(Stop::Declined);
        };
        let found = i64::try_from(items.len()).map_err(|_| Stop::Declined)?;
        self.candidate(&[(len, JoinValue::Integer(found))], 0, next)
    }

    /// Continues if a block has no solution.
    fn solve_negation(&mut self, block: &Block, next: Next<'_, 's>) -> Result<Flow, Stop> {
        let mut is_found = false;
        self.solve(block, &mut |_| {
            is_found = true;
            Ok(Flow::Stop)
        })?;
        self.continue_if(!is_found, next)
    }

    /// Continues with the solutions of each block, one block after the other.
    fn solve_each(&mut self, blocks: &[Block], next: Next<'_, 's>) -> Result<Flow, Stop> {
        for block in blocks {
            if self.solve(block, &mut |solver| next(solver, 0))? == Flow::Stop {
                return Ok(Flow::Stop);
            }
        }
        Ok(Flow::Continue)
    }

    /// Continues with the first solution of a block.
    fn solve_once(&mut self, block: &Block, next: Next<'_, 's>) -> Result<Flow, Stop> {
        let mut flow = Flow::Continue;
        self.solve(block, &mut |solver| {
            flow = next(solver, 0)?;
            Ok(Flow::Stop)
        })?;
        Ok(flow)
    }

    /// Unifies a pattern with an aggregate over the solutions of a block, if there is one.
    fn aggregate(
        &mut self,
        block: &Block,
        aggregate: &Aggregate,
        result: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        match self.compute_aggregate(block, aggregate)? {
            Some(value) => self.candidate(&[(result, value)], 0, next),
            None => Ok(Flow::Continue),
        }
    }

    /// Unifies `Key`, `Mean` and `Count` with those of each group of solutions of a block.
    fn average_by_key(
        &mut self,
        block: &Block,
        [key, number]: [&Pattern; 2],
        [of, mean, count]: &[Pattern; 3],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        for (place, group) in (0..).zip(self.means(block, key, number)?) {
            let [key, average, members] = group;
            let pairs = [(of, key), (mean, average), (count, members)];
            if self.candidate(&pairs, place, next)? == Flow::Stop {
                return Ok(Flow::Stop);
            }
        }
        Ok(Flow::Continue)
    }

    pub(super) fn continue_if(&mut self, holds: bool, next: Next<'_, 's>) -> Result<Flow, Stop> {
        if holds {
            next(self, 0)
        } else {
            Ok(Flow::Continue)
        }
    }

    /// Continues with patterns unified with values, if possible; then undoes the bindings.
    pub(super) fn candidate(
        &mut self,
        pairs: &[(&Pattern, JoinValue)],
        key: u64,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        self.tick()?;
        let mark = self.trail.len();
        let fits = pairs
            .iter()
            .all(|(pattern, value)| self.unify(pattern, value));
        let flow = if fits {
            next(self, key)?
        } else {
            Flow::Continue
        };
        self.undo(mark);
        Ok(flow)
    }

    /// Counts a candidate, and checks time and interrupt regularly.
    pub(super) fn tick(&mut self) -> Result<(), Stop> {
        self.candidates += 1;
        if !self.candidates.is_multiple_of(CLOCK_CHECK) {
            return Ok(());
        }
        if self.budget.interrupt.swap(false, Ordering::Relaxed) {
            return Err(Stop::Error(AskError::Interrupted));
        }
        if Instant::now() >= self.budget.deadline {
            return Err(Stop::Error(AskError::Time(self.budget.time)));
        }
        if self.candidates > self.budget.candidates {
            return Err(Stop::Declined);
        }
        Ok(())
    }

    /// Whether two values are equal by the engine's `same/2`; `None` if names must be resolved.
    fn are_same(&self, left: &JoinValue, right: &JoinValue) -> Option<bool> {
        if left.is_same(right, &self.known.catalogue) {
            return Some(true);
        }
        if let (Some(left), Some(right)) = (left.as_number(), right.as_number()) {
            #[allow(clippy::float_cmp, reason = "the query asks for exact equality")]
            return Some(left == right);
        }
        let may_name = |value: &JoinValue| match value {
            JoinValue::Individual(_) | JoinValue::Shared(_) => true,
            JoinValue::Term(Term::Atom(_)) => true,
            JoinValue::Term(Term::Compound(colon, _)) => colon == ":",
            _ => false,
        };
        let has_prefix = |value: &JoinValue| match value {
            JoinValue::Individual(_) | JoinValue::Shared(_) => true,
            JoinValue::Term(Term::Atom(name)) => name.contains(':'),
            _ => true,
        };
        let is_full =
            |value: &JoinValue| matches!(value, JoinValue::Individual(_) | JoinValue::Shared(_));
        if !may_name(left) || !may_name(right) || (is_full(left) && is_full(right)) {
            return Some(false);
        }
        (!has_prefix(left) && !has_prefix(right)).then_some(false)
    }

    fn bind(&mut self, variable: usize, value: JoinValue) {
        self.bindings[variable] = Some(value);
        self.trail.push(variable);
    }

    fn undo(&mut self, mark: usize) {
        for variable in self.trail.drain(mark..) {
            self.bindings[variable] = None;
        }
    }

    fn unify(&mut self, pattern: &Pattern, value: &JoinValue) -> bool {
        match (pattern, value) {
            (Pattern::Variable(variable), _) => match &self.bindings[*variable] {
                Some(found) => found.is_same(value, &self.known.catalogue),
                None => {
                    self.bind(*variable, value.clone());
                    true
                }
            },
            (Pattern::JoinValue(found), _) => found.is_same(value, &self.known.catalogue),
            (Pattern::List(patterns), JoinValue::Term(Term::List(items))) => {
                self.unify_all(patterns, items)
            }
            (Pattern::Compound(name, patterns), JoinValue::Term(Term::Compound(other, items))) => {
                name == other && self.unify_all(patterns, items)
            }
            _ => false,
        }
    }

    fn unify_all(&mut self, patterns: &[Pattern], items: &[Term]) -> bool {
        let mut pairs = patterns.iter().zip(items);
        patterns.len() == items.len()
            && pairs.all(|(pattern, item)| self.unify(pattern, &JoinValue::from_term(item.clone())))
    }

    /// Returns the value of a pattern, if all of it is known.
    pub(super) fn instance(&self, pattern: &Pattern) -> Option<JoinValue> {
        match pattern {
            Pattern::Variable(variable) => self.bindings[*variable].clone(),
            Pattern::JoinValue(value) => Some(value.clone()),
            Pattern::List(items) => Some(JoinValue::Term(Term::List(self.instances(items)?))),
            Pattern::Compound(name, items) => {
                let items = self.instances(items)?;
                Some(JoinValue::Term(Term::compound(name, items)))
            }
        }
    }

    fn instances(&self, patterns: &[Pattern]) -> Option<Vec<Term>> {
        let values = patterns.iter().map(|pattern| self.instance(pattern));
        let terms = values.map(|value| Some(value?.to_term(&self.known.catalogue)));
        terms.collect()
    }

    /// Returns the value of a pattern as a term.
    ///
    /// # Errors
    /// If a variable in it is unbound.
    pub fn term(&self, pattern: &Pattern) -> Result<Term, Stop> {
        let value = self.instance(pattern).ok_or(Stop::Declined)?;
        Ok(value.to_term(&self.known.catalogue))
    }

    /// Returns the value of a pattern as an answer, which may be an unbound variable itself.
    ///
    /// # Errors
    /// If a variable within the term is unbound.
    pub fn answer(&self, pattern: &Pattern) -> Result<Term, Stop> {
        match pattern {
            Pattern::Variable(variable) if self.bindings[*variable].is_none() => {
                Ok(Term::Variable("_".to_owned()))
            }
            other => self.term(other),
        }
    }

    /// Returns the thing that a pattern refers to; `None` for an unbound variable.
    pub(super) fn thing(&self, pattern: &Pattern) -> Result<Option<JoinValue>, Stop> {
        match self.instance(pattern) {
            // Only a full name equals the name that a goal finds.
            Some(JoinValue::Term(Term::Atom(name))) => {
                let thing = thing_of(self.known, &Term::atom(&name)).ok_or(Stop::Declined)?;
                let is_full = thing.to_term(&self.known.catalogue).as_atom() == Some(&name);
                is_full.then_some(Some(thing)).ok_or(Stop::Declined)
            }
            Some(JoinValue::Term(_)) => Err(Stop::Declined),
            Some(JoinValue::Integer(_) | JoinValue::Float(_)) => Err(Stop::Declined),
            other => Ok(other),
        }
    }

    /// Returns the individual that a pattern refers to: `Ok(Err(true))` for an unbound variable, `Ok(Err(false))` for
    /// another thing.
    pub(super) fn individual(&self, pattern: &Pattern) -> Result<Result<IndividualId, bool>, Stop> {
        Ok(match self.thing(pattern)? {
            Some(JoinValue::Individual(id)) => Ok(id),
            Some(_) => Err(false),
            None => Err(true),
        })
    }

    /// Returns the thing with a full name.
    pub(super) fn find_thing(&self, name: String) -> JoinValue {
        find_thing(self.known, name)
    }

    pub(super) fn evaluate(&self, expression: &Expression) -> Result<JoinValue, Stop> {
        let value = expression.evaluate(&|pattern| self.instance(pattern));
        value.ok_or(Stop::Declined)
    }

    pub(super) fn number(&self, expression: &Expression) -> Result<f64, Stop> {
        self.evaluate(expression)?.as_number().ok_or(Stop::Declined)
    }
}
