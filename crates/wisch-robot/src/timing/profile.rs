//! The fastest σ̇ along a blended path: time-optimal path parametrisation by reachability analysis
//! (Pham and Pham, *A new approach to time-optimal path parameterization based on reachability
//! analysis*, IEEE Transactions on Robotics 34(3), 2018).
//!
//! Between grid points σ̈ is constant, so x = σ̇² is linear in σ. There dq/dσ is linear and d²q/dσ² constant,
//! hence q̈ = (dq/dσ) σ̈ + (d²q/dσ²) x is linear in σ as well. Limits that hold at both ends of an interval
//! therefore hold throughout, and a coarser grid only costs speed.

use super::blends::BlendedPath;
use super::{JointLimits, MAX_GRID_INTERVALS};

/// Relative distance kept from the limits [1]: far above rounding errors, and negligible for the
/// duration.
const LIMIT_MARGIN: f64 = 1e-8;

/// Controllable speeds are reduced by this share, so that rounding cannot leave them without a successor.
const CONTROLLABLE_MARGIN: f64 = 1e-10;

/// A grid interval of the path.
pub(super) struct Interval {
    /// Index of its piece.
    pub piece: usize,
    /// σ from the start of the piece to that of the interval [s].
    pub offset: f64,
    /// Length in σ [s].
    pub step: f64,
}

/// |at_begin·x + at_end·y| ≤ 1 for x = σ̇² at an interval's begin and y = σ̇² at its end.
#[derive(Debug, Clone, Copy)]
struct Strip {
    at_begin: f64,
    at_end: f64,
}

impl Strip {
    fn value(&self, x: f64, y: f64) -> f64 {
        self.at_begin * x + self.at_end * y
    }
}

/// Returns the grid of the whole path: at least `density` intervals per piece.
pub(super) fn grid(path: &BlendedPath, limits: &JointLimits, density: usize) -> Vec<Interval> {
    let most = (MAX_GRID_INTERVALS / path.pieces().len().max(1)).max(2);
    let mut intervals = Vec::new();
    for (piece, part) in path.pieces().iter().enumerate() {
        let count = if part.is_link {
            1
        } else {
            let joints = limits.joints().iter().zip(path.terms(piece));
            let acceleration = joints
                .map(|(joint, [_, d1, d2])| {
                    let slope = d1.abs().max((d1 + part.length * d2).abs());
                    joint.acceleration / slope
                })
                .fold(f64::INFINITY, f64::min);
            // Speed 1 is reached within 1 / (2 σ̈).
            let runs_up = part.length * 2.0 * acceleration;
            // An even number puts a grid point where a rest-to-rest motion starts to brake.
            let count = ((runs_up * density as f64) as usize).max(density);
            count.next_multiple_of(2).min(most)
        };
        // The speed changes most on straight pieces, and near rest it grows with the root of σ: there the grid
        // is finer towards both ends. Blends have almost constant speed.
        let is_straight = path.terms(piece).iter().all(|[_, _, d2]| *d2 == 0.0);
        let at = |k: usize| {
            let share = k as f64 / count as f64;
            let share = if is_straight {
                share * share * (3.0 - 2.0 * share)
            } else {
                share
            };
            part.length * share
        };
        intervals.extend((0..count).map(|k| Interval {
            piece,
            offset: at(k),
            step: at(k + 1) - at(k),
        }));
    }
    intervals
}

/// Returns σ̇² at every grid point, the fastest from rest to rest within the limits.
pub(super) fn fastest(path: &BlendedPath, limits: &JointLimits, grid: &[Interval]) -> Vec<f64> {
    let ceiling = velocity_ceiling(path, limits, grid);
    let last = grid.len();
    let mut strips = Vec::new();

    // Backward pass: the largest x at each grid point from which the end can be reached at rest. x = 0 is
    // always controllable, so the controllable set is the interval from 0 to that x.
    let mut controllable = ceiling;
    controllable[0] = 0.0;
    controllable[last] = 0.0;
    for k in (0..last).rev() {
        acceleration_strips(path, limits, &grid[k], &mut strips);
        let most = largest_begin(&strips, controllable[k], controllable[k + 1]);
        controllable[k] = most * (1.0 - CONTROLLABLE_MARGIN);
    }

    // Forward pass: always as fast as the motion can still be stopped.
    let mut squares = controllable;
    for k in 0..last {
        acceleration_strips(path, limits, &grid[k], &mut strips);
        squares[k + 1] = largest_end(&strips, squares[k], squares[k + 1]);
    }
    squares
}

/// Returns the largest σ̇² at every grid point that velocity limits and shortest times allow.
fn velocity_ceiling(path: &BlendedPath, limits: &JointLimits, grid: &[Interval]) -> Vec<f64> {
    let mut ceiling = vec![f64::INFINITY; grid.len() + 1];
    for (k, interval) in grid.iter().enumerate() {
        let joints = limits.joints().iter().zip(path.terms(interval.piece));
        let speed = joints
            .map(|(joint, [_, d1, d2])| {
                let begin = d1 + interval.offset * d2;
                let end = begin + interval.step * d2;
                joint.velocity / begin.abs().max(end.abs())
            })
            .fold(path.pieces()[interval.piece].speed_cap, f64::min);
        let square = (speed * (1.0 - LIMIT_MARGIN)).powi(2);
        ceiling[k] = ceiling[k].min(square);
        ceiling[k + 1] = ceiling[k + 1].min(square);
    }
    ceiling
}

/// Returns the acceleration limits of all joints at both ends of an interval.
fn acceleration_strips(
    path: &BlendedPath,
    limits: &JointLimits,
    interval: &Interval,
    strips: &mut Vec<Strip>,
) {
    strips.clear();
    // σ̈ = (y − x) / (2 step)
    let per_difference = 0.5 / interval.step;
    for (joint, [_, d1, d2]) in limits.joints().iter().zip(path.terms(interval.piece)) {
        let most = joint.acceleration * (1.0 - LIMIT_MARGIN);
        let bend = d2 / most;
        let begin = (d1 + interval.offset * d2) / most * per_difference;
        strips.push(Strip {
            at_begin: bend - begin,
            at_end: begin,
        });
        if bend != 0.0 {
            let end = begin + interval.step * bend * per_difference;
            strips.push(Strip {
                at_begin: -end,
                at_end: bend + end,
            });
        }
    }
}

/// Returns the largest x ≤ `most_begin` for which some y in 0 ≤ y ≤ `most_end` satisfies all strips.
///
/// This is a linear programme in two variables, solved one constraint after the other (Seidel 1991). While the
/// optimum so far satisfies the next constraint it stays; else the new optimum lies on that constraint's line.
fn largest_begin(strips: &[Strip], most_begin: f64, most_end: f64) -> f64 {
    let (mut x, mut y) = (most_begin, most_end);
    for (count, strip) in strips.iter().enumerate() {
        let value = strip.value(x, y);
        if value.abs() <= 1.0 {
            continue;
        }
        let side = value.signum();
        let (a, b) = (strip.at_begin, strip.at_end);
        let norm = a.hypot(b);
        // Along the line a·x + b·y = side, towards larger x; if x is constant on it, towards larger y.
        let (from_x, from_y) = (side * a / norm / norm, side * b / norm / norm);
        let (to_x, to_y) = if b == 0.0 {
            (0.0, 1.0)
        } else {
            (b.abs() / norm, -a * b.signum() / norm)
        };
        let mut range = (f64::NEG_INFINITY, f64::INFINITY);
        clip(&mut range, from_x, to_x, 0.0, most_begin);
        clip(&mut range, from_y, to_y, 0.0, most_end);
        for earlier in &strips[..count] {
            let (from, to) = (earlier.value(from_x, from_y), earlier.value(to_x, to_y));
            clip(&mut range, from, to, -1.0, 1.0);
        }
        let along = if range.0 <= range.1 {
            range.1
        } else {
            // Empty only by rounding: the origin satisfies every constraint.
            0.5 * (range.0 + range.1)
        };
        x = (from_x + along * to_x).clamp(0.0, most_begin);
        y = (from_y + along * to_y).clamp(0.0, most_end);
    }
    // The origin satisfies every constraint, so that a scaling towards it repairs rounding errors.
    let worst = strips.iter().map(|strip| strip.value(x, y).abs());
    x / worst.fold(1.0, f64::max)
}

/// Restricts `range` to where lower ≤ from + t·to ≤ upper.
fn clip(range: &mut (f64, f64), from: f64, to: f64, lower: f64, upper: f64) {
    if to != 0.0 {
        let (one, other) = ((lower - from) / to, (upper - from) / to);
        range.0 = range.0.max(one.min(other));
        range.1 = range.1.min(one.max(other));
    }
}

/// Returns the largest y ≤ `most_end` that satisfies all strips, for a controllable x.
fn largest_end(strips: &[Strip], x: f64, most_end: f64) -> f64 {
    let mut range = (0.0, most_end);
    for strip in strips {
        // A strip that restricts no y says no more than the bound on x.
        if (strip.at_end * most_end).abs() > CONTROLLABLE_MARGIN {
            clip(&mut range, strip.at_begin * x, strip.at_end, -1.0, 1.0);
        }
    }
    range.1.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Tries all corners of the region one by one.
    fn largest_begin_by_corners(strips: &[Strip], most_begin: f64, most_end: f64) -> f64 {
        let mut lines = vec![
            (1.0, 0.0, 0.0),
            (1.0, 0.0, most_begin),
            (0.0, 1.0, 0.0),
            (0.0, 1.0, most_end),
        ];
        for strip in strips {
            lines.push((strip.at_begin, strip.at_end, 1.0));
            lines.push((strip.at_begin, strip.at_end, -1.0));
        }
        let mut best: f64 = 0.0;
        for (i, (a, b, c)) in lines.iter().enumerate() {
            for (d, e, f) in &lines[..i] {
                let determinant = a * e - b * d;
                if determinant == 0.0 {
                    continue;
                }
                let x = (c * e - b * f) / determinant;
                let y = (a * f - c * d) / determinant;
                let inside = (-1e-9..=most_begin + 1e-9).contains(&x)
                    && (-1e-9..=most_end + 1e-9).contains(&y)
                    && strips.iter().all(|s| s.value(x, y).abs() <= 1.0 + 1e-9);
                if inside {
                    best = best.max(x);
                }
            }
        }
        best
    }

    proptest! {
        #[test]
        fn the_largest_begin_is_the_best_corner(
            strips in prop::collection::vec((-5.0..5.0, -5.0..5.0), 1..20),
            most_begin in 0.01..3.0,
            most_end in 0.0..3.0,
        ) {
            let strips: Vec<Strip> = strips
                .into_iter()
                .map(|(at_begin, at_end)| Strip { at_begin, at_end })
                .collect();
            let x = largest_begin(&strips, most_begin, most_end);
            let best = largest_begin_by_corners(&strips, most_begin, most_end);
            prop_assert!((x - best).abs() < 1e-6, "{x} instead of {best}");
        }
    }
}
