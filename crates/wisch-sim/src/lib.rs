//! A physics world in which wiping motions are executed: an [`Executor`](wisch::run::Executor) that stands in for the
//! real robot; paper §4.1.
//!
//! The robot is a multibody under gravity. Torso and arm are driven by torques alone, by the controller of
//! [`wisch::control`]. The base, and arms that do not wipe, are held by drives of their own. Sensors are those of a
//! real robot: positions, efforts, and a force at the tool that an observer estimates from them. Dirt is real bodies.
//!
//! [`World`] executes the motions of a [`Session`](wisch::run::Session); what it knows to be true has a door of its own,
//! [`World::truth`], for evaluations and reports.

mod camera;
mod checkpoint;
mod dirt;
mod error;
mod grains;
mod mismatch;
mod period;
mod plant;
mod settings;
mod treated;
mod truth;
mod world;

pub use checkpoint::{Checkpoints, KeptRound};
pub use dirt::{Dirt, Grain, GrainCount, Places, Site};
pub use error::SimulationError;
pub use mismatch::Mismatch;
pub use period::execute;
pub use settings::{Camera, RealTool, Schedule, Sensing, SimulationSettings, Waviness};
pub use truth::{GroundTruth, Spread};
pub use world::World;
