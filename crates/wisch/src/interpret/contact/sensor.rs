//! The force sensor of a log: the axes of its bias, its noise, and its clock.

use super::downsampling::MeasuredPiece;
use super::weighted::median;
use crate::geometry::Vector3;

/// Ratio of the largest to the median size of normal noise in three directions: the median is at 1.54 standard
/// deviations, and 4 are hardly exceeded.
const NOISE_BY_MEDIAN: f64 = 2.6;
/// Largest offset between the clocks of force and position, step of the search, and least offset that is corrected [s].
const CLOCKS: [f64; 3] = [3.0, 0.02, 0.08];
/// Least factor by which alignment of the clocks must raise the contrast of the contact force [1],
/// and the least contrast over the usual contact force: occasional pushes by a person show no clock
/// offset.
const CLOCK_GAIN: f64 = 1.1;
const CLOCK_CONTRAST: f64 = 0.8;

/// Axes in which the bias of a log's force is constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SensorAxes {
    Surface,
    Tool,
}

impl SensorAxes {
    /// Returns the measured force in these axes [N].
    pub(super) fn of(self, piece: &MeasuredPiece, force: Vector3) -> Vector3 {
        match self {
            Self::Surface => piece.turn.map_or(force, |turn| turn * force),
            Self::Tool => piece.surface_from_tool.inverse() * force,
        }
    }

    /// Returns a force from these axes in those of the believed surface [N].
    pub(super) fn to_surface(self, piece: &MeasuredPiece, force: Vector3) -> Vector3 {
        match self {
            Self::Surface => piece.turn.map_or(force, |turn| turn.inverse() * force),
            Self::Tool => piece.surface_from_tool * force,
        }
    }

    /// Returns a measured force less the bias, which is in the sensor's axes, in axes in which a force along the normal is
    /// constant [N]: those of the surface at the place, or those of the tool.
    pub(super) fn without_bias(
        self,
        piece: &MeasuredPiece,
        force: Vector3,
        bias: Vector3,
    ) -> Vector3 {
        let force = self.of(piece, force) - bias;
        match self {
            Self::Surface => self.to_surface(piece, force),
            Self::Tool => force,
        }
    }

    /// Returns the normal of the surface in these axes.
    pub(super) fn normal(self, piece: &MeasuredPiece) -> Vector3 {
        match self {
            Self::Surface => Vector3::z(),
            Self::Tool => self.of(piece, Vector3::z()),
        }
    }
}

/// Returns the median force of the pieces by component, and the largest size of the remaining noise [N].
pub(super) fn bias_and_noise(
    pieces: &[MeasuredPiece],
    free: &[usize],
    axes: SensorAxes,
) -> (Vector3, f64) {
    let of = |i: usize| axes.of(&pieces[i], pieces[i].force);
    let weight = |i: usize| f64::from(pieces[i].samples);
    let bias =
        Vector3::from_fn(|row, _| median(free.iter().map(|&i| (of(i)[row], weight(i))).collect()));
    let sizes = free.iter().map(|&i| ((of(i) - bias).norm(), weight(i)));
    (bias, NOISE_BY_MEDIAN * median(sizes.collect()))
}

/// Returns the delay of the force's clock behind the position's [s]: the offset at which the forces on the plane and
/// above it differ most.
pub(super) fn clock_offset(pieces: &[MeasuredPiece], on: &[usize], free: &[usize]) -> f64 {
    let [farthest, step, least] = CLOCKS;
    let time = |i: usize| 0.5 * (pieces[i].time[0] + pieces[i].time[1]);
    // Forces are limited to the usual contact force, as pushes and impacts do not depend on the clock.
    let (resting, _) = bias_and_noise(pieces, free, SensorAxes::Surface);
    let sensed = |i: usize| SensorAxes::Surface.of(&pieces[i], pieces[i].force) - resting;
    let sizes = on
        .iter()
        .map(|&i| (sensed(i).norm(), f64::from(pieces[i].samples)));
    let usual = median(sizes.collect());
    // The size alone: friction turns with the motion, so that the mean force also depends on which strokes a shift joins.
    let clipped = |i: usize| sensed(i).norm().min(usual);
    // Integral of the force over time, up to the middle of each piece.
    let mut integral = vec![0.0; pieces.len()];
    for i in 1..pieces.len() {
        let lasts = time(i) - time(i - 1);
        integral[i] = integral[i - 1] + (clipped(i) + clipped(i - 1)) * (0.5 * lasts);
    }
    let at = |when: f64| {
        let next = pieces.partition_point(|piece| 0.5 * (piece.time[0] + piece.time[1]) < when);
        let next = next.clamp(1, pieces.len() - 1);
        let [begin, end] = [time(next - 1), time(next)];
        let share = ((when - begin) / (end - begin)).clamp(0.0, 1.0);
        integral[next - 1] + (integral[next] - integral[next - 1]) * share
    };
    let [first, last] = [time(0), time(pieces.len() - 1)];
    let [on, free] = [runs(pieces, on), runs(pieces, free)];
    let mean = |runs: &[[f64; 2]], offset: f64| {
        let (mut sum, mut lasts) = (0.0, 0.0);
        for &[start, end] in runs {
            let [start, end] = [start + offset, end + offset].map(|when| when.clamp(first, last));
            sum += at(end) - at(start);
            lasts += end - start;
        }
        (lasts > 0.0).then(|| sum / lasts)
    };
    let contrast = |offset: f64| {
        let [on, free] = [mean(&on, offset), mean(&free, offset)];
        on.zip(free).map_or(0.0, |(on, free)| f64::abs(on - free))
    };
    let aligned = contrast(0.0);
    let steps = (farthest / step) as i32;
    let offsets = (-steps..=steps).map(|i| f64::from(i) * step);
    let best = offsets.map(|offset| (contrast(offset), offset));
    let best = best.max_by(|a, b| (a.0.total_cmp(&b.0)).then(b.1.abs().total_cmp(&a.1.abs())));
    match best {
        Some((most, offset))
            if offset.abs() >= least
                && most > CLOCK_GAIN * aligned
                && most > CLOCK_CONTRAST * usual =>
        {
            offset
        }
        _ => 0.0,
    }
}

/// Returns the time intervals over which the chosen pieces follow each other [s].
fn runs(pieces: &[MeasuredPiece], chosen: &[usize]) -> Vec<[f64; 2]> {
    let mut runs: Vec<([f64; 2], usize)> = Vec::new();
    for &i in chosen {
        match runs.last_mut() {
            Some((run, last)) if *last + 1 == i => {
                run[1] = pieces[i].time[1];
                *last = i;
            }
            _ => runs.push((pieces[i].time, i)),
        }
    }
    runs.into_iter().map(|(run, _)| run).collect()
}

/// Returns the pieces with the forces measured later by `offset` [s].
pub(super) fn shift_forces(pieces: &[MeasuredPiece], offset: f64) -> Vec<MeasuredPiece> {
    if offset == 0.0 {
        return pieces.to_vec();
    }
    let middle = |piece: &MeasuredPiece| 0.5 * (piece.time[0] + piece.time[1]);
    let force_at = |when: f64| {
        let next = pieces.partition_point(|piece| middle(piece) < when);
        let next = next.min(pieces.len() - 1);
        let before = next.saturating_sub(1);
        let lasts = middle(&pieces[next]) - middle(&pieces[before]);
        let share = if lasts > 0.0 {
            ((when - middle(&pieces[before])) / lasts).clamp(0.0, 1.0)
        } else {
            0.0
        };
        pieces[before].force + (pieces[next].force - pieces[before].force) * share
    };
    (pieces.iter())
        .map(|piece| MeasuredPiece {
            force: force_at(middle(piece) + offset),
            ..*piece
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point3;
    use nalgebra::UnitQuaternion;

    /// Pieces of 20 ms with these forces [N], each for a number of pieces.
    fn pieces(forces: &[(usize, Vector3)]) -> Vec<MeasuredPiece> {
        let each = (forces.iter()).flat_map(|(count, force)| vec![*force; *count]);
        each.enumerate()
            .map(|(i, force)| MeasuredPiece {
                time: [0.02 * i as f64, 0.02 * (i + 1) as f64],
                samples: 2,
                position: Point3::origin(),
                mean_height: 0.0,
                heading: 0.0,
                surface_from_tool: UnitQuaternion::identity(),
                turn: None,
                force,
                peak_force: force.norm(),
            })
            .collect()
    }

    #[test]
    fn friction_of_strokes_to_and_fro_is_no_clock_offset() {
        let [to, fro] = [0.9, -0.9].map(|friction| Vector3::new(10.0 * friction, 0.0, 10.0));
        let rest = Vector3::zeros();
        let strokes = pieces(&[(25, rest), (50, to), (50, rest), (50, fro), (25, rest)]);
        let is_stroke = |i: &usize| (25..75).contains(i) || (125..175).contains(i);
        let (on, free): (Vec<usize>, Vec<usize>) = (0..200).partition(is_stroke);
        // Aligned by a period, one stroke alone would have the larger mean force.
        assert_eq!(clock_offset(&strokes, &on, &free), 0.0);
    }

    #[test]
    fn regular_strokes_are_not_read_in_the_air_between_them() {
        let (press, rest) = (Vector3::z() * 10.0, Vector3::zeros());
        let runs: Vec<(usize, Vector3)> = (0..30).flat_map(|_| [(50, rest), (50, press)]).collect();
        let strokes = pieces(&runs);
        let is_stroke = |i: &usize| i % 100 >= 50;
        let (on, free): (Vec<usize>, Vec<usize>) = (0..3000).partition(is_stroke);
        let late: Vec<MeasuredPiece> = (strokes.iter().enumerate())
            .map(|(i, piece)| MeasuredPiece {
                force: strokes[i.saturating_sub(30)].force,
                ..*piece
            })
            .collect();
        let found = clock_offset(&late, &on, &free);
        assert!((found - 0.6).abs() < 0.03, "{found}");
    }
}
