//! What a robot's driver needs to wipe compliantly: the whole-body impedance controller (8) and the observer that tells
//! external forces from joint torques; paper §4.1.
//!
//! Torso and arm are driven by torques alone. The controller pulls the tool along its line with a spring that is
//! commanded into the surface and saturated at the force of the task, so that whoever pushes the robot meets no more
//! than that. Nothing here knows whether the robot is real.

mod config;
mod impedance;
mod momentum_observer;
mod motion_controller;
#[cfg(test)]
mod tests;

pub use config::ControlConfig;
pub use impedance::{Desired, ImpedanceController, Measured, Posture};
pub use momentum_observer::MomentumObserver;
pub use motion_controller::{ControlCommand, MotionController, pressed_in, tool_load};

use crate::geometry::Vector3;

/// A force with its moment about the tool centre point, in the axes of the world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wrench {
    /// Force [N].
    pub force: Vector3,
    /// Moment about the tool centre point [Nm].
    pub moment: Vector3,
}
