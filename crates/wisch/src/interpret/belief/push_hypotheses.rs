//! Contact during pushes, as hypotheses: one per replay.
//!
//! While somebody has a hand on the tool, the force that is felt is the hand's as much as the surface's: little
//! force may be a hand that holds against the spring of the tool, much of it a hand in the air. Where the tool is
//! is another sign: a tool that is nearer to the plane than it is long when nothing presses it must touch. And a
//! tool that is shoved and let go of may hop over what it carried, where nobody feels it. None of these hypotheses
//! is certain, so each replay takes one of its own.

use crate::geometry::{Bounds2, Pose};
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{
    ContactMotion, NormalizedForce, PathPiece, Touch, contact_motions,
};
use crate::interpret::events::Event;
use crate::random::{keyed_uniform, normal};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::borrow::Cow;
use std::ops::Range;

/// How long before it is felt a push may have begun [s].
const BEFORE: f64 = 0.05;
/// How long after a push a tool that is let go of swings [s].
const AFTER: f64 = 2.0;
/// Stream of random numbers: apart from those of activation and parameters.
const STREAM: u64 = 0x646f_7562_0000_0000;
/// Key of which replays take a log without contact for misread.
const MISREAD: u64 = 0x6d69_7372_6561_6421;

/// What speaks for contact, and when somebody pushed meanwhile.
#[derive(Debug)]
pub(in crate::interpret) struct ContactEvidence<'a> {
    path: &'a [PathPiece],
    /// Of the footprint, in the frame of the tool.
    bounds: Option<Bounds2>,
    real_from_believed: Pose,
    config: &'a InterpretConfig,
    /// Pieces while somebody pushed.
    is_pushed: Vec<bool>,
    /// Pieces of each stretch in which somebody pushed, and what became of that.
    stretches: Vec<Range<usize>>,
    /// The motions where nobody pushed.
    certain: Vec<ContactMotion>,
    /// The motions of a tool that touched wherever it was low, if the log shows no contact: it may be misread.
    low: Vec<ContactMotion>,
}

/// How one replay detects contact in a stretch: by the force again as soon as the hand has let go.
#[derive(Debug, Clone)]
struct PushHypothesis {
    stretch: Range<usize>,
    criterion: Criterion,
    /// Pieces within which the tool touches nothing.
    hop: Range<usize>,
}

/// What decides on contact while somebody pushes.
#[derive(Debug, Clone, Copy)]
enum Criterion {
    /// By the force, as everywhere else.
    Force,
    /// By the distance from the plane, which is off by this [m].
    Distance(f64),
    /// What it carried it drags along as long as it is near the surface at all.
    Dragging,
}

impl<'a> ContactEvidence<'a> {
    /// Of a path in the frame of the believed surface with these events.
    pub(in crate::interpret) fn new(
        path: &'a [PathPiece],
        events: &[Event],
        bounds: Option<Bounds2>,
        real_from_believed: Pose,
        config: &'a InterpretConfig,
    ) -> Self {
        Self {
            path,
            bounds,
            is_pushed: is_pushed(path, events),
            stretches: stretches(path, events),
            certain: contact_motions(path, &real_from_believed, |i| by_force(&path[i])),
            low: Vec::new(),
            real_from_believed,
            config,
        }
    }

    /// The same for a log that shows no contact, of a tool that may have touched at these pieces.
    #[must_use]
    pub(in crate::interpret) fn or_low(mut self, is_low: &[bool]) -> Self {
        if !is_low.is_empty() {
            let force = |i: usize| {
                if is_low[i] {
                    NormalizedForce::Mean(1.0)
                } else {
                    NormalizedForce::NoContact
                }
            };
            self.low = contact_motions(self.path, &self.real_from_believed, force);
        }
        self
    }

    /// Whether nothing was touched, and nobody pushed.
    pub(in crate::interpret) fn is_untouched(&self) -> bool {
        self.certain.is_empty() && self.stretches.is_empty() && self.low.is_empty()
    }

    /// The motions in contact that a replay believes, in which the tool is compressed so far at nominal force [m].
    pub(in crate::interpret) fn motions(
        &self,
        replay: u64,
        compression: f64,
    ) -> Cow<'_, [ContactMotion]> {
        if !self.low.is_empty() {
            let is_misread = keyed_uniform(self.config.seed ^ MISREAD, replay, 0);
            if is_misread < self.config.uncertainty.misread_share {
                return Cow::Borrowed(&self.low);
            }
        }
        if self.stretches.is_empty() {
            return Cow::Borrowed(&self.certain);
        }
        let mut random = ChaCha8Rng::seed_from_u64(self.config.seed);
        random.set_stream(STREAM ^ replay);
        let hypotheses: Vec<PushHypothesis> = (self.stretches.iter())
            .map(|stretch| self.draw(stretch, &mut random))
            .collect();
        let force = |i: usize| {
            let hypothesis = hypotheses.iter().find(|one| one.stretch.contains(&i));
            hypothesis.map_or_else(
                || by_force(&self.path[i]),
                |one| self.force(i, one, compression),
            )
        };
        Cow::Owned(contact_motions(self.path, &self.real_from_believed, force))
    }

    fn draw(&self, stretch: &Range<usize>, random: &mut ChaCha8Rng) -> PushHypothesis {
        let uncertainty = &self.config.uncertainty;
        let off = normal(random) * self.config.plane.inlier_distance_m;
        let choice = random.random::<f64>();
        let is_hopping = random.random::<f64>() < uncertainty.hop_share;
        let begin = random.random::<f64>();
        PushHypothesis {
            criterion: if choice < uncertainty.pushed_by_force {
                Criterion::Force
            } else if choice < uncertainty.pushed_by_force + uncertainty.pushed_dragging {
                Criterion::Dragging
            } else {
                Criterion::Distance(off)
            },
            hop: if is_hopping {
                self.hop(stretch, begin)
            } else {
                0..0
            },
            stretch: stretch.clone(),
        }
    }

    /// The pieces of a hop as long as the tool, which begins at this share of the way of a stretch.
    fn hop(&self, stretch: &Range<usize>, begin: f64) -> Range<usize> {
        let length = (self.bounds).map_or(0.0, |bounds| bounds.size().norm());
        let way: Vec<f64> = (stretch.clone().skip(1))
            .scan(0.0, |way, i| {
                let step = self.path[i].position - self.path[i - 1].position;
                *way += step.xy().norm();
                Some(*way)
            })
            .collect();
        let from = begin * way.last().copied().unwrap_or(0.0);
        let at = |travel: f64| stretch.start + way.partition_point(|way| *way < travel);
        at(from)..at(from + length) + 1
    }

    fn force(&self, i: usize, hypothesis: &PushHypothesis, compression: f64) -> NormalizedForce {
        let piece = &self.path[i];
        match hypothesis.criterion {
            _ if hypothesis.hop.contains(&i) => NormalizedForce::NoContact,
            Criterion::Distance(off) if self.is_pushed[i] => {
                self.by_distance(piece, off, compression)
            }
            Criterion::Dragging if self.is_pushed[i] && self.is_near(piece) => {
                NormalizedForce::Mean(1.0)
            }
            Criterion::Distance(_) | Criterion::Dragging | Criterion::Force => by_force(piece),
        }
    }

    fn is_near(&self, piece: &PathPiece) -> bool {
        piece.height.abs() <= self.config.events.near_height_m
    }

    /// As much as the tool must be compressed where it is, if it is as much farther from the plane.
    fn by_distance(&self, piece: &PathPiece, off: f64, compression: f64) -> NormalizedForce {
        let height = piece.height + off;
        if compression <= 0.0 {
            let is_near = height <= self.config.plane.inlier_distance_m;
            return if is_near {
                NormalizedForce::Mean(1.0)
            } else {
                NormalizedForce::NoContact
            };
        }
        let middle = 1.0 - height / compression;
        let half = self.bounds.map(|bounds| bounds.size() / 2.0);
        let most = half.map_or(0.0, |half| piece.slope.abs().dot(&half) / compression);
        if middle + most > 0.0 {
            NormalizedForce::Middle(middle.min(1.0))
        } else {
            NormalizedForce::NoContact
        }
    }
}

fn by_force(piece: &PathPiece) -> NormalizedForce {
    match piece.touch {
        Touch::Weak | Touch::Confident => NormalizedForce::Mean(piece.normalized_force),
        Touch::Free | Touch::FalsePositive => NormalizedForce::NoContact,
    }
}

/// Which pieces are within a push.
fn is_pushed(path: &[PathPiece], events: &[Event]) -> Vec<bool> {
    let mut is_pushed = vec![false; path.len()];
    for push in pushes(events) {
        is_pushed[within(path, push.start - BEFORE, push.end)].fill(true);
    }
    is_pushed
}

fn pushes(events: &[Event]) -> impl Iterator<Item = &Event> {
    (events.iter()).filter(|event| event.kind.is_by_hand())
}

/// The pieces between two times [s].
fn within(path: &[PathPiece], start: f64, end: f64) -> Range<usize> {
    let first = path.partition_point(|piece| piece.time[1] < start);
    first..path.partition_point(|piece| piece.time[0] <= end)
}

/// The pieces within each push and soon after it, those that overlap together.
fn stretches(path: &[PathPiece], events: &[Event]) -> Vec<Range<usize>> {
    let mut stretches: Vec<Range<usize>> = Vec::new();
    for push in pushes(events) {
        let next = within(path, push.start - BEFORE, push.end + AFTER);
        match stretches.last_mut() {
            Some(before) if before.end >= next.start => before.end = before.end.max(next.end),
            _ => stretches.push(next),
        }
    }
    stretches
}
