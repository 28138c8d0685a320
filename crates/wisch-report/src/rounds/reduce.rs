//! Reduces minutes of a log at 1 kHz to few points for a picture, and keeps its peaks.

use std::ops::RangeInclusive;
use wisch::geometry::Point3;
use wisch::interpret::{Interpretation, PathPiece, Touch};

/// Maximum number of points of a curve.
const MAX_POINTS: usize = 2_600;
/// Maximum number of stretches of a path in space.
const MAX_STRETCHES: usize = 5_000;
const TOUCHES: [Touch; 4] = [
    Touch::Free,
    Touch::Weak,
    Touch::Confident,
    Touch::FalsePositive,
];

/// A point of a curve: its position, and the contact class of its piece of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dot {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) touch: Touch,
}

/// Consecutive points of one contact class.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Run {
    pub(crate) touch: Touch,
    pub(crate) points: Vec<(f64, f64)>,
}

/// A stretch of the path in space: its end, and its contact class.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    pub(crate) end: Point3,
    pub(crate) touch: Touch,
    /// Mean f′ of its pieces in contact.
    pub(crate) normalized_force: f64,
}

/// Returns the lowest and the highest point of each contact class in every column of the picture, in order of time. Columns
/// are one unit wide, or wider if there are too many.
pub(crate) fn find_peaks(curve: &[Dot]) -> Vec<Dot> {
    let mut width = 1.0;
    loop {
        let kept = find_peaks_by(curve, width);
        if kept.len() <= MAX_POINTS {
            return kept;
        }
        width *= 2.0;
    }
}

fn find_peaks_by(curve: &[Dot], width: f64) -> Vec<Dot> {
    let column = |dot: &Dot| (dot.x / width).floor();
    let mut kept = Vec::new();
    for group in curve.chunk_by(|a, b| column(a) == column(b)) {
        let mut chosen: Vec<usize> = Vec::with_capacity(2 * TOUCHES.len());
        for touch in TOUCHES {
            let of_touch = || (0..group.len()).filter(|&i| group[i].touch == touch);
            let by_height = |a: &usize, b: &usize| group[*a].y.total_cmp(&group[*b].y);
            chosen.extend(of_touch().min_by(by_height));
            chosen.extend(of_touch().max_by(by_height));
        }
        chosen.sort_unstable();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|i| group[i]));
    }
    kept
}

/// Splits a curve into runs of one contact class; a run begins at the end of the run before.
pub(crate) fn split_runs(curve: &[Dot]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    for dot in curve {
        let here = (dot.x, dot.y);
        match runs.last_mut() {
            Some(run) if run.touch == dot.touch => run.points.push(here),
            _ => runs.push(Run {
                touch: dot.touch,
                points: before.into_iter().chain([here]).collect(),
            }),
        }
        before = Some(here);
    }
    runs
}

/// Returns start and end [s] of consecutive pieces of a contact class. Runs that are closer than `gap` [s] are merged.
pub(crate) fn find_spans(path: &[PathPiece], touch: Touch, gap: f64) -> Vec<[f64; 2]> {
    let mut spans: Vec<[f64; 2]> = Vec::new();
    for piece in path.iter().filter(|piece| piece.touch == touch) {
        match spans.last_mut() {
            Some(last) if piece.time[0] - last[1] <= gap => last[1] = last[1].max(piece.time[1]),
            _ => spans.push(piece.time),
        }
    }
    spans
}

/// Returns the pieces that can be drawn: finite, and not earlier than the piece before.
pub(crate) fn select_usable(path: &[PathPiece]) -> Vec<PathPiece> {
    let mut usable: Vec<PathPiece> = Vec::with_capacity(path.len());
    for piece in path {
        let [from, to] = piece.time;
        let position = piece.position;
        let values = [
            from,
            to,
            position.x,
            position.y,
            position.z,
            piece.normal_force,
            piece.normalized_force,
            piece.height,
        ];
        let later = usable.last().is_none_or(|before| from >= before.time[0]);
        if values.iter().all(|value| value.is_finite()) && to >= from && later {
            usable.push(*piece);
        }
    }
    usable
}

/// Splits the path into stretches of about `length` [m], or longer if there are too many.
pub(crate) fn split_stretches(path: &[PathPiece], length: f64) -> Vec<Stretch> {
    let mut length = length;
    loop {
        let stretches = split_stretches_by(path, length);
        if stretches.len() <= MAX_STRETCHES || !length.is_finite() {
            return stretches;
        }
        length *= 2.0;
    }
}

fn split_stretches_by(path: &[PathPiece], length: f64) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    let mut from = 0;
    for (i, piece) in path.iter().enumerate() {
        // Straight-line distance: the path length of a trembling tool at rest grows without limit.
        let moved = (piece.position - path[from].position).norm();
        // A push should not spread over a whole stretch of good contact.
        let turns = (piece.touch == Touch::FalsePositive)
            != path
                .get(i + 1)
                .is_some_and(|next| next.touch == Touch::FalsePositive);
        if moved >= length || (turns && moved >= length / 8.0) || i + 1 == path.len() {
            stretches.push(Stretch::of(path, from..=i, piece.position));
            from = i + 1;
        }
    }
    stretches
}

impl Stretch {
    fn of(path: &[PathPiece], places: RangeInclusive<usize>, end: Point3) -> Self {
        let group = &path[places.clone()];
        // A path of a single sample has no duration.
        let durations = places.map(|i| PathPiece::duration(path, i).max(1e-9));
        let lasting: Vec<(&PathPiece, f64)> = group.iter().zip(durations).collect();
        let total = |wanted: &dyn Fn(Touch) -> bool| -> f64 {
            let pieces = (lasting.iter()).filter(|(piece, _)| wanted(piece.touch));
            pieces.map(|(_, duration)| duration).sum()
        };
        let in_contact = |touch| matches!(touch, Touch::Weak | Touch::Confident);
        let contact = total(&in_contact);
        let force = (lasting.iter()).filter(|(piece, _)| in_contact(piece.touch));
        let force: f64 = force
            .map(|(p, duration)| p.normalized_force * duration)
            .sum();
        let touch = if group.iter().any(|p| p.touch == Touch::FalsePositive) {
            Touch::FalsePositive
        } else if contact < total(&|touch| touch == Touch::Free) {
            Touch::Free
        } else if 2.0 * total(&|touch| touch == Touch::Confident) >= contact {
            Touch::Confident
        } else {
            Touch::Weak
        };
        Self {
            end,
            touch,
            normalized_force: if contact > 0.0 { force / contact } else { 0.0 },
        }
    }
}

/// Returns the path to draw. Force away from the plane counts as a false positive only during a collision, because force and
/// height also disagree briefly at landing.
pub(crate) fn select_drawable(interpretation: &Interpretation) -> Vec<PathPiece> {
    let mut path = select_usable(&interpretation.path);
    let spans: Vec<[f64; 2]> = (interpretation.events.iter())
        .filter(|event| event.kind.is_by_hand())
        .map(|event| [event.start, event.end])
        .collect();
    for piece in &mut path {
        let is_in = |span: &[f64; 2]| piece.time[1] >= span[0] && piece.time[0] <= span[1];
        if piece.touch == Touch::FalsePositive && !spans.iter().any(is_in) {
            piece.touch = Touch::Weak;
        }
    }
    path
}
