//! The particle distribution (1): dirt as points on the surface, with the fate of each.

use crate::geometry::Point2;

/// Largest number of particles of a distribution; planning and prediction take about 300 bytes for
/// each.
pub const MAX_PARTICLES: usize = 5_000_000;

/// Fate of a particle: on the surface, absorbed by a tool, off the surface, or treated as a place of the surface. Only
/// the effect model changes it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Fate {
    /// The particle is on the surface.
    #[default]
    OnSurface,
    /// A tool absorbed the particle.
    Absorbed,
    /// The particle went over an edge of the surface's outline.
    OffSurface {
        /// Index of that edge, see [`crate::geometry::Polygon::edges`]; [`u16::MAX`] for a particle that fell, see
        /// [`Fate::FALLEN`].
        edge: u16,
    },
    /// The particle is a place of the surface over which a tool slid.
    Treated {
        /// Number of passes: travel of the tool over the place, over the mean length of its footprint \[1\].
        passes: f64,
    },
}

impl Fate {
    /// The particle fell off by its own weight: from a surface that faces down, or as liquid over an edge over which no dirt
    /// may be skimmed.
    pub const FALLEN: Self = Self::OffSurface { edge: u16::MAX };

    /// Whether the particle is on the surface.
    pub fn is_on_surface(self) -> bool {
        matches!(self, Self::OnSurface | Self::Treated { .. })
    }

    /// Number of passes of a tool over the particle \[1\].
    pub fn passes(self) -> f64 {
        match self {
            Self::Treated { passes } => passes,
            _ => 0.0,
        }
    }
}

/// A reason why positions do not make a [`ParticleDistribution`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ParticleError {
    /// A coordinate is NaN or infinite.
    #[error("particle {index}: position ({x}, {y}) m is not finite")]
    NotFinite {
        /// Index of the particle.
        index: usize,
        /// Its x \[m\].
        x: f64,
        /// Its y \[m\].
        y: f64,
    },
    /// More particles than [`MAX_PARTICLES`].
    #[error("{count} particles exceed the limit of {MAX_PARTICLES}")]
    TooMany {
        /// Number of particles given.
        count: usize,
    },
}

/// N points (x, y) in the surface frame \[m\] with their fates; paper (1).
///
/// No particle is created or lost: [`ParticleTally::initial`] is constant.
///
/// ```
/// use wisch::{geometry::Point2, represent::ParticleDistribution};
/// let crumbs = ParticleDistribution::new(&[Point2::new(0.1, 0.0), Point2::new(0.0, 0.1)])?;
/// assert_eq!(crumbs.tally().remaining, 2);
/// # Ok::<(), wisch::represent::ParticleError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ParticleDistribution {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) fate: Vec<Fate>,
}

/// Number of particles by their fate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ParticleTally {
    /// Number of particles in all.
    pub initial: usize,
    /// Number of particles on the surface.
    pub remaining: usize,
    /// Number of particles that a tool absorbed.
    pub absorbed: usize,
    /// Number of particles that left the surface over any edge.
    pub off_surface: usize,
}

impl ParticleDistribution {
    /// Returns particles on the surface at these points (surface frame \[m\]).
    ///
    /// # Errors
    /// A point that is not finite, or more than [`MAX_PARTICLES`] points.
    pub fn new(points: &[Point2]) -> Result<Self, ParticleError> {
        if points.len() > MAX_PARTICLES {
            return Err(ParticleError::TooMany {
                count: points.len(),
            });
        }
        if let Some((index, p)) = points
            .iter()
            .enumerate()
            .find(|(_, p)| !(p.x.is_finite() && p.y.is_finite()))
        {
            return Err(ParticleError::NotFinite {
                index,
                x: p.x,
                y: p.y,
            });
        }
        Ok(Self {
            x: points.iter().map(|p| p.x).collect(),
            y: points.iter().map(|p| p.y).collect(),
            fate: vec![Fate::OnSurface; points.len()],
        })
    }

    /// Returns particles with their fates. The position of a particle that is gone is its last
    /// place \[m\].
    ///
    /// # Errors
    /// As [`ParticleDistribution::new`].
    pub fn with_fates(particles: &[(Point2, Fate)]) -> Result<Self, ParticleError> {
        let points: Vec<Point2> = particles.iter().map(|(point, _)| *point).collect();
        Ok(Self {
            fate: particles.iter().map(|(_, fate)| *fate).collect(),
            ..Self::new(&points)?
        })
    }

    /// Sets position and fate of a particle.
    pub(crate) fn put(&mut self, index: usize, place: Point2, fate: Fate) {
        self.x[index] = place.x;
        self.y[index] = place.y;
        self.fate[index] = fate;
    }

    /// Returns the particles with these indices, in their order.
    pub(crate) fn chosen(&self, numbers: &[usize]) -> Self {
        let mut chosen = Self {
            x: Vec::new(),
            y: Vec::new(),
            fate: Vec::new(),
        };
        for &i in numbers {
            chosen.x.push(self.x[i]);
            chosen.y.push(self.y[i]);
            chosen.fate.push(self.fate[i]);
        }
        chosen
    }

    /// Number of particles of any fate.
    pub fn len(&self) -> usize {
        self.fate.len()
    }

    /// Whether the distribution has no particles.
    pub fn is_empty(&self) -> bool {
        self.fate.is_empty()
    }

    /// Position of particle `index` in the surface frame \[m\]; for a particle that is gone, its
    /// last place.
    pub fn position(&self, index: usize) -> Point2 {
        Point2::new(self.x[index], self.y[index])
    }

    /// Fate of particle `index`, in the order of creation.
    ///
    /// # Panics
    /// If `index` is not below [`Self::len`].
    pub fn fate(&self, index: usize) -> Fate {
        self.fate[index]
    }

    /// Positions \[m\] and fates of all particles, in order.
    pub fn iter(&self) -> impl Iterator<Item = (Point2, Fate)> + '_ {
        (0..self.len()).map(|i| (self.position(i), self.fate[i]))
    }

    /// Positions of the particles on the surface \[m\].
    pub fn remaining(&self) -> impl Iterator<Item = Point2> + '_ {
        self.iter()
            .filter(|(_, fate)| fate.is_on_surface())
            .map(|(position, _)| position)
    }

    /// Returns the number of particles by fate; the numbers sum to [`Self::len`].
    pub fn tally(&self) -> ParticleTally {
        let mut tally = ParticleTally {
            initial: self.len(),
            ..ParticleTally::default()
        };
        for fate in &self.fate {
            match fate {
                Fate::OnSurface | Fate::Treated { .. } => tally.remaining += 1,
                Fate::Absorbed => tally.absorbed += 1,
                Fate::OffSurface { .. } => tally.off_surface += 1,
            }
        }
        tally
    }
}
