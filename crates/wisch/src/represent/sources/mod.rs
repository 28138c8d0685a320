//! Random particles: evenly spread, or in clusters.

#[cfg(test)]
mod tests;

use super::{MAX_PARTICLES, OccupiedArea, ParticleDistribution, ParticleError};
use crate::geometry::{Bounds2, Point2, Polygon, Vector2};
use crate::random::normal_pair;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Random stream of the task's seed for particles; stream 0 is the planner's.
const PARTICLE_STREAM: u64 = 1;
/// Draws per particle after which the free area counts as too small.
const DRAWS_PER_PARTICLE: usize = 1_000;
/// Largest distance of the centre of a cluster from the surface, over its standard deviation [1]: 2
/// % of its particles then lie on the surface.
const MOST_OFF: f64 = 2.0;
/// Least number of draws before sampling is abandoned.
const MIN_DRAWS: usize = 100_000;

/// A heap of particles, normally distributed about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cluster {
    /// Centre in the surface frame \[m\].
    pub center: Point2,
    /// Standard deviation along x and along y \[m\].
    pub sigma: f64,
    /// Share of the particles, relative to the other clusters' weights.
    pub weight: f64,
}

/// Area where dirt can lie: on the surface, and not under an object.
#[derive(Debug, Clone, Copy)]
pub struct DirtArea<'a> {
    /// Outline of the surface, in its frame \[m\].
    pub outline: &'a Polygon,
    /// Area that objects occupy.
    pub occupied: &'a OccupiedArea,
}

impl DirtArea<'_> {
    /// Whether a particle can lie at a point (surface frame \[m\]).
    pub fn contains(&self, point: Point2) -> bool {
        self.outline.contains(point) && !self.occupied.contains(point)
    }
}

/// A reason why a source yields no particles.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SourceError {
    /// The particle distribution rejected the points.
    #[error(transparent)]
    Particles(#[from] ParticleError),
    /// A count outside its range.
    #[error("count = {count} is outside its limits: at least 1 and at most {MAX_PARTICLES}")]
    Count {
        /// The requested count.
        count: usize,
    },
    /// A cluster that lies beside the surface.
    #[error(
        "clusters[{cluster}]: its centre is {distance:.3} m off the surface, more than {MOST_OFF} times its sigma ({sigma} m), so that hardly any of its particles would lie on the surface"
    )]
    OffSurface {
        /// Index of the cluster.
        cluster: usize,
        /// Distance of its centre from the surface \[m\].
        distance: f64,
        /// Its standard deviation \[m\].
        sigma: f64,
    },
    /// Too few draws hit the free surface.
    #[error(
        "{draws} draws put only {placed} of {count} particles on the surface: it is covered, or the clusters lie off it"
    )]
    NoRoom {
        /// Number of draws.
        draws: usize,
        /// Number of placed particles.
        placed: usize,
        /// Number of requested particles.
        count: usize,
    },
}

/// Returns the random generator of a task's particles, from the task's seed; it is the same on every platform.
pub fn particle_generator(seed: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(PARTICLE_STREAM);
    random
}

/// Draws `count` particles evenly over the area.
///
/// # Errors
/// A count of 0 or above [`MAX_PARTICLES`], or an area too small to be hit.
///
/// ```
/// use wisch::geometry::{Polygon, Vector2};
/// use wisch::represent::{DirtArea, OccupiedArea, uniform_particles};
/// let board = Polygon::rectangle(Vector2::new(0.4, 0.28));
/// let area = DirtArea { outline: &board, occupied: &OccupiedArea::default() };
/// assert_eq!(uniform_particles(area, 80, 1)?.len(), 80);
/// # Ok::<(), wisch::represent::SourceError>(())
/// ```
pub fn uniform_particles(
    area: DirtArea<'_>,
    count: usize,
    seed: u64,
) -> Result<ParticleDistribution, SourceError> {
    let bounds = Bounds2::from_points(area.outline.outer().iter().copied()).unwrap_or(Bounds2 {
        min: Point2::origin(),
        max: Point2::origin(),
    });
    let size = bounds.size();
    sample_by_rejection(area, count, seed, |random| {
        bounds.min
            + Vector2::new(
                size.x * random.random::<f64>(),
                size.y * random.random::<f64>(),
            )
    })
}

/// Draws `count` particles in heaps; particles off the area are drawn again.
///
/// # Errors
/// A count of 0 or above [`MAX_PARTICLES`], or a cluster that hardly ever hits the area.
pub fn cluster_particles(
    area: DirtArea<'_>,
    clusters: &[Cluster],
    count: usize,
    seed: u64,
) -> Result<ParticleDistribution, SourceError> {
    for (index, cluster) in clusters.iter().enumerate() {
        let edges = area.outline.edges();
        let distance = match area.outline.contains(cluster.center) {
            true => 0.0,
            false => edges.fold(f64::INFINITY, |least, edge| {
                least.min(edge.distance(cluster.center))
            }),
        };
        if distance > MOST_OFF * cluster.sigma {
            return Err(SourceError::OffSurface {
                cluster: index,
                distance,
                sigma: cluster.sigma,
            });
        }
    }
    let total: f64 = clusters.iter().map(|cluster| cluster.weight).sum();
    sample_by_rejection(area, count, seed, |random| {
        let mut share = random.random::<f64>() * total;
        let chosen = clusters.iter().find(|cluster| {
            share -= cluster.weight;
            share < 0.0
        });
        let offset = normal_pair(random);
        match chosen.or(clusters.last()) {
            Some(cluster) => cluster.center + offset * cluster.sigma,
            None => Point2::new(f64::NAN, f64::NAN),
        }
    })
}

fn sample_by_rejection(
    area: DirtArea<'_>,
    count: usize,
    seed: u64,
    mut draw: impl FnMut(&mut ChaCha8Rng) -> Point2,
) -> Result<ParticleDistribution, SourceError> {
    SourceError::check_count(count)?;
    let mut random = particle_generator(seed);
    let budget = MIN_DRAWS.max(count.saturating_mul(DRAWS_PER_PARTICLE));
    let mut points = Vec::with_capacity(count);
    let mut draws = 0;
    while points.len() < count {
        // An area that not one of a hundred thousand draws hits cannot be filled.
        if draws == budget || (draws == MIN_DRAWS && points.is_empty()) {
            let placed = points.len();
            return Err(SourceError::NoRoom {
                draws,
                placed,
                count,
            });
        }
        draws += 1;
        let point = draw(&mut random);
        if area.contains(point) {
            points.push(point);
        }
    }
    Ok(ParticleDistribution::new(&points)?)
}

impl SourceError {
    /// Checks that a number of particles is within its limits.
    ///
    /// # Errors
    /// A count of 0 or above [`MAX_PARTICLES`].
    pub fn check_count(count: usize) -> Result<(), Self> {
        if (1..=MAX_PARTICLES).contains(&count) {
            Ok(())
        } else {
            Err(Self::Count { count })
        }
    }
}
