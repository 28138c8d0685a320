//! Charts that are as rigid as possible (Liu et al., *A Local/Global Approach to Mesh Parameterization*, 2008).

use super::cholesky::{Factor, SymmetricMatrix};
use super::topology::Triangles;
use crate::geometry::{Point2, Vector2, Vector3};
use std::collections::BTreeMap;

/// Largest number of rounds of rotating triangles and moving vertices. Developable parts need 2,
/// other parts 60 to 120.
const MAX_ROUNDS: usize = 300;
/// Rounds after which a chart may be abandoned. Later rounds change the stretch of few triangles.
const TRIAL_ROUNDS: usize = 20;
/// Movement at which the rounds end, relative to the longest edge [1].
const MOVEMENT: f64 = 1e-7;
/// Share of the mean diagonal that is added to it [1], so that the matrix can be factorised.
const REGULARISATION: f64 = 1e-12;

/// A triangle in its own plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlatTriangle {
    /// The corners \[m\]: the first at the origin, the second on the x axis.
    pub(super) corners: [Vector2; 3],
    /// Cotangents of the angles at the corners.
    cotangents: [f64; 3],
    pub(super) area: f64,
}

impl FlatTriangle {
    /// Returns the triangle with another weight in the chart.
    pub(super) fn weighted(&self, weight: f64) -> Self {
        Self {
            corners: self.corners,
            cotangents: self.cotangents.map(|cotangent| cotangent * weight),
            area: self.area * weight,
        }
    }
}

/// Returns each triangle in its own plane.
pub(super) fn flat_triangles(surface: &Triangles) -> Vec<FlatTriangle> {
    let flat = |&triangle: &[u32; 3]| {
        let [a, b, c] = surface.corners(triangle);
        let (ab, ac) = (b - a, c - a);
        let length = ab.norm();
        let doubled = ab.cross(&ac).norm();
        let along = ab.try_normalize(0.0).unwrap_or_default();
        let corners = [
            Vector2::zeros(),
            Vector2::new(length, 0.0),
            Vector2::new(ac.dot(&along), doubled / length.max(f64::MIN_POSITIVE)),
        ];
        let longest = length.max(ac.norm()).max((c - b).norm());
        let cotangent = |u: Vector3, v: Vector3| {
            if doubled > 1e-12 * longest * longest {
                u.dot(&v) / doubled
            } else {
                0.0
            }
        };
        FlatTriangle {
            corners,
            cotangents: [
                cotangent(ab, ac),
                cotangent(a - b, c - b),
                cotangent(a - c, b - c),
            ],
            area: 0.5 * doubled,
        }
    };
    surface.triangles.iter().map(flat).collect()
}

/// Returns a place in the chart for each vertex \[m\]: the chart's x points along `x_axis`, a unit
/// vector across the mean normal, and the origin is the centroid of its area. Lengths in the chart
/// are those of the surface as far as possible. The rounds end early if `is_hopeless` holds for the
/// places after [`TRIAL_ROUNDS`].
pub(super) fn flatten(
    surface: &Triangles,
    flat: &[FlatTriangle],
    [x_axis, y_axis]: [Vector3; 2],
    is_hopeless: impl Fn(&[Point2]) -> bool,
) -> Vec<Point2> {
    let projected: Vec<Point2> = (surface.vertices.iter())
        .map(|p| Point2::new(p.coords.dot(&x_axis), p.coords.dot(&y_axis)))
        .collect();
    let is_folded = |places: &[Point2]| {
        let mut triangles = surface.triangles.iter();
        triangles.any(|&triangle| doubled_area(places, triangle) <= 0.0)
    };
    let matrix = laplacian(surface, flat);
    let start = if is_folded(&projected) {
        unfold(surface, flat)
    } else {
        projected.clone()
    };
    let factor = Factor::new(&matrix, &start);
    let mut places = make_rigid(surface, flat, &factor, start, is_hopeless);
    align(surface, flat, &projected, &mut places);
    places
}

/// Returns twice the signed area of a triangle in the chart.
pub(super) fn doubled_area(places: &[Point2], triangle: [u32; 3]) -> f64 {
    let [a, b, c] = triangle.map(|i| places[i as usize]);
    (b - a).perp(&(c - a))
}

/// Returns the cotangent Laplacian.
fn laplacian(surface: &Triangles, flat: &[FlatTriangle]) -> SymmetricMatrix {
    let mut weights: BTreeMap<[u32; 2], f64> = BTreeMap::new();
    for (triangle, flat) in surface.triangles.iter().zip(flat) {
        for k in 0..3 {
            let [i, j] = [(k + 1) % 3, (k + 2) % 3].map(|side| triangle[side]);
            *weights.entry([i.min(j), i.max(j)]).or_default() += flat.cotangents[k];
        }
    }
    let count = surface.vertices.len();
    let mut matrix = SymmetricMatrix {
        diagonal: vec![0.0; count],
        beside: vec![Vec::new(); count],
    };
    for ([i, j], weight) in weights {
        for (from, to) in [(i, j), (j, i)] {
            matrix.diagonal[from as usize] += weight;
            matrix.beside[from as usize].push((to, -weight));
        }
    }
    matrix
        .beside
        .iter_mut()
        .for_each(|beside| beside.sort_by_key(|&(to, _)| to));
    let mean = matrix.diagonal.iter().sum::<f64>() / count.max(1) as f64;
    // Fixes the translation, which is free otherwise, and vertices without weights.
    for diagonal in &mut matrix.diagonal {
        *diagonal += REGULARISATION * mean;
    }
    if let Some(first) = matrix.diagonal.first_mut() {
        *first += mean;
    }
    matrix
}

/// Turns each triangle to the chart, and moves the vertices to fit the turned triangles, until nothing moves or the chart is
/// hopeless.
fn make_rigid(
    surface: &Triangles,
    flat: &[FlatTriangle],
    factor: &Factor,
    mut places: Vec<Point2>,
    is_hopeless: impl Fn(&[Point2]) -> bool,
) -> Vec<Point2> {
    let longest = (surface.triangles.iter())
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[i, j]| (surface.vertices[i as usize] - surface.vertices[j as usize]).norm())
        .fold(0.0, f64::max);
    for round in 0..MAX_ROUNDS {
        if round == TRIAL_ROUNDS && is_hopeless(&places) {
            break;
        }
        let mut right = vec![[0.0; 2]; places.len()];
        for (triangle, flat) in surface.triangles.iter().zip(flat) {
            let corners = triangle.map(|i| places[i as usize]);
            // The rotation nearest to Σ cot · (edge in the chart)(edge of the triangle)ᵀ, in closed form.
            let (mut cosine, mut sine) = (0.0, 0.0);
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let (to, from) = (corners[i] - corners[j], flat.corners[i] - flat.corners[j]);
                cosine += flat.cotangents[k] * from.dot(&to);
                sine += flat.cotangents[k] * from.perp(&to);
            }
            let norm = (cosine * cosine + sine * sine).sqrt();
            let (cosine, sine) = if norm > 0.0 {
                (cosine / norm, sine / norm)
            } else {
                (1.0, 0.0)
            };
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let edge = (flat.corners[i] - flat.corners[j]) * flat.cotangents[k];
                let turned = [
                    cosine * edge.x - sine * edge.y,
                    sine * edge.x + cosine * edge.y,
                ];
                for axis in 0..2 {
                    right[triangle[i] as usize][axis] += turned[axis];
                    right[triangle[j] as usize][axis] -= turned[axis];
                }
            }
        }
        factor.solve(&mut right);
        let count = places.len() as f64;
        let shift = (places.iter().zip(&right)).fold(Vector2::zeros(), |sum, (place, new)| {
            sum + (place - Point2::from(*new)) / count
        });
        let mut moved: f64 = 0.0;
        for (place, new) in places.iter_mut().zip(right) {
            let new = Point2::from(new) + shift;
            moved = moved.max((new - *place).amax());
            *place = new;
        }
        if moved <= MOVEMENT * longest {
            break;
        }
    }
    places
}

/// Lays triangle beside triangle into a plane, breadth first; exact where the surface is developable.
fn unfold(surface: &Triangles, flat: &[FlatTriangle]) -> Vec<Point2> {
    let neighbours = surface.neighbours();
    let mut places: Vec<Option<Point2>> = vec![None; surface.vertices.len()];
    let first = middle_triangle(surface);
    for (i, corner) in surface.triangles[first].iter().zip(flat[first].corners) {
        places[*i as usize] = Some(Point2::from(corner));
    }
    let mut is_placed = vec![false; surface.triangles.len()];
    is_placed[first] = true;
    let (mut open, mut at) = (vec![first as u32], 0);
    while let Some(&t) = open.get(at) {
        at += 1;
        for other in neighbours[t as usize].into_iter().flatten() {
            if std::mem::replace(&mut is_placed[other as usize], true) {
                continue;
            }
            open.push(other);
            let corners = surface.triangles[other as usize];
            let Some(k) = (0..3).find(|&k| places[corners[k] as usize].is_none()) else {
                continue;
            };
            let [from, to] = [(k + 1) % 3, (k + 2) % 3];
            let ends = [from, to].map(|side| places[corners[side] as usize]);
            let [Some(a), Some(b)] = ends else {
                continue;
            };
            // The turn and shift that bring the common edge to its place bring the third corner, too.
            let flat = &flat[other as usize].corners;
            let edge = flat[to] - flat[from];
            let placed = b - a;
            let scale = (edge.norm() * placed.norm()).max(f64::MIN_POSITIVE);
            let (cosine, sine) = (edge.dot(&placed) / scale, edge.perp(&placed) / scale);
            let arm = flat[k] - flat[from];
            places[corners[k] as usize] = Some(Point2::new(
                a.x + cosine * arm.x - sine * arm.y,
                a.y + sine * arm.x + cosine * arm.y,
            ));
        }
    }
    places.into_iter().map(Option::unwrap_or_default).collect()
}

/// Returns the triangle nearest to the centroid of all.
fn middle_triangle(surface: &Triangles) -> usize {
    let centre = |&triangle: &[u32; 3]| {
        let [a, b, c] = surface.corners(triangle);
        (a.coords + b.coords + c.coords) / 3.0
    };
    let (mut sum, mut area) = (Vector3::zeros(), 0.0);
    for triangle in &surface.triangles {
        let weight = surface.doubled_normal(*triangle).norm();
        sum += centre(triangle) * weight;
        area += weight;
    }
    let middle = sum / area.max(f64::MIN_POSITIVE);
    let distances: Vec<f64> = (surface.triangles.iter())
        .map(|triangle| (centre(triangle) - middle).norm())
        .collect();
    (0..distances.len())
        .min_by(|&one, &other| distances[one].total_cmp(&distances[other]))
        .unwrap_or(0)
}

/// Turns the chart to fit the projection, and moves the centroid of its area to the origin.
fn align(surface: &Triangles, flat: &[FlatTriangle], projected: &[Point2], places: &mut [Point2]) {
    let centroid = |places: &[Point2]| {
        let (mut sum, mut area) = (Vector2::zeros(), 0.0);
        for (triangle, flat) in surface.triangles.iter().zip(flat) {
            let [a, b, c] = triangle.map(|i| places[i as usize].coords);
            sum += (a + b + c) * (flat.area / 3.0);
            area += flat.area;
        }
        sum / area.max(f64::MIN_POSITIVE)
    };
    let [from, to] = [centroid(places), centroid(projected)];
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (triangle, flat) in surface.triangles.iter().zip(flat) {
        for i in *triangle {
            let (place, wanted) = (
                places[i as usize].coords - from,
                projected[i as usize].coords - to,
            );
            cosine += flat.area * place.dot(&wanted);
            sine += flat.area * place.perp(&wanted);
        }
    }
    let norm = (cosine * cosine + sine * sine).sqrt();
    let (cosine, sine) = if norm > 0.0 {
        (cosine / norm, sine / norm)
    } else {
        (1.0, 0.0)
    };
    for place in places {
        let p = place.coords - from;
        *place = Point2::new(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y);
    }
}
