//! Where the dirt is believed to lie: many replays of the same log, each with chances of its own.

use super::Estimate;
use crate::represent::{GoalState, ParticleDistribution, Performance, Surface};

/// An ensemble of particle distributions over the same particles.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    replays: Vec<ParticleDistribution>,
}

impl Belief {
    /// Certainty: the dirt lies like this.
    pub fn certain(particles: ParticleDistribution) -> Self {
        Self {
            replays: vec![particles],
        }
    }

    /// The replays, at least one, all of the same length.
    pub fn replays(&self) -> &[ParticleDistribution] {
        &self.replays
    }

    /// Mean performance with its 90 % interval.
    pub fn performance(&self, goal: &GoalState, surface: &Surface) -> Estimate {
        let share = |particles| Performance::of(particles, goal, surface).ratio();
        let mut shares: Vec<f64> = self.replays.iter().map(share).collect();
        shares.sort_by(f64::total_cmp);
        let at = |quantile: f64| shares[((shares.len() - 1) as f64 * quantile).round() as usize];
        Estimate {
            mean: shares.iter().sum::<f64>() / shares.len() as f64,
            low: at(0.05),
            high: at(0.95),
        }
    }
}
