//! A run, as it is to be shown.

use crate::motion::MotionInput;
use crate::prediction::frames::EffectFrames;
use crate::rounds::RoundsInput;
use wisch::plan::{Plan, Prediction};
use wisch::represent::Task;

/// What a report is made of.
#[derive(Debug, Clone, Copy)]
pub struct ReportInput<'a> {
    /// Headline of the figures; the task's name as a rule.
    pub title: &'a str,
    /// What was to be done.
    pub task: &'a Task,
    /// How it is to be done.
    pub plan: &'a Plan,
    /// What is to be expected of it.
    pub prediction: &'a Prediction,
    /// The effect over time, recorded while the prediction ran.
    pub frames: &'a EffectFrames,
    /// Bandwidth that the plan was asked for, [`wisch::plan::PlanConfig::bandwidth`] [m].
    pub bandwidth: Option<f64>,
    /// How a robot does it; `None` if none was asked to.
    pub motion: Option<&'a MotionInput<'a>>,
    /// What came of it, round by round; `None` if nothing was executed.
    pub rounds: Option<&'a RoundsInput<'a>>,
}
