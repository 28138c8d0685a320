//! Space that dirt takes when a tool carries it together.
//!
//! In the effect model particles do not touch each other, so everything that a tool carries is on one line. Real dirt
//! heaps up before the tool. Part of it lies ahead of that line, falls over an edge that the tool does not reach, and
//! comes to rest in other places. On a slope it comes to rest farther down.

use super::{ParticleField, Surface, ToolMotion};
use crate::geometry::{Pose, Vector2, Vector3};
use crate::random::keyed_uniform;

/// Usual depth of a heap of all particles before a tool, over the radius r_s of the tool's
/// collision sphere \[1\]. Simulated crumbs occupy this space before a sponge that moves at an
/// angle to its broad side.
pub const HEAP_DEPTH: f64 = 0.35;

/// Returns the depth \[m\] of a heap that holds this share of the particles, if a heap of all of them has `depth_of_all`
/// \[m\]: the covered area is proportional to the number of particles.
pub fn heap_depth(depth_of_all: f64, share: f64) -> f64 {
    // The area is proportional to the share, so the depth is to its square root.
    depth_of_all * share.max(0.0).sqrt()
}

/// Friction coefficient of dirt on a surface [1]: dirt rests on a slope of up to 42°. An assumption; simulated grains
/// have 0.8.
const FRICTION: f64 = 0.9;
/// Largest share of this friction that a slope takes up [1]; on a steeper slope, dirt slides by
/// itself.
const MAX_SHEDDING: f64 = 0.8;

/// Returns how much farther down a slope a carried heap comes to rest, as a multiple of its depth, in the surface frame
/// \[1\].
///
/// `along`: direction of the motion, a unit vector in the surface frame. The slope reduces or increases the friction
/// that stops the heap: 1 − tan θ/μ of it remains for a motion straight down, 1 + tan θ/μ for one straight up.
///
/// ```
/// # use wisch::geometry::*;
/// # use wisch::represent::*;
/// let tilted = |degrees: f64| Pose::from_parts(
///     nalgebra::Translation3::identity(),
///     nalgebra::UnitQuaternion::from_scaled_axis(Vector3::x() * degrees.to_radians()),
/// );
/// let down = -Vector2::y();
/// assert_eq!(heap_slide(&tilted(0.0), down).norm(), 0.0);
/// let (on_the_way_down, on_the_way_up) = (heap_slide(&tilted(30.0), down), heap_slide(&tilted(30.0), -down));
/// assert!((on_the_way_down - down * 1.79).norm() < 0.01 && (on_the_way_up - down * 0.39).norm() < 0.01);
/// ```
pub fn heap_slide(world_from_surface: &Pose, along: Vector2) -> Vector2 {
    let gravity = world_from_surface.rotation.inverse() * -Vector3::z();
    let across = gravity.xy();
    let Some(down) = across.try_normalize(f64::EPSILON) else {
        return Vector2::zeros();
    };
    let shedding = (across.norm() / (FRICTION * gravity.z.abs())).min(MAX_SHEDDING);
    down * (shedding / (1.0 - shedding * down.dot(&along)))
}

/// Keys of the random numbers for the place in a heap, ahead and beside.
const PLACES: [u64; 2] = [0x6865_6170_6168_6561, 0x6865_6170_7369_6465];

/// The particles that a tool carries.
#[derive(Debug, Clone)]
pub(super) struct Heap {
    /// Depth of a heap of all particles [m].
    depth_of_all: f64,
    seed: u64,
    /// Number of contacts so far.
    contact: u32,
    /// Carried particles, by index in the distribution.
    carried: Vec<usize>,
    /// Direction of the motion.
    along: Vector2,
    /// Extra slide of the heap down the slope, over its depth [1].
    slide: Vector2,
}

impl Heap {
    pub(super) const fn new(depth_of_all: f64, seed: u64) -> Self {
        Self {
            depth_of_all,
            seed,
            contact: 0,
            carried: Vec::new(),
            along: Vector2::new(0.0, 0.0),
            slide: Vector2::new(0.0, 0.0),
        }
    }

    /// Sets the number of contacts so far; nothing is carried.
    pub(super) fn resume(&mut self, contacts: u32) {
        self.carried.clear();
        self.contact = contacts;
    }

    /// Begins a motion.
    pub(super) fn begin(&mut self, motion: &ToolMotion, surface: &Surface) {
        self.carried.clear();
        self.along = motion.travel().0;
        self.slide = heap_slide(&surface.world_from_surface, self.along);
    }

    /// Records a particle that the motion carries.
    pub(super) fn carry(&mut self, particle: usize) {
        self.carried.push(particle);
    }

    /// Ends a motion: particles ahead of the heap's front edge may have fallen. Returns the number of fallen ones.
    pub(super) fn spill(&self, field: &mut ParticleField, surface: &Surface) -> usize {
        let fallen = self.carried.iter().filter(|&&particle| {
            let ahead = self.offset(particle, field).x;
            field.drop_beyond_edge(particle, surface, (self.along + self.slide) * ahead)
        });
        fallen.count()
    }

    /// Ends the contact: the heap comes to rest in its shape.
    pub(super) fn come_to_rest(&mut self, field: &mut ParticleField, surface: &Surface) {
        let side = Vector2::new(-self.along.y, self.along.x);
        for &particle in &self.carried {
            let offset = self.offset(particle, field);
            let by = (self.along + self.slide) * offset.x + side * offset.y;
            field.displace(particle, surface, by);
        }
        self.carried.clear();
        self.contact += 1;
    }

    /// Returns the place of a particle in the heap, along the motion and beside it [m].
    fn offset(&self, particle: usize, field: &ParticleField) -> Vector2 {
        let share = self.carried.len() as f64 / field.len().max(1) as f64;
        let depth = heap_depth(self.depth_of_all, share);
        let [ahead, beside] =
            PLACES.map(|place| keyed_uniform(self.seed ^ place, particle as u64, self.contact));
        Vector2::new(ahead, beside - 0.5) * depth
    }
}
