//! Positions of the dirt of a world, drawn independently of what any robot believes.

use crate::SimulationSettings;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use wisch::geometry::{Bounds2, Mesh, Point2, Polygon, Pose, Vector2};
use wisch::random::normal;
use wisch::represent::{
    Cluster, DirtArea, OccupiedArea, SourceError, Task, cluster_particles, uniform_particles,
};

/// Separates the random numbers of positions from those of a task with the same seed.
const PLACE_SEED: u64 = 0x706c_6163_6573_0000;
/// Streams of random numbers: the number of grains, the shape of heaps and bands, the position of each grain.
const COUNT_STREAM: u64 = 1;
const SHAPE_STREAM: u64 = 2;
const GRAIN_STREAM: u64 = 3;
/// Standard deviation of the logarithm of real over believed number of grains [1].
const COUNT_SPREAD: f64 = 0.2;
/// Ranges for random heaps: their number, and their standard deviation [m].
const HEAPS: [u32; 2] = [1, 6];
const HEAP_SIGMA: [f64; 2] = [0.01, 0.10];
/// Range for the width of a random band [m].
const BAND_WIDTH: [f64; 2] = [0.02, 0.10];
/// Number of draws per grain after which the dirt counts as too much for the surface.
const DRAWS_PER_GRAIN: usize = 10_000;

/// The surface of a world and the objects on it, without any belief about the dirt.
#[derive(Debug, Clone, PartialEq)]
pub struct Site {
    /// Believed pose of the surface.
    pub world_from_surface: Pose,
    /// Outline of the surface, in its frame \[m\].
    pub outline: Polygon,
    /// Area that objects on the surface occupy.
    pub occupied: OccupiedArea,
}

impl Site {
    /// The site of a task.
    pub fn of(task: &Task) -> Self {
        let meshes: Vec<Mesh> = task.obstacles_in_surface().collect();
        Self {
            world_from_surface: task.surface.world_from_surface,
            outline: task.surface.outline.clone(),
            occupied: OccupiedArea::of(&meshes),
        }
    }

    /// Area on which dirt can lie.
    fn area(&self) -> DirtArea<'_> {
        DirtArea {
            outline: &self.outline,
            occupied: &self.occupied,
        }
    }

    /// Draws a point of the free surface, uniformly.
    fn place(&self, random: &mut ChaCha8Rng) -> Result<Point2, SourceError> {
        let bounds = Bounds2::of(self.outline.outer().iter().copied());
        let bounds = bounds.unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        let draw = |random: &mut ChaCha8Rng| {
            let share = Vector2::new(random.random(), random.random());
            bounds.min + bounds.size().component_mul(&share)
        };
        let mut draws = (0..DRAWS_PER_GRAIN).map(|_| draw(random));
        let found = draws.find(|place| self.area().contains(*place));
        found.ok_or(SourceError::NoRoom {
            draws: DRAWS_PER_GRAIN,
            placed: 0,
            count: 1,
        })
    }
}

/// Number of grains in a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GrainCount {
    /// Exactly this number.
    Exactly(usize),
    /// This number times a random log-normal factor with a spread of 20 %.
    About(usize),
}

/// Spatial distribution of dirt, in the frame of the real surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Places {
    /// At these points \[m\]; the number of grains in the settings is ignored.
    Listed(Vec<Point2>),
    /// Uniformly over the free surface.
    Uniform,
    /// In heaps; `None` draws 1 to 6 heaps, each with a standard deviation of 1 to 10 cm, anywhere on the surface.
    Clusters(Option<Vec<Cluster>>),
    /// In a band across the surface; a field that is `None` is drawn.
    Stripe {
        /// A point of the band's middle line \[m\].
        center: Option<Point2>,
        /// Direction of the band, about the surface's z from its x \[rad\].
        direction: Option<f64>,
        /// Width of the band \[m\].
        width: Option<f64>,
    },
    /// Along the outline, at most this far inside it \[m\].
    Edge(f64),
}

/// Draws a number uniformly between two limits.
fn draw_between([low, high]: [f64; 2], random: &mut ChaCha8Rng) -> f64 {
    low + (high - low) * random.random::<f64>()
}

fn stream(seed: u64, number: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ PLACE_SEED);
    random.set_stream(number);
    random
}

impl Places {
    /// Draws the positions of the grains [m]; none if there are more than the settings allow to simulate.
    pub(super) fn draw(
        &self,
        site: &Site,
        settings: &SimulationSettings,
        seed: u64,
    ) -> Result<Vec<Point2>, SourceError> {
        if settings.count_over_limit().is_some() {
            return Ok(Vec::new());
        }
        if let Self::Listed(places) = self {
            return Ok(places.clone());
        }
        let count = match settings.count {
            GrainCount::Exactly(count) => count,
            GrainCount::About(count) => {
                let factor = libm::exp(COUNT_SPREAD * normal(&mut stream(seed, COUNT_STREAM)));
                (count as f64 * factor).round().max(1.0) as usize
            }
        };
        if count == 0 {
            return Ok(Vec::new());
        }
        let shape = &mut stream(seed, SHAPE_STREAM);
        let grain_seed = seed ^ PLACE_SEED;
        match self {
            Self::Listed(_) => Ok(Vec::new()),
            Self::Uniform => {
                let drawn = uniform_particles(site.area(), count, grain_seed)?;
                Ok(drawn.remaining().collect())
            }
            Self::Clusters(given) => {
                let heaps = match given {
                    Some(heaps) => heaps.clone(),
                    None => random_heaps(site, shape)?,
                };
                let drawn = cluster_particles(site.area(), &heaps, count, grain_seed)?;
                Ok(drawn.remaining().collect())
            }
            Self::Stripe {
                center,
                direction,
                width,
            } => {
                // All three are drawn, needed or not, so that a given value does not change the drawn ones.
                let anywhere = site.place(shape)?;
                let center = center.unwrap_or(anywhere);
                let drawn = draw_between([0.0, TAU / 2.0], shape);
                let angle = direction.unwrap_or(drawn);
                let drawn = draw_between(BAND_WIDTH, shape);
                let width = width.unwrap_or(drawn);
                let across = Vector2::new(-libm::sin(angle), libm::cos(angle));
                sample_where(site, count, seed, |place| {
                    (place - center).dot(&across).abs() <= width / 2.0
                })
            }
            Self::Edge(within) => sample_where(site, count, seed, |place| {
                let distances = site.outline.edges().map(|edge| edge.distance(place));
                distances.fold(f64::INFINITY, f64::min) <= *within
            }),
        }
    }
}

fn random_heaps(site: &Site, random: &mut ChaCha8Rng) -> Result<Vec<Cluster>, SourceError> {
    let [least, most] = HEAPS;
    let count = random.random_range(least..=most);
    let heap = |_| {
        Ok(Cluster {
            center: site.place(random)?,
            sigma: draw_between(HEAP_SIGMA, random),
            weight: 1.0,
        })
    };
    (0..count).map(heap).collect()
}

/// Draws `count` points uniformly over the free surface, among those that `is_wanted` accepts (rejection sampling).
fn sample_where(
    site: &Site,
    count: usize,
    seed: u64,
    is_wanted: impl Fn(Point2) -> bool,
) -> Result<Vec<Point2>, SourceError> {
    let random = &mut stream(seed, GRAIN_STREAM);
    let mut places = Vec::with_capacity(count);
    let budget = count * DRAWS_PER_GRAIN;
    for _ in 0..budget {
        let place = site.place(random)?;
        if is_wanted(place) {
            places.push(place);
        }
        if places.len() == count {
            return Ok(places);
        }
    }
    Err(SourceError::NoRoom {
        draws: budget,
        placed: places.len(),
        count,
    })
}
