//! A log prepared for the detection of events.
//!
//! Each event has two thresholds (hysteresis). An event exists where the higher one is exceeded for long enough, and
//! extends over all pieces above the lower one, short interruptions included.

use super::event::{Event, EventKind};
use crate::geometry::{PlanarPose, Region, Vector2, Vector3};
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ClassifiedPath, MeasuredPiece, PathPiece, Touch};
use crate::represent::Surface;

/// Number of confident pieces from which a log shows its own friction: half a second of contact.
const LEAST_CONTACTS: usize = 50;

/// Largest interquartile range of a log's friction coefficient, over its median, at which a
/// coefficient above the usual limit is attributed to the tool; and the share by which wiping may
/// then exceed the upper quartile [1].
const STEADY_FRICTION: f64 = 0.25;
const OVER_FRICTION: f64 = 1.2;
/// Least path around a piece with a direction [m], the longest duration of this path [s], and the
/// least cosine between friction and the opposite of the direction of motion [1].
const LEAST_WAY: f64 = 1e-3;
const LONGEST_WAY: f64 = 0.5;
const ALONG: f64 = 0.8;

/// Error of the tool's position relative to the surface's border [m]: grasp and localisation
/// together.
const BORDER: f64 = 5e-3;

/// Detector of events in a log; all slices have one entry per piece.
#[derive(Debug)]
pub(in crate::interpret) struct EventDetector<'a> {
    pieces: &'a [MeasuredPiece],
    pub(super) path: &'a [PathPiece],
    pub(super) off: &'a [f64],
    pub(super) off_spring: &'a [f64],
    surface: &'a Surface,
    footprint: &'a Region,
    pub(super) has_plane: bool,
    pub(super) friction: LogFriction,
    /// Largest force that noise alone produces [N].
    pub(super) noise: f64,
    pub(super) config: &'a InterpretConfig,
}

/// Level of a piece against an event's two thresholds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Below,
    Weak,
    Strong,
}

pub(super) fn level(weak: bool, strong: bool) -> Level {
    match (strong, weak) {
        (true, _) => Level::Strong,
        (_, true) => Level::Weak,
        _ => Level::Below,
    }
}

impl<'a> EventDetector<'a> {
    pub(in crate::interpret) fn new(
        pieces: &'a [MeasuredPiece],
        classified: &'a ClassifiedPath,
        surface: &'a Surface,
        footprint: &'a Region,
        noise: f64,
        config: &'a InterpretConfig,
    ) -> Self {
        let path = &classified.path;
        Self {
            pieces,
            path,
            off: &classified.off,
            off_spring: &classified.off_spring,
            surface,
            footprint,
            has_plane: classified.plane.is_some(),
            friction: measure_friction(pieces, path, config),
            noise: noise.min(2.0 * config.force_noise_n),
            config,
        }
    }

    /// Time that a piece represents [s].
    pub(super) fn span(&self, i: usize) -> [f64; 2] {
        PathPiece::span(self.path, i)
    }

    /// Measured force at a piece, in the axes of the believed surface [N].
    pub(super) fn force(&self, i: usize) -> Vector3 {
        self.pieces[i].force
    }

    pub(super) fn is_on_plane(&self, i: usize) -> bool {
        self.path[i].is_on_plane()
    }

    pub(super) fn is_touching(&self, i: usize) -> bool {
        self.path[i].is_in_contact(self.config.events.contact_share[1])
    }

    pub(super) fn is_near(&self, i: usize) -> bool {
        let piece = &self.path[i];
        piece.height.abs() <= self.config.events.near_height_m
            && self.surface.outline.contains(piece.position.xy())
    }

    /// Whether the tool overhangs the surface's border at a piece, where it may tip and sink.
    pub(super) fn overhangs(&self, i: usize) -> bool {
        let piece = &self.path[i];
        let outline = &self.surface.outline;
        let tool = PlanarPose::new(piece.position.xy(), piece.heading);
        self.footprint.edges().any(|side| {
            let corner = tool.transform(side.start);
            !outline.contains(corner) || outline.edges().any(|edge| edge.distance(corner) < BORDER)
        })
    }

    /// Travel across and along the surface over a piece and two neighbours on either side [m].
    pub(super) fn travel(&self, i: usize) -> [f64; 2] {
        let before = &self.path[i.saturating_sub(2)];
        let after = &self.path[(i + 2).min(self.path.len() - 1)];
        let along = (after.position.xy() - before.position.xy()).norm();
        [(after.height - before.height).abs(), along]
    }

    /// Speed along the surface's normal, in either direction [m/s].
    pub(super) fn climb(&self, i: usize) -> f64 {
        let before = i.saturating_sub(2);
        let after = (i + 2).min(self.path.len() - 1);
        let time = self.path[after].time[1] - self.path[before].time[1];
        if time > 0.0 {
            self.travel(i)[0] / time
        } else {
            0.0
        }
    }

    /// Returns stretches of pieces that are at least weak, with interruptions bridged, whose strong pieces last long
    /// enough. `bridge` returns the longest interruption at a piece [s].
    pub(super) fn candidates(
        &self,
        level: impl Fn(usize) -> Level,
        bridge: impl Fn(usize) -> f64,
    ) -> Vec<Candidate> {
        let mut candidates = Vec::new();
        let mut candidate: Option<Candidate> = None;
        for i in 0..self.path.len() {
            let [start, end] = self.span(i);
            let now = level(i);
            // Nothing is known about a gap in the log, so no event lasts beyond it.
            let is_after_gap = |candidate: &Candidate| start - candidate.end > bridge(i);
            if candidate.as_ref().is_some_and(is_after_gap) {
                candidates.extend(candidate.take());
            }
            if now == Level::Below {
                if candidate
                    .as_ref()
                    .is_some_and(|candidate| end - candidate.end > bridge(i))
                {
                    candidates.extend(candidate.take());
                }
                continue;
            }
            let open = candidate.get_or_insert(Candidate {
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
        candidates.extend(candidate);
        candidates.retain(|candidate| candidate.strong >= self.config.events.min_duration_s);
        candidates
    }

    /// Duration of a candidate [s].
    pub(super) fn duration(&self, candidate: &Candidate) -> f64 {
        self.span(candidate.last)[1] - self.span(candidate.first)[0]
    }

    /// Returns an event over the pieces `first` to `last`, with its evidence.
    pub(super) fn describe(&self, kind: EventKind, first: usize, last: usize) -> Event {
        let pieces = &self.pieces[first..=last];
        let path = &self.path[first..=last];
        let samples: f64 = pieces.iter().map(|piece| f64::from(piece.samples)).sum();
        // Σ F t / Σ t over the time that the pieces represent; a log of a single sample has no duration.
        let (mut impulse, mut time) = (0.0, 0.0);
        for (piece, i) in path.iter().zip(first..) {
            let duration = PathPiece::duration(self.path, i).max(f64::EPSILON);
            impulse += piece.normal_force * duration;
            time += duration;
        }
        Event {
            kind,
            start: self.span(first)[0],
            end: self.span(last)[1],
            samples: samples as usize,
            mean_normal_force: impulse / time,
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

/// Friction coefficients of a log: tangential force over normal force \[1\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LogFriction {
    /// 90 % quantile over the confident contacts, at most `limit`: the usual coefficient of wiping
    /// in this log.
    pub(super) usual: f64,
    /// The coefficient that wiping may reach.
    pub(super) limit: f64,
}

/// Returns the friction coefficients that a log shows.
fn measure_friction(
    pieces: &[MeasuredPiece],
    path: &[PathPiece],
    config: &InterpretConfig,
) -> LogFriction {
    let ratio = |piece: &PathPiece| piece.tangential_force / piece.normal_force.abs();
    let is_confident = |piece: &&PathPiece| piece.touch == Touch::Confident;
    let mut ratios: Vec<f64> = path.iter().filter(is_confident).map(ratio).collect();
    let limit = config.events.friction_limit;
    if ratios.len() < LEAST_CONTACTS {
        return LogFriction {
            usual: limit,
            limit,
        };
    }
    ratios.sort_unstable_by(f64::total_cmp);
    let quantile = |share: usize| ratios[(ratios.len() - 1) * share / 100];
    let [low, middle, high] = [25, 50, 75].map(quantile);
    let is_steady = high - low <= STEADY_FRICTION * middle;
    let limit = if middle > limit && is_steady && opposes_motion(pieces, path) {
        limit.max(OVER_FRICTION * high)
    } else {
        limit
    };
    LogFriction {
        usual: quantile(90).min(limit),
        limit,
    }
}

/// Whether the force on the tool points against its motion in most of the confident contacts, as friction does. The force
/// of a hand that pulls the tool along points the other way.
fn opposes_motion(pieces: &[MeasuredPiece], path: &[PathPiece]) -> bool {
    let (mut against, mut all) = (0, 0);
    for (i, piece) in path.iter().enumerate() {
        if piece.touch != Touch::Confident {
            continue;
        }
        if let Some(way) = way_around(path, i) {
            all += 1;
            let force = pieces[i].force.xy();
            against += usize::from(-force.dot(&way) >= ALONG * force.norm() * way.norm());
        }
    }
    all >= LEAST_CONTACTS && against * 5 >= all * 4
}

/// Returns the shortest path around a piece that has a direction; `None` for a tool at rest.
fn way_around(path: &[PathPiece], i: usize) -> Option<Vector2> {
    for reach in 2..path.len() {
        let before = &path[i.saturating_sub(reach)];
        let after = &path[(i + reach).min(path.len() - 1)];
        let way = after.position.xy() - before.position.xy();
        if way.norm() > LEAST_WAY {
            return Some(way);
        }
        if after.time[1] - before.time[0] > LONGEST_WAY {
            break;
        }
    }
    None
}

/// A stretch of pieces that may be an event.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    pub(super) first: usize,
    pub(super) last: usize,
    /// Time at which it ends [s].
    end: f64,
    /// Time above the higher threshold [s].
    strong: f64,
}
