//! Summaries of the rounds of a run for `--json`.

use super::warning::WarningRecord;
use serde::Serialize;
use wisch::interpret::EventKind;
use wisch::run::{Ending, Pause, Round};

/// Durations of the stages of a round.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RoundTimes {
    /// Duration of planning \[s\].
    pub planning_s: f64,
    /// Duration of computing the motion that follows the plan \[s\].
    pub following_s: f64,
    /// Duration of the execution \[s\].
    pub executing_s: f64,
    /// Duration of the interpretation \[s\].
    pub interpreting_s: f64,
}

/// The kind of executor that executed a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExecutedBy {
    /// The simulated world of wisch.
    SimulatedWorld,
    /// An external program: a robot driver or a simulator.
    Executor,
}

impl ExecutedBy {
    /// Name of the kind in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::SimulatedWorld => "simulated world",
            Self::Executor => "executor",
        }
    }
}

/// The summary of a round, for `rounds.json` and `--json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundSummary {
    /// Its number, from 1.
    pub round: usize,
    /// Number of planned strokes.
    pub strokes: usize,
    /// Predicted performance of the followed plan.
    pub predicted: f64,
    /// Estimated performance.
    pub estimated: f64,
    /// Whether the log, or an observation after it, allows an estimate; otherwise the estimate is a guess.
    pub is_conclusive: bool,
    /// Lower end of its 90 % interval.
    pub estimated_low: f64,
    /// Upper end of its 90 % interval.
    pub estimated_high: f64,
    /// Estimated performance from touch only, before an observation.
    pub estimated_by_touch: f64,
    /// Number of detections of the observation after the round; null without an observation.
    pub detections: Option<usize>,
    /// True performance; null without simulated dirt.
    pub true_performance: Option<f64>,
    /// Time in contact over the time that the tool was on or near the surface; null if it never was.
    pub contact_share: Option<f64>,
    /// Number of detected collisions.
    pub collisions: usize,
    /// Start and end of each collision \[s\].
    pub collision_times_s: Vec<[f64; 2]>,
    /// Angle between the fitted plane and the believed surface; null without a plane.
    pub plane_tilt_rad: Option<f64>,
    /// Height of the fitted plane above the believed surface; null without a plane.
    pub plane_offset_m: Option<f64>,
    /// localized, relocalize, no contact or hovering.
    pub diagnosis: &'static str,
    /// goal met, wipe again, or another name of a [`Verdict`](wisch::recover::Verdict).
    pub verdict: &'static str,
    /// complete, stopped, or the cause of a protective stop.
    pub ending: String,
    /// Warnings during the execution; left out without one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<WarningRecord>,
    /// Executor: `simulated world` or `executor`.
    pub executed_by: &'static str,
    /// Duration of the execution, in the robot's time.
    pub execution_time_s: f64,
    /// Duration of planned contact until the execution ended.
    pub contact_time_s: f64,
    /// Path length of the arm's revolute joints in joint space during contact.
    pub joint_movement_in_contact_rad: f64,
    /// Total path length of the arm's revolute joints.
    pub joint_movement_rad: f64,
    /// Path length of the arm's prismatic joints during contact; left out for an arm without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_movement_in_contact_m: Option<f64>,
    /// Total path length of the arm's prismatic joints; left out for an arm without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_movement_m: Option<f64>,
    /// Path length of the tool in contact, along the strokes that the robot follows.
    pub distance_in_contact_m: f64,
    /// Total path length of the tool in the world, from the ready posture and back.
    pub distance_total_m: f64,
    /// Pauses of the motion; left out without one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pauses: Vec<PauseSummary>,
    /// Number of samples that were dropped because the records of the run were too slow; left out if it is 0.
    #[serde(skip_serializing_if = "is_zero")]
    pub dropped_samples: usize,
    /// Computation times; left out of files, so that files are reproducible.
    #[serde(flatten)]
    pub timing: Option<RoundTiming>,
}

/// A pause of a motion, with its interval.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PauseSummary {
    /// Time of its begin, since the start of the motion.
    pub start_s: f64,
    /// Time of its end; null if the motion ended in it.
    pub end_s: Option<f64>,
    /// Phase of the motion at its begin.
    pub phase: &'static str,
    /// Number of the stroke, from 0; left out between strokes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stroke: Option<usize>,
    /// Reason that the robot reports; may be empty.
    pub reason: String,
}

impl From<&Pause> for PauseSummary {
    fn from(pause: &Pause) -> Self {
        Self {
            start_s: pause.start,
            end_s: pause.end,
            phase: pause.phase.as_str(),
            stroke: pause.phase.stroke(),
            reason: pause.reason.clone(),
        }
    }
}

const fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// Computation times of a round's stages.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundTiming {
    /// Ratio of simulated time to computation time; null without a simulated world.
    pub realtime_factor: Option<f64>,
    /// Planning time.
    pub planning_time_s: f64,
    /// Following time.
    pub following_time_s: f64,
    /// Interpretation time.
    pub interpretation_time_s: f64,
}

impl RoundSummary {
    /// Makes the summary of a round. `truth`: true performance, if a simulated world provides it.
    pub fn new(
        round: &Round,
        times: &RoundTimes,
        executed_by: ExecutedBy,
        true_performance: Option<f64>,
    ) -> Self {
        let interpretation = &round.interpretation;
        let [low, high] = interpretation.range(round.motion.task.action);
        let executed = round.executed_motion();
        let collisions = (interpretation.events.iter()).filter(|e| e.kind == EventKind::Push);
        let collision_times_s: Vec<[f64; 2]> =
            collisions.map(|event| [event.start, event.end]).collect();
        Self {
            round: round.motion.number,
            strokes: round.motion.plan.strokes.len(),
            predicted: round.motion.prediction.performance.ratio(),
            estimated: interpretation.performance.mean,
            is_conclusive: interpretation.is_conclusive(),
            estimated_low: low,
            estimated_high: high,
            estimated_by_touch: interpretation.by_touch.mean,
            detections: interpretation
                .observation
                .as_ref()
                .map(|observation| observation.detections.len()),
            true_performance,
            contact_share: interpretation.contact_share,
            collisions: collision_times_s.len(),
            collision_times_s,
            plane_tilt_rad: interpretation.plane.map(|plane| plane.tilt),
            plane_offset_m: interpretation.plane.map(|plane| plane.offset),
            diagnosis: interpretation.diagnosis.as_str(),
            verdict: round.verdict.as_str(),
            ending: match &round.execution.ending {
                ending @ (Ending::Complete | Ending::Stopped) => ending.as_str().to_owned(),
                Ending::Early { time, cause } => format!("early at {time:.3} s: {cause}"),
                Ending::ProtectiveStop { time, cause } => format!("at {time:.3} s: {cause}"),
            },
            warnings: round.warnings.iter().map(WarningRecord::from).collect(),
            executed_by: executed_by.as_str(),
            execution_time_s: round.execution.duration,
            // An empty sum of f64 is -0.0.
            contact_time_s: executed.contact_time + 0.0,
            joint_movement_in_contact_rad: executed.joint_movement[0],
            joint_movement_rad: executed.joint_movement[1],
            joint_movement_in_contact_m: executed.slide_movement.map(|[in_contact, _]| in_contact),
            joint_movement_m: executed.slide_movement.map(|[_, in_all]| in_all),
            distance_in_contact_m: executed.distance[0],
            distance_total_m: executed.distance[1],
            pauses: round
                .execution
                .pauses
                .iter()
                .map(PauseSummary::from)
                .collect(),
            dropped_samples: round.execution.dropped_samples,
            timing: Some(RoundTiming {
                realtime_factor: (executed_by == ExecutedBy::SimulatedWorld)
                    .then(|| round.execution.duration / times.executing_s.max(f64::MIN_POSITIVE)),
                planning_time_s: times.planning_s,
                following_time_s: times.following_s,
                interpretation_time_s: times.interpreting_s,
            }),
        }
    }

    /// Returns the summary without values that depend on the machine.
    pub fn without_timing(self) -> Self {
        Self {
            timing: None,
            ..self
        }
    }
}

/// The part of a summary about the execution.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoopSummary {
    /// The rounds in their order.
    pub rounds: Vec<RoundSummary>,
    /// Estimated performance after the last round.
    pub final_estimated: f64,
    /// Whether the last round allows an estimate; otherwise it is a guess.
    pub is_conclusive: bool,
    /// True performance after the last round; null without simulated dirt.
    pub final_true: Option<f64>,
    /// Ratio of simulated time to computation time over all executions; null without a simulated world.
    pub realtime_factor: Option<f64>,
}

impl LoopSummary {
    /// Sums a quantity over the rounds.
    pub fn total(&self, of: impl Fn(&RoundSummary) -> f64) -> f64 {
        self.rounds.iter().map(of).sum()
    }

    /// Makes the summary of rounds; `None` without rounds.
    pub fn new(rounds: Vec<RoundSummary>) -> Option<Self> {
        let last = rounds.last()?;
        let mut simulated: Option<[f64; 2]> = None;
        for round in &rounds {
            let factor = round
                .timing
                .as_ref()
                .and_then(|timing| timing.realtime_factor);
            if let Some(factor) = factor {
                let [time, taken] = simulated.get_or_insert_default();
                *time += round.execution_time_s;
                *taken += round.execution_time_s / factor.max(f64::MIN_POSITIVE);
            }
        }
        Some(Self {
            final_estimated: last.estimated,
            is_conclusive: last.is_conclusive,
            final_true: last.true_performance,
            realtime_factor: simulated.map(|[time, taken]| time / taken.max(f64::MIN_POSITIVE)),
            rounds,
        })
    }
}
