//! Runs of a goal of several parts over many seeds: which parts were claimed, and which were really reached.

use crate::scenario::Quartiles;
use serde::{Deserialize, Serialize};

/// How far a true performance may lie below the target for a part to count as reached, in shares of the dirt.
const REACHED_WITHIN: f64 = 0.05;
/// How far it has to lie below the target for a claim to count as false.
const FALSE_BELOW: f64 = 0.1;

/// A run of a goal with one seed, in the simulated world that its task describes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GoalRunScore {
    /// Name or path of the task, as typed.
    pub task: String,
    /// Digest of the task's inputs.
    pub inputs: String,
    /// Seed of belief and world.
    pub seed: u64,
    /// The parts of the goal, in order.
    pub parts: Vec<GoalPartScore>,
    /// Expected time of all steps before the first one \[s\].
    pub expected_s: f64,
    /// Time of all steps \[s\].
    pub took_s: f64,
    /// Least time of any order of the steps that reached their goals, with the times that they took \[s\]; `None` if none is
    /// found.
    pub best_order_s: Option<f64>,
    /// Time to compute the order of the steps \[s\].
    pub ordering_s: f64,
}

/// A part of the goal after a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GoalPartScore {
    /// The part, as in PDDL.
    pub part: String,
    /// Whether the run claims that it holds.
    pub is_claimed: bool,
    /// Why the run does not claim it; `None` if it does.
    pub reason: Option<String>,
    /// Target performance of its last wiping step; `None` if no step served it.
    pub target: Option<f64>,
    /// Estimated performance after that step.
    pub estimated: Option<f64>,
    /// True performance after that step.
    pub truth: Option<f64>,
}

impl GoalPartScore {
    /// Whether the true performance is at most 5 percentage points below the target.
    pub fn is_reached(&self) -> bool {
        self.is_within(REACHED_WITHIN)
    }

    /// Whether the part is claimed with a true performance of more than 10 percentage points below the target.
    pub fn is_claimed_falsely(&self) -> bool {
        self.is_claimed && !self.is_within(FALSE_BELOW)
    }

    fn is_within(&self, below: f64) -> bool {
        // 1e-9 is far above rounding and far below one particle of any task.
        (self.truth.zip(self.target)).is_some_and(|(truth, target)| truth >= target - below - 1e-9)
    }
}

/// Statistics of the runs of one goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoalScores {
    /// Name or path of the task, as typed.
    pub task: String,
    /// Number of runs, one per seed.
    pub runs: usize,
    /// Number of runs whose parts were all reached, within 5 percentage points of their targets.
    pub reached: usize,
    /// Number of runs that claimed all parts.
    pub claimed: usize,
    /// Number of runs that claimed a part more than 10 percentage points below its target.
    pub false_claims: usize,
    /// The parts of the goal, in order.
    pub parts: Vec<GoalPartScores>,
    /// Time of all steps \[s\].
    pub took_s: Option<Quartiles>,
    /// Time of all steps, as a multiple of the time that was expected before the first one.
    pub of_expected: Option<Quartiles>,
    /// Time of all steps, as a multiple of [`GoalRunScore::best_order_s`].
    pub of_best_order: Option<Quartiles>,
    /// Time to compute the order of the steps \[s\].
    pub ordering_s: Option<Quartiles>,
}

/// Statistics of one part of a goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoalPartScores {
    /// The part, as in PDDL.
    pub part: String,
    /// Number of runs that reached it, within 5 percentage points of its target.
    pub reached: usize,
    /// Number of runs that claimed it.
    pub claimed: usize,
    /// Number of runs that claimed it more than 10 percentage points below its target.
    pub false_claims: usize,
    /// True performance after the last step that served it.
    pub truth: Option<Quartiles>,
}

impl GoalScores {
    /// Summarises the runs of one task.
    ///
    /// ```
    /// use wisch_eval::{GoalPartScore, GoalRunScore, GoalScores};
    /// let part = |truth| GoalPartScore {
    ///     part: "(absorbed water table)".into(),
    ///     is_claimed: true,
    ///     reason: None,
    ///     target: Some(0.9),
    ///     estimated: Some(0.95),
    ///     truth: Some(truth),
    /// };
    /// let run = |seed, truth| GoalRunScore {
    ///     task: "kitchen".into(),
    ///     inputs: String::new(),
    ///     seed,
    ///     parts: vec![part(truth)],
    ///     expected_s: 100.0,
    ///     took_s: 120.0,
    ///     best_order_s: Some(120.0),
    ///     ordering_s: 0.01,
    /// };
    /// let scores = GoalScores::summarise("kitchen", &[run(1, 0.85), run(2, 0.79)]);
    /// assert_eq!((scores.reached, scores.claimed, scores.false_claims), (1, 2, 1));
    /// ```
    pub fn summarise(task: &str, runs: &[GoalRunScore]) -> Self {
        let of_all = |value: &dyn Fn(&GoalRunScore) -> Option<f64>| {
            Quartiles::from_values(runs.iter().filter_map(value).collect())
        };
        let count =
            |holds: &dyn Fn(&GoalRunScore) -> bool| runs.iter().filter(|run| holds(run)).count();
        let parts = runs.first().map_or(0, |run| run.parts.len());
        Self {
            task: task.to_owned(),
            runs: runs.len(),
            reached: count(&|run| run.parts.iter().all(GoalPartScore::is_reached)),
            claimed: count(&|run| run.parts.iter().all(|part| part.is_claimed)),
            false_claims: count(&|run| run.parts.iter().any(GoalPartScore::is_claimed_falsely)),
            parts: (0..parts).map(|at| summarise_part(runs, at)).collect(),
            took_s: of_all(&|run| Some(run.took_s)),
            of_expected: of_all(&|run| Some(run.took_s / run.expected_s)),
            of_best_order: of_all(&|run| Some(run.took_s / run.best_order_s?)),
            ordering_s: of_all(&|run| Some(run.ordering_s)),
        }
    }
}

fn summarise_part(runs: &[GoalRunScore], at: usize) -> GoalPartScores {
    let own: Vec<&GoalPartScore> = runs.iter().filter_map(|run| run.parts.get(at)).collect();
    let count =
        |holds: &dyn Fn(&GoalPartScore) -> bool| own.iter().filter(|part| holds(part)).count();
    GoalPartScores {
        part: own
            .first()
            .map_or_else(String::new, |part| part.part.clone()),
        reached: count(&GoalPartScore::is_reached),
        claimed: count(&|part| part.is_claimed),
        false_claims: count(&GoalPartScore::is_claimed_falsely),
        truth: Quartiles::from_values(own.iter().filter_map(|part| part.truth).collect()),
    }
}
