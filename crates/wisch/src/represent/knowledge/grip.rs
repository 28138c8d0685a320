//! Where hands hold a tool.

use crate::geometry::{Point3, Pose, Vector3};
use nalgebra::Unit;

/// How the hand that leads a tool holds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// The hand in the tool frame: its origin at the hand's outermost point, its z axis out of the hand.
    pub tool_from_hand: Pose,
}

/// A bar of a tool that a second hand may close round: the hand turns freely about it and may lean on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondGrip {
    /// Where the hand's outermost point is, in the tool frame [m].
    pub point_in_tool: Point3,
    /// Direction of the bar, a unit vector in the tool frame; the hand's y axis goes along it, either way.
    pub axis_in_tool: Unit<Vector3>,
    /// Largest angle between the bar and the hand's y axis [rad].
    pub max_lean: f64,
}
