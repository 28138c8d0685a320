//! Poses that are recorded at a lower rate than the forces, and repeated in between.

use super::downsampling::MeasuredPiece;
use super::weighted::median;
use crate::geometry::wrap_angle;

/// Shortest period of poses that count as held [s], and least number of pieces per pose [1].
const SHORTEST: f64 = 0.09;
const FEWEST_PIECES: usize = 5;
/// Least number of poses that show a period, range of their durations over it, and least share of them in this range [1].
const FEWEST_POSES: usize = 10;
const REGULAR: std::ops::RangeInclusive<f64> = 0.8..=1.25;
const LEAST_REGULAR: f64 = 0.7;
/// Duration of a pose over the period above which the tool rests [1].
const RESTS: f64 = 1.5;

/// Returns the pieces with poses interpolated between the times at which they change, and the period of these changes [s].
/// `None` if the poses are not held: a log repeats poses of a tool at rest, too, but not at a fixed period.
pub(in crate::interpret) fn interpolate_held_poses(
    pieces: &[MeasuredPiece],
) -> Option<(Vec<MeasuredPiece>, f64)> {
    let is_same = |a: &MeasuredPiece, b: &MeasuredPiece| {
        a.position == b.position && a.surface_from_tool == b.surface_from_tool
    };
    let runs: Vec<&[MeasuredPiece]> = pieces.chunk_by(is_same).collect();
    if runs.len() < FEWEST_POSES || pieces.len() < FEWEST_PIECES * runs.len() {
        return None;
    }
    let begin = |run: &[MeasuredPiece]| run[0].time[0];
    let durations: Vec<f64> = (runs.windows(2))
        .map(|pair| begin(pair[1]) - begin(pair[0]))
        .collect();
    let period = median(durations.iter().map(|lasts| (*lasts, 1.0)).collect());
    let regular = durations
        .iter()
        .filter(|lasts| REGULAR.contains(&(*lasts / period)));
    if period < SHORTEST || (regular.count() as f64) < LEAST_REGULAR * durations.len() as f64 {
        return None;
    }
    let mut interpolated = Vec::with_capacity(pieces.len());
    for (pair, lasts) in runs.windows(2).zip(durations) {
        let (from, to) = (pair[0][pair[0].len() - 1], pair[1][0]);
        // A tool that rests begins to move during the last period.
        let moving = if lasts > RESTS * period {
            period
        } else {
            lasts
        };
        let start = begin(pair[1]) - moving;
        interpolated.extend(pair[0].iter().map(|piece| {
            let share = ((piece.time[1] - start) / moving).clamp(0.0, 1.0);
            MeasuredPiece {
                position: from.position + (to.position - from.position) * share,
                mean_height: from.mean_height + (to.mean_height - from.mean_height) * share,
                heading: from.heading + wrap_angle(to.heading - from.heading) * share,
                surface_from_tool: from.surface_from_tool.nlerp(&to.surface_from_tool, share),
                ..*piece
            }
        }));
    }
    interpolated.extend(runs[runs.len() - 1]);
    Some((interpolated, period))
}
