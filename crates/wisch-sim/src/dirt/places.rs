//! Positions of the dirt of a world, drawn independently of what any robot believes.

use crate::{GrainCount, SimulationSettings, TrueDirt};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use wisch::geometry::{Bounds2, Point2, Polygon, Pose, Vector2};
use wisch::random::normal;
use wisch::represent::{
    Cluster, DirtArea, OccupiedArea, SourceError, Surface, SurfaceShape, Task, cluster_particles,
    uniform_particles,
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
pub struct WorkSurface {
    /// Believed pose of the surface.
    pub world_from_surface: Pose,
    /// Outline of the surface, in its frame \[m\].
    pub outline: Polygon,
    /// Area that objects on the surface occupy.
    pub occupied: OccupiedArea,
    /// Believed shape of the surface.
    pub shape: SurfaceShape,
}

impl WorkSurface {
    /// Returns the surface of a task with the objects on it; the believed dirt is not used.
    pub fn from_task(task: &Task) -> Self {
        Self {
            world_from_surface: task.surface.world_from_surface,
            outline: task.surface.outline.clone(),
            occupied: task.occupied_area(),
            shape: task.surface.shape.clone(),
        }
    }

    /// Returns the real surface of a world.
    pub(super) fn real(&self, settings: &SimulationSettings) -> Surface {
        let world_from_real = self.world_from_surface * settings.believed_from_real;
        let mut real = Surface::new("surface", self.outline.clone(), world_from_real);
        real.shape = settings.shape.as_ref().unwrap_or(&self.shape).clone();
        real
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
        let bounds = Bounds2::from_points(self.outline.outer().iter().copied());
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

/// Draws a number uniformly between two limits.
fn draw_between([low, high]: [f64; 2], random: &mut ChaCha8Rng) -> f64 {
    low + (high - low) * random.random::<f64>()
}

fn stream(seed: u64, number: u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ PLACE_SEED);
    random.set_stream(number);
    random
}

/// Draws the positions of the grains [m]; none for a list.
pub(super) fn draw_positions(
    dirt: &TrueDirt,
    surface: &WorkSurface,
    settings: &SimulationSettings,
    seed: u64,
) -> Result<Vec<Point2>, SourceError> {
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
    match dirt {
        TrueDirt::Listed(_) => Ok(Vec::new()),
        TrueDirt::Uniform => {
            let drawn = uniform_particles(surface.area(), count, grain_seed)?;
            Ok(drawn.remaining().collect())
        }
        TrueDirt::Clusters(given) => {
            let heaps = match given {
                Some(heaps) => heaps.clone(),
                None => random_heaps(surface, shape)?,
            };
            let drawn = cluster_particles(surface.area(), &heaps, count, grain_seed)?;
            Ok(drawn.remaining().collect())
        }
        TrueDirt::Stripe {
            center,
            direction,
            width,
        } => {
            // All three are always drawn, so that a given value does not change the drawn ones.
            let anywhere = surface.place(shape)?;
            let center = center.unwrap_or(anywhere);
            let drawn = draw_between([0.0, TAU / 2.0], shape);
            let angle = direction.unwrap_or(drawn);
            let drawn = draw_between(BAND_WIDTH, shape);
            let width = width.unwrap_or(drawn);
            let across = Vector2::new(-libm::sin(angle), libm::cos(angle));
            sample_where(surface, count, seed, |place| {
                (place - center).dot(&across).abs() <= width / 2.0
            })
        }
        TrueDirt::Edge(within) => sample_where(surface, count, seed, |place| {
            let distances = surface.outline.edges().map(|edge| edge.distance(place));
            distances.fold(f64::INFINITY, f64::min) <= *within
        }),
    }
}

fn random_heaps(
    surface: &WorkSurface,
    random: &mut ChaCha8Rng,
) -> Result<Vec<Cluster>, SourceError> {
    let [least, most] = HEAPS;
    let count = random.random_range(least..=most);
    let heap = |_| {
        Ok(Cluster {
            center: surface.place(random)?,
            sigma: draw_between(HEAP_SIGMA, random),
            weight: 1.0,
        })
    };
    (0..count).map(heap).collect()
}

/// Draws `count` points uniformly over the free surface, among those that `is_wanted` accepts (rejection sampling).
fn sample_where(
    surface: &WorkSurface,
    count: usize,
    seed: u64,
    is_wanted: impl Fn(Point2) -> bool,
) -> Result<Vec<Point2>, SourceError> {
    let random = &mut stream(seed, GRAIN_STREAM);
    let mut places = Vec::with_capacity(count);
    let budget = count * DRAWS_PER_GRAIN;
    for _ in 0..budget {
        let place = surface.place(random)?;
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
