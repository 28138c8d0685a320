//! Where the dirt is believed to lie: many replays of the same log, each with chances of its own.

use super::{DensityMap, Estimate, InterpretError};
use crate::geometry::Point2;
use crate::represent::{
    Fate, GoalState, ParticleDistribution, ParticleError, Performance, Surface,
};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

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

    /// Several replays of the same particles.
    ///
    /// # Errors
    /// No replay at all, or one with another number of particles than the first.
    pub fn of(replays: Vec<ParticleDistribution>) -> Result<Self, InterpretError> {
        let first = replays.first().ok_or(InterpretError::NoReplays)?;
        let expected = first.len();
        match replays.iter().position(|one| one.len() != expected) {
            Some(replay) => Err(InterpretError::UnequalReplays {
                replay,
                count: replays[replay].len(),
                expected,
            }),
            None => Ok(Self { replays }),
        }
    }

    /// Replays that are known to hold the same particles, at least one.
    pub(super) fn ensemble(replays: Vec<ParticleDistribution>) -> Self {
        Self { replays }
    }

    /// The replays, at least one, all of the same length.
    pub fn replays(&self) -> &[ParticleDistribution] {
        &self.replays
    }

    /// Mean performance with its 90 % interval.
    pub fn performance(&self, goal: &GoalState, surface: &Surface) -> Estimate {
        let counts = |particles| Performance::of(particles, goal, surface);
        let mut counts: Vec<Performance> = self.replays.iter().map(counts).collect();
        counts.sort_by_key(|one| one.achieved);
        let last = (counts.len() - 1) as f64;
        let at = |quantile: f64| counts[(last * quantile).round() as usize].ratio();
        // Counted rather than averaged: equal shares have that share as their mean, to the last bit.
        let all = Performance {
            initial: counts.iter().map(|one| one.initial).sum(),
            achieved: counts.iter().map(|one| one.achieved).sum(),
            lost: counts.iter().map(|one| one.lost).sum(),
        };
        Estimate {
            mean: all.ratio(),
            low: at(0.05),
            high: at(0.95),
        }
    }

    /// One distribution out of the belief: each particle as in a replay drawn by itself.
    ///
    /// Where the replays disagree about a place, the sample holds the mean share of the particles there.
    ///
    /// # Errors
    /// A replay holds a position that is not finite.
    pub fn sample(&self, seed: u64) -> Result<ParticleDistribution, ParticleError> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let particles: Vec<(Point2, Fate)> = (0..self.replays[0].len())
            .map(|i| {
                let replay = &self.replays[random.random_range(0..self.replays.len())];
                (replay.position(i), replay.fate(i))
            })
            .collect();
        ParticleDistribution::with_fates(&particles)
    }

    /// How many particles remain where, over square cells of side `cell_size` [m].
    ///
    /// # Errors
    /// Cells so small that there are too many, or a side that is not above 0.
    pub fn density(&self, surface: &Surface, cell_size: f64) -> Result<DensityMap, InterpretError> {
        DensityMap::of(self, surface, cell_size)
    }
}
