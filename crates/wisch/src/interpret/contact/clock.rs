//! Offset between the clocks of force and position.
//!
//! A *span* is a time that the tool spends low over a plane, from its landing to its lift. A *pulse* is a time with a contact
//! force. If the clocks differ, the same offset leads from landings to the begins of pulses, and from lifts to their ends.
//! Only this counts as evidence: it needs both the presence of force during a span, and its absence before and after it. A
//! lost contact, or a force that the robot builds up slowly, moves one end of a pulse.

use super::downsampling::MeasuredPiece;
use super::sensor::{SensorAxes, bias_and_noise};
use super::weighted::median;
use crate::geometry::Vector3;

/// Range of the offsets that are corrected [s].
const OFFSETS: std::ops::RangeInclusive<f64> = 0.07..=3.05;
/// Largest distance between the end of a span and the end of its pulse after alignment [s].
const MATCHED: f64 = 0.15;
/// Resolution of the offsets that are tried [s].
const STEP: f64 = 0.02;
/// Least share of the spans that match a pulse at both ends [1].
const LEAST_MATCHED: f64 = 0.6;
/// Least delay of each end of the pulses over that of their middle [1].
const LEAST_OF_EACH: f64 = 0.5;
/// Shortest pulse, and longest interruption of one [s].
const SHORTEST: f64 = 0.1;
/// Quantile of the force in the log, which pushes do not reach, and share of it that is a contact force [1].
const STRONG: f64 = 0.95;
const CONTACT: f64 = 0.5;
/// Least number of spans from which the log may rest at the force that contacts have without alignment.
const FEWEST_STAYS: usize = 2;

/// Begin and end of a span or a pulse [s].
type Span = [f64; 2];

/// Delay of the force's clock behind the position's.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct ClockOffset {
    /// The delay [s].
    pub(super) delay: f64,
    /// Another delay that matches as many spans, if it is unknown which of them holds [s].
    pub(super) other: Option<f64>,
}

/// Returns the delay of the force's clock behind the position's; 0 unless spans and pulses show another.
///
/// # Parameters
/// - `heights`: distances of the pieces from the plane [m].
/// - `limits`: height below which the tool is on the plane, and height above which it is clear of it [m].
/// - `on`, `free`: pieces that slide on the plane, and pieces of calm motion clear of it.
pub(super) fn clock_offset(
    pieces: &[MeasuredPiece],
    heights: &[f64],
    limits: [f64; 2],
    (on, free): (&[usize], &[usize]),
) -> ClockOffset {
    let spans = find_contact_spans(pieces, heights, limits);
    let [at_rest, in_contact] =
        [free, on].map(|some| bias_and_noise(pieces, some, SensorAxes::Surface).0);
    let by_rest = best_offset(&spans, &pulses(pieces, at_rest, |_| true));
    if by_rest.delay != 0.0 || spans.len() < FEWEST_STAYS {
        return by_rest;
    }
    // With a large offset, most spans are without force. A surface presses outwards.
    best_offset(&spans, &pulses(pieces, in_contact, |force| force.z > 0.0))
}

/// Returns the times at which the tool is on the plane, each between two times clear of it.
fn find_contact_spans(
    pieces: &[MeasuredPiece],
    heights: &[f64],
    [low, clear]: [f64; 2],
) -> Vec<Span> {
    let mut spans = Vec::new();
    let mut open: Option<Span> = None;
    let mut was_clear = false;
    for (piece, height) in pieces.iter().zip(heights) {
        if *height > clear {
            spans.extend(open.take().filter(|_| was_clear));
            was_clear = true;
        } else if *height <= low {
            let begin = open.map_or(piece.time[0], |[begin, _]| begin);
            open = Some([begin, piece.time[1]]);
        }
    }
    spans
}

/// Returns the times of a contact force, relative to the force `rest` in free motion [N]. `is_contact` decides whether a force
/// of this size and direction is one.
fn pulses(
    pieces: &[MeasuredPiece],
    rest: Vector3,
    is_contact: impl Fn(Vector3) -> bool,
) -> Vec<Span> {
    let force = |piece: &MeasuredPiece| SensorAxes::Surface.of(piece, piece.force) - rest;
    let mut sizes: Vec<f64> = pieces.iter().map(|piece| force(piece).norm()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let Some(strong) = sizes.get((STRONG * sizes.len() as f64) as usize) else {
        return Vec::new();
    };
    let strong = sizes.partition_point(|size| *size < CONTACT * strong);
    let usual = sizes[usize::midpoint(strong, sizes.len() - 1)];
    let mut pulses: Vec<Span> = Vec::new();
    for piece in pieces {
        let force = force(piece);
        if force.norm() < CONTACT * usual || !is_contact(force) {
            continue;
        }
        match pulses.last_mut() {
            Some(pulse) if piece.time[0] - pulse[1] < SHORTEST => pulse[1] = piece.time[1],
            _ => pulses.push(piece.time),
        }
    }
    pulses.retain(|[begin, end]| end - begin >= SHORTEST);
    pulses
}

/// Returns the offset with which most spans match a pulse, or 0 if too few do.
fn best_offset(spans: &[Span], pulses: &[Span]) -> ClockOffset {
    let furthest = *OFFSETS.end();
    let near = |[begin, end]: Span| {
        let from = pulses.partition_point(|pulse| pulse[1] < end - furthest);
        let some = pulses[from..].iter();
        some.take_while(move |pulse| pulse[0] <= begin + furthest)
            .map(move |pulse| [pulse[0] - begin, pulse[1] - end])
    };
    // Delays of both ends of a pulse behind those of a span [s].
    let delays: Vec<Vec<[f64; 2]>> = (spans.iter())
        .map(|span| {
            near(*span)
                .filter(|[first, last]| (first - last).abs() <= 2.0 * MATCHED)
                .collect()
        })
        .collect();
    let matches = |offset: f64| -> Vec<[f64; 2]> {
        let off = |both: &[f64; 2]| {
            let off = both.map(|delay| (delay - offset).abs());
            off[0].max(off[1])
        };
        let nearest = delays
            .iter()
            .filter_map(|some| some.iter().min_by(|a, b| off(a).total_cmp(&off(b))));
        nearest
            .filter(|both| off(both) <= MATCHED)
            .copied()
            .collect()
    };
    let mut tried: Vec<i32> = (delays.iter().flatten())
        .map(|[first, last]| (0.5 * (first + last) / STEP).round() as i32)
        .chain([0])
        .collect();
    tried.sort_unstable_by_key(|step| (step.abs(), *step));
    tried.dedup();
    let mut best = Vec::new();
    for step in &tried {
        let matched = matches(f64::from(*step) * STEP);
        if matched.len() > best.len() {
            best = matched;
        }
    }
    if best.is_empty() || (best.len() as f64) < LEAST_MATCHED * spans.len() as f64 {
        return ClockOffset::default();
    }
    let usual = |delay: &dyn Fn(&[f64; 2]) -> f64| {
        median(best.iter().map(|both| (delay(both), 1.0)).collect())
    };
    let delay = usual(&|[first, last]| 0.5 * (first + last));
    let ends = [usual(&|both| both[0]), usual(&|both| both[1])];
    let is_alike = (ends.iter()).all(|end| end * delay.signum() >= LEAST_OF_EACH * delay.abs());
    if !is_alike || !OFFSETS.contains(&delay.abs()) {
        return ClockOffset::default();
    }
    // Strokes that follow each other regularly match at several offsets if a part of their force is not in the log.
    let mut others = tried.iter().map(|step| f64::from(*step) * STEP);
    let other = others
        .find(|other| (other - delay).abs() > 2.0 * MATCHED && matches(*other).len() >= best.len());
    ClockOffset { delay, other }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stays of one second each, at these times [s].
    fn spans_from(begins: &[f64]) -> Vec<Span> {
        begins.iter().map(|begin| [*begin, begin + 1.0]).collect()
    }

    #[test]
    fn pulses_in_every_contact_span_show_an_offset() {
        let spans = spans_from(&[3.0, 5.0, 7.0, 9.0]);
        for offset in [-2.9, -1.0, -0.1, 0.1, 0.5, 1.3, 2.0, 2.9] {
            let pulses: Vec<Span> = spans
                .iter()
                .map(|span| span.map(|at| at + offset))
                .collect();
            let found = best_offset(&spans, &pulses);
            let is_found = (found.delay - offset).abs() < 1e-9 && found.other.is_none();
            assert!(is_found, "{offset}: {found:?}");
        }
        assert_eq!(best_offset(&spans, &spans), ClockOffset::default());
        // Without the force of the first span, the pulses may belong to the spans before.
        let cut: Vec<Span> = (spans[1..].iter())
            .map(|span| span.map(|at| at - 0.8))
            .collect();
        let found = best_offset(&spans, &cut);
        assert!(found.other.is_some(), "{found:?}");
    }

    #[test]
    fn lost_contacts_and_slow_presses_show_no_offset() {
        let spans = spans_from(&[1.0, 3.0, 5.0]);
        let early: Vec<Span> = spans
            .iter()
            .map(|[begin, end]| [*begin, end - 0.5])
            .collect();
        let slow: Vec<Span> = spans
            .iter()
            .map(|[begin, end]| [begin + 0.25, *end])
            .collect();
        // Of one long span, either half has a force.
        for (spans, pulses) in [
            (&spans[..], early),
            (&spans[..], slow),
            (&[[1.0, 7.0]], vec![[1.0, 4.0]]),
            (&[[1.0, 7.0]], vec![[4.0, 7.0]]),
            (&[[1.0, 7.0]], vec![[0.0, 1.0], [4.0, 8.0]]),
        ] {
            assert_eq!(
                best_offset(spans, &pulses),
                ClockOffset::default(),
                "{pulses:?}"
            );
        }
    }
}
