//! What `--json` says of the rounds of a run.

use serde::Serialize;
use wisch::interpret::{Diagnosis, EventKind};
use wisch::run::{Ending, Round};

/// How long the parts of a round took.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RoundTimes {
    /// Planning [s].
    pub planning_s: f64,
    /// Following [s].
    pub following_s: f64,
    /// Executing [s].
    pub executing_s: f64,
    /// Interpreting [s].
    pub interpreting_s: f64,
}

/// What executed a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExecutedBy {
    /// The world that wisch simulates.
    SimulatedWorld,
    /// Another program: a robot, or a simulator.
    Executor,
}

impl ExecutedBy {
    /// Its name in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::SimulatedWorld => "simulated world",
            Self::Executor => "executor",
        }
    }
}

/// One round.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundSummary {
    /// Its number, from 1.
    pub round: usize,
    /// Strokes that were planned.
    pub strokes: usize,
    /// Performance that the plan promised as it was followed.
    pub predicted: f64,
    /// Performance by touch.
    pub estimated: f64,
    /// Lower end of its 90 % interval.
    pub estimated_low: f64,
    /// Upper end of its 90 % interval.
    pub estimated_high: f64,
    /// Estimated performance by touch alone, before anything was seen.
    pub felt: f64,
    /// How many detections there were where dirt was looked for afterwards; null where nothing looked.
    pub seen: Option<usize>,
    /// Performance of the simulated dirt; null where none was simulated.
    pub true_performance: Option<f64>,
    /// Time in contact over the time that the tool was to wipe.
    pub contact_share: f64,
    /// Collisions that were felt.
    pub collisions: usize,
    /// From when to when each of them lasted [s].
    pub collision_times_s: Vec<[f64; 2]>,
    /// Angle between the felt and the believed surface; null where no plane was found.
    pub plane_tilt_rad: Option<f64>,
    /// Height of the felt over the believed surface; null where no plane was found.
    pub plane_offset_m: Option<f64>,
    /// localized, relocalize or no contact.
    pub diagnosis: &'static str,
    /// goal met, wipe again, no progress or no contact.
    pub verdict: &'static str,
    /// complete, stopped, or why the robot stopped itself.
    pub ending: String,
    /// What executed it: `simulated world` or `executor`.
    pub executed_by: &'static str,
    /// How long the execution lasted, in the time of the robot.
    pub execution_time_s: f64,
    /// How long of it the tool wiped, as planned until the execution ended.
    pub contact_time_s: f64,
    /// The length of the way of the arm's joints in joint space while the tool wiped.
    pub joint_movement_in_contact_rad: f64,
    /// The length of their whole way.
    pub joint_movement_rad: f64,
    /// Way of the tool in contact.
    pub distance_in_contact_m: f64,
    /// Its whole way.
    pub distance_total_m: f64,
    /// How long the computations took; left out of files, which are to be the same every time.
    #[serde(flatten)]
    pub timing: Option<RoundTiming>,
}

/// How long the computations of a round took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundTiming {
    /// Time in the simulated world over the time that simulating it took; null where no world was simulated.
    pub realtime_factor: Option<f64>,
    /// How long planning took.
    pub planning_time_s: f64,
    /// How long following took.
    pub following_time_s: f64,
    /// How long interpreting took.
    pub interpretation_time_s: f64,
}

impl RoundSummary {
    /// The summary of a round; its true performance is what a simulated world knows of it.
    pub fn new(
        round: &Round,
        times: &RoundTimes,
        executed_by: ExecutedBy,
        true_performance: Option<f64>,
    ) -> Self {
        let interpretation = &round.interpretation;
        let executed = round.executed();
        let collisions = (interpretation.events.iter()).filter(|e| e.kind == EventKind::Collision);
        let collision_times_s: Vec<[f64; 2]> =
            collisions.map(|event| [event.start, event.end]).collect();
        Self {
            round: round.motion.number,
            strokes: round.motion.plan.strokes.len(),
            predicted: round.motion.prediction.performance.ratio(),
            estimated: interpretation.performance.mean,
            estimated_low: interpretation.performance.low,
            estimated_high: interpretation.performance.high,
            felt: interpretation.felt.mean,
            seen: interpretation
                .observation
                .as_ref()
                .map(|seen| seen.detections.len()),
            true_performance,
            contact_share: interpretation.contact_share,
            collisions: collision_times_s.len(),
            collision_times_s,
            plane_tilt_rad: interpretation.plane.map(|plane| plane.tilt),
            plane_offset_m: interpretation.plane.map(|plane| plane.offset),
            diagnosis: match interpretation.diagnosis {
                Diagnosis::Localized => "localized",
                Diagnosis::Relocalize { .. } => "relocalize",
                Diagnosis::NoContact => "no contact",
                Diagnosis::Hovering => "hovering",
            },
            verdict: round.verdict.as_str(),
            ending: match &round.execution.ending {
                ending @ (Ending::Complete | Ending::Stopped) => ending.as_str().to_owned(),
                Ending::Early { time, cause } => format!("early at {time:.3} s: {cause}"),
                Ending::ProtectiveStop { time, cause } => format!("at {time:.3} s: {cause}"),
            },
            executed_by: executed_by.as_str(),
            execution_time_s: round.execution.duration,
            // The sum of nothing is -0.
            contact_time_s: executed.contact_time + 0.0,
            joint_movement_in_contact_rad: executed.joint_movement[0],
            joint_movement_rad: executed.joint_movement[1],
            distance_in_contact_m: executed.distance[0],
            distance_total_m: executed.distance[1],
            timing: Some(RoundTiming {
                realtime_factor: (executed_by == ExecutedBy::SimulatedWorld)
                    .then(|| round.execution.duration / times.executing_s.max(f64::MIN_POSITIVE)),
                planning_time_s: times.planning_s,
                following_time_s: times.following_s,
                interpretation_time_s: times.interpreting_s,
            }),
        }
    }

    /// Without what depends on the machine.
    pub fn without_timing(self) -> Self {
        Self {
            timing: None,
            ..self
        }
    }
}

/// The part of a summary that takes an execution.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoopSummary {
    /// The rounds in their order.
    pub rounds: Vec<RoundSummary>,
    /// Performance by touch after the last of them.
    pub final_estimated: f64,
    /// Performance of the simulated dirt after the last of them; null where none was simulated.
    pub final_true: Option<f64>,
    /// Simulated time of all executions over the time that they took; null where no world was simulated.
    pub realtime_factor: Option<f64>,
}

impl LoopSummary {
    /// The sum of a quantity over the rounds.
    pub fn total(&self, of: impl Fn(&RoundSummary) -> f64) -> f64 {
        self.rounds.iter().map(of).sum()
    }

    /// The summary of rounds; `None` of none.
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
            final_true: last.true_performance,
            realtime_factor: simulated.map(|[time, taken]| time / taken.max(f64::MIN_POSITIVE)),
            rounds,
        })
    }
}
