//! Likelihood of the camera observations of particles that were exposed to a tool.
//!
//! The association of detections before and after a round is unknown. If particles lie so close that one detection may
//! be of several of them, the likelihood is the sum over all associations: each detection belongs to one particle or
//! none, and each particle has at most one detection. This is joint probabilistic data association (Bar-Shalom and
//! Fortmann 1988). A particle of another group, farther off, is assumed to be still there with probability 0.5. Groups
//! too large for the sum are left out.

use super::error::LearnError;
use crate::geometry::Point2;
use crate::interpret::Exposure;
use crate::represent::{Observation, Sight};

/// Largest distance between the detections of a particle that stays, in standard deviations of their difference [1].
const GATE: f64 = 3.0;
/// Probability that they are closer, by a Rayleigh distribution.
const WITHIN_GATE: f64 = 0.988_891;
/// Least standard deviation of a position [m].
const LEAST_DEVIATION: f64 = 1e-4;
/// Largest group of particles for which all associations are summed.
const MOST_JOINT: usize = 8;
/// Radius over which unassociated detections give the density of further ones [m].
const NEIGHBOURHOOD: f64 = 0.02;
/// Least density of clutter, that is of detections of no known particle [1/m²].
const LEAST_CLUTTER: f64 = 1e-3;
/// Least probability that a detection before the round is dirt [1].
const LEAST_REAL: f64 = 0.05;
/// Probability that a particle of another group is still there [1].
const OTHERS: f64 = 0.5;
/// Least likelihood, as its logarithm must be finite.
const LEAST_LIKELIHOOD: f64 = 1e-300;

/// A round of wiping with observations before and after it; places in the frame of the believed surface.
#[derive(Debug, Clone, PartialEq)]
pub struct ObservedRound {
    /// Observation before the round.
    pub before: Observation,
    /// Observation after the round.
    pub after: Observation,
    /// Detection rate and sensor noise.
    pub sight: Sight,
    /// Area of the surface \[m²\].
    pub area_m2: f64,
    /// Exposure of each detection of `before` to the tool, with one entry per guess; see
    /// [`Interpreter::exposures`](crate::interpret::Interpreter::exposures).
    pub exposures: Vec<Vec<Exposure>>,
    /// Largest f′ at each detection of `before` in earlier rounds since its dirt was first detected
    /// there, by guess \[1\]; empty if there was none. A particle that keeps its threshold and is
    /// still there has a threshold above this value.
    pub earlier: Vec<Vec<f64>>,
}

/// A round as input of the likelihood.
pub(super) struct RoundEvidence<'a> {
    pub(super) groups: Vec<Group<'a>>,
}

/// Particles that may share detections.
pub(super) struct Group<'a> {
    pub(super) members: Vec<Member<'a>>,
    pub(super) seen: Seen,
}

/// A particle that was detected before the round and whose place was observed after it.
pub(super) struct Member<'a> {
    /// Probability that it is dirt, and detected if it stayed [1].
    pub(super) detected: f64,
    pub(super) exposures: &'a [Exposure],
    /// Largest earlier f′ by guess; empty if there was none.
    pub(super) earlier: &'a [f64],
}

/// Detections after the round near a group. Each has, per member, the ratio of its likelihood as that member to its
/// likelihood as clutter [1].
pub(super) struct Seen(Vec<Vec<f64>>);

impl<'a> RoundEvidence<'a> {
    pub(super) fn of(
        round: &'a ObservedRound,
        index: usize,
        law: &dyn Fn() -> String,
    ) -> Result<Self, LearnError> {
        round.check_counts(index, law)?;
        round.check_ranges(index, law)?;
        let detections = RoundDetections::of(round);
        let mut groups = connected_groups(&detections.places, detections.gate());
        groups.retain(|group| group.len() <= MOST_JOINT);
        let groups = groups.iter().map(|group| detections.group(group));
        // Groups that the tool did not touch carry no information about the law.
        let groups = groups.filter(|group| group.members.iter().any(Member::is_touched));
        Ok(Self {
            groups: groups.collect(),
        })
    }

    /// Number of particles that were touched and then observed.
    pub(super) fn observed(&self) -> usize {
        let members = self.groups.iter().flat_map(|group| &group.members);
        members.filter(|member| member.is_touched()).count()
    }
}

impl ObservedRound {
    /// Checks that each detection before the round has its exposures, and an earlier f′ if any detection has.
    fn check_counts(&self, index: usize, law: &dyn Fn() -> String) -> Result<(), LearnError> {
        let expected = self.before.detections.len();
        let found = [
            ("exposures", self.exposures.len(), true),
            ("earlier", self.earlier.len(), !self.earlier.is_empty()),
        ];
        for (field, found, is_given) in found {
            if is_given && found != expected {
                return Err(LearnError::Mismatch {
                    law: law(),
                    round: index,
                    field,
                    found,
                    expected,
                });
            }
        }
        Ok(())
    }

    /// Checks that the area and the sensor's properties are within their limits.
    fn check_ranges(&self, index: usize, law: &dyn Fn() -> String) -> Result<(), LearnError> {
        let Sight { sensor, detection } = self.sight;
        let (alarms, error) = (sensor.false_alarms_per_m2, sensor.position_error_m);
        for (field, value, limits, expected) in [
            ("area_m2", self.area_m2, 1e-9..=1e6, "1e-9 to 1e6 m²"),
            ("detection", detection, 1e-3..=1.0, "0.001 to 1"),
            ("false_alarms_per_m2", alarms, 0.0..=1e9, "0 to 1e9 1/m²"),
            ("position_error_m", error, 0.0..=1.0, "0 to 1 m"),
        ] {
            if !limits.contains(&value) {
                return Err(LearnError::OutOfRange {
                    law: law(),
                    round: index,
                    field,
                    value,
                    expected,
                });
            }
        }
        Ok(())
    }
}

/// Detections of a round, with the densities that associate those before with those after.
struct RoundDetections<'a> {
    round: &'a ObservedRound,
    /// Indices of detections before the round whose places were observed after it.
    observed_indices: Vec<usize>,
    places: Vec<Point2>,
    /// Detections after the round that belong to none of them.
    unrelated: Vec<Point2>,
    /// Standard deviation of the difference of two detections of a particle that stays [m].
    deviation: f64,
    /// Probability that a detection before the round is dirt [1].
    real: f64,
    /// Mean density of clutter after the round [1/m²].
    base: f64,
}

impl<'a> RoundDetections<'a> {
    fn of(round: &'a ObservedRound) -> Self {
        let (before, after) = (&round.before.detections, &round.after.detections);
        let Sight { sensor, detection } = round.sight;
        let alarms = sensor.false_alarms_per_m2 * round.area_m2;
        let real = (1.0 - alarms / before.len().max(1) as f64).clamp(LEAST_REAL, 1.0);
        // Expected number of grains that were missed before and are detected now.
        let missed = before.len() as f64 * real * (1.0 - detection);
        let observed_indices: Vec<usize> = (0..before.len())
            .filter(|&i| !round.after.is_hidden(before[i]) && !round.exposures[i].is_empty())
            .collect();
        let places: Vec<Point2> = observed_indices.iter().map(|&i| before[i]).collect();
        let deviation = 2.0_f64.sqrt() * sensor.position_error_m.max(LEAST_DEVIATION);
        let nearest = |place: &Point2| {
            let distances = places.iter().map(|known| (known - place).norm());
            distances.fold(f64::INFINITY, f64::min)
        };
        let unrelated = (after.iter().copied()).filter(|place| nearest(place) > GATE * deviation);
        Self {
            round,
            unrelated: unrelated.collect(),
            observed_indices,
            places,
            deviation,
            real,
            base: sensor.false_alarms_per_m2 + missed / round.area_m2,
        }
    }

    /// Largest distance between the detections of a particle that stays [m].
    fn gate(&self) -> f64 {
        GATE * self.deviation
    }

    /// Returns the particles at these indices, with the detections after the round that may be of them.
    fn group(&self, group: &[usize]) -> Group<'a> {
        let round = self.round;
        let members = group.iter().map(|&k| {
            let i = self.observed_indices[k];
            Member {
                detected: self.real * round.sight.detection,
                exposures: &round.exposures[i],
                earlier: round.earlier.get(i).map_or(&[][..], Vec::as_slice),
            }
        });
        let is_near = |place: &&Point2| {
            (group.iter()).any(|&k| (self.places[k] - **place).norm() <= self.gate())
        };
        let related = round.after.detections.iter().filter(is_near);
        Group {
            members: members.collect(),
            seen: Seen(related.map(|place| self.ratios(place, group)).collect()),
        }
    }

    /// Returns, for each member of a group, the likelihood ratio of a detection as that member against clutter [1].
    fn ratios(&self, place: &Point2, group: &[usize]) -> Vec<f64> {
        let others = (0..self.places.len()).filter(|k| !group.contains(k));
        let others: f64 = others.map(|k| self.density(place, &self.places[k])).sum();
        let detection = self.round.sight.detection;
        let clutter = self.clutter(place) + OTHERS * self.real * detection * others;
        let members = group.iter().map(|&k| &self.places[k]);
        members
            .map(|from| self.density(place, from) / clutter)
            .collect()
    }

    /// Returns the density of clutter near a place [1/m²].
    fn clutter(&self, place: &Point2) -> f64 {
        let circle = std::f64::consts::PI * NEIGHBOURHOOD * NEIGHBOURHOOD;
        let is_close = |other: &&Point2| (*other - place).norm() <= NEIGHBOURHOOD;
        let close = self.unrelated.iter().filter(is_close).count();
        (self.base + close as f64 / circle).max(LEAST_CLUTTER)
    }

    /// Returns the probability density of a detection at `place` of a particle that was detected at `from` [1/m²].
    fn density(&self, place: &Point2, from: &Point2) -> f64 {
        let variance = self.deviation * self.deviation;
        let squared = (place - from).norm_squared() / variance;
        if squared > GATE * GATE {
            return 0.0;
        }
        libm::exp(-0.5 * squared) / (std::f64::consts::TAU * self.deviation * self.deviation)
    }
}

impl Member<'_> {
    fn is_touched(&self) -> bool {
        self.exposures.iter().any(Exposure::is_touched)
    }
}

impl Seen {
    /// Returns the natural logarithm of the likelihood, given for each member the probability that it is dirt, stays
    /// and is detected [1]. `work` is scratch memory.
    pub(super) fn log_likelihood(&self, detected: &[f64], work: &mut Vec<f64>) -> f64 {
        let likelihood = match detected {
            [one] => {
                let ratios: f64 = self.0.iter().map(|ratios| ratios[0]).sum();
                1.0 + one * (ratios - WITHIN_GATE)
            }
            many => joint(&self.0, many, work),
        };
        libm::log(likelihood.max(LEAST_LIKELIHOOD))
    }
}

/// Returns the sum over all associations of detections with members, by dynamic programming: `ways[set]` is the sum
/// over those in which exactly the members of `set` are detected.
fn joint(detections: &[Vec<f64>], detected: &[f64], ways: &mut Vec<f64>) -> f64 {
    let sets = 1 << detected.len();
    ways.clear();
    ways.resize(sets, 0.0);
    ways[0] = 1.0;
    for ratios in detections {
        // From the largest set down, so that no detection counts twice.
        for set in (1..sets).rev() {
            let mut sum = ways[set];
            for (member, (ratio, detected)) in ratios.iter().zip(detected).enumerate() {
                if set >> member & 1 == 1 {
                    sum += ways[set ^ (1 << member)] * ratio * detected;
                }
            }
            ways[set] = sum;
        }
    }
    let unseen = |set: usize| {
        let others = detected.iter().enumerate();
        let others = others.filter(|(member, _)| set >> member & 1 == 0);
        others
            .map(|(_, detected)| 1.0 - detected * WITHIN_GATE)
            .product::<f64>()
    };
    (0..sets).map(|set| ways[set] * unseen(set)).sum()
}

/// Returns the connected groups of places, linked by distances of at most `distance` [m].
fn connected_groups(places: &[Point2], distance: f64) -> Vec<Vec<usize>> {
    let mut is_taken = vec![false; places.len()];
    let mut groups = Vec::new();
    for first in 0..places.len() {
        if is_taken[first] {
            continue;
        }
        is_taken[first] = true;
        let mut group = vec![first];
        let mut next = 0;
        while let Some(&at) = group.get(next) {
            next += 1;
            for other in 0..places.len() {
                if !is_taken[other] && (places[other] - places[at]).norm() <= distance {
                    is_taken[other] = true;
                    group.push(other);
                }
            }
        }
        groups.push(group);
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_over_associations_equals_their_enumeration() {
        // Two members, two detections, the second of which may be of either.
        let ratios = [vec![5.0, 0.0], vec![2.0, 3.0]];
        let [a, b] = [0.7, 0.4];
        let (not_a, not_b) = (1.0 - a * WITHIN_GATE, 1.0 - b * WITHIN_GATE);
        let by_hand =
            not_a * not_b + 5.0 * a * not_b + 2.0 * a * not_b + 3.0 * b * not_a + 5.0 * a * 3.0 * b;
        let seen = Seen(ratios.to_vec());
        let found = seen.log_likelihood(&[a, b], &mut Vec::new());
        assert!((found - by_hand.ln()).abs() < 1e-12);
        // Alone, a member is a special case of it.
        let alone = Seen(vec![vec![5.0], vec![2.0]]);
        let summed = joint(&[vec![5.0], vec![2.0]], &[a], &mut Vec::new());
        let found = alone.log_likelihood(&[a], &mut Vec::new());
        assert!((found - summed.ln()).abs() < 1e-12);
    }

    #[test]
    fn close_places_form_a_group() {
        let at = |x: f64| Point2::new(x, 0.0);
        let groups = connected_groups(&[at(0.0), at(0.9), at(3.0), at(1.8)], 1.0);
        assert_eq!(groups, [vec![0, 1, 3], vec![2]]);
    }
}
