//! Input of the figures of a run.

use crate::motion::MotionInput;
use crate::prediction::frames::EffectFrames;
use crate::rounds::RoundsInput;
use wisch::plan::{Plan, Prediction};
use wisch::represent::Task;

/// Input of the figures of a run.
#[derive(Debug, Clone, Copy)]
pub struct ReportInput<'a> {
    /// Headline of the figures; usually the task's name.
    pub title: &'a str,
    /// The task.
    pub task: &'a Task,
    /// The plan.
    pub plan: &'a Plan,
    /// Predicted effect of the plan.
    pub prediction: &'a Prediction,
    /// Predicted effect over time, recorded during the prediction.
    pub frames: &'a EffectFrames,
    /// Bandwidth of the planner settings, [`wisch::plan::PlanConfig::bandwidth`] \[m\].
    pub bandwidth: Option<f64>,
    /// The robot's motion; `None` without a robot.
    pub motion: Option<&'a MotionInput<'a>>,
    /// The executed rounds; `None` without execution.
    pub rounds: Option<&'a RoundsInput<'a>>,
}
