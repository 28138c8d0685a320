//! Why a plan cannot be followed at all. What is merely out of reach is part of the outcome.

use super::TimingError;
use crate::geometry::MeshError;
use crate::robot::RobotError;
use crate::source_location::UnknownName;

/// Why a plan cannot be followed at all.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FollowError {
    /// The robot cannot be used.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A joint path cannot be timed.
    #[error("timing: {0}")]
    Timing(#[from] TimingError),
    /// A group that the SRDF does not have.
    #[error("{0}")]
    UnknownGroup(Box<UnknownName>),
    /// The group's base is moved by joints that are no planar base.
    #[error(
        "link {link:?}, the base of the group, is moved by {}; a base is fixed, or moves by a prismatic x, a prismatic y and a revolute z",
        joints.join(", ")
    )]
    NoPlanarBase {
        /// The base of the group.
        link: String,
        /// The joints that move it.
        joints: Vec<String>,
    },
    /// A robot that moves over its floor is placed off it.
    #[error(
        "robot: {what} is {value}, but this robot moves over the floor: only x, y and yaw are free"
    )]
    OffFloor {
        /// The coordinate.
        what: &'static str,
        /// Its value [m or rad].
        value: f64,
    },
    /// The robot touches something before it has moved.
    #[error(
        "the robot cannot start: in its ready posture {a:?} comes within {distance:.4} m of {b:?}, the limit is {limit} m"
    )]
    StartBlocked {
        /// One body.
        a: String,
        /// The other.
        b: String,
        /// Their distance [m]; negative inside.
        distance: f64,
        /// The clearance asked for [m].
        limit: f64,
    },
    /// The robot's ready posture is outside its limits.
    #[error("the robot cannot start: {0}")]
    StartOutOfLimits(crate::robot::LimitFault),
    /// There is no way from where the robot was stopped to its ready posture.
    #[error(
        "no way back from where the robot was stopped to its ready posture{}",
        because(why)
    )]
    NoRetreat {
        /// What is in the way of lifting the tool off the surface; `None` where it is the way after that.
        why: Option<super::Obstruction>,
    },
    /// A second hand is to hold a tool that has no grip for it.
    #[error("tool {tool:?} has no second_grip that the group {group:?} could hold")]
    NoSecondGrip {
        /// The tool.
        tool: String,
        /// The group of the second hand.
        group: String,
    },
    /// The second hand is on the arm that leads.
    #[error("{link:?} moves with the arm that leads the tool: it is no second hand")]
    NoSecondArm {
        /// The hand.
        link: String,
    },
    /// The second arm is moved by a joint of the one that leads.
    #[error("the second arm, to {link:?}, is moved by {joint:?}, which moves the leading arm too")]
    SharedJoint {
        /// The second hand.
        link: String,
        /// The joint.
        joint: String,
    },
    /// The second hand does not reach the tool in the ready posture.
    #[error("{link:?} cannot hold the tool in the ready posture: {why}")]
    NoSecondHold {
        /// The second hand.
        link: String,
        /// What keeps it.
        why: super::Obstruction,
    },
    /// The hand is below the surface wherever the tool touches it.
    #[error(
        "{link:?} would be {depth:.3} m below the surface {surface:?} wherever {tool:?} touches it: the tool is taken to be held at the end of {tip:?}; name the link that holds it, as the tip of the SRDF's group, or give the tool a grip"
    )]
    HandBelowSurface {
        /// The link of the hand.
        link: String,
        /// How far it reaches below the tool's contact plane [m].
        depth: f64,
        /// The surface.
        surface: String,
        /// The tool.
        tool: String,
        /// The link that the tool is taken to be held by.
        tip: String,
    },
    /// The target surface cannot be used as an obstacle.
    #[error("surface: {0}")]
    Surface(#[source] MeshError),
    /// The tool's mesh cannot be used.
    #[error("tool: {0}")]
    Tool(#[source] MeshError),
    /// A number of the configuration that makes no sense.
    #[error("{name} is {value}, expected {expected}")]
    Config {
        /// The field.
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
}

fn because(why: &Option<super::Obstruction>) -> String {
    why.as_ref()
        .map_or_else(String::new, |why| format!(": {why}"))
}
