//! Frames, poses, polygons, meshes, charts of curved surfaces, and the footprint of a tool's mesh on a surface.

mod disjoint_sets;
mod footprint;
mod mesh;
mod point_grid;
mod polygon;
mod pose;
mod sheet;
mod triangulation;
mod units;

pub use disjoint_sets::DisjointSets;
pub use footprint::{
    FootprintError, MAX_FOOTPRINT_EDGES, MIN_COMPRESSION_DEPTH, RIGID_DEPTH, footprint,
};
pub(crate) use mesh::{MAX_ATTRIBUTES, most_attributes};
pub use mesh::{MAX_COORDINATE, MAX_TRIANGLES, Mesh, MeshError, MeshFormat};
pub use point_grid::PointGrid;
pub use polygon::encloses;
pub use polygon::{Bounds2, Edge, Polygon, Region};
pub use pose::{PlanarPose, Pose, flatten_pose, restore_pose, wrap_angle};
pub use sheet::{
    Atlas, AtlasSeam, MAX_CHARTS, MAX_SHEET_TRIANGLES, MeshRepairs, MeshSurvey, PartChoice,
    SIDE_LEAN, Sheet, SheetConfig, SheetError, SheetFoot, SheetPoint, SheetStretch, SheetVertex,
    TOOL_RADIUS_RANGE,
};
pub use triangulation::prism_below;
pub use units::LikelyUnits;

/// A point in a plane \[m\].
pub type Point2 = nalgebra::Point2<f64>;
/// A vector in a plane \[m\].
pub type Vector2 = nalgebra::Vector2<f64>;
/// A point in space \[m\]; variable names state the frame, as in `point_in_tool`.
pub type Point3 = nalgebra::Point3<f64>;
/// A vector in space, in metres unless stated otherwise; variable names state the frame of its axes.
pub type Vector3 = nalgebra::Vector3<f64>;
