//! What happened during a log: intervals, each with its evidence.
//!
//! Every event has two thresholds: where the higher one is passed for long enough there is an event, and it
//! reaches as far as the lower one is passed, short interruptions included.

use super::contact::{Clearance, Judged};
use super::pieces::Piece;
use super::{Event, EventKind, InterpretConfig, PathPiece, Touch};

/// A log as events see it; all lists are as long.
#[derive(Debug)]
pub(super) struct Evidence<'a> {
    pieces: &'a [Piece],
    pub(super) path: &'a [PathPiece],
    clearances: &'a [Clearance],
    /// Travel along the surface up to each piece [m].
    pub(super) way: Vec<f64>,
    has_plane: bool,
    pub(super) config: &'a InterpretConfig,
}

/// How a piece stands to an event's thresholds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Below,
    Weak,
    Strong,
}

fn level(weak: bool, strong: bool) -> Level {
    match (strong, weak) {
        (true, _) => Level::Strong,
        (_, true) => Level::Weak,
        _ => Level::Below,
    }
}

impl<'a> Evidence<'a> {
    pub(super) fn new(
        pieces: &'a [Piece],
        judged: &'a Judged,
        config: &'a InterpretConfig,
    ) -> Self {
        let path = &judged.path;
        let steps = (0..path.len()).map(|i| {
            (path[i].position - path[i.saturating_sub(1)].position)
                .xy()
                .norm()
        });
        Self {
            pieces,
            path,
            clearances: &judged.clearances,
            way: steps
                .scan(0.0, |way, step| {
                    *way += step;
                    Some(*way)
                })
                .collect(),
            has_plane: judged.plane.is_some(),
            config,
        }
    }

    /// All events, by start.
    pub(super) fn events(&self) -> Vec<Event> {
        let mut events = self.intervals(EventKind::Contact, |i| self.contact(i));
        events.extend(self.intervals(EventKind::Collision, |i| self.collision(i)));
        let losses = self.intervals(EventKind::ContactLoss, |i| self.loss(i));
        let collisions: Vec<[f64; 2]> = (events.iter())
            .filter(|event| event.kind == EventKind::Collision)
            .map(|event| [event.start, event.end])
            .collect();
        // What a push takes from the surface is the push's, not a loss.
        events.extend(losses.into_iter().filter(|loss| {
            !(collisions.iter()).any(|[start, end]| loss.start < *end && *start < loss.end)
        }));
        events.extend(self.stick_slips());
        events.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.kind.cmp(&b.kind)));
        events
    }

    /// Time in contact over the time on or near the surface [1].
    pub(super) fn contact_share(&self) -> f64 {
        let (mut near, mut touching) = (0.0, 0.0);
        for i in 0..self.path.len() {
            let [start, end] = self.span(i);
            let is_touching = self.is_touching(i);
            if is_touching || self.is_near(i) {
                near += end - start;
            }
            if is_touching {
                touching += end - start;
            }
        }
        if near > 0.0 { touching / near } else { 0.0 }
    }

    /// From when to when a piece speaks: half way to its neighbours [s].
    fn span(&self, i: usize) -> [f64; 2] {
        let [first, last] = self.path[i].time;
        let before = i.checked_sub(1).map_or(first, |j| self.path[j].time[1]);
        let after = self.path.get(i + 1).map_or(last, |next| next.time[0]);
        [0.5 * (before + first), 0.5 * (last + after)]
    }

    fn is_on_plane(&self, i: usize) -> bool {
        matches!(self.path[i].touch, Touch::Weak | Touch::Confident)
    }

    pub(super) fn is_touching(&self, i: usize) -> bool {
        self.is_on_plane(i) && self.path[i].normalized_force >= self.config.events.contact_share[1]
    }

    fn is_near(&self, i: usize) -> bool {
        self.path[i].height.abs() <= self.config.events.near_height_m
    }

    fn contact(&self, i: usize) -> Level {
        let [begin, end] = self.config.events.contact_share;
        let share = self.path[i].normalized_force;
        let on_plane = self.is_on_plane(i);
        level(on_plane && share >= end, on_plane && share >= begin)
    }

    /// Near the surface, moving along it, without force.
    fn loss(&self, i: usize) -> Level {
        let without_force = self.path[i].normalized_force < self.config.events.contact_share[0]
            && !self.is_pushed(i);
        let lost = self.has_plane && self.is_near(i) && without_force;
        let [rise, along] = self.travel(i);
        level(lost, lost && along > 2.0 * rise)
    }

    fn is_pushed(&self, i: usize) -> bool {
        self.collision(i) != Level::Below
    }

    /// Travel across and along the surface over a piece and its neighbours [m].
    fn travel(&self, i: usize) -> [f64; 2] {
        let before = &self.path[i.saturating_sub(2)];
        let after = &self.path[(i + 2).min(self.path.len() - 1)];
        let along = (after.position.xy() - before.position.xy()).norm();
        [(after.height - before.height).abs(), along]
    }

    /// Speed towards or away from the surface [m/s].
    fn climb(&self, i: usize) -> f64 {
        let before = i.saturating_sub(2);
        let after = (i + 2).min(self.path.len() - 1);
        let time = self.path[after].time[1] - self.path[before].time[1];
        if time > 0.0 {
            self.travel(i)[0] / time
        } else {
            0.0
        }
    }

    fn collision(&self, i: usize) -> Level {
        self.off_plane(i)
            .max(self.shoved(i))
            .max(self.overloaded(i))
    }

    /// Off the plane with a force like that of contact (Fig. 18).
    fn off_plane(&self, i: usize) -> Level {
        if !self.has_plane {
            return Level::Below;
        }
        let events = &self.config.events;
        let clearance = self.clearances[i];
        let share = self.path[i].normalized_force;
        let off = clearance.height.abs() - clearance.tolerance;
        let far = events.collision_height_m + events.force_lag_s * self.climb(i);
        level(
            off > 0.0 && share >= events.collision_share[1],
            off > far && share >= events.collision_share[0],
        )
    }

    /// More force along the surface than friction takes.
    fn shoved(&self, i: usize) -> Level {
        let events = &self.config.events;
        let piece = &self.path[i];
        let friction = events.friction_limit * (-piece.normal_force).max(0.0);
        let beyond = piece.tangential_force - friction;
        level(
            beyond > events.tangential_margin_n[1],
            beyond > events.tangential_margin_n[0],
        )
    }

    /// Much more normal force than asked for.
    fn overloaded(&self, i: usize) -> Level {
        let nominal = self.config.nominal_force();
        let noise = 2.0 * self.config.force_noise_n;
        let force = -self.path[i].normal_force - noise;
        let [begin, end] = self.config.events.overload;
        level(force > end * nominal, force > begin * nominal)
    }

    /// Runs of pieces at least weak, interruptions bridged, in which the strong ones last long enough.
    fn intervals(&self, kind: EventKind, level: impl Fn(usize) -> Level) -> Vec<Event> {
        let mut events = Vec::new();
        let mut run: Option<Run> = None;
        for i in 0..self.path.len() {
            let [start, end] = self.span(i);
            let now = level(i);
            if now == Level::Below {
                if run
                    .as_ref()
                    .is_some_and(|run| end - run.end > self.config.events.bridge_s)
                {
                    events.extend(run.take().and_then(|run| self.event(kind, &run)));
                }
                continue;
            }
            let open = run.get_or_insert(Run {
                first: i,
                last: i,
                end,
                strong: 0.0,
            });
            open.last = i;
            open.end = end;
            if now == Level::Strong {
                open.strong += end - start;
            }
        }
        events.extend(run.and_then(|run| self.event(kind, &run)));
        events
    }

    fn event(&self, kind: EventKind, run: &Run) -> Option<Event> {
        let travel = (self.path[run.last].position - self.path[run.first].position)
            .xy()
            .norm();
        let enough = run.strong >= self.config.events.min_duration_s
            && (kind != EventKind::ContactLoss || travel >= self.config.events.loss_travel_m);
        enough.then(|| self.described(kind, run.first, run.last))
    }

    /// The evidence of pieces `first` to `last`.
    pub(super) fn described(&self, kind: EventKind, first: usize, last: usize) -> Event {
        let pieces = &self.pieces[first..=last];
        let path = &self.path[first..=last];
        let samples: f64 = pieces.iter().map(|piece| f64::from(piece.samples)).sum();
        let weighted = pieces
            .iter()
            .zip(path)
            .map(|(piece, judged)| f64::from(piece.samples) * judged.normal_force);
        Event {
            kind,
            start: self.span(first)[0],
            end: self.span(last)[1],
            samples: samples as usize,
            mean_normal_force: weighted.sum::<f64>() / samples,
            peak_force: pieces
                .iter()
                .map(|piece| piece.peak_force)
                .fold(0.0, f64::max),
            peak_height: path
                .iter()
                .map(|piece| piece.height.abs())
                .fold(0.0, f64::max),
        }
    }
}

/// Pieces that may be an event.
#[derive(Debug)]
struct Run {
    first: usize,
    last: usize,
    /// [s]
    end: f64,
    /// How long the higher threshold was passed [s].
    strong: f64,
}
