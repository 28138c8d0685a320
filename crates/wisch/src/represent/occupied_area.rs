//! Area of the target surface that the objects of a scene occupy.

use crate::geometry::{Bounds2, Edge, Mesh, Point2, Point3, encloses};

/// Distance from the surface's plane below which geometry counts as part of it \[m\].
pub const SURFACE_SKIN: f64 = 1e-4;

/// The part of the surface's plane that the solids of a scene cover. Each object contributes its section just above the
/// plane.
///
/// ```
/// use wisch::geometry::{Mesh, Point2, Pose, Vector3};
/// use wisch::represent::OccupiedArea;
/// let cup = Mesh::cylinder(0.04, 0.10, 48)?.transform(&Pose::translation(0.2, 0.0, 0.05));
/// let occupied = OccupiedArea::from_scene([&cup]);
/// assert!(occupied.contains(Point2::new(0.2, 0.03)));
/// assert!(!occupied.contains(Point2::new(0.2, 0.05)));
/// # Ok::<(), wisch::geometry::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OccupiedArea {
    /// Outline of each object's section in the plane of the surface, as unordered edges.
    sections: Vec<Vec<Edge>>,
    /// Bounding box of each section.
    bounds: Vec<Bounds2>,
}

impl OccupiedArea {
    /// Cuts meshes, given in the surface frame, just above the plane.
    pub fn from_scene<'a>(scene_in_surface: impl IntoIterator<Item = &'a Mesh>) -> Self {
        let sections = scene_in_surface.into_iter().map(section);
        let bounded = sections.filter_map(|edges| {
            let corners = edges.iter().flat_map(|edge| [edge.start, edge.end]);
            let bounds = Bounds2::from_points(corners)?;
            Some((edges, bounds))
        });
        let (sections, bounds) = bounded.unzip();
        Self { sections, bounds }
    }

    /// Outline of the section of each object that reaches the plane, as unordered edges \[m\].
    pub fn sections(&self) -> &[Vec<Edge>] {
        &self.sections
    }

    /// Whether an object covers a point (even–odd rule per object).
    pub fn contains(&self, point: Point2) -> bool {
        let mut sections = self.sections.iter().zip(&self.bounds);
        sections
            .any(|(edges, bounds)| bounds.contains(point) && encloses(edges.iter().copied(), point))
    }
}

/// Returns the section of a mesh just above the plane of the surface.
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
