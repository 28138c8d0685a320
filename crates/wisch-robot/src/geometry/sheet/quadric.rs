//! Position, normal and bend of a surface at the scale of a tool: a quadric fitted around each vertex.

use super::topology::Triangles;
use crate::geometry::{Point3, Vector3};
use nalgebra::{Matrix3, Matrix6, Vector6};
use rayon::prelude::*;
use std::collections::HashMap;

/// Refinements of the frame in which a quadric is fitted: its z is the normal of the fit before.
const ROUNDS: usize = 3;
/// Least number of points for a quadric, which has 6 coefficients.
const MIN_POINTS: usize = 8;
/// Least cosine between the normals of a sample and of the vertex [1]: beyond it, the surface turns away.
const MIN_COSINE: f64 = 0.2;
/// Ridge on the coefficients of a fit, relative to the sum of weights [1]: it lowers a bend by less than 0.1 %.
const RIDGE: f64 = 1e-6;
/// Largest bend of a fit, times the radius [1]: a tool touches neither such a bulge nor such a hollow.
const MAX_BEND: f64 = 4.0;
/// Largest distance by which a fit moves a vertex, relative to the radius [1].
const MAX_SHIFT: f64 = 0.2;
/// Largest slope of a fit over the normal of the vertex [1].
const MAX_SLOPE: f64 = 1.0;
/// Largest factor by which a chord replaces its projection [1].
const MAX_CHORD: f64 = 1.5;

/// The surface near a vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LocalFit {
    /// Point of the fitted surface.
    pub(super) point: Point3,
    /// Unit normal.
    pub(super) normal: Vector3,
    /// Second fundamental form as a tensor in space \[1/m\], positive where the surface bulges towards the tool.
    pub(super) bend: Matrix3<f64>,
}

/// Weighted points of a surface, with the points to which each is connected.
struct Samples<'a> {
    surface: &'a Triangles,
    weights: Vec<f64>,
    normals: Vec<Vector3>,
    /// Ranges of `links` by vertex.
    starts: Vec<usize>,
    links: Vec<u32>,
    cells: HashMap<[i64; 3], Vec<u32>>,
    cell: f64,
}

/// Fits a quadric to the samples within `radius` \[m\] of each vertex of `surface`; the samples have edges of at most
/// `longest` \[m\].
pub(super) fn fit_vertices(
    surface: &Triangles,
    samples: &Triangles,
    radius: f64,
    longest: f64,
) -> Vec<LocalFit> {
    let samples = Samples::new(samples, longest);
    let normals = vertex_normals(surface);
    let places: Vec<(Point3, Vector3)> = (surface.vertices.iter().copied()).zip(normals).collect();
    let count = samples.surface.vertices.len();
    places
        .par_iter()
        .map_init(
            || vec![false; count],
            |is_known, &(point, normal)| {
                let near = samples.connected_near(point, normal, radius, is_known);
                fit(&samples, &near, point, normal, radius)
            },
        )
        .collect()
}

/// Returns the area-weighted mean normal of each vertex.
pub(super) fn vertex_normals(surface: &Triangles) -> Vec<Vector3> {
    let mut normals = vec![Vector3::zeros(); surface.vertices.len()];
    for &triangle in &surface.triangles {
        let normal = surface.doubled_normal(triangle);
        triangle.iter().for_each(|&i| normals[i as usize] += normal);
    }
    let mean = surface.mean_normal();
    (normals.iter())
        .map(|normal| normal.try_normalize(0.0).unwrap_or(mean))
        .collect()
}

impl<'a> Samples<'a> {
    fn new(surface: &'a Triangles, cell: f64) -> Self {
        let count = surface.vertices.len();
        let mut weights = vec![0.0; count];
        for &triangle in &surface.triangles {
            let area = surface.doubled_normal(triangle).norm();
            triangle
                .iter()
                .for_each(|&i| weights[i as usize] += area / 6.0);
        }
        let mut pairs: Vec<[u32; 2]> = (surface.triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut starts = vec![0; count + 1];
        for [from, _] in &pairs {
            starts[*from as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        for (i, point) in (0u32..).zip(&surface.vertices) {
            cells.entry(cell_of(*point, cell)).or_default().push(i);
        }
        Self {
            normals: vertex_normals(surface),
            surface,
            weights,
            starts,
            links: pairs.into_iter().map(|[_, to]| to).collect(),
            cells,
            cell,
        }
    }

    /// Returns the sample on the same side that is nearest to a point.
    fn nearest(&self, point: Point3, normal: Vector3) -> Option<u32> {
        let [x, y, z] = cell_of(point, self.cell);
        let offsets =
            (-1..=1).flat_map(|i| (-1..=1).flat_map(move |j| (-1..=1).map(move |k| [i, j, k])));
        let near = offsets
            .filter_map(|[i, j, k]| self.cells.get(&[x + i, y + j, z + k]))
            .flatten()
            .filter(|&&i| self.normals[i as usize].dot(&normal) > MIN_COSINE);
        let distance = |i: u32| (self.surface.vertices[i as usize] - point).norm_squared();
        near.copied().min_by(|&one, &other| {
            distance(one)
                .total_cmp(&distance(other))
                .then(one.cmp(&other))
        })
    }

    /// Returns the samples within `radius` of a point that are connected to the one next to it on the same side; needs and
    /// leaves `is_known` false everywhere.
    fn connected_near(
        &self,
        point: Point3,
        normal: Vector3,
        radius: f64,
        is_known: &mut [bool],
    ) -> Vec<u32> {
        let mut near: Vec<u32> = self.nearest(point, normal).into_iter().collect();
        near.iter().for_each(|&i| is_known[i as usize] = true);
        let mut at = 0;
        while let Some(&i) = near.get(at) {
            at += 1;
            for &other in &self.links[self.starts[i as usize]..self.starts[i as usize + 1]] {
                let distance = (self.surface.vertices[other as usize] - point).norm();
                let is_same_side = self.normals[other as usize].dot(&normal) > MIN_COSINE;
                if !is_known[other as usize] && distance < radius && is_same_side {
                    is_known[other as usize] = true;
                    near.push(other);
                }
            }
        }
        near.iter().for_each(|&i| is_known[i as usize] = false);
        near
    }
}

fn cell_of(point: Point3, cell: f64) -> [i64; 3] {
    [point.x, point.y, point.z].map(|c| (c / cell).floor() as i64)
}

/// Fits height = c₀ + c₁x + c₂y + ½c₃x² + c₄xy + ½c₅y² over the tangent plane, by least squares weighted by area and by
/// (1 − (distance/radius)²)².
///
/// x and y are stretched from the projection of a chord to its length, so that a sphere is a quadric exactly.
fn fit(samples: &Samples, near: &[u32], point: Point3, normal: Vector3, radius: f64) -> LocalFit {
    let mut result = LocalFit {
        point,
        normal,
        bend: Matrix3::zeros(),
    };
    if near.len() < MIN_POINTS {
        return result;
    }
    for _ in 0..ROUNDS {
        let [x_axis, y_axis] = tangents(result.normal);
        let (mut matrix, mut right) = (Matrix6::<f64>::zeros(), Vector6::zeros());
        for &i in near {
            let from = (samples.surface.vertices[i as usize] - result.point) / radius;
            let (x, y, z) = (
                from.dot(&x_axis),
                from.dot(&y_axis),
                from.dot(&result.normal),
            );
            let across = x * x + y * y;
            let kernel = 1.0 - from.norm_squared();
            if kernel <= 0.0 {
                continue;
            }
            let chord = if across > 0.0 {
                (1.0 + z * z / across).sqrt().min(MAX_CHORD)
            } else {
                1.0
            };
            let (x, y) = (x * chord, y * chord);
            let row = Vector6::new(1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y);
            let weight = samples.weights[i as usize] * kernel * kernel;
            matrix += row * row.transpose() * weight;
            right += row * (z * weight);
        }
        let scale = matrix[(0, 0)].max(f64::MIN_POSITIVE);
        // If the samples lie on a line or in a corner, the ridge keeps undetermined coefficients
        // small.
        for k in 0..6 {
            matrix[(k, k)] += RIDGE * scale;
        }
        let Some(factor) = matrix.cholesky() else {
            return result;
        };
        let mut c = factor.solve(&right);
        if !c.iter().all(|c| c.is_finite()) {
            return result;
        }
        let bend = [-c[3], -c[4], -c[5]].map(|bend| bend.clamp(-MAX_BEND, MAX_BEND) / radius);
        // Far from the samples, the position on the quadric is meaningless.
        let is_near = (result.point + result.normal * (c[0] * radius) - point).norm()
            <= MAX_SHIFT * radius
            && c[1].hypot(c[2]) <= MAX_SLOPE;
        if !is_near {
            c.fill(0.0);
        }
        result = LocalFit {
            point: result.point + result.normal * (c[0] * radius),
            bend: x_axis * x_axis.transpose() * bend[0]
                + (x_axis * y_axis.transpose() + y_axis * x_axis.transpose()) * bend[1]
                + y_axis * y_axis.transpose() * bend[2],
            normal: (result.normal - x_axis * c[1] - y_axis * c[2]).normalize(),
        };
    }
    result
}

/// Returns two unit vectors across a unit normal, a right-handed frame with it as z.
pub(super) fn tangents(normal: Vector3) -> [Vector3; 2] {
    let x = Vector3::ith(normal.iamin(), 1.0);
    let x = (x - normal * normal.dot(&x)).normalize();
    [x, normal.cross(&x)]
}
