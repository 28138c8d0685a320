//! What a plan is predicted to be worth, term by term.

/// The score of a plan, as the mean over all places where the dirt may lie. Every term is a share of the dirt [1], and the total
/// is the first less the others: wiping all of the surface once costs 0.01.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlanScore {
    /// What the terms add up to [1]: more is better.
    pub total: f64,
    /// The dirt that ends where it belongs [1].
    pub in_place: f64,
    /// The dirt that is lost over a wrong edge, three times [1].
    pub lost: f64,
    /// The dirt that is pushed so near to an edge, or to the rim of the goal, that part of the heap may go beyond it, by half [1].
    pub at_risk: f64,
    /// The dirt that does not end where it belongs, 0.3 times its distance from there over the diagonal of the surface [1].
    pub away: f64,
    /// The way in contact, lifts and turns [1].
    pub way: f64,
    /// The way in contact beyond [`PlanConfig::max_distance`](super::PlanConfig::max_distance), three for each metre [1].
    pub too_long: f64,
    /// The duration of the robot's motion, 0.01 for half a minute [1]; 0 of a plan that no robot follows.
    pub time: f64,
}

impl PlanScore {
    /// Share of the dirt that a second of motion costs [1/s]: half a minute, about as long as it takes to wipe a board once, costs
    /// one part in a hundred.
    const PER_SECOND: f64 = 3e-4;

    /// The same of a plan that a robot takes so long to follow [s].
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
