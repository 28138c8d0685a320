//! Compliant execution of joint motion in a physics world that stands in for the real robot; paper §4.1.
//!
//! The robot is a multibody under gravity. Torso and arm are driven by torques alone: a whole-body
//! impedance controller (8) pulls the tool along its line with a spring that is commanded into the
//! surface and saturated at the force of the task, so that whoever pushes the robot meets no more than
//! that. The base, and arms that do not wipe, are held by drives of their own. Sensors are those of a
//! real robot: positions, efforts, and a force at the tool that an observer estimates from them.

mod config;
mod controller;
mod dirt;
mod error;
mod grains;
mod observer;
mod outcome;
mod plant;
mod session;
mod telemetry;
#[cfg(test)]
mod tests;
mod truth;

pub use config::ExecuteConfig;
pub use dirt::{Dirt, Grain};
pub use error::ExecuteError;
pub use outcome::{Ending, Executed, StopCause};
pub use session::execute;
pub use telemetry::{TelemetrySample, Wrench};
pub use truth::{GroundTruth, Spread};
