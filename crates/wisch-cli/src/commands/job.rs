//! What the commands have in common that go through a session: what they are given, and what comes of it.

use super::follow::{Chosen, Following, workcell_config};
use super::prepare::Prepared;
use crate::args::{LoopArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use wisch::follow::WorkcellConfig;
use wisch::plan::{Plan, Prediction};
use wisch::recover::Verdict;
use wisch::represent::{ParticleDistribution, ParticleError, Task};
use wisch::run::{Considered, Pace, PlannedRound, Round, RunConfig, RunError, Session};
use wisch_io::{ExecutedBy, OutputFolder, Robot, RoundTimes};
use wisch_report::EffectFrames;
use wisch_sim::{GroundTruth, Schedule};

/// Rounds of a single stroke that stand for one of a whole plan.
const GREEDY_ROUNDS: usize = 10;

/// What all commands work with that go through a session.
pub(super) struct Job<'a> {
    pub task_args: &'a TaskArgs,
    pub prepared: &'a Prepared,
    pub robot: Option<(&'a Chosen<'a>, &'a Robot)>,
    pub folder: &'a OutputFolder,
    pub progress: &'a Progress,
}

impl Job<'_> {
    /// How the stages work, and when to stop.
    pub fn config(&self, args: Option<&LoopArgs>) -> RunConfig {
        let (pace, usual_rounds) = if args.is_some_and(|args| args.greedy) {
            (Pace::Greedy, GREEDY_ROUNDS * self.prepared.max_rounds())
        } else {
            (self.prepared.file.pace(), self.prepared.max_rounds())
        };
        let rounds = args.and_then(|args| args.rounds);
        RunConfig {
            workcell: (self.robot.as_ref()).map_or_else(WorkcellConfig::default, |(chosen, _)| {
                workcell_config(chosen, self.prepared)
            }),
            max_rounds: rounds.map_or(usual_rounds, usize::from),
            pace,
            ..self.prepared.run_config()
        }
    }

    /// A session for the task that begins with this plan, if one is given.
    pub fn session(&self, config: RunConfig, given: Option<Plan>) -> Session<'_> {
        let session = Session::new(&self.prepared.task, config)
            .with_belief(self.prepared.belief())
            .with_plan(given);
        match self.robot {
            Some((_, robot)) => session.with_robot(robot.performer()),
            None => session,
        }
    }

    /// A failure of the session.
    pub fn failed(&self, error: RunError) -> Failure {
        match (error, &self.robot) {
            (RunError::Follow(error), Some((chosen, _))) => {
                chosen.cannot_follow(&error, self.task_args, self.prepared)
            }
            (error, _) => self.prepared.failure(self.task_args, error),
        }
    }
}

/// The outcome of the stages.
pub(super) struct Results {
    /// The task, with the dirt as it was believed to lie when the plan was made.
    pub task: Task,
    pub plan: Plan,
    /// `None` where a plan was given.
    pub planning_time_s: Option<f64>,
    pub following: Option<Following>,
    pub predicted: Option<(Prediction, EffectFrames)>,
    /// All plans that there were to choose from; `None` where nobody asked for them.
    pub considered: Option<Vec<Considered>>,
    /// What was executed.
    pub rounds: Vec<Done>,
    /// All that its report shows; empty where there is nothing to show.
    pub recording: Vec<u8>,
}

impl Results {
    /// Whether the goal is met: by the estimate of the last round, or where no robot was to do it by the prediction.
    pub fn is_goal_met(&self, target: f64) -> bool {
        match (self.rounds.last(), &self.following, &self.predicted) {
            (Some(last), ..) => last.round.verdict == Verdict::GoalMet,
            (None, Some(following), _) if !following.audit.faults.is_empty() => false,
            (None, _, Some((prediction, _))) => prediction.performance.ratio() >= target,
            (None, _, None) => true,
        }
    }
}

/// What is kept of a round while it goes on.
#[derive(Clone, Default)]
pub struct WatchedRound {
    /// How long its parts took.
    pub times: RoundTimes,
    /// What it was predicted to do, over time; `None` for a plan without strokes, which does nothing.
    pub frames: Option<EffectFrames>,
}

impl WatchedRound {
    /// What the round was predicted to do to a task's particles, over time.
    pub fn effect(&self, task: &Task, wiped: &Plan) -> EffectFrames {
        let frames = self.frames.clone();
        frames.unwrap_or_else(|| EffectFrames::new(task, wiped))
    }
}

/// A round with what was watched of it.
pub struct Done {
    /// The round.
    pub round: Round,
    /// How long its parts took.
    pub times: RoundTimes,
    /// What executed it.
    pub executed_by: ExecutedBy,
    /// Where the dirt really lies after it; `None` where none was simulated.
    pub truth: Option<ParticleDistribution>,
    /// The true performance [1]; `None` where no dirt was simulated.
    pub true_performance: Option<f64>,
    /// When somebody pushed [s].
    pub pushes: Vec<[f64; 2]>,
    /// In words, what the task has disturb the round and did not, because the motion ended before.
    pub missed: Vec<String>,
}

impl Done {
    /// A round that is over, with what the simulated world knows of it.
    pub fn new(
        round: Round,
        truth: Option<&GroundTruth>,
        watched: WatchedRound,
        executed_by: ExecutedBy,
        prepared: &Prepared,
    ) -> Result<Self, ParticleError> {
        let PlannedRound {
            number,
            task,
            plan,
            followed,
            ..
        } = &round.motion;
        // Only the simulated world knows who pushed.
        let schedule = match truth {
            Some(_) => prepared.reality.schedule(*number, followed),
            None => Schedule::default(),
        };
        let performance = |truth: &GroundTruth| truth.performance(&plan.graph.goal, &task.surface);
        Ok(Self {
            truth: (truth.map(GroundTruth::particles).transpose()?).flatten(),
            true_performance: (truth.map(performance).transpose()?).flatten(),
            pushes: (schedule.pushes.iter())
                .map(|(start, push)| [*start, start + push.duration])
                .collect(),
            missed: schedule.missed,
            times: watched.times,
            executed_by,
            round,
        })
    }
}
