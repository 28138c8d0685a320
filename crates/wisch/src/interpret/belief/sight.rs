//! What a look at the surface says of a belief.
//!
//! Where dirt lies and what moves it are two things, and a look tells much of the first and little of the second. An
//! ensemble that were weighted by how well each member's places match would have one member left: of eighty places none
//! is ever right. So the two are updated apart (Rao and Blackwell's way):
//!
//! - the members' parameters by importance weights, by how much dirt each has left within the goal and elsewhere, which
//!   is what places say of parameters; then systematic resampling where few members carry the weight;
//! - the places of each member anew, by Bayes' rule for points seen with misses, false alarms and errors of position
//!   (Poisson intensity of what was not detected, a Bernoulli trial for each detection; Mahler 2007).
//!
//! A particle that is neither seen nor missed is gone: a look tells what lies there, and the rest follows from how much
//! there was.

use super::ensemble::{Belief, MemberState};
use crate::geometry::Point2;
use crate::random::normal_pair;
use crate::represent::{
    Effect, Fate, GoalState, Observation, ParticleDistribution, Sight, Surface,
};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;

/// Below this share of the members, those that carry the weight are resampled [1].
const RESAMPLE_BELOW: f64 = 0.5;
/// What a member's dirt may be off by beside what the sensor does, as a share of it [1] and as a number.
const COUNT_ERROR: [f64; 2] = [0.1, 1.0];
/// Distance over which the members' dirt says how likely dirt is at a place [m].
const NEIGHBOURHOOD: f64 = 0.02;
/// How much of the dirt may lie where no member has any [1].
const ANYWHERE: f64 = 0.05;
/// A particle within so many standard deviations of a detection may be the one detected [1].
const MATCHED: f64 = 3.0;
/// Streams of random numbers.
const STREAM: u64 = 0x7369_6768_0000_0000;

/// A look at a surface, and what is to be made of it.
#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    /// What was seen.
    pub observation: &'a Observation,
    /// How well dirt is seen.
    pub sight: Sight,
    /// What is looked at.
    pub surface: &'a Surface,
    /// What is striven for.
    pub goal: &'a GoalState,
    /// Of everything random.
    pub seed: u64,
}

impl Belief {
    /// The belief after a look.
    ///
    /// Before anything was wiped, a look says how much dirt there is; afterwards, what is gone is what there was less what
    /// is left.
    ///
    /// What is known for certain is not looked for: certainty stays what it is.
    #[must_use]
    pub fn seen(&self, look: &Look<'_>) -> Self {
        if self.is_certain() {
            return self.clone();
        }
        let weights = look.weights(self);
        let squares: f64 = weights.iter().map(|weight| weight * weight).sum();
        let weighted = self.reweighted(weights);
        let count = weighted.replays().len();
        let is_even = 1.0 / squares >= RESAMPLE_BELOW * count as f64;
        let (chosen, weights) = if is_even {
            ((0..count).collect(), weighted.weights().to_vec())
        } else {
            let chosen = weighted.systematic(count, look.seed ^ STREAM);
            (chosen, vec![1.0 / count as f64; count])
        };
        let believed = Intensity::of(&weighted, look);
        let is_first = !weighted.was_wiped();
        let members = chosen.into_par_iter().enumerate().map(|(index, member)| {
            let mut random = ChaCha8Rng::seed_from_u64(look.seed);
            random.set_stream(STREAM ^ index as u64);
            let was = &weighted.replays()[member];
            let state = weighted.states.get(member);
            look.places(was, state, &believed, is_first, &mut random)
        });
        Self::after_look(members.collect(), weights)
    }

    /// Whether a log was replayed.
    fn was_wiped(&self) -> bool {
        !self.states.is_empty()
    }
}

/// How likely dirt is at a detection.
struct Intensity {
    /// Per detection, that it is dirt [1].
    real: Vec<f64>,
}

impl Intensity {
    fn of(belief: &Belief, look: &Look<'_>) -> Self {
        let area = look.surface.outline.area();
        let circle = std::f64::consts::PI * NEIGHBOURHOOD * NEIGHBOURHOOD;
        let mut expected = 0.0;
        let detections = &look.observation.detections;
        let mut near = vec![0.0; detections.len()];
        let grid = Grid::new(detections, NEIGHBOURHOOD);
        for (member, weight) in belief.replays().iter().zip(belief.weights()) {
            for place in member.remaining() {
                expected += weight;
                grid.within(place, NEIGHBOURHOOD, |index| near[index] += weight);
            }
        }
        let floor = ANYWHERE * expected.max(1.0) / area;
        let real = |near: &f64| {
            let intensity = look.sight.detection * ((1.0 - ANYWHERE) * near / circle + floor);
            intensity / (intensity + look.sight.sensor.false_alarms_per_m2)
        };
        Self {
            real: near.iter().map(real).collect(),
        }
    }
}

impl Look<'_> {
    fn is_visible(&self, place: Point2) -> bool {
        !self.observation.is_hidden(place)
    }

    /// The members' weights by how much each has left where the goal wants it and elsewhere.
    fn weights(&self, belief: &Belief) -> Vec<f64> {
        let is_there = |place: &Point2| self.goal.is_met_by(*place, Fate::OnSurface, self.surface);
        let counts = |places: &mut dyn Iterator<Item = Point2>| {
            let mut counts = [0.0; 2];
            for place in places {
                counts[usize::from(is_there(&place))] += 1.0;
            }
            counts
        };
        let seen = counts(&mut self.observation.detections.iter().copied());
        // A false alarm within the goal is as likely as its share of the surface, which is small.
        let alarms = self.sight.sensor.false_alarms_per_m2 * self.surface.outline.area();
        let [share, number] = COUNT_ERROR;
        let fit = |member: &ParticleDistribution| {
            let left = counts(&mut member.remaining().filter(|place| self.is_visible(*place)));
            let fits = [0, 1].map(|k| {
                let expected = self.sight.detection * left[k] + if k == 0 { alarms } else { 0.0 };
                let misses = self.sight.detection * (1.0 - self.sight.detection) * left[k];
                let other = share * left[k] + number;
                let variance = misses + alarms + other * other;
                let off = seen[k] - expected;
                -0.5 * (off * off / variance + libm::log(variance))
            });
            fits[0] + fits[1]
        };
        let fits: Vec<f64> = belief.replays().iter().map(fit).collect();
        let best = fits.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let weights = fits.iter().zip(belief.weights());
        let weights: Vec<f64> = weights
            .map(|(fit, weight)| weight * libm::exp(fit - best))
            .collect();
        let sum: f64 = weights.iter().sum();
        weights.into_iter().map(|weight| weight / sum).collect()
    }

    /// A member's dirt after the look, with the thresholds of what it recognises.
    fn places(
        &self,
        was: &ParticleDistribution,
        state: Option<&MemberState>,
        believed: &Intensity,
        is_first: bool,
        random: &mut ChaCha8Rng,
    ) -> (ParticleDistribution, Option<MemberState>) {
        let mut particles: Vec<(Point2, Fate)> = was.iter().collect();
        let visible: Vec<usize> = (0..particles.len())
            .filter(|&i| particles[i].1 == Fate::OnSurface && self.is_visible(particles[i].0))
            .collect();
        let at: Vec<Point2> = visible.iter().map(|&i| particles[i].0).collect();
        let radius = (MATCHED * self.sight.sensor.position_error_m).max(1e-6);
        let grid = Grid::new(&at, radius);
        let mut is_taken = vec![false; visible.len()];
        let mut found = Vec::new();
        for (place, real) in self.observation.detections.iter().zip(&believed.real) {
            if random.random::<f64>() >= *real {
                continue;
            }
            let there = self.scattered(*place, random);
            let mut nearest: Option<(f64, usize)> = None;
            grid.within(*place, radius, |index| {
                let distance = (at[index] - place).norm();
                if !is_taken[index] && nearest.is_none_or(|(least, _)| distance < least) {
                    nearest = Some((distance, index));
                }
            });
            match nearest {
                Some((_, index)) => {
                    is_taken[index] = true;
                    particles[visible[index]].0 = there;
                }
                None => found.push(there),
            }
        }
        // What is visible and was not seen was missed, or is not there.
        let mut free: Vec<usize> = Vec::new();
        for (&index, taken) in visible.iter().zip(&is_taken) {
            if !taken && random.random::<f64>() < self.sight.detection {
                free.push(index);
            }
        }
        if !is_first {
            // What was believed gone may be what lies there, in the order in which it was given.
            let gone = (0..particles.len()).filter(|&i| particles[i].1 != Fate::OnSurface);
            let gone: Vec<usize> = gone.collect();
            free.splice(0..0, gone.into_iter().rev());
        }
        let mut renewed = Vec::new();
        for there in found {
            match free.pop() {
                Some(index) => {
                    particles[index] = (there, Fate::OnSurface);
                    renewed.push(index);
                }
                None => particles.push((there, Fate::OnSurface)),
            }
        }
        let mut is_there = vec![true; particles.len()];
        for index in free {
            if particles[index].1 == Fate::OnSurface {
                is_there[index] = !is_first;
                particles[index].1 = self.fate_of_missing(particles[index].0);
            }
        }
        let mut is_there = is_there.into_iter();
        // Before anything was wiped, nobody has thresholds yet.
        particles.retain(|_| is_there.next().unwrap_or(true));
        let state = state.map(|state| {
            let mut state = state.clone();
            state.activation.renew(&renewed, particles.len());
            state
        });
        // Detections are finite, and so are the members' places.
        let particles = ParticleDistribution::with_fates(&particles);
        (particles.unwrap_or_else(|_| was.clone()), state)
    }

    /// Where a detected grain may really lie.
    fn scattered(&self, seen: Point2, random: &mut ChaCha8Rng) -> Point2 {
        let there = seen + normal_pair(random) * self.sight.sensor.position_error_m;
        if self.surface.outline.contains(there) {
            there
        } else {
            seen
        }
    }

    /// What became of dirt that is no longer there.
    fn fate_of_missing(&self, place: Point2) -> Fate {
        match self.goal.action().effect() {
            Effect::Absorb => Fate::Absorbed,
            Effect::Push => {
                let edges = self.surface.outline.edges();
                let distances = edges.map(|edge| edge.distance(place)).enumerate();
                let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1));
                let edge = nearest.map_or(0, |(edge, _)| edge);
                Fate::OffSurface {
                    edge: u16::try_from(edge).unwrap_or(u16::MAX),
                }
            }
        }
    }
}

/// Points by square cells, to find those near a place.
struct Grid<'a> {
    points: &'a [Point2],
    cell: f64,
    /// Points of each cell, by cell: sorted.
    cells: Vec<((i64, i64), usize)>,
}

impl<'a> Grid<'a> {
    fn new(points: &'a [Point2], cell: f64) -> Self {
        let mut cells: Vec<_> = (points.iter().enumerate())
            .map(|(index, point)| (Self::cell(*point, cell), index))
            .collect();
        cells.sort_unstable();
        Self {
            points,
            cell,
            cells,
        }
    }

    fn cell(point: Point2, cell: f64) -> (i64, i64) {
        (
            (point.x / cell).floor() as i64,
            (point.y / cell).floor() as i64,
        )
    }

    /// Calls with every point at most this far from a place; `radius` is at most a cell.
    fn within(&self, place: Point2, radius: f64, mut call: impl FnMut(usize)) {
        let (x, y) = Self::cell(place, self.cell);
        for column in x - 1..=x + 1 {
            let begin = self
                .cells
                .partition_point(|(cell, _)| *cell < (column, y - 1));
            for ((at, row), index) in &self.cells[begin..] {
                if *at != column || *row > y + 1 {
                    break;
                }
                if (self.points[*index] - place).norm() <= radius {
                    call(*index);
                }
            }
        }
    }
}
