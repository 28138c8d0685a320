//! Surfaces of meshes in a chart: welded, oriented, smoothed to the scale of a tool, and unrolled as rigidly as possible.

mod atlas;
mod cells;
mod cholesky;
mod error;
mod flatten;
mod locate;
mod part;
mod prepared;
mod quadric;
mod remesh;
mod stretch;
mod surface_sheet;
mod topology;
mod weld;

pub use atlas::{Atlas, AtlasSeam, MAX_CHARTS};
pub use error::SheetError;
pub use part::{MeshSurvey, PartChoice, SIDE_LEAN};
pub use prepared::{MAX_SHEET_TRIANGLES, SheetConfig, TOOL_RADIUS_RANGE};
pub use stretch::SheetStretch;
pub use surface_sheet::{Sheet, SheetFoot, SheetPoint, SheetVertex};
pub use weld::MeshRepairs;
