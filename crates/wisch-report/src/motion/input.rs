//! Input of the figures of a robot's motion.

use wisch::follow::TrajectorySample;
use wisch::geometry::Pose;
use wisch::represent::Task;
use wisch::robot::{LinkId, RobotModel};

/// The motion of a robot with its scene, for figures.
#[derive(Debug, Clone, Copy)]
pub struct MotionInput<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// Pose of its root in the world.
    pub world_from_root: Pose,
    /// Surface, scene and tool.
    pub task: &'a Task,
    /// The robot's link that holds the tool.
    pub tool_link: LinkId,
    /// Pose of the tool in that link's frame.
    pub link_from_tool: Pose,
    /// Positions, velocities and accelerations of all n variables of the robot, by rising time.
    /// Samples of another length, with non-finite values or out of sequence are left out.
    pub samples: &'a [TrajectorySample],
    /// Phases, by rising time.
    pub phases: &'a [ShownPhase],
    /// Base poses in order of time; empty for a fixed base.
    pub placements: &'a [BasePose],
    /// Candidate base poses.
    pub ratings: &'a [CandidateBase],
}

/// A named interval of the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownPhase {
    /// Name of the phase.
    pub name: String,
    /// Start time \[s\].
    pub start: f64,
    /// End time \[s\].
    pub end: f64,
    /// Whether the tool wipes.
    pub contact: ShownContact,
    /// The stroke that is wiped, counted from 0 as in the plan; `None` between strokes.
    pub stroke: Option<usize>,
}

/// Contact of the tool with the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShownContact {
    /// In contact.
    Wiping,
    /// Out of contact.
    Lifted,
}

/// Pose of the robot's base in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasePose {
    /// x in the world \[m\].
    pub x: f64,
    /// y in the world \[m\].
    pub y: f64,
    /// Yaw about the vertical \[rad\].
    pub yaw: f64,
}

/// A candidate position of the base in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CandidateBase {
    /// x in the world \[m\].
    pub x: f64,
    /// y in the world \[m\].
    pub y: f64,
    /// Rating, from 0 to 1.
    pub rating: f64,
    /// Whether an obstacle blocks it.
    pub blocked: bool,
}
