//! Triangles by their place in a chart, and by their distance in space.

use super::flatten::doubled_area;
use super::topology::Triangles;
use crate::geometry::{Point2, Point3, Vector3};
use nalgebra::Matrix3;
use parry3d_f64::math::Vector;
use parry3d_f64::query::{PointQueryWithLocation, Ray, RayCast};
use parry3d_f64::shape::{TriMesh, TrianglePointLocation};

/// Tolerance of a place on an edge, in barycentric coordinates [1].
const ON_EDGE: f64 = 1e-9;
/// Largest number of triangles that the search for a foot visits.
const MAX_WALK: usize = 64;
/// Largest number of Newton steps in a triangle.
const MAX_NEWTON: usize = 20;

/// Triangle and barycentric coordinates of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Located {
    pub(super) triangle: usize,
    pub(super) weights: [f64; 3],
}

/// Square cells of the chart with the triangles that reach into them.
#[derive(Debug, Clone)]
pub(super) struct ChartGrid {
    low: Point2,
    cell: f64,
    columns: usize,
    /// Ranges of `triangles` by cell, row by row.
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl ChartGrid {
    pub(super) fn new(places: &[Point2], triangles: &[[u32; 3]]) -> Self {
        let nowhere = Point2::new(f64::INFINITY, f64::INFINITY);
        let (low, high) = (places.iter()).fold((nowhere, -nowhere), |(low, high), p| {
            (low.inf(p), high.sup(p))
        });
        let size = high - low;
        // About one triangle in each cell.
        let cell = (size.x * size.y / triangles.len().max(1) as f64)
            .sqrt()
            .max(size.amax() * 1e-4)
            .max(f64::MIN_POSITIVE);
        let [columns, rows] = [size.x, size.y].map(|length| (length / cell) as usize + 1);
        let mut grid = Self {
            low,
            cell,
            columns,
            starts: vec![0; columns * rows + 1],
            triangles: Vec::new(),
        };
        let cells_of = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|i| places[i as usize]);
            let (first, last) = (
                grid.cell_of(a.inf(&b).inf(&c)),
                grid.cell_of(a.sup(&b).sup(&c)),
            );
            (first[1]..=last[1])
                .flat_map(move |row| (first[0]..=last[0]).map(move |column| row * columns + column))
        };
        let mut starts = vec![0u32; columns * rows + 1];
        triangles
            .iter()
            .flat_map(cells_of)
            .for_each(|cell| starts[cell + 1] += 1);
        for i in 0..columns * rows {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut sorted = vec![0; starts[columns * rows] as usize];
        for (t, corners) in (0u32..).zip(triangles) {
            for cell in cells_of(corners) {
                sorted[next[cell] as usize] = t;
                next[cell] += 1;
            }
        }
        grid.starts = starts;
        grid.triangles = sorted;
        grid
    }

    fn cell_of(&self, place: Point2) -> [usize; 2] {
        let rows = (self.starts.len() - 1) / self.columns;
        let at = (place - self.low) / self.cell;
        // Negative and infinite values saturate.
        [
            (at.x as usize).min(self.columns - 1),
            (at.y as usize).min(rows - 1),
        ]
    }

    /// Iterates over the triangles that hold a place, in ascending order.
    pub(super) fn holding<'a>(
        &'a self,
        place: Point2,
        places: &'a [Point2],
        triangles: &'a [[u32; 3]],
    ) -> impl Iterator<Item = Located> + 'a {
        let [column, row] = self.cell_of(place);
        let cell = row * self.columns + column;
        let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
        self.triangles[range].iter().filter_map(move |&t| {
            let weights = weights_at(place, places, triangles[t as usize])?;
            let is_inside = weights.iter().all(|&w| w >= -ON_EDGE);
            is_inside.then_some(Located {
                triangle: t as usize,
                weights,
            })
        })
    }
}

/// Returns the barycentric coordinates of a place in the chart.
fn weights_at(place: Point2, places: &[Point2], triangle: [u32; 3]) -> Option<[f64; 3]> {
    let doubled = doubled_area(places, triangle);
    if doubled == 0.0 {
        return None;
    }
    let [a, b, c] = triangle.map(|i| places[i as usize]);
    let second = (place - a).perp(&(c - a)) / doubled;
    let third = (b - a).perp(&(place - a)) / doubled;
    Some([1.0 - second - third, second, third])
}

/// Triangles with normals at their corners, for feet of perpendiculars.
#[derive(Clone)]
pub(super) struct FootFinder {
    tree: TriMesh,
    neighbours: Vec<[Option<u32>; 3]>,
    /// Sides without a neighbour: triangle and number of the side.
    border: Vec<(u32, u8)>,
}

impl FootFinder {
    pub(super) fn new(surface: &Triangles) -> Option<Self> {
        let vertices = surface
            .vertices
            .iter()
            .map(|p| Vector::new(p.x, p.y, p.z))
            .collect();
        let neighbours = surface.neighbours();
        let sides = (0u32..).zip(&neighbours).flat_map(|(triangle, sides)| {
            let open = (0u8..).zip(sides).filter(|(_, side)| side.is_none());
            open.map(move |(side, _)| (triangle, side))
        });
        Some(Self {
            tree: TriMesh::new(vertices, surface.triangles.clone()).ok()?,
            border: sides.collect(),
            neighbours,
        })
    }

    /// Returns the place of the border that is nearest to a place of the chart; `None` without a border.
    pub(super) fn nearest_on_border(
        &self,
        place: Point2,
        places: &[Point2],
        surface: &Triangles,
    ) -> Option<Located> {
        let mut nearest: Option<(f64, Located)> = None;
        for &(triangle, side) in &self.border {
            let corners = surface.triangles[triangle as usize];
            let (first, second) = (usize::from(side), (usize::from(side) + 1) % 3);
            let [a, b] = [corners[first], corners[second]].map(|i| places[i as usize]);
            let along = b - a;
            let length = along.norm_squared();
            let share = if length > 0.0 {
                ((place - a).dot(&along) / length).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let distance = (place - (a + along * share)).norm_squared();
            if nearest.is_none_or(|(best, _)| distance < best) {
                let mut weights = [0.0; 3];
                weights[first] = 1.0 - share;
                weights[second] = share;
                let triangle = triangle as usize;
                nearest = Some((distance, Located { triangle, weights }));
            }
        }
        nearest.map(|(_, located)| located)
    }

    /// Returns the first point that a line along −z meets from above, by its x and y.
    pub(super) fn find_below(&self, at: Point2, surface: &Triangles) -> Option<Located> {
        let top = self.tree.local_aabb().maxs.z + 1.0;
        let ray = Ray::new(Vector::new(at.x, at.y, top), -Vector::Z);
        let hit = self
            .tree
            .cast_local_ray_and_get_normal(&ray, f64::MAX, true)?;
        let triangle = hit.subshape as usize;
        let point = Point3::new(at.x, at.y, top - hit.time_of_impact);
        let [a, b, c] = surface.corners(surface.triangles[triangle]);
        let normal = (b - a).cross(&(c - a));
        let doubled = normal.norm_squared();
        let second = (point - a).cross(&(c - a)).dot(&normal) / doubled;
        let third = (b - a).cross(&(point - a)).dot(&normal) / doubled;
        (doubled > 0.0).then_some(Located {
            triangle,
            weights: [1.0 - second - third, second, third],
        })
    }

    /// Returns the foot of the perpendicular from a point: where the interpolated normal leads to the point, or the nearest
    /// point of the border.
    pub(super) fn find(&self, point: Point3, surface: &Triangles, normals: &[Vector3]) -> Located {
        let at = Vector::new(point.x, point.y, point.z);
        let (_, (triangle, location)) = self.tree.project_local_point_and_get_location(at, false);
        let weights = match location {
            TrianglePointLocation::OnVertex(i) => {
                let mut weights = [0.0; 3];
                weights[i as usize] = 1.0;
                weights
            }
            TrianglePointLocation::OnEdge(edge, [a, b]) => {
                // parry numbers edges ab, bc, ca.
                let mut weights = [0.0; 3];
                weights[edge as usize] = a;
                weights[(edge as usize + 1) % 3] = b;
                weights
            }
            TrianglePointLocation::OnFace(_, weights) => weights,
            TrianglePointLocation::OnSolid => [1.0 / 3.0; 3],
        };
        let nearest = Located {
            triangle: triangle as usize,
            weights,
        };
        let mut at = nearest;
        for _ in 0..MAX_WALK {
            let Some(weights) = solve_foot(point, surface, normals, at) else {
                return nearest;
            };
            let Some((lowest, _)) = (weights.iter().enumerate())
                .filter(|(_, weight)| **weight < -ON_EDGE)
                .min_by(|one, other| one.1.total_cmp(other.1))
            else {
                return Located { weights, ..at };
            };
            // The side opposite to corner k begins at the next corner.
            let Some(next) = self.neighbours[at.triangle][(lowest + 1) % 3] else {
                return nearest;
            };
            at = Located {
                triangle: next as usize,
                weights: [1.0 / 3.0; 3],
            };
        }
        nearest
    }
}

/// Solves point = X(w) + s N(w) in the plane of a triangle by Newton's method, with X and N linear in the weights w.
fn solve_foot(
    point: Point3,
    surface: &Triangles,
    normals: &[Vector3],
    from: Located,
) -> Option<[f64; 3]> {
    let corners = surface.triangles[from.triangle];
    let [a, b, c] = surface.corners(corners);
    let [na, nb, nc] = corners.map(|i| normals[i as usize]);
    let [_, mut second, mut third] = from.weights;
    let size = (b - a).norm() + (c - a).norm();
    let mut height = 0.0;
    for step in 0..MAX_NEWTON {
        let foot = a + (b - a) * second + (c - a) * third;
        let normal = na + (nb - na) * second + (nc - na) * third;
        if step == 0 {
            height = (point - foot).dot(&normal) / normal.norm_squared();
        }
        let residual = point - (foot + normal * height);
        let columns = [
            (b - a) + (nb - na) * height,
            (c - a) + (nc - na) * height,
            normal,
        ];
        let change = Matrix3::from_columns(&columns).try_inverse()? * residual;
        second += change.x;
        third += change.y;
        height += change.z;
        let size_of_weights = second.abs() + third.abs();
        if size_of_weights.is_nan() || size_of_weights >= 1e3 {
            return None;
        }
        if change.x.abs() + change.y.abs() < 1e-13 && change.z.abs() < 1e-13 * size.max(1.0) {
            break;
        }
    }
    Some([1.0 - second - third, second, third])
}
