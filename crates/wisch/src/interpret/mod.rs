//! Inference by touch: from the tool's path and its forces to what the tool wiped; paper §4.2, §4.3.
//!
//! ```text
//! contact: samples → pooled samples → bias, f′ (9), confident contacts (10) → plane (11) → contact motions
//! events:  contacts, losses, pushes, stick-slip, phases
//! belief:  uncertain parameters → replays of the contact motions (12) → where the dirt lies
//! ```

mod belief;
mod config;
mod contact;
mod doubt;
mod error;
mod events;
mod fast_turns;
mod interpretation;
mod interpreter;
mod log_evidence;
mod poses_alone;
mod uncertainty;
mod wrench_quality;

pub use belief::{
    Belief, COUNT_SPREAD, DensityMap, DirtPrior, Estimate, Exposure, ObservationUpdate,
    ParticleTouch, PerformanceDistribution,
};
pub use config::{EventConfig, InterpretConfig, PlaneConfig, ToolCompliance, member_count};
pub use contact::{
    ContactLevel, ContactResidual, FittedPlane, PathPiece, PlaneFit, RESIDUAL_CELL, ShapeFit,
    ToolStiffness, Touch, TouchSample, fit_plane, fit_shape,
};
pub use doubt::Doubt;
pub use error::InterpretError;
pub use events::{Event, EventKind};
pub use interpretation::{Diagnosis, Interpretation};
pub use interpreter::{Interpreter, interpret};
pub use uncertainty::Uncertainty;
pub use wrench_quality::{UnusableWrenches, WrenchQuality};
