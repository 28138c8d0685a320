//! Compliant control for a robot's driver: the whole-body impedance controller (8), and the observer that
//! estimates external forces from joint torques; paper §4.1.
//!
//! Torso and arm are driven by torques alone. A spring that is commanded into the surface pulls the
//! tool along its line; its force saturates at the force of the task. A person who pushes the robot
//! therefore meets no larger force. The controller does not depend on whether the robot is real or
//! simulated.

mod config;
mod impedance;
mod momentum_observer;
mod motion_controller;
#[cfg(test)]
mod tests;

pub use config::ControlConfig;
pub use impedance::{DesiredPosture, DesiredToolState, ImpedanceController, MeasuredJointState};
pub use momentum_observer::MomentumObserver;
pub use motion_controller::{ControlCommand, MotionController, press_into_surface, tool_load};

use crate::geometry::Vector3;

/// A force with its moment about the tool centre point, in the axes of the world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wrench {
    /// Force \[N\].
    pub force: Vector3,
    /// Moment about the tool centre point \[Nm\].
    pub moment: Vector3,
}
