//! What came of a run.

use crate::error::RecordError;
use crate::following::Following;
use crate::stages::{RoundStages, StageSink};
use wisch::geometry::Pose;
use wisch::plan::{Plan, Prediction};
use wisch::recover::Verdict;
use wisch::represent::{ParticleDistribution, Task};
use wisch::run::{Considered, Round, Session};
use wisch_io::{ExecutedBy, RoundSummary};
use wisch_report::EffectFrames;

/// What a simulated world knows of a round, and nobody else.
#[derive(Debug, Clone, Default)]
pub struct KnownTruth {
    /// Where the dirt really lies after it, in the frame of the real surface [m]; `None` where none was simulated.
    pub particles: Option<ParticleDistribution>,
    /// The true performance, in [0, 1]; `None` where no dirt was simulated.
    pub performance: Option<f64>,
    /// When somebody pushed: from, to [s].
    pub pushes: Vec<[f64; 2]>,
    /// In words, what was to disturb the round and did not, because the motion ended before.
    pub missed: Vec<String>,
    /// Where the surface really is, in the world.
    pub world_from_surface: Option<Pose>,
}

/// A round that is over, with what was kept of it meanwhile.
#[derive(Debug, Clone)]
pub struct FinishedRound {
    /// The round.
    pub round: Round,
    /// How long its stages took, and what it was predicted to do.
    pub stages: RoundStages,
    /// What executed it.
    pub executed_by: ExecutedBy,
    /// What a simulated world knows of it; `None` of a real one.
    pub truth: Option<KnownTruth>,
}

impl FinishedRound {
    /// The true performance, in [0, 1]; `None` where nobody knows it.
    pub fn true_performance(&self) -> Option<f64> {
        self.truth.as_ref()?.performance
    }

    /// What `--json` says of the round.
    pub fn summary(&self) -> RoundSummary {
        let truth = self.true_performance();
        RoundSummary::new(&self.round, &self.stages.times, self.executed_by, truth)
    }
}

/// What came of a run, or of the stages of one that executed nothing.
#[derive(Debug, Clone)]
pub struct RunResults {
    /// The task, with the dirt as it was believed to lie when the plan was made.
    pub task: Task,
    /// The plan of the first round.
    pub plan: Plan,
    /// How long planning it took [s]; `None` where a plan was given.
    pub planning_time_s: Option<f64>,
    /// The motion of the first round; `None` without a robot.
    pub following: Option<Following>,
    /// What the first round is predicted to do.
    pub predicted: Option<(Prediction, EffectFrames)>,
    /// All plans that there were to choose from; `None` where nobody asked for them.
    pub considered: Option<Vec<Considered>>,
    /// What was executed.
    pub rounds: Vec<FinishedRound>,
    /// All that its report shows, JSON lines; empty where there is nothing to show.
    pub recording: Vec<u8>,
}

impl RunResults {
    /// What a session has come to, without its rounds.
    ///
    /// # Errors
    /// [`RecordError::Nothing`] if it has planned no round.
    pub fn of(session: &Session<'_>, stages: &mut StageSink) -> Result<Self, RecordError> {
        let (planned, _) = session.first().ok_or(RecordError::Nothing)?;
        let first = stages.round(1);
        let frames = first.effect(&planned.task, &planned.wiped());
        Ok(Self {
            task: planned.task.clone(),
            plan: planned.plan.clone(),
            planning_time_s: Some(first.times.planning_s),
            following: Following::of(session, first.times.following_s),
            predicted: Some((planned.prediction.clone(), frames)),
            considered: None,
            rounds: Vec::new(),
            recording: Vec::new(),
        })
    }

    /// Adds the rounds that are over.
    ///
    /// # Parameters
    /// - `truths`: what the simulated world knows of them, in their order; empty for a real one.
    pub fn add_rounds(
        &mut self,
        rounds: Vec<Round>,
        stages: &mut StageSink,
        executed_by: ExecutedBy,
        truths: Vec<KnownTruth>,
    ) {
        let truths = truths.into_iter().map(Some);
        let truths = truths.chain(std::iter::repeat_with(|| None));
        let finished = rounds.into_iter().zip(truths);
        self.rounds.extend(finished.map(|(round, truth)| {
            let stages = std::mem::take(stages.round(round.motion.number));
            FinishedRound {
                round,
                stages,
                executed_by,
                truth,
            }
        }));
    }

    /// Whether the goal is met: by the estimate of the last round, or where no robot was to do it by the prediction.
    pub fn is_goal_met(&self, target: f64) -> bool {
        match (self.rounds.last(), &self.following, &self.predicted) {
            (Some(last), ..) => last.round.verdict == Verdict::GoalMet,
            (None, Some(following), _) if !following.audit.faults.is_empty() => false,
            (None, _, Some((prediction, _))) => prediction.performance.ratio() >= target,
            (None, _, None) => true,
        }
    }

    /// The plan of the first round as it is wiped: where a robot follows it, without what had to be given up.
    pub fn wiped(&self) -> Plan {
        let following = self.following.as_ref();
        following.map_or_else(|| self.plan.clone(), |f| f.plan(&self.plan))
    }
}
