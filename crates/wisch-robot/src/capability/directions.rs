//! A fixed grid of directions on the sphere, with linear interpolation between them.

use crate::geometry::Vector3;
use nalgebra::Matrix3;

/// Range of the number of parts into which the edges of the icosahedron are cut.
pub(super) const FREQUENCIES: std::ops::RangeInclusive<usize> = 1..=32;

/// Nearly uniform directions: the 10 frequency² + 2 nodes of an icosahedron whose edges are cut into `frequency` parts,
/// and each face thus into frequency² flat triangles.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Directions {
    frequency: usize,
    nodes: Vec<Vector3>,
    /// Solid angle of each node, as a share of the sphere.
    shares: Vec<f64>,
    /// Nodes that share an edge with each node: five or six.
    neighbours: Vec<Vec<usize>>,
    faces: Vec<Face>,
}

/// A face of the icosahedron.
#[derive(Debug, Clone, PartialEq)]
struct Face {
    center: Vector3,
    /// Maps a direction to its coordinates in the face's corners, up to a common factor.
    corners_from_direction: Matrix3<f64>,
    /// Node i parts towards the first and j towards the second corner, at index `i * stride + j`.
    nodes: Vec<u32>,
}

/// Corners of the triangle that holds a direction, with weights that sum to 1.
pub(super) type Corners = [(usize, f64); 3];

impl Directions {
    /// Returns the grid for a frequency within [`FREQUENCIES`].
    pub(super) fn new(frequency: usize) -> Self {
        let corners = icosahedron();
        let stride = frequency + 2;
        let mut grid = Self {
            frequency,
            nodes: Vec::with_capacity(10 * frequency * frequency + 2),
            shares: Vec::new(),
            neighbours: Vec::new(),
            faces: Vec::new(),
        };
        for [a, b, c] in faces(&corners) {
            let face_corners = Matrix3::from_columns(&[corners[a], corners[b], corners[c]]);
            let mut nodes = vec![0; stride * stride];
            for i in 0..=frequency {
                for j in 0..=frequency - i {
                    let parts = Vector3::new(i as f64, j as f64, (frequency - i - j) as f64);
                    nodes[i * stride + j] = grid.node((face_corners * parts).normalize());
                }
            }
            grid.faces.push(Face {
                center: (face_corners * Vector3::repeat(1.0)).normalize(),
                // The corners of a face are linearly independent.
                corners_from_direction: face_corners.try_inverse().unwrap_or_default(),
                nodes,
            });
        }
        grid.join();
        grid
    }

    /// Returns the index of a node; adds it if it does not exist.
    fn node(&mut self, direction: Vector3) -> u32 {
        // Nodes are at least 1/40 apart.
        const SAME: f64 = 1e-6;
        let known = self
            .nodes
            .iter()
            .position(|n| (n - direction).norm() < SAME);
        known.unwrap_or_else(|| {
            self.nodes.push(direction);
            self.nodes.len() - 1
        }) as u32
    }

    /// Computes neighbours and solid angles, triangle by triangle.
    fn join(&mut self) {
        let stride = self.frequency + 2;
        let mut triangles = Vec::new();
        for face in &self.faces {
            let at = |i: usize, j: usize| face.nodes[i * stride + j] as usize;
            for i in 0..self.frequency {
                for j in 0..self.frequency - i {
                    triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                    if i + j + 1 < self.frequency {
                        triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                    }
                }
            }
        }
        self.shares = vec![0.0; self.nodes.len()];
        self.neighbours = vec![Vec::new(); self.nodes.len()];
        for corners in triangles {
            let [a, b, c] = corners.map(|node| self.nodes[node]);
            let share = solid_angle(&a, &b, &c) / (4.0 * std::f64::consts::PI);
            for k in 0..3 {
                let (node, next) = (corners[k], corners[(k + 1) % 3]);
                self.shares[node] += share / 3.0;
                // Each edge has a triangle on either side, which traverses it in the opposite direction.
                self.neighbours[node].push(next);
            }
        }
        for neighbours in &mut self.neighbours {
            neighbours.sort_unstable();
        }
    }

    pub(super) fn count(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn nodes(&self) -> &[Vector3] {
        &self.nodes
    }

    pub(super) fn shares(&self) -> &[f64] {
        &self.shares
    }

    pub(super) fn neighbours(&self, node: usize) -> &[usize] {
        &self.neighbours[node]
    }

    /// Returns the nodes around a direction, which may have any length but 0.
    pub(super) fn locate(&self, direction: &Vector3) -> Corners {
        let mut face = &self.faces[0];
        let mut nearest = f64::NEG_INFINITY;
        for candidate in &self.faces {
            let along = candidate.center.dot(direction);
            if along > nearest {
                (face, nearest) = (candidate, along);
            }
        }
        let parts = face.corners_from_direction * direction;
        let scale = self.frequency as f64 / parts.sum();
        let most = self.frequency as f64;
        let (a, b) = (
            (parts.x * scale).clamp(0.0, most),
            (parts.y * scale).clamp(0.0, most),
        );
        let (i, j) = (a as usize, (b as usize).min(self.frequency - a as usize));
        let (a, b) = (a - i as f64, (b - j as f64).min(1.0));
        let stride = self.frequency + 2;
        // Nodes beyond the face have weight 0.
        let at = |i: usize, j: usize| face.nodes[i * stride + j] as usize;
        if a + b <= 1.0 {
            let rest = 1.0 - a - b;
            [(at(i, j), rest), (at(i + 1, j), a), (at(i, j + 1), b)]
        } else {
            let far = a + b - 1.0;
            [
                (at(i + 1, j + 1), far),
                (at(i + 1, j), 1.0 - b),
                (at(i, j + 1), 1.0 - a),
            ]
        }
    }

    /// Returns the node nearest to a direction; ties are broken arbitrarily.
    pub(super) fn nearest(&self, direction: &Vector3) -> usize {
        let [a, b, c] = self.locate(direction);
        let ab = if a.1 >= b.1 { a } else { b };
        if ab.1 >= c.1 { ab.0 } else { c.0 }
    }
}

/// Returns the twelve unit corners of an icosahedron.
fn icosahedron() -> Vec<Vector3> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut corners = Vec::with_capacity(12);
    for one in [-1.0, 1.0] {
        for g in [-golden, golden] {
            corners.push(Vector3::new(0.0, one, g));
            corners.push(Vector3::new(one, g, 0.0));
            corners.push(Vector3::new(g, 0.0, one));
        }
    }
    corners.iter().map(Vector3::normalize).collect()
}

/// Returns the faces of the icosahedron, counter-clockwise as seen from outside.
fn faces(corners: &[Vector3]) -> Vec<[usize; 3]> {
    // Neighbouring corners are 1.05 apart, all others at least 1.7.
    let near = |a: usize, b: usize| (corners[a] - corners[b]).norm() < 1.3;
    let mut faces = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(a, c) {
                    let outwards = corners[a].dot(&corners[b].cross(&corners[c]));
                    faces.push(if outwards > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}

/// Solid angle of the spherical triangle of three directions (Van Oosterom & Strackee 1983) [sr].
fn solid_angle(a: &Vector3, b: &Vector3, c: &Vector3) -> f64 {
    let volume = a.dot(&b.cross(c)).abs();
    2.0 * volume.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_grid_covers_the_sphere_once() {
        for frequency in [1, 2, 3, 5, 8] {
            let grid = Directions::new(frequency);
            assert_eq!(grid.faces.len(), 20);
            assert_eq!(grid.count(), 10 * frequency * frequency + 2);
            assert!((grid.shares().iter().sum::<f64>() - 1.0).abs() < 1e-12);
            for node in 0..grid.count() {
                let neighbours = grid.neighbours(node);
                assert!((5..=6).contains(&neighbours.len()));
                assert!(
                    neighbours
                        .iter()
                        .all(|&n| grid.neighbours(n).contains(&node))
                );
                assert_eq!(grid.nearest(&grid.nodes()[node]), node);
            }
        }
    }

    proptest! {
        #[test]
        fn a_direction_is_the_weighted_sum_of_its_corners(
            frequency in 1usize..9,
            x in -1.0..1.0, y in -1.0..1.0, z in -1.0..1.0,
        ) {
            let direction = Vector3::new(x, y, z);
            prop_assume!(direction.norm() > 1e-3);
            let grid = Directions::new(frequency);
            let corners = grid.locate(&direction);
            // The nodes of a flat triangle are pushed out to the sphere, by different lengths: only
            // the weights in the flat face reproduce the direction exactly, so compare loosely.
            let sum: Vector3 = corners.iter().map(|&(n, w)| grid.nodes()[n] * w).sum();
            prop_assert!((corners.iter().map(|c| c.1).sum::<f64>() - 1.0).abs() < 1e-9);
            prop_assert!(corners.iter().all(|c| c.1 >= -1e-9));
            let off = sum.angle(&direction);
            prop_assert!(off < 0.15 / frequency as f64, "{off} rad off");
        }
    }

    #[test]
    fn no_direction_is_no_panic() {
        let grid = Directions::new(4);
        for odd in [0.0, f64::NAN, f64::INFINITY] {
            let corners = grid.locate(&Vector3::repeat(odd));
            assert!(corners.iter().all(|c| c.0 < grid.count()));
        }
    }
}
