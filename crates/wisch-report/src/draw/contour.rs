//! Lines of equal density (marching squares).

use std::collections::BTreeMap;
use wisch::geometry::{Edge, Point2};
use wisch::plan::CoverageDensity;

/// Maximum number of samples along one side of the map.
const MAX_SAMPLES: usize = 320;
/// Ends closer than this count as the same corner [m].
const SAME: f64 = 1e-7;

/// A density, sampled for contours.
pub(crate) struct Contours<'a> {
    density: &'a CoverageDensity,
    stride: usize,
    /// Largest sampled density.
    pub(crate) peak: f64,
}

impl<'a> Contours<'a> {
    pub(crate) fn new(density: &'a CoverageDensity) -> Self {
        let (columns, rows) = density.shape();
        let peak = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (column, row)))
            .map(|(column, row)| density.sample(column, row))
            .fold(0.0, f64::max);
        Self {
            density,
            stride: columns.max(rows).div_ceil(MAX_SAMPLES).max(1),
            peak,
        }
    }

    /// Returns rings around all areas with a density above `level`; a ring inside a ring encloses a hole.
    ///
    /// The map extends beyond the particles until the density vanishes, so all rings close.
    pub(crate) fn rings(&self, level: f64) -> Vec<Vec<Point2>> {
        let (columns, rows) = self.density.shape();
        let mut edges = Vec::new();
        for row in (0..rows.saturating_sub(self.stride)).step_by(self.stride) {
            for column in (0..columns.saturating_sub(self.stride)).step_by(self.stride) {
                self.cross_cell(column, row, level, &mut edges);
            }
        }
        join_edges(&edges)
    }

    fn cross_cell(&self, column: usize, row: usize, level: f64, edges: &mut Vec<Edge>) {
        let (right, up) = (column + self.stride, row + self.stride);
        // Counter-clockwise from the lower left.
        let corners = [(column, row), (right, row), (right, up), (column, up)];
        let value = corners.map(|(c, r)| self.density.sample(c, r) - level);
        let above = value.map(|v| v > 0.0);
        if above == [true; 4] || above == [false; 4] {
            return;
        }
        let place = corners.map(|(c, r)| self.density.sample_position(c, r));
        let cut = |side: usize| {
            // From the lower corner to the higher, so that both neighbours of a side agree.
            let (a, b) = (side, (side + 1) % 4);
            let (low, high) = if above[a] { (b, a) } else { (a, b) };
            place[low] + (place[high] - place[low]) * (value[low] / (value[low] - value[high]))
        };
        let cuts: Vec<usize> = (0..4).filter(|&s| above[s] != above[(s + 1) % 4]).collect();
        // The mean of the corners decides how a saddle is connected.
        let turned = cuts.len() == 4 && (value.iter().sum::<f64>() > 0.0) == above[0];
        let pairs: &[(usize, usize)] = match (cuts.len(), turned) {
            (2, _) => &[(0, 1)],
            (_, true) => &[(0, 1), (2, 3)],
            (_, false) => &[(3, 0), (1, 2)],
        };
        edges.extend(pairs.iter().map(|&(a, b)| Edge {
            start: cut(cuts[a]),
            end: cut(cuts[b]),
        }));
    }
}

/// Joins unordered edges end to end. A chain that does not close stays open.
pub(crate) fn join_edges(edges: &[Edge]) -> Vec<Vec<Point2>> {
    let key = |p: Point2| ((p.x / SAME).round() as i64, (p.y / SAME).round() as i64);
    let mut at: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
    for (i, edge) in edges.iter().enumerate() {
        at.entry(key(edge.start)).or_default().push(i);
        at.entry(key(edge.end)).or_default().push(i);
    }
    let mut used = vec![false; edges.len()];
    let mut rings = Vec::new();
    for first in 0..edges.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let mut ring = vec![edges[first].start];
        let mut end = edges[first].end;
        while let Some(&next) = at
            .get(&key(end))
            .and_then(|candidates| candidates.iter().find(|&&i| !used[i]))
        {
            used[next] = true;
            ring.push(end);
            let edge = &edges[next];
            end = if key(edge.start) == key(end) {
                edge.end
            } else {
                edge.start
            };
        }
        if key(end) != key(ring[0]) {
            ring.push(end);
        }
        rings.push(ring);
    }
    rings
}
