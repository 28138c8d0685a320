//! The robot of a session, the settings of each stage, and the conditions under which a session ends.

use super::OnWarning;
use crate::follow::{FollowConfig, WorkcellConfig};
use crate::plan::PlanConfig;
use crate::represent::Sight;
use crate::robot::{CapabilityMap, RobotModel, Srdf};

pub use crate::recover::Pace;

/// The robot setup that a session borrows; `wisch_io::Robot` reads one from files.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotSetup<'a> {
    /// The robot's links, joints and limits.
    pub robot: &'a RobotModel,
    /// The robot's groups and named states, and the link pairs that may touch.
    pub srdf: Option<&'a Srdf>,
    /// Capability map of the arm, for the placement of the base; `None` rates base poses by inverse kinematics,
    /// slowly.
    pub map: Option<&'a CapabilityMap>,
}

/// What happens after a person or a safety system stops the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AfterStop {
    /// The session ends: the robot waits for its operator.
    #[default]
    Wait,
    /// The robot retreats from the surface by itself, and the session continues.
    Retreat,
}

/// Lowest score of a plan that is executed, unless the task sets another \[1\]. A plan that loses
/// half of the dirt has a lower score, whatever share it brings to the goal.
pub const MIN_SCORE: f64 = -1.0;

/// Largest permitted share of unchanged runs that give a warning, unless the task sets another
/// \[1\].
pub const FALSE_WARNING_RATE: f64 = 0.02;

/// Settings of each stage, and the conditions under which a session ends. All seeds derive from the task's.
///
/// ```
/// use wisch::run::RunConfig;
/// let config = RunConfig { target: 0.9, max_rounds: 2, ..RunConfig::default() };
/// assert_eq!(config.variants, 1);
/// ```
#[derive(Debug, Clone)]
pub struct RunConfig {
    /// Settings of the planner.
    pub plan: PlanConfig,
    /// Number of candidate plans among which the prediction chooses in the first round.
    pub variants: usize,
    /// Settings of robot and tool.
    pub workcell: WorkcellConfig,
    /// Settings of the joint motions.
    pub follow: FollowConfig,
    /// Estimated performance at which the goal is met \[1\].
    pub target: f64,
    /// Lowest score of a plan that is executed in the first round, see
    /// [`Prediction::score`](crate::plan::Prediction::score) \[1\].
    pub min_score: f64,
    /// Largest number of rounds.
    pub max_rounds: usize,
    /// Amount of work in one round.
    pub pace: Pace,
    /// Whether a round ends during a stroke that no longer has an effect, because contact is lost or the tool is
    /// led away; the next round plans for the remaining dirt.
    pub end_strokes_early: bool,
    /// What happens after a person or a safety system stops the robot.
    pub after_stop: AfterStop,
    /// What happens after a warning of the [watch](super::Session::with_warnings).
    pub on_warning: OnWarning,
    /// Largest permitted share of unchanged runs that give a warning \[1\], for the watch.
    pub false_warning_rate: f64,
    /// Largest distance of any joint from the start of a motion [rad or m].
    pub start_tolerance: f64,
    /// Model of the camera; `None` for a robot that only measures forces.
    pub sight: Option<Sight>,
}

impl Default for RunConfig {
    /// One plan by the grid strategy, a target of 95 %, and at most four rounds.
    fn default() -> Self {
        Self {
            plan: PlanConfig::default(),
            variants: 1,
            workcell: WorkcellConfig::default(),
            follow: FollowConfig::default(),
            target: 0.95,
            min_score: MIN_SCORE,
            max_rounds: 4,
            pace: Pace::Whole,
            end_strokes_early: false,
            after_stop: AfterStop::default(),
            on_warning: OnWarning::default(),
            false_warning_rate: FALSE_WARNING_RATE,
            start_tolerance: 0.05,
            sight: None,
        }
    }
}
