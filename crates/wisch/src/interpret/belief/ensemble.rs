//! What the robot believes of the dirt: many worlds that may be, each with its own dirt and its own laws.

use super::activation::Activation;
use super::density::DensityMap;
use super::parameter_sampling::MemberParameters;
use super::performance::PerformanceDistribution;
use crate::interpret::contact::StiffnessBelief;
use crate::interpret::error::InterpretError;
use crate::represent::{Fate, GoalState, ParticleDistribution, ParticleError, Surface};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// An ensemble of worlds that may be. Each member has dirt of its own, as many particles as it believes in, and, from
/// the first log on, parameters of its own, which it keeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    replays: Vec<ParticleDistribution>,
    /// Of the members; they add up to 1.
    weights: Vec<f64>,
    /// What each member takes for real; nothing before the first log.
    pub(super) states: Vec<MemberState>,
    /// What the logs said of the tool's stiffness; nothing before the first.
    stiffness: Option<StiffnessBelief>,
}

/// What a member takes for real beside where its dirt lies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MemberState {
    pub(super) parameters: MemberParameters,
    pub(super) activation: Activation,
}

impl Belief {
    /// Certainty: the dirt lies like this.
    pub fn certain(particles: ParticleDistribution) -> Self {
        Self {
            replays: vec![particles],
            weights: vec![1.0],
            states: Vec::new(),
            stiffness: None,
        }
    }

    /// Members of equal weight.
    ///
    /// # Errors
    /// No member at all.
    pub fn of(members: Vec<ParticleDistribution>) -> Result<Self, InterpretError> {
        if members.is_empty() {
            return Err(InterpretError::NoMembers);
        }
        Ok(Self::ensemble(members))
    }

    /// Members of equal weight, at least one.
    pub(super) fn ensemble(members: Vec<ParticleDistribution>) -> Self {
        let weights = vec![1.0 / members.len() as f64; members.len()];
        Self {
            replays: members,
            weights,
            states: Vec::new(),
            stiffness: None,
        }
    }

    /// The same members after a log.
    pub(super) fn continued(
        members: Vec<(ParticleDistribution, MemberState)>,
        weights: Vec<f64>,
        stiffness: StiffnessBelief,
    ) -> Self {
        let (replays, states) = members.into_iter().unzip();
        Self {
            replays,
            weights,
            states,
            stiffness: Some(stiffness),
        }
    }

    /// The same members with other weights.
    pub(super) fn reweighted(&self, weights: Vec<f64>) -> Self {
        Self {
            weights,
            ..self.clone()
        }
    }

    /// What the logs so far said of the tool's stiffness.
    pub(in crate::interpret) fn stiffness(&self) -> Option<StiffnessBelief> {
        self.stiffness
    }

    /// Members after a look; states only if all have some.
    pub(super) fn after_look(
        &self,
        members: Vec<(ParticleDistribution, Option<MemberState>)>,
        weights: Vec<f64>,
    ) -> Self {
        let (replays, states): (Vec<_>, Vec<_>) = members.into_iter().unzip();
        Self {
            replays,
            weights,
            states: states
                .into_iter()
                .collect::<Option<_>>()
                .unwrap_or_default(),
            stiffness: self.stiffness,
        }
    }

    /// The members' dirt; there is at least one.
    pub fn replays(&self) -> &[ParticleDistribution] {
        &self.replays
    }

    /// How likely each member is; the weights add up to 1.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Whether it says exactly where the dirt lies.
    pub fn is_certain(&self) -> bool {
        self.replays.len() == 1
    }

    /// How many members of equal weight would say as much.
    pub fn effective_members(&self) -> f64 {
        let squares: f64 = self.weights.iter().map(|weight| weight * weight).sum();
        1.0 / squares
    }

    /// The belief about the performance; `deviation` is what the model leaves out, as a standard deviation [1].
    pub fn performance(
        &self,
        goal: &GoalState,
        surface: &Surface,
        deviation: f64,
    ) -> PerformanceDistribution {
        PerformanceDistribution::of(&self.replays, &self.weights, goal, surface, deviation)
    }

    /// Fewer members, each as often as its weight says, give or take one; all of equal weight. At least one is kept.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let at = |x| ParticleDistribution::new(&[Point2::new(x, 0.0)]);
    /// let belief = Belief::of(vec![at(0.1)?, at(0.2)?, at(0.3)?, at(0.4)?])?;
    /// assert_eq!(belief.thinned(2, 1).replays().len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn thinned(&self, count: usize, seed: u64) -> Self {
        let kept = self.systematic(count.max(1), seed);
        let weights = vec![1.0 / kept.len() as f64; kept.len()];
        let states = self.states.iter().collect::<Vec<_>>();
        Self {
            replays: kept.iter().map(|&i| self.replays[i].clone()).collect(),
            weights,
            states: (kept.iter())
                .filter_map(|&i| states.get(i).map(|&state| state.clone()))
                .collect(),
            stiffness: self.stiffness,
        }
    }

    /// The dirt of one member, drawn by weight.
    ///
    /// # Errors
    /// None today: the members' dirt is known to be finite.
    pub fn sample(&self, seed: u64) -> Result<ParticleDistribution, ParticleError> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        Ok(self.replays[self.at(random.random())].clone())
    }

    /// The dirt of several members, drawn by weight, one on top of the other: all that the dirt may be like, for plans
    /// that are to be good on average. A single member has dirt where there is none and none where there is some.
    ///
    /// # Errors
    /// More than [`MAX_PARTICLES`](crate::represent::MAX_PARTICLES) in all.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let [here, there] = [0.0, 0.1].map(|x| ParticleDistribution::new(&[Point2::new(x, 0.0)]).unwrap());
    /// let belief = Belief::of(vec![here, there])?;
    /// let draws = belief.draws(1000, 7)?;
    /// let share_here = draws.remaining().filter(|place| place.x < 0.05).count() as f64 / 1000.0;
    /// assert!((share_here - 0.5).abs() < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn draws(&self, count: usize, seed: u64) -> Result<ParticleDistribution, ParticleError> {
        let members = self.members(count, seed);
        let particles: Vec<_> = members.iter().flat_map(|dirt| dirt.iter()).collect();
        ParticleDistribution::with_fates(&particles)
    }

    /// The places of a surface that is treated, each with the median over the members of its passes: what is as likely as
    /// not to be missing is missing. `None` where members disagree on where the places are.
    pub fn median_passes(&self) -> Option<ParticleDistribution> {
        let [first, others @ ..] = &self.replays[..] else {
            return None;
        };
        let is_alike = |other: &ParticleDistribution| {
            other.len() == first.len()
                && (0..first.len()).all(|i| other.position(i) == first.position(i))
        };
        if !others.iter().all(is_alike) {
            return None;
        }
        let passes: Vec<Vec<f64>> = (self.replays.iter())
            .map(|member| member.iter().map(|(_, fate)| fate.passes()).collect())
            .collect();
        let half = self.weights.iter().sum::<f64>() / 2.0;
        let median = |i: usize| {
            let mut at: Vec<(f64, f64)> = (passes.iter().zip(&self.weights))
                .map(|(member, weight)| (member[i], *weight))
                .collect();
            at.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut sum = 0.0;
            let found = at.iter().find(|(_, weight)| {
                sum += weight;
                sum >= half
            });
            found.map_or(0.0, |(passes, _)| *passes)
        };
        let places: Vec<_> = (0..first.len())
            .map(|i| (first.position(i), Fate::Treated { passes: median(i) }))
            .collect();
        ParticleDistribution::with_fates(&places).ok()
    }

    /// The dirt of several members, drawn by weight; of certainty just the one.
    ///
    /// ```
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let certain = Belief::certain(ParticleDistribution::default());
    /// assert_eq!(certain.members(8, 1).len(), 1);
    /// ```
    pub fn members(&self, count: usize, seed: u64) -> Vec<ParticleDistribution> {
        let count = if self.is_certain() { 1 } else { count };
        let chosen = self.systematic(count, seed).into_iter();
        chosen.map(|member| self.replays[member].clone()).collect()
    }

    /// Members drawn so that each comes as often as its weight says, give or take one (systematic resampling).
    pub(super) fn systematic(&self, count: usize, seed: u64) -> Vec<usize> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let begin: f64 = random.random();
        let place = |i: usize| (i as f64 + begin) / count as f64;
        (0..count).map(|i| self.at(place(i))).collect()
    }

    /// The member at a place in [0, 1) along the weights.
    fn at(&self, place: f64) -> usize {
        let mut sum = 0.0;
        let reached = self.weights.iter().position(|weight| {
            sum += weight;
            sum > place
        });
        reached.unwrap_or(self.weights.len() - 1)
    }

    /// How many particles remain where, over square cells of side `cell_size` [m].
    ///
    /// # Errors
    /// Cells so small that there are too many, or a side that is not above 0.
    pub fn density(&self, surface: &Surface, cell_size: f64) -> Result<DensityMap, InterpretError> {
        DensityMap::of(&self.replays, &self.weights, surface, cell_size)
    }
}
