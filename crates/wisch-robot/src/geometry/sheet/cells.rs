//! Cells of a surface of about equal size, by Lloyd's algorithm over the distances between neighbouring triangles.

use super::topology::Triangles;
use crate::geometry::{Point3, Vector3};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Rounds in which cells move to their middles.
const ROUNDS: usize = 12;
/// Rounds in which the borders of cells become smoother.
const SMOOTHING_ROUNDS: usize = 3;

/// Triangles with the distances to their neighbours.
#[derive(Clone)]
pub(super) struct CellGraph {
    pub(super) neighbours: Vec<[Option<u32>; 3]>,
    pub(super) centres: Vec<Point3>,
    areas: Vec<f64>,
    /// Factors of the distances in each triangle.
    factors: Vec<f64>,
}

impl CellGraph {
    pub(super) fn new(surface: &Triangles) -> Self {
        let centre = |&triangle: &[u32; 3]| {
            let [a, b, c] = surface.corners(triangle);
            Point3::from((a.coords + b.coords + c.coords) / 3.0)
        };
        let area = |&triangle: &[u32; 3]| surface.doubled_normal(triangle).norm();
        Self {
            neighbours: surface.neighbours(),
            centres: surface.triangles.iter().map(centre).collect(),
            areas: surface.triangles.iter().map(area).collect(),
            factors: vec![1.0; surface.triangles.len()],
        }
    }

    /// Returns the graph with distances that grow by a factor in each triangle.
    pub(super) fn with_factors(&self, factors: Vec<f64>) -> Self {
        Self {
            factors,
            ..self.clone()
        }
    }

    /// Returns the triangles of each of `count` cells, in ascending order.
    pub(super) fn divide(&self, count: usize) -> Vec<Vec<u32>> {
        let mut seeds = vec![self.nearest(0..self.centres.len() as u32)];
        while seeds.len() < count {
            let (distances, _) = self.spread(&seeds);
            let farthest = (0..distances.len())
                .filter(|&t| distances[t].is_finite())
                .max_by(|&one, &other| {
                    distances[one]
                        .total_cmp(&distances[other])
                        .then(other.cmp(&one))
                });
            seeds.push(farthest.unwrap_or(0) as u32);
        }
        let mut cells = Vec::new();
        for _ in 0..ROUNDS {
            let (_, owners) = self.spread(&seeds);
            cells = vec![Vec::new(); seeds.len()];
            for (t, owner) in (0u32..).zip(owners) {
                if let Some(owner) = owner {
                    cells[owner as usize].push(t);
                }
            }
            let middles: Vec<u32> = (cells.iter().zip(&seeds))
                .map(|(cell, seed)| {
                    if cell.is_empty() {
                        *seed
                    } else {
                        self.nearest(cell.iter().copied())
                    }
                })
                .collect();
            if middles == seeds {
                break;
            }
            seeds = middles;
        }
        let mut cells = self.smooth(&cells);
        cells.retain(|cell| !cell.is_empty());
        cells
    }

    /// Returns cells with smoother borders: a triangle with two neighbours of another cell goes to that cell.
    fn smooth(&self, cells: &[Vec<u32>]) -> Vec<Vec<u32>> {
        let mut owners: Vec<Option<usize>> = vec![None; self.centres.len()];
        for (owner, cell) in cells.iter().enumerate() {
            cell.iter().for_each(|&t| owners[t as usize] = Some(owner));
        }
        for _ in 0..SMOOTHING_ROUNDS {
            for t in 0..owners.len() {
                let around = self.neighbours[t].map(|other| owners[other? as usize]);
                let [a, b, c] = around;
                let most = if a == b || a == c {
                    a
                } else {
                    b.filter(|_| b == c)
                };
                if most.is_some() && owners[t].is_some() {
                    owners[t] = most;
                }
            }
        }
        let mut smooth = vec![Vec::new(); cells.len()];
        for (t, owner) in (0u32..).zip(owners) {
            if let Some(owner) = owner {
                smooth[owner].push(t);
            }
        }
        smooth
    }

    /// Returns the triangle nearest to the centroid of some.
    fn nearest(&self, triangles: impl Iterator<Item = u32> + Clone) -> u32 {
        let (mut sum, mut area) = (Vector3::zeros(), 0.0);
        for t in triangles.clone() {
            sum += self.centres[t as usize].coords * self.areas[t as usize];
            area += self.areas[t as usize];
        }
        let middle = Point3::from(sum / f64::max(area, f64::MIN_POSITIVE));
        let distance = |t: u32| (self.centres[t as usize] - middle).norm();
        triangles
            .min_by(|&one, &other| {
                distance(one)
                    .total_cmp(&distance(other))
                    .then(one.cmp(&other))
            })
            .unwrap_or(0)
    }

    /// Returns the distance of each triangle to the nearest seed \[m, times its factors\], and the index of that seed (Dijkstra).
    pub(super) fn spread(&self, seeds: &[u32]) -> (Vec<f64>, Vec<Option<u32>>) {
        let mut distances = vec![f64::INFINITY; self.centres.len()];
        let mut owners = vec![None; self.centres.len()];
        // Positive numbers have the order of their bits.
        let mut queue = BinaryHeap::new();
        for (owner, &seed) in (0u32..).zip(seeds) {
            queue.push(Reverse((0f64.to_bits(), owner, seed)));
        }
        while let Some(Reverse((bits, owner, t))) = queue.pop() {
            if owners[t as usize].is_some() {
                continue;
            }
            let distance = f64::from_bits(bits);
            owners[t as usize] = Some(owner);
            distances[t as usize] = distance;
            for other in self.neighbours[t as usize].into_iter().flatten() {
                if owners[other as usize].is_none() {
                    let [from, to] = [t as usize, other as usize];
                    let factor = 0.5 * (self.factors[from] + self.factors[to]);
                    let step = factor * (self.centres[to] - self.centres[from]).norm();
                    queue.push(Reverse(((distance + step).to_bits(), owner, other)));
                }
            }
        }
        (distances, owners)
    }
}
