//! Grips of the hands that hold a tool.

use crate::geometry::{Point3, Pose, Vector3};
use nalgebra::Unit;

/// Grip of the hand that leads a tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// Pose of the hand in the tool frame: its origin is the hand's outermost point, its z axis points out of the hand.
    pub tool_from_hand: Pose,
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
