//! What a session says while it goes on.

use super::{Considered, PlannedRound, Round, TelemetrySample};
use crate::follow::Audit;
use crate::plan::{Plan, PredictionProgress};
use crate::recover::Verdict;
use crate::represent::{Observation, Task};
use std::ops::ControlFlow;

/// What a session is at or has just done, in the order in which it happens.
#[derive(Debug, Clone, Copy)]
pub enum RunEvent<'a> {
    /// A round is being planned.
    Planning {
        /// The round, from 1.
        round: usize,
    },
    /// Plans of several strategies were weighed against each other; that which is worth most becomes the round's plan.
    Considered {
        /// The round, from 1.
        round: usize,
        /// One of each strategy.
        considered: &'a [Considered],
    },
    /// A round is planned.
    Planned {
        /// The round, from 1.
        round: usize,
        /// Its plan.
        plan: &'a Plan,
    },
    /// The plan is being followed.
    Following {
        /// The round, from 1.
        round: usize,
        /// Nodes passed.
        passed: usize,
        /// Of so many.
        nodes: usize,
    },
    /// The effect of the followed plan is being predicted.
    Predicting {
        /// The round, from 1.
        round: usize,
        /// The task, with the dirt that it is predicted on.
        task: &'a Task,
        /// The plan as the robot wipes it.
        wiped: &'a Plan,
        /// How far it has come.
        progress: PredictionProgress<'a>,
    },
    /// The motion was checked.
    Audited {
        /// The round, from 1.
        round: usize,
        /// What the check says.
        audit: &'a Audit,
    },
    /// An execution begins.
    Executing(&'a PlannedRound),
    /// One sample of it.
    Sample(&'a TelemetrySample<'a>),
    /// The log is being interpreted.
    Interpreting {
        /// The round, from 1.
        round: usize,
    },
    /// The surface was looked at.
    Observed {
        /// After this round; 0 before the first.
        round: usize,
        /// What was seen.
        observation: &'a Observation,
    },
    /// A round is over.
    Judged(&'a Round),
    /// The session is over, for this reason; `None` if an observer stopped it.
    Ended(Option<Verdict>),
}

/// An observer that looks away.
pub fn unobserved(_: &RunEvent<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Looks on while a session goes on, and may stop it at any event: a motion that is about to be executed is not, an
/// execution that has begun is interpreted as far as it went.
pub type Observer<'a> = dyn FnMut(&RunEvent<'_>) -> ControlFlow<()> + 'a;
