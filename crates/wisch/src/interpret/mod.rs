//! Inference by touch: from where the tool was and what it felt to what was wiped; paper §4.2, §4.3.

mod belief;
mod outcome;

pub use belief::Belief;
pub use outcome::{
    Diagnosis, Estimate, Event, EventKind, FittedPlane, Interpretation, PathPiece, Touch,
    TouchSample,
};
