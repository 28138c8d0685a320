//! Real dirt: grains with a size and a will of their own.

mod places;

pub use places::{GrainCount, Places, Site};

use crate::{SimulationError, SimulationSettings};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wisch::geometry::Point2;
use wisch::random::normal;
use wisch::represent::{Fate, ParticleDistribution, ParticleError, SourceError};

/// Tells the random numbers of grains apart from those of a task with the same seed.
const GRAIN_SEED: u64 = 0x6772_6169_6e73_0000;

/// One grain as it really is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Where it is, or went, in the frame of the real surface [m].
    pub position: Point2,
    /// What became of it.
    pub fate: Fate,
    /// Half its diameter [m].
    pub radius: f64,
    /// Pressure under the tool over the nominal one from which on the tool takes it along [1].
    pub threshold: f64,
    /// Depth that was rubbed off at this place [m].
    pub wear: f64,
}

/// The truth about the dirt, which only the simulated world knows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dirt {
    pub(super) grains: Vec<Grain>,
}

impl Dirt {
    /// The dirt of a world: where the settings say, of as many grains, with random numbers of its own.
    ///
    /// # Errors
    /// Where the settings put it there is no room on the surface.
    pub fn draw(
        site: &Site,
        settings: &SimulationSettings,
        seed: u64,
    ) -> Result<Self, SimulationError> {
        let places = settings.dirt.draw(site, settings, seed)?;
        let particles = ParticleDistribution::new(&places).map_err(SourceError::from)?;
        Ok(Self::scatter(&particles, settings, seed))
    }

    /// Grains where the particles lie, with sizes and thresholds drawn from settings.
    pub fn scatter(
        particles: &ParticleDistribution,
        settings: &SimulationSettings,
        seed: u64,
    ) -> Self {
        let grain = |(i, (position, fate)): (usize, (Point2, Fate))| {
            // Each grain has a stream of its own, so that its nature does not depend on the others.
            let mut random = ChaCha8Rng::seed_from_u64(seed ^ GRAIN_SEED);
            random.set_stream(i as u64);
            let size = settings.grain_size;
            let diameter = size.min_m + (size.max_m - size.min_m) * random.random::<f64>();
            Grain {
                position,
                fate,
                radius: diameter / 2.0,
                threshold: libm::exp(
                    settings.likelihood.mu + settings.likelihood.sigma * normal(&mut random),
                ),
                wear: 0.0,
            }
        };
        Self {
            grains: particles.iter().enumerate().map(grain).collect(),
        }
    }

    /// Dirt of these grains.
    pub const fn of(grains: Vec<Grain>) -> Self {
        Self { grains }
    }

    /// The grains.
    pub fn grains(&self) -> &[Grain] {
        &self.grains
    }

    /// Mean depth that was rubbed off at the places of a surface that is polished [m].
    pub fn mean_wear(&self) -> f64 {
        let wear: f64 = self.grains.iter().map(|grain| grain.wear).sum();
        wear / self.grains.len().max(1) as f64
    }

    /// Where they lie, as particles in the frame of the real surface.
    ///
    /// # Errors
    /// If a grain went where no number leads, which would be a fault of the simulation.
    pub fn particles(&self) -> Result<ParticleDistribution, ParticleError> {
        let grains = self.grains.iter().map(|grain| (grain.position, grain.fate));
        ParticleDistribution::with_fates(&grains.collect::<Vec<_>>())
    }
}
