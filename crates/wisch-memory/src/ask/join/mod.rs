//! Joins: what a query asks of facts alone is found here, over the catalogue's columns, in place of a conversation with
//! the engine about each of them.
//!
//! The engine sends goals as terms (`prolog/plan.pl` says which, and puts definitions in place of predicates that stand
//! for them). They are compiled, ordered by what they leave to go through, and solved; solutions come in the order in
//! which Prolog would find them. Whatever is beyond this, or on which engines do not agree, is declined: then the engine
//! calls the same goals itself, and says what is wrong with them if something is.

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

/// Solutions of goals.
#[derive(Debug, Default, PartialEq)]
pub struct Solutions {
    /// What was asked for, by solution.
    pub rows: Vec<Vec<Term>>,
    /// Whether there are as many as were wanted, and perhaps more.
    pub is_cut: bool,
}

/// What goals are solved with.
pub struct Joins<'a> {
    /// What is known.
    pub known: &'a Knowledge,
    /// What finds it faster.
    pub indices: &'a mut Indices,
    /// What was felt.
    pub telemetry: &'a mut TelemetryPredicates,
}

impl Joins<'_> {
    /// At most so many solutions of a list of goals, with what each of these terms is in them; `None` where the engine
    /// is to solve them.
    ///
    /// # Errors
    /// If the query has to end.
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
