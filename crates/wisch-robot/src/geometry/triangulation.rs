//! Triangulation of polygons by ear clipping with the `earcut` crate; polygons may be concave and have holes.

use super::{Mesh, MeshError, Point2, Point3, Polygon, Vector3};
use earcut::Earcut;

/// Relative difference between the areas of triangles and polygon from which the polygon counts as self-intersecting
/// [1].
const AREA_TOLERANCE: f64 = 1e-6;
/// Tolerance of a corner that turns the wrong way, over the squared size of the polygon [1]; for single precision.
const TURN_TOLERANCE: f64 = 1e-7;

/// Returns the corners of a polygon, outer ring first, and its triangles, counter-clockwise, as corner indices.
fn triangles_of(polygon: &Polygon) -> (Vec<Point2>, Vec<[u32; 3]>) {
    let corners: Vec<Point2> = polygon.rings().flatten().copied().collect();
    let mut holes = Vec::new();
    let mut count = 0u32;
    for ring in polygon.rings() {
        if count > 0 {
            holes.push(count);
        }
        count += ring.len() as u32;
    }
    let triangles = cut_rings(&corners, &holes);
    (corners, triangles)
}

/// Triangulates rings; `holes` has the index of each hole's first corner.
fn cut_rings(corners: &[Point2], holes: &[u32]) -> Vec<[u32; 3]> {
    let mut indices: Vec<u32> = Vec::new();
    let places = corners.iter().map(|corner| [corner.x, corner.y]);
    Earcut::new().earcut(places, holes, &mut indices);
    let triangles = indices.as_chunks().0.iter();
    triangles
        .map(|&[a, b, c]| {
            let at = |i: u32| corners[i as usize];
            let is_counter_clockwise = (at(b) - at(a)).perp(&(at(c) - at(a))) >= 0.0;
            if is_counter_clockwise {
                [a, b, c]
            } else {
                [a, c, b]
            }
        })
        .collect()
}

/// Returns the prism under a polygon in the plane z = 0, down to `depth` below it \[m\]: a closed mesh.
///
/// # Errors
/// If the polygon has no area.
pub fn prism_below(polygon: &Polygon, depth: f64) -> Result<Mesh, MeshError> {
    let (corners, top) = triangles_of(polygon);
    let count = corners.len() as u32;
    let at_height = |z: f64| {
        corners
            .iter()
            .map(move |corner| Point3::new(corner.x, corner.y, z))
    };
    let vertices = at_height(0.0).chain(at_height(-depth)).collect();
    let mut triangles = top.clone();
    triangles.extend(
        top.iter()
            .map(|&[a, b, c]| [a + count, c + count, b + count]),
    );
    let mut first = 0;
    for ring in polygon.rings() {
        let length = ring.len() as u32;
        for i in 0..length {
            let (a, b) = (first + i, first + (i + 1) % length);
            // The interior lies left of an edge, so the side's outward normal points to its right.
            triangles.extend([[a, a + count, b + count], [a, b + count, b]]);
        }
        first += length;
    }
    Mesh::new(vertices, triangles)
}

/// Returns the triangles of a plane face of a mesh, as corner indices, with the orientation of the face.
///
/// A convex face becomes a fan about its first corner. So does a face that is self-intersecting or has no area, which
/// has no correct triangles.
pub(in crate::geometry) fn cut_face(corners: &[Point3]) -> Vec<[usize; 3]> {
    let fan = || (2..corners.len()).map(|i| [0, i - 1, i]).collect();
    if corners.len() < 4 {
        return fan();
    }
    let next = |i: usize| corners[(i + 1) % corners.len()];
    // Newell's normal: a vector along the normal whose length is twice the area of the face.
    let origin = corners[0];
    let doubled = (0..corners.len()).fold(Vector3::zeros(), |sum, i| {
        sum + (corners[i] - origin).cross(&(next(i) - origin))
    });
    let Some(normal) = doubled.try_normalize(0.0) else {
        return fan();
    };
    let across = Vector3::ith(normal.iamin(), 1.0);
    let x = normal.cross(&across).normalize();
    let y = normal.cross(&x);
    let in_plane: Vec<Point2> = (corners.iter())
        .map(|corner| corner - origin)
        .map(|corner| Point2::new(corner.dot(&x), corner.dot(&y)))
        .collect();
    let size = in_plane.iter().map(|corner| corner.coords.norm_squared());
    let least = -TURN_TOLERANCE * size.fold(0.0, f64::max);
    let turns_left = |i: usize| {
        let [a, b, c] = [i, i + 1, i + 2].map(|i| in_plane[i % in_plane.len()]);
        (b - a).perp(&(c - b)) >= least
    };
    if (0..corners.len()).all(turns_left) {
        return fan();
    }
    let triangles = cut_rings(&in_plane, &[]);
    let area = |&[a, b, c]: &[u32; 3]| {
        let at = |i: u32| in_plane[i as usize];
        (at(b) - at(a)).perp(&(at(c) - at(a)))
    };
    let cut: f64 = triangles.iter().map(area).sum();
    if (cut - doubled.norm()).abs() > AREA_TOLERANCE * doubled.norm() {
        return fan();
    }
    let indices = triangles.iter();
    indices.map(|t| t.map(|i| i as usize)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector2;

    fn area(corners: &[Point3], triangles: &[[usize; 3]]) -> f64 {
        let area = |&[a, b, c]: &[usize; 3]| {
            (corners[b] - corners[a])
                .cross(&(corners[c] - corners[a]))
                .norm()
                / 2.0
        };
        triangles.iter().map(area).sum()
    }

    #[test]
    fn a_concave_face_has_its_area_whichever_corner_it_begins_at_and_however_it_is_turned() {
        // A square of 10 less one of 5.
        let l = [
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 5.0],
            [5.0, 5.0],
            [5.0, 10.0],
            [0.0, 10.0],
        ];
        let tilted = nalgebra::Rotation3::from_euler_angles(0.3, -1.1, 2.0);
        for first in 0..6 {
            for reversed in [false, true] {
                let mut corners: Vec<Point3> = (0..6)
                    .map(|i| l[(first + i) % 6])
                    .map(|[x, y]| tilted * Point3::new(x, y, 3.0))
                    .collect();
                if reversed {
                    corners.reverse();
                }
                let triangles = cut_face(&corners);
                assert_eq!(triangles.len(), 4);
                assert!((area(&corners, &triangles) - 75.0).abs() < 1e-9);
                // They run as the face does.
                let normal = tilted * Vector3::z() * if reversed { -1.0 } else { 1.0 };
                for [a, b, c] in triangles {
                    let [a, b, c] = [a, b, c].map(|i| corners[i]);
                    assert!((b - a).cross(&(c - a)).dot(&normal) > 0.0);
                }
            }
        }
    }

    #[test]
    fn a_prism_under_a_square_with_a_hole_is_closed_and_has_its_volume() {
        let ring = |size: f64| {
            Polygon::rectangle(Vector2::new(size, size))
                .outer()
                .to_vec()
        };
        let prism = prism_below(&Polygon::new(ring(2.0), vec![ring(1.0)]), 0.1).unwrap();
        assert!(prism.is_watertight());
        let six_volumes = prism
            .corners()
            .map(|[a, b, c]| a.coords.dot(&b.coords.cross(&c.coords)));
        assert!((six_volumes.sum::<f64>() / 6.0 - 0.3).abs() < 1e-12);
    }
}
