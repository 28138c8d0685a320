//! Whether an observation contradicts the places of known dirt, as if its frame were turned, mirrored or shifted.

use super::ensemble::Belief;
use super::sight::{MATCHED, ObservationUpdate};
use crate::geometry::{Point2, PointGrid};
use crate::interpret::doubt::Doubt;
use crate::represent::Fate;

/// Largest number of members that are compared with the observation.
const COMPARED: usize = 32;
/// Usual error of known places, along x and along y [m].
const PLACE_ERROR: f64 = 1.5e-3;
/// Share of a member's untouched dirt that another member must have at the same places, if the places are known [1].
const AGREEING: f64 = 0.8;
/// Least number of known places that the tool did not touch, and of detections without known dirt.
const FEWEST: f64 = 5.0;
/// Largest share of the expected detections of untouched dirt, and least share of detections without known dirt, in an
/// observation of another frame [1].
const MOST_SEEN: f64 = 0.5;
const LEAST_UNKNOWN: f64 = 0.5;
/// Standard deviations within which numbers of detections scatter [1].
const DEVIATIONS: f64 = 3.0;

/// Places of one member's dirt.
struct Places {
    /// All places, those of dirt that is gone included.
    all: Vec<Point2>,
    /// Visible places of dirt that the tool never touched.
    untouched: Vec<Point2>,
}

impl ObservationUpdate<'_> {
    /// Returns a doubt if the places of the detections contradict the belief, whatever their number: known dirt that the
    /// tool did not touch is not seen again, and most detections lie where no member has ever had dirt. False alarms, missed
    /// dirt, and dirt that the tool moved cause only one of the two.
    pub(in crate::interpret) fn find_other_frame(&self, belief: &Belief) -> Option<Doubt> {
        let detections = &self.observation.detections;
        let detection = self.sight.detection;
        if belief.is_certain() || detection <= 0.0 || (detections.len() as f64) < FEWEST {
            return None;
        }
        let radius = MATCHED * self.sight.sensor.position_error_m.hypot(PLACE_ERROR);
        let count = belief.members().len();
        let step = count.div_ceil(COMPARED);
        let compared: Vec<Places> = (0..count)
            .step_by(step)
            .map(|member| self.places_of(belief, member))
            .collect();
        let seen = PointGrid::from_points(detections, radius);
        // Sums over the members: untouched places, those seen again, those of the next member, and detections without dirt.
        let mut sums = [0.0; 4];
        for (k, places) in compared.iter().enumerate() {
            let own = PointGrid::from_points(&places.all, radius);
            let next = &compared[(k + 1) % compared.len()].untouched;
            let near = |grid: &PointGrid, of: &[Point2]| {
                of.iter()
                    .filter(|place| grid.has_within(**place, radius, |_, _| true))
                    .count() as f64
            };
            sums[0] += places.untouched.len() as f64;
            sums[1] += near(&seen, &places.untouched);
            sums[2] += near(&own, next);
            sums[3] += detections.len() as f64 - near(&own, detections);
        }
        let [untouched, again, agreeing, unknown] = sums.map(|sum| sum / compared.len() as f64);
        let expected = detection * untouched;
        let scatter = DEVIATIONS * (expected * (1.0 - detection)).sqrt();
        let alarms = self.false_alarms();
        let is_other_frame = untouched >= FEWEST
            && agreeing >= AGREEING * untouched
            && again < (MOST_SEEN * expected).min(expected - scatter)
            && unknown >= (LEAST_UNKNOWN * detections.len() as f64).max(FEWEST)
            && unknown > alarms + DEVIATIONS * alarms.sqrt();
        is_other_frame.then(|| Doubt::ObservationInOtherFrame {
            untouched: untouched.round() as usize,
            seen_again: again.round() as usize,
            unknown: unknown.round() as usize,
            of: detections.len(),
        })
    }

    /// Returns the places of a member's dirt.
    fn places_of(&self, belief: &Belief, member: usize) -> Places {
        let dirt = &belief.members()[member];
        let state = belief.states.get(member);
        let is_untouched = |(i, (place, fate)): &(usize, (Point2, Fate))| {
            fate.is_on_surface()
                && !self.observation.is_hidden(*place)
                && state.is_none_or(|state| !state.activation.is_touched(*i))
        };
        Places {
            all: dirt.iter().map(|(place, _)| place).collect(),
            untouched: (dirt.iter().enumerate())
                .filter(is_untouched)
                .map(|(_, (place, _))| place)
                .collect(),
        }
    }
}
