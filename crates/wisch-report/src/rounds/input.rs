//! Input of the figures of rounds.

use wisch::interpret::Interpretation;
use wisch::plan::Plan;
use wisch::represent::{GoalState, ParticleDistribution, Performance, Task};

/// A round for figures: its plan and the interpretation of its execution.
#[derive(Debug, Clone, Copy)]
pub struct RoundView<'a> {
    /// Number of the round, from 1.
    pub number: usize,
    /// The plan; `None` for a log, which has no plan.
    pub plan: Option<&'a Plan>,
    /// Believed dirt when the plan was made.
    pub believed: &'a ParticleDistribution,
    /// Predicted performance of the plan, in [0, 1]; NaN without a plan.
    pub predicted: f64,
    /// Interpretation of the log.
    pub interpretation: &'a Interpretation,
    /// True dirt and true performance in [0, 1] after the round; `None` without ground truth, as on a real robot.
    pub truth: Option<(&'a ParticleDistribution, f64)>,
    /// Times of true pushes: start, end \[s\].
    pub pushes: &'a [[f64; 2]],
}

/// All rounds of a task, for the figures of a report.
#[derive(Debug, Clone, Copy)]
pub struct RoundsInput<'a> {
    /// The task.
    pub task: &'a Task,
    /// The goal.
    pub goal: &'a GoalState,
    /// Target performance, in [0, 1].
    pub target: f64,
    /// The rounds, in order.
    pub rounds: &'a [RoundView<'a>],
}

impl<'a> RoundView<'a> {
    /// Returns the members that form the belief after the round.
    pub(crate) fn members(&self) -> &'a [ParticleDistribution] {
        self.interpretation.belief.members()
    }

    /// Returns the replay whose performance is nearest to the mean estimate, as a typical particle distribution.
    pub(crate) fn typical_replay(&self, input: &RoundsInput) -> &'a ParticleDistribution {
        let mean = self.interpretation.performance.mean;
        let off = |particles: &ParticleDistribution| {
            (Performance::evaluate(particles, input.goal, &input.task.surface).ratio() - mean).abs()
        };
        let nearest = (self.members().iter()).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(self.believed)
    }
}
