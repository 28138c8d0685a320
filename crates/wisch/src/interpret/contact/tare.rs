//! A tare of the force sensor before the first contact.

use super::downsampling::MeasuredPiece;
use super::weighted::median;
use crate::geometry::Vector3;
use crate::interpret::config::InterpretConfig;

/// Largest travel of a tool that hangs still [m].
const STILL: f64 = 2e-3;
/// Least number of pieces before and after the tare.
const FEWEST: usize = 10;
/// Least step within two pieces over the whole change, and largest deviation from the constant forces before and after it [1].
const SUDDEN: f64 = 0.8;
const MOST_VARIATION: f64 = 0.15;
/// Least change over the nominal force [1], and over the noise [1].
const LEAST_CHANGE: [f64; 2] = [0.1, 6.0];
/// Share of the pieces that keep to a constant force [1].
const MOST: f64 = 0.9;

/// A sudden change between two constant forces, while the tool hangs still before its first contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct EarlyTare {
    /// Number of the pieces before the tare.
    pub(in crate::interpret) pieces: usize,
    /// Time of the tare [s].
    pub(in crate::interpret) time: f64,
    /// Size of the change [N].
    pub(in crate::interpret) change: f64,
}

/// Returns the tare with which a log begins, if there is one. A hand neither holds its force as constant as a bias is, nor
/// releases the tool at once.
pub(in crate::interpret) fn find_early_tare(
    pieces: &[MeasuredPiece],
    config: &InterpretConfig,
) -> Option<EarlyTare> {
    let first = pieces.first()?;
    let heights = pieces.iter().map(|piece| piece.mean_height);
    let lowest = heights.fold(f64::INFINITY, f64::min);
    let is_still = |piece: &&MeasuredPiece| (piece.position - first.position).norm() <= STILL;
    let hang = &pieces[..pieces.iter().take_while(is_still).count()];
    if first.mean_height - lowest < config.free_height_m || hang.len() < 2 * FEWEST + 2 {
        return None;
    }
    let step = |k: &usize| (hang[k + 1].force - hang[k - 1].force).norm();
    let at = (FEWEST..hang.len() - FEWEST - 1).max_by(|a, b| step(a).total_cmp(&step(b)))?;
    // The force after a tare is that of the last free motion. An early force of contact is not.
    let is_up = |piece: &&MeasuredPiece| piece.mean_height >= lowest + config.free_height_m;
    let later = pieces[hang.len()..].iter().rev().filter(is_up);
    let later: Vec<MeasuredPiece> = later.take(FEWEST).copied().collect();
    if later.len() < FEWEST {
        return None;
    }
    let [before, after] = [&hang[..at], &hang[at + 1..]].map(steady_force);
    let last = steady_force(&later).middle;
    if (last - after.middle).norm() >= (last - before.middle).norm() {
        return None;
    }
    let change = (after.middle - before.middle).norm();
    let [share, by_noise] = LEAST_CHANGE;
    let noise = before.usual.max(after.usual);
    let is_constant = before.usual <= 2.0 * after.usual + 0.02 * change
        && before.most.max(after.most) <= MOST_VARIATION * change + 3.0 * noise;
    let is_large = change >= (share * config.nominal_force()).max(by_noise * noise);
    (is_constant && is_large && step(&at) >= SUDDEN * change).then_some(EarlyTare {
        pieces: at + 1,
        time: hang[at].time[1],
        change,
    })
}

/// A constant force, and how far the pieces deviate from it [N].
struct SteadyForce {
    middle: Vector3,
    /// Deviation that half of the pieces exceed.
    usual: f64,
    /// Deviation that one piece of ten exceeds.
    most: f64,
}

fn steady_force(pieces: &[MeasuredPiece]) -> SteadyForce {
    let middle = Vector3::from_fn(|row, _| {
        median(pieces.iter().map(|piece| (piece.force[row], 1.0)).collect())
    });
    let mut off: Vec<f64> = (pieces.iter())
        .map(|piece| (piece.force - middle).norm())
        .collect();
    off.sort_unstable_by(f64::total_cmp);
    SteadyForce {
        middle,
        usual: off[off.len() / 2],
        most: off[((off.len() as f64 * MOST) as usize).min(off.len() - 1)],
    }
}
