//! A motion of a robot, as it is to be shown.

use wisch::follow::TrajectorySample;
use wisch::geometry::{Point2, Pose};
use wisch::represent::Task;
use wisch::robot::{LinkId, RobotModel};

/// A motion of a robot that wipes, as it is shown.
#[derive(Debug, Clone, Copy)]
pub struct MotionInput<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// Where its root stands.
    pub world_from_root: Pose,
    /// Surface, scene and tool.
    pub task: &'a Task,
    /// The link that holds the tool, one of the robot's.
    pub tool_link: LinkId,
    /// Where the tool is on it.
    pub link_from_tool: Pose,
    /// Positions, velocities and accelerations of all n variables of the robot, by rising time.
    /// What is of another length, not finite or out of order is left out.
    pub samples: &'a [TrajectorySample],
    /// What is done when, by rising time.
    pub phases: &'a [ShownPhase],
    /// Where the base is placed, in this order; none for a robot that stands still.
    pub placements: &'a [ShownPlacement],
    /// Where the base could have been placed.
    pub ratings: &'a [ShownPlace],
    /// The particles over time, by rising time.
    pub particles: &'a [ParticleFrame],
}

/// A stretch of time with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownPhase {
    /// What is done, for the reader.
    pub name: String,
    /// When it begins [s].
    pub start: f64,
    /// When it ends [s].
    pub end: f64,
    /// Whether the tool wipes.
    pub contact: ShownContact,
    /// The stroke that is wiped, counted from 0 as in the plan; `None` between strokes.
    pub stroke: Option<usize>,
}

/// Whether the tool touches the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShownContact {
    /// It does.
    Wiping,
    /// It does not.
    Lifted,
}

/// Where the robot's base stands, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPlacement {
    /// East of the origin [m].
    pub x: f64,
    /// North of the origin [m].
    pub y: f64,
    /// Turn about the vertical [rad].
    pub yaw: f64,
}

/// A place where the base could stand, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPlace {
    /// East of the origin [m].
    pub x: f64,
    /// North of the origin [m].
    pub y: f64,
    /// How good it is, from 0 to 1.
    pub rating: f64,
    /// Whether something stands in its way.
    pub blocked: bool,
}

/// The particles that remain on the surface at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct ParticleFrame {
    /// When [s].
    pub time: f64,
    /// Where they lie, in the surface frame [m].
    pub positions: Vec<Point2>,
}
