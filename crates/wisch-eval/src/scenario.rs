//! Runs of a scenario over many seeds: true and estimated performance of their rounds.

use crate::simulated::{SimulatedWorld, format_error, read_robot};
use crate::trial::{BeliefScore, EvaluationError};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::path::Path;
use wisch::interpret::EventKind;
use wisch::recover::Verdict;
use wisch::represent::{GoalState, Performance, Task};
use wisch::run::Session;
use wisch_io::{LoadOptions, load_task};
use wisch_sim::Dirt;

/// Index of the level of the reported intervals in [`LEVELS`](crate::LEVELS).
const LEVEL_90: usize = 2;

/// A run of a scenario with one seed, in the simulated world that the scenario describes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScenarioRun {
    /// Name or path of the scenario, as typed.
    pub scenario: String,
    /// Seed of belief and world.
    pub seed: u64,
    /// Target performance.
    pub target: f64,
    /// True performance before wiping.
    pub before: f64,
    /// Rounds, in order.
    pub rounds: Vec<ScenarioRound>,
}

/// A round of a scenario run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScenarioRound {
    /// True performance.
    pub outcome: f64,
    /// Score of the estimate.
    pub belief: BeliefScore,
    /// Number of detected pushes.
    pub collisions: usize,
    /// The verdict as text.
    pub verdict: String,
    /// Whether the goal was claimed.
    pub is_claimed: bool,
}

impl ScenarioRun {
    /// Runs a shipped scenario or a task file with a seed, optionally with touch only and another maximum number of rounds.
    ///
    /// # Errors
    /// A message if a stage fails.
    pub fn evaluate(
        scenario: &str,
        seed: u64,
        rounds: Option<usize>,
        is_touch_only: bool,
    ) -> Result<Self, EvaluationError> {
        evaluate_run(scenario, seed, rounds, is_touch_only)
            .map_err(|message| EvaluationError { seed, message })
    }

    /// Returns the true performance after the last round.
    pub fn final_performance(&self) -> f64 {
        self.rounds
            .last()
            .map_or(self.before, |round| round.outcome)
    }

    /// Returns the share of the initially misplaced dirt that has reached the goal after a round (from 1); `None` without
    /// that round or without misplaced dirt.
    pub fn recovered_share(&self, round: usize) -> Option<f64> {
        let round = self.rounds.get(round.checked_sub(1)?)?;
        (self.before < 1.0).then(|| (round.outcome - self.before) / (1.0 - self.before))
    }
}

fn evaluate_run(
    scenario: &str,
    seed: u64,
    rounds: Option<usize>,
    is_touch_only: bool,
) -> Result<ScenarioRun, String> {
    let mut settings = Vec::new();
    if is_touch_only {
        settings.push(("perception.senses".to_owned(), r#"["touch"]"#.to_owned()));
    }
    let options = LoadOptions {
        settings,
        seed: Some(seed),
        ..LoadOptions::default()
    };
    let loaded = load_task(Path::new(scenario), &options).map_err(format_error)?;
    let robot = read_robot(&loaded)?;
    let SimulatedWorld { mut world, dirt } = SimulatedWorld::draw(&loaded)?;
    let task = &loaded.task;
    let mut config = loaded.run.clone();
    config.max_rounds = rounds.unwrap_or(config.max_rounds);
    let target = config.target;
    let session = Session::new(task, config).with_belief(loaded.belief());
    let mut session = session.with_robot(robot.robot_setup());
    session
        .run(&mut world, &mut |_| ControlFlow::Continue(()))
        .map_err(format_error)?;
    let first = session.rounds().first();
    let goal = first.ok_or("no round was executed")?.motion.plan.graph.goal;
    let scored = session
        .rounds()
        .iter()
        .zip(world.truth())
        .map(|(round, truth)| {
            let outcome = truth.performance(&goal, &round.motion.task.surface);
            let outcome = outcome.map_err(format_error)?.ok_or("there is no dirt")?;
            let events = round.interpretation.events.iter();
            Ok(ScenarioRound {
                outcome,
                belief: BeliefScore::evaluate(&round.interpretation.distribution, outcome),
                collisions: events.filter(|event| event.kind == EventKind::Push).count(),
                verdict: round.verdict.as_str().to_owned(),
                is_claimed: round.verdict == Verdict::GoalMet,
            })
        });
    Ok(ScenarioRun {
        scenario: scenario.to_owned(),
        seed,
        target,
        before: measure_performance_before(&dirt, &goal, task)?,
        rounds: scored.collect::<Result<_, String>>()?,
    })
}

/// Returns the performance before wiping.
fn measure_performance_before(dirt: &Dirt, goal: &GoalState, task: &Task) -> Result<f64, String> {
    let particles = dirt.particles().map_err(format_error)?;
    Ok(Performance::evaluate(&particles, goal, &task.surface).ratio())
}

/// Minimum, first quartile, median, third quartile and maximum of some values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Quartiles(pub [f64; 5]);

impl Quartiles {
    /// Computes the quartiles; `None` without values.
    ///
    /// ```
    /// use wisch_eval::Quartiles;
    /// assert_eq!(Quartiles::from_values(vec![4.0, 1.0, 3.0, 2.0, 5.0]), Some(Quartiles([1.0, 2.0, 3.0, 4.0, 5.0])));
    /// assert_eq!(Quartiles::from_values(vec![1.0, 2.0]).map(|of| of.0[2]), Some(1.5));
    /// assert_eq!(Quartiles::from_values(vec![]), None);
    /// ```
    pub fn from_values(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let at = |share: f64| {
            let place = share * last as f64;
            let (low, high) = (place.floor() as usize, place.ceil() as usize);
            values[low] + (values[high] - values[low]) * (place - low as f64)
        };
        Some(Self([0.0, 0.25, 0.5, 0.75, 1.0].map(at)))
    }
}

/// Statistics of the runs of one scenario.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScenarioScores {
    /// Name or path of the scenario, as typed.
    pub scenario: String,
    /// Number of runs, one per seed.
    pub runs: usize,
    /// Total number of rounds.
    pub rounds: usize,
    /// True performance after the first round.
    pub first: Option<Quartiles>,
    /// True performance after the last round.
    pub last: Option<Quartiles>,
    /// Share of the initially misplaced dirt that has reached the goal after the first round.
    #[serde(rename = "moved")]
    pub recovered: Option<Quartiles>,
    /// Number of rounds whose 90 % interval contains the true performance.
    #[serde(rename = "held")]
    pub covered: usize,
    /// Mean absolute error of the estimate; `None` without rounds.
    pub error: Option<f64>,
    /// Number of runs whose goal was met at the end.
    pub met: usize,
    /// Number of runs that claimed the goal.
    pub claimed: usize,
    /// Number of runs that claimed the goal more than 10 percentage points below the target.
    pub false_claims: usize,
    /// Number of detected pushes.
    pub collisions: usize,
}

impl ScenarioScores {
    /// Summarises the runs of one scenario.
    pub fn summarise(scenario: &str, runs: &[ScenarioRun]) -> Self {
        let rounds: Vec<&ScenarioRound> = runs.iter().flat_map(|run| &run.rounds).collect();
        let error = (rounds.iter()).map(|round| (round.belief.mean - round.outcome).abs());
        let claims = |run: &&ScenarioRun| run.rounds.last().is_some_and(|last| last.is_claimed);
        let first = runs.iter().filter_map(|run| run.rounds.first());
        Self {
            scenario: scenario.to_owned(),
            runs: runs.len(),
            rounds: rounds.len(),
            first: Quartiles::from_values(first.map(|round| round.outcome).collect()),
            last: Quartiles::from_values(runs.iter().map(ScenarioRun::final_performance).collect()),
            recovered: Quartiles::from_values(
                runs.iter()
                    .filter_map(|run| run.recovered_share(1))
                    .collect(),
            ),
            covered: (rounds.iter())
                .filter(|round| round.belief.holds(LEVEL_90, round.outcome))
                .count(),
            error: (!rounds.is_empty()).then(|| error.sum::<f64>() / rounds.len() as f64),
            met: runs
                .iter()
                .filter(|run| run.final_performance() >= run.target)
                .count(),
            claimed: runs.iter().filter(claims).count(),
            false_claims: (runs.iter().filter(claims))
                .filter(|run| run.final_performance() < run.target - 0.1)
                .count(),
            collisions: rounds.iter().map(|round| round.collisions).sum(),
        }
    }
}
