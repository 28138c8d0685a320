//! Where the dirt is believed to lie: many replays of the same log, each with random numbers of its own.

use super::density::DensityMap;
use crate::geometry::Point2;
use crate::interpret::error::InterpretError;
use crate::represent::{
    Fate, GoalState, ParticleDistribution, ParticleError, Performance, Surface,
};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Seeds of several draws differ from here on [bits], far from those of other rounds.
const DRAW_SHIFT: u32 = 32;

/// A share with a 90 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Mean over the replays.
    pub mean: f64,
    /// 5th percentile, less what the model leaves out.
    pub low: f64,
    /// 95th percentile, and what the model leaves out.
    pub high: f64,
}

impl Estimate {
    /// With an interval longer by a margin at either end, within 0 to 1.
    pub(in crate::interpret) fn widened(self, margin: f64) -> Self {
        Self {
            mean: self.mean,
            low: (self.low - margin).clamp(0.0, 1.0),
            high: (self.high + margin).clamp(0.0, 1.0),
        }
    }
}

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

    /// Several draws of [`Belief::sample`] one on top of the other: all that the dirt may be like, for plans that are to
    /// be good on average. A single draw has dirt where there is none and none where there is some.
    ///
    /// It holds `count` times the particles, those of a draw together; the draws have seeds of their own, derived
    /// from `seed`.
    ///
    /// # Errors
    /// As [`Belief::sample`], and more than [`MAX_PARTICLES`](crate::represent::MAX_PARTICLES) in all.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let [here, there] = [0.0, 0.1].map(|x| ParticleDistribution::new(&[Point2::new(x, 0.0)]).unwrap());
    /// let belief = Belief::of(vec![here, there])?;
    /// let draws = belief.draws(1000, 7)?;
    /// let share_here = draws.remaining().filter(|place| place.x < 0.05).count() as f64 / 1000.0;
    /// assert!((share_here - 0.5).abs() < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn draws(&self, count: u64, seed: u64) -> Result<ParticleDistribution, ParticleError> {
        let mut particles = Vec::new();
        for draw in 0..count {
            let draw = self.sample(seed.wrapping_add(draw << DRAW_SHIFT))?;
            particles.extend(draw.iter());
        }
        ParticleDistribution::with_fates(&particles)
    }

    /// How many particles remain where, over square cells of side `cell_size` [m].
    ///
    /// # Errors
    /// Cells so small that there are too many, or a side that is not above 0.
    pub fn density(&self, surface: &Surface, cell_size: f64) -> Result<DensityMap, InterpretError> {
        DensityMap::of(&self.replays, surface, cell_size)
    }
}
