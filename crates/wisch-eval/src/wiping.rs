//! Scores of a task that is planned, followed or executed once.

use crate::picture::Picture;
use crate::simulated::{SimulatedWorld, format_error, read_robot};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::time::Instant;
use wisch::follow::Audit;
use wisch::plan::{Plan, plan, predict};
use wisch::recover::Verdict;
use wisch::represent::{ParticleDistribution, Performance, Task};
use wisch::run::{NoExecutor, PlannedRound, RunConfig, Session, Stage, ignore_events};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::GroundTruth;

/// The last stage to which a task is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WipingExtent {
    /// Planned and predicted, without a robot.
    Planned,
    /// Followed by the task's robot, and predicted for what it wipes.
    Followed,
    /// Executed round by round in the simulated world of the task, until the termination policy ends the run.
    Executed,
}

impl WipingExtent {
    /// Name of the extent in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Planned => "planned without a robot",
            Self::Followed => "followed by the robot",
            Self::Executed => "executed in the simulated world",
        }
    }
}

/// Settings of a wiping run, beside those of its task.
#[derive(Debug, Clone, Copy)]
pub struct WipingOptions {
    /// Last stage.
    pub extent: WipingExtent,
    /// Whether to plan as if the dirt's positions were known exactly, as in the paper's Table 1. Executed runs always plan
    /// for the belief.
    pub is_certain: bool,
    /// Also evaluate a plan whose path in contact is at most this long \[m\].
    pub limit: Option<f64>,
    /// Whether to keep the data of a picture.
    pub is_pictured: bool,
}

/// The score of one run of a task. All values but the computation time are the same on any machine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WipingScore {
    /// Strategy of the first plan; with `best`, that of the chosen plan.
    pub strategy: String,
    /// Nodes of the first plan.
    pub nodes: usize,
    /// Number of lifts of the tool, one at the end of each stroke; over all executed rounds.
    pub lifts: usize,
    /// Path length in contact \[m\]; over all executed rounds.
    pub distance_m: f64,
    /// Share of the particles that no tool pose covers \[1\].
    pub out_of_reach: f64,
    /// Predicted performance of the whole plan, as if no node were abandoned \[1\].
    pub planned: f64,
    /// Predicted performance; with a robot, of the motion of the first round \[1\].
    pub predicted: f64,
    /// Predicted share of particles lost over an edge that is not a skim edge \[1\].
    pub predicted_loss: f64,
    /// Predicted performance of the plan with limited path length \[1\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limited: Option<f64>,
    /// The robot's motion of the first round.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionScore>,
    /// The executed rounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub execution: Option<ExecutionScore>,
    /// Wall time of planning and, with a robot, following the first round on one core \[s\].
    pub computation_s: f64,
    /// Data of a picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<Picture>,
}

/// The score of a robot's planned motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MotionScore {
    /// Number of abandoned nodes.
    pub abandoned: usize,
    /// Number of base poses.
    pub placements: usize,
    /// Duration of the motion \[s\].
    pub duration_s: f64,
    /// Duration of contact \[s\].
    pub contact_s: f64,
    /// Number of faults of the motion.
    pub faults: usize,
}

/// The score of the executed rounds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ExecutionScore {
    /// Number of rounds.
    pub rounds: usize,
    /// Total duration in simulated time \[s\].
    pub duration_s: f64,
    /// True performance before wiping \[1\].
    pub before: f64,
    /// True performance after the first round \[1\].
    pub first: f64,
    /// True performance at the end \[1\].
    pub truth: f64,
    /// True share of dirt lost over an edge that is not a skim edge \[1\].
    pub loss: f64,
    /// Estimated performance at the end \[1\].
    pub estimated: f64,
    /// Lower end of its 90 % interval \[1\].
    pub low: f64,
    /// Upper end of its 90 % interval \[1\].
    pub high: f64,
    /// The last verdict as text.
    pub verdict: String,
    /// Whether the goal was claimed.
    pub is_claimed: bool,
}

impl WipingScore {
    /// Execution time \[s\]: measured, or that of the planned motion; `None` without a robot.
    pub fn execution_s(&self) -> Option<f64> {
        let executed = self
            .execution
            .as_ref()
            .map(|execution| execution.duration_s);
        executed.or(self.motion.map(|motion| motion.duration_s))
    }

    /// Counts the runs that claimed the goal; `None` without execution.
    pub(crate) fn count_claimed(runs: &[&Self]) -> Option<usize> {
        let executed: Vec<&ExecutionScore> = (runs.iter())
            .filter_map(|score| score.execution.as_ref())
            .collect();
        let claimed = executed.iter().filter(|execution| execution.is_claimed);
        (!executed.is_empty()).then(|| claimed.count())
    }

    /// Runs a shipped scenario or a task file.
    ///
    /// # Errors
    /// A message if a stage fails.
    pub fn evaluate(
        scenario: &Path,
        load: &LoadOptions,
        options: WipingOptions,
    ) -> Result<Self, String> {
        let loaded = load_task(scenario, load).map_err(format_error)?;
        let mut score = match options.extent {
            WipingExtent::Planned => score_planned(&loaded, options)?,
            WipingExtent::Followed => score_followed(&loaded, options)?,
            WipingExtent::Executed => score_executed(&loaded, options)?,
        };
        if let Some(limit) = options.limit {
            let mut config = loaded.run.plan.clone();
            config.max_distance = Some(config.max_distance.map_or(limit, |most| most.min(limit)));
            let plan = plan(&loaded.task, &config).map_err(format_error)?;
            score.limited = Some(predict(&loaded.task, &plan, |_| ()).performance.ratio());
        }
        Ok(score)
    }

    /// Makes the score of a plan. `wiped`: the plan without abandoned nodes.
    fn from_prediction(task: &Task, plan: &Plan, wiped: &Plan, computation_s: f64) -> Self {
        let performance = predict(task, wiped, |_| ()).performance;
        Self {
            strategy: plan.strategy.to_string(),
            nodes: plan.graph.nodes.len(),
            lifts: wiped.strokes.len(),
            distance_m: wiped.contact_distance(),
            out_of_reach: plan.unreachable_share,
            planned: predict(task, plan, |_| ()).performance.ratio(),
            predicted: performance.ratio(),
            predicted_loss: find_lost_share(&performance),
            limited: None,
            motion: None,
            execution: None,
            computation_s,
            picture: None,
        }
    }
}

fn score_planned(loaded: &LoadedTask, options: WipingOptions) -> Result<WipingScore, String> {
    let task = &loaded.task;
    let begin = Instant::now();
    let mut session = create_session(loaded, options.is_certain);
    (session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events))
        .map_err(format_error)?;
    let computation_s = begin.elapsed().as_secs_f64();
    let plan = session.plan().ok_or("no plan was made")?;
    let mut score = WipingScore::from_prediction(task, plan, plan, computation_s);
    if options.is_pictured {
        let after = predict(task, plan, |_| ()).particles;
        score.picture = Some(Picture::new(task, plan, &task.particles, &after));
    }
    Ok(score)
}

fn score_followed(loaded: &LoadedTask, options: WipingOptions) -> Result<WipingScore, String> {
    let robot = read_robot(loaded)?;
    let begin = Instant::now();
    let mut session = create_session(loaded, options.is_certain).with_robot(robot.robot_setup());
    let mut none = NoExecutor;
    (session.run_until(Stage::Followed, &mut none, &mut ignore_events)).map_err(format_error)?;
    let computation_s = begin.elapsed().as_secs_f64();
    (session.run_until(Stage::Audited, &mut none, &mut ignore_events)).map_err(format_error)?;
    let (first, audit) = session.first_motion().ok_or("no motion was made")?;
    let mut score = score_first_round(first, audit, computation_s);
    if options.is_pictured {
        let (task, wiped) = (&first.task, first.executable_plan());
        let after = &first.prediction.particles;
        score.picture = Some(Picture::new(task, &wiped, &task.particles, after));
    }
    Ok(score)
}

fn score_executed(loaded: &LoadedTask, options: WipingOptions) -> Result<WipingScore, String> {
    let robot = read_robot(loaded)?;
    let SimulatedWorld { mut world, dirt } = SimulatedWorld::draw(loaded)?;
    let begin = Instant::now();
    let mut session = create_session(loaded, false).with_robot(robot.robot_setup());
    (session.run_until(Stage::Followed, &mut world, &mut ignore_events)).map_err(format_error)?;
    let computation_s = begin.elapsed().as_secs_f64();
    session
        .run(&mut world, &mut ignore_events)
        .map_err(format_error)?;
    let (first, audit) = session.first_motion().ok_or("no motion was made")?;
    let (goal, surface) = (first.plan.graph.goal, &first.task.surface);
    let before = dirt.particles().map_err(format_error)?;
    let performance =
        |particles: &ParticleDistribution| Performance::evaluate(particles, &goal, surface);
    let truths = world.truth().iter().map(GroundTruth::particles);
    let truths: Vec<ParticleDistribution> = truths
        .filter_map(Result::transpose)
        .collect::<Result<_, _>>()
        .map_err(format_error)?;
    // A motion that fails its check is not executed and has no effect.
    let after = truths.last().unwrap_or(&before);
    let rounds = session.rounds();
    let last = rounds
        .last()
        .ok_or("no round was executed: the audit found faults")?;
    let estimate = last.interpretation.performance;
    let end = performance(after);
    let mut score = score_first_round(first, audit, computation_s);
    score.execution = Some(ExecutionScore {
        rounds: rounds.len(),
        duration_s: rounds.iter().map(|round| round.execution.duration).sum(),
        before: performance(&before).ratio(),
        first: performance(truths.first().unwrap_or(&before)).ratio(),
        truth: end.ratio(),
        loss: find_lost_share(&end),
        estimated: estimate.mean,
        low: estimate.low,
        high: estimate.high,
        verdict: last.verdict.as_str().to_owned(),
        is_claimed: last.verdict == Verdict::GoalMet,
    });
    let all = rounds
        .iter()
        .flat_map(|round| &round.motion.followed.strokes);
    let wiped = Plan {
        strokes: all.cloned().collect(),
        ..first.plan.clone()
    };
    score.lifts = wiped.strokes.len();
    score.distance_m = wiped.contact_distance();
    if options.is_pictured {
        score.picture = Some(Picture::new(&first.task, &wiped, &before, after));
    }
    Ok(score)
}

/// Makes the score of the first round's motion.
fn score_first_round(first: &PlannedRound, audit: &Audit, computation_s: f64) -> WipingScore {
    let followed = &first.followed;
    WipingScore {
        motion: Some(MotionScore {
            abandoned: followed.abandoned.len(),
            placements: followed.placements.len(),
            duration_s: followed.duration(),
            contact_s: followed.contact_time(),
            faults: audit.faults.len(),
        }),
        ..WipingScore::from_prediction(
            &first.task,
            &first.plan,
            &first.executable_plan(),
            computation_s,
        )
    }
}

/// Makes a new session without a robot.
fn create_session(loaded: &LoadedTask, is_certain: bool) -> Session<'static> {
    let config = RunConfig {
        // The effect of bad plans is part of the evaluation, so the minimum score does not apply.
        min_score: f64::NEG_INFINITY,
        ..loaded.run.clone()
    };
    let session = Session::new(&loaded.task, config);
    if is_certain {
        session
    } else {
        session.with_belief(loaded.belief())
    }
}

fn find_lost_share(performance: &Performance) -> f64 {
    performance.lost as f64 / performance.initial.max(1) as f64
}
