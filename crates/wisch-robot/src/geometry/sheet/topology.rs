//! Triangles with their neighbours: edges, connected parts, borders.

use crate::geometry::{Point3, Vector3};

/// Vertices and triangles that name them, without the checks of a mesh.
#[derive(Debug, Clone, Default)]
pub(super) struct Triangles {
    pub(super) vertices: Vec<Point3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// A directed side of a triangle, as an undirected edge with its owner.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    /// The vertices, the smaller first.
    pub(super) edge: [u32; 2],
    pub(super) triangle: u32,
    /// Number of the side: from corner `side` to the next.
    pub(super) side: u8,
}

impl Triangles {
    pub(super) fn corners(&self, triangle: [u32; 3]) -> [Point3; 3] {
        triangle.map(|i| self.vertices[i as usize])
    }

    /// Returns the normal of a triangle, with twice the area as its length.
    pub(super) fn doubled_normal(&self, triangle: [u32; 3]) -> Vector3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(&(c - a))
    }

    pub(super) fn area(&self) -> f64 {
        let doubled = self
            .triangles
            .iter()
            .map(|&t| self.doubled_normal(t).norm());
        0.5 * doubled.sum::<f64>()
    }

    /// Returns the area-weighted mean normal; zero if the normals cancel.
    pub(super) fn mean_normal(&self) -> Vector3 {
        let sum =
            (self.triangles.iter()).fold(Vector3::zeros(), |sum, &t| sum + self.doubled_normal(t));
        sum.try_normalize(1e-12).unwrap_or_default()
    }

    /// Returns the triangles of these indices, with the vertices that they use in their order.
    pub(super) fn select(&self, chosen: &[u32]) -> Self {
        let used = self.used_vertices(chosen);
        let mut number = vec![0; self.vertices.len()];
        for (new, &old) in (0u32..).zip(&used) {
            number[old as usize] = new;
        }
        let triangles = (chosen.iter())
            .map(|&t| self.triangles[t as usize].map(|i| number[i as usize]))
            .collect();
        Self {
            vertices: used.iter().map(|&i| self.vertices[i as usize]).collect(),
            triangles,
        }
    }

    /// Returns the vertices of these triangles in ascending order.
    pub(super) fn used_vertices(&self, chosen: &[u32]) -> Vec<u32> {
        let mut is_used = vec![false; self.vertices.len()];
        for &t in chosen {
            for i in self.triangles[t as usize] {
                is_used[i as usize] = true;
            }
        }
        (0u32..)
            .zip(is_used)
            .filter(|(_, used)| *used)
            .map(|(i, _)| i)
            .collect()
    }

    /// Returns all sides, sorted by their edges.
    pub(super) fn sides(&self) -> Vec<Side> {
        let mut sides: Vec<Side> = (0u32..)
            .zip(&self.triangles)
            .flat_map(|(triangle, corners)| {
                (0..3u8).map(move |side| {
                    let [from, to] = [side, (side + 1) % 3].map(|i| corners[usize::from(i)]);
                    Side {
                        edge: [from.min(to), from.max(to)],
                        triangle,
                        side,
                    }
                })
            })
            .collect();
        sides.sort_unstable();
        sides
    }

    /// Returns the neighbour of each triangle over each of its sides. Sides that one or more than two triangles have
    /// lead to none.
    pub(super) fn neighbours(&self) -> Vec<[Option<u32>; 3]> {
        let mut neighbours = vec![[None; 3]; self.triangles.len()];
        for group in self.sides().chunk_by(|one, other| one.edge == other.edge) {
            if let [one, other] = group {
                neighbours[one.triangle as usize][usize::from(one.side)] = Some(other.triangle);
                neighbours[other.triangle as usize][usize::from(other.side)] = Some(one.triangle);
            }
        }
        neighbours
    }

    /// Returns a copy in which each vertex has one fan of triangles: vertices at which several fans meet are repeated at
    /// the end. Also returns the vertex of which each is a copy.
    pub(super) fn with_single_fans(&self) -> (Self, Vec<u32>) {
        let mut origins: Vec<u32> = (0..self.vertices.len() as u32).collect();
        let neighbours = self.neighbours();
        let mut result = self.clone();
        // Corners are numbered 3 t + k; corners of one fan are joined over sides.
        let mut sets = crate::geometry::DisjointSets::new(3 * self.triangles.len());
        for (t, corners) in self.triangles.iter().enumerate() {
            for (side, other) in neighbours[t].iter().enumerate() {
                let Some(other) = *other else {
                    continue;
                };
                for k in [side, (side + 1) % 3] {
                    let same = |&i: &u32| i == corners[k];
                    if let Some(at) = self.triangles[other as usize].iter().position(same) {
                        sets.union(3 * t + k, 3 * other as usize + at);
                    }
                }
            }
        }
        let mut owner: Vec<Option<usize>> = vec![None; self.vertices.len()];
        let mut copies = std::collections::BTreeMap::new();
        for t in 0..self.triangles.len() {
            for k in 0..3 {
                let vertex = self.triangles[t][k] as usize;
                let fan = sets.find(3 * t + k);
                match owner[vertex] {
                    None => owner[vertex] = Some(fan),
                    Some(known) if known == fan => {}
                    Some(_) => {
                        let copy = *copies.entry((vertex, fan)).or_insert_with(|| {
                            result.vertices.push(self.vertices[vertex]);
                            origins.push(vertex as u32);
                            result.vertices.len() as u32 - 1
                        });
                        result.triangles[t][k] = copy;
                    }
                }
            }
        }
        (result, origins)
    }

    /// Returns the closed border lines, each along the directions of its triangles; expects single fans.
    pub(super) fn borders(&self) -> Vec<Vec<u32>> {
        let mut next: std::collections::BTreeMap<u32, u32> = std::collections::BTreeMap::new();
        for group in self.sides().chunk_by(|one, other| one.edge == other.edge) {
            if let [only] = group {
                let corners = self.triangles[only.triangle as usize];
                let side = usize::from(only.side);
                next.insert(corners[side], corners[(side + 1) % 3]);
            }
        }
        let mut borders = Vec::new();
        while let Some((&first, _)) = next.first_key_value() {
            let (mut border, mut at) = (Vec::new(), first);
            while let Some(to) = next.remove(&at) {
                border.push(at);
                at = to;
            }
            borders.push(border);
        }
        borders
    }

    /// Returns the groups of triangles that are connected over sides, each in ascending order.
    pub(super) fn parts(&self) -> Vec<Vec<u32>> {
        let neighbours = self.neighbours();
        let mut part_of = vec![usize::MAX; self.triangles.len()];
        let mut parts: Vec<Vec<u32>> = Vec::new();
        for first in 0..self.triangles.len() {
            if part_of[first] != usize::MAX {
                continue;
            }
            let mut open = vec![first as u32];
            part_of[first] = parts.len();
            let mut at = 0;
            while let Some(&t) = open.get(at) {
                at += 1;
                for other in neighbours[t as usize].into_iter().flatten() {
                    if part_of[other as usize] == usize::MAX {
                        part_of[other as usize] = parts.len();
                        open.push(other);
                    }
                }
            }
            open.sort_unstable();
            parts.push(open);
        }
        parts
    }
}

/// Returns the distance of a point from a triangle [m], and the nearest point.
pub(super) fn nearest_in_triangle(point: Point3, [a, b, c]: [Point3; 3]) -> (f64, Point3) {
    // Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    let bp = point - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    let cp = point - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let nearest = if d1 <= 0.0 && d2 <= 0.0 {
        a
    } else if d3 >= 0.0 && d4 <= d3 {
        b
    } else if d6 >= 0.0 && d5 <= d6 {
        c
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + ab * (d1 / (d1 - d3))
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + ac * (d2 / (d2 - d6))
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))
    } else {
        let sum = va + vb + vc;
        if sum > 0.0 {
            a + ab * (vb / sum) + ac * (vc / sum)
        } else {
            a
        }
    };
    ((point - nearest).norm(), nearest)
}
