//! Events of a session.

use super::{CandidateEvaluation, PlannedRound, Round, RunWarning, TelemetrySample};
use crate::follow::Audit;
use crate::plan::{Plan, PredictionProgress};
use crate::recover::Verdict;
use crate::represent::{Observation, Task};
use std::ops::ControlFlow;

/// What a session is doing or has just done, in the order of the stages.
///
/// ```
/// use std::ops::ControlFlow;
/// use wisch::run::RunEvent;
/// /// Stops a session before its third round.
/// fn stop_early(event: &RunEvent<'_>) -> ControlFlow<()> {
///     match event {
///         RunEvent::Planning { round: 3 } => ControlFlow::Break(()),
///         _ => ControlFlow::Continue(()),
///     }
/// }
/// assert!(stop_early(&RunEvent::Planning { round: 1 }).is_continue());
/// assert!(stop_early(&RunEvent::Planning { round: 3 }).is_break());
/// ```
#[derive(Debug, Clone, Copy)]
pub enum RunEvent<'a> {
    /// A round is being planned.
    Planning {
        /// The round, from 1.
        round: usize,
    },
    /// Plans of several strategies were evaluated; the plan with the highest score becomes the round's plan.
    Evaluated {
        /// The round, from 1.
        round: usize,
        /// One evaluation for each strategy.
        considered: &'a [CandidateEvaluation],
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
        /// Number of nodes followed so far.
        passed: usize,
        /// Number of all nodes.
        nodes: usize,
    },
    /// The effect of the followed plan is being predicted.
    Predicting {
        /// The round, from 1.
        round: usize,
        /// The task, with the dirt of the prediction.
        task: &'a Task,
        /// The part of the plan that the robot executes.
        wiped: &'a Plan,
        /// Progress of the prediction.
        progress: PredictionProgress<'a>,
    },
    /// The motion was checked.
    Audited {
        /// The round, from 1.
        round: usize,
        /// Result of the check.
        audit: &'a Audit,
    },
    /// An execution begins.
    Executing(&'a PlannedRound),
    /// A sample of the execution.
    Sample(&'a TelemetrySample<'a>),
    /// The running stroke differs from earlier runs; the sample that shows it precedes this event.
    Warned(&'a RunWarning),
    /// The log is being interpreted.
    Interpreting {
        /// The round, from 1.
        round: usize,
    },
    /// The camera observed the surface.
    Observed {
        /// The round after which it was observed; 0 before the first.
        round: usize,
        /// The observation.
        observation: &'a Observation,
    },
    /// A round is over.
    Decided(&'a Round),
    /// The session is over, for this reason; `None` if an observer stopped it.
    Ended(Option<Verdict>),
}

/// An observer that ignores every event.
///
/// ```
/// use std::ops::ControlFlow;
/// use wisch::run::{RunEvent, ignore_events};
/// assert_eq!(ignore_events(&RunEvent::Planning { round: 1 }), ControlFlow::Continue(()));
/// ```
pub fn ignore_events(_: &RunEvent<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Receives the events of a session, and may stop it at any of them. A motion that has not begun is then not
/// executed; an execution in progress is interpreted up to that point.
pub type Observer<'a> = dyn FnMut(&RunEvent<'_>) -> ControlFlow<()> + 'a;
