//! Likelihood that a contact affects a particle, by its force.

/// Distribution of the least normalised contact force f′ at which the tool affects a particle, ln X ~ N(μ, σ) (equation
/// 12, Fig. 11).
///
/// A small σ gives a steep curve: above the median nearly every contact works. A large σ gives a flat one: even full
/// force may have no effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogNormal {
    /// Mean of ln x; exp(μ) is the median of x.
    pub mu: f64,
    /// Standard deviation of ln x, above 0.
    pub sigma: f64,
}

/// Uncertainty of the parameters of a [`LogNormal`], as standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogNormalSpread {
    /// Standard deviation of μ \[1\].
    pub mu: f64,
    /// Standard deviation of ln σ \[1\].
    pub ln_sigma: f64,
}

impl LogNormalSpread {
    /// No spread: both parameters are known exactly.
    pub const NONE: Self = Self {
        mu: 0.0,
        ln_sigma: 0.0,
    };
}

impl Default for LogNormalSpread {
    /// Spread of estimated values that were never measured.
    fn default() -> Self {
        Self {
            mu: 0.3,
            ln_sigma: 0.2,
        }
    }
}

/// How a particle that has not responded draws its threshold again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Redraw {
    /// ℓ: travel in contact after which it draws again \[m\]; `None` for the radius r_s of the tool's collision sphere.
    pub length_m: Option<f64>,
    /// Standard deviation of ln ℓ \[1\].
    pub ln_length_spread: f64,
    /// Probability that a particle keeps its threshold permanently \[1\]: a particle that does not
    /// respond once never responds to an equal force.
    pub kept_share: f64,
}

impl Default for Redraw {
    /// Values for a tool and medium without measurements.
    fn default() -> Self {
        Self {
            length_m: None,
            ln_length_spread: 0.5,
            kept_share: 0.5,
        }
    }
}

impl LogNormal {
    /// Returns P(X ≤ f′), the probability that contact at the normalised force f′ ∈ [0, 1] affects a particle. It is 0
    /// without force and for NaN.
    ///
    /// ```
    /// use wisch::represent::LogNormal;
    /// let median = 0.35_f64;
    /// let likelihood = LogNormal { mu: median.ln(), sigma: 0.25 };
    /// assert!((likelihood.probability(median) - 0.5).abs() < 1e-12);
    /// assert_eq!(likelihood.probability(0.0), 0.0);
    /// ```
    pub fn probability(&self, normalized_force: f64) -> f64 {
        if normalized_force > 0.0 {
            let standard_score = (libm::log(normalized_force) - self.mu) / self.sigma;
            0.5 * libm::erfc(-standard_score * std::f64::consts::FRAC_1_SQRT_2)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_standard_normal_table_is_met() {
        // Φ(1), Φ(-2) from Abramowitz & Stegun, table 26.1.
        let likelihood = LogNormal {
            mu: 0.0,
            sigma: 1.0,
        };
        let e = std::f64::consts::E;
        assert!((likelihood.probability(e) - 0.841_344_746_068_543).abs() < 1e-14);
        assert!((likelihood.probability(e.powi(-2)) - 0.022_750_131_948_179).abs() < 1e-14);
    }

    proptest! {
        #[test]
        fn more_force_is_never_less_likely(
            mu in -5.0..5.0_f64, sigma in 0.01..5.0_f64, weak in 0.0..1.0_f64, more in 0.0..1.0_f64
        ) {
            let likelihood = LogNormal { mu, sigma };
            let (low, high) = (likelihood.probability(weak), likelihood.probability(weak + more));
            prop_assert!((0.0..=1.0).contains(&low) && low <= high && high <= 1.0);
        }
    }
}
