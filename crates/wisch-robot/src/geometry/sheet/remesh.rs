//! Triangles at the scale of a tool: short edges collapse, long edges are split, and thin triangles are flipped.

use super::topology::Triangles;
use crate::geometry::{Mesh, Vector3};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Edges shorter than this share of the longest allowed edge collapse [1] (Botsch and Kobbelt, 2004: 4/5 of a target length
/// whose 4/3 is the limit).
const SHORT: f64 = 0.6;
/// Least cosine between the normals of a triangle before and after a change [1].
const MIN_NORMAL_COSINE: f64 = 0.8;
/// Largest distance by which a collapse moves the border, relative to the longest allowed edge [1].
const BORDER_TOLERANCE: f64 = 0.008;
/// Triangles lower than this share of their longest side have no usable normal [1].
const MIN_HEIGHT: f64 = 1e-9;

/// A surface that changes: triangles with the triangles of each vertex.
struct Changing {
    mesh: Triangles,
    /// Triangles of each vertex, in no fixed order but one that depends on the input alone.
    around: Vec<Vec<u32>>,
    is_alive: Vec<bool>,
    is_border: Vec<bool>,
}

/// Returns the surface with edges of at most `longest` \[m\] that are not much shorter where that keeps the shape; expects
/// single fans.
pub(super) fn remesh(surface: &Triangles, longest: f64) -> Triangles {
    let mut changing = Changing::new(surface.clone());
    changing.flip_edges();
    changing.collapse_edges(longest);
    let coarse = changing.finish();
    let fine = split_long_edges(&coarse, longest);
    let mut changing = Changing::new(fine);
    changing.flip_edges();
    changing.finish()
}

/// Divides edges longer than `longest` \[m\].
pub(super) fn split_long_edges(surface: &Triangles, longest: f64) -> Triangles {
    let Ok(mesh) = Mesh::new(surface.vertices.clone(), surface.triangles.clone()) else {
        return surface.clone();
    };
    let fine = mesh.split_edges(longest);
    Triangles {
        vertices: fine.vertices().to_vec(),
        triangles: fine.triangles().to_vec(),
    }
}

/// Whether an edge is longer than `longest` \[m\].
pub(super) fn has_edges_beyond(surface: &Triangles, longest: f64) -> bool {
    (surface.triangles.iter()).any(|&triangle| {
        let [a, b, c] = surface.corners(triangle);
        [b - a, c - b, a - c]
            .iter()
            .any(|edge| edge.norm() > longest)
    })
}

impl Changing {
    fn new(mesh: Triangles) -> Self {
        let mut around = vec![Vec::new(); mesh.vertices.len()];
        for (t, corners) in (0u32..).zip(&mesh.triangles) {
            for &i in corners {
                around[i as usize].push(t);
            }
        }
        let mut is_border = vec![false; mesh.vertices.len()];
        for group in mesh.sides().chunk_by(|one, other| one.edge == other.edge) {
            if group.len() != 2 {
                group[0]
                    .edge
                    .iter()
                    .for_each(|&i| is_border[i as usize] = true);
            }
        }
        Self {
            is_alive: vec![true; mesh.triangles.len()],
            around,
            is_border,
            mesh,
        }
    }

    /// Returns the triangles that are left.
    fn finish(self) -> Triangles {
        let alive: Vec<u32> = (0..self.mesh.triangles.len() as u32)
            .filter(|&t| self.is_alive[t as usize])
            .collect();
        self.mesh.select(&alive)
    }

    fn length(&self, a: u32, b: u32) -> f64 {
        (self.mesh.vertices[a as usize] - self.mesh.vertices[b as usize]).norm()
    }

    /// Returns the triangles that have both vertices.
    fn sharing(&self, a: u32, b: u32) -> Vec<u32> {
        (self.around[a as usize].iter())
            .copied()
            .filter(|&t| self.mesh.triangles[t as usize].contains(&b))
            .collect()
    }

    /// Returns the neighbours of a vertex in ascending order.
    fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let mut neighbours: Vec<u32> = (self.around[vertex as usize].iter())
            .flat_map(|&t| self.mesh.triangles[t as usize])
            .filter(|&i| i != vertex)
            .collect();
        neighbours.sort_unstable();
        neighbours.dedup();
        neighbours
    }

    /// Returns the unit normal; none for a triangle without a usable height.
    fn normal(&self, corners: [u32; 3]) -> Option<Vector3> {
        let doubled = self.mesh.doubled_normal(corners);
        let [a, b, c] = corners;
        let longest = (self.length(a, b))
            .max(self.length(b, c))
            .max(self.length(c, a));
        doubled.try_normalize(MIN_HEIGHT * longest * longest)
    }

    /// Whether every triangle keeps its orientation.
    fn keeps_normal(&self, before: [u32; 3], after: [u32; 3]) -> bool {
        match (self.normal(before), self.normal(after)) {
            (_, None) => false,
            (None, Some(_)) => true,
            (Some(before), Some(after)) => before.dot(&after) >= MIN_NORMAL_COSINE,
        }
    }

    /// Collapses short edges, the shortest first.
    fn collapse_edges(&mut self, longest: f64) {
        let short = SHORT * longest;
        let mut drift = vec![0.0; self.mesh.vertices.len()];
        // Positive numbers have the order of their bits.
        let entry = |length: f64, a: u32, b: u32| Reverse((length.to_bits(), a.min(b), a.max(b)));
        let mut queue: BinaryHeap<_> = (self.mesh.sides())
            .chunk_by(|one, other| one.edge == other.edge)
            .map(|group| group[0].edge)
            .filter(|&[a, b]| self.length(a, b) < short)
            .map(|[a, b]| entry(self.length(a, b), a, b))
            .collect();
        while let Some(Reverse((bits, a, b))) = queue.pop() {
            if self.length(a, b).to_bits() != bits || self.sharing(a, b).is_empty() {
                continue;
            }
            // The vertex inside goes first; of two alike, that of the higher number.
            let orders = if self.is_border[b as usize] && !self.is_border[a as usize] {
                [[a, b], [b, a]]
            } else {
                [[b, a], [a, b]]
            };
            let Some([gone, kept]) = (orders.into_iter())
                .find(|&[gone, kept]| self.may_collapse(gone, kept, longest, &mut drift))
            else {
                continue;
            };
            self.collapse(gone, kept);
            for other in self.neighbours(kept) {
                if self.length(kept, other) < short {
                    queue.push(entry(self.length(kept, other), kept, other));
                }
            }
        }
    }

    /// Whether the vertex `gone` may move into `kept`. If so, adds the movement of the border to `drift`.
    fn may_collapse(&self, gone: u32, kept: u32, longest: f64, drift: &mut [f64]) -> bool {
        let shared = self.sharing(gone, kept);
        let [around_gone, around_kept] = [gone, kept].map(|i| self.neighbours(i));
        let is_common = |i: &&u32| around_kept.binary_search(i).is_ok();
        let common = around_gone.iter().filter(is_common).count();
        if common != shared.len() || self.around[kept as usize].len() <= shared.len() {
            return false;
        }
        let mut new_drift = None;
        if self.is_border[gone as usize] {
            // Only along the border, and where it is nearly straight.
            if shared.len() != 1 || !self.is_border[kept as usize] {
                return false;
            }
            let is_on_border = |&&i: &&u32| i != kept && self.sharing(gone, i).len() == 1;
            let Some(&before) = around_gone.iter().find(is_on_border) else {
                return false;
            };
            let [from, to, at] = [before, kept, gone].map(|i| self.mesh.vertices[i as usize]);
            let along = to - from;
            let Some(along) = along.try_normalize(0.0) else {
                return false;
            };
            let aside = (at - from) - along * (at - from).dot(&along);
            let moved = drift[gone as usize].max(drift[kept as usize]) + aside.norm();
            if moved > BORDER_TOLERANCE * longest {
                return false;
            }
            new_drift = Some(moved);
        } else if self.is_border[kept as usize] && shared.len() != 2 {
            return false;
        }
        let is_allowed = (self.around[gone as usize].iter())
            .filter(|t| !shared.contains(t))
            .all(|&t| {
                let before = self.mesh.triangles[t as usize];
                let after = before.map(|i| if i == gone { kept } else { i });
                let is_short =
                    (before.iter()).all(|&i| i == gone || self.length(i, kept) <= longest);
                is_short && self.keeps_normal(before, after)
            });
        if let (true, Some(moved)) = (is_allowed, new_drift) {
            drift[kept as usize] = moved;
        }
        is_allowed
    }

    fn collapse(&mut self, gone: u32, kept: u32) {
        for t in std::mem::take(&mut self.around[gone as usize]) {
            let corners = self.mesh.triangles[t as usize];
            if corners.contains(&kept) {
                self.is_alive[t as usize] = false;
                for i in corners {
                    self.around[i as usize].retain(|&other| other != t);
                }
            } else {
                self.mesh.triangles[t as usize] = corners.map(|i| if i == gone { kept } else { i });
                self.around[kept as usize].push(t);
            }
        }
    }

    /// Flips inner edges whose opposite angles sum to more than π, which makes thin triangles less thin.
    fn flip_edges(&mut self) {
        let mut open: Vec<[u32; 2]> = (self.mesh.sides())
            .chunk_by(|one, other| one.edge == other.edge)
            .filter(|group| group.len() == 2)
            .map(|group| group[0].edge)
            .collect();
        // Flips of edges on a curved surface need not end by themselves.
        let mut left = 10 * open.len();
        while let Some([a, b]) = open.pop() {
            left = left.saturating_sub(1);
            if left == 0 {
                break;
            }
            if let Some([c, d]) = self.flip(a, b) {
                open.extend([[a, c], [a, d], [b, c], [b, d]]);
            }
        }
        self.drop_flat_border_triangles();
    }

    /// Flips an edge if that is better; returns the new edge.
    fn flip(&mut self, a: u32, b: u32) -> Option<[u32; 2]> {
        let shared = self.sharing(a, b);
        let &[one, other] = &shared[..] else {
            return None;
        };
        let tip = |t: u32| {
            let corners = self.mesh.triangles[t as usize];
            corners.into_iter().find(|&i| i != a && i != b)
        };
        let (c, d) = (tip(one)?, tip(other)?);
        if c == d || !self.sharing(c, d).is_empty() {
            return None;
        }
        // cot γ + cot δ < 0, without a division: the sum of the angles is above π.
        let (sine_c, cosine_c) = self.angle_at(c, a, b);
        let (sine_d, cosine_d) = self.angle_at(d, a, b);
        if sine_c * cosine_d + cosine_c * sine_d >= -1e-9 {
            return None;
        }
        let [before_one, before_other] = [one, other].map(|t| self.mesh.triangles[t as usize]);
        let [after_one, after_other] = [
            before_one.map(|i| if i == b { d } else { i }),
            before_other.map(|i| if i == a { c } else { i }),
        ];
        let is_kept = [before_one, before_other].iter().all(|&before| {
            self.normal(before).is_none()
                || (self.keeps_normal(before, after_one) && self.keeps_normal(before, after_other))
        });
        if !is_kept || self.normal(after_one).is_none() || self.normal(after_other).is_none() {
            return None;
        }
        self.mesh.triangles[one as usize] = after_one;
        self.mesh.triangles[other as usize] = after_other;
        self.around[b as usize].retain(|&t| t != one);
        self.around[a as usize].retain(|&t| t != other);
        self.around[d as usize].push(one);
        self.around[c as usize].push(other);
        Some([c, d])
    }

    /// Returns sine and cosine of the angle at a corner, both times the lengths of its sides over their product.
    fn angle_at(&self, corner: u32, a: u32, b: u32) -> (f64, f64) {
        let [corner, a, b] = [corner, a, b].map(|i| self.mesh.vertices[i as usize]);
        let (u, v) = (a - corner, b - corner);
        let scale = (u.norm() * v.norm()).max(f64::MIN_POSITIVE);
        (u.cross(&v).norm() / scale, u.dot(&v) / scale)
    }

    /// Drops triangles without height whose longest side is on the border.
    fn drop_flat_border_triangles(&mut self) {
        for t in 0..self.mesh.triangles.len() {
            let corners = self.mesh.triangles[t];
            if !self.is_alive[t] || self.normal(corners).is_some() {
                continue;
            }
            let is_outside = (0..3).any(|k| {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                let other = corners[(k + 2) % 3];
                let is_longest = self.length(a, b) >= self.length(b, other)
                    && self.length(a, b) >= self.length(other, a);
                is_longest && self.sharing(a, b).len() == 1 && !self.is_border[other as usize]
            });
            if is_outside {
                self.is_alive[t] = false;
                for i in corners {
                    self.around[i as usize].retain(|&other| other != t as u32);
                    self.is_border[i as usize] = true;
                }
            }
        }
    }
}
