//! The plan of a first round, kept for another session with the same inputs.

use super::{CandidateEvaluation, PlannedRound, RobotSetup};
use crate::follow::{FollowConfig, WorkcellConfig};
use crate::interpret::Belief;
use crate::plan::{Plan, PlanConfig};
use crate::recover::Pace;
use crate::represent::Task;

/// The plan of a first round, with its motion and all inputs from which both were computed.
///
/// [`Session::plan_first`](super::Session::plan_first) computes it. A session that gets it by
/// [`Session::with_first_plan`](super::Session::with_first_plan) uses it if its own inputs are equal to these, and otherwise
/// plans anew.
#[derive(Debug, Clone)]
pub struct FirstPlan<'a> {
    pub(super) inputs: FirstInputs<'a>,
    /// The candidates that were compared; `None` if the strategy compares none.
    pub(super) considered: Option<Vec<CandidateEvaluation>>,
    pub(super) plan: Plan,
    /// The motion, with the numbers of nodes that its computation reported; `None` without a robot.
    pub(super) motion: Option<(Box<PlannedRound>, Vec<usize>)>,
}

/// All inputs of the plan and the motion of a first round.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FirstInputs<'a> {
    pub task: Task,
    pub belief: Belief,
    pub robot: Option<RobotSetup<'a>>,
    pub workcell: WorkcellConfig,
    pub plan: PlanConfig,
    pub variants: usize,
    pub follow: FollowConfig,
    pub pace: Pace,
    /// Whether a camera has observed the dirt.
    pub is_observed: bool,
    /// Last known joint positions [rad or m].
    pub positions: Option<Vec<f64>>,
}
