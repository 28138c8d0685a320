//! Detection of stick-slip: the tool sticks, breaks loose, and sticks again.

use super::detector::EventDetector;
use super::event::{Event, EventKind};
use crate::geometry::Vector2;

/// Half the time window of the mean speed [s].
const WINDOW: f64 = 0.25;
/// Share of the mean speed below which the tool sticks, and above which it slips [1].
const STUCK: f64 = 0.3;
const SLIPPING: f64 = 1.4;
/// Longest time between two turns of one stick-slip [s]; slower changes are stops of the plan.
const LONGEST_TURN: f64 = 0.25;
/// Least travel over which a speed is measured [m]: a position error of 0.1 mm changes it by a seventh.
const LEAST_WAY: f64 = 1e-3;
/// Least mean speed at which stick-slip can be detected [m/s]: at a slower one this travel takes as long as a slip.
const SLOWEST: f64 = 0.015;
/// Longest time between two runs of turns of one stick-slip [s]: noise occasionally hides a turn.
const BRIDGE: f64 = 0.5;
/// Least change of the tangential force between sticking and slipping [N].
const LEAST_FORCE: f64 = 1.0;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Gait {
    Stuck,
    Slipping,
}

/// A change from sticking to slipping or back.
#[derive(Debug, Clone, Copy)]
struct Turn {
    piece: usize,
    to: Gait,
    /// Largest tangential force since the turn before [N].
    peak: f64,
    /// Least tangential force since the turn before [N].
    least: f64,
}

impl EventDetector<'_> {
    /// Returns the stick-slip events: runs of turns in quick succession.
    pub(super) fn stick_slips(&self) -> Vec<Event> {
        let turns = self.turns();
        let together = |a: &Turn, b: &Turn| {
            self.path[b.piece].time[1] - self.path[a.piece].time[1] <= LONGEST_TURN
                && b.peak - b.least >= LEAST_FORCE
                && self.all_touching(a.piece, b.piece)
        };
        let runs = turns
            .chunk_by(together)
            .filter(|run| run.len() >= self.config.events.stick_slip_turns)
            .map(|run| {
                // A tool that stands before a stroke does not stick: the event begins with the first slip.
                let first = usize::from(run[0].to == Gait::Stuck);
                [run[first].piece, run[run.len() - 1].piece]
            });
        let mut stick_slips: Vec<[usize; 2]> = Vec::new();
        for [first, last] in runs {
            match stick_slips.last_mut() {
                Some([_, end])
                    if self.path[first].time[0] - self.path[*end].time[1] <= BRIDGE
                        && self.all_touching(*end, first) =>
                {
                    *end = last;
                }
                _ => stick_slips.push([first, last]),
            }
        }
        let described =
            |[first, last]: [usize; 2]| self.describe(EventKind::StickSlip, first, last);
        stick_slips.into_iter().map(described).collect()
    }

    fn all_touching(&self, first: usize, last: usize) -> bool {
        (first..=last).all(|i| self.is_touching(i))
    }

    /// Returns the speed along the mean velocity at a piece that has two neighbours [m/s]. It is taken over as many
    /// neighbours as the least travel demands; across the mean velocity there is only noise.
    fn speed(&self, i: usize, mean: Vector2) -> f64 {
        let last = self.path.len() - 1;
        let (mut before, mut after) = (i - 1, i + 1);
        let time =
            |before: usize, after: usize| self.path[after].time[1] - self.path[before].time[1];
        while mean.norm() * time(before, after) < LEAST_WAY && before > 0 && after < last {
            (before, after) = (before - 1, after + 1);
        }
        let way = (self.path[after].position - self.path[before].position).xy();
        way.dot(&mean.normalize()).abs() / time(before, after)
    }

    fn turns(&self) -> Vec<Turn> {
        let mut turns: Vec<Turn> = Vec::new();
        let (mut first, mut last) = (0, 0);
        let (mut peak, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut gait = Gait::Slipping;
        for i in 1..self.path.len().saturating_sub(1) {
            let now = self.path[i].time[1];
            while self.path[first].time[1] < now - WINDOW {
                first += 1;
            }
            while last + 1 < self.path.len() && self.path[last].time[1] < now + WINDOW {
                last += 1;
            }
            // The net displacement, as noise lengthens the path.
            let net = (self.path[last].position - self.path[first].position).xy();
            let velocity = net / (self.path[last].time[1] - self.path[first].time[1]);
            let mean = velocity.norm();
            peak = peak.max(self.path[i].tangential_force);
            least = least.min(self.path[i].tangential_force);
            if mean < SLOWEST || !self.is_touching(i) {
                continue;
            }
            let speed = self.speed(i, velocity);
            let next = match gait {
                Gait::Slipping if speed < STUCK * mean => Gait::Stuck,
                Gait::Stuck if speed > SLIPPING * mean => Gait::Slipping,
                same => same,
            };
            if next != gait {
                gait = next;
                turns.push(Turn {
                    piece: i,
                    to: gait,
                    peak,
                    least,
                });
                (peak, least) = (f64::NEG_INFINITY, f64::INFINITY);
            }
        }
        turns
    }
}
