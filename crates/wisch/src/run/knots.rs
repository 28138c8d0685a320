//! Knots of a trajectory: a small number of setpoints, between which quintic polynomials follow the
//! trajectory within an error.

use crate::follow::{Followed, TrajectorySample};

/// Period at which the polynomials are compared with the trajectory [s].
const CHECK_PERIOD: f64 = 0.005;
/// Largest number of periods between two knots.
const MAX_PERIODS: usize = 400;

/// Returns the times of the knots [s]: the start of each motion, the end, and further times found
/// by a greedy search for few knots. `error`: largest deviation of any variable [rad or m].
pub(super) fn knot_times(followed: &Followed, error: f64) -> Vec<f64> {
    let mut times: Vec<f64> = Vec::new();
    for motion in &followed.motions {
        let (start, end) = (motion.start, motion.end());
        let periods = ((end - start) / CHECK_PERIOD).ceil().max(1.0) as usize;
        let time = |k: usize| (start + k as f64 * CHECK_PERIOD).min(end);
        let samples: Vec<TrajectorySample> = (0..=periods)
            .map(|k| motion.trajectory.sample(time(k) - start))
            .collect();
        let fits = |from: usize, to: usize| {
            let span = time(to) - time(from);
            (from + 1..to).all(|k| {
                let share = (time(k) - time(from)) / span;
                deviation(&samples[from], &samples[to], span, share, &samples[k].q) <= error
            })
        };
        if times.last().is_none_or(|last| start > *last) {
            times.push(start);
        }
        let mut from = 0;
        while from < periods {
            let farthest = periods.min(from + MAX_PERIODS);
            // The farthest knot that fits, by doubling and halving; the next sample always fits.
            let (mut near, mut step) = (from + 1, 1);
            while near < farthest && fits(from, (near + step).min(farthest)) {
                near = (near + step).min(farthest);
                step *= 2;
            }
            while step > 1 {
                step /= 2;
                if near + step <= farthest && fits(from, near + step) {
                    near += step;
                }
            }
            times.push(time(near));
            from = near;
        }
    }
    times
}

/// Largest distance of any variable from the quintic polynomial between two samples, at a share of the span between them
/// [rad or m]. `span`: time between the samples [s].
fn deviation(
    from: &TrajectorySample,
    to: &TrajectorySample,
    span: f64,
    share: f64,
    q: &[f64],
) -> f64 {
    let of = |i: usize| {
        let start = [from.q[i], from.qd[i] * span, from.qdd[i] * span * span];
        let end = [to.q[i], to.qd[i] * span, to.qdd[i] * span * span];
        (quintic(start, end, share) - q[i]).abs()
    };
    (0..q.len()).map(of).fold(0.0, f64::max)
}

/// Value at `s` in \[0, 1\] of the polynomial of fifth degree with value, first and second derivative given at 0 and 1.
fn quintic([p, v, a]: [f64; 3], [q, w, b]: [f64; 3], s: f64) -> f64 {
    let d = q - p;
    let [c3, c4, c5] = [
        10.0 * d - 6.0 * v - 4.0 * w - 1.5 * a + 0.5 * b,
        -15.0 * d + 8.0 * v + 7.0 * w + 1.5 * a - b,
        6.0 * d - 3.0 * v - 3.0 * w - 0.5 * a + 0.5 * b,
    ];
    p + s * (v + s * (0.5 * a + s * (c3 + s * (c4 + s * c5))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_of_fifth_degree_is_met_exactly() {
        let f = |s: f64| 1.0 - 2.0 * s + 3.0 * s.powi(3) - s.powi(4) + 0.5 * s.powi(5);
        let d = |s: f64| -2.0 + 9.0 * s * s - 4.0 * s.powi(3) + 2.5 * s.powi(4);
        let dd = |s: f64| 18.0 * s - 12.0 * s * s + 10.0 * s.powi(3);
        for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let value = quintic([f(0.0), d(0.0), dd(0.0)], [f(1.0), d(1.0), dd(1.0)], s);
            assert!((value - f(s)).abs() < 1e-12, "{value} at {s}");
        }
    }
}
