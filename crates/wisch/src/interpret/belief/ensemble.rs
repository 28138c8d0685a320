//! The robot's belief about the dirt: an ensemble of possible worlds, each with its own dirt and parameters.

use super::activation::Activation;
use super::density::DensityMap;
use super::parameter_sampling::MemberParameters;
use super::performance::PerformanceDistribution;
use crate::interpret::contact::StiffnessBelief;
use crate::interpret::error::InterpretError;
use crate::represent::{Fate, GoalState, ParticleDistribution, ParticleError, Surface};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// A weighted ensemble of possible worlds. Each member has its own number and places of particles. From the first log
/// on it also has its own parameters, which it keeps.
///
/// ```
/// use wisch::geometry::Point2;
/// use wisch::interpret::Belief;
/// use wisch::represent::ParticleDistribution;
/// let crumbs = ParticleDistribution::new(&[Point2::new(0.1, 0.0), Point2::new(0.2, 0.0)])?;
/// let known = Belief::from_particles(crumbs.clone());
/// assert!(known.is_certain());
/// let uncertain = Belief::from_members(vec![crumbs, ParticleDistribution::default()])?;
/// assert_eq!(uncertain.weights(), [0.5, 0.5]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    members: Vec<ParticleDistribution>,
    /// Weights of the members; they sum to 1.
    weights: Vec<f64>,
    /// Parameters and thresholds of each member; empty before the first log.
    pub(super) states: Vec<MemberState>,
    /// Belief about the tool's stiffness after the logs so far; `None` before the first.
    stiffness: Option<StiffnessBelief>,
    /// Whether a camera has detected dirt in an earlier observation.
    pub(in crate::interpret) was_seen: bool,
    /// Number of grains of each member on the surface before the last log; empty without a log since the last observation.
    before: Vec<usize>,
}

/// Parameters and thresholds of a member.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MemberState {
    pub(super) parameters: MemberParameters,
    pub(super) activation: Activation,
}

impl Belief {
    /// Returns the belief of a single member, whose dirt is known.
    pub fn from_particles(particles: ParticleDistribution) -> Self {
        Self {
            members: vec![particles],
            weights: vec![1.0],
            states: Vec::new(),
            stiffness: None,
            was_seen: false,
            before: Vec::new(),
        }
    }

    /// Returns a belief of members of equal weight.
    ///
    /// # Errors
    /// An empty list of members.
    pub fn from_members(members: Vec<ParticleDistribution>) -> Result<Self, InterpretError> {
        if members.is_empty() {
            return Err(InterpretError::NoMembers);
        }
        Ok(Self::ensemble(members))
    }

    /// Returns a belief of members of equal weight; `members` must not be empty.
    pub(super) fn ensemble(members: Vec<ParticleDistribution>) -> Self {
        let weights = vec![1.0 / members.len() as f64; members.len()];
        Self {
            members,
            weights,
            states: Vec::new(),
            stiffness: None,
            was_seen: false,
            before: Vec::new(),
        }
    }

    /// Returns the belief after a log: its members with their states, weights and stiffness. `before`: number of grains of
    /// each member on the surface before the log.
    pub(super) fn continue_with(
        members: Vec<(ParticleDistribution, MemberState)>,
        before: Vec<usize>,
        weights: Vec<f64>,
        stiffness: StiffnessBelief,
        was_seen: bool,
    ) -> Self {
        let (members, states) = members.into_iter().unzip();
        Self {
            members,
            weights,
            states,
            stiffness: Some(stiffness),
            was_seen,
            before,
        }
    }

    /// Returns the same belief with another value of `was_seen`: whether a camera has detected
    /// dirt.
    pub(super) fn with_seen(self, was_seen: bool) -> Self {
        Self { was_seen, ..self }
    }

    /// Returns the same members with new weights.
    pub(super) fn with_weights(&self, weights: Vec<f64>) -> Self {
        Self {
            weights,
            ..self.clone()
        }
    }

    /// Number of a member's grains on the surface before the last log; all of its grains without a log since the last
    /// observation.
    pub(super) fn count_before(&self, member: usize) -> usize {
        let all = || self.members[member].len();
        self.before.get(member).copied().unwrap_or_else(all)
    }

    /// Belief about the tool's stiffness after the logs so far.
    pub(in crate::interpret) fn stiffness(&self) -> Option<StiffnessBelief> {
        self.stiffness
    }

    /// Returns the belief after an observation; it keeps the states only if every member has one.
    pub(super) fn with_observed(
        &self,
        members: Vec<(ParticleDistribution, Option<MemberState>)>,
        weights: Vec<f64>,
        was_seen: bool,
    ) -> Self {
        let (members, states): (Vec<_>, Vec<_>) = members.into_iter().unzip();
        Self {
            members,
            weights,
            states: states
                .into_iter()
                .collect::<Option<_>>()
                .unwrap_or_default(),
            stiffness: self.stiffness,
            was_seen,
            before: Vec::new(),
        }
    }

    /// Dirt of each member; at least one.
    pub fn members(&self) -> &[ParticleDistribution] {
        &self.members
    }

    /// Weights of the members; they sum to 1.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Whether there is a single member, whose dirt counts as known.
    pub fn is_certain(&self) -> bool {
        self.members.len() == 1
    }

    /// Effective number of members: the inverse of the sum of the squared weights (Kish).
    pub fn effective_members(&self) -> f64 {
        let squares: f64 = self.weights.iter().map(|weight| weight * weight).sum();
        1.0 / squares
    }

    /// Returns the distribution of the performance; `deviation` is the standard deviation of the model error \[1\].
    pub fn performance(
        &self,
        goal: &GoalState,
        surface: &Surface,
        deviation: f64,
    ) -> PerformanceDistribution {
        PerformanceDistribution::of(&self.members, &self.weights, goal, surface, deviation)
    }

    /// Resamples `count` members of equal weight, at least one. Each member occurs as often as its weight says, rounded
    /// up or down.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let at = |x| ParticleDistribution::new(&[Point2::new(x, 0.0)]);
    /// let belief = Belief::from_members(vec![at(0.1)?, at(0.2)?, at(0.3)?, at(0.4)?])?;
    /// assert_eq!(belief.resample(2, 1).members().len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn resample(&self, count: usize, seed: u64) -> Self {
        let kept = self.systematic(count.max(1), seed);
        let weights = vec![1.0 / kept.len() as f64; kept.len()];
        let states = self.states.iter().collect::<Vec<_>>();
        Self {
            members: kept.iter().map(|&i| self.members[i].clone()).collect(),
            weights,
            states: (kept.iter())
                .filter_map(|&i| states.get(i).map(|&state| state.clone()))
                .collect(),
            stiffness: self.stiffness,
            was_seen: self.was_seen,
            before: Vec::new(),
        }
    }

    /// Returns the dirt of one member, drawn by weight.
    ///
    /// # Errors
    /// None: the dirt of the members is always finite.
    pub fn sample(&self, seed: u64) -> Result<ParticleDistribution, ParticleError> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        Ok(self.members[self.at(random.random())].clone())
    }

    /// Returns the dirt of `count` members, drawn by weight, in one distribution. It represents all
    /// possible dirt, for plans that are good on average. A single member, in contrast, has dirt in
    /// some clean places and none in some dirty ones.
    ///
    /// # Errors
    /// More than [`MAX_PARTICLES`](crate::represent::MAX_PARTICLES) particles in total.
    ///
    /// ```
    /// use wisch::geometry::Point2;
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let [here, there] = [0.0, 0.1].map(|x| ParticleDistribution::new(&[Point2::new(x, 0.0)]).unwrap());
    /// let belief = Belief::from_members(vec![here, there])?;
    /// let draws = belief.draw_mixture(1000, 7)?;
    /// let share_here = draws.remaining().filter(|place| place.x < 0.05).count() as f64 / 1000.0;
    /// assert!((share_here - 0.5).abs() < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn draw_mixture(
        &self,
        count: usize,
        seed: u64,
    ) -> Result<ParticleDistribution, ParticleError> {
        let members = self.draw_members(count, seed);
        let particles: Vec<_> = members.iter().flat_map(|dirt| dirt.iter()).collect();
        ParticleDistribution::with_fates(&particles)
    }

    /// Returns the places of a treated surface, each with the weighted median of its passes over the members. A place
    /// that at least half of the weight calls untreated is untreated. `None` if the members have different places.
    pub fn median_passes(&self) -> Option<ParticleDistribution> {
        let [first, others @ ..] = &self.members[..] else {
            return None;
        };
        let is_alike = |other: &ParticleDistribution| {
            other.len() == first.len()
                && (0..first.len()).all(|i| other.position(i) == first.position(i))
        };
        if !others.iter().all(is_alike) {
            return None;
        }
        let passes: Vec<Vec<f64>> = (self.members.iter())
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

    /// Returns the dirt of `count` members, drawn by weight; a certain belief returns its single member.
    ///
    /// ```
    /// use wisch::interpret::Belief;
    /// use wisch::represent::ParticleDistribution;
    /// let certain = Belief::from_particles(ParticleDistribution::default());
    /// assert_eq!(certain.draw_members(8, 1).len(), 1);
    /// ```
    pub fn draw_members(&self, count: usize, seed: u64) -> Vec<ParticleDistribution> {
        let count = if self.is_certain() { 1 } else { count };
        let chosen = self.systematic(count, seed).into_iter();
        chosen.map(|member| self.members[member].clone()).collect()
    }

    /// Draws member indices by systematic resampling: each member occurs as often as its weight says, rounded up or
    /// down.
    pub(super) fn systematic(&self, count: usize, seed: u64) -> Vec<usize> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let begin: f64 = random.random();
        let place = |i: usize| (i as f64 + begin) / count as f64;
        (0..count).map(|i| self.at(place(i))).collect()
    }

    /// Returns the index of the member at a position in [0, 1) along the cumulative weights.
    fn at(&self, place: f64) -> usize {
        let mut sum = 0.0;
        let reached = self.weights.iter().position(|weight| {
            sum += weight;
            sum > place
        });
        reached.unwrap_or(self.weights.len() - 1)
    }

    /// Returns the expected number of remaining particles per square cell of side `cell_size` \[m\].
    ///
    /// # Errors
    /// [`InterpretError::Cells`] for a side that is not above 0, or for cells so small that their
    /// number exceeds the limit.
    pub fn density(&self, surface: &Surface, cell_size: f64) -> Result<DensityMap, InterpretError> {
        DensityMap::of(&self.members, &self.weights, surface, cell_size)
    }
}
