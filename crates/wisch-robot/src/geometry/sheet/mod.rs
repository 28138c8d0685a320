//! Surfaces of meshes in a chart: welded, oriented, smoothed to the scale of a tool, and unrolled as rigidly as possible.

mod cells;
mod cholesky;
mod error;
mod flatten;
mod locate;
mod part;
mod quadric;
mod remesh;
mod stretch;
mod surface_sheet;
mod topology;
mod weld;

pub use error::SheetError;
pub use part::{MeshSurvey, PartChoice, SIDE_LEAN};
pub use stretch::SheetStretch;
pub use surface_sheet::{
    MAX_CHARTS, MAX_SHEET_TRIANGLES, Sheet, SheetConfig, SheetFoot, SheetPoint, SheetVertex,
    TOOL_RADIUS_RANGE,
};
pub use weld::MeshRepairs;
