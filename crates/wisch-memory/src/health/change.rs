//! Sudden changes in a series, found by seeded binary segmentation (Kovács 2023).
//!
//! Intervals of many lengths are searched, the shortest first, so that a change is found among many
//! others and in a long history. An interval is split where two lines fit so much better than one
//! that chance does not explain it (Bayesian information criterion, Schwarz 1978, with a stricter
//! penalty). Single outliers are replaced first (Hampel 1974). Several adjacent outliers are no
//! change either. Therefore, the values on both sides of a split must also differ by their ranks
//! (Mann and Whitney 1947).

use super::median::{DEVIATION_OF_MEDIAN, median};
use super::slope::RobustLine;
use std::collections::BTreeMap;

/// Least number of episodes on either side of a change, so that a single outlier is not a change.
const FEWEST_BESIDE_CHANGE: usize = 4;
/// Penalty of a change in log-likelihood: a factor on the logarithm of the length, and a constant.
const PENALTY: [f64; 2] = [5.0, 5.0];
/// Neighbours on either side with which a value is compared, and the deviations from their median that make an outlier.
const NEIGHBOURS: usize = 3;
const OUTLIER: f64 = 4.0;
/// Values on either side of a change that are compared by their ranks.
const RANKED: usize = 60;
/// Length of the shortest intervals.
const SHORTEST: usize = 16;
/// Probability up to which a split counts as a change \[1\].
const MAX_P_VALUE: f64 = 0.05;

/// A split of a series into two lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ChangePoint {
    /// First index after the change.
    pub place: usize,
    /// Upper limit of the probability that chance makes two lines fit so much better than one \[1\].
    pub p: f64,
}

/// Returns the sudden changes of a series, in order. `scatter`: least standard deviation of the values.
///
/// Each p-value is the larger one of two: that of the F-test of two lines against one, times the
/// number of all tested places, and that of the test of ranks, times the places of the interval. A
/// change is taken from the shortest interval that shows it; of equally long ones, the one with the
/// least p-value comes first. Intervals around a change are not searched again. The p-value of a
/// change is the least of those in this interval and between the neighbouring changes.
#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
pub(crate) fn find_changes(values: &[f64], scatter: f64) -> Vec<ChangePoint> {
    let sums = Sums::new(&replace_outliers(values, scatter));
    let levels = list_intervals(values.len());
    // Intervals of a length overlap by half, and see each place twice at most.
    let tried = levels.len() * (values.len() + 1).saturating_sub(2 * FEWEST_BESIDE_CHANGE);
    let p_value = |interval: [usize; 2], place| {
        let fit = tried as f64 * sums.p_value(interval, place, scatter);
        // The order of a few values has a least probability, so it is compared with the places of its interval only.
        let places = interval[1] - interval[0] + 1 - 2 * FEWEST_BESIDE_CHANGE;
        let order = places as f64 * rank_p_value(values, interval, place, scatter);
        fit.max(order).min(1.0)
    };
    let mut found: BTreeMap<usize, f64> = BTreeMap::new();
    for intervals in levels {
        let candidates = intervals.into_iter().filter_map(|[from, to]| {
            let is_open = found.range(from + 1..to).next().is_none();
            let place = sums.split([from, to], scatter).filter(|_| is_open)?;
            let p = p_value([from, to], place);
            (p <= MAX_P_VALUE).then_some(([from, to], place, p))
        });
        let mut candidates: Vec<([usize; 2], usize, f64)> = candidates.collect();
        candidates.sort_by(|a, b| a.2.total_cmp(&b.2).then(a.1.cmp(&b.1)));
        for ([from, to], place, p) in candidates {
            if found.range(from + 1..to).next().is_none() {
                found.insert(place, p);
            }
        }
    }
    let places: Vec<usize> = found.keys().copied().collect();
    let bounds: Vec<usize> = [vec![0], places, vec![values.len()]].concat();
    let changes = found.into_iter().enumerate();
    let changes = changes.map(|(k, (place, p))| ChangePoint {
        place,
        p: p.min(p_value([bounds[k], bounds[k + 2]], place)),
    });
    changes.collect()
}

/// Returns the intervals of a series that are searched for changes, by their lengths, which double;
/// the last one is the whole series.
fn list_intervals(count: usize) -> Vec<Vec<[usize; 2]>> {
    let lengths = std::iter::successors(Some(SHORTEST), |length| Some(2 * length));
    let lengths = lengths.take_while(|length| *length < count);
    let mut levels: Vec<Vec<[usize; 2]>> = lengths
        .map(|length| {
            let begins = (0..count - length).step_by(length / 2);
            // The newest values are always at the end of an interval.
            let begins = begins.chain(std::iter::once(count - length));
            begins.map(|from| [from, from + length]).collect()
        })
        .collect();
    levels.push(vec![[0, count]]);
    levels
}

/// Returns the series with each outlier replaced by the median of its neighbours.
fn replace_outliers(values: &[f64], scatter: f64) -> Vec<f64> {
    let mut near = Vec::with_capacity(2 * NEIGHBOURS + 1);
    let replaced = values.iter().enumerate().map(|(place, &value)| {
        let to = (place + NEIGHBOURS + 1).min(values.len());
        near.clear();
        near.extend_from_slice(&values[place.saturating_sub(NEIGHBOURS)..to]);
        let middle = median(&mut near);
        near.iter_mut()
            .for_each(|near| *near = (*near - middle).abs());
        let deviation = (DEVIATION_OF_MEDIAN * median(&mut near)).max(scatter);
        let is_outlier = (value - middle).abs() > OUTLIER * deviation;
        if is_outlier { middle } else { value }
    });
    replaced.collect()
}

/// Sums over the beginning of a series, from which the residuals of a line through any part of it follow.
struct Sums {
    /// Σ y, Σ x y and Σ y² over the first values, with x counted from 0 and the mean of the series subtracted from y.
    first: Vec<[f64; 3]>,
}

#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
impl Sums {
    fn new(values: &[f64]) -> Self {
        let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
        let mut sums = [0.0; 3];
        let first = values.iter().enumerate().map(|(x, y)| {
            let y = y - mean;
            let terms = [y, x as f64 * y, y * y];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
            sums
        });
        Self {
            first: std::iter::once([0.0; 3]).chain(first).collect(),
        }
    }

    /// Returns the sum of squared residuals of the line through a part of the series.
    fn squares(&self, [from, to]: [usize; 2]) -> f64 {
        let [begin, end] = [self.first[from], self.first[to]];
        let [sy, sxy, syy]: [f64; 3] = std::array::from_fn(|i| end[i] - begin[i]);
        let n = (to - from) as f64;
        let mean_x = 0.5 * (from + to - 1) as f64;
        // Σ (x − x̄)² of equidistant x, Σ (x − x̄) y and Σ (y − ȳ)²; S = Σ (y − ȳ)² − (Σ (x − x̄) y)² / Σ (x − x̄)².
        let xx = n * (n * n - 1.0) / 12.0;
        let xy = sxy - mean_x * sy;
        let yy = syy - sy * sy / n;
        (yy - xy * xy / xx).max(0.0)
    }

    /// Returns the variances of the residuals of one line, and of two that meet at a place.
    fn variances(&self, [from, to]: [usize; 2], place: usize, scatter: f64) -> [f64; 2] {
        let n = (to - from) as f64;
        let two = self.squares([from, place]) + self.squares([place, to]);
        [self.squares([from, to]), two].map(|squares| squares / n + scatter * scatter)
    }

    /// Returns the place of a change in a part of the series, if it has one.
    fn split(&self, [from, to]: [usize; 2], scatter: f64) -> Option<usize> {
        if to - from < 2 * FEWEST_BESIDE_CHANGE {
            return None;
        }
        let places = from + FEWEST_BESIDE_CHANGE..=to - FEWEST_BESIDE_CHANGE;
        let costs = places.map(|k| (k, self.squares([from, k]) + self.squares([k, to])));
        let (place, _) = costs.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let n = (to - from) as f64;
        let [one, two] = self.variances([from, to], place, scatter);
        // Twice the gain in log-likelihood of normal residuals: n ln(S₁ / S₂).
        let gain = n * (one / two).ln();
        (gain > PENALTY[0] * n.ln() + PENALTY[1]).then_some(place)
    }

    /// Returns the probability that one line fits so much worse than two by chance \[1\].
    fn p_value(&self, [from, to]: [usize; 2], place: usize, scatter: f64) -> f64 {
        let [one, two] = self.variances([from, to], place, scatter);
        // With two further parameters, P(F > f) = (S₂ / S₁)^((n − 4) / 2) in closed form.
        (two / one).powf(0.5 * (to - from).saturating_sub(4) as f64)
    }
}

/// Returns the probability that the values before and after a place differ so much by chance, from their ranks \[1\].
///
/// The line through the longer side is subtracted first, so that a drift is no change, and a drift that begins again from
/// its start is one. Equal values count against a change.
fn rank_p_value(values: &[f64], [from, to]: [usize; 2], place: usize, scatter: f64) -> f64 {
    let (from, to) = (
        from.max(place.saturating_sub(RANKED)),
        to.min(place + RANKED),
    );
    let longer = if place - from >= to - place {
        from..place
    } else {
        place..to
    };
    let line = RobustLine::fit(&values[longer.clone()], scatter);
    let left = |x: usize| values[x] - line.slope * (x as f64 - longer.start as f64);
    let before: Vec<f64> = (from..place).map(left).collect();
    let after: Vec<f64> = (place..to).map(left).collect();
    let pairs = || before.iter().flat_map(|a| after.iter().map(move |b| b - a));
    let rising = pairs().filter(|by| *by > 0.0).count();
    let falling = pairs().filter(|by| *by < 0.0).count();
    let against = before.len() * after.len() - rising.max(falling);
    // Gaussian binomial coefficients: the numbers of orders by their pairs against the change, ∏ (1 − qⁿ⁺ⁱ) / (1 − qⁱ).
    let mut orders = vec![0.0; against + 1];
    orders[0] = 1.0;
    let mut all = 1.0;
    for i in 1..=after.len() {
        let longer = before.len() + i;
        for k in (longer..=against).rev() {
            orders[k] -= orders[k - longer];
        }
        for k in i..=against {
            orders[k] += orders[k - i];
        }
        all *= longer as f64 / i as f64;
    }
    (2.0 * orders.iter().sum::<f64>() / all).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Offsets [m] with a standard deviation of about half a millimetre.
    fn scattered(seed: u64, of: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        // The sum of three uniform numbers is approximately normal.
        let mut noise = || {
            (0..3)
                .map(|_| random.random_range(-0.5e-3..0.5e-3))
                .sum::<f64>()
        };
        (0..20).map(|k| of(k) + noise()).collect()
    }

    fn places(values: &[f64]) -> Vec<usize> {
        let found = find_changes(values, 2e-4).into_iter();
        found.map(|change| change.place).collect()
    }

    #[test]
    fn a_step_is_located_and_a_slope_has_no_step() {
        let mut found_elsewhere = 0;
        for seed in 0..100 {
            let step = scattered(seed, |k| if k < 12 { 0.0 } else { -5e-3 });
            let found = places(&step);
            assert_eq!(found.len(), 1, "{seed}: {found:?}");
            found_elsewhere += usize::from(found != [12]);
            assert!(find_changes(&step, 2e-4)[0].p < 1e-3);
            let slope = scattered(seed, |k| -3e-4 * k as f64);
            assert_eq!(places(&slope), [0; 0], "{seed}");
            for outliers in [[0, 9], [17, 19], [12, 13]] {
                let is_outlier = |k| outliers.contains(&k);
                let values = scattered(seed, |k| if is_outlier(k) { 5e-3 } else { 0.0 });
                assert_eq!(places(&values), [0; 0], "{seed}: {outliers:?}");
            }
            // A drift, a repair, and the same drift.
            let repaired = scattered(seed, |k| -5e-4 * (k % 10) as f64);
            assert_eq!(places(&repaired).len(), 1, "{seed}");
        }
        assert!(found_elsewhere < 5, "{found_elsewhere}");
    }

    #[test]
    fn many_repairs_and_a_long_history_hide_no_change() {
        let noise = |seed: u64, count: usize| {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            (0..count).map(move |_| {
                let parts = (0..3).map(|_| random.random_range(-0.5e-3..0.5e-3));
                parts.sum::<f64>()
            })
        };
        for seed in 0..20 {
            // A drift that is repaired every 15 runs, 20 times.
            let values: Vec<f64> = (noise(seed, 300).enumerate())
                .map(|(k, noise)| noise - 5e-4 * (k % 15) as f64)
                .collect();
            let found = find_changes(&values, 2e-4);
            let last = found.last().expect("a change").place;
            assert!((282..=288).contains(&last), "{seed}: {found:?}");
            assert!(found.len() >= 17, "{seed}: {}", found.len());
            // A shift of the last values after many quiet ones, and an excursion.
            let shifted = |from: usize, to: usize, by: f64, count: usize| -> Vec<f64> {
                (noise(seed, count).enumerate())
                    .map(|(k, noise)| noise + if (from..to).contains(&k) { by } else { 0.0 })
                    .collect()
            };
            let last = |values: &[f64]| places(values).last().copied();
            assert_eq!(last(&shifted(295, 300, -20e-3, 300)), Some(295), "{seed}");
            assert_eq!(last(&shifted(790, 800, 5e-3, 800)), Some(790), "{seed}");
            assert_eq!(places(&shifted(25, 35, 5e-3, 60)).len(), 2, "{seed}");
        }
    }

    #[test]
    fn p_values_of_ranks_are_those_of_tables() {
        // Four values above four others: 2 of the 70 orders; with two pairs against it, 2 (1 + 1 + 2) of them.
        let p_value = |values: &[f64]| rank_p_value(values, [0, 8], 4, 0.0);
        let apart = [1.0, 3.0, 3.0, 1.0, 8.0, 6.0, 7.0, 5.0];
        assert!((p_value(&apart) - 2.0 / 70.0).abs() < 1e-12);
        let close = [1.0, 3.0, 3.0, 1.0, 8.0, 6.0, 7.0, 2.0];
        assert!((p_value(&close) - 8.0 / 70.0).abs() < 1e-12);
        assert_eq!(p_value(&[1.0; 8]), 1.0);
    }

    #[test]
    fn squares_by_sums_are_those_of_the_line() {
        let values = scattered(3, |k| 1.0 + 0.1 * (k * k) as f64);
        let sums = Sums::new(&values);
        for (from, to) in [(0, 20), (4, 8), (11, 20)] {
            let part = &values[from..to];
            let n = part.len() as f64;
            let mean = part.iter().sum::<f64>() / n;
            let x = |i: usize| i as f64 - 0.5 * (n - 1.0);
            let xy: f64 = (0..part.len()).map(|i| x(i) * part[i]).sum();
            let xx: f64 = (0..part.len()).map(|i| x(i) * x(i)).sum();
            let residual = |i: usize| part[i] - mean - xy / xx * x(i);
            let expected: f64 = (0..part.len()).map(|i| residual(i).powi(2)).sum();
            let found = sums.squares([from, to]);
            assert!((found - expected).abs() < 1e-9 * expected.max(1.0));
        }
    }

    #[test]
    fn extreme_and_equal_values_have_no_change() {
        assert_eq!(places(&[]), [0; 0]);
        assert_eq!(places(&[1.0; 40]), [0; 0]);
        let mut values = vec![0.0; 30];
        values[12] = 1e300;
        assert_eq!(places(&values), [0; 0]);
        let alternating: Vec<f64> = (0..40)
            .map(|k| if k % 2 == 0 { 1e300 } else { -1e300 })
            .collect();
        places(&alternating);
    }
}
