//! Where the objects of a scene stand on the target surface.

use crate::geometry::{Bounds2, Edge, Mesh, Point2, Point3, encloses};

/// Geometry closer to the surface's plane than this counts as part of it [m].
pub const SURFACE_SKIN: f64 = 1e-4;

/// The part of the surface's plane that the solids of a scene cover: per object, its section just
/// above the plane.
///
/// ```
/// use wisch::geometry::{Mesh, Point2, Pose, Vector3};
/// use wisch::represent::OccupiedArea;
/// let cup = Mesh::cylinder(0.04, 0.10, 48)?.transformed(&Pose::translation(0.2, 0.0, 0.05));
/// let occupied = OccupiedArea::of([&cup]);
/// assert!(occupied.contains(Point2::new(0.2, 0.03)));
/// assert!(!occupied.contains(Point2::new(0.2, 0.05)));
/// # Ok::<(), wisch::geometry::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OccupiedArea {
    /// Per object, the outline of its solid in the plane of the surface (unordered edges).
    sections: Vec<Vec<Edge>>,
    /// Of each section the rectangle round it.
    bounds: Vec<Bounds2>,
}

impl OccupiedArea {
    /// The sections of meshes in the surface frame.
    pub fn of<'a>(scene_in_surface: impl IntoIterator<Item = &'a Mesh>) -> Self {
        let sections = scene_in_surface.into_iter().map(section);
        let bounded = sections.filter_map(|edges| {
            let corners = edges.iter().flat_map(|edge| [edge.start, edge.end]);
            let bounds = Bounds2::of(corners)?;
            Some((edges, bounds))
        });
        let (sections, bounds) = bounded.unzip();
        Self { sections, bounds }
    }

    /// Per object that reaches down to the plane, the outline of its section as unordered edges [m].
    pub fn sections(&self) -> &[Vec<Edge>] {
        &self.sections
    }

    /// Whether an object stands on this point (even–odd rule per object).
    pub fn contains(&self, point: Point2) -> bool {
        let mut sections = self.sections.iter().zip(&self.bounds);
        sections
            .any(|(edges, bounds)| bounds.contains(point) && encloses(edges.iter().copied(), point))
    }
}

/// Where a mesh cuts the plane just above the surface.
fn section(mesh: &Mesh) -> Vec<Edge> {
    let cut = |a: Point3, b: Point3| {
        ((a.z > SURFACE_SKIN) != (b.z > SURFACE_SKIN)).then(|| {
            let share = (SURFACE_SKIN - a.z) / (b.z - a.z);
            Point2::new(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))
        })
    };
    mesh.corners()
        .filter_map(|[a, b, c]| {
            let mut cuts = [(a, b), (b, c), (c, a)]
                .into_iter()
                .filter_map(|(p, q)| cut(p, q));
            Some(Edge {
                start: cuts.next()?,
                end: cuts.next()?,
            })
        })
        .collect()
}
