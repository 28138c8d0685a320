//! Summary of a distribution over the nodes of an axis.

/// Mean, spread and interval of a posterior.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PosteriorSummary {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Central 90 % interval.
    pub interval: [f64; 2],
}

impl PosteriorSummary {
    /// Summarises weights, in any unit, of equally spaced nodes in ascending order.
    pub(super) fn of(nodes: &[f64], weights: &[f64]) -> Self {
        let sum: f64 = weights.iter().sum();
        let mean = |of: &dyn Fn(f64) -> f64| {
            let parts = nodes.iter().zip(weights);
            parts.map(|(node, weight)| of(*node) * weight).sum::<f64>() / sum
        };
        let middle = mean(&|x| x);
        let variance = mean(&|x| (x - middle).powi(2));
        Self {
            mean: middle,
            deviation: variance.max(0.0).sqrt(),
            interval: [0.05, 0.95].map(|share| quantile(nodes, weights, share)),
        }
    }
}

/// Returns the quantile at `share`; the weight of a node is spread evenly half way to its neighbours.
fn quantile(nodes: &[f64], weights: &[f64], share: f64) -> f64 {
    let (&[first, ..], &[.., last]) = (nodes, nodes) else {
        return f64::NAN;
    };
    let step = (last - first) / (nodes.len() - 1).max(1) as f64;
    let mut left = share * weights.iter().sum::<f64>();
    for (node, weight) in nodes.iter().zip(weights) {
        if left <= *weight && *weight > 0.0 {
            return (node + step * (left / weight - 0.5)).clamp(first, last);
        }
        left -= weight;
    }
    last
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normal_distribution_is_summed_up() {
        let nodes: Vec<f64> = (0..41).map(|i| -5.0 + 0.25 * f64::from(i)).collect();
        let weights: Vec<f64> = nodes.iter().map(|x| libm::exp(-0.5 * x * x)).collect();
        let PosteriorSummary {
            mean,
            deviation,
            interval: [low, high],
        } = PosteriorSummary::of(&nodes, &weights);
        assert!(mean.abs() < 1e-9 && (deviation - 1.0).abs() < 1e-3);
        // Φ(1.6449) = 0.95; spreading a node's weight evenly adds a little.
        assert!(
            (high - 1.645).abs() < 0.02 && (low + 1.645).abs() < 0.02,
            "{low} {high}"
        );
        let one = PosteriorSummary::of(&[0.3], &[2.0]);
        assert_eq!(
            (one.mean, one.deviation, one.interval),
            (0.3, 0.0, [0.3; 2])
        );
    }
}
