//! A scenario over many seeds: how its rounds end, and what is believed of them.

use crate::simulated::{SimulatedWorld, robot_of, words};
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

/// The level of the intervals that are looked at, among [`LEVELS`](crate::LEVELS).
const LEVEL_90: usize = 2;

/// A scenario with one seed, wiped in the world that it describes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScenarioRun {
    /// As it was asked for.
    pub scenario: String,
    /// The seed of belief and world.
    pub seed: u64,
    /// The performance that was to be reached.
    pub target: f64,
    /// What was so before anything was wiped.
    pub before: f64,
    /// Rounds, in order.
    pub rounds: Vec<ScenarioRound>,
}

/// One round of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScenarioRound {
    /// What was so.
    pub outcome: f64,
    /// What was believed.
    pub belief: BeliefScore,
    /// Pushes that were told.
    pub collisions: usize,
    /// The verdict in words.
    pub verdict: String,
    /// Whether the goal was claimed.
    pub is_claimed: bool,
}

impl ScenarioRun {
    /// Wipes a shipped scenario, or a task file, with a seed; by touch alone if told so, in so many rounds at most.
    ///
    /// # Errors
    /// What a stage refuses, in words.
    pub fn evaluate(
        scenario: &str,
        seed: u64,
        rounds: Option<usize>,
        is_touch_only: bool,
    ) -> Result<Self, EvaluationError> {
        evaluated(scenario, seed, rounds, is_touch_only)
            .map_err(|message| EvaluationError { seed, message })
    }

    /// What was so after the last round.
    pub fn after(&self) -> f64 {
        self.rounds
            .last()
            .map_or(self.before, |round| round.outcome)
    }

    /// Of what was not where it belongs at first, the share that was after a round, from 1; `None` without such a round,
    /// or if nothing was to be done.
    pub fn moved(&self, round: usize) -> Option<f64> {
        let round = self.rounds.get(round.checked_sub(1)?)?;
        (self.before < 1.0).then(|| (round.outcome - self.before) / (1.0 - self.before))
    }
}

fn evaluated(
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
    let loaded = load_task(Path::new(scenario), &options).map_err(words)?;
    let robot = robot_of(&loaded)?;
    let SimulatedWorld { mut world, dirt } = SimulatedWorld::of(&loaded)?;
    let task = &loaded.task;
    let mut config = loaded.run_config();
    config.max_rounds = rounds.unwrap_or(config.max_rounds);
    let target = config.target;
    let session = Session::new(task, config).with_belief(loaded.belief());
    let mut session = session.with_robot(robot.performer());
    session
        .run(&mut world, &mut |_| ControlFlow::Continue(()))
        .map_err(words)?;
    let first = session.rounds().first();
    let goal = first.ok_or("no round was executed")?.motion.plan.graph.goal;
    let scored = session
        .rounds()
        .iter()
        .zip(world.truth())
        .map(|(round, truth)| {
            let outcome = truth.performance(&goal, &round.motion.task.surface);
            let outcome = outcome.map_err(words)?.ok_or("there is no dirt")?;
            let events = round.interpretation.events.iter();
            Ok(ScenarioRound {
                outcome,
                belief: BeliefScore::of(&round.interpretation.distribution, outcome),
                collisions: events
                    .filter(|event| event.kind == EventKind::Collision)
                    .count(),
                verdict: round.verdict.as_str().to_owned(),
                is_claimed: round.verdict == Verdict::GoalMet,
            })
        });
    Ok(ScenarioRun {
        scenario: scenario.to_owned(),
        seed,
        target,
        before: before(&dirt, &goal, task)?,
        rounds: scored.collect::<Result<_, String>>()?,
    })
}

/// The performance before anything is wiped.
fn before(dirt: &Dirt, goal: &GoalState, task: &Task) -> Result<f64, String> {
    let particles = dirt.particles().map_err(words)?;
    Ok(Performance::of(&particles, goal, &task.surface).ratio())
}

/// Least, first quartile, median, third quartile and greatest of some values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Quartiles(pub [f64; 5]);

impl Quartiles {
    /// Of these values; `None` of none.
    ///
    /// ```
    /// use wisch_eval::Quartiles;
    /// assert_eq!(Quartiles::of(vec![4.0, 1.0, 3.0, 2.0, 5.0]), Some(Quartiles([1.0, 2.0, 3.0, 4.0, 5.0])));
    /// assert_eq!(Quartiles::of(vec![1.0, 2.0]).map(|of| of.median()), Some(1.5));
    /// assert_eq!(Quartiles::of(vec![]), None);
    /// ```
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let at = |share: f64| {
            let place = share * last as f64;
            let (low, high) = (place.floor() as usize, place.ceil() as usize);
            values[low] + (values[high] - values[low]) * (place - low as f64)
        };
        Some(Self([0.0, 0.25, 0.5, 0.75, 1.0].map(at)))
    }

    /// The one in the middle.
    pub const fn median(&self) -> f64 {
        self.0[2]
    }
}

/// A scenario's runs together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScenarioScores {
    /// As it was asked for.
    pub scenario: String,
    /// How many seeds, and rounds of all of them.
    pub runs: usize,
    /// How many rounds.
    pub rounds: usize,
    /// What was so after the first round, and after the last.
    pub first: Option<Quartiles>,
    /// After the last.
    pub last: Option<Quartiles>,
    /// Of what was not where it belongs at first, the share that was after the first round.
    pub moved: Option<Quartiles>,
    /// Rounds whose 90 % interval holds what was so.
    pub held: usize,
    /// Mean distance of the estimate from what was so.
    pub error: f64,
    /// Runs that ended with the goal met, with the goal claimed, and with it claimed falsely by more than 10 points.
    pub met: usize,
    /// Claimed.
    pub claimed: usize,
    /// Claimed falsely.
    pub false_claims: usize,
    /// Pushes that were told.
    pub collisions: usize,
}

impl ScenarioScores {
    /// Of a scenario's runs.
    pub fn of(scenario: &str, runs: &[ScenarioRun]) -> Self {
        let rounds: Vec<&ScenarioRound> = runs.iter().flat_map(|run| &run.rounds).collect();
        let error = (rounds.iter()).map(|round| (round.belief.mean - round.outcome).abs());
        let claims = |run: &&ScenarioRun| run.rounds.last().is_some_and(|last| last.is_claimed);
        let first = runs.iter().filter_map(|run| run.rounds.first());
        Self {
            scenario: scenario.to_owned(),
            runs: runs.len(),
            rounds: rounds.len(),
            first: Quartiles::of(first.map(|round| round.outcome).collect()),
            last: Quartiles::of(runs.iter().map(ScenarioRun::after).collect()),
            moved: Quartiles::of(runs.iter().filter_map(|run| run.moved(1)).collect()),
            held: (rounds.iter())
                .filter(|round| round.belief.holds(LEVEL_90, round.outcome))
                .count(),
            error: error.sum::<f64>() / rounds.len().max(1) as f64,
            met: runs.iter().filter(|run| run.after() >= run.target).count(),
            claimed: runs.iter().filter(claims).count(),
            false_claims: (runs.iter().filter(claims))
                .filter(|run| run.after() < run.target - 0.1)
                .count(),
            collisions: rounds.iter().map(|round| round.collisions).sum(),
        }
    }
}
