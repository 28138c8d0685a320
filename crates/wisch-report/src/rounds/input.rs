//! Rounds of planning, wiping and interpreting, as they are to be shown.

use wisch::interpret::Interpretation;
use wisch::plan::Plan;
use wisch::represent::{GoalState, ParticleDistribution, Performance, Task};

/// One round: what was planned, and what touch told of its execution.
#[derive(Debug, Clone, Copy)]
pub struct RoundView<'a> {
    /// Its number, counted from 1.
    pub number: usize,
    /// The strokes that were to be wiped; `None` of a log, which does not say it.
    pub plan: Option<&'a Plan>,
    /// Where the dirt was believed to lie when the plan was made.
    pub believed: &'a ParticleDistribution,
    /// The performance that the plan promised, in [0, 1]; not a number where there is no plan.
    pub predicted: f64,
    /// What the log says.
    pub interpretation: &'a Interpretation,
    /// Where the dirt lay after the round, and the performance by it in [0, 1]; `None` where nobody knows,
    /// as on a real robot.
    pub truth: Option<(&'a ParticleDistribution, f64)>,
    /// When something really pushed the tool: from, to [s].
    pub pushes: &'a [[f64; 2]],
}

/// All rounds of a task.
#[derive(Debug, Clone, Copy)]
pub struct RoundsInput<'a> {
    /// What was to be done.
    pub task: &'a Task,
    /// What the performance counts.
    pub goal: &'a GoalState,
    /// The performance that was wanted, in [0, 1].
    pub target: f64,
    /// The rounds in their order.
    pub rounds: &'a [RoundView<'a>],
}

impl<'a> RoundView<'a> {
    /// What makes up the belief after the round.
    pub(crate) fn replays(&self) -> &'a [ParticleDistribution] {
        self.interpretation.belief.replays()
    }

    /// The replay whose performance is nearest to the mean: one way in which it may be.
    pub(crate) fn typical(&self, input: &RoundsInput) -> &'a ParticleDistribution {
        let mean = self.interpretation.performance.mean;
        let off = |particles: &ParticleDistribution| {
            (Performance::of(particles, input.goal, &input.task.surface).ratio() - mean).abs()
        };
        let nearest = (self.replays().iter()).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(self.believed)
    }
}
