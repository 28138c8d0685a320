//! Stick-slip: the tool stands, tears itself loose, and stands again.

use super::detector::EventDetector;
use super::event::{Event, EventKind};

/// Half the time over which the mean speed is taken [s].
const WINDOW: f64 = 0.25;
/// Share of the mean speed below which the tool sticks, and that above which it slips [1].
const STUCK: f64 = 0.3;
const SLIPPING: f64 = 1.4;
/// Longest time between two turns of the same stick-slip [s]: slower ones are the plan's own stops.
const LONGEST_TURN: f64 = 0.25;
/// Slowest mean speed at which it can be detected [m/s]: positions off by 0.1 mm look like half of it.
const SLOWEST: f64 = 0.03;
/// Least change of the force along the surface between stuck and slipping [N].
const LEAST_FORCE: f64 = 1.0;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Gait {
    Stuck,
    Slipping,
}

/// A change from stuck to slipping or back.
#[derive(Debug, Clone, Copy)]
struct Turn {
    piece: usize,
    to: Gait,
    /// Largest force along the surface since the turn before [N].
    peak: f64,
    /// Smallest [N].
    least: f64,
}

impl EventDetector<'_> {
    /// Runs of turns, one soon after the other.
    pub(super) fn stick_slips(&self) -> Vec<Event> {
        let turns = self.turns();
        let together = |a: &Turn, b: &Turn| {
            self.path[b.piece].time[1] - self.path[a.piece].time[1] <= LONGEST_TURN
                && self.all_touching(a.piece, b.piece)
        };
        turns
            .chunk_by(together)
            .filter(|run| run.len() >= self.config.events.stick_slip_turns)
            .filter(|run| {
                run[1..]
                    .iter()
                    .all(|turn| turn.peak - turn.least >= LEAST_FORCE)
            })
            .map(|run| {
                // Standing before a stroke is no sticking: it begins with the first slip.
                let first = usize::from(run[0].to == Gait::Stuck);
                let last = run.len() - 1;
                self.described(EventKind::StickSlip, run[first].piece, run[last].piece)
            })
            .collect()
    }

    fn all_touching(&self, first: usize, last: usize) -> bool {
        (first..=last).all(|i| self.is_touching(i))
    }

    /// Speed along the surface, over the neighbours of a piece that has two [m/s].
    fn speed(&self, i: usize) -> f64 {
        let (before, after) = (&self.path[i - 1], &self.path[i + 1]);
        (after.position - before.position).xy().norm() / (after.time[1] - before.time[1])
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
            let mean = self.way[last] - self.way[first];
            let mean = mean / (self.path[last].time[1] - self.path[first].time[1]);
            let speed = self.speed(i);
            peak = peak.max(self.path[i].tangential_force);
            least = least.min(self.path[i].tangential_force);
            if mean < SLOWEST || !self.is_touching(i) {
                continue;
            }
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
