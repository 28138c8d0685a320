//! The predicted score of a plan, term by term. All plans are compared by it.

use super::edge_margin::EdgeMargin;
use crate::represent::{GoalState, ParticleDistribution, Performance, Surface};

/// Number of remaining particles that weigh as much as one lost particle: remaining dirt can be wiped again [1].
const LOSS: f64 = 3.0;
/// Number of particles in the goal that one particle right at an edge cancels; within the margin,
/// in proportion to its nearness [1]. Chosen on `failure-human-push`, seeds 101 to 130: with 1, or
/// if all particles within the margin count in full, more dirt is left on the surface and fewer
/// runs succeed.
const RISK: f64 = 0.5;

/// The terms of a [`PlanScore`] that the dirt contributes, for one possible distribution [particles].
#[derive(Debug, Clone, Copy)]
pub(super) struct DirtTerms {
    pub(super) in_place: f64,
    pub(super) lost: f64,
    pub(super) at_risk: f64,
    /// Distance of remaining dirt from the goal; only the search counts it.
    pub(super) away: f64,
}

impl DirtTerms {
    /// Returns the terms of the dirt `after` a plan. `margin`: the edges near which the plan pushed dirt, if it did.
    pub(super) fn evaluate(
        after: &ParticleDistribution,
        goal: &GoalState,
        surface: &Surface,
        margin: Option<&EdgeMargin>,
    ) -> Self {
        Self {
            at_risk: margin.map_or(0.0, |margin| {
                RISK * margin.nearness() + margin.beyond(goal, &surface.outline)
            }),
            ..Self::from(&Performance::evaluate(after, goal, surface))
        }
    }

    /// Sum of the terms [particles]: more is better.
    pub(super) fn total(&self) -> f64 {
        self.in_place - self.lost - self.at_risk - self.away
    }

    /// Sum of the terms, with the risk rounded to whole particles: plans that differ by less count as equal.
    pub(super) fn whole(&self) -> i64 {
        let at_risk = self.at_risk.round();
        Self { at_risk, ..*self }.total() as i64
    }
}

impl From<&Performance> for DirtTerms {
    /// The terms without a risk.
    fn from(performance: &Performance) -> Self {
        Self {
            in_place: performance.achieved as f64,
            lost: LOSS * performance.lost as f64,
            at_risk: 0.0,
            away: 0.0,
        }
    }
}

/// The score of a plan, as the mean over all possible distributions of the dirt.
///
/// Every term is a share of the dirt \[1\]. The total is `in_place` minus all other terms; the path
/// that wipes the whole surface once costs 0.01.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlanScore {
    /// Sum of the terms \[1\]: more is better.
    pub total: f64,
    /// Dirt that ends where it belongs \[1\].
    pub in_place: f64,
    /// Dirt that falls over a wrong edge, times 3 \[1\].
    pub lost: f64,
    /// Dirt of heaps pushed near a limit \[1\]: near an edge, 0.5 times how near it is; at the rim of the goal, the
    /// share of its heap that lies beyond.
    pub at_risk: f64,
    /// Dirt that ends elsewhere, times 0.3, times its distance from the goal over the diagonal of the surface
    /// \[1\].
    pub away: f64,
    /// Cost of the path in contact, of lifts and of turns \[1\].
    pub way: f64,
    /// Cost of the path in contact beyond [`PlanConfig::max_distance`](super::PlanConfig::max_distance), 3 per
    /// metre \[1\].
    pub too_long: f64,
    /// Cost of the duration of the robot's motion, 0.01 for about half a minute \[1\]; 0 for a plan without a
    /// robot.
    pub time: f64,
}

impl PlanScore {
    /// Share of the dirt that a second of motion costs [1/s]. Half a minute, about the time to wipe a board
    /// once, costs one part in a hundred.
    const PER_SECOND: f64 = 3e-4;

    /// Adds the terms of one possible distribution of the dirt. `weight`: of a particle in it [1].
    pub(super) fn add(&mut self, weight: f64, terms: &DirtTerms) {
        self.in_place += weight * terms.in_place;
        self.lost += weight * terms.lost;
        self.at_risk += weight * terms.at_risk;
        self.away += weight * terms.away;
    }

    /// Returns the score with the cost of a robot's motion of this duration \[s\].
    #[must_use]
    pub fn with_motion(self, duration: f64) -> Self {
        let time = Self::PER_SECOND * duration;
        Self {
            total: self.total - time,
            time,
            ..self
        }
    }
}
