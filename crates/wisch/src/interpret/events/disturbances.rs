//! Detection of disturbances: pushes by people, and landings, overloads and vibrations that the robot causes itself.

use super::detector::{Candidate, EventDetector, Level, level};
use super::event::{Event, EventKind};
use crate::geometry::Vector3;

/// Least size of the mean force over the mean size of the force, at which a force has a direction [1], and the longest
/// time of that mean [s]. A person pushes in one direction for a while: random pushes reach 0.7 and more. The inertial
/// force of a long tool that the robot lifts oscillates about 0 and stays below 0.3.
const LEAST_STEADINESS: f64 = 0.5;
const SWING: f64 = 0.2;
/// Least time off the surface before an impact that makes this impact a landing of the tool, and
/// longest duration of the impact [s].
const TOUCHDOWN: [f64; 2] = [0.1, 0.3];

/// Time before a strong force within which its beginning is searched [s].
const RISE: f64 = 0.06;

/// Tail of a force that the sensor's low-pass filter extends: range of the time constant [s],
/// longest time between the contact and the tail [s], least number of pieces, largest deviation
/// from an exponential over the initial force [1], and largest initial force over that of the
/// contact [1].
const TAIL: [f64; 2] = [0.02, 1.0];
const BEFORE_TAIL: f64 = 0.1;
const FEWEST_IN_TAIL: usize = 4;
const MOST_OFF_TAIL: f64 = 0.12;
const MOST_OF_CONTACT: f64 = 1.2;

/// Share of a log above which all pushes together count as hand guiding [1].
const GUIDED_SHARE: f64 = 0.5;

impl EventDetector<'_> {
    /// Returns pushes, hand guiding, landings, overloads and vibrations, sorted by start. Stretches of one push are
    /// merged.
    pub(super) fn disturbances(&self) -> Vec<Event> {
        let mut candidates =
            self.candidates(|i| self.disturbance_level(i), |i| self.push_bridge(i));
        for candidate in &mut candidates {
            candidate.first = self.onset(candidate);
        }
        candidates.retain(|candidate| {
            !self.is_filter_tail(candidate)
                && !self.is_soft_contact(candidate)
                && !self.is_late_contact(candidate)
                && !self.is_high_friction(candidate)
        });
        let mut pushes: Vec<Candidate> = Vec::new();
        let mut others: Vec<(EventKind, Candidate)> = Vec::new();
        for candidate in candidates {
            let kind = self.cause(&candidate, pushes.last());
            match pushes.last_mut() {
                _ if kind != EventKind::Push => others.push((kind, candidate)),
                Some(before) if self.gap(before, &candidate) <= self.config.events.push_gap_s => {
                    before.last = candidate.last;
                }
                _ => pushes.push(candidate),
            }
        }
        let is_led = self.is_led(&pushes);
        let by_hand = pushes.into_iter().map(|push| {
            let is_long = self.duration(&push) > self.config.events.guiding_s;
            let kind = if is_led || is_long {
                EventKind::HandGuiding
            } else {
                EventKind::Push
            };
            (kind, push)
        });
        let mut disturbances: Vec<_> = by_hand.chain(others).collect();
        disturbances.sort_by_key(|(_, candidate)| candidate.first);
        (disturbances.iter())
            .map(|(kind, candidate)| self.describe(*kind, candidate.first, candidate.last))
            .collect()
    }

    /// Whether the force of a candidate is that of the contact before it, which a low-pass filter of the sensor lets decay
    /// exponentially while the tool rises.
    fn is_filter_tail(&self, candidate: &Candidate) -> bool {
        let [first, last] = [candidate.first, candidate.last];
        let begin = self.span(first)[0];
        let before = (0..first).rev();
        let before = before.take_while(|&i| begin - self.span(i)[1] <= BEFORE_TAIL);
        let contact = before
            .filter(|&i| self.is_touching(i))
            .map(|i| self.force(i).norm());
        let contact = contact.fold(0.0, f64::max);
        // Of F = F₀ exp(−t/τ), ln F is linear.
        let decay: Vec<[f64; 2]> = (first..=last)
            .map(|i| {
                let [start, end] = self.span(i);
                let size = self.force(i).norm();
                [
                    0.5 * (start + end) - begin,
                    libm::log(size.max(f64::MIN_POSITIVE)),
                ]
            })
            .collect();
        let count = decay.len() as f64;
        let [time, level] = [0, 1].map(|k| decay.iter().map(|at| at[k]).sum::<f64>() / count);
        let [mut square, mut product] = [0.0; 2];
        for at in &decay {
            square += (at[0] - time).powi(2);
            product += (at[0] - time) * (at[1] - level);
        }
        let rate = product / square;
        let fitted = |at: &[f64; 2]| libm::exp(level + rate * (at[0] - time));
        let off = decay
            .iter()
            .map(|at| (libm::exp(at[1]) - fitted(at)).powi(2))
            .sum::<f64>();
        let initial = fitted(&[0.0, 0.0]);
        let [shortest, longest] = TAIL.map(|time| -1.0 / time);
        decay.len() >= FEWEST_IN_TAIL
            && (shortest..=longest).contains(&rate)
            && (off / count).sqrt() <= MOST_OFF_TAIL * initial
            && initial <= MOST_OF_CONTACT * contact
            && self.path[last].height > self.path[first].height
            && self.path[last].height > self.config.events.collision_height_m
    }

    /// Returns the piece at which a candidate begins to rise to its first strong piece. Friction alone may exceed the
    /// lower threshold for long before.
    fn onset(&self, candidate: &Candidate) -> usize {
        let mut pieces = candidate.first..=candidate.last;
        let Some(strong) = pieces.find(|&i| self.disturbance_level(i) == Level::Strong) else {
            return candidate.first;
        };
        let mut onset = (strong, self.excess(strong));
        for i in (candidate.first..strong).rev() {
            if self.span(onset.0)[0] - self.span(i)[0] > RISE {
                break;
            }
            let excess = self.excess(i);
            if excess < onset.1 {
                onset = (i, excess);
            }
        }
        onset.0
    }

    /// Largest force beyond that of wiping, over all directions [N].
    fn excess(&self, i: usize) -> f64 {
        let piece = &self.path[i];
        let pressed = -piece.normal_force;
        let along = piece.tangential_force - self.friction.usual * pressed.max(0.0);
        let most = along.max(pressed - self.config.nominal_force());
        let compression = self.config.nominal_compression();
        let off = if compression > 0.0 {
            self.off_spring[i].max(0.0) * self.config.nominal_force() / compression
        } else {
            0.0
        };
        let held = if self.is_free(i) {
            piece.normal_force.hypot(piece.tangential_force)
        } else {
            0.0
        };
        most.max(off).max(held)
    }

    /// Returns the cause of a candidate: a push unless the robot causes it itself. `before` is the last push before it.
    fn cause(&self, candidate: &Candidate, before: Option<&Candidate>) -> EventKind {
        if !self.is_steady(candidate) {
            EventKind::Vibration
        } else if self.is_touchdown(candidate)
            || before.is_some_and(|push| self.is_landing(push, candidate))
        {
            EventKind::Landing
        } else if self.is_overload(candidate) {
            EventKind::Overload
        } else {
            EventKind::Push
        }
    }

    /// Whether pushes make up most of the log.
    fn is_led(&self, pushes: &[Candidate]) -> bool {
        let pushed: f64 = pushes.iter().map(|push| self.duration(push)).sum();
        let ends = (self.path.first().zip(self.path.last()))
            .map(|(first, last)| last.time[1] - first.time[0]);
        ends.is_some_and(|all| pushed > GUIDED_SHARE * all && pushed > self.config.events.guiding_s)
    }

    /// Time from the end of one candidate to the beginning of the next [s].
    fn gap(&self, before: &Candidate, next: &Candidate) -> f64 {
        self.span(next.first)[0] - self.span(before.last)[1]
    }

    /// Whether a candidate soon after a push is the released tool that comes down again: the surface presses it, and
    /// nothing pulls it along.
    fn is_landing(&self, before: &Candidate, next: &Candidate) -> bool {
        self.gap(before, next) <= self.config.events.landing_s && self.is_pressed(next)
    }

    /// Whether a candidate is the impact of the tool as it comes down on the surface.
    fn is_touchdown(&self, candidate: &Candidate) -> bool {
        let [before, longest] = TOUCHDOWN;
        let start = self.span(candidate.first)[0];
        let earlier = (0..candidate.first).rev();
        let mut earlier = earlier.take_while(|&i| self.span(i)[1] >= start - before);
        self.duration(candidate) <= longest
            && self.is_pressed(candidate)
            && earlier.any(|i| !self.is_touching(i))
    }

    /// Whether a candidate is a tool that is pressed onto the surface too hard, by robot or person: it compresses as
    /// the force demands, and is not pulled along.
    fn is_overload(&self, candidate: &Candidate) -> bool {
        let (mut pressed, mut other) = (0.0, 0.0);
        for i in candidate.first..=candidate.last {
            let [start, end] = self.span(i);
            if self
                .tangential_level(i)
                .max(self.free_force_level(i))
                .max(self.off_plane_level(i))
                == Level::Strong
            {
                other += end - start;
            } else if self.overload_level(i) == Level::Strong {
                pressed += end - start;
            }
        }
        pressed > other
    }

    /// Whether the force of a candidate is that of the surface rather than that of a pulling hand.
    fn is_pressed(&self, candidate: &Candidate) -> bool {
        let (mut drawn, mut pressed) = (0.0, 0.0);
        for i in candidate.first..=candidate.last {
            let [start, end] = self.span(i);
            if self.tangential_level(i).max(self.free_force_level(i)) == Level::Strong {
                drawn += end - start;
            } else if self.overload_level(i).max(self.off_plane_level(i)) == Level::Strong {
                pressed += end - start;
            }
        }
        pressed > drawn
    }

    /// Whether the force of a candidate has a direction for a while.
    fn is_steady(&self, candidate: &Candidate) -> bool {
        let (mut acting, mut all) = (0.0, 0.0);
        let (mut net, mut since) = (Vector3::zeros(), self.span(candidate.first)[0]);
        for i in candidate.first..=candidate.last {
            let [start, end] = self.span(i);
            if end - since > SWING {
                acting += net.norm();
                (net, since) = (Vector3::zeros(), start);
            }
            let impulse = self.force(i) * (end - start);
            net += impulse;
            all += impulse.norm();
        }
        acting + net.norm() >= LEAST_STEADINESS * all
    }

    pub(super) fn is_disturbed(&self, i: usize) -> bool {
        self.disturbance_level(i) != Level::Below
    }

    pub(super) fn disturbance_level(&self, i: usize) -> Level {
        self.off_plane_level(i)
            .max(self.tangential_level(i))
            .max(self.overload_level(i))
            .max(self.free_force_level(i))
    }

    /// Level of a contact force off the plane (Fig. 18). The event extends while the tool is off the position that its
    /// spring implies; it begins only where no stiffness of the tool explains the position.
    fn off_plane_level(&self, i: usize) -> Level {
        // Over an edge, a tool tips and sinks by itself.
        let is_sunk = || self.path[i].height < 0.0 && self.overhangs(i);
        if !self.has_plane || self.off_spring[i] <= 0.0 || is_sunk() {
            return Level::Below;
        }
        let events = &self.config.events;
        let share = self.path[i].normalized_force;
        let off = self.off[i];
        // The delay of the force makes a moving tool appear off the plane by this much.
        let lag = events.force_lag_s * self.climb(i);
        let far = events.collision_height_m + lag;
        level(
            self.off_spring[i] > lag && share >= events.collision_share[1],
            off > far && share >= events.collision_share[0],
        )
    }

    /// Level of a tangential force beyond friction.
    pub(super) fn tangential_level(&self, i: usize) -> Level {
        let events = &self.config.events;
        let piece = &self.path[i];
        let press = (-piece.normal_force).max(0.0);
        let beyond = |friction: f64| piece.tangential_force - friction * press;
        let [begin, end] = events.tangential_margin_n;
        level(
            beyond(self.friction.usual) > end,
            beyond(self.friction.limit) > begin,
        )
    }

    /// Level of a normal force far above the nominal one.
    fn overload_level(&self, i: usize) -> Level {
        let nominal = self.config.nominal_force();
        let noise = 2.0 * self.config.force_noise_n;
        let force = -self.path[i].normal_force - noise;
        let [begin, end] = self.config.events.overload;
        level(force > end * nominal, force > begin * nominal)
    }

    /// Whether the tool is in the air, where only a hand can act on it.
    fn is_free(&self, i: usize) -> bool {
        let events = &self.config.events;
        let lag = events.force_lag_s * self.climb(i);
        let least = if self.has_plane {
            events.near_height_m
        } else {
            self.config.search_height_m
        };
        self.path[i].height > least && self.off[i] > events.collision_height_m + lag
    }

    /// Level of a force of any direction in free motion.
    fn free_force_level(&self, i: usize) -> Level {
        if !self.is_free(i) {
            return Level::Below;
        }
        let piece = &self.path[i];
        let force = piece.normal_force.hypot(piece.tangential_force) - self.noise;
        let [begin, end] = self.config.events.free_force_n;
        level(force > end, force > begin)
    }

    /// Longest interruption of a push at a piece [s].
    fn push_bridge(&self, i: usize) -> f64 {
        let events = &self.config.events;
        if self.is_free(i) {
            events.free_bridge_s
        } else {
            events.bridge_s
        }
    }
}
