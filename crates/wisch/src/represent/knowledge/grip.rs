//! Grips of the hands that hold a tool.

use crate::geometry::{Point3, Pose, Vector3};
use crate::robot::LinkAxis;
use nalgebra::Unit;

/// Grip of the hand that leads a tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// Pose of the hand in the tool frame: its origin is the hand's outermost point, its z axis points out of the hand.
    pub tool_from_hand: Pose,
}

/// How the link at the end of an arm holds a tool.
///
/// The *hand* is a frame whose z axis is the link's axis that points out of it, usually z. It is at the outermost point, along
/// that axis, of the shapes of the link and of all links that it carries, such as a gripper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mount {
    /// The middle of the tool's upper face lies square on the flange: the tool's z axis points against the link's.
    Flange {
        /// Rotation of the tool about its own z axis \[rad\]; at 0 its x axis is the hand's.
        yaw: f64,
        /// Distance of the tool's upper face from the link's origin, along that axis \[m\]; `None` is the hand.
        distance: Option<f64>,
        /// Radius of the straight holder between flange and tool at a declared distance \[m\]; `None` assumes it.
        holder_radius: Option<f64>,
        /// The link's axis that points out of the flange; `None` takes that of the robot's SRDF, else z.
        axis: Option<LinkAxis>,
    },
    /// The hand holds the rear edge of the tool's upper face and leans back, like the hand of a
    /// humanoid, which is as thick as the tool is wide.
    Hand {
        /// Angle between the hand's z axis and the tool's, against the tool's motion \[rad\].
        lean: f64,
    },
    /// The hand is at a grip of the tool.
    Grip(Grip),
}

impl Mount {
    /// Square on the flange or gripper.
    pub const SQUARE: Self = Self::Flange {
        yaw: 0.0,
        distance: None,
        holder_radius: None,
        axis: None,
    };
}

/// A bar of a tool for a second hand, which may turn freely about it and lean on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondGrip {
    /// Place of the hand's outermost point, in the tool frame \[m\].
    pub point_in_tool: Point3,
    /// Direction of the bar, a unit vector in the tool frame; the hand's y axis is along it, in either direction.
    pub axis_in_tool: Unit<Vector3>,
    /// Largest angle between the bar and the hand's y axis \[rad\].
    pub max_lean: f64,
}
