//! Joint posterior of several laws, each of which uses the data of the others.

use super::Fit;
use super::grid::log_sum;
use nalgebra::{Cholesky, DMatrix};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Values of ρ, the correlation of laws [1]; all have the same prior probability.
const COMMON: [f64; 4] = [0.0, 0.3, 0.6, 0.9];
/// Number of Gibbs sweeps that count, and of sweeps before them that do not.
const SWEEPS: usize = 2000;
const FIRST_SWEEPS: usize = 200;

/// Returns the posterior weights of each law's nodes of (ln σ, μ); `names`: tool and medium of each law.
pub(super) fn posteriors(fits: &[Fit], names: &[[&str; 2]], seed: u64) -> Vec<Vec<f64>> {
    let laws: Vec<Law> = fits.iter().map(Law::of).collect();
    if let [law] = &laws[..] {
        // A single law has no other law whose data it could use.
        return vec![law.weights_given([0.0; 2], 1.0)];
    }
    let priors: Vec<Common> = COMMON
        .iter()
        .filter_map(|c| Common::of(*c, names))
        .collect();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut sums: Vec<Vec<f64>> = laws.iter().map(|law| vec![0.0; law.log.len()]).collect();
    // Deviation of each μ and each ln σ from its entry, in prior standard deviations.
    let mut off = [vec![0.0; laws.len()], vec![0.0; laws.len()]];
    for sweep in 0..FIRST_SWEEPS + SWEEPS {
        let logs: Vec<f64> = priors.iter().map(|prior| prior.log_density(&off)).collect();
        let prior = &priors[draw_index(&weights(&logs), &mut random)];
        for (index, law) in laws.iter().enumerate() {
            let means = [0, 1].map(|axis| prior.mean_of(index, &off[axis]));
            let given = law.weights_given(means, prior.variance_of(index));
            let node = draw_index(&given, &mut random);
            [off[0][index], off[1][index]] = law.scores(node);
            if sweep >= FIRST_SWEEPS {
                for (sum, weight) in sums[index].iter_mut().zip(given) {
                    *sum += weight;
                }
            }
        }
    }
    sums
}

/// Likelihood of a law over its deviations from the entry.
struct Law {
    /// Deviations of the nodes of μ and of ln σ, in prior standard deviations.
    scores: [Vec<f64>; 2],
    /// Log-likelihoods of the nodes of (ln σ, μ).
    log: Vec<f64>,
}

impl Law {
    fn of(fit: &Fit) -> Self {
        let scores = |axis: usize, nodes: &[f64]| {
            let scores = nodes.iter().map(|node| fit.prior.score(axis, *node));
            scores.collect()
        };
        Self {
            scores: [scores(0, &fit.grid.mu), scores(1, &fit.grid.ln_sigma)],
            log: fit.grid.log_of_laws(&fit.prior),
        }
    }

    /// Returns the weights of the nodes, with sum 1, under normal priors of the two deviations with these means.
    fn weights_given(&self, means: [f64; 2], variance: f64) -> Vec<f64> {
        let log = |axis: usize| {
            let of = move |score: &f64| -0.5 * (score - means[axis]).powi(2) / variance;
            self.scores[axis].iter().map(of).collect::<Vec<f64>>()
        };
        let (of_mu, of_sigma) = (log(0), log(1));
        let rows = self.log.chunks(of_mu.len()).zip(&of_sigma);
        let logs = rows.flat_map(|(row, of_sigma)| {
            let row = row.iter().zip(&of_mu);
            row.map(move |(log, of_mu)| log + of_mu + of_sigma)
        });
        weights(&logs.collect::<Vec<f64>>())
    }

    fn scores(&self, node: usize) -> [f64; 2] {
        let count = self.scores[0].len();
        [self.scores[0][node % count], self.scores[1][node / count]]
    }
}

/// Multivariate normal prior of the deviations of all laws.
struct Common {
    precision: DMatrix<f64>,
    log_determinant: f64,
}

impl Common {
    fn of(common: f64, names: &[[&str; 2]]) -> Option<Self> {
        let correlation = |i: usize, j: usize| {
            let [a, b] = [names[i], names[j]];
            let shared =
                1.0 + f64::from(u8::from(a[0] == b[0])) + f64::from(u8::from(a[1] == b[1]));
            let own = if i == j { 1.0 - common } else { 0.0 };
            own + common * shared / 3.0
        };
        let count = names.len();
        let factor = Cholesky::new(DMatrix::from_fn(count, count, correlation))?;
        let diagonal = factor.l_dirty().diagonal();
        Some(Self {
            log_determinant: 2.0 * diagonal.iter().map(|d| libm::log(*d)).sum::<f64>(),
            precision: factor.inverse(),
        })
    }

    /// Returns the log-density of the deviations of all μ and all ln σ, up to a constant.
    fn log_density(&self, off: &[Vec<f64>; 2]) -> f64 {
        let squared = |scores: &[f64]| {
            let scores = nalgebra::DVector::from_column_slice(scores);
            scores.dot(&(&self.precision * &scores))
        };
        -0.5 * (squared(&off[0]) + squared(&off[1])) - self.log_determinant
    }

    /// Returns the conditional mean of one deviation, given those of the other laws.
    fn mean_of(&self, index: usize, scores: &[f64]) -> f64 {
        // Conditional mean of a zero-mean normal with precision P: −Σⱼ≠ᵢ Pᵢⱼ xⱼ / Pᵢᵢ.
        let others = scores.iter().enumerate().filter(|(i, _)| *i != index);
        let pull: f64 = others
            .map(|(i, score)| self.precision[(index, i)] * score)
            .sum();
        -pull * self.variance_of(index)
    }

    fn variance_of(&self, index: usize) -> f64 {
        1.0 / self.precision[(index, index)]
    }
}

/// Returns weights with sum 1 from their logarithms.
fn weights(logs: &[f64]) -> Vec<f64> {
    let whole = log_sum(logs.iter().copied());
    logs.iter().map(|log| libm::exp(log - whole)).collect()
}

/// Draws an index by weights with sum 1.
fn draw_index(weights: &[f64], random: &mut ChaCha8Rng) -> usize {
    let mut left = random.random::<f64>();
    let found = weights.iter().position(|weight| {
        left -= weight;
        left < 0.0
    });
    found.unwrap_or(weights.len() - 1)
}
