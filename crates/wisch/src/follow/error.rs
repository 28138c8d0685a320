//! Reasons why a plan cannot be followed at all. Nodes out of reach are no error but part of the result.

use super::TimingError;
use crate::digits::format_beside_limit;
use crate::geometry::MeshError;
use crate::robot::RobotError;
use crate::source_location::UnknownName;

/// The reason why a plan cannot be followed at all.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FollowError {
    /// The robot model cannot be used.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A joint path cannot be timed.
    #[error("timing: {0}")]
    Timing(#[from] TimingError),
    /// The SRDF does not have the group.
    #[error("{0}")]
    UnknownGroup(Box<UnknownName>),
    /// The pose of a robot that moves over the floor is off the floor.
    #[error(
        "robot: {what} is {value}, but this robot moves over the floor; only x, y and yaw are free"
    )]
    OffFloor {
        /// Name of the coordinate.
        what: &'static str,
        /// Its value [m or rad].
        value: f64,
    },
    /// The robot is in collision before it has moved.
    #[error(
        "the robot cannot start: in its ready posture {a:?} is too close to {b:?}: clearance {} m, expected at least {limit} m; move the robot or the scene, or change the ready posture",
        format_beside_limit(*limit, *distance, 4)
    )]
    StartBlocked {
        /// First body.
        a: String,
        /// Second body.
        b: String,
        /// Distance between them \[m\]; negative if they penetrate.
        distance: f64,
        /// Required clearance \[m\].
        limit: f64,
    },
    /// The lifted tool would be too close to the surface to move.
    #[error(
        "plan.lift_height_m is {lift} m, but must exceed {} m: the tool is pressed in by {pressed} m, and keeps {margin} m from obstacles when lifted",
        round_to_micrometres(pressed + margin)
    )]
    LowLift {
        /// Height of lifts \[m\].
        lift: f64,
        /// Depth by which the surface compresses the tool \[m\].
        pressed: f64,
        /// Required clearance \[m\].
        margin: f64,
    },
    /// The robot's ready posture is outside its limits.
    #[error("the robot cannot start: {0}")]
    StartOutOfLimits(crate::robot::LimitFault),
    /// A joint is too slow for a motion.
    #[error(
        "joint {joint:?} needs {duration:.0} s for one motion at its {quantity} limit of {limit} {unit}, more than the {} s that a motion may last at the joints' limits; correct the limit in the URDF",
        super::schedule::MAX_DURATION
    )]
    TooSlow {
        /// Name of the joint.
        joint: String,
        /// `velocity` or `acceleration`.
        quantity: &'static str,
        /// The limit [rad/s, m/s, rad/s² or m/s²].
        limit: f64,
        /// Its unit.
        unit: String,
        /// Least duration of the motion \[s\].
        duration: f64,
    },
    /// No path was found from where the robot was stopped to its ready posture.
    #[error(
        "no path was found from where the robot was stopped to its ready posture{}",
        reason_suffix(why)
    )]
    NoRetreat {
        /// The obstruction that prevents lifting the tool off the surface; `None` if the motion after the lift
        /// fails.
        why: Option<super::Obstruction>,
    },
    /// The tool has no grip for a second hand.
    #[error("tool {tool:?} has no second_grip that the group {group:?} could hold")]
    NoSecondGrip {
        /// Name of the tool.
        tool: String,
        /// Group of the second hand.
        group: String,
    },
    /// The second hand is part of the leading arm.
    #[error(
        "{link:?} moves with the arm that leads the tool, so it cannot be the second hand; choose a group of another arm"
    )]
    NoSecondArm {
        /// Link of the hand.
        link: String,
    },
    /// A joint moves both the leading and the second arm.
    #[error(
        "the second arm, to {link:?}, shares the joint {joint:?} with the leading arm; choose a group without it"
    )]
    SharedJoint {
        /// Link of the second hand.
        link: String,
        /// Name of the joint.
        joint: String,
    },
    /// The second hand does not reach its grip on the tool in the ready posture.
    #[error("{link:?} cannot hold the tool in the ready posture: {why}")]
    NoSecondHold {
        /// Link of the second hand.
        link: String,
        /// The obstruction.
        why: super::Obstruction,
    },
    /// The hand is below the surface at every node where the tool touches it.
    #[error(
        "{link:?} would be {depth:.3} m below the surface {surface:?} at every node of the plan, because {tool:?} is held at the end of {tip:?}; name the link that holds it, as the tip of the SRDF's group, or give the tool a grip"
    )]
    HandBelowSurface {
        /// Link of the hand.
        link: String,
        /// Depth below the tool's contact plane \[m\].
        depth: f64,
        /// Name of the surface.
        surface: String,
        /// Name of the tool.
        tool: String,
        /// The link that holds the tool.
        tip: String,
    },
    /// A collision mesh of the hand cannot be read, so that nobody knows where the hand ends.
    #[error(
        "the tool is held at the outermost point of the hand, which is unknown, because the collision mesh of {link:?} cannot be read ({why}); provide the mesh, for example with [robot] packages, or declare the distance of the tool from the flange: [tool.mount] on = \"flange\" and distance_m"
    )]
    UnknownHand {
        /// Name of the link.
        link: String,
        /// Why its mesh cannot be read.
        why: String,
    },
    /// The target surface cannot serve as an obstacle.
    #[error("surface: {0}")]
    Surface(#[source] MeshError),
    /// The tool's mesh cannot be used.
    #[error("tool: {0}")]
    Tool(#[source] MeshError),
    /// A number of the configuration is out of range.
    #[error("{name} is {value}, expected {expected}")]
    Config {
        /// Name of the field.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The values allowed.
        expected: &'static str,
    },
}

fn reason_suffix(why: &Option<super::Obstruction>) -> String {
    why.as_ref()
        .map_or_else(String::new, |why| format!(": {why}"))
}

fn round_to_micrometres(length: f64) -> f64 {
    (length * 1e6).round() / 1e6
}
