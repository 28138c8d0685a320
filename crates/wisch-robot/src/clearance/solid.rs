//! Solids and their distances.
//!
//! A solid is the set of points within a radius of a core. Segments and boxes have closed forms; for other cores,
//! parry's implementation of the Gilbert, Johnson and Keerthi algorithm computes the distance.

use super::super::frame::Frame;
use crate::geometry::Vector3;
use parry3d_f64::math::{Matrix, Pose as ParryPose, Rotation, Vector};
use parry3d_f64::query::PointQuery;
use parry3d_f64::query::details::distance_support_map_support_map as gjk;
use parry3d_f64::shape::{SupportMap, TriMesh};
use std::sync::Arc;

/// Bounds on the error of the iteration: relative [1], and if a cylinder is involved [m], each with some reserve.
const RELATIVE_ERROR: f64 = 1e-6;
const CYLINDER_ERROR: f64 = 2e-5;

/// All points within `radius` of a core.
#[derive(Debug, Clone)]
pub(super) struct Solid {
    /// Half extents along x, y and z of a box around the core, about the origin of the solid [m].
    pub half: Vector3,
    pub radius: f64,
    pub core: Core,
}

/// A core, in the axes of its box.
#[derive(Debug, Clone)]
pub(super) enum Core {
    /// A segment along z, as long as the box; a point if that is 0 m.
    Segment,
    /// The box itself.
    Box,
    /// A cylinder along z that touches the box.
    Cylinder,
    /// The convex hull of points [m].
    Hull(Arc<[Vector]>),
    /// A mesh that may be concave.
    Surface(Arc<Surface>),
}

/// Triangles, with their interior if they are closed.
#[derive(Debug)]
pub(super) struct Surface {
    pub mesh: TriMesh,
    pub is_closed: bool,
}

/// An axis-aligned box in the world [m].
#[derive(Debug, Clone, Copy)]
pub(super) struct AxisAlignedBox {
    pub low: Vector3,
    pub high: Vector3,
}

impl AxisAlignedBox {
    /// Returns the smallest box around both.
    pub fn merge(self, other: Self) -> Self {
        Self {
            low: self.low.inf(&other.low),
            high: self.high.sup(&other.high),
        }
    }
}

impl Solid {
    /// Radius of the ball about the origin that contains the solid [m].
    pub fn reach(&self) -> f64 {
        self.half.norm() + self.radius
    }

    /// Returns the axis-aligned box around the solid in the world.
    #[inline]
    pub fn bounds(&self, world_from_solid: &Frame) -> AxisAlignedBox {
        let [x, y, z] = &world_from_solid.axes;
        let half = self.half.x * x.abs() + self.half.y * y.abs() + self.half.z * z.abs();
        let half = half.add_scalar(self.radius);
        let middle = world_from_solid.translation;
        AxisAlignedBox {
            low: middle - half,
            high: middle + half,
        }
    }

    /// Returns the ends of a segment.
    #[inline]
    fn ends(&self, world_from_solid: &Frame) -> [Vector3; 2] {
        let along = self.half.z * world_from_solid.axes[2];
        let middle = world_from_solid.translation;
        [middle - along, middle + along]
    }
}

impl SupportMap for Solid {
    fn local_support_point(&self, dir: Vector) -> Vector {
        let half = &self.half;
        let z = half.z.copysign(dir.z);
        match &self.core {
            Core::Segment => Vector::new(0.0, 0.0, z),
            Core::Box => Vector::new(half.x.copysign(dir.x), half.y.copysign(dir.y), z),
            Core::Cylinder => {
                let across = Vector::new(dir.x, dir.y, 0.0);
                across.normalize_or_zero() * half.x + Vector::new(0.0, 0.0, z)
            }
            Core::Hull(points) => farthest(points, dir),
            // A surface is queried triangle by triangle.
            Core::Surface(_) => Vector::ZERO,
        }
    }
}

/// Returns the point farthest along a direction.
pub(super) fn farthest(points: &[Vector], dir: Vector) -> Vector {
    let mut best = (f64::NEG_INFINITY, Vector::ZERO);
    for &point in points {
        let along = point.dot(dir);
        if along > best.0 {
            best = (along, point);
        }
    }
    best.1
}

/// Returns the distance of two solids [m] if it is below `up_to`, and infinity otherwise. If they intersect, the value
/// is at most 0 and a lower bound on the depth.
#[inline]
pub(super) fn distance(
    (a, world_from_a): (&Solid, &Frame),
    (b, world_from_b): (&Solid, &Frame),
    up_to: f64,
) -> f64 {
    let between = world_from_b.translation - world_from_a.translation;
    let far = up_to + a.reach() + b.reach();
    if between.norm_squared() >= far * far {
        return f64::INFINITY;
    }
    let radii = a.radius + b.radius;
    let apart = match (&a.core, &b.core) {
        (Core::Segment, Core::Segment) => {
            segment_segment(a.ends(world_from_a), b.ends(world_from_b)) - radii
        }
        (Core::Segment, _) => {
            round_and_any((a, world_from_a), (b, world_from_b), up_to + radii) - radii
        }
        (_, Core::Segment) => {
            round_and_any((b, world_from_b), (a, world_from_a), up_to + radii) - radii
        }
        _ => any_and_any((a, world_from_a), (b, world_from_b), up_to + radii) - radii,
    };
    if apart < up_to { apart } else { f64::INFINITY }
}

/// Returns the distance between the core of a segment and another core.
fn round_and_any(
    (round, world_from_round): (&Solid, &Frame),
    (other, world_from_other): (&Solid, &Frame),
    up_to: f64,
) -> f64 {
    let in_other = |p: Vector3| world_from_other.turn_back(&(p - world_from_other.translation));
    let to_box = segment_box(round.ends(world_from_round).map(in_other), &other.half);
    if matches!(other.core, Core::Box) || to_box >= up_to {
        return to_box;
    }
    cores((other, world_from_other), (round, world_from_round), up_to)
}

/// Returns the distance between two cores neither of which is a segment.
fn any_and_any(
    (a, world_from_a): (&Solid, &Frame),
    (b, world_from_b): (&Solid, &Frame),
    up_to: f64,
) -> f64 {
    for ((ball, world_from_ball), (other, world_from_other)) in [
        ((a, world_from_a), (b, world_from_b)),
        ((b, world_from_b), (a, world_from_a)),
    ] {
        let center = world_from_ball.translation - world_from_other.translation;
        let apart = outside(&world_from_other.turn_back(&center), &other.half).norm();
        if apart - ball.half.norm() >= up_to {
            return apart - ball.half.norm();
        }
    }
    match (&a.core, &b.core) {
        (_, Core::Surface(_)) => cores((b, world_from_b), (a, world_from_a), up_to),
        _ => cores((a, world_from_a), (b, world_from_b), up_to),
    }
}

/// Returns the distance between two cores, the second of which is convex.
fn cores(
    (a, world_from_a): (&Solid, &Frame),
    (b, world_from_b): (&Solid, &Frame),
    up_to: f64,
) -> f64 {
    let between = world_from_b.translation - world_from_a.translation;
    let translation = vector(&world_from_a.turn_back(&between));
    let axes = world_from_b
        .axes
        .map(|axis| vector(&world_from_a.turn_back(&axis)));
    let rotation = Rotation::from_mat3(&Matrix::from_cols(axes[0], axes[1], axes[2]));
    let a_from_b = ParryPose::from_parts(translation, rotation);
    match &a.core {
        Core::Surface(surface) => surface.distance(b, &a_from_b, up_to),
        _ => gjk(&a_from_b, a, b),
    }
}

impl Surface {
    /// Returns the distance to a convex core; 0 if it is inside.
    fn distance(&self, other: &Solid, self_from_other: &ParryPose, up_to: f64) -> f64 {
        let some_point = self_from_other.transform_point(other.local_support_point(Vector::X));
        if self.is_closed && self.mesh.contains_local_point(some_point) {
            return 0.0;
        }
        let ball = other.half.norm();
        let center = self_from_other.translation;
        let half = vector(&other.half);
        // Half extents, along the axes of the mesh, of the box around the core.
        let axes = self_from_other.rotation * Vector::X * half.x;
        let extent = axes.abs()
            + (self_from_other.rotation * Vector::Y * half.y).abs()
            + (self_from_other.rotation * Vector::Z * half.z).abs();
        let other_from_self = self_from_other.inverse();
        let found = self.mesh.bvh().find_best(
            up_to,
            |node, _| {
                let nearest = center.clamp(node.mins(), node.maxs());
                let to_ball = (center - nearest).length() - ball;
                let to_box = gap(node.mins(), node.maxs(), center - extent, center + extent);
                to_ball.max(lower_bound(to_box)).max(0.0)
            },
            |triangle, best| {
                let triangle = self.mesh.triangle(triangle);
                let corners = [triangle.a, triangle.b, triangle.c];
                let [a, b, c] = corners.map(|corner| other_from_self.transform_point(corner));
                let to_box = gap(a.min(b).min(c), a.max(b).max(c), -half, half);
                // A triangle that is certainly farther away than the nearest one costs no
                // iterations.
                (lower_bound(to_box) < best).then(|| gjk(self_from_other, &triangle, other))
            },
        );
        found.map_or(f64::INFINITY, |(_, distance)| distance)
    }
}

/// Returns the distance between two axis-aligned boxes [m]; 0 if they overlap.
fn gap(low: Vector, high: Vector, other_low: Vector, other_high: Vector) -> f64 {
    (low - other_high)
        .max(other_low - high)
        .max(Vector::ZERO)
        .length()
}

/// Returns a lower bound of the distances that the iteration returns [m], from the distance of
/// boxes around the cores.
fn lower_bound(between_boxes: f64) -> f64 {
    between_boxes * (1.0 - RELATIVE_ERROR) - CYLINDER_ERROR
}

pub(super) fn vector(v: &Vector3) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

/// Returns the vector from the nearest point of a box about the origin to a point; zero inside.
#[inline]
fn outside(point: &Vector3, half: &Vector3) -> Vector3 {
    point.zip_map(half, |x, h| x - x.clamp(-h, h))
}

/// Returns a quotient clamped to [0, 1]; 0 if its divisor is 0.
#[inline]
fn fraction(over: f64, under: f64) -> f64 {
    if under > 0.0 {
        (over / under).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// Returns the distance between two segments [m], either of which may be a point. Ericson 2005, §5.1.9.
#[inline]
pub(super) fn segment_segment([a, a_end]: [Vector3; 2], [b, b_end]: [Vector3; 2]) -> f64 {
    let (u, v, w) = (a_end - a, b_end - b, a - b);
    let (uu, uv, vv) = (u.norm_squared(), u.dot(&v), v.norm_squared());
    // Nearest points on the lines, then on one segment for the other and back. For nearly parallel segments cross
    // products keep their precision, whereas u·u v·v − (u·v)² cancels.
    let across = u.cross(&v);
    let s = fraction(across.dot(&v.cross(&w)), across.norm_squared());
    let t = fraction(uv * s + v.dot(&w), vv);
    let s = fraction(uv * t - u.dot(&w), uu);
    (w + s * u - t * v).norm()
}

/// Returns the distance between a segment and a box about the origin [m]; 0 if they intersect.
///
/// The squared distance is convex along the segment, and its derivative is linear between the planes of the faces. The
/// minimum lies where the derivative changes its sign.
#[inline]
pub(super) fn segment_box([from, to]: [Vector3; 2], half: &Vector3) -> f64 {
    let along = to - from;
    let at = |t: f64| outside(&(from + t * along), half);
    let rate = |t: f64| at(t).dot(&along);
    let (mut low, mut high) = ((0.0, rate(0.0)), (1.0, rate(1.0)));
    if low.1 >= 0.0 {
        return at(0.0).norm();
    }
    if high.1 <= 0.0 {
        return at(1.0).norm();
    }
    for axis in 0..3 {
        for face in [-half[axis], half[axis]] {
            let t = (face - from[axis]) / along[axis];
            if low.0 < t && t < high.0 {
                let rate = rate(t);
                let end = if rate <= 0.0 { &mut low } else { &mut high };
                *end = (t, rate);
            }
        }
    }
    at(low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1)).norm()
}
