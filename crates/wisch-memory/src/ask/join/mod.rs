//! Joins: goals that only look facts up are solved here, over the catalogue's columns, instead of exchanging messages
//! with the engine about each fact.
//!
//! The engine sends goals as terms; `prolog/plan.pl` selects them, and replaces predicates by their definitions. This
//! module compiles the goals, orders them by the number of candidates, and solves them; solutions arrive in Prolog's
//! order. Goals that this module does not support, or on which engines disagree, are declined. Then the engine calls
//! the same goals itself, and reports their faults.

mod aggregate;
mod compile;
mod expression;
mod facts;
mod goal;
mod indices;
mod order;
mod solver;
mod value;

#[cfg(test)]
mod tests;

pub use indices::Indices;
pub use solver::SolverBudget;

use super::error::AskError;
use super::streams::Knowledge;
use super::telemetry_predicates::TelemetryPredicates;
use super::term::Term;
use compile::Compiler;
use solver::{Flow, Solver, Stop};
use value::Pattern;

/// The solutions of a conjunction of goals.
#[derive(Debug, Default, PartialEq)]
pub struct Solutions {
    /// Values of the wanted terms, by solution.
    pub rows: Vec<Vec<Term>>,
    /// Whether the wanted number is reached, so that there may be more solutions.
    pub is_cut: bool,
}

/// The data with which goals are solved.
pub struct Joins<'a> {
    /// Episodes and statements.
    pub known: &'a Knowledge,
    /// Indices that speed up the search.
    pub indices: &'a mut Indices,
    /// Telemetry of the episodes.
    pub telemetry: &'a mut TelemetryPredicates,
}

impl Joins<'_> {
    /// Returns at most the wanted number of solutions of a list of goals, as values of the wanted terms; `None` if the
    /// engine must solve them.
    ///
    /// # Errors
    /// If the query must end.
    pub fn solve(
        self,
        goals: &Term,
        wanted: &[Term],
        most: usize,
        budget: SolverBudget<'_>,
    ) -> Result<Option<Solutions>, AskError> {
        if goals.is_cut_short() {
            return Ok(None);
        }
        let mut compiler = Compiler::new(self.known);
        let Some(block) = compiler.block(goals) else {
            return Ok(None);
        };
        let patterns = wanted.iter().map(|term| compiler.pattern(term));
        let Some(patterns) = patterns.collect::<Option<Vec<Pattern>>>() else {
            return Ok(None);
        };
        let variables = compiler.len();
        let mut solver = Solver::new(self.known, self.indices, self.telemetry, budget, variables);
        let mut solutions = Solutions::default();
        let solved = solver.solve(&block, &mut |solver| {
            let row = patterns.iter().map(|pattern| solver.answer(pattern));
            solutions.rows.push(row.collect::<Result<_, _>>()?);
            let is_enough = solutions.rows.len() >= most;
            solutions.is_cut = is_enough;
            Ok(if is_enough {
                Flow::Stop
            } else {
                Flow::Continue
            })
        });
        match solved {
            Ok(_) => Ok(Some(solutions)),
            Err(Stop::Declined) => Ok(None),
            Err(Stop::Error(error)) => Err(error),
        }
    }
}
