//! Update of the belief by a camera observation.
//!
//! An observation shows where dirt lies, but hardly anything about the parameters that move it. If
//! whole members were weighted by how well their places match, a single member would remain,
//! because no member has all of some eighty places right. Parameters and places are therefore
//! updated separately (Rao-Blackwellised):
//!
//! - The parameters of the members get importance weights, from how much dirt each member has left
//!   within the goal and outside it. If few members carry the weight, systematic resampling
//!   follows. If hardly a member explains the observed numbers, the likelihood is flattened;
//!   otherwise it would select the most extreme member alone.
//! - The places of each member are drawn anew. A Bernoulli trial per detection decides whether it is dirt (Mahler
//!   2007). Within the goal and outside it, Bayes' rule gives the number of missed grains, from the member's own number
//!   and the number detected (a binomial likelihood). Missed grains stay where the member has them.
//!
//! A particle that is neither detected nor missed is gone. Its fate follows from the task's effect.
//!
//! A log may be wrong about nearly all of the dirt, in every member alike. So the amount of dirt where no member has any
//! follows from the detections (empirical Bayes; Robbins 1956), and a number of grains far above a member's own loses its
//! weight as prior: the observation decides.

use super::ensemble::{Belief, MemberState};
use super::performance::PerformanceDistribution;
use crate::geometry::{Point2, PointGrid};
use crate::interpret::doubt::Doubt;
use crate::random::normal_pair;
use crate::represent::{
    Effect, Fate, GoalState, Observation, ParticleDistribution, Sight, Surface,
};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;
use std::collections::HashMap;

/// Share of effective members below which the ensemble is resampled [1].
const RESAMPLE_BELOW: f64 = 0.5;
/// Standard deviation of a member's number of grains beyond sensor errors: a share of it [1], and a number.
const COUNT_ERROR: [f64; 2] = [0.1, 1.0];
/// Least effective number of members that explain the number of grains; fewer contradict it.
const FEWEST_EFFECTIVE: f64 = 8.0;
/// Standard deviations of the number of detections beyond the range of the members at which it contradicts them [1].
const FAR: f64 = 2.5;
/// Bisection steps to the flattened likelihood under which the least permitted number of members is
/// effective.
const HALVINGS: usize = 30;
/// Share of the members below and above the range that describes them [1].
const TAIL: f64 = 0.05;
/// Probability of so few detections below which a camera that has shown no dirt before is in doubt [1].
const UNLIKELY: f64 = 0.1;
/// Radius over which the members' dirt gives the prior probability of dirt at a place [m].
const NEIGHBOURHOOD: f64 = 0.02;
/// Prior share of the dirt that lies where no member has any [1].
const ANYWHERE: f64 = 0.05;
/// Steps of the fixed-point iteration to the amount of dirt that lies where no member has any.
const ANYWHERE_STEPS: usize = 100;
/// Largest distance between a particle and its detection, in standard deviations of the sensor [1].
pub(super) const MATCHED: f64 = 3.0;
/// Largest number of particles near a detection among which the nearest is searched; further
/// particles are skipped.
const MOST_MATCHES: usize = 256;
/// Regions in which dirt is counted: outside the goal and within it.
const REGIONS: usize = 2;
/// Largest number of pairs of detections and particles that are counted one by one; above it, cells
/// are counted.
const MOST_PAIRS: usize = 100_000_000;
/// Largest number of particles of all members after an observation, unless that leaves too few
/// members.
const MOST_PARTICLES: usize = 1 << 22;
const FEWEST_MEMBERS: usize = 16;
/// Exponent beyond which a likelihood is computed by its logarithm.
const LARGEST_EXPONENT: f64 = 600.0;
/// Random streams of the update.
const STREAM: u64 = 0x7369_6768_0000_0000;

/// A camera observation of a surface, with what is needed to update a belief by it.
#[derive(Debug, Clone, Copy)]
pub struct ObservationUpdate<'a> {
    /// Detections and occluded area.
    pub observation: &'a Observation,
    /// Detection rate and sensor noise.
    pub sight: Sight,
    /// The observed surface.
    pub surface: &'a Surface,
    /// Goal of the task.
    pub goal: &'a GoalState,
    /// Seed of the random numbers of the update.
    pub seed: u64,
}

impl Belief {
    /// Returns the belief after an observation.
    ///
    /// Before the first log, an observation determines how much dirt there is. After it, dirt that
    /// is no longer detected counts as gone.
    ///
    /// For very many detections fewer members are kept, so that all members together have at most about four million
    /// particles.
    ///
    /// A certain belief stays as it is, and so does a belief that is observed with a detection rate of 0.
    #[must_use]
    pub fn observe(&self, update: &ObservationUpdate<'_>) -> Self {
        let was_seen = self.was_seen || update.shows_dirt();
        if self.is_certain() || update.sight.detection <= 0.0 {
            return self.clone().with_seen(was_seen);
        }
        let (weights, _) = update.reweight(self);
        let effective = effective_number(&weights);
        let weighted = self.with_weights(weights);
        let count = weighted.members().len();
        let is_even = effective >= RESAMPLE_BELOW * count as f64;
        let kept = count.min(update.most_members(self));
        let (chosen, weights) = if is_even && kept == count {
            ((0..count).collect(), weighted.weights().to_vec())
        } else {
            let chosen = weighted.systematic(kept, update.seed ^ STREAM);
            (chosen, vec![1.0 / kept as f64; kept])
        };
        let believed = Intensity::of(&weighted, update);
        let is_first = !weighted.was_wiped();
        let members = chosen.into_par_iter().enumerate().map(|(index, member)| {
            let mut random = ChaCha8Rng::seed_from_u64(update.seed);
            random.set_stream(STREAM ^ index as u64);
            let was = &weighted.members()[member];
            let state = weighted.states.get(member);
            update.update_member(was, state, &believed, is_first, &mut random)
        });
        weighted.with_observed(members.collect(), weights, was_seen)
    }

    /// Whether a log has been replayed.
    fn was_wiped(&self) -> bool {
        !self.states.is_empty()
    }
}

/// Probability of dirt at each detection.
struct Intensity {
    /// Probability that a detection is dirt [1], by detection.
    real: Vec<f64>,
}

impl Intensity {
    fn of(belief: &Belief, update: &ObservationUpdate<'_>) -> Self {
        let area = update.surface.outline.area();
        let circle = std::f64::consts::PI * NEIGHBOURHOOD * NEIGHBOURHOOD;
        let mut expected = 0.0;
        let detections = &update.observation.detections;
        let mut near = vec![0.0; detections.len()];
        let particles: usize = belief.members().iter().map(ParticleDistribution::len).sum();
        let is_exact = particles.saturating_mul(detections.len()) <= MOST_PAIRS;
        let places = (belief.members().iter().zip(belief.weights()))
            .flat_map(|(member, weight)| member.remaining().map(move |place| (place, *weight)));
        if is_exact {
            let grid = PointGrid::from_points(detections, NEIGHBOURHOOD);
            for (place, weight) in places {
                expected += weight;
                grid.visit_within(place, NEIGHBOURHOOD, |index, _| near[index] += weight);
            }
        } else {
            let mut counted = Counted::default();
            for (place, weight) in places {
                expected += weight;
                counted.add(place, weight);
            }
            near = (detections.par_iter())
                .map(|place| counted.near(*place))
                .collect();
        }
        let known: Vec<f64> = (near.iter())
            .map(|near| update.sight.detection * (1.0 - ANYWHERE) * near / circle)
            .collect();
        let alarms = update.sight.sensor.false_alarms_per_m2;
        let least = update.sight.detection * ANYWHERE * expected.max(1.0) / area;
        let anywhere = estimate_anywhere(&known, alarms, least, area);
        let real = |known: &f64| (known + anywhere) / (known + anywhere + alarms);
        Self {
            real: known.iter().map(real).collect(),
        }
    }
}

/// Returns the rate of detections of dirt where no member has any [1/m²]: the most probable one, given the detections and a
/// prior that is inversely proportional to the rate, and at least `least`.
///
/// A single detection more than expected counts as a false alarm. Many of them do not.
///
/// # Parameters
/// - `known`: rate of detections of the members' dirt, by detection [1/m²].
/// - `alarms`: rate of false alarms [1/m²].
/// - `least`: the least rate that is returned [1/m²].
/// - `area`: area of the surface [m²].
fn estimate_anywhere(known: &[f64], alarms: f64, least: f64, area: f64) -> f64 {
    let mut rate = least.max(known.len() as f64 / area);
    for _ in 0..ANYWHERE_STEPS {
        // A step of expectation maximisation. The prior takes one detection away.
        let shares = known.iter().map(|known| rate / (known + rate + alarms));
        let next = least.max((shares.sum::<f64>() - 1.0) / area);
        if next == rate {
            break;
        }
        rate = next;
    }
    rate
}

impl ObservationUpdate<'_> {
    /// Returns the number of members after the observation; each may have as many particles as before plus one per
    /// detection.
    fn most_members(&self, belief: &Belief) -> usize {
        let members = belief.members().len();
        let before: usize = belief.members().iter().map(ParticleDistribution::len).sum();
        let each = before / members + self.observation.detections.len();
        (MOST_PARTICLES / each.max(1)).max(FEWEST_MEMBERS)
    }

    /// Whether dirt at a place on the surface is where the goal requires it.
    fn is_met_at(&self, place: Point2) -> bool {
        self.goal.is_met_by(place, Fate::OnSurface, self.surface)
    }

    fn is_visible(&self, place: Point2) -> bool {
        !self.observation.is_hidden(place)
    }

    /// Returns the region of a place.
    fn region(&self, place: Point2) -> usize {
        usize::from(self.is_met_at(place))
    }

    /// Counts places in each region.
    fn count_by_region(&self, places: impl Iterator<Item = Point2>) -> [usize; REGIONS] {
        let mut counts = [0; REGIONS];
        for place in places {
            counts[self.region(place)] += 1;
        }
        counts
    }

    /// Returns the log-likelihood of the numbers of grains observed, by member.
    fn log_likelihoods(&self, belief: &Belief) -> Vec<f64> {
        let detections = self.observation.detections.iter().copied();
        let seen = self.count_by_region(detections);
        let alarms = self.false_alarms();
        let [share, number] = COUNT_ERROR;
        let fit = |member: &ParticleDistribution| {
            let visible = member.remaining().filter(|place| self.is_visible(*place));
            let left = self.count_by_region(visible).map(|count| count as f64);
            let fits = [0, 1].map(|k| {
                let expected = self.sight.detection * left[k] + if k == 0 { alarms } else { 0.0 };
                let misses = self.sight.detection * (1.0 - self.sight.detection) * left[k];
                let other = share * left[k] + number;
                let variance = misses + alarms + other * other;
                let off = seen[k] as f64 - expected;
                // Log-likelihood of the count, a normal distribution about the expected one.
                -0.5 * (off * off / variance + libm::log(variance))
            });
            fits[0] + fits[1]
        };
        belief.members().iter().map(fit).collect()
    }

    /// Whether the observation shows more detections than false alarms.
    pub(in crate::interpret) fn shows_dirt(&self) -> bool {
        self.sight.detection > 0.0 && self.observation.detections.len() as f64 > self.false_alarms()
    }

    /// Expected number of false alarms. Their share within the goal is the goal's share of the surface, which is small.
    pub(super) fn false_alarms(&self) -> f64 {
        self.sight.sensor.false_alarms_per_m2 * self.surface.outline.area()
    }

    /// Returns the members' weights, by how much dirt each has left in each region, and whether hardly a member explains the
    /// numbers observed, so that the likelihood was flattened.
    fn reweight(&self, belief: &Belief) -> (Vec<f64>, bool) {
        let fits = self.log_likelihoods(belief);
        let flattened = |exponent: f64| weigh(&fits, belief.weights(), exponent);
        let weights = flattened(1.0);
        let fewest = FEWEST_EFFECTIVE.min(0.5 * effective_number(belief.weights()));
        if effective_number(&weights) >= fewest {
            return (weights, false);
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if effective_number(&flattened(middle)) >= fewest {
                low = middle;
            } else {
                high = middle;
            }
        }
        (flattened(low), true)
    }

    /// Returns a doubt if the number of observed grains contradicts the belief: hardly a member
    /// explains the number, it is far outside the range of all members, or the first observation
    /// shows fewer grains than this range. `was_felt`: whether the log before the observation shows
    /// contact; without contact, all earlier dirt is still expected.
    pub(in crate::interpret) fn find_contradiction(
        &self,
        belief: &Belief,
        was_felt: bool,
    ) -> Option<Doubt> {
        if belief.is_certain() || self.sight.detection <= 0.0 {
            return None;
        }
        let untouched = |member: usize| {
            let Some(state) = belief.states.get(member) else {
                return 0.0;
            };
            let particles = belief.members()[member].iter().enumerate();
            let never = particles.filter(|(i, (place, fate))| {
                fate.is_on_surface() && self.is_visible(*place) && !state.activation.is_touched(*i)
            });
            never.count() as f64
        };
        let seen = self.observation.detections.len();
        let all = |member: usize| belief.count_before(member) as f64;
        let visible = |member: usize| self.count_visible(&belief.members()[member]);
        let count_left: &dyn Fn(usize) -> f64 = if was_felt { &visible } else { &all };
        let believed = self.expect(belief, &all);
        let left = self.expect(belief, count_left);
        let [least, most] = left;
        let is_more = seen as f64 > most + FAR * self.count_error(most);
        let is_less = (seen as f64) < least - FAR * self.count_error(least);
        // A camera that has shown no dirt before may miss more than its detection rate states.
        let is_unproven_less = !belief.was_seen
            && (seen as f64) < least
            && self.probability_of_at_most(seen, belief, count_left) < UNLIKELY;
        let is_far = is_more || is_less || is_unproven_less;
        let hidden_share = if is_more {
            self.hidden_share(belief)
        } else {
            0.0
        };
        (is_far || self.reweight(belief).1).then(|| Doubt::ObservationContradicts {
            hidden_share,
            is_more_than_before: seen as f64 > believed[1] + FAR * self.count_error(believed[1]),
            seen,
            left,
            shares: (!is_far).then(|| self.goal_shares(belief)).flatten(),
            believed,
            untouched: {
                let [least, _] = if was_felt {
                    self.expect(belief, &untouched)
                } else {
                    believed
                };
                least - FAR * self.count_error(least)
            },
            is_first: !belief.was_seen,
        })
    }

    /// Returns the share of the detections within the goal, and the range of this share that the members predict (5 % and
    /// 95 % quantiles), if the share lies outside it [1].
    fn goal_shares(&self, belief: &Belief) -> Option<[f64; 3]> {
        let share =
            |[outside, within]: [usize; REGIONS]| within as f64 / (outside + within).max(1) as f64;
        let seen = share(self.count_by_region(self.observation.detections.iter().copied()));
        let shares = belief.members().iter().map(|member| {
            let visible = member.remaining().filter(|place| self.is_visible(*place));
            share(self.count_by_region(visible))
        });
        let shares = shares.zip(belief.weights().iter().copied());
        let shares = PerformanceDistribution::from_shares(shares, 0.0);
        let [least, most] = [TAIL, 1.0 - TAIL].map(|tail| shares.quantile(tail));
        (!(least..=most).contains(&seen)).then_some([seen, least, most])
    }

    /// Returns the mean share of the members' dirt, remaining or not, that lies in occluded places [1].
    fn hidden_share(&self, belief: &Belief) -> f64 {
        let members = belief.members().iter().zip(belief.weights());
        let shares = members.map(|(member, weight)| {
            let hidden = (0..member.len()).filter(|&i| !self.is_visible(member.position(i)));
            weight * hidden.count() as f64 / member.len().max(1) as f64
        });
        shares.sum()
    }

    /// Returns the range of the number of detections that a belief predicts, if the observation
    /// shows none although some are predicted: the surface is clean, or the camera does not detect
    /// the dirt.
    pub(crate) fn find_unseen(&self, belief: &Belief) -> Option<[f64; 2]> {
        if belief.is_certain() || !self.observation.detections.is_empty() {
            return None;
        }
        let expected = self.expect_visible(belief);
        let [least, _] = expected;
        (least > FAR * self.count_error(least)).then_some(expected)
    }

    /// Returns the range of the number of detections that a belief predicts from its visible dirt.
    fn expect_visible(&self, belief: &Belief) -> [f64; 2] {
        self.expect(belief, &|member| {
            self.count_visible(&belief.members()[member])
        })
    }

    /// Number of a member's grains that are on the surface and not occluded.
    fn count_visible(&self, member: &ParticleDistribution) -> f64 {
        let remaining = member.remaining();
        remaining.filter(|place| self.is_visible(*place)).count() as f64
    }

    /// Returns the probability of at most `seen` detections [1]. `count`: number of grains by member.
    fn probability_of_at_most(
        &self,
        seen: usize,
        belief: &Belief,
        count: &dyn Fn(usize) -> f64,
    ) -> f64 {
        let one = |(member, weight): (usize, &f64)| {
            let expected = self.sight.detection * count(member) + self.false_alarms();
            let score = (expected - seen as f64 - 0.5) / self.count_error(expected);
            weight * 0.5 * libm::erfc(score * std::f64::consts::FRAC_1_SQRT_2)
        };
        belief.weights().iter().enumerate().map(one).sum()
    }

    /// Returns the range of the number of detections that the members predict (5 % and 95 %
    /// quantiles). `count`: number of grains by member.
    fn expect(&self, belief: &Belief, count: &dyn Fn(usize) -> f64) -> [f64; 2] {
        let members = 0..belief.members().len();
        let counts =
            members.map(|member| self.sight.detection * count(member) + self.false_alarms());
        let counts = counts.zip(belief.weights().iter().copied());
        let counts = PerformanceDistribution::from_shares(counts, 0.0);
        [TAIL, 1.0 - TAIL].map(|share| counts.quantile(share))
    }

    /// Standard deviation of the number of detections, given the expected number [1].
    fn count_error(&self, expected: f64) -> f64 {
        let [share, number] = COUNT_ERROR;
        let misses = (1.0 - self.sight.detection) * expected;
        (misses + self.false_alarms())
            .sqrt()
            .hypot(share * expected + number)
    }

    /// Returns a member's dirt after the observation, with the thresholds of the matched particles.
    fn update_member(
        &self,
        was: &ParticleDistribution,
        state: Option<&MemberState>,
        believed: &Intensity,
        is_first: bool,
        random: &mut ChaCha8Rng,
    ) -> (ParticleDistribution, Option<MemberState>) {
        let mut member = MemberUpdate {
            update: self,
            random,
            particles: was.iter().collect(),
            unassigned: Vec::new(),
            free: Vec::new(),
        };
        let visible = member.visible();
        let left = self.count_by_region(visible.iter().map(|&i| member.particles[i].0));
        let hidden = was.tally().remaining - visible.len();
        let most = if is_first {
            usize::MAX
        } else {
            was.len() - hidden
        };
        let (real, unseen) = member.match_detections(&visible, believed);
        let missed = self.draw_missed(left, &real, most, member.random);
        member.keep_missed(missed, &unseen, &real);
        if !is_first {
            member.free_gone();
        }
        let renewed = member.assign_particles();
        let particles = member.remove_free(was, is_first);
        let state = state.map(|state| {
            let mut state = state.clone();
            state.activation.renew(&renewed, particles.len());
            state
        });
        // Detections are finite, and so are the members' places.
        let particles = ParticleDistribution::with_fates(&particles);
        (particles.unwrap_or_else(|_| was.clone()), state)
    }

    /// Draws how many grains the camera missed in each region. `left`: visible grains of the member, by region; `seen`:
    /// grains detected; `most`: limit of the visible grains.
    fn draw_missed(
        &self,
        left: [usize; REGIONS],
        seen: &[Vec<Point2>; REGIONS],
        most: usize,
        random: &mut ChaCha8Rng,
    ) -> [usize; REGIONS] {
        let all_seen: usize = seen.iter().map(Vec::len).sum();
        let mut visible_left = most.saturating_sub(all_seen);
        // The goal comes first, as it holds either most of the dirt or none.
        let mut missed = [0; REGIONS];
        for region in (0..REGIONS).rev() {
            let seen = seen[region].len();
            missed[region] =
                self.draw_missed_in_region(left[region] as f64, seen, visible_left, random);
            visible_left -= missed[region];
        }
        missed
    }

    /// Draws the number of missed grains in a region by Bayes' rule. The prior is a normal distribution about the
    /// member's number `left`; each grain is detected independently, and `seen` grains were.
    fn draw_missed_in_region(
        &self,
        left: f64,
        seen: usize,
        most: usize,
        random: &mut ChaCha8Rng,
    ) -> usize {
        let miss = 1.0 - self.sight.detection;
        let [share, number] = COUNT_ERROR;
        let mut deviation = share * left + number;
        // Far more grains than the member has contradict its number, which then hardly counts.
        let beyond = seen as f64 / self.sight.detection - left;
        if beyond > FAR * deviation.hypot((miss * left).sqrt()) {
            deviation = beyond;
        }
        // A number five standard deviations above the member's is impossible by the prior.
        let most = most.min((left + 5.0 * deviation).max(0.0) as usize + 1);
        let mut weights = Vec::with_capacity(most + 1);
        let place = random.random::<f64>();
        if -(seen as f64 + 1.0) * libm::log(1.0 - miss) > LARGEST_EXPONENT {
            return draw_missed_of_many((left, deviation), (seen, miss), most, place);
        }
        // The likelihood of k missed grains is binomial, C(seen + k, k) (1 - p)^k up to a constant; the loop updates it
        // factor by factor.
        let (mut likelihood, mut sum) = (1.0, 0.0);
        let nearest = (left - seen as f64).max(0.0).round();
        let least = (seen as f64 + nearest - left) / deviation;
        for missed in 0..=most {
            let off = (seen + missed) as f64 - left;
            let prior = libm::exp(-0.5 * ((off / deviation).powi(2) - least * least));
            sum += likelihood * prior;
            weights.push(sum);
            likelihood *= miss * (seen + missed + 1) as f64 / (missed + 1) as f64;
        }
        let place = place * sum;
        weights.partition_point(|sum| *sum <= place).min(most)
    }

    /// Draws the true place of a detected grain from the sensor's position error.
    fn draw_place(&self, seen: Point2, random: &mut ChaCha8Rng) -> Point2 {
        let there = seen + normal_pair(random) * self.sight.sensor.position_error_m;
        if self.surface.outline.contains(there) {
            there
        } else {
            seen
        }
    }

    /// Draws the fate of dirt that is no longer there; `crossed` are the edges over which the member has lost dirt.
    fn fate_of_missing(&self, place: Point2, crossed: &[u16], random: &mut ChaCha8Rng) -> Fate {
        match self.goal.action().effect() {
            Effect::Absorb => Fate::Absorbed,
            // A place of a treated surface cannot disappear.
            Effect::Treat => Fate::OnSurface,
            Effect::Push if !crossed.is_empty() => Fate::OffSurface {
                edge: crossed[random.random_range(0..crossed.len())],
            },
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

/// A member's dirt during an observation update.
struct MemberUpdate<'a> {
    update: &'a ObservationUpdate<'a>,
    random: &'a mut ChaCha8Rng,
    particles: Vec<(Point2, Fate)>,
    /// Detected and missed grains that no particle represents yet.
    unassigned: Vec<Point2>,
    /// Particles that may represent other grains, taken from the end.
    free: Vec<usize>,
}

impl MemberUpdate<'_> {
    /// Returns the particles on the surface that are not occluded.
    fn visible(&self) -> Vec<usize> {
        let is_visible = |&i: &usize| {
            let (place, fate) = self.particles[i];
            fate == Fate::OnSurface && self.update.is_visible(place)
        };
        (0..self.particles.len()).filter(is_visible).collect()
    }

    /// Draws which detections are dirt, and moves the nearest particles there. Returns the detected grains by region,
    /// and in random order the particles that were not detected: the camera missed them, or they are gone.
    fn match_detections(
        &mut self,
        visible: &[usize],
        believed: &Intensity,
    ) -> ([Vec<Point2>; REGIONS], Vec<usize>) {
        let update = self.update;
        let at: Vec<Point2> = visible.iter().map(|&i| self.particles[i].0).collect();
        let radius = (MATCHED * update.sight.sensor.position_error_m).max(1e-6);
        let mut grid = PointGrid::from_points(&at, radius / 2.0);
        let mut is_detected = vec![false; visible.len()];
        let mut real = [const { Vec::new() }; REGIONS];
        for (place, probability) in update.observation.detections.iter().zip(&believed.real) {
            if self.random.random::<f64>() >= *probability {
                continue;
            }
            let there = update.draw_place(*place, self.random);
            real[update.region(*place)].push(there);
            match grid.nearest_within(*place, radius, MOST_MATCHES) {
                Some(index) => {
                    grid.remove(index, at[index]);
                    is_detected[index] = true;
                    self.particles[visible[index]].0 = there;
                }
                None => self.unassigned.push(there),
            }
        }
        let unseen = (visible.iter().zip(is_detected)).filter(|(_, is_detected)| !is_detected);
        let mut unseen: Vec<usize> = unseen.map(|(&index, _)| index).collect();
        unseen.shuffle(self.random);
        (real, unseen)
    }

    /// Keeps as many undetected particles as were `missed` in each region, and frees the remaining ones.
    fn keep_missed(
        &mut self,
        missed: [usize; REGIONS],
        unseen: &[usize],
        real: &[Vec<Point2>; REGIONS],
    ) {
        for (region, (mut missed, seen)) in missed.into_iter().zip(real).enumerate() {
            for &index in unseen {
                if self.update.region(self.particles[index].0) != region {
                    continue;
                }
                if missed > 0 {
                    missed -= 1;
                } else {
                    self.free.push(index);
                }
            }
            // Missed grains beyond the member's undetected particles are placed among the detected ones.
            if !seen.is_empty() {
                let anyone = (0..missed).map(|_| seen[self.random.random_range(0..seen.len())]);
                self.unassigned.extend(anyone);
            }
        }
    }

    /// Frees the particles that are believed gone, as they may be among the detected grains. They are used after the
    /// undetected ones.
    fn free_gone(&mut self) {
        let particles = self.particles.iter().enumerate().rev();
        let gone = particles.filter(|(_, (_, fate))| *fate != Fate::OnSurface);
        self.free.splice(0..0, gone.map(|(index, _)| index));
    }

    /// Assigns a free particle or a new one to each unassigned grain, and returns the reused particles.
    fn assign_particles(&mut self) -> Vec<usize> {
        let mut renewed = Vec::new();
        for there in self.unassigned.drain(..) {
            match self.free.pop() {
                Some(index) => {
                    self.particles[index] = (there, Fate::OnSurface);
                    renewed.push(index);
                }
                None => self.particles.push((there, Fate::OnSurface)),
            }
        }
        renewed
    }

    /// Gives the free particles the fate of missing dirt and returns all particles. The first observation removes them
    /// altogether.
    fn remove_free(mut self, was: &ParticleDistribution, is_first: bool) -> Vec<(Point2, Fate)> {
        // The member has wiped over the edges over which it has lost dirt.
        let crossed: Vec<u16> = (was.iter())
            .filter_map(|(_, fate)| match fate {
                Fate::OffSurface { edge } if fate != Fate::FALLEN => Some(edge),
                _ => None,
            })
            .collect();
        let mut is_there = vec![true; self.particles.len()];
        for index in self.free {
            let (place, fate) = &mut self.particles[index];
            if *fate == Fate::OnSurface {
                is_there[index] = !is_first;
                *fate = self.update.fate_of_missing(*place, &crossed, self.random);
            }
        }
        let mut is_there = is_there.into_iter();
        // Before the first log no particle has a threshold that an index would have to keep.
        self.particles.retain(|_| is_there.next().unwrap_or(true));
        self.particles
    }
}

/// Returns the weights of members with these log-likelihoods; `exponent` flattens the likelihood if it is below 1.
fn weigh(fits: &[f64], weights: &[f64], exponent: f64) -> Vec<f64> {
    let best = fits.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let weights = fits.iter().zip(weights);
    let weights: Vec<f64> = weights
        .map(|(fit, weight)| weight * libm::exp(exponent * (fit - best)))
        .collect();
    let sum: f64 = weights.iter().sum();
    weights.into_iter().map(|weight| weight / sum).collect()
}

/// Effective number of members with these weights (Kish).
fn effective_number(weights: &[f64]) -> f64 {
    1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>()
}

/// Draws as [`ObservationUpdate::draw_missed_in_region`] does, but by logarithms, for counts whose
/// likelihood exceeds the range of `f64`. `place` in [0, 1) is the quantile.
fn draw_missed_of_many(
    (left, deviation): (f64, f64),
    (seen, miss): (usize, f64),
    most: usize,
    place: f64,
) -> usize {
    let mut exponent = 0.0;
    let mut exponents = Vec::with_capacity(most + 1);
    for missed in 0..=most {
        let off = ((seen + missed) as f64 - left) / deviation;
        exponents.push(exponent - 0.5 * off * off);
        exponent += libm::log(miss * (seen + missed + 1) as f64 / (missed + 1) as f64);
    }
    let greatest = exponents.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut sum = 0.0;
    let sums: Vec<f64> = (exponents.iter())
        .map(|exponent| {
            sum += libm::exp(exponent - greatest);
            sum
        })
        .collect();
    sums.partition_point(|partial| *partial <= place * sum)
        .min(most)
}

/// Weights of places, summed over square cells, for counting neighbours among very many places.
#[derive(Default)]
struct Counted {
    cells: HashMap<[i64; 2], f64>,
}

impl Counted {
    /// Side of a cell [m].
    const CELL: f64 = NEIGHBOURHOOD / 8.0;

    fn add(&mut self, place: Point2, weight: f64) {
        *self.cells.entry(Self::cell(place)).or_default() += weight;
    }

    /// Sums the weights of the cells whose middle lies in the neighbourhood of a place.
    fn near(&self, place: Point2) -> f64 {
        let reach = (NEIGHBOURHOOD / Self::CELL) as i64 + 1;
        let [x, y] = Self::cell(place);
        let cells = (x - reach..=x + reach)
            .flat_map(|column| (y - reach..=y + reach).map(move |row| [column, row]));
        let is_near = |[column, row]: &[i64; 2]| {
            let middle = Point2::new(*column as f64 + 0.5, *row as f64 + 0.5) * Self::CELL;
            (middle - place).norm() <= NEIGHBOURHOOD
        };
        (cells.filter(is_near))
            .filter_map(|cell| self.cells.get(&cell))
            .sum()
    }

    fn cell(place: Point2) -> [i64; 2] {
        // Detections beyond this are far from every surface; the limit keeps the index within `i64`.
        const MOST: f64 = 1e15;
        [place.x, place.y].map(|along| (along / Self::CELL).floor().clamp(-MOST, MOST) as i64)
    }
}
