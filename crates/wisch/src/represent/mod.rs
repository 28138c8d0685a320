//! Task, surface, tool, medium, and dirt as particles, with the one model of what wiping does to them.

mod chords;
mod effect;
mod field;
mod metrics;
mod particles;
mod scene;
mod surface;
mod task;
mod turning;

pub use effect::{Effect, EffectModel, MotionEffect, ToolMotion};
pub use field::ParticleField;
pub use metrics::{GoalState, Performance};
pub use particles::{Fate, MAX_PARTICLES, ParticleDistribution, ParticleError, ParticleTally};
pub use scene::SceneObject;
pub use surface::Surface;
pub use task::{Task, Tool};
/// Temporary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Action { Absorb, Collect, Skim }
#[allow(missing_docs)]
impl Action { pub fn effect(self) -> Effect { if self == Self::Absorb { Effect::Absorb } else { Effect::Push } } }
