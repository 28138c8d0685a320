//! Ground truth of the dirt: grains with a size and a threshold of their own.

mod places;

pub use places::WorkSurface;

use crate::{SimulationError, SimulationSettings, TrueDirt};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wisch::geometry::Point2;
use wisch::random::normal;
use wisch::represent::{
    DirtMobility, DirtSlide, Fate, ParticleDistribution, ParticleError, SourceError, Surface,
};

/// Separates the random numbers of grains from those of a task with the same seed.
const GRAIN_SEED: u64 = 0x6772_6169_6e73_0000;

/// Ground truth of one grain, or of one point of a treated surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Position, or the place at which it left the surface, in the frame of the real surface \[m\].
    pub position: Point2,
    /// Fate of the grain.
    pub fate: Fate,
    /// Radius \[m\].
    pub radius: f64,
    /// Normalised pressure above which the tool moves or absorbs the grain \[1\].
    pub threshold: f64,
    /// Depth that the tool rubbed off at this point \[m\].
    pub wear: f64,
}

/// Ground truth of the dirt, which only the simulated world reads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dirt {
    pub(super) grains: Vec<Grain>,
}

impl Dirt {
    /// Draws the dirt of a world: number and positions by `settings`, reproducible from `seed`.
    ///
    /// # Errors
    /// If the dirt that the settings describe does not fit on the surface.
    pub fn draw(
        surface: &WorkSurface,
        settings: &SimulationSettings,
        seed: u64,
    ) -> Result<Self, SimulationError> {
        let particles = match &settings.dirt {
            // More grains than the settings allow to simulate.
            _ if settings.count_over_limit().is_some() => ParticleDistribution::new(&[]),
            TrueDirt::Listed(particles) => Ok(particles.clone()),
            dirt => {
                let places = places::draw_positions(dirt, surface, settings, seed)?;
                ParticleDistribution::new(&places)
            }
        };
        let particles = particles.map_err(SourceError::from)?;
        let drawn = Self::scatter(&particles, settings, seed);
        Ok(match settings.mobility {
            DirtMobility::Slides(friction) => {
                let slide = DirtSlide::new(friction, surface.occupied.clone());
                drawn.settle(&surface.real(settings), &slide)
            }
            DirtMobility::Unknown | DirtMobility::Runs(_) => drawn,
        })
    }

    /// Returns dirt with a grain on each particle, whose size and threshold are drawn from
    /// `settings`.
    pub fn scatter(
        particles: &ParticleDistribution,
        settings: &SimulationSettings,
        seed: u64,
    ) -> Self {
        let grain = |(i, (position, fate)): (usize, (Point2, Fate))| {
            // Each grain has its own random stream, so that its properties do not depend on the
            // other grains.
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

    /// Returns the dirt after the grains that are too steep to rest have slid.
    fn settle(mut self, real: &Surface, slide: &DirtSlide) -> Self {
        for grain in &mut self.grains {
            if grain.fate == Fate::OnSurface
                && let Some(end) = slide.find_end(real, grain.position)
            {
                (grain.position, grain.fate) = (end.place, end.fate);
            }
        }
        self
    }

    /// Returns dirt of the given grains.
    pub const fn from_grains(grains: Vec<Grain>) -> Self {
        Self { grains }
    }

    /// The grains, each with its position and fate.
    pub fn grains(&self) -> &[Grain] {
        &self.grains
    }

    /// Mean depth that was rubbed off over the points of a polished surface \[m\].
    pub fn mean_wear(&self) -> f64 {
        let wear: f64 = self.grains.iter().map(|grain| grain.wear).sum();
        wear / self.grains.len().max(1) as f64
    }

    /// Returns the grains as particles in the frame of the real surface.
    ///
    /// # Errors
    /// If a grain's position is not finite, which would be a fault of the simulation.
    pub fn particles(&self) -> Result<ParticleDistribution, ParticleError> {
        let grains = self.grains.iter().map(|grain| (grain.position, grain.fate));
        ParticleDistribution::with_fates(&grains.collect::<Vec<_>>())
    }
}
