//! The particle distribution (1): dirt as points on the surface, and what became of each.

use crate::geometry::Point2;

/// Most particles a distribution may hold: planning and predicting takes some 300 bytes for each.
pub const MAX_PARTICLES: usize = 5_000_000;

/// Where a particle is: on the surface, in a tool, or over an edge; or how much a place of the surface was treated. Only the
/// effect model changes it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Fate {
    /// It still lies on the surface.
    #[default]
    OnSurface,
    /// A tool took it up.
    Absorbed,
    /// It was pushed over an edge of the surface's outline.
    OffSurface {
        /// Index of that edge, see [`crate::geometry::Polygon::edges`].
        edge: u16,
    },
    /// It is a place of the surface, over which a tool slid.
    Treated {
        /// How often: the way that the tool slid over the place, over the mean length of its footprint along itself [1].
        passes: f64,
    },
}

impl Fate {
    /// Whether the particle is there still.
    pub fn is_on_surface(self) -> bool {
        matches!(self, Self::OnSurface | Self::Treated { .. })
    }

    /// How often a tool slid over it [1].
    pub fn passes(self) -> f64 {
        match self {
            Self::Treated { passes } => passes,
            _ => 0.0,
        }
    }
}

/// Why positions do not make a [`ParticleDistribution`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ParticleError {
    /// A coordinate is NaN or infinite.
    #[error("particle {index}: position ({x}, {y}) m is not finite")]
    NotFinite {
        /// Index of the particle.
        index: usize,
        /// Its x [m].
        x: f64,
        /// Its y [m].
        y: f64,
    },
    /// More particles than [`MAX_PARTICLES`].
    #[error("{count} particles exceed the limit of {MAX_PARTICLES}")]
    TooMany {
        /// How many were given.
        count: usize,
    },
}

/// N points (x, y) in the surface frame [m] and their fates; paper (1).
///
/// The three fates always add up to the initial number: [`ParticleTally::initial`] is constant.
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

/// How many particles met which fate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ParticleTally {
    /// Particles there were at the beginning.
    pub initial: usize,
    /// Particles that still lie on the surface.
    pub remaining: usize,
    /// Particles that a tool took up.
    pub absorbed: usize,
    /// Particles that left the surface over any edge.
    pub off_surface: usize,
}

impl ParticleDistribution {
    /// Particles lying on the surface at the given points [m].
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

    /// Particles with what became of them; for one that is gone, the position is where it went [m].
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

    /// Puts a particle to another place, with another fate.
    pub(crate) fn put(&mut self, index: usize, place: Point2, fate: Fate) {
        self.x[index] = place.x;
        self.y[index] = place.y;
        self.fate[index] = fate;
    }

    /// Those with these numbers, in this order.
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

    /// Number of particles, whatever their fate.
    pub fn len(&self) -> usize {
        self.fate.len()
    }

    /// Whether there are no particles at all.
    pub fn is_empty(&self) -> bool {
        self.fate.is_empty()
    }

    /// Position of particle `index` in the surface frame [m]; for one that is gone, where it went.
    pub fn position(&self, index: usize) -> Point2 {
        Point2::new(self.x[index], self.y[index])
    }

    /// Fate of particle `index`, counted as they were given.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn fate(&self, index: usize) -> Fate {
        self.fate[index]
    }

    /// All particles in order: position [m] and fate.
    pub fn iter(&self) -> impl Iterator<Item = (Point2, Fate)> + '_ {
        (0..self.len()).map(|i| (self.position(i), self.fate[i]))
    }

    /// Positions of the particles that still lie on the surface [m].
    pub fn remaining(&self) -> impl Iterator<Item = Point2> + '_ {
        self.iter()
            .filter(|(_, fate)| fate.is_on_surface())
            .map(|(position, _)| position)
    }

    /// Number of particles by fate; they add up to [`Self::len`].
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
