//! Contact of the tool with the surface: places, forces and the plane of the contacts; (9) to (11).

mod bias_change;
mod classification;
mod clock;
mod compression;
mod curvature;
mod downsampling;
mod force_reading;
mod levels;
mod motions;
mod path;
mod plane;
mod pressure_distribution;
mod registration;
mod residuals;
mod sensor;
mod stiffness;
mod tool_on_bend;
mod weighted;

pub(super) use classification::{ClassifiedPath, ContactClassifier, middle};
pub(super) use compression::{STIFFEST, find_stiffness};
pub(super) use curvature::{ContactShape, is_inland};
pub(super) use downsampling::{Downsampler, MeasuredPiece};
pub(super) use force_reading::{ForceReading, PressDirection};
pub use levels::ContactLevel;
pub(super) use levels::{ContactLevels, MOST_LEVELS};
pub(super) use motions::{ContactMotion, MAX_LENGTH, NormalizedForce, contact_motions};
pub use path::{FittedPlane, PathPiece, Touch, TouchSample};
pub use plane::{PlaneFit, fit_plane};
pub(super) use pressure_distribution::PressureDistribution;
pub use registration::{ShapeFit, fit_shape};
pub use residuals::{ContactResidual, RESIDUAL_CELL};
pub use stiffness::ToolStiffness;
pub(super) use stiffness::{MeasuredStiffness, StiffnessBelief};
pub(super) use tool_on_bend::ToolOnBend;
pub(super) use weighted::median;
