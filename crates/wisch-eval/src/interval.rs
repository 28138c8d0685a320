//! Confidence intervals of counted shares.

/// Number of bisection steps for a bound.
const HALVINGS: usize = 60;

/// Returns the 95 % confidence interval of a share for `hits` out of `trials` (Clopper and Pearson, 1934).
///
/// ```
/// let [low, high] = wisch_eval::binomial_interval(9, 10);
/// assert!((low - 0.5550).abs() < 1e-4 && (high - 0.9975).abs() < 1e-4);
/// ```
pub fn binomial_interval(hits: usize, trials: usize) -> [f64; 2] {
    let bound = |target: f64, at: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if at(middle) < target {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    };
    let low = if hits == 0 {
        0.0
    } else {
        bound(0.025, &|share| 1.0 - sum_binomial(hits - 1, trials, share))
    };
    let high = if hits >= trials {
        1.0
    } else {
        bound(0.975, &|share| 1.0 - sum_binomial(hits, trials, share))
    };
    [low, high]
}

/// Returns the probability of at most `hits` out of `trials` (binomial distribution).
fn sum_binomial(hits: usize, trials: usize, share: f64) -> f64 {
    if share <= 0.0 {
        return 1.0;
    }
    if share >= 1.0 {
        return if hits >= trials { 1.0 } else { 0.0 };
    }
    let (n, odds) = (trials as f64, libm::log(share) - libm::log1p(-share));
    let mut term = n * libm::log1p(-share);
    let mut sum = libm::exp(term);
    for k in 1..=hits {
        let k = k as f64;
        term += libm::log((n - k + 1.0) / k) + odds;
        sum += libm::exp(term);
    }
    sum.min(1.0)
}

#[cfg(test)]
mod tests {
    use super::binomial_interval;

    #[test]
    fn the_bounds_are_those_of_tables() {
        // Clopper and Pearson's own figures, and the rule of three.
        for (hits, trials, expected) in [
            (0, 10, [0.0, 0.3085]),
            (10, 10, [0.6915, 1.0]),
            (5, 10, [0.1871, 0.8129]),
            (900, 1000, [0.8797, 0.9179]),
        ] {
            let found = binomial_interval(hits, trials);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-4, "{hits}/{trials}: {found}");
            }
        }
    }
}
