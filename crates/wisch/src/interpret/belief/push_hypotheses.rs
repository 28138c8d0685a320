//! Hypotheses about contact during pushes, one per replay.
//!
//! While a person pushes the tool, the measured force is the hand's as well as the surface's. A small force may come
//! from a hand that pulls against the spring of the tool, a large one from a hand in the air. The distance from the
//! plane is another criterion: a tool that is closer to the plane than its uncompressed length must touch. A pushed and
//! released tool may also hop over the carried material without a trace in the force. No hypothesis is certain, so each
//! replay draws its own.

use crate::geometry::{Bounds2, Pose};
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{
    ContactMotion, NormalizedForce, PathPiece, Touch, contact_motions,
};
use crate::interpret::events::Event;
use crate::random::normal;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::borrow::Cow;
use std::ops::Range;

/// Time before its detection at which a push may have begun [s].
const BEFORE: f64 = 0.05;
/// Time after a push during which the released tool swings [s].
const AFTER: f64 = 2.0;
/// Random stream; separate from those of activation and parameters.
const STREAM: u64 = 0x646f_7562_0000_0000;

/// Contact motions of a log, and the pieces during which a person pushed the tool.
#[derive(Debug)]
pub(in crate::interpret) struct ContactEvidence<'a> {
    path: &'a [PathPiece],
    /// Bounds of the footprint, in the tool frame.
    bounds: Option<Bounds2>,
    real_from_believed: Pose,
    config: &'a InterpretConfig,
    /// Whether heights are those of a tool that lies flat, although it leans.
    is_leveled: bool,
    /// Whether a person pushed the tool during each piece.
    is_pushed: Vec<bool>,
    /// Pieces of each stretch that holds a push and its consequences.
    stretches: Vec<Range<usize>>,
    /// Contact motions as classified by the force alone.
    certain: Vec<ContactMotion>,
    /// Contact motions of a tool that touched wherever it was low, for a log that may be misread; empty otherwise.
    low: Vec<ContactMotion>,
    /// Whether the tool may also have touched nothing, although the log shows contact.
    may_hover: bool,
}

/// How one replay detects contact in a stretch. After the hand has let go, the force decides again.
#[derive(Debug, Clone)]
struct PushHypothesis {
    stretch: Range<usize>,
    criterion: Criterion,
    /// Pieces of a hop, during which the tool touches nothing.
    hop: Range<usize>,
}

/// Criterion of contact while a person pushes the tool.
#[derive(Debug, Clone, Copy)]
enum Criterion {
    /// The force, as in the rest of the log.
    Force,
    /// The distance from the plane, with this error [m].
    Distance(f64),
    /// The tool drags the carried material while it is near the surface.
    Dragging,
}

impl<'a> ContactEvidence<'a> {
    /// Collects the evidence of a path in the frame of the believed surface, with its events.
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
            certain: contact_motions(path, &real_from_believed, |i| share_by_force(&path[i])),
            low: Vec::new(),
            may_hover: false,
            real_from_believed,
            config,
            is_leveled: false,
        }
    }

    /// States whether heights are those of a tool that lies flat, although it leans.
    #[must_use]
    pub(in crate::interpret) const fn with_leveled_heights(mut self, is_leveled: bool) -> Self {
        self.is_leveled = is_leveled;
        self
    }

    /// Adds the alternatives to a log that may be misread: the tool touched at the pieces that `is_low` marks, or, if
    /// `may_hover`, nothing. `is_low` is empty for a log whose contact is not in doubt.
    #[must_use]
    pub(in crate::interpret) fn or_low(mut self, is_low: &[bool], may_hover: bool) -> Self {
        if !is_low.is_empty() {
            self.may_hover = may_hover;
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

    /// Whether the tool touched nothing and no person pushed it.
    pub(in crate::interpret) fn is_untouched(&self) -> bool {
        self.certain.is_empty() && self.stretches.is_empty() && self.low.is_empty()
    }

    /// Returns the contact motions in a replay; `compression` is that of the tool at nominal force in this replay [m], and
    /// `misread` its draw from 0 to 1 that decides whether logs are misread in it.
    pub(in crate::interpret) fn motions(
        &self,
        replay: u64,
        compression: f64,
        misread: f64,
    ) -> Cow<'_, [ContactMotion]> {
        if !self.low.is_empty() {
            let share = self.config.uncertainty.misread_share;
            let touched = if self.may_hover { 0.5 * share } else { share };
            if misread < touched {
                return Cow::Borrowed(&self.low);
            }
            if misread < share {
                return Cow::Borrowed(&[]);
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
                || share_by_force(&self.path[i]),
                |one| self.share(i, one, compression),
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

    /// Returns the pieces of a hop of the tool's length; `begin` is the share of the stretch's travel at which it
    /// starts.
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

    fn share(&self, i: usize, hypothesis: &PushHypothesis, compression: f64) -> NormalizedForce {
        let piece = &self.path[i];
        match hypothesis.criterion {
            _ if hypothesis.hop.contains(&i) => NormalizedForce::NoContact,
            Criterion::Distance(off) if self.is_pushed[i] => {
                self.share_by_distance(piece, off, compression)
            }
            Criterion::Dragging if self.is_pushed[i] && self.is_near(piece) => {
                NormalizedForce::Mean(1.0)
            }
            Criterion::Distance(_) | Criterion::Dragging | Criterion::Force => {
                share_by_force(piece)
            }
        }
    }

    fn is_near(&self, piece: &PathPiece) -> bool {
        piece.height.abs() <= self.config.events.near_height_m
    }

    /// Returns f′ from the compression of the tool at its distance from the plane; `off` is the error of that distance
    /// [m].
    fn share_by_distance(&self, piece: &PathPiece, off: f64, compression: f64) -> NormalizedForce {
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
        if self.is_leveled && middle > 0.0 {
            return NormalizedForce::Mean(middle.min(1.0));
        } else if self.is_leveled {
            return NormalizedForce::NoContact;
        }
        let half = self.bounds.map(|bounds| bounds.size() / 2.0);
        let most = half.map_or(0.0, |half| piece.slope.abs().dot(&half) / compression);
        if middle + most > 0.0 {
            NormalizedForce::Middle(middle.min(1.0))
        } else {
            NormalizedForce::NoContact
        }
    }
}

fn share_by_force(piece: &PathPiece) -> NormalizedForce {
    match piece.touch {
        Touch::Weak | Touch::Confident => NormalizedForce::Mean(piece.normalized_force),
        Touch::Free | Touch::FalsePositive => NormalizedForce::NoContact,
    }
}

/// Marks the pieces during which a person pushed the tool.
fn is_pushed(path: &[PathPiece], events: &[Event]) -> Vec<bool> {
    let mut is_pushed = vec![false; path.len()];
    for push in pushes(events) {
        is_pushed[pieces_between(path, push.start - BEFORE, push.end)].fill(true);
    }
    is_pushed
}

fn pushes(events: &[Event]) -> impl Iterator<Item = &Event> {
    (events.iter()).filter(|event| event.kind.is_by_hand())
}

/// Returns the pieces between two times [s].
fn pieces_between(path: &[PathPiece], start: f64, end: f64) -> Range<usize> {
    let first = path.partition_point(|piece| piece.time[1] < start);
    first..path.partition_point(|piece| piece.time[0] <= end)
}

/// Returns the pieces of each push and its consequences; overlapping stretches are merged.
fn stretches(path: &[PathPiece], events: &[Event]) -> Vec<Range<usize>> {
    let mut stretches: Vec<Range<usize>> = Vec::new();
    for push in pushes(events) {
        let next = pieces_between(path, push.start - BEFORE, push.end + AFTER);
        match stretches.last_mut() {
            Some(before) if before.end >= next.start => before.end = before.end.max(next.end),
            _ => stretches.push(next),
        }
    }
    stretches
}
