//! Poses of the tool at times without a force, before the first sample of a log and after its last.

use super::contact::ClassifiedPath;
use super::doubt::NEAR;
use crate::geometry::{Point3, Pose};
use crate::represent::Surface;

/// Largest distance from the found surface at which a tool without measured force counts as sliding on it [m].
const ON_SURFACE: f64 = 5e-3;
/// Least time between two poses that are kept, and largest time between two that follow each other [s].
const BETWEEN_POSES: f64 = 0.02;
const LONGEST_BETWEEN: f64 = 0.5;
/// Number of poses from which every second one is left out.
const MOST_POSES: usize = 200_000;
/// Least travel on the surface without a force that may have wiped [m].
const LEAST_SLIDING: f64 = 0.02;

/// Positions of the tool without a force, a bounded number.
#[derive(Debug, Clone)]
pub(super) struct PosesAlone {
    /// Times [s], and positions in the world [m].
    places: Vec<(f64, Point3)>,
    /// Least time between two of them [s].
    between: f64,
}

impl Default for PosesAlone {
    fn default() -> Self {
        Self {
            places: Vec::new(),
            between: BETWEEN_POSES,
        }
    }
}

impl PosesAlone {
    /// Keeps the position at a time [s] if it is late enough after the one before.
    pub(super) fn note(&mut self, time: f64, world_from_tool: &Pose) {
        let place: Point3 = world_from_tool.translation.vector.into();
        let is_valid = time.is_finite() && place.iter().all(|part| part.is_finite());
        let last = self.places.last();
        if !is_valid || last.is_some_and(|(last, _)| time - last < self.between) {
            return;
        }
        self.places.push((time, place));
        if self.places.len() >= MOST_POSES {
            let mut number = 0;
            self.places.retain(|_| {
                number += 1;
                number % 2 == 1
            });
            self.between *= 2.0;
        }
    }

    /// Returns the time in which the tool slid on the surface that a log shows [s]; `None` if it slid too little to wipe.
    pub(super) fn time_on(&self, surface: &Surface, classified: &ClassifiedPath) -> Option<f64> {
        let surface_from_world = surface.world_from_surface.inverse();
        let is_known = classified.registration.is_some() || classified.plane.is_some();
        let near = if is_known { ON_SURFACE } else { NEAR };
        let is_on = |place: &Point3| {
            let place = surface_from_world * place;
            let at = surface.shape.chart(place);
            let in_chart = Point3::new(at.place.x, at.place.y, at.height);
            let height = match (&classified.registration, &classified.plane) {
                (Some(fit), _) => fit.height(&surface.shape, place),
                (None, Some((plane, _))) => plane.distance(in_chart),
                (None, None) => in_chart.z,
            };
            height.abs() <= near && surface.outline.contains(at.place)
        };
        let longest = LONGEST_BETWEEN.max(2.0 * self.between);
        let (mut time, mut travel) = (0.0, 0.0);
        for pair in self.places.windows(2) {
            let [(start, from), (end, to)] = [&pair[0], &pair[1]];
            if end - start <= longest && is_on(from) && is_on(to) {
                time += end - start;
                travel += (to - from).norm();
            }
        }
        (travel >= LEAST_SLIDING).then_some(time)
    }
}
