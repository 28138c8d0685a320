//! Detection of contacts on parallel planes at different heights, such as those of two boards side by side.
//!
//! For a slope of the planes, each plane is a cluster of the heights less that slope. Slopes are drawn through three contacts
//! (RANSAC; Fischler and Bolles, 1981), and the slope with the most contacts in few clusters counts. A smooth surface gives
//! no clusters: its contacts lie between them, too, or a quadric explains them as well. Through three strokes there is always a
//! quadric; the force across the strokes then shows whether the surface is inclined there.

use super::curvature::{PressedPlace, Quadric, pressed_places};
use super::downsampling::MeasuredPiece;
use super::plane::slope_within;
use super::weighted::median;
use crate::geometry::{Point2, Point3, Vector2, Vector3};
use crate::interpret::config::InterpretConfig;
use crate::represent::Surface;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Largest number of planes that are searched.
pub(in crate::interpret) const MOST_LEVELS: usize = 3;
/// Half the range of the heights on one plane [m], or in standard deviations of the noise [1].
const HALF_RANGE: [f64; 2] = [6e-4, 3.0];
/// Least step between two planes [m], and over half the range of the heights on one of them [1].
const LEAST_STEP: [f64; 2] = [1.6e-3, 2.5];
/// Least share of the contacts on each plane, on all of them together, and on two of them without search for a third [1].
const LEAST_ON_ONE: f64 = 0.1;
const LEAST_ON_ALL: f64 = 0.75;
const LEAST_ON_TWO: f64 = 0.88;
/// Least number of contacts on a plane.
const FEWEST: usize = 10;
/// Largest number of contacts just beside a plane, within an equal range of heights, over the
/// number on the plane [1]: a ramp has equal numbers.
const MOST_BESIDE: f64 = 0.25;
/// Largest cost of the planes over that of a quadric [1].
const LEAST_BETTER: f64 = 0.6;
/// Least slope of a quadric across the motion at which its force shows [1], least share of such contacts [1], and the largest force
/// across the motion over that of the slope at which the surface is level there [1].
const SHOWN_SLOPE: f64 = 0.06;
const LEAST_SLOPING: f64 = 0.1;
const MOST_INCLINED: f64 = 0.4;
/// Least step of the measured heights over that of the heights at nominal force [1]: a change of
/// force with a wrong stiffness makes no step of the measured heights.
const LEAST_MEASURED: f64 = 0.5;
/// Least extent of a slide on a plane [m]; for the only slide on it, its least share of the contacts [1], and its length from
/// which no hand keeps the tool at one height [m].
const LEAST_SLIDE: f64 = 0.02;
const LEAST_ONLY: f64 = 0.2;
const LEAST_LONG: f64 = 0.3;
/// Contacts farther apart belong to different slides [m].
const APART: f64 = 0.04;
/// Number of slopes that are drawn, and largest number of contacts on which a slope is scored.
const DRAWS: usize = 200;
const MOST_SCORED: usize = 500;
/// Least number of contacts on a plane over that on the plane with the most, at which the nearer one counts [1].
const ABOUT_AS_MANY: f64 = 0.8;
/// Least deviation of the contacts along a direction at which they determine the slope there [m].
const LEAST_SPREAD: f64 = 0.01;
const REFINEMENTS: usize = 3;

/// Contacts on a plane at one of several heights.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactLevel {
    /// Height of the plane over the middle of the believed surface \[m\].
    pub height: f64,
    /// Number of contacts on the plane.
    pub contacts: usize,
}

/// Parallel planes with the contacts on them.
struct Levels {
    slope: Vector2,
    /// Heights of the planes over the origin, the one with the most contacts first [m].
    heights: Vec<f64>,
    /// Number of contacts on all planes.
    count: usize,
}

/// Planes at different heights on which nearly all contacts lie.
#[derive(Debug, Clone, Copy)]
pub(in crate::interpret) struct ContactLevels {
    /// The planes, the lowest first; unused entries are without contacts.
    pub(in crate::interpret) levels: [ContactLevel; MOST_LEVELS],
    /// Number of contacts.
    pub(in crate::interpret) contacts: usize,
    /// Height over the origin [m] and slope [1] of the plane with the most contacts; of planes with about as many, of the
    /// nearest to the believed surface.
    pub(super) main: (f64, Vector2),
}

impl ContactLevels {
    /// Finds the planes on which the contacts of the pieces lie; `None` if they lie on one surface, or if the believed surface
    /// is no plane. `middle` is that of the believed surface [m].
    pub(in crate::interpret) fn of(
        pieces: &[MeasuredPiece],
        surface: &Surface,
        middle: Point2,
        config: &InterpretConfig,
    ) -> Option<Self> {
        if !surface.shape.is_plane() || config.gap_m > 0.0 {
            return None;
        }
        let contacts = pressed_places(pieces, surface, config, |_| Vector3::z());
        let all = contacts.len() as f64;
        let search = LevelSearch::of(&contacts);
        let found = (2..=MOST_LEVELS).find_map(|most| {
            let levels = search.refine(search.search(most, config)?, most)?;
            let least = if most == 2 {
                LEAST_ON_TWO
            } else {
                LEAST_ON_ALL
            };
            (levels.count as f64 >= least * all).then_some(levels)
        })?;
        let quadric = Quadric::fit(&contacts)?;
        let by_quadric = search.cost(|one| one.height - quadric.height_at(one.place));
        let by_levels = search.cost(|one| search.off(&found, one));
        let plane = Quadric::fit_plane(&contacts)?;
        let by_plane = search.cost(|one| one.height - plane.height_at(one.place));
        // Two heights always lie on an inclined plane, three hardly ever unless they are one plane.
        let is_plane = found.heights.len() > 2 && by_levels > LEAST_BETTER * by_plane;
        let is_better =
            by_levels <= LEAST_BETTER * by_quadric || !is_plane && search.is_level(&quadric);
        if !is_better || !search.is_apart(&found) {
            return None;
        }
        let rise = found.slope.dot(&middle.coords);
        let mut levels = [ContactLevel::default(); MOST_LEVELS];
        for (level, (at, height)) in levels.iter_mut().zip(found.heights.iter().enumerate()) {
            level.height = height + rise;
            level.contacts = search.on(&found, at).count();
        }
        levels[..found.heights.len()].sort_by(|a, b| a.height.total_cmp(&b.height));
        let most = levels.iter().map(|level| level.contacts).max()? as f64;
        let main = (levels.iter())
            .filter(|level| level.contacts as f64 >= ABOUT_AS_MANY * most)
            .min_by(|a, b| a.height.abs().total_cmp(&b.height.abs()))?;
        Some(Self {
            levels,
            contacts: contacts.len(),
            main: (main.height - rise, found.slope),
        })
    }
}

/// Search for parallel planes through contacts.
struct LevelSearch<'a> {
    contacts: &'a [PressedPlace],
    /// Half the range of the heights on one plane [m].
    half: f64,
    /// Least step between two planes [m].
    step: f64,
}

impl<'a> LevelSearch<'a> {
    fn of(contacts: &'a [PressedPlace]) -> Self {
        // The second difference of normal values has √6 times their standard deviation, and its median size is 0.674 times
        // its own.
        let bends = contacts.windows(3).map(|three| {
            let bend = three[2].height - 2.0 * three[1].height + three[0].height;
            (bend.abs(), 1.0)
        });
        let noise = median(bends.collect()) / (0.674 * 6.0_f64.sqrt());
        let half = HALF_RANGE[0].max(HALF_RANGE[1] * noise);
        Self {
            contacts,
            half,
            step: LEAST_STEP[0].max(LEAST_STEP[1] * half),
        }
    }

    /// Returns the slope at which most contacts lie on at most `most` planes. Of slopes with about as many, the least counts: few
    /// strokes lie on steep planes, too.
    fn search(&self, most: usize, config: &InterpretConfig) -> Option<Levels> {
        let stride = self.contacts.len().div_ceil(MOST_SCORED).max(1);
        let scored: Vec<&PressedPlace> = self.contacts.iter().step_by(stride).collect();
        if scored.len() < FEWEST {
            return None;
        }
        let steepest = libm::tan(config.plane.cone);
        let mut best = self.cluster(&scored, Vector2::zeros(), most);
        let mut random = ChaCha8Rng::seed_from_u64(config.seed);
        let worth = |levels: &Levels| levels.count as f64 * (1.0 - levels.slope.norm());
        for _ in 0..DRAWS {
            let [a, b, c]: [&PressedPlace; 3] =
                std::array::from_fn(|_| scored[random.random_range(0..scored.len())]);
            let (ab, ac) = (b.place - a.place, c.place - a.place);
            let (rise, climb) = (b.height - a.height, c.height - a.height);
            let area = ab.perp(&ac);
            let slope = Vector2::new(rise * ac.y - climb * ab.y, climb * ab.x - rise * ac.x) / area;
            // Collinear contacts give a slope that is NaN or too steep.
            if slope.norm() <= steepest {
                let next = self.cluster(&scored, slope, most);
                if worth(&next) > worth(&best) {
                    best = next;
                }
            }
        }
        Some(best)
    }

    /// Returns the planes of a slope with the most contacts, one after another.
    fn cluster(&self, contacts: &[&PressedPlace], slope: Vector2, most: usize) -> Levels {
        let mut heights: Vec<f64> = (contacts.iter())
            .map(|one| one.height - slope.dot(&one.place.coords))
            .collect();
        heights.sort_unstable_by(f64::total_cmp);
        let least = (LEAST_ON_ONE * heights.len() as f64).ceil() as usize;
        let mut levels = Levels {
            slope,
            heights: Vec::new(),
            count: 0,
        };
        while levels.heights.len() < most {
            let (mut densest, mut end) = (0..0, 0);
            for first in 0..heights.len() {
                while end < heights.len() && heights[end] - heights[first] <= 2.0 * self.half {
                    end += 1;
                }
                let middle = heights[usize::midpoint(first, end - 1)];
                let is_apart = |other: &f64| (middle - other).abs() >= self.step;
                if end - first > densest.len() && levels.heights.iter().all(is_apart) {
                    densest = first..end;
                }
            }
            if densest.len() < least.max(1) {
                break;
            }
            levels.count += densest.len();
            levels
                .heights
                .push(heights[usize::midpoint(densest.start, densest.end - 1)]);
            heights.drain(densest);
        }
        levels
    }

    /// Repeats least squares with a common slope of all planes. `None` if fewer than two remain.
    fn refine(&self, mut levels: Levels, most: usize) -> Option<Levels> {
        let all: Vec<&PressedPlace> = self.contacts.iter().collect();
        levels = self.cluster(&all, levels.slope, most);
        for _ in 0..REFINEMENTS {
            let mut about = Vec::new();
            for at in 0..levels.heights.len() {
                let on: Vec<&PressedPlace> = self.on(&levels, at).collect();
                let sum: Vector3 = on.iter().map(|one| point(one).coords).sum();
                let mean = sum / on.len().max(1) as f64;
                about.extend(on.iter().map(|one| point(one) - mean));
            }
            levels = self.cluster(&all, slope_within(&about, LEAST_SPREAD), most);
        }
        (levels.heights.len() >= 2).then_some(levels)
    }

    /// Distance of a contact from the nearest plane [m].
    fn off(&self, levels: &Levels, one: &PressedPlace) -> f64 {
        let height = one.height - levels.slope.dot(&one.place.coords);
        let off = levels.heights.iter().map(|level| (height - level).abs());
        off.fold(f64::INFINITY, f64::min)
    }

    /// Contacts on one of the planes.
    fn on<'b>(&'b self, levels: &'b Levels, at: usize) -> impl Iterator<Item = &'b PressedPlace> {
        let height = levels.heights[at];
        let over =
            move |one: &PressedPlace| one.height - levels.slope.dot(&one.place.coords) - height;
        let is_on = move |one: &&PressedPlace| over(one).abs() <= self.half;
        self.contacts.iter().filter(is_on)
    }

    /// Mean of the squared distances over half the range, each limited to 1 (MSAC; Torr and Zisserman, 2000).
    fn cost(&self, off: impl Fn(&PressedPlace) -> f64) -> f64 {
        let costs = self
            .contacts
            .iter()
            .map(|one| (off(one) / self.half).powi(2).min(1.0));
        costs.sum::<f64>() / self.contacts.len() as f64
    }

    /// Whether the forces contradict the slopes of a quadric: friction acts along the motion, so a force across it is that of an
    /// inclined surface.
    fn is_level(&self, quadric: &Quadric) -> bool {
        let pairs = self.contacts.windows(2);
        let sloping = pairs.filter_map(|pair| {
            let [one, next] = pair else { return None };
            let way = next.place - one.place;
            if !is_next(one, next) {
                return None;
            }
            let across = Vector2::new(-way.y, way.x).normalize();
            let normal = quadric.normal(one.place);
            let slope = normal.xy().dot(&across) / normal.z;
            let force = one.force.xy().dot(&across) / one.force.z;
            (slope.abs() >= SHOWN_SLOPE).then(|| (force / slope, 1.0))
        });
        let sloping: Vec<(f64, f64)> = sloping.collect();
        sloping.len() as f64 >= LEAST_SLOPING * self.contacts.len() as f64
            && median(sloping) <= MOST_INCLINED
    }

    /// Whether each plane holds contacts of its own: hardly any lie just beside it, its measured heights differ, and the tool
    /// slides on it more often than a hand lifts it.
    fn is_apart(&self, levels: &Levels) -> bool {
        let measured = |at: usize| {
            let heights = self.on(levels, at).map(|one| {
                let height = one.measured - levels.slope.dot(&one.place.coords);
                (height, 1.0)
            });
            median(heights.collect())
        };
        let first = (levels.heights[0], measured(0));
        (0..levels.heights.len()).all(|at| {
            let count = self.on(levels, at).count();
            let height = levels.heights[at];
            let beside = self.contacts.iter().filter(|one| {
                let off = (one.height - levels.slope.dot(&one.place.coords) - height).abs();
                off > self.half && off <= 2.0 * self.half
            });
            let is_clear = beside.count() as f64 <= MOST_BESIDE * count as f64;
            let (step, seen) = (height - first.0, measured(at) - first.1);
            let is_measured = seen * step.signum() >= LEAST_MEASURED * step.abs();
            count >= FEWEST && is_clear && is_measured && (at == 0 || self.is_slid(levels, at))
        })
    }

    /// Whether the tool slides on a plane more than once, or for a good part of the log. A single slide between two on other
    /// planes is that of a tool which a person lifts or pushes down, unless it is long.
    fn is_slid(&self, levels: &Levels, at: usize) -> bool {
        let on: Vec<&PressedPlace> = self.on(levels, at).collect();
        let slides = on.chunk_by(|one, next| is_next(one, next));
        let slides: Vec<&[&PressedPlace]> = slides
            .filter(|slide| {
                let mut ways = slide.iter().map(|one| (one.place - slide[0].place).norm());
                ways.any(|way| way >= LEAST_SLIDE)
            })
            .collect();
        let [slide] = slides[..] else {
            return slides.len() > 1;
        };
        let steps = slide
            .windows(2)
            .map(|two| (two[1].place - two[0].place).norm());
        let [first, last] = [slide[0], slide[slide.len() - 1]];
        let is_between = self
            .contacts
            .windows(2)
            .any(|two| two[1].index == first.index && is_next(&two[0], &two[1]))
            && self
                .contacts
                .windows(2)
                .any(|two| two[0].index == last.index && is_next(&two[0], &two[1]));
        let is_long = steps.sum::<f64>() >= LEAST_LONG;
        slide.len() as f64 >= LEAST_ONLY * self.contacts.len() as f64 && (is_long || !is_between)
    }
}

/// Whether two contacts belong to one slide.
fn is_next(one: &PressedPlace, next: &PressedPlace) -> bool {
    (next.place - one.place).norm() <= APART && next.index - one.index <= 2
}

fn point(contact: &PressedPlace) -> Point3 {
    Point3::new(contact.place.x, contact.place.y, contact.height)
}
