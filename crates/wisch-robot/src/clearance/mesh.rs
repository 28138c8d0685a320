//! Conversion of meshes and link shapes into boxes, hulls and surfaces.

use super::super::{Collision, RobotError, Shape};
use super::solid::{Core, Solid, Surface, farthest, vector};
use crate::geometry::{Mesh, Point3, Pose, Vector3};
use nalgebra::{Matrix3, Rotation3, Translation3, UnitQuaternion};
use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::query::details::distance_support_map_support_map as gjk;
use parry3d_f64::shape::{TriMesh, TriMeshFlags};
use std::collections::BTreeSet;

/// Largest number of points of a hull. Of more points, those farthest in this number of directions
/// are kept, and the hull is inflated by the largest distance of a dropped point.
const MAX_HULL_POINTS: usize = 256;

/// Tolerance of a corner against that of a box, relative to the box; for meshes in single precision.
const BOX_TOLERANCE: f64 = 1e-6;

/// Largest distance of a vertex in front of a face of a convex mesh, relative to the mesh.
const CONVEX_TOLERANCE: f64 = 1e-6;

/// Largest product of triangles and vertices up to which convexity is checked.
const MAX_CONVEXITY_TESTS: usize = 100_000_000;

/// A solid with its pose in the frame of its origin.
pub(super) type Placed = (Pose, Solid);

/// Returns the solid of a link's shape. A mesh becomes its convex hull.
pub(super) fn of_shape(collision: &Collision) -> Placed {
    let solid = |half, radius, core| (Pose::identity(), Solid { half, radius, core });
    let (shape_from_solid, solid) = match &collision.shape {
        Shape::Box { size } => solid(size / 2.0, 0.0, Core::Box),
        &Shape::Sphere { radius } => solid(Vector3::zeros(), radius, Core::Segment),
        &Shape::Capsule { radius, length } => {
            solid(Vector3::new(0.0, 0.0, length / 2.0), radius, Core::Segment)
        }
        &Shape::Cylinder { radius, length } => solid(
            Vector3::new(radius, radius, length / 2.0),
            0.0,
            Core::Cylinder,
        ),
        Shape::Mesh(mesh) => hull(mesh),
    };
    (collision.link_from_shape * shape_from_solid, solid)
}

/// Returns the convex hull of a mesh, as a box if it is one.
pub(super) fn hull(mesh: &Mesh) -> Placed {
    let points = distinct(mesh);
    if let Some(found) = as_box(&points) {
        return found;
    }
    let (center, half) = bounds(&points);
    let mut cloud: Vec<Vector> = points.iter().map(|p| vector(&(p - center))).collect();
    let mut radius = 0.0;
    if cloud.len() > MAX_HULL_POINTS {
        (cloud, radius) = reduce(&cloud);
    }
    let core = Core::Hull(cloud.into());
    let mesh_from_solid = Translation3::from(center.coords).into();
    (mesh_from_solid, Solid { half, radius, core })
}

/// Returns a convex mesh as its hull, and any other mesh as a surface.
///
/// # Errors
/// If the collision library rejects the mesh.
pub(super) fn obstacle(name: &str, mesh: &Mesh) -> Result<Placed, RobotError> {
    let is_closed = is_closed(mesh);
    if is_closed && is_convex(mesh) {
        return Ok(hull(mesh));
    }
    let (center, half) = bounds(mesh.vertices());
    let vertices = mesh
        .vertices()
        .iter()
        .map(|p| vector(&(p - center)))
        .collect();
    let inside_out = is_closed && signed_volume(mesh) < 0.0;
    let triangles = mesh.triangles().iter();
    let triangles = triangles.map(|&[a, b, c]| if inside_out { [a, c, b] } else { [a, b, c] });
    let flags = TriMeshFlags::MERGE_DUPLICATE_VERTICES | TriMeshFlags::ORIENTED;
    let mesh = TriMesh::with_flags(vertices, triangles.collect(), flags).map_err(|error| {
        RobotError::Obstacle {
            name: name.to_owned(),
            problem: error.to_string(),
        }
    })?;
    let core = Core::Surface(Surface { mesh, is_closed }.into());
    let mesh_from_solid = Translation3::from(center.coords).into();
    Ok((
        mesh_from_solid,
        Solid {
            half,
            radius: 0.0,
            core,
        },
    ))
}

/// Returns the distinct vertices, sorted by their coordinates.
fn distinct(mesh: &Mesh) -> Vec<Point3> {
    // Adding zero turns −0 into 0.
    let mut points: Vec<[f64; 3]> = mesh
        .vertices()
        .iter()
        .map(|p| [p.x + 0.0, p.y + 0.0, p.z + 0.0])
        .collect();
    points.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    points.dedup();
    points.into_iter().map(Point3::from).collect()
}

/// Returns centre and half extent of the axis-aligned bounding box.
fn bounds(points: &[Point3]) -> (Point3, Vector3) {
    let first = points.first().map_or_else(Vector3::zeros, |p| p.coords);
    let low = points.iter().fold(first, |low, p| low.inf(&p.coords));
    let high = points.iter().fold(first, |high, p| high.sup(&p.coords));
    (Point3::from((low + high) / 2.0), (high - low) / 2.0)
}

/// Returns the box whose eight corners these points are, if there is one.
fn as_box(points: &[Point3]) -> Option<Placed> {
    let [corner, others @ ..] = points else {
        return None;
    };
    if others.len() != 7 {
        return None;
    }
    let from_corner: Vec<Vector3> = others.iter().map(|p| p - corner).collect();
    let diagonal = from_corner
        .iter()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    let tolerance = BOX_TOLERANCE * diagonal.norm();
    for (i, x) in from_corner.iter().enumerate() {
        for (j, y) in from_corner.iter().enumerate().skip(i + 1) {
            let z = diagonal - x - y;
            if !from_corner
                .iter()
                .skip(j + 1)
                .any(|other| (other - z).norm() <= tolerance)
            {
                continue;
            }
            // The axes are made right-handed, and the third orthogonal to the others.
            let (x, y) = if x.cross(y).dot(&z) > 0.0 {
                (x, y)
            } else {
                (y, x)
            };
            let [lengths_x, lengths_y, lengths_z] = [x, y, &z].map(Vector3::norm);
            let first = x.normalize();
            let third = x.cross(y).try_normalize(0.0)?;
            let axes = Matrix3::from_columns(&[first, third.cross(&first), third]);
            let rotation =
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
            let half = Vector3::new(lengths_x, lengths_y, lengths_z) / 2.0;
            let center = corner + diagonal / 2.0;
            let mesh_from_solid = Pose::from_parts(Translation3::from(center.coords), rotation);
            let off = |p: &Point3| {
                let in_box = mesh_from_solid.inverse_transform_point(p).coords.abs();
                (in_box - half).norm()
            };
            let radius = points.iter().map(off).fold(0.0, f64::max);
            if radius <= tolerance {
                return Some((
                    mesh_from_solid,
                    Solid {
                        half,
                        radius,
                        core: Core::Box,
                    },
                ));
            }
        }
    }
    None
}

/// Returns a subset of the points, and the largest distance of a dropped point from its hull [m].
fn reduce(cloud: &[Vector]) -> (Vec<Vector>, f64) {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let count = MAX_HULL_POINTS as f64;
    let direction = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count;
        let (sin, cos) = (golden * i as f64).sin_cos();
        let across = (1.0 - z * z).sqrt();
        Vector::new(across * cos, across * sin, z)
    };
    let mut kept: Vec<Vector> = (0..MAX_HULL_POINTS)
        .map(|i| farthest(cloud, direction(i)))
        .collect();
    kept.sort_by(|a, b| {
        a.to_array()
            .partial_cmp(&b.to_array())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    kept.dedup();
    let solid = |points: Vec<Vector>| Solid {
        half: Vector3::zeros(),
        radius: 0.0,
        core: Core::Hull(points.into()),
    };
    let (hull, point) = (solid(kept.clone()), solid(vec![Vector::ZERO]));
    let outside = |&p: &Vector| gjk(&ParryPose::from_translation(p), &hull, &point);
    let radius = cloud.iter().map(outside).fold(0.0, f64::max);
    (kept, radius)
}

/// Iterates over the triangles' corners by coordinates, so that repeated vertices count as one.
fn corners(mesh: &Mesh) -> impl Iterator<Item = [[u64; 3]; 3]> {
    let key = |i: u32| {
        mesh.vertices()[i as usize]
            .coords
            .map(|x| (x + 0.0).to_bits())
            .into()
    };
    mesh.triangles()
        .iter()
        .map(move |triangle| triangle.map(key))
}

/// Whether every edge belongs to two triangles of consistent orientation.
fn is_closed(mesh: &Mesh) -> bool {
    let mut open = BTreeSet::new();
    for [a, b, c] in corners(mesh) {
        if a == b || b == c || c == a {
            continue;
        }
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if !open.remove(&(to, from)) && !open.insert((from, to)) {
                return false;
            }
        }
    }
    open.is_empty()
}

/// Whether all vertices of a closed mesh lie behind every triangle.
fn is_convex(mesh: &Mesh) -> bool {
    let points = distinct(mesh);
    if points.len().saturating_mul(mesh.triangles().len()) > MAX_CONVEXITY_TESTS {
        return false;
    }
    let tolerance = CONVEX_TOLERANCE * bounds(&points).1.norm();
    let outward = signed_volume(mesh).signum();
    mesh.triangles().iter().all(|&[a, b, c]| {
        let [a, b, c] = [a, b, c].map(|i| mesh.vertices()[i as usize]);
        let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else {
            return true;
        };
        points
            .iter()
            .all(|p| outward * normal.dot(&(p - a)) <= tolerance)
    })
}

/// Volume that a closed mesh encloses [m³]; negative if it is inside out.
fn signed_volume(mesh: &Mesh) -> f64 {
    let center = bounds(mesh.vertices()).0;
    let six_volumes = mesh.triangles().iter().map(|triangle| {
        let [a, b, c] = triangle.map(|i| mesh.vertices()[i as usize] - center);
        a.dot(&b.cross(&c))
    });
    six_volumes.sum::<f64>() / 6.0
}
