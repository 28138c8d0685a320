//! Forces of contact at heights where a tool of the declared stiffness would not touch: those of a softer tool, and those that the
//! sensor reports late.

use super::detector::{Candidate, EventDetector, Level};
use crate::interpret::contact::median;

/// Longest time between a force and the contact that it leads to or comes from [s].
const LONGEST_GAP: f64 = 0.1;
/// Least number of pieces, and least way along the normal [m].
const FEWEST: usize = 6;
const LEAST_WAY: f64 = 4e-3;
/// Largest way back over the whole way [1]: the tool comes down, or rises, all the time.
const MOST_BACK: f64 = 0.1;
/// Largest force at the far end over that at the near end [1], and largest deviation from a linear spring over the latter [1].
const MOST_AT_END: f64 = 0.4;
const MOST_OFF: f64 = 0.1;
/// Range of the delay of the force at landings [s].
const DELAYS: std::ops::RangeInclusive<f64> = 0.05..=0.5;
/// Longest duration of a late force over that delay [1], and in addition to it [s].
const LONGEST: [f64; 2] = [1.5, 0.3];
/// Range of the first late force over the force of the contact before it [1].
const LIKE_CONTACT: std::ops::RangeInclusive<f64> = 0.6..=1.25;
/// Largest coefficient of friction that a force may show which vanishes with the normal force [1]; rubber on rubber has about 2.
const MOST_FRICTION: f64 = 2.0;
/// Range of a light normal force over the largest one of a candidate [1], longest time around the candidate in which it counts
/// [s], and least coefficient of friction there over that of the candidate [1].
const LOW_PRESS: [f64; 2] = [0.15, 0.5];
const AROUND: f64 = 1.0;
const LEAST_ALIKE: f64 = 0.6;
/// Force of a contact over the nominal one, and height over the compression, at which the tool has landed [1].
const LANDED: f64 = 0.5;

impl EventDetector<'_> {
    /// Whether the force of a candidate is that of a tool softer than declared: it rises in proportion to the way down until the
    /// contact that follows, or falls likewise on the way up. A hand exerts no force that the height determines.
    pub(super) fn is_soft_contact(&self, candidate: &Candidate) -> bool {
        let [first, last] = [candidate.first, candidate.last];
        let is_normal = (first..=last).all(|i| self.tangential_level(i) != Level::Strong);
        if !self.has_plane || last - first < FEWEST || !is_normal {
            return false;
        }
        let [begin, end] = [self.span(first)[0], self.span(last)[1]];
        let lands = (last..self.path.len())
            .take_while(|&i| self.span(i)[0] - end <= LONGEST_GAP)
            .any(|i| self.is_touching(i));
        let mut lifting = (0..=first)
            .rev()
            .take_while(|&i| begin - self.span(i)[1] <= LONGEST_GAP);
        let lifts = lifting.any(|i| self.is_touching(i));
        (lands && self.is_like_spring(first..=last, -1.0))
            || (lifts && self.is_like_spring(first..=last, 1.0))
    }

    /// Whether the tool moves along the normal in one direction, `sign`, and its normal force is linear in its height and small at
    /// the upper end.
    fn is_like_spring(&self, pieces: std::ops::RangeInclusive<usize>, sign: f64) -> bool {
        let at = |i: usize| [self.path[i].height, -self.path[i].normal_force];
        let [first, last] = [*pieces.start(), *pieces.end()].map(at);
        let way = sign * (last[0] - first[0]);
        let mut reached = f64::NEG_INFINITY;
        let back = pieces.clone().fold(0.0_f64, |back, i| {
            reached = reached.max(sign * self.path[i].height);
            back.max(reached - sign * self.path[i].height)
        });
        let [upper, lower] = if sign < 0.0 {
            [first, last]
        } else {
            [last, first]
        };
        if way < LEAST_WAY || back > MOST_BACK * way || upper[1] > MOST_AT_END * lower[1] {
            return false;
        }
        let count = pieces.clone().count() as f64;
        let mean = [0, 1].map(|k| pieces.clone().map(|i| at(i)[k]).sum::<f64>() / count);
        let [mut square, mut product] = [0.0; 2];
        for i in pieces.clone() {
            let [height, force] = at(i);
            square += (height - mean[0]).powi(2);
            product += (height - mean[0]) * (force - mean[1]);
        }
        let rate = product / square;
        // A hand that holds its force and lets go leaves a force that is constant over most of the way.
        let [at_upper, at_lower] = [upper, lower].map(|end| mean[1] + rate * (end[0] - mean[0]));
        let off = pieces.map(|i| {
            let [height, force] = at(i);
            (force - mean[1] - rate * (height - mean[0])).powi(2)
        });
        at_upper <= MOST_AT_END * at_lower
            && (off.sum::<f64>() / count).sqrt() <= MOST_OFF * lower[1]
    }

    /// Whether the force of a candidate is that of the contact before it, which the sensor reports late while the tool rises. The
    /// force is then late at the landings, too.
    pub(super) fn is_late_contact(&self, candidate: &Candidate) -> bool {
        let [first, last] = [candidate.first, candidate.last];
        let Some(delay) = self.landing_delay().filter(|delay| DELAYS.contains(delay)) else {
            return false;
        };
        let begin = self.span(first)[0];
        let before = (0..first).rev();
        let before = before.take_while(|&i| begin - self.span(i)[1] <= LONGEST_GAP + delay);
        let contact = before.filter(|&i| self.is_touching(i));
        let contact = median(contact.map(|i| (self.force(i).norm(), 1.0)).collect());
        let size = |i: usize| self.force(i).norm();
        let mut highest = f64::NEG_INFINITY;
        let rises = (first..=last).all(|i| {
            highest = highest.max(self.path[i].height);
            highest - self.path[i].height <= MOST_BACK * self.path[last].height.abs()
        });
        let most = (first..=last).map(size).fold(0.0, f64::max);
        contact > 0.0
            && rises
            && self.path[last].height - self.path[first].height >= LEAST_WAY
            && self.duration(candidate) <= LONGEST[0] * delay + LONGEST[1]
            && LIKE_CONTACT.contains(&(size(first) / contact))
            && most <= LIKE_CONTACT.end() * contact
            && size(last) <= MOST_AT_END * contact
    }

    /// Whether the force of a candidate is friction beyond the usual limit, as of a tool that sticks and hops: it varies with the
    /// normal force, and vanishes with it. The force of a hand does not depend on the normal force.
    pub(super) fn is_high_friction(&self, candidate: &Candidate) -> bool {
        let press = |i: usize| (-self.path[i].normal_force).max(0.0);
        let pieces = candidate.first..=candidate.last;
        let most = pieces.clone().map(press).fold(0.0, f64::max);
        let [begin, end] = [
            self.span(candidate.first)[0] - AROUND,
            self.span(candidate.last)[1] + AROUND,
        ];
        let is_pressed = |i: &usize| press(*i) > LOW_PRESS[0] * most;
        let before = (0..candidate.first).rev();
        let before = before.take_while(|&i| is_pressed(&i) && self.span(i)[1] >= begin);
        let after = candidate.last + 1..self.path.len();
        let after = after.take_while(|i| is_pressed(i) && self.span(*i)[0] <= end);
        let spell = candidate.first - before.count()..=candidate.last + after.count();
        let [_, margin] = self.config.events.tangential_margin_n;
        let is_friction =
            |i: usize| self.path[i].tangential_force <= MOST_FRICTION * press(i) + margin;
        let is_by_friction = |i: usize| {
            self.disturbance_level(i) != Level::Strong || self.tangential_level(i) == Level::Strong
        };
        let ratio = |i: usize| (self.path[i].tangential_force / press(i), 1.0);
        let [least, light] = LOW_PRESS.map(|share| share * most);
        let is_light = |i: &usize| (least..light).contains(&press(*i));
        let low: Vec<(f64, f64)> = spell.clone().filter(is_light).map(ratio).collect();
        let usual = median(pieces.clone().filter(is_pressed).map(ratio).collect());
        low.len() >= FEWEST
            && spell.clone().all(is_friction)
            && pieces.clone().all(is_by_friction)
            && median(low) >= LEAST_ALIKE * usual
    }

    /// Median time from a landing to its contact force [s]; `None` without a landing.
    fn landing_delay(&self) -> Option<f64> {
        let low = LANDED * self.config.nominal_compression();
        let least = LANDED * self.config.nominal_force();
        let mut delays: Vec<(f64, f64)> = Vec::new();
        let (mut is_up, mut landed) = (false, None);
        for (i, piece) in self.path.iter().enumerate() {
            let time = self.span(i)[0];
            if piece.height > self.config.events.near_height_m {
                (is_up, landed) = (true, None);
            } else if is_up && piece.height <= low {
                (is_up, landed) = (false, Some(time));
            }
            if let Some(since) = landed.filter(|_| -piece.normal_force >= least) {
                delays.push((time - since, 1.0));
                landed = None;
            }
        }
        (!delays.is_empty()).then(|| median(delays))
    }
}
