//! Belief about the dirt before the first log.

use super::ensemble::Belief;
use crate::geometry::{Bounds2, Point2, Vector2};
use crate::random::{normal, normal_pair};
use crate::represent::{
    Cluster, DirtArea, OccupiedArea, ParticleDistribution, Sight, Surface, Task,
};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;

/// Standard deviation of the logarithm of the number of particles \[1\].
pub const COUNT_SPREAD: f64 = 0.3;
/// Probability that dirt of unknown place lies in heaps [1].
const CLUMPED: f64 = 0.5;
/// Largest number of heaps of dirt.
const MOST_HEAPS: u32 = 6;
/// Least and largest standard deviation of a heap [m].
const HEAP_SPREAD: [f64; 2] = [0.01, 0.1];
/// Number of draws after which no free place counts as found.
const DRAWS: usize = 10_000;
/// Random streams of the members.
const STREAM: u64 = 0x7072_696f_0000_0000;

/// Knowledge about the places of the dirt.
#[derive(Debug, Clone, PartialEq)]
pub enum DirtPrior {
    /// Every particle of the task lies where the task says.
    Known,
    /// The number of particles is known roughly, and their places are unknown: they lie evenly or
    /// in heaps.
    Anywhere {
        /// Expected number of particles.
        count: usize,
    },
    /// The number of particles is known roughly, and they lie in known heaps.
    Heaps {
        /// Expected number of particles in all heaps.
        count: usize,
        /// The heaps.
        heaps: Vec<Cluster>,
    },
    /// A camera detected the dirt: the particles of the task are detections.
    Seen(Sight),
}

impl DirtPrior {
    /// Returns a belief of `members` members about a task's dirt; the random numbers follow from the task's seed.
    ///
    /// Known dirt gives a single member, which the first log replaces by an ensemble.
    pub fn belief(&self, task: &Task, members: usize) -> Belief {
        if *self == Self::Known || members == 0 {
            return Belief::from_particles(task.particles.clone());
        }
        let occupied = task.occupied_area();
        let area = Area::new(&task.surface, &occupied);
        let slide = task.dirt_slide();
        let one = |member: usize| {
            let mut random = ChaCha8Rng::seed_from_u64(task.seed);
            random.set_stream(STREAM ^ member as u64);
            let points = self.points(task, &area, &mut random);
            // All points lie on the surface, so they are finite.
            let drawn = ParticleDistribution::new(&points).unwrap_or_default();
            match &slide {
                Some(slide) => slide.settle(&drawn, &task.surface),
                None => drawn,
            }
        };
        let belief = Belief::ensemble((0..members).into_par_iter().map(one).collect());
        belief.with_seen(matches!(self, Self::Seen(_)) && !task.particles.is_empty())
    }

    fn points(&self, task: &Task, area: &Area<'_>, random: &mut ChaCha8Rng) -> Vec<Point2> {
        match self {
            Self::Known => task.particles.remaining().collect(),
            Self::Anywhere { count } => {
                let count = draw_count(*count, random);
                if random.random::<f64>() < CLUMPED {
                    area.in_heaps(count, random)
                } else {
                    (0..count).filter_map(|_| area.anywhere(random)).collect()
                }
            }
            Self::Heaps { count, heaps } => {
                let count = draw_count(*count, random);
                let total: f64 = heaps.iter().map(|heap| heap.weight).sum();
                let mut place = || {
                    let mut share = random.random::<f64>() * total;
                    let heap = heaps.iter().find(|heap| {
                        share -= heap.weight;
                        share < 0.0
                    });
                    let heap = heap.or(heaps.last())?;
                    area.near(heap.center, heap.sigma, random)
                };
                (0..count).filter_map(|_| place()).collect()
            }
            Self::Seen(Sight { sensor, detection }) => {
                let alarms = sensor.false_alarms_per_m2 * task.surface.outline.area();
                let seen = task.particles.tally().remaining as f64;
                let real = (1.0 - alarms / seen.max(1.0)).clamp(0.0, 1.0);
                let mut points = Vec::new();
                for place in task.particles.remaining() {
                    if random.random::<f64>() < real {
                        points.extend(area.near(place, sensor.position_error_m, random));
                    }
                }
                // Expected number of missed grains, from the detection rate.
                let missed = (1.0 - detection) / detection.max(0.05) * points.len() as f64;
                for _ in 0..poisson(missed, random) {
                    points.extend(area.anywhere(random));
                }
                points
            }
        }
    }
}

/// Draws a log-normal number of particles around `count`, at least 1.
fn draw_count(count: usize, random: &mut ChaCha8Rng) -> usize {
    let factor = libm::exp(COUNT_SPREAD * normal(random));
    ((count as f64 * factor).round() as usize).max(1)
}

/// Draws from a Poisson distribution: by multiplying uniform numbers for a small mean, by a normal approximation for a
/// large one.
pub(super) fn poisson(mean: f64, random: &mut ChaCha8Rng) -> usize {
    if mean > 100.0 {
        return (mean + mean.sqrt() * normal(random)).round().max(0.0) as usize;
    }
    let limit = libm::exp(-mean);
    let (mut count, mut product) = (0, random.random::<f64>());
    while product > limit {
        count += 1;
        product *= random.random::<f64>();
    }
    count
}

/// Area of a surface in which dirt can lie.
pub(super) struct Area<'a> {
    area: DirtArea<'a>,
    bounds: Bounds2,
}

impl<'a> Area<'a> {
    pub(super) fn new(surface: &'a Surface, occupied: &'a OccupiedArea) -> Self {
        let outline = &surface.outline;
        let bounds = Bounds2::from_points(outline.outer().iter().copied()).unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        Self {
            area: DirtArea { outline, occupied },
            bounds,
        }
    }

    /// Draws a uniform place; `None` if no free place was found.
    pub(super) fn anywhere(&self, random: &mut ChaCha8Rng) -> Option<Point2> {
        let size = self.bounds.size();
        let mut draw = || {
            let [x, y] = [random.random::<f64>(), random.random::<f64>()];
            self.bounds.min + Vector2::new(size.x * x, size.y * y)
        };
        (0..DRAWS)
            .map(|_| draw())
            .find(|place| self.area.contains(*place))
    }

    /// Draws a place from a normal distribution about `center`; `None` if no free place was found.
    fn near(&self, center: Point2, deviation: f64, random: &mut ChaCha8Rng) -> Option<Point2> {
        let mut draw = || center + normal_pair(random) * deviation;
        (0..DRAWS)
            .map(|_| draw())
            .find(|place| self.area.contains(*place))
    }

    /// Draws places in heaps about uniform centres (Thomas 1949).
    fn in_heaps(&self, count: usize, random: &mut ChaCha8Rng) -> Vec<Point2> {
        let heaps: Vec<(Point2, f64)> = (0..random.random_range(1..=MOST_HEAPS))
            .filter_map(|_| {
                let center = self.anywhere(random)?;
                let [least, most] = HEAP_SPREAD;
                let spread = least * libm::pow(most / least, random.random::<f64>());
                Some((center, spread))
            })
            .collect();
        if heaps.is_empty() {
            return Vec::new();
        }
        let mut place = || {
            let (center, spread) = heaps[random.random_range(0..heaps.len())];
            self.near(center, spread, random)
        };
        (0..count).filter_map(|_| place()).collect()
    }
}
