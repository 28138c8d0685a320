//! Where a line along the motion runs through a translating footprint.

use super::motion::CLEARANCE;
use crate::geometry::{Edge, Point2, Vector2};

const MAX_BINS: usize = 256;

/// The footprint's edges in the frame of a stroke (x along the motion, y to its left), sorted into
/// bins of y so that a particle only meets the edges beside it.
#[derive(Debug, Clone)]
pub(super) struct SweptTranslation {
    edges: Vec<Edge>,
    low: Point2,
    high: Point2,
    /// `bin_edges[bin_start[b]..bin_start[b + 1]]` are the edges that reach into bin b.
    bin_start: Vec<u32>,
    bin_edges: Vec<u32>,
    crossings: Vec<f64>,
}

/// The intervals in which one line along the motion runs inside the footprint, in ascending order.
pub(super) struct Chords<'a> {
    pub(super) crossings: &'a [f64],
}

impl SweptTranslation {
    pub(super) fn for_edges(edges: usize) -> Self {
        let bins = (edges / 4).clamp(1, MAX_BINS);
        Self {
            edges: Vec::with_capacity(edges),
            low: Point2::origin(),
            high: Point2::origin(),
            bin_start: vec![0; bins + 1],
            bin_edges: Vec::new(),
            crossings: Vec::new(),
        }
    }

    /// Turns the footprint (tool frame, at `heading`) into the frame of a stroke along `along`.
    pub(super) fn fill(&mut self, edges: &[Edge], heading: f64, along: Vector2) {
        let (sin, cos) = heading.sin_cos();
        let into_stroke = |p: Point2| {
            let turned = Vector2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
            Point2::new(turned.dot(&along), along.perp(&turned))
        };
        self.edges.clear();
        self.low = Point2::new(f64::INFINITY, f64::INFINITY);
        self.high = -self.low;
        for edge in edges {
            let edge = Edge {
                start: into_stroke(edge.start),
                end: into_stroke(edge.end),
            };
            self.low = self.low.inf(&edge.start);
            self.high = self.high.sup(&edge.start);
            self.edges.push(edge);
        }
        self.sort_into_bins();
    }

    /// Counting sort: sizes, then starts, then the edges themselves.
    fn sort_into_bins(&mut self) {
        self.bin_start.fill(0);
        let bins = self.bin_start.len() - 1;
        if self.edges.is_empty() || bins == 1 {
            return;
        }
        for edge in &self.edges {
            for bin in
                self.bin(edge.start.y.min(edge.end.y))..=self.bin(edge.start.y.max(edge.end.y))
            {
                self.bin_start[bin] += 1;
            }
        }
        let mut total = 0;
        for start in &mut self.bin_start {
            total += *start;
            *start = total;
        }
        self.bin_edges.clear();
        self.bin_edges.resize(total as usize, 0);
        for (i, edge) in self.edges.iter().enumerate() {
            let first = self.bin(edge.start.y.min(edge.end.y));
            let last = self.bin(edge.start.y.max(edge.end.y));
            for bin in first..=last {
                self.bin_start[bin] -= 1;
                self.bin_edges[self.bin_start[bin] as usize] = i as u32;
            }
        }
    }

    /// Smallest and largest coordinates of the footprint in the stroke frame [m].
    pub(super) fn extent(&self) -> Option<(Point2, Point2)> {
        (!self.edges.is_empty()).then_some((self.low, self.high))
    }

    /// The only chords of a convex footprint, one for each line at so much [m] to the left of the tool centre point's line; one
    /// that misses it ends before it begins.
    ///
    /// Edge by edge over all lines, without a branch: the compiler takes several at once.
    pub(super) fn chords(&self, laterals: &[f64], chords: &mut Vec<[f64; 2]>) {
        chords.clear();
        chords.resize(laterals.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        for Edge { start, end } in &self.edges {
            let (rise, run) = (end.y - start.y, end.x - start.x);
            for (lateral, chord) in laterals.iter().zip(&mut *chords) {
                let x = match run == 0.0 {
                    true => start.x,
                    false => start.x + (lateral - start.y) / rise * run,
                };
                let is_crossed = (start.y > *lateral) != (end.y > *lateral);
                chord[0] = if is_crossed && x < chord[0] {
                    x
                } else {
                    chord[0]
                };
                chord[1] = if is_crossed && x > chord[1] {
                    x
                } else {
                    chord[1]
                };
            }
        }
    }

    /// The chords of the line at `lateral` [m] to the left of the tool centre point's line.
    pub(super) fn at(&mut self, lateral: f64) -> Chords<'_> {
        self.crossings.clear();
        if lateral < self.low.y || lateral > self.high.y {
            return Chords { crossings: &[] };
        }
        let cross = |edge: &Edge| {
            ((edge.start.y > lateral) != (edge.end.y > lateral)).then(|| {
                let share = (lateral - edge.start.y) / (edge.end.y - edge.start.y);
                edge.start.x + share * (edge.end.x - edge.start.x)
            })
        };
        if self.bin_start.len() == 2 {
            self.crossings.extend(self.edges.iter().filter_map(cross));
        } else {
            let bin = self.bin(lateral);
            let members = self.bin_start[bin] as usize..self.bin_start[bin + 1] as usize;
            for &i in &self.bin_edges[members] {
                self.crossings.extend(cross(&self.edges[i as usize]));
            }
        }
        self.crossings.sort_unstable_by(f64::total_cmp);
        Chords {
            crossings: &self.crossings,
        }
    }

    fn bin(&self, lateral: f64) -> usize {
        let bins = self.bin_start.len() - 1;
        let share = (lateral - self.low.y) / (self.high.y - self.low.y);
        ((share * bins as f64) as usize).min(bins - 1)
    }
}

impl<'a> Chords<'a> {
    /// That of a convex footprint; see [`SweptTranslation::chords`].
    pub(super) fn of_convex(chord: &'a [f64; 2]) -> Self {
        let crossings = match chord[0] <= chord[1] {
            true => &chord[..],
            false => &[],
        };
        Self { crossings }
    }
}

impl Chords<'_> {
    /// Whether a particle `ahead` of the tool's start comes under the footprint on a way of `length`.
    pub(super) fn covers(&self, ahead: f64, length: f64) -> bool {
        self.crossings
            .chunks_exact(2)
            .any(|chord| chord[0] <= ahead && ahead <= chord[1] + length)
    }

    /// How far the footprint slides over a particle `ahead` of the tool's start on a way of `length` [m].
    pub(super) fn slid(&self, ahead: f64, length: f64) -> f64 {
        let over = |chord: &[f64]| (ahead - chord[0]).min(length) - (ahead - chord[1]).max(0.0);
        let chords = self.crossings.chunks_exact(2);
        chords.map(|chord| over(chord).max(0.0)).sum()
    }

    /// Where a particle `ahead` of the tool's start has been carried to after a way of `length`.
    ///
    /// The foremost chord that begins behind the particle is the one that reaches it first: all
    /// chords move alike, so none of those further back ever catches up.
    pub(super) fn carried(&self, ahead: f64, length: f64) -> Option<f64> {
        let leading = self
            .crossings
            .chunks_exact(2)
            .take_while(|chord| chord[0] < ahead)
            .last()?[1];
        let carried = leading + length + CLEARANCE;
        (carried > ahead).then_some(carried)
    }
}
