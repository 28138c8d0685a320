//! The results of a run.

use crate::error::RecordError;
use crate::following::FollowedPlan;
use crate::stages::StageSink;
use wisch::geometry::Pose;
use wisch::plan::{Plan, Prediction};
use wisch::recover::Verdict;
use wisch::represent::{ParticleDistribution, SurfaceShape, Task};
use wisch::run::{CandidateEvaluation, Round, Session};
use wisch_io::{ExecutedBy, RoundSummary, RoundTimes};
use wisch_report::EffectFrames;

/// The simulated world's ground truth of a round.
#[derive(Debug, Clone, Default)]
pub struct RoundGroundTruth {
    /// True dirt after the round, in the frame of the true surface \[m\]; `None` without simulated dirt.
    pub particles: Option<ParticleDistribution>,
    /// True performance, in [0, 1]; `None` without simulated dirt.
    pub performance: Option<f64>,
    /// Times of pushes: start, end \[s\].
    pub pushes: Vec<[f64; 2]>,
    /// Descriptions of disturbances that did not happen because the motion ended before them.
    pub missed: Vec<String>,
    /// True pose of the surface in the world.
    pub world_from_surface: Option<Pose>,
    /// True shape of the surface, if it differs from the believed one.
    pub surface_shape: Option<SurfaceShape>,
}

/// A finished round with its record.
#[derive(Debug, Clone)]
pub struct FinishedRound {
    /// The round.
    pub round: Round,
    /// Durations of its stages.
    pub times: RoundTimes,
    /// The executor.
    pub executed_by: ExecutedBy,
    /// Ground truth of a simulated world; `None` for a real robot.
    pub truth: Option<RoundGroundTruth>,
}

impl FinishedRound {
    /// The true performance, in [0, 1]; `None` without ground truth.
    pub fn true_performance(&self) -> Option<f64> {
        self.truth.as_ref()?.performance
    }

    /// Returns the summary of the round for `--json`.
    pub fn summary(&self) -> RoundSummary {
        let truth = self.true_performance();
        RoundSummary::new(&self.round, &self.times, self.executed_by, truth)
    }
}

/// The results of a run, or of its first stages if nothing was executed.
#[derive(Debug, Clone)]
pub struct RunResults {
    /// The task, with the dirt as believed when the plan was made.
    pub task: Task,
    /// The plan of the first round.
    pub plan: Plan,
    /// Planning time \[s\]; `None` if the user gave the plan.
    pub planning_time_s: Option<f64>,
    /// The motion of the first round; `None` without a robot.
    pub following: Option<FollowedPlan>,
    /// Predicted effect of the first round.
    pub predicted: Option<(Prediction, EffectFrames)>,
    /// All candidate plans; `None` if they were not requested.
    pub considered: Option<Vec<CandidateEvaluation>>,
    /// Range of the number of detections that were expected before the first round, if the camera detects none.
    pub unseen: Option<[f64; 2]>,
    /// Whether a camera observed the dirt before the first round.
    pub is_observed: bool,
    /// Whether the run ended without an executed round and without an observation, so that nothing shows whether the goal
    /// is met.
    pub is_unmeasured: bool,
    /// The executed rounds.
    pub rounds: Vec<FinishedRound>,
    /// The recording for the run's page, as JSON lines; empty if no page is made.
    pub recording: Vec<u8>,
    /// The recording, compressed by gzip.
    pub packed: Vec<u8>,
}

impl RunResults {
    /// Collects the results of a session, without its rounds.
    ///
    /// # Parameters
    /// - `frames`: the predicted effect of the first round over time; `None` for a plan without strokes.
    ///
    /// # Errors
    /// [`RecordError::Nothing`] if no round was planned.
    pub(crate) fn from_session(
        session: &Session<'_>,
        stages: &mut StageSink,
        frames: Option<EffectFrames>,
    ) -> Result<Self, RecordError> {
        let (planned, _) = session.first_motion().ok_or(RecordError::Nothing)?;
        let times = stages.round(1);
        let frames =
            frames.unwrap_or_else(|| EffectFrames::new(&planned.task, &planned.executable_plan()));
        Ok(Self {
            task: planned.task.clone(),
            plan: planned.plan.clone(),
            planning_time_s: Some(times.planning_s),
            following: FollowedPlan::from_session(session, times.following_s),
            predicted: Some((planned.prediction.clone(), frames)),
            considered: None,
            unseen: session.unseen_dirt(),
            is_observed: session.first_observation().is_some(),
            is_unmeasured: false,
            rounds: Vec::new(),
            recording: Vec::new(),
            packed: Vec::new(),
        })
    }

    /// Adds the finished rounds to the results.
    ///
    /// # Parameters
    /// - `truths`: their ground truth in a simulated world, in the same order; empty for a real robot.
    pub fn add_rounds(
        &mut self,
        rounds: Vec<Round>,
        stages: &mut StageSink,
        executed_by: ExecutedBy,
        truths: Vec<RoundGroundTruth>,
    ) {
        let truths = truths.into_iter().map(Some);
        let truths = truths.chain(std::iter::repeat_with(|| None));
        let finished = rounds.into_iter().zip(truths);
        self.rounds.extend(finished.map(|(round, truth)| {
            let times = std::mem::take(stages.round(round.motion.number));
            FinishedRound {
                round,
                times,
                executed_by,
                truth,
            }
        }));
        self.is_unmeasured = self.rounds.is_empty() && !self.is_observed;
    }

    /// Whether the goal is met: by the last round's estimate. A run without executed rounds must have observed the dirt. For
    /// a prediction, the goal is met if the particles react as it assumes.
    pub fn is_goal_met(&self, target: f64) -> bool {
        if let Some(last) = self.rounds.last() {
            return last.round.verdict == Verdict::GoalMet;
        }
        let is_known = self.unseen.is_none() && !self.is_unmeasured;
        self.is_predicted(target) && !self.needs_stronger_reaction(target) && is_known
    }

    /// Whether the prediction reaches the target, but fewer particles than the target react to the press force, which the
    /// prediction does not count. Never so after an executed round.
    pub fn depends_on_reaction(&self, target: f64) -> bool {
        self.rounds.is_empty() && self.is_predicted(target) && self.needs_stronger_reaction(target)
    }

    /// Whether only a prediction says that the goal is met, although a run has ended.
    pub fn is_only_predicted(&self, target: f64) -> bool {
        self.is_unmeasured && self.is_predicted(target)
    }

    fn needs_stronger_reaction(&self, target: f64) -> bool {
        self.predicted.is_some() && self.task.interaction.reaction_probability() < target
    }

    /// Whether the target is reached if every particle under the tool reacts.
    fn is_predicted(&self, target: f64) -> bool {
        match (&self.following, &self.predicted) {
            (Some(following), _) if !following.audit.faults.is_empty() => false,
            (_, Some((prediction, _))) => {
                let is_exceeded = (self.task.treatment).is_some_and(|treatment| {
                    treatment.exceeds_limit([(&prediction.particles, 1.0)], target)
                });
                prediction.performance.ratio() >= target && !is_exceeded
            }
            (_, None) => true,
        }
    }

    /// Returns the plan of the first round without the nodes that the robot abandons.
    pub fn executable_plan(&self) -> Plan {
        let following = self.following.as_ref();
        following.map_or_else(|| self.plan.clone(), |f| f.plan(&self.plan))
    }
}
