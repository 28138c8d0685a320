//! Simulated execution of wiping motions: an [`Executor`](wisch::run::Executor) that stands in for the real robot;
//! paper §4.1.
//!
//! The robot is a multibody under gravity. The controller of [`wisch::control`] drives torso and arm by torques alone.
//! Position drives hold the base, and arms that do not wipe. The sensors are those of a real robot: joint positions,
//! efforts, and a wrench at the tool that an observer estimates from them. Dirt consists of rigid bodies.
//!
//! [`World`] executes the motions of a [`Session`](wisch::run::Session). Its ground truth is available to evaluations
//! and reports only, through [`World::truth`].

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

pub use checkpoint::{CheckpointRound, Checkpoints};
pub use dirt::{Dirt, Grain, GrainCount, WorkSurface};
pub use error::SimulationError;
pub use mismatch::Mismatch;
pub use period::execute;
pub use settings::{Camera, RealTool, Schedule, Sensing, SimulationSettings, Waviness};
pub use truth::{GroundTruth, Spread};
pub use wisch_io::TrueDirt;
pub use world::World;
