//! Robust lines through the values of a series, with the probability that chance explains their slope.

use super::median::{DEVIATION_OF_MEDIAN, median};

/// Number of points from which a line is computed; longer series are divided into equal blocks, each with its median.
const MOST_POINTS: usize = 60;
/// Number of points up to which the distribution of Kendall's S is exact; above, it is close to normal.
const MOST_EXACT: usize = 30;
/// Quantile of the normal distribution that leaves 2.5 % above it.
const TWO_SIDED_95: f64 = 1.959_964;

/// A line through the values of a series, which single outliers do not move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RobustLine {
    /// Slope, and its 95 % interval.
    pub slope: f64,
    pub slope_within: [f64; 2],
    /// Probability that values without a slope are at least as ordered \[1\].
    pub p: f64,
    /// The least probability that values of this number can have \[1\].
    pub least_p: f64,
    /// First and last value of the line.
    pub ends: [f64; 2],
    /// Half of the approximate 95 % interval of the last value of the line.
    pub uncertainty: f64,
}

impl RobustLine {
    /// Fits a line through equidistant values, see [`Self::fit_at`].
    pub fn fit(values: &[f64], scatter: f64) -> Self {
        let at: Vec<f64> = (0..values.len()).map(|k| k as f64).collect();
        Self::fit_at(&at, values, scatter)
    }

    /// Fits a line: the median slope of all pairs of values (Theil 1950), its interval (Sen 1968), and Kendall's test (1938).
    ///
    /// `at`: abscissa of each value, in increasing order. `scatter`: least standard deviation of
    /// the values. Pairs of equal values count against a slope.
    #[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
    pub fn fit_at(at: &[f64], values: &[f64], scatter: f64) -> Self {
        let size = values.len().div_ceil(MOST_POINTS).max(1);
        // The oldest values, which do not fill a block, are left out.
        let from = values.len() % size;
        let blocks = values[from..].chunks(size);
        let points: Vec<f64> = blocks.map(|block| median(&mut block.to_vec())).collect();
        let blocks = at[from..].chunks(size);
        let places: Vec<f64> = blocks
            .map(|block| block.iter().sum::<f64>() / block.len() as f64)
            .collect();
        let mut slopes = Vec::with_capacity(points.len() * points.len() / 2);
        let mut order = 0_i64;
        for (j, later) in points.iter().enumerate() {
            for (i, earlier) in points[..j].iter().enumerate() {
                let rise = later - earlier;
                order += i64::from(rise > 0.0) - i64::from(rise < 0.0);
                slopes.push(rise / (places[j] - places[i]));
            }
        }
        let slope = median(&mut slopes);
        let kendall = Kendall::of(points.len());
        let slope_within = match kendall.left_out() {
            Some(count) if count < slopes.len() => {
                let last = slopes.len() - 1;
                [count, last - count].map(|place| {
                    let (_, &mut at, _) = slopes.select_nth_unstable_by(place, f64::total_cmp);
                    at
                })
            }
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let residuals = points.iter().zip(&places);
        let mut residuals: Vec<f64> = residuals.map(|(y, place)| y - slope * place).collect();
        let begin = median(&mut residuals);
        residuals
            .iter_mut()
            .for_each(|residual| *residual = (*residual - begin).abs());
        let n = points.len().max(1) as f64;
        // The median deviation of few values is too small by about this factor (Croux and Rousseeuw 1992).
        let few = n / (n - 0.8);
        let deviation = few * DEVIATION_OF_MEDIAN * median(&mut residuals);
        let deviation = deviation.max(scatter / (size as f64).sqrt());
        // Student's quantile, from above, for n − 2 degrees of freedom; at its end, a line varies by 2 σ / √n.
        let student = TWO_SIDED_95 * (1.0 + 1.9 / (n - 2.0).max(1.0));
        Self {
            slope,
            slope_within,
            p: kendall.p_value(order.unsigned_abs() as usize),
            least_p: kendall.least_p_value(),
            ends: [at.first(), at.last()].map(|at| begin + slope * at.copied().unwrap_or(0.0)),
            uncertainty: student * 2.0 * deviation / n.sqrt(),
        }
    }
}

/// Distribution of Kendall's S, the pairs in order less those against it, of a number of values in random order.
struct Kendall {
    pairs: usize,
    /// Probabilities of 0, 1, … pairs against the order; empty for a normal distribution.
    exact: Vec<f64>,
    deviation: f64,
}

#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
impl Kendall {
    fn of(count: usize) -> Self {
        let pairs = count * count.saturating_sub(1) / 2;
        let n = count as f64;
        let mut exact = Vec::new();
        if count <= MOST_EXACT {
            // The next value stands before any number of the earlier ones with the same probability.
            exact = vec![1.0];
            for added in 1..=count {
                let longer = exact.len() + added - 1;
                let next = (0..longer).map(|k| {
                    let from = (k + 1).saturating_sub(added);
                    let to = (k + 1).min(exact.len());
                    exact[from..to].iter().sum::<f64>() / added as f64
                });
                exact = next.collect();
            }
        }
        Self {
            pairs,
            exact,
            deviation: (n * (n - 1.0) * (2.0 * n + 5.0) / 18.0).max(0.0).sqrt(),
        }
    }

    /// Returns the least probability that values can have, those in order \[1\].
    fn least_p_value(&self) -> f64 {
        self.p_value(self.pairs)
    }

    /// Returns the probability that |S| is at least a number \[1\].
    fn p_value(&self, order: usize) -> f64 {
        if order == 0 {
            return 1.0;
        }
        if self.exact.is_empty() {
            return 2.0 * upper_tail((order as f64 - 1.0) / self.deviation);
        }
        let against = self.pairs.saturating_sub(order) / 2;
        let tail: f64 = self.exact[..=against].iter().sum();
        (2.0 * tail).min(1.0)
    }

    /// Returns the number of slopes beyond either end of the 95 % interval; `None` if there are too few for an interval.
    fn left_out(&self) -> Option<usize> {
        if self.exact.is_empty() {
            let beyond = 0.5 * (self.pairs as f64 - TWO_SIDED_95 * self.deviation) - 1.0;
            return Some(beyond.max(0.0) as usize);
        }
        let mut tail = 0.0;
        let is_within = |p: &&f64| {
            tail += **p;
            2.0 * tail <= 0.05
        };
        let beyond = self.exact.iter().take_while(is_within).count();
        beyond.checked_sub(1)
    }
}

/// Returns the probability that a standard normal number is at least `z`, for z ≥ 0 \[1\].
fn upper_tail(z: f64) -> f64 {
    let density = (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt();
    if z < 2.0 {
        // Φ(z) − 1/2 = φ(z) (z + z³/3 + z⁵/(3·5) + …).
        let mut term = z;
        let mut sum = z;
        for k in 1..60 {
            term *= z * z / f64::from(2 * k + 1);
            sum += term;
        }
        return 0.5 - density * sum;
    }
    // Laplace's continued fraction: φ(z) / (z + 1 / (z + 2 / (z + …))).
    let fraction = (1..=80).rev().fold(z, |below, k| z + f64::from(k) / below);
    density / fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_recovered_whatever_single_values_are() {
        let mut values: Vec<f64> = (0..12).map(|x| 3.0 - 0.25 * f64::from(x)).collect();
        values[4] = 1e6;
        let line = RobustLine::fit(&values, 0.0);
        for (found, is) in [
            (line.slope, -0.25),
            (line.ends[0], 3.0),
            (line.ends[1], 0.25),
        ] {
            assert!((found - is).abs() < 1e-9, "{found} for {is}");
        }
        assert!(line.p < 1e-3);
    }

    #[test]
    fn a_long_series_is_fitted_in_blocks() {
        let values: Vec<f64> = (0..12_345).map(|x| 2.0 + 0.5 * f64::from(x)).collect();
        let line = RobustLine::fit(&values, 0.0);
        assert!((line.slope - 0.5).abs() < 1e-12 && (line.ends[0] - 2.0).abs() < 1e-6);
        assert!((line.ends[1] - 6174.0).abs() < 1e-6, "{line:?}");
    }

    #[test]
    fn equal_and_few_values_show_no_slope() {
        let line = RobustLine::fit(&[2.0; 9], 0.1);
        assert_eq!((line.slope, line.p, line.ends), (0.0, 1.0, [2.0; 2]));
        assert_eq!(line.slope_within, [0.0; 2]);
        for count in 0..4 {
            let line = RobustLine::fit(&[1.0, 2.0, 3.0][..count.min(3)], 0.1);
            assert_eq!(line.slope_within, [f64::NEG_INFINITY, f64::INFINITY]);
            assert!(line.p > 0.3);
        }
    }

    #[test]
    fn p_values_are_those_of_tables() {
        // Kendall 1948, table 1: 5 values in order by chance 1 / 120; S ≥ 8 by 5 / 120.
        let five = Kendall::of(5);
        assert!((five.p_value(10) - 2.0 / 120.0).abs() < 1e-12);
        assert!((five.p_value(8) - 10.0 / 120.0).abs() < 1e-12);
        assert_eq!(five.left_out(), Some(0));
        // 30 values: the normal distribution is close.
        let (exact, mut normal) = (Kendall::of(30), Kendall::of(30));
        normal.exact.clear();
        for order in [31, 101, 151] {
            let ratio = normal.p_value(order) / exact.p_value(order);
            assert!((0.9..1.3).contains(&ratio), "{order}: {ratio}");
        }
        for (z, tail) in [
            (0.0, 0.5),
            (1.0, 0.158_655_25),
            (1.959_964, 0.025),
            (5.0, 2.866_515_7e-7),
        ] {
            assert!((upper_tail(z) / tail - 1.0).abs() < 1e-6, "{z}");
        }
    }
}
