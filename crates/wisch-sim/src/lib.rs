//! Simulated execution of wiping motions: an [`Executor`](wisch::run::Executor) in place of the
//! real robot; paper §4.1.
//!
//! The robot is a multibody under gravity. The controller of [`wisch::control`] drives torso and arm by torques alone.
//! Position drives hold the base, and arms that do not wipe. The sensors are those of a real robot: joint positions,
//! efforts, and a wrench at the tool that an observer estimates from them. Dirt consists of rigid bodies.
//!
//! [`World`] executes the motions of a [`Session`](wisch::run::Session). Its ground truth is available to evaluations
//! and reports only, through [`World::truth`]. A [`LiveArm`] follows setpoints that another program gives.
//!
//! Without the feature `physics`, which is on by default, the crate has only the [`SimulationSettings`].

#[cfg(feature = "physics")]
mod camera;
#[cfg(feature = "physics")]
mod checkpoint;
#[cfg(feature = "physics")]
mod dirt;
mod disturbance;
#[cfg(feature = "physics")]
mod error;
#[cfg(feature = "physics")]
mod grains;
#[cfg(feature = "physics")]
mod live;
mod mismatch;
#[cfg(feature = "physics")]
mod period;
#[cfg(feature = "physics")]
mod plant;
mod settings;
#[cfg(feature = "physics")]
mod treated;
#[cfg(feature = "physics")]
mod truth;
#[cfg(feature = "physics")]
mod world;

#[cfg(feature = "physics")]
pub use checkpoint::{CheckpointRound, Checkpoints};
#[cfg(feature = "physics")]
pub use dirt::{Dirt, Grain, WorkSurface};
pub use disturbance::{FrictionChange, Moment, Push};
#[cfg(feature = "physics")]
pub use error::SimulationError;
#[cfg(feature = "physics")]
pub use live::LiveArm;
pub use mismatch::Mismatch;
#[cfg(feature = "physics")]
pub use period::execute;
pub use settings::{
    Camera, GrainCount, RealTool, Schedule, Sensing, SimulationSettings, TrueDirt, Waviness,
};
#[cfg(feature = "physics")]
pub use truth::{GroundTruth, Spread};
#[cfg(feature = "physics")]
pub use world::World;
