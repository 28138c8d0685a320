//! Likelihood of the observations on a grid of laws.

use super::evidence::{Group, RoundEvidence};
use crate::represent::{Interaction, LogNormal};
use rayon::prelude::*;

/// Half the range of each parameter on the first grid, in standard deviations of its prior [1].
const REACH: [f64; 3] = [5.0, 4.0, 3.0];
/// Number of nodes of the axes of μ, ln σ and ln ℓ.
const NODES: [usize; 3] = [31, 13, 13];
/// Logarithm of the ratio to the peak below which a posterior is neglected.
const NEGLIGIBLE: f64 = -11.0;
/// Largest number of grids, each within the previous one.
const PASSES: usize = 6;
/// Ratio of the widths of a new grid and the last one above which refinement ends [1].
const NARROWER: f64 = 0.6;
/// Fall of the log-posterior from its peak to the neighbouring nodes, over all axes, up to which the peak is resolved.
const FINE: f64 = 4.0;
/// Factor on the number of nodes of a grid that is not resolved and cannot be narrower [1].
const FINER: f64 = 1.4;
/// Least distance of the nodes of μ [1]; much less than the uncertainty of the force.
const LEAST_STEP: f64 = 0.01;

/// Least f′ that differs from no contact [1].
const LEAST_SHARE: f64 = 0.01;
const BINS_PER_LOG: f64 = 100.0;
/// Largest f′ that has a bin of its own [1].
const MOST_SHARE: f64 = 10.0;

/// Largest error of a round's force, in standard deviations, and number of steps to it [1].
const SHIFT_REACH: f64 = 2.5;
const SHIFTS: i32 = 10;

/// Prior of a law.
#[derive(Debug, Clone, Copy)]
pub(super) struct LawPrior {
    /// Means and standard deviations of μ, ln σ and ln ℓ.
    pub(super) of: [[f64; 2]; 3],
    /// Probability that particles keep their thresholds [1].
    pub(super) kept: f64,
}

impl LawPrior {
    pub(super) fn of(interaction: &Interaction, collision_radius_m: f64) -> Self {
        let (law, spread) = (&interaction.likelihood, &interaction.likelihood_spread);
        let redraw = &interaction.redraw;
        let length = redraw.length_m.unwrap_or(collision_radius_m);
        Self {
            of: [
                [law.mu, spread.mu],
                [libm::log(law.sigma), spread.ln_sigma],
                [libm::log(length), redraw.ln_length_spread],
            ],
            kept: redraw.kept_share,
        }
    }

    /// Returns the deviation of a value from its prior mean, in standard deviations.
    pub(super) fn score(&self, axis: usize, value: f64) -> f64 {
        let [mean, deviation] = self.of[axis];
        if deviation > 0.0 {
            (value - mean) / deviation
        } else {
            0.0
        }
    }

    /// Returns the log-probabilities of the nodes of ln ℓ and, last, of kept thresholds.
    fn log_redraw(&self, nodes: &[f64]) -> Vec<f64> {
        let step = match (nodes, self.of[2][1]) {
            ([first, second, ..], deviation) if deviation > 0.0 => (second - first) / deviation,
            _ => (std::f64::consts::TAU).sqrt(),
        };
        let density = 1.0 / std::f64::consts::TAU.sqrt();
        let drawn = libm::log((1.0 - self.kept) * step * density);
        let node = |node: &f64| drawn - 0.5 * self.score(2, *node).powi(2);
        let nodes = nodes.iter().map(node);
        nodes.chain([libm::log(self.kept)]).collect()
    }
}

/// Log-likelihoods at the nodes of (ln σ, redraw mode, μ), the last index fastest. The redraw modes are the nodes of ln
/// ℓ and, last, kept thresholds.
#[derive(Debug, Clone)]
pub(super) struct LikelihoodGrid {
    pub(super) mu: Vec<f64>,
    pub(super) ln_sigma: Vec<f64>,
    pub(super) ln_length: Vec<f64>,
    log: Vec<f64>,
}

/// Draws of a particle as bins of ln f′: each distinct sequence among the guesses, with its weight.
struct Draws {
    guesses: Vec<(f64, Vec<Vec<u16>>, [u16; 2])>,
}

impl LikelihoodGrid {
    /// Returns a grid as fine as the posterior demands.
    pub(super) fn refine(rounds: &[RoundEvidence<'_>], prior: &LawPrior, force_share: f64) -> Self {
        let axis = |range: [f64; 2], count: usize, least: f64| -> Vec<f64> {
            let [low, high] = range;
            if high <= low {
                return vec![low];
            }
            let most = ((high - low) / least).ceil() as usize + 1;
            let count = count.min(most.max(3));
            let at = |i: usize| low + (high - low) * i as f64 / (count - 1) as f64;
            (0..count).map(at).collect()
        };
        let least = [LEAST_STEP, 1e-3, 1e-3];
        let mut ranges: [[f64; 2]; 3] = std::array::from_fn(|k| {
            let [mean, deviation] = prior.of[k];
            let reach = REACH[k] * deviation;
            [mean - reach, mean + reach]
        });
        let (mut pass, mut finer) = (0, 1.0);
        loop {
            let nodes = NODES.map(|nodes| (nodes as f64 * finer) as usize);
            let [mu, ln_sigma, ln_length] =
                std::array::from_fn(|k| axis(ranges[k], nodes[k], least[k]));
            let grid = Self::over(rounds, mu, ln_sigma, ln_length, force_share);
            pass += 1;
            let (narrowed, slack) = grid.supports(prior);
            let is_narrower = (0..3).any(|k| {
                let [before, after] = [ranges[k], narrowed[k]].map(|[low, high]| high - low);
                after < NARROWER * before
            });
            if pass == PASSES || (!is_narrower && slack <= FINE) {
                return grid;
            }
            if !is_narrower {
                finer *= FINER;
            }
            ranges = narrowed;
        }
    }

    fn over(
        rounds: &[RoundEvidence<'_>],
        mu: Vec<f64>,
        ln_sigma: Vec<f64>,
        ln_length: Vec<f64>,
        force_share: f64,
    ) -> Self {
        let lengths: Vec<f64> = ln_length.iter().map(|node| libm::exp(*node)).collect();
        let draws: Vec<Vec<Vec<Draws>>> = rounds
            .par_iter()
            .map(|round| {
                let of_group = |group: &Group<'_>| {
                    let members = group.members.iter();
                    members
                        .map(|member| Draws::of(member.exposures, member.earlier, &lengths))
                        .collect()
                };
                round.groups.iter().map(of_group).collect()
            })
            .collect();
        let step = if mu.len() > 1 { mu[1] - mu[0] } else { 0.0 };
        // The margin beyond the ends is for rounds with an error of the force.
        let (wider, margin) = if step > 0.0 && force_share > 0.0 {
            let margin = (SHIFT_REACH * force_share / step).ceil() as usize + 1;
            let count = mu.len() + 2 * margin;
            let at = |i: usize| mu[0] + (i as f64 - margin as f64) * step;
            ((0..count).map(at).collect(), margin)
        } else {
            (mu.clone(), 0)
        };
        let ways = ln_length.len() + 1;
        // Nodes of σ and μ, in parallel.
        let places: Vec<(usize, usize)> = (0..ln_sigma.len())
            .flat_map(|s| (0..wider.len()).map(move |m| (s, m)))
            .collect();
        let raw: Vec<Vec<f64>> = places
            .par_iter()
            .map(|&(s, m)| {
                let law = LogNormal {
                    mu: wider[m],
                    sigma: libm::exp(ln_sigma[s]),
                };
                log_likelihoods(rounds, &draws, &StayTable::of(&law), ways)
            })
            .collect();
        let mut log = Vec::with_capacity(ln_sigma.len() * ways * mu.len());
        for s in 0..ln_sigma.len() {
            let of_sigma = &raw[s * wider.len()..(s + 1) * wider.len()];
            for way in 0..ways {
                let mut sums = vec![0.0; mu.len()];
                for round in 0..rounds.len() {
                    let along: Vec<f64> = (of_sigma.iter())
                        .map(|of_mu| of_mu[round * ways + way])
                        .collect();
                    for (m, sum) in sums.iter_mut().enumerate() {
                        *sum += if margin == 0 {
                            along[m]
                        } else {
                            blur(&along, m + margin, force_share / step)
                        };
                    }
                }
                log.extend(sums);
            }
        }
        Self {
            mu,
            ln_sigma,
            ln_length,
            log,
        }
    }

    /// Returns the log-likelihood at the nodes of ln σ and μ, summed over the redraw modes.
    pub(super) fn log_of_laws(&self, prior: &LawPrior) -> Vec<f64> {
        let ways = prior.log_redraw(&self.ln_length);
        let mut laws = Vec::with_capacity(self.ln_sigma.len() * self.mu.len());
        for s in 0..self.ln_sigma.len() {
            for m in 0..self.mu.len() {
                let terms = (ways.iter().enumerate()).map(|(way, log)| log + self.at(s, way, m));
                laws.push(log_sum(terms));
            }
        }
        laws
    }

    fn at(&self, s: usize, way: usize, m: usize) -> f64 {
        self.log[(s * (self.ln_length.len() + 1) + way) * self.mu.len() + m]
    }

    /// Returns the range of each parameter in which the law's posterior is not negligible, plus one
    /// step; and the largest excess of the posterior between the nodes over the nodes, as a
    /// logarithm.
    fn supports(&self, prior: &LawPrior) -> ([[f64; 2]; 3], f64) {
        let log_prior = |s: usize, m: usize| {
            let scores = [(0, self.mu[m]), (1, self.ln_sigma[s])];
            let scores = scores.map(|(axis, value)| prior.score(axis, value));
            -0.5 * (scores[0].powi(2) + scores[1].powi(2))
        };
        let ways = prior.log_redraw(&self.ln_length);
        let none = f64::NEG_INFINITY;
        let mut most = [
            vec![none; self.mu.len()],
            vec![none; self.ln_sigma.len()],
            vec![none; self.ln_length.len()],
        ];
        for s in 0..self.ln_sigma.len() {
            for m in 0..self.mu.len() {
                for (way, log) in ways.iter().enumerate() {
                    let here = log_prior(s, m) + log + self.at(s, way, m);
                    for (axis, index) in [(0, m), (1, s), (2, way)] {
                        if let Some(known) = most[axis].get_mut(index) {
                            *known = known.max(here);
                        }
                    }
                }
            }
        }
        // On a coarse grid the peak may lie between nodes, above them by less than the fall to the next ones.
        let here =
            |s: usize, way: usize, m: usize| log_prior(s, m) + ways[way] + self.at(s, way, m);
        let slack = self.slack(&here);
        let axes = [&self.mu, &self.ln_sigma, &self.ln_length];
        let ranges = std::array::from_fn(|k| {
            let peak = most[k].iter().copied().fold(none, f64::max);
            let counts = |log: &f64| *log >= peak + NEGLIGIBLE - slack;
            let first = most[k].iter().position(counts).unwrap_or(0);
            let last = most[k].iter().rposition(counts).unwrap_or(0);
            let end = axes[k].len() - 1;
            [
                axes[k][first.saturating_sub(1)],
                axes[k][(last + 1).min(end)],
            ]
        });
        (ranges, slack)
    }

    /// Returns the fall of the log-posterior from its highest node to the neighbours, over all axes; the larger one of
    /// kept and of redrawn thresholds.
    fn slack(&self, log: &dyn Fn(usize, usize, usize) -> f64) -> f64 {
        let (sigmas, lengths, mus) = (self.ln_sigma.len(), self.ln_length.len(), self.mu.len());
        let fall = |ways: std::ops::Range<usize>| {
            let nodes = (0..sigmas).flat_map(|s| {
                let ways = ways.clone();
                ways.flat_map(move |way| (0..mus).map(move |m| (s, way, m)))
            });
            let at = |(s, way, m): &(usize, usize, usize)| log(*s, *way, *m);
            let Some(best) = nodes.max_by(|a, b| at(a).total_cmp(&at(b))) else {
                return 0.0;
            };
            let (s, way, m) = best;
            let falls = |next: [Option<(usize, usize, usize)>; 2]| {
                let next = next.iter().flatten().map(|node| at(&best) - at(node));
                next.filter(|fall| fall.is_finite()).fold(0.0, f64::max)
            };
            let up = |i: usize, count: usize| Some(i + 1).filter(|i| *i < count);
            falls([s.checked_sub(1), up(s, sigmas)].map(|s| Some((s?, way, m))))
                + falls([m.checked_sub(1), up(m, mus)].map(|m| Some((s, way, m?))))
                + if way < lengths {
                    falls([way.checked_sub(1), up(way, lengths)].map(|way| Some((s, way?, m))))
                } else {
                    0.0
                }
        };
        fall(0..lengths).max(fall(lengths..lengths + 1))
    }

    /// Returns the marginal weights of μ and of ln σ, given the joint weights (ln σ, μ).
    pub(super) fn marginals(&self, weights: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let rows = || weights.chunks(self.mu.len());
        let of_mu = |m: usize| rows().map(|row| row[m]).sum();
        let mu = (0..self.mu.len()).map(of_mu).collect();
        (mu, rows().map(|row| row.iter().sum()).collect())
    }

    /// Returns the weights of the nodes of ln ℓ, and the probability that thresholds are kept.
    pub(super) fn redraw(&self, weights: &[f64], prior: &LawPrior) -> (Vec<f64>, f64) {
        let ways = prior.log_redraw(&self.ln_length);
        let mut sums = vec![0.0; ways.len()];
        for s in 0..self.ln_sigma.len() {
            for m in 0..self.mu.len() {
                let logs = (ways.iter().enumerate()).map(|(way, log)| log + self.at(s, way, m));
                let whole = log_sum(logs.clone());
                let weight = weights[s * self.mu.len() + m];
                for (sum, log) in sums.iter_mut().zip(logs) {
                    *sum += weight * libm::exp(log - whole);
                }
            }
        }
        let whole: f64 = sums.iter().sum();
        let kept = sums.pop().unwrap_or(0.0) / whole;
        if sums.iter().sum::<f64>() <= 0.0 {
            // No particle redraws, so ℓ keeps its prior.
            let log = |node: &f64| libm::exp(-0.5 * prior.score(2, *node).powi(2));
            sums = self.ln_length.iter().map(log).collect();
        }
        (sums, kept)
    }
}

/// Returns the logarithm of a sum of exponentials.
pub(super) fn log_sum(terms: impl Iterator<Item = f64> + Clone) -> f64 {
    let most = terms.clone().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY {
        return most;
    }
    most + libm::log(terms.map(|term| libm::exp(term - most)).sum())
}

/// Returns the log of the mean likelihood about a node, over laws that are off by a normal error of `deviation` nodes.
fn blur(along: &[f64], node: usize, deviation: f64) -> f64 {
    let shift = |k: i32| SHIFT_REACH * f64::from(k) / f64::from(SHIFTS);
    let terms = (-SHIFTS..=SHIFTS).map(|k| {
        let at = node as f64 + shift(k) * deviation;
        let below = (at.floor() as usize).min(along.len() - 2);
        let share = at - below as f64;
        let value = along[below] * (1.0 - share) + along[below + 1] * share;
        value - 0.5 * shift(k).powi(2)
    });
    let whole = (-SHIFTS..=SHIFTS).map(|k| -0.5 * shift(k).powi(2));
    log_sum(terms) - log_sum(whole)
}

/// Returns the log-likelihood of each round and redraw mode, the mode fastest.
fn log_likelihoods(
    rounds: &[RoundEvidence<'_>],
    draws: &[Vec<Vec<Draws>>],
    stays: &StayTable,
    ways: usize,
) -> Vec<f64> {
    let mut logs = Vec::with_capacity(rounds.len() * ways);
    let (mut detected, mut work) = (Vec::new(), Vec::new());
    for (round, draws) in rounds.iter().zip(draws) {
        for way in 0..ways {
            let mut sum = 0.0;
            for (group, draws) in round.groups.iter().zip(draws) {
                detected.clear();
                let members = group.members.iter().zip(draws);
                detected.extend(
                    members.map(|(member, draws)| member.detected * draws.stays(stays, way)),
                );
                sum += group.seen.log_likelihood(&detected, &mut work);
            }
            logs.push(sum);
        }
    }
    logs
}

/// Probability 1 − Φ((ln f′ − μ)/σ) of staying, by bin of ln f′.
struct StayTable(Vec<f64>);

impl StayTable {
    fn of(law: &LogNormal) -> Self {
        let bins = bin(MOST_SHARE) + 1;
        let share = |bin: u16| LEAST_SHARE * libm::exp((f64::from(bin) - 0.5) / BINS_PER_LOG);
        // Bin 0 is no contact.
        let of_bin = |bin: u16| match bin {
            0 => 1.0,
            bin => 1.0 - law.probability(share(bin)),
        };
        Self((0..bins).map(of_bin).collect())
    }

    fn at(&self, bin: u16) -> f64 {
        self.0[usize::from(bin)]
    }
}

fn bin(share: f64) -> u16 {
    if share < LEAST_SHARE {
        return 0;
    }
    let log = libm::log(share.min(MOST_SHARE) / LEAST_SHARE);
    1 + (log * BINS_PER_LOG).floor() as u16
}

impl Draws {
    fn of(exposures: &[crate::interpret::Exposure], earlier: &[f64], lengths: &[f64]) -> Self {
        let weight = 1.0 / exposures.len() as f64;
        let mut guesses: Vec<(f64, Vec<Vec<u16>>, [u16; 2])> = Vec::new();
        for (guess, exposure) in exposures.iter().enumerate() {
            let draws = lengths.iter().map(|length| {
                let draws = exposure.draws(*length).into_iter().map(bin);
                // A draw without contact does not change the probability of staying.
                draws.filter(|bin| *bin > 0).collect()
            });
            let draws: Vec<Vec<u16>> = draws.collect();
            let before = earlier.get(guess).map_or(0, |share| bin(*share));
            let kept = [bin(exposure.max_share()).max(before), before];
            let same = guesses
                .iter_mut()
                .find(|(_, d, k)| *d == draws && *k == kept);
            match same {
                Some(same) => same.0 += weight,
                None => guesses.push((weight, draws, kept)),
            }
        }
        Self { guesses }
    }

    /// Probability that the particle stays [1].
    fn stays(&self, table: &StayTable, way: usize) -> f64 {
        let guesses = self.guesses.iter().map(|(weight, draws, [most, before])| {
            let stays = match draws.get(way) {
                Some(draws) => draws.iter().map(|bin| table.at(*bin)).product(),
                None if most == before => 1.0,
                None => table.at(*most) / table.at(*before).max(f64::MIN_POSITIVE),
            };
            weight * stays
        });
        guesses.sum::<f64>().min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_hold_the_force_to_half_a_hundredth() {
        let law = LogNormal {
            mu: -0.9,
            sigma: 0.3,
        };
        let table = StayTable::of(&law);
        for share in [0.02, 0.2, 0.4, 0.7, 1.0, 3.0] {
            let exact = 1.0 - law.probability(share);
            let found = table.at(bin(share));
            // Half a bin of 0.01 times the steepest slope, 0.4/σ.
            assert!(
                (found - exact).abs() < 0.005 * 0.4 / 0.3 + 1e-9,
                "{share}: {found} {exact}"
            );
        }
        assert_eq!(table.at(bin(0.0)), 1.0);
    }

    #[test]
    fn a_shift_blurs_by_its_deviation() {
        // A narrow likelihood at the middle becomes one as wide as the shift.
        let along: Vec<f64> = (0..201)
            .map(|i| -0.5 * (f64::from(i - 100) / 5.0).powi(2))
            .collect();
        let at = |node: usize| blur(&along, node, 12.0);
        // Variances add: 5² + 12² = 13².
        let ratio = at(113) - at(100);
        assert!((ratio + 0.5).abs() < 0.02, "{ratio}");
    }
}
