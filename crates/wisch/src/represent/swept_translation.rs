//! Chords of a translating footprint along the motion, and the particles that they reach.

use super::contact::PositiveRange;
use super::field::BLOCK;
use super::motion::CLEARANCE;
use super::{Effect, LocalPressure};
use crate::geometry::{Edge, PlanarPose, Point2, Vector2};

const MAX_BINS: usize = 256;
/// Number of particles whose chords are computed at once; divides [`BLOCK`].
const LANES: usize = 4;

/// Edges of the footprint in the stroke frame (x along the motion, y to its left), sorted into bins of y, so that a
/// particle meets only the edges beside it.
#[derive(Debug, Clone)]
pub(super) struct SweptTranslation {
    edges: Vec<Edge>,
    low: Point2,
    high: Point2,
    /// `bin_edges[bin_start[b]..bin_start[b + 1]]` are the edges that reach into bin b.
    bin_start: Vec<u32>,
    bin_edges: Vec<u32>,
    crossings: Vec<f64>,
    clipped: Vec<f64>,
    /// Whether every line meets the footprint in at most one chord.
    is_convex: bool,
    along: Vector2,
    length: f64,
    /// Coordinates of a block's particles in the stroke frame [m].
    ahead: [f64; BLOCK],
    lateral: [f64; BLOCK],
    /// How far each met particle is carried, or the tool slides over it [m].
    extent: [f64; BLOCK],
    is_met: [bool; BLOCK],
    /// Indices in the block of the met particles, in ascending order.
    met: [u8; BLOCK],
}

/// Intervals in which a line along the motion lies inside the footprint, in ascending order.
struct Chords<'a> {
    crossings: &'a [f64],
}

impl SweptTranslation {
    /// Returns an empty sweep for a footprint of `edges` edges; a convex one has at most one chord per line.
    pub(super) fn new(edges: usize, is_convex: bool) -> Self {
        let bins = (edges / 4).clamp(1, MAX_BINS);
        Self {
            edges: Vec::with_capacity(edges),
            low: Point2::origin(),
            high: Point2::origin(),
            bin_start: vec![0; bins + 1],
            bin_edges: Vec::new(),
            crossings: Vec::new(),
            clipped: Vec::new(),
            is_convex,
            along: Vector2::x(),
            length: 0.0,
            ahead: [0.0; BLOCK],
            lateral: [0.0; BLOCK],
            extent: [0.0; BLOCK],
            is_met: [false; BLOCK],
            met: [0; BLOCK],
        }
    }

    /// Transforms the footprint (tool frame, at `heading`) into the frame of a stroke of a length [m] along `along`.
    /// `is_partial`: whether only a part of the footprint acts.
    pub(super) fn fill(
        &mut self,
        edges: &[Edge],
        heading: f64,
        (along, length): (Vector2, f64),
        is_partial: bool,
    ) {
        (self.along, self.length) = (along, length);
        let (sin, cos) = heading.sin_cos();
        let into_stroke = |p: Point2| {
            let turned = Vector2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
            Point2::new(turned.dot(&along), along.perp(&turned))
        };
        self.edges.clear();
        self.low = Point2::new(f64::INFINITY, f64::INFINITY);
        self.high = -self.low;
        let is_convex = self.is_convex;
        for edge in edges {
            let edge = Edge {
                start: into_stroke(edge.start),
                end: into_stroke(edge.end),
            };
            self.low = self.low.inf(&edge.start);
            self.high = self.high.sup(&edge.start);
            // Lines along the motion do not cross an edge that is parallel to it.
            if !is_convex || edge.start.y != edge.end.y {
                self.edges.push(edge);
            }
        }
        if !self.is_convex || is_partial {
            self.sort_into_bins();
        }
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
        (self.low.x <= self.high.x).then_some((self.low, self.high))
    }

    /// Finds the particles of a block that the stroke from `from` affects, given their coordinates [m], and returns
    /// their number. [`SweptTranslation::outcome`] returns each of them, in ascending order.
    pub(super) fn find_met(
        &mut self,
        (x, y): (&[f64], &[f64]),
        from: Point2,
        kind: Effect,
    ) -> usize {
        self.place(x, y, from);
        let count = x.len();
        if self.is_convex {
            self.find_met_by_convex(count, kind)
        } else {
            self.find_met_by_any(count, kind, |_, _| ())
        }
    }

    /// Does the same as [`Self::find_met`] for a tool of which only the part acts whose pressure
    /// reaches a limit. `part`: the pressure (tool frame) and the limit at the place of a particle;
    /// `None` where the whole footprint acts.
    pub(super) fn find_met_by_part(
        &mut self,
        (x, y): (&[f64], &[f64]),
        from: &PlanarPose,
        kind: Effect,
        mut part: impl FnMut(Point2) -> Option<(LocalPressure, f64)>,
    ) -> usize {
        self.place(x, y, from.position);
        let (sin, cos) = from.heading.sin_cos();
        let in_tool = |d: Vector2| Vector2::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x);
        let along = in_tool(self.along);
        let side = Vector2::new(-along.y, along.x);
        self.find_met_by_any(x.len(), kind, |sweep, number| {
            let place = Point2::new(x[number], y[number]);
            if let Some((pressure, least)) = part(place) {
                let line = pressure.on_line(side * sweep.lateral[number], along);
                sweep.clip(&line.exceeds(least));
            }
        })
    }

    /// Computes the coordinates of a block's particles in the stroke frame.
    fn place(&mut self, x: &[f64], y: &[f64], from: Point2) {
        let (along, side) = (self.along, Vector2::new(-self.along.y, self.along.x));
        let frame = self.ahead.iter_mut().zip(&mut self.lateral);
        for ((x, y), (ahead, lateral)) in x.iter().zip(y).zip(frame) {
            let relative = Vector2::new(x - from.x, y - from.y);
            *ahead = relative.dot(&along);
            *lateral = relative.dot(&side);
        }
    }

    /// Returns the index in the block of a met particle, and how far it is carried or the tool slides over it [m].
    pub(super) fn outcome(&self, number: usize) -> (u32, f64) {
        let particle = self.met[number];
        (particle.into(), self.extent[particle as usize])
    }

    /// Runs branch-free over all particles, so that the compiler vectorises it.
    fn find_met_by_convex(&mut self, count: usize, kind: Effect) -> usize {
        let length = self.length;
        let (low, high) = self.chords();
        let particles = self.ahead.iter().zip(low.iter().zip(&high));
        let found = (self.extent.iter_mut().zip(&mut self.is_met)).zip(particles);
        match kind {
            Effect::Absorb => {
                for ((_, is_met), (ahead, (low, high))) in found {
                    *is_met = (low <= ahead) & (*ahead <= high + length);
                }
            }
            Effect::Push => {
                for ((advance, is_met), (ahead, (low, high))) in found {
                    let carried = high + length + CLEARANCE;
                    *advance = carried - ahead;
                    *is_met = (low < ahead) & (carried > *ahead);
                }
            }
            Effect::Treat => {
                for ((slid, is_met), (ahead, (low, high))) in found {
                    *slid = (ahead - low).min(length) - (ahead - high).max(0.0);
                    *is_met = *slid > 0.0;
                }
            }
        }
        let mut met = 0;
        for (particle, &is_met) in self.is_met[..count].iter().enumerate() {
            self.met[met % BLOCK] = particle as u8;
            met += usize::from(is_met);
        }
        met
    }

    /// Returns where the lines of a block's particles enter and leave a convex footprint. A line that misses it leaves
    /// before it enters.
    fn chords(&self) -> ([f64; BLOCK], [f64; BLOCK]) {
        let mut chords = ([f64::INFINITY; BLOCK], [f64::NEG_INFINITY; BLOCK]);
        for (first, laterals) in self.lateral.as_chunks::<LANES>().0.iter().enumerate() {
            let mut low = [f64::INFINITY; LANES];
            let mut high = [f64::NEG_INFINITY; LANES];
            for Edge { start, end } in &self.edges {
                let (rise, run) = (end.y - start.y, end.x - start.x);
                let crossings = match run == 0.0 {
                    true => [start.x; LANES],
                    false => laterals.map(|lateral| start.x + (lateral - start.y) / rise * run),
                };
                for lane in 0..LANES {
                    let lateral = laterals[lane];
                    let is_crossed = (start.y > lateral) != (end.y > lateral);
                    let x = crossings[lane];
                    let (least, most) = (low[lane], high[lane]);
                    low[lane] = if is_crossed & (x < least) { x } else { least };
                    high[lane] = if is_crossed & (x > most) { x } else { most };
                }
            }
            let lanes = first * LANES..(first + 1) * LANES;
            chords.0[lanes.clone()].copy_from_slice(&low);
            chords.1[lanes].copy_from_slice(&high);
        }
        chords
    }

    /// `restrict` removes from the crossings of a particle's line what does not act on it.
    fn find_met_by_any(
        &mut self,
        count: usize,
        kind: Effect,
        mut restrict: impl FnMut(&mut Self, usize),
    ) -> usize {
        let mut met = 0;
        for number in 0..count {
            let (ahead, length) = (self.ahead[number], self.length);
            if ahead < self.low.x || ahead > self.high.x + length {
                continue;
            }
            self.cross(self.lateral[number]);
            if !self.crossings.is_empty() {
                restrict(self, number);
            }
            let chords = Chords {
                crossings: &self.crossings,
            };
            let outcome = match kind {
                Effect::Absorb => chords.covers(ahead, length).then_some(ahead),
                Effect::Push => chords.carried(ahead, length).map(|to| to - ahead),
                Effect::Treat => Some(chords.slid(ahead, length)).filter(|&slid| slid > 0.0),
            };
            if let Some(outcome) = outcome {
                self.extent[number] = outcome;
                self.met[met] = number as u8;
                met += 1;
            }
        }
        met
    }

    /// Reduces the chords to the range in which the tool acts.
    fn clip(&mut self, range: &PositiveRange) {
        self.clipped.clear();
        let mut keep = |low: f64, high: f64| {
            if low < high {
                self.clipped.extend([low, high]);
            }
        };
        for chord in self.crossings.chunks_exact(2) {
            let (low, high) = (chord[0], chord[1]);
            if range.is_between {
                keep(low.max(range.low), high.min(range.high));
            } else {
                keep(low, high.min(range.low));
                keep(low.max(range.high), high);
            }
        }
        std::mem::swap(&mut self.crossings, &mut self.clipped);
    }

    /// Computes the chords of the line at `lateral` [m] to the left of the tool centre point's line.
    fn cross(&mut self, lateral: f64) {
        self.crossings.clear();
        if lateral < self.low.y || lateral > self.high.y {
            return;
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
    }

    fn bin(&self, lateral: f64) -> usize {
        let bins = self.bin_start.len() - 1;
        let share = (lateral - self.low.y) / (self.high.y - self.low.y);
        ((share * bins as f64) as usize).min(bins - 1)
    }
}

impl Chords<'_> {
    /// Whether a particle `ahead` of the tool's start comes under the footprint during a stroke of `length`.
    fn covers(&self, ahead: f64, length: f64) -> bool {
        self.crossings
            .chunks_exact(2)
            .any(|chord| chord[0] <= ahead && ahead <= chord[1] + length)
    }

    /// Returns how far the footprint slides over a particle `ahead` of the tool's start during a stroke of `length`
    /// [m].
    fn slid(&self, ahead: f64, length: f64) -> f64 {
        let over = |chord: &[f64]| (ahead - chord[0]).min(length) - (ahead - chord[1]).max(0.0);
        let chords = self.crossings.chunks_exact(2);
        chords.map(|chord| over(chord).max(0.0)).sum()
    }

    /// Returns where a particle `ahead` of the tool's start is carried to by a stroke of `length`.
    ///
    /// The foremost chord that begins behind the particle reaches it first. All chords move alike, so no chord further
    /// back ever overtakes it.
    fn carried(&self, ahead: f64, length: f64) -> Option<f64> {
        let leading = self
            .crossings
            .chunks_exact(2)
            .take_while(|chord| chord[0] < ahead)
            .last()?[1];
        let carried = leading + length + CLEARANCE;
        (carried > ahead).then_some(carried)
    }
}
