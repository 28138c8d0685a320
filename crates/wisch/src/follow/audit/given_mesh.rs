//! Distance and lean of a pressed tool against the mesh of its surface as it was given, never against its chart.

use super::kinematics::Frame;
use crate::follow::FollowConfig;
use crate::geometry::{Bounds2, Point2, Point3, Vector2, Vector3};
use crate::represent::{SurfaceShape, Task};
use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQueryWithLocation;
use parry3d_f64::shape::TriMesh;

/// Number of points along each side of the footprint under which normals are taken.
const POINTS: usize = 9;
/// Largest angle between the tool's axis and the mean normal of the mesh under the tool [rad]:
/// 4.6°. Over creases, the smoothed normal of the chart differs from that of the mesh by 4°.
const MAX_LEAN: f64 = 0.08;
/// Allowed distance of the tool centre point from the mesh, besides what smoothing moved [m].
const DISTANCE_TOLERANCE: f64 = 1e-3;

/// How a pressed tool lies on a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OffMesh {
    /// Distance of the tool centre point from the mesh [m].
    pub distance: f64,
    /// Angle between the tool's axis and the mean normal under the tool [rad].
    pub lean: f64,
}

impl OffMesh {
    /// Whether this deviation is worse than another one.
    pub fn exceeds(&self, other: &Self) -> bool {
        self.distance / DISTANCE_TOLERANCE + self.lean / MAX_LEAN
            > other.distance / DISTANCE_TOLERANCE + other.lean / MAX_LEAN
    }
}

/// The mesh of a surface, in the surface's frame.
pub(super) struct GivenMesh {
    mesh: TriMesh,
    normals: Vec<Vector3>,
    /// Points of the footprint in the frame of the tool.
    points: Vec<Point3>,
    largest_distance: f64,
    /// Whether the tool is upright: it has no freedom to lean.
    is_upright: bool,
}

impl GivenMesh {
    /// Returns the mesh of a task's surface; `None` if it has none.
    pub fn new(task: &Task, config: &FollowConfig) -> Option<Self> {
        let SurfaceShape::Mesh(shape) = &task.surface.shape else {
            return None;
        };
        let given = shape.mesh();
        let vertices = given.vertices().iter().map(|p| Vector::new(p.x, p.y, p.z));
        let corner = |i: u32| given.vertices()[i as usize];
        let normals = given.triangles().iter().map(|&[a, b, c]| {
            let normal = (corner(b) - corner(a)).cross(&(corner(c) - corner(a)));
            normal.try_normalize(0.0).unwrap_or_else(Vector3::zeros)
        });
        let footprint = &task.tool.footprint;
        let Bounds2 { min, max } = footprint.bounds()?;
        let share = |i: usize| (i as f64 + 0.5) / POINTS as f64;
        let places = (0..POINTS * POINTS).map(|i| {
            let share = Vector2::new(share(i % POINTS), share(i / POINTS));
            min + (max - min).component_mul(&share)
        });
        let touched = places.filter(|place: &Point2| footprint.contains(*place));
        let gap = task.interaction.gap_m;
        Some(Self {
            mesh: TriMesh::new(vertices.collect(), given.triangles().to_vec()).ok()?,
            normals: normals.collect(),
            points: touched
                .map(|place| Point3::new(place.x, place.y, 0.0))
                .collect(),
            largest_distance: gap
                + DISTANCE_TOLERANCE
                + config.line_tolerance
                + shape.sheet().smoothed_by(),
            is_upright: task.tool.tilt.is_none(),
        })
    }

    /// Returns how a tool lies on the mesh. `is_beyond`: whether the tool centre point is beyond
    /// the border of the surface.
    pub fn measure(&self, surface_from_tool: &Frame, is_beyond: bool) -> OffMesh {
        let axis: Vector3 = surface_from_tool.rotation.column(2).into_owned();
        let nearest = |point: Vector3| {
            let at = Vector::new(point.x, point.y, point.z);
            let (found, (triangle, _)) = self.mesh.project_local_point_and_get_location(at, false);
            (found.point.distance(at), triangle as usize)
        };
        // Normals are taken on the tool's side of the mesh, for either orientation of the triangles
        // in the file.
        let mean = self.points.iter().fold(Vector3::zeros(), |sum, point| {
            let normal = self.normals[nearest(surface_from_tool.point(point)).1];
            sum + normal * normal.dot(&axis).signum()
        });
        let lean = if self.is_upright {
            mean.cross(&axis).norm().atan2(mean.dot(&axis))
        } else {
            0.0
        };
        let (distance, triangle) = nearest(surface_from_tool.origin);
        // Beyond the border, the height over the nearest triangle's plane counts.
        let distance = if is_beyond {
            let normal = self.normals[triangle];
            let corner = self.mesh.triangle(triangle as u32).a;
            let corner = Vector3::new(corner.x, corner.y, corner.z);
            (surface_from_tool.origin - corner).dot(&normal).abs()
        } else {
            distance
        };
        OffMesh { distance, lean }
    }

    /// Whether a tool lies farther off or leans more than allowed.
    pub fn exceeds(&self, off: &OffMesh) -> bool {
        off.distance > self.largest_distance || off.lean > MAX_LEAN
    }
}
