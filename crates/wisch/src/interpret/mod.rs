//! Inference by touch: from where the tool was and what it felt to what was wiped; paper §4.2, §4.3.
//!
//! ```text
//! samples → pieces → bias, f′ (9), confident contacts (10) → plane (11) → contact → replays (12) → belief
//!                                                                            └───→ events
//! ```

mod belief;
mod chances;
mod collisions;
mod config;
mod contact;
mod density;
mod doubt;
mod error;
mod events;
mod heap;
mod interpreter;
mod motions;
mod outcome;
mod phases;
mod pieces;
mod plane;
mod replay;
mod stick_slip;
mod uneven;
mod variation;

pub use belief::Belief;
pub use config::{EventConfig, InterpretConfig, ToolCompliance};
pub use density::DensityMap;
pub use error::InterpretError;
pub use interpreter::{Interpreter, interpret};
pub use outcome::{
    Diagnosis, Estimate, Event, EventKind, FittedPlane, Interpretation, PathPiece, Touch,
    TouchSample,
};
pub use plane::{PlaneConfig, PlaneFit, fit_plane};
pub use variation::Uncertainty;
