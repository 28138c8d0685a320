//! Who wipes, how each stage works, and when to stop.

use crate::follow::{FollowConfig, WorkcellConfig};
use crate::plan::PlanConfig;
use crate::represent::Sight;
use crate::robot::{CapabilityMap, RobotModel, Srdf};

pub use crate::recover::Pace;

/// The robot that is to wipe, as a session borrows it; `wisch_io::Robot` reads one from files.
#[derive(Debug, Clone, Copy)]
pub struct Performer<'a> {
    /// Its links, joints and limits.
    pub robot: &'a RobotModel,
    /// Its groups, states and pairs that may touch.
    pub srdf: Option<&'a Srdf>,
    /// What its arm reaches, for the placement of the base; `None` rates places by inverse kinematics, slowly.
    pub map: Option<&'a CapabilityMap>,
}

/// What follows where a person or a safety system stopped the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AfterStop {
    /// The session ends: the robot waits for its operator.
    #[default]
    Wait,
    /// The robot retreats from the surface by itself, and the session goes on.
    Retreat,
}

/// Least score of a plan that is executed unless the task says otherwise [1]: a plan that loses half of the dirt has less,
/// whatever it brings where it belongs.
pub const MIN_SCORE: f64 = -1.0;

/// How each stage works, and when to stop. Seeds are those of the task.
///
/// ```
/// use wisch::run::RunConfig;
/// let config = RunConfig { target: 0.9, max_rounds: 2, ..RunConfig::default() };
/// assert_eq!(config.variants, 1);
/// ```
#[derive(Debug, Clone)]
pub struct RunConfig {
    /// Of the plans.
    pub plan: PlanConfig,
    /// How many candidate plans the prediction chooses from in the first round.
    pub variants: usize,
    /// Of robot and tool.
    pub workcell: WorkcellConfig,
    /// Of the motions.
    pub follow: FollowConfig,
    /// Estimated performance at which the goal is met [1].
    pub target: f64,
    /// Least score of a plan that is executed in the first round, see [`Prediction::score`](crate::plan::Prediction::score) [1].
    pub min_score: f64,
    /// Most rounds.
    pub max_rounds: usize,
    /// How far a round goes.
    pub pace: Pace,
    /// Whether a round ends amid a stroke once touch tells that it brings nothing any more, because contact is lost or the
    /// tool is led away; what is left is planned anew.
    pub end_strokes_early: bool,
    /// What follows where a person or a safety system stopped the robot.
    pub after_stop: AfterStop,
    /// How far any joint may stand from where a motion begins [rad or m].
    pub start_tolerance: f64,
    /// How well the robot sees dirt; `None` for a robot that only feels.
    pub sight: Option<Sight>,
}

impl Default for RunConfig {
    /// One plan by grid, until 95 % are reached or four rounds are over.
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
            start_tolerance: 0.05,
            sight: None,
        }
    }
}
