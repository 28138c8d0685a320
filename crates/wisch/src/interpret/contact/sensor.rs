//! The force sensor of a log: the axes of its bias, its noise, and forces at other times.

use super::downsampling::MeasuredPiece;
use super::weighted::median;
use crate::geometry::Vector3;

/// Ratio of the largest to the median size of normal noise in three directions: the median is at 1.54 standard
/// deviations, and 4 are hardly exceeded.
const NOISE_BY_MEDIAN: f64 = 2.6;

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
