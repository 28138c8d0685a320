//! Task, surface, tool, medium, and dirt as particles, with the one model of what wiping does to them.

mod chords;
mod effect;
mod field;
mod particles;
mod surface;
mod turning;

pub use effect::{EffectModel, Interaction, MotionEffect, ToolMotion};
pub use field::ParticleField;
pub use particles::{Fate, MAX_PARTICLES, ParticleDistribution, ParticleError, ParticleTally};
pub use surface::Surface;
