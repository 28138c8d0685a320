//! Dirt that is carried together needs room.
//!
//! In the effect model particles do not touch each other, so whatever a tool carries rides on one line. Real
//! dirt heaps up before the tool: some of it lies ahead of that line, falls over an edge that the tool does not
//! reach, and comes to rest elsewhere. How deep a heap is nobody measures, so each replay has a depth of its
//! own.

use super::chances::even;
use crate::geometry::Vector2;
use crate::represent::{ParticleField, Surface, ToolMotion, heap_depth};

/// Makes numbers of their own for the place in a heap, ahead and beside.
const PLACES: [u64; 2] = [0x6865_6170_6168_6561, 0x6865_6170_7369_6465];

/// What a tool carries in one replay.
#[derive(Debug)]
pub(super) struct Heap {
    /// Depth of a heap of all particles [m].
    depth_of_all: f64,
    key: u64,
    contact: u32,
    carried: Vec<usize>,
    along: Vector2,
}

impl Heap {
    pub(super) const fn new(depth_of_all: f64, key: u64) -> Self {
        Self {
            depth_of_all,
            key,
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
    pub(super) fn take(&mut self, particle: usize) {
        self.carried.push(particle);
    }

    /// The motion is over: what lies ahead of the rest may have fallen.
    pub(super) fn pass(&self, field: &mut ParticleField, surface: &Surface) {
        for &particle in &self.carried {
            let ahead = self.offset(particle, field).x;
            field.shove(particle, surface, self.along * ahead, false);
        }
    }

    /// The tool has lifted off: the heap stays as it lies.
    pub(super) fn rest(&mut self, field: &mut ParticleField, surface: &Surface) {
        let side = Vector2::new(-self.along.y, self.along.x);
        for &particle in &self.carried {
            let offset = self.offset(particle, field);
            let by = self.along * offset.x + side * offset.y;
            field.shove(particle, surface, by, true);
        }
        self.carried.clear();
        self.contact += 1;
    }

    /// Where in the heap a particle lies, along the motion and beside it [m].
    fn offset(&self, particle: usize, field: &ParticleField) -> Vector2 {
        let share = self.carried.len() as f64 / field.len().max(1) as f64;
        let depth = heap_depth(self.depth_of_all, share);
        let [ahead, beside] =
            PLACES.map(|place| even(self.key ^ place, particle as u64, self.contact));
        Vector2::new(ahead, beside - 0.5) * depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{PlanarPose, Point2, Polygon, Pose};
    use crate::represent::{Fate, ParticleDistribution};

    const COUNT: usize = 400;

    /// A heap of this depth that is pushed along x and comes to 1 cm before the edge at x = 0.2.
    fn pushed(depth: f64) -> ParticleDistribution {
        let board = Surface {
            name: "board".into(),
            outline: Polygon::rectangle(Vector2::new(0.4, 0.4)),
            world_from_surface: Pose::identity(),
            skim_edges: vec![],
        };
        let crumbs = ParticleDistribution::new(&[Point2::new(0.19, 0.0); COUNT]).unwrap();
        let mut field = ParticleField::new(&crumbs);
        let mut heap = Heap::new(depth, 1);
        heap.begin(&ToolMotion {
            from: PlanarPose::new(Point2::new(0.0, 0.0), 0.0),
            to: PlanarPose::new(Point2::new(0.1, 0.0), 0.0),
        });
        (0..COUNT).for_each(|particle| heap.take(particle));
        heap.pass(&mut field, &board);
        heap.rest(&mut field, &board);
        field.distribution()
    }

    #[test]
    fn what_has_no_room_before_the_edge_falls_and_the_rest_lies_apart() {
        let fallen = |particles: &ParticleDistribution| {
            let off = (0..COUNT).filter(|&i| particles.fate(i) == Fate::OffSurface { edge: 1 });
            off.count()
        };
        // Twice as deep as there is room: half of it.
        let deep = pushed(0.02);
        assert!((150..250).contains(&fallen(&deep)), "{}", fallen(&deep));
        let left = (0..COUNT).filter(|&i| deep.fate(i) == Fate::OnSurface);
        let places: Vec<Point2> = left.map(|i| deep.position(i)).collect();
        assert!(places.iter().all(|place| (0.19..0.2).contains(&place.x)));
        assert!(places.iter().any(|place| place.y < -0.008));
        assert!(places.iter().any(|place| place.y > 0.008));
        assert_eq!(fallen(&pushed(0.009)), 0);
        let flat = pushed(0.0);
        assert!((0..COUNT).all(|i| flat.position(i) == Point2::new(0.19, 0.0)));
    }
}
