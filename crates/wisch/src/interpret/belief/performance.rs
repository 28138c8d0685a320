//! Belief about the performance: a distribution over [0, 1].

use crate::represent::{GoalState, ParticleDistribution, Performance, Surface};

/// Steps of the grid on [0, 1] over which the CRPS is integrated.
const SCORE_STEPS: usize = 2000;
/// Steps on [0, 1] of the uniform distribution of an unknown performance.
const UNKNOWN_STEPS: u32 = 100;
/// Bisection steps to a quantile.
const HALVINGS: usize = 40;

/// A mean in [0, 1] with its 90 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Expected value.
    pub mean: f64,
    /// 5th percentile.
    pub low: f64,
    /// 95th percentile.
    pub high: f64,
}

/// Belief about a performance in [0, 1]: a mixture over the members, by weight. Each component is a normal distribution
/// whose standard deviation is the model error, cut off at 0 and 1.
///
/// ```
/// use wisch::interpret::PerformanceDistribution;
/// let belief = PerformanceDistribution::from_shares([(0.9, 1.0), (1.0, 3.0)], 0.0);
/// assert_eq!(belief.mean(), 0.975);
/// assert_eq!(belief.quantile(0.2), 0.9);
/// assert_eq!(belief.probability_below(0.95), 0.25);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PerformanceDistribution {
    /// Performances with their weights, sorted by performance; the weights sum to 1.
    shares: Vec<(f64, f64)>,
    mean: f64,
    deviation: f64,
}

impl PerformanceDistribution {
    /// Returns a mixture of performances with weights of any positive sum; `deviation` is the standard deviation of
    /// each component \[1\].
    pub fn from_shares(shares: impl IntoIterator<Item = (f64, f64)>, deviation: f64) -> Self {
        let mut shares: Vec<(f64, f64)> = shares.into_iter().collect();
        shares.sort_by(|a, b| a.0.total_cmp(&b.0));
        shares.dedup_by(|next, kept| {
            let is_same = next.0 == kept.0;
            if is_same {
                kept.1 += next.1;
            }
            is_same
        });
        let sum: f64 = shares.iter().map(|(_, weight)| weight).sum();
        for (_, weight) in &mut shares {
            *weight /= sum;
        }
        let mean: f64 = shares.iter().map(|(share, weight)| share * weight).sum();
        // Rounding must not move the mean of equal shares away from them.
        let [least, most] = [shares.first(), shares.last()].map(|end| end.map_or(0.0, |end| end.0));
        Self {
            mean: mean.clamp(least, most),
            shares,
            deviation,
        }
    }

    /// Returns the distribution if the performance is unknown with this probability [1], that is uniform from `least` to 1.
    #[must_use]
    pub(in crate::interpret) fn or_unknown(&self, probability: f64, least: f64) -> Self {
        if probability <= 0.0 {
            return self.clone();
        }
        let step = probability / f64::from(UNKNOWN_STEPS + 1);
        let unknown = (0..=UNKNOWN_STEPS).map(|i| {
            let share = f64::from(i) / f64::from(UNKNOWN_STEPS);
            (least + (1.0 - least) * share, step)
        });
        let known = self
            .shares
            .iter()
            .map(|(share, weight)| (*share, weight * (1.0 - probability)));
        Self::from_shares(known.chain(unknown), self.deviation)
    }

    pub(super) fn of(
        members: &[ParticleDistribution],
        weights: &[f64],
        goal: &GoalState,
        surface: &Surface,
        deviation: f64,
    ) -> Self {
        let share = |member| Performance::evaluate(member, goal, surface).ratio();
        let shares = members.iter().map(share).zip(weights.iter().copied());
        Self::from_shares(shares, deviation)
    }

    /// Expected performance \[1\], from 0 to 1.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Returns the probability that the performance is below a value \[1\].
    pub fn probability_below(&self, value: f64) -> f64 {
        if value > 1.0 {
            return 1.0;
        }
        if value <= 0.0 {
            return 0.0;
        }
        if self.deviation == 0.0 {
            let below = self.shares.iter().filter(|(share, _)| *share < value);
            return below.map(|(_, weight)| weight).sum();
        }
        self.cumulative(value)
    }

    /// Returns the performance below which `probability`, in (0, 1), of the distribution lies \[1\].
    pub fn quantile(&self, probability: f64) -> f64 {
        if self.deviation == 0.0 {
            let mut sum = 0.0;
            let reached = self.shares.iter().find(|(_, weight)| {
                sum += weight;
                // A remainder of this size comes from rounding.
                sum >= probability - 1e-12
            });
            return reached.or(self.shares.last()).map_or(0.0, |share| share.0);
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.cumulative(middle) < probability {
                low = middle;
            } else {
                high = middle;
            }
        }
        if high == 1.0 { 1.0 } else { 0.5 * (low + high) }
    }

    /// Returns the ends of the central interval that holds `share` of the probability \[1\].
    pub fn interval(&self, share: f64) -> [f64; 2] {
        let outside = 0.5 * (1.0 - share);
        [self.quantile(outside), self.quantile(1.0 - outside)]
    }

    /// Returns the mean with the 90 % interval.
    pub fn estimate(&self) -> Estimate {
        let [low, high] = self.interval(0.9);
        // The mean of very unequal shares may lie beyond a quantile.
        Estimate {
            mean: self.mean,
            low: low.min(self.mean),
            high: high.max(self.mean),
        }
    }

    /// Returns the continuous ranked probability score of an outcome \[1\]: the integral of the squared difference
    /// between the cumulative probability and the step at the outcome. A certain and correct belief scores 0 (Gneiting
    /// and Raftery 2007).
    pub fn score(&self, outcome: f64) -> f64 {
        let step = 1.0 / SCORE_STEPS as f64;
        let at = |i: usize| {
            let value = (i as f64 + 0.5) * step;
            let is_reached = if value >= outcome { 1.0 } else { 0.0 };
            (self.probability_below(value) - is_reached).powi(2) * step
        };
        (0..SCORE_STEPS).map(at).sum()
    }

    fn cumulative(&self, value: f64) -> f64 {
        let one = |(share, weight): &(f64, f64)| {
            let score = (share - value) / self.deviation;
            weight * 0.5 * libm::erfc(score * std::f64::consts::FRAC_1_SQRT_2)
        };
        self.shares.iter().map(one).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blurred_belief_is_normal_and_cut_off() {
        let belief = PerformanceDistribution::from_shares([(0.5, 1.0)], 0.1);
        assert!((belief.quantile(0.05) - (0.5 - 0.164_485)).abs() < 1e-5);
        assert!((belief.probability_below(0.6) - 0.841_345).abs() < 1e-5);
        let full = PerformanceDistribution::from_shares([(1.0, 2.0)], 0.1);
        assert_eq!(full.quantile(0.95), 1.0);
        assert!((full.quantile(0.05) - (1.0 - 0.164_485)).abs() < 1e-5);
        assert_eq!([full.mean(), full.probability_below(1.1)], [1.0, 1.0]);
    }

    #[test]
    fn a_score_is_that_of_the_closed_form() {
        // A normal belief about its own mean has a score of 0.2337 standard deviations.
        let belief = PerformanceDistribution::from_shares([(0.5, 1.0)], 0.05);
        assert!((belief.score(0.5) - 0.233_695 * 0.05).abs() < 1e-5);
        // Two certain members, at the mean of which the outcome lies: a quarter of their distance.
        let two = PerformanceDistribution::from_shares([(0.2, 1.0), (0.6, 1.0)], 0.0);
        assert!((two.score(0.2) - 0.1).abs() < 1e-3);
        let sure = PerformanceDistribution::from_shares([(0.7, 1.0)], 0.0);
        assert!(sure.score(0.7) < 1e-3 && (sure.score(0.9) - 0.2).abs() < 1e-3);
    }
}
