//! Changes of the force sensor's bias during a log: drift, and steps such as those of a tare in
//! contact.

use super::downsampling::MeasuredPiece;
use super::sensor::{SensorAxes, bias_and_noise};
use crate::geometry::Vector3;

/// Time to the next contact within which a force may belong to that contact, because forces lag and
/// are averaged [s].
const SETTLED: f64 = 0.15;
/// Least number of pieces of a free motion that show its bias.
const FEWEST: usize = 5;
/// Largest difference of the medians of two free motions over the largest noise and the root of their number of pieces [1].
const NOISE_OF_MEDIANS: f64 = 2.0;
/// Least change of the bias over the change of the force within one of the two free motions [1]. A hand that touches the tool
/// in the air does not hold its force as constant as a bias is.
const MORE_THAN_WITHIN: f64 = 2.0;

/// A change of the bias between two free motions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct BiasChange {
    /// Size of the change [N].
    pub(in crate::interpret) size: f64,
    /// Times in the middle of the two free motions [s].
    pub(in crate::interpret) times: [f64; 2],
    /// Whether most of the change remains in the last free motion.
    pub(in crate::interpret) persists: bool,
}

/// Bias during a free motion.
#[derive(Debug, Clone, Copy)]
struct Level {
    bias: Vector3,
    noise: f64,
    /// Largest difference of the forces of two thirds of the motion [N].
    variation: f64,
    count: usize,
    time: f64,
}

/// Returns the largest change of the bias between free motions that contacts separate. `None` if
/// noise explains the differences, or if there is only one free motion.
///
/// # Parameters
/// - `free`: pieces of calm free motion, in their order.
/// - `is_clear`: whether the tool is above the surface at each piece.
pub(super) fn find_bias_change(
    pieces: &[MeasuredPiece],
    free: &[usize],
    is_clear: &[bool],
    axes: SensorAxes,
) -> Option<BiasChange> {
    let levels = levels(pieces, free, is_clear, axes);
    let [Some(first), Some(last)] = [levels.first(), levels.last()] else {
        return None;
    };
    let remaining = (last.bias - first.bias).norm();
    let pairs = (levels.iter().enumerate())
        .flat_map(|(i, before)| levels[i + 1..].iter().map(move |after| (before, after)));
    let changes = pairs.filter_map(|(before, after)| {
        let size = (after.bias - before.bias).norm();
        let count = before.count.min(after.count) as f64;
        let least = NOISE_OF_MEDIANS * before.noise.max(after.noise) / count.sqrt();
        let within = MORE_THAN_WITHIN * before.variation.max(after.variation);
        (size > least.max(within)).then_some(BiasChange {
            size,
            times: [before.time, after.time],
            persists: remaining > size / 2.0,
        })
    });
    changes.max_by(|a, b| a.size.total_cmp(&b.size))
}

/// Returns the bias of the first free motion, that of the last one, and between them the medians of three in a row, sorted
/// by time. A person who pushes during one of them does not change such a median.
fn levels(
    pieces: &[MeasuredPiece],
    free: &[usize],
    is_clear: &[bool],
    axes: SensorAxes,
) -> Vec<Level> {
    let motions = motions(pieces, free, is_clear);
    let levels = motions.iter().map(|motion| {
        let (bias, noise) = bias_and_noise(pieces, motion, axes);
        Level {
            bias,
            noise,
            variation: variation_within(pieces, motion, axes),
            count: motion.len(),
            time: middle(&pieces[motion[motion.len() / 2]]),
        }
    });
    let levels: Vec<Level> = levels.collect();
    let [first, .., last] = levels[..] else {
        return levels;
    };
    let inner = levels.windows(3).map(|three| Level {
        bias: Vector3::from_fn(|row, _| median_of_three([0, 1, 2].map(|k| three[k].bias[row]))),
        noise: three.iter().map(|level| level.noise).fold(0.0, f64::max),
        // One of the three, which a hand may have touched, does not change the median.
        variation: median_of_three([0, 1, 2].map(|k| three[k].variation)),
        count: three.iter().map(|level| level.count).min().unwrap_or(0),
        time: three[1].time,
    });
    std::iter::once(first).chain(inner).chain([last]).collect()
}

fn median_of_three([a, b, c]: [f64; 3]) -> f64 {
    a.max(b).min(a.min(b).max(c))
}

/// Returns the largest difference of the median forces of the thirds of a free motion [N].
fn variation_within(pieces: &[MeasuredPiece], motion: &[usize], axes: SensorAxes) -> f64 {
    let thirds = motion.chunks(motion.len().div_ceil(3));
    let forces: Vec<Vector3> = thirds
        .map(|third| bias_and_noise(pieces, third, axes).0)
        .collect();
    let differences = (forces.iter()).flat_map(|a| forces.iter().map(move |b| (a - b).norm()));
    differences.fold(0.0, f64::max)
}

/// Returns the pieces of each free motion that are not close to a contact in time.
fn motions(pieces: &[MeasuredPiece], free: &[usize], is_clear: &[bool]) -> Vec<Vec<usize>> {
    let mut motions: Vec<Vec<usize>> = Vec::new();
    let mut next = 0;
    for motion in is_clear.chunk_by(|a, b| a == b) {
        let range = next..next + motion.len();
        next = range.end;
        if !motion[0] {
            continue;
        }
        let begin = (range.start > 0).then(|| pieces[range.start].time[0] + SETTLED);
        let end = (range.end < pieces.len()).then(|| pieces[range.end - 1].time[1] - SETTLED);
        let from = free.partition_point(|i| *i < range.start);
        let to = free.partition_point(|i| *i < range.end);
        let is_settled = |i: &usize| {
            let time = middle(&pieces[*i]);
            begin.is_none_or(|begin| time >= begin) && end.is_none_or(|end| time <= end)
        };
        let settled: Vec<usize> = free[from..to].iter().copied().filter(is_settled).collect();
        if settled.len() >= FEWEST {
            motions.push(settled);
        }
    }
    motions
}

/// Time in the middle of a piece [s].
fn middle(piece: &MeasuredPiece) -> f64 {
    0.5 * (piece.time[0] + piece.time[1])
}
