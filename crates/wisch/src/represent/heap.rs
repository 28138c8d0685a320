//! Room that dirt needs when it is carried together.
//!
//! Particles do not touch each other in the effect model, so whatever a tool carries rides on one line. Real
//! dirt heaps up before the tool: some of it lies ahead of that line, falls over an edge that the tool does not
//! reach, and comes to rest elsewhere.

use super::{ParticleField, Surface, ToolMotion};
use crate::geometry::Vector2;
use crate::random::keyed_uniform;

/// Usual depth of a heap of all particles before a tool, over the radius r_s of the tool's collision sphere
/// [1]: what the simulated crumbs need before a sponge that comes at an angle.
pub const HEAP_DEPTH: f64 = 0.35;

/// Depth of a heap of a share of the particles, where one of all of them has `depth_of_all` [m]: the ground
/// that it covers grows with what lies in it.
pub fn heap_depth(depth_of_all: f64, share: f64) -> f64 {
    depth_of_all * share.max(0.0).sqrt()
}

/// Tell apart the random numbers for the place in a heap, ahead and beside.
const PLACES: [u64; 2] = [0x6865_6170_6168_6561, 0x6865_6170_7369_6465];

/// What a tool carries.
#[derive(Debug, Clone)]
pub(super) struct Heap {
    /// Depth of a heap of all particles [m].
    depth_of_all: f64,
    seed: u64,
    /// Contacts so far.
    contact: u32,
    /// The particles, by index in the distribution.
    carried: Vec<usize>,
    /// Direction of the motion.
    along: Vector2,
}

impl Heap {
    pub(super) const fn new(depth_of_all: f64, seed: u64) -> Self {
        Self {
            depth_of_all,
            seed,
            contact: 0,
            carried: Vec::new(),
            along: Vector2::new(0.0, 0.0),
        }
    }

    /// A motion begins.
    pub(super) fn begin(&mut self, motion: &ToolMotion) {
        self.carried.clear();
        self.along = motion.travel().0;
    }

    /// The motion carries a particle.
    pub(super) fn carry(&mut self, particle: usize) {
        self.carried.push(particle);
    }

    /// The motion is over: what lies ahead of the rest may have fallen. Returns how many did.
    pub(super) fn spill(&self, field: &mut ParticleField, surface: &Surface) -> usize {
        let fallen = self.carried.iter().filter(|&&particle| {
            let ahead = self.offset(particle, field).x;
            field.drop_beyond_edge(particle, surface, self.along * ahead)
        });
        fallen.count()
    }

    /// The tool has lifted off: the heap stays as it lies.
    pub(super) fn come_to_rest(&mut self, field: &mut ParticleField, surface: &Surface) {
        let side = Vector2::new(-self.along.y, self.along.x);
        for &particle in &self.carried {
            let offset = self.offset(particle, field);
            let by = self.along * offset.x + side * offset.y;
            field.displace(particle, surface, by);
        }
        self.carried.clear();
        self.contact += 1;
    }

    /// Where in the heap a particle lies, along the motion and beside it [m].
    fn offset(&self, particle: usize, field: &ParticleField) -> Vector2 {
        let share = self.carried.len() as f64 / field.len().max(1) as f64;
        let depth = heap_depth(self.depth_of_all, share);
        let [ahead, beside] =
            PLACES.map(|place| keyed_uniform(self.seed ^ place, particle as u64, self.contact));
        Vector2::new(ahead, beside - 0.5) * depth
    }
}
