//! Particles in blocks of neighbours, so that a motion examines only the blocks near it.

use super::{Fate, ParticleDistribution, Surface};
use crate::geometry::{Bounds2, Point2, Vector2};
use std::ops::Range;

/// Number of particles per block: enough for vector instructions, and few enough to be close together.
pub(super) const BLOCK: usize = 32;
/// Number of blocks per group, which are skipped together.
const GROUP: usize = 64;

/// Index of a particle in the field's own order, in which neighbours in space are neighbours in memory.
pub(super) type Slot = u32;

/// Particles of a surface, sorted once into blocks of neighbours with their bounding boxes (sort-tile-recursive
/// packing).
///
/// A particle that moves stays in its block, whose box grows: that takes constant time and no allocation. The field
/// keeps its own copy of the positions, sorted by block; [`ParticleField::distribution`] returns them in the original
/// order.
#[derive(Debug, Clone)]
pub struct ParticleField {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Index in the original distribution, by slot.
    index: Vec<u32>,
    /// Slot, by index in the original distribution.
    slot: Vec<Slot>,
    /// Fate, by index in the original distribution.
    fate: Vec<Fate>,
    /// Number of particles of each block that are on the surface; they fill its first slots.
    present: Vec<u32>,
    /// Bounding box of the particles of each block.
    blocks: Vec<Bounds2>,
    groups: Vec<Bounds2>,
    remaining: usize,
}

/// A rectangle in which a motion may meet particles: `center ± half` along `axis` and to its left [m].
#[derive(Debug, Clone, Copy)]
pub(super) struct OrientedBox {
    pub(super) center: Point2,
    pub(super) axis: Vector2,
    pub(super) half: Vector2,
}

impl OrientedBox {
    /// Whether the rectangle shares a point with an axis-aligned box (separating axis test).
    fn meets(&self, other: &Bounds2) -> bool {
        let Self { axis, half, .. } = self;
        let apart = other.center() - self.center;
        let size = other.size() / 2.0;
        let [c, s] = [axis.x.abs(), axis.y.abs()];
        apart.x.abs() <= size.x + half.x * c + half.y * s
            && apart.y.abs() <= size.y + half.x * s + half.y * c
            && apart.dot(axis).abs() <= half.x + size.x * c + size.y * s
            && axis.perp(&apart).abs() <= half.y + size.x * s + size.y * c
    }

    /// Whether a point lies in the rectangle.
    pub(super) fn contains(&self, point: Point2) -> bool {
        let apart = point - self.center;
        (apart.dot(&self.axis).abs() <= self.half.x) & (self.axis.perp(&apart).abs() <= self.half.y)
    }
}

/// Bounds without a point.
const NOWHERE: Bounds2 = Bounds2 {
    min: Point2::new(f64::INFINITY, f64::INFINITY),
    max: Point2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
};

fn join(one: &Bounds2, other: &Bounds2) -> Bounds2 {
    Bounds2 {
        min: one.min.inf(&other.min),
        max: one.max.sup(&other.max),
    }
}

impl ParticleField {
    /// Sorts the particles into blocks. The cost is n log n in the number of particles.
    pub fn new(particles: &ParticleDistribution) -> Self {
        let count = particles.len();
        let (mut order, gone): (Vec<u32>, Vec<u32>) =
            (0..count as u32).partition(|&i| particles.fate[i as usize].is_on_surface());
        pack(&mut order, particles);
        let remaining = order.len();
        order.extend(gone);
        let blocks = remaining.div_ceil(BLOCK);
        let mut field = Self {
            x: order.iter().map(|&i| particles.x[i as usize]).collect(),
            y: order.iter().map(|&i| particles.y[i as usize]).collect(),
            slot: vec![0; count],
            fate: particles.fate.clone(),
            present: (0..blocks)
                .map(|block| BLOCK.min(remaining - block * BLOCK) as u32)
                .collect(),
            blocks: vec![NOWHERE; blocks],
            groups: vec![NOWHERE; blocks.div_ceil(GROUP)],
            index: order,
            remaining,
        };
        for (slot, &i) in field.index.iter().enumerate() {
            field.slot[i as usize] = slot as Slot;
        }
        (0..blocks).for_each(|block| field.refit(block));
        field
    }

    /// Returns the particles in their original order.
    pub fn distribution(&self) -> ParticleDistribution {
        let mut particles = ParticleDistribution {
            x: vec![0.0; self.x.len()],
            y: vec![0.0; self.x.len()],
            fate: vec![Fate::OnSurface; self.x.len()],
        };
        self.copy_to(&mut particles);
        particles
    }

    /// Writes the particles into the original distribution.
    pub(crate) fn copy_to(&self, particles: &mut ParticleDistribution) {
        for (slot, &i) in self.index.iter().enumerate() {
            particles.x[i as usize] = self.x[slot];
            particles.y[i as usize] = self.y[slot];
        }
        particles.fate.copy_from_slice(&self.fate);
    }

    /// Returns position and fate of particle `index` of the distribution.
    pub(crate) fn place(&self, index: usize) -> (Point2, Fate) {
        (self.position(self.slot[index]), self.fate[index])
    }

    /// Moves particle `index` of the distribution by a vector, or off the surface if the vector crosses an edge. A
    /// particle that is off the surface stays there.
    pub(super) fn displace(&mut self, index: usize, surface: &Surface, by: Vector2) {
        if self.fate[index].is_on_surface() && !self.drop_beyond_edge(index, surface, by) {
            let to = self.position(self.slot[index]) + by;
            self.relocate(index, to, self.fate[index]);
        }
    }

    /// Moves particle `index` of the distribution, which is on the surface, to a place \[m\] with a fate.
    pub(super) fn relocate(&mut self, index: usize, to: Point2, fate: Fate) {
        let slot = self.slot[index];
        if !fate.is_on_surface() {
            return self.remove(slot, to, fate);
        }
        self.put(slot, to);
        let block = slot as usize / BLOCK;
        self.blocks[block] = join(&self.blocks[block], &Bounds2 { min: to, max: to });
        self.regroup(block);
    }

    /// Removes particle `index` from the surface if a move by a vector crosses an edge; returns whether it does.
    pub(super) fn drop_beyond_edge(
        &mut self,
        index: usize,
        surface: &Surface,
        by: Vector2,
    ) -> bool {
        if !self.fate[index].is_on_surface() {
            return false;
        }
        let slot = self.slot[index];
        let from = self.position(slot);
        let edge = surface.exit_edge(from, from + by);
        if let Some(edge) = edge {
            let edge = u16::try_from(edge).unwrap_or(u16::MAX);
            self.remove(slot, from + by, Fate::OffSurface { edge });
        }
        edge.is_some()
    }

    /// Number of particles in all, on and off the surface.
    pub(super) fn len(&self) -> usize {
        self.index.len()
    }

    /// Number of particles that are still on the surface.
    pub fn remaining(&self) -> usize {
        self.remaining
    }

    /// Index in the original distribution of the particle in `slot`.
    pub(super) fn index(&self, slot: Slot) -> usize {
        self.index[slot as usize] as usize
    }

    /// Position of the particle in `slot` [m].
    pub(super) fn position(&self, slot: Slot) -> Point2 {
        Point2::new(self.x[slot as usize], self.y[slot as usize])
    }

    /// Moves a particle that stays on the surface; its block must be refitted afterwards.
    pub(super) fn put(&mut self, slot: Slot, to: Point2) {
        self.x[slot as usize] = to.x;
        self.y[slot as usize] = to.y;
    }

    /// Adds passes of a tool to a place of the surface.
    pub(super) fn treat(&mut self, slot: Slot, more: f64) {
        let index = self.index(slot);
        let fate = &mut self.fate[index];
        let passes = fate.passes() + more;
        *fate = Fate::Treated { passes };
    }

    /// Removes a particle from the surface, to `at`. The last particle of its block takes its slot.
    pub(super) fn remove(&mut self, slot: Slot, at: Point2, fate: Fate) {
        let slot = slot as usize;
        let block = slot / BLOCK;
        self.present[block] -= 1;
        let last = block * BLOCK + self.present[block] as usize;
        let (gone, other) = (self.index[slot] as usize, self.index[last] as usize);
        self.fate[gone] = fate;
        self.x[slot] = self.x[last];
        self.y[slot] = self.y[last];
        self.x[last] = at.x;
        self.y[last] = at.y;
        self.index.swap(slot, last);
        self.slot[other] = slot as Slot;
        self.slot[gone] = last as Slot;
        self.remaining -= 1;
    }

    /// Collects the blocks that may have a particle in the rectangle, in ascending order.
    pub(super) fn blocks_near(&self, near: &OrientedBox, found: &mut Vec<u32>) {
        found.clear();
        for (group, bounds) in self.groups.iter().enumerate() {
            if near.meets(bounds) {
                let first = group * GROUP;
                let last = (first + GROUP).min(self.blocks.len());
                let blocks = (first..last).zip(&self.blocks[first..last]);
                let met = blocks.filter(|(_, bounds)| near.meets(bounds));
                found.extend(met.map(|(block, _)| block as u32));
            }
        }
    }

    /// Slots of a block's particles that are on the surface.
    pub(super) fn slots(&self, block: u32) -> Range<Slot> {
        let first = block * BLOCK as u32;
        first..first + self.present[block as usize]
    }

    /// Coordinates of the particles in a range of slots [m].
    pub(super) fn coordinates(&self, slots: Range<Slot>) -> (&[f64], &[f64]) {
        let slots = slots.start as usize..slots.end as usize;
        (&self.x[slots.clone()], &self.y[slots])
    }

    /// Updates the bounds of a block after particles of it have moved.
    pub(super) fn refit(&mut self, block: usize) {
        let (x, y) = self.coordinates(self.slots(block as u32));
        let [(left, right), (bottom, top)] = [extent(x), extent(y)];
        self.blocks[block] = Bounds2 {
            min: Point2::new(left, bottom),
            max: Point2::new(right, top),
        };
        self.regroup(block);
    }

    fn regroup(&mut self, block: usize) {
        let group = &mut self.groups[block / GROUP];
        *group = join(group, &self.blocks[block]);
    }
}

/// Returns the smallest and the largest of `numbers`, without branches, so that the compiler vectorises it.
fn extent(numbers: &[f64]) -> (f64, f64) {
    const LANES: usize = 4;
    let mut low = [f64::INFINITY; LANES];
    let mut high = [f64::NEG_INFINITY; LANES];
    let mut take = |lane: usize, number: f64| {
        low[lane] = if number < low[lane] {
            number
        } else {
            low[lane]
        };
        high[lane] = if number > high[lane] {
            number
        } else {
            high[lane]
        };
    };
    let (whole, rest) = numbers.as_chunks::<LANES>();
    for chunk in whole {
        (0..LANES).for_each(|lane| take(lane, chunk[lane]));
    }
    rest.iter().for_each(|&number| take(0, number));
    (
        low.into_iter().fold(f64::INFINITY, f64::min),
        high.into_iter().fold(f64::NEG_INFINITY, f64::max),
    )
}

/// Sorts particles so that each run of [`BLOCK`] of them are neighbours: into slices along x, and each slice along y
/// (Leutenegger, Lopez and Edgington, 1997).
fn pack(order: &mut [u32], particles: &ParticleDistribution) {
    if order.len() <= BLOCK {
        return;
    }
    let sort = |order: &mut [u32], coordinates: &[f64]| {
        let mut keys: Vec<(f64, u32)> = (order.iter())
            .map(|&i| (coordinates[i as usize], i))
            .collect();
        keys.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        order
            .iter_mut()
            .zip(keys)
            .for_each(|(place, (_, i))| *place = i);
    };
    let bounds = Bounds2::from_points(order.iter().map(|&i| particles.position(i as usize)));
    let size = bounds.map_or(Vector2::zeros(), |bounds| bounds.size());
    let blocks = order.len().div_ceil(BLOCK);
    // As many slices as make the blocks about square.
    let slices = (blocks as f64 * size.x / size.y).sqrt().round();
    let slices = (slices as usize).clamp(1, blocks);
    sort(order, &particles.x);
    let per_slice = blocks.div_ceil(slices) * BLOCK;
    order
        .chunks_mut(per_slice)
        .for_each(|slice| sort(slice, &particles.y));
}
