//! Reasons why a mesh gives no chart.

use crate::geometry::Point3;

/// A reason why a mesh is not usable as a surface in one chart. Places are in the frame of the mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SheetError {
    /// A setting is outside its range.
    #[error("{name} = {value} is outside {} to {}", limits[0], limits[1])]
    Setting {
        /// Name of the setting.
        name: &'static str,
        /// Its value, in the unit of its limits.
        value: f64,
        /// Least and largest value.
        limits: [f64; 2],
    },
    /// Every triangle has no area.
    #[error("all {triangles} triangles have no area")]
    NoArea {
        /// Number of triangles.
        triangles: usize,
    },
    /// The part has no border, so the wiped side is not defined.
    #[error(
        "this mesh is closed: {triangles} triangles without a border enclose a body, so it does not state which side is wiped"
    )]
    Closed {
        /// Number of triangles of the part.
        triangles: usize,
    },
    /// No triangle faces the tool.
    #[error("no triangle's normal is within {lean:.2} rad of the direction to the tool")]
    NoSide {
        /// Largest angle of a normal from the direction to the tool \[rad\].
        lean: f64,
    },
    /// The part has only one side, like a Möbius strip.
    #[error(
        "the mesh has no consistent side: following its triangles around leads to the back of {}",
        place(at)
    )]
    NotOrientable {
        /// Where the sides contradict.
        at: Point3,
    },
    /// The part is too large for the scale of the tool.
    #[error(
        "at the scale of a tool of {tool_radius:.4} m radius, the surface needs more than {limit} triangles"
    )]
    TooLarge {
        /// Radius of the tool \[m\].
        tool_radius: f64,
        /// Largest number of triangles.
        limit: usize,
    },
    /// Unrolling stretches the surface too much.
    #[error(
        "unrolling stretches the surface by up to {:.1} % at {}, and by more than {:.0} % on {:.1} % of its area; the limit is 1 % of its area",
        100.0 * stretch, place(at), 100.0 * limit, 100.0 * share
    )]
    Stretched {
        /// Where the stretch is largest.
        at: Point3,
        /// The largest stretch \[1\].
        stretch: f64,
        /// The limit of the stretch \[1\].
        limit: f64,
        /// Share of the area beyond the limit \[1\].
        share: f64,
    },
    /// Unrolling folds the surface.
    #[error(
        "unrolling folds the surface: triangles lie upside down in the chart, the first of {triangles} at {}",
        place(at)
    )]
    Folded {
        /// Number of the triangles that lie upside down.
        triangles: usize,
        /// The first of them.
        at: Point3,
    },
    /// Two places of the surface come to lie on the same place of the chart.
    #[error(
        "unrolled, the surface covers itself: {} and another place lie on the same place of the chart",
        place(at)
    )]
    Overlapping {
        /// One of the places.
        at: Point3,
    },
}

/// Formats a place [m].
fn place(at: &Point3) -> String {
    format!("({:.3}, {:.3}, {:.3}) m", at.x, at.y, at.z)
}
