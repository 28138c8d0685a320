//! The predicted score of a plan, term by term.

/// The score of a plan, as the mean over all possible distributions of the dirt.
///
/// Every term is a share of the dirt \[1\]. The total is `in_place` less all other terms: wiping the whole
/// surface once costs 0.01.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlanScore {
    /// Sum of the terms \[1\]: more is better.
    pub total: f64,
    /// Dirt that ends where it belongs \[1\].
    pub in_place: f64,
    /// Dirt that falls over a wrong edge, times 3 \[1\].
    pub lost: f64,
    /// Dirt pushed so near an edge, or the rim of the goal, that part of the heap may go beyond it, times 0.5
    /// \[1\].
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
