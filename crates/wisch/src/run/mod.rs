//! The whole loop: plan, follow, audit, execute, interpret, decide, until the goal is met; paper §4.
//!
//! A [`Session`] is the only item with state in this module. It advances one stage at a time,
//! reports its progress by [`RunEvent`]s, and accesses the world only through an [`Executor`].

mod config;
mod considered;
mod detections;
mod error;
mod event;
mod execution;
mod executor;
mod first_plan;
mod force_ramp;
mod knots;
mod measured_motion;
mod order;
mod own_strategy;
mod pose_agreement;
mod round;
mod session;
mod stance;
mod stroke_watch;
mod telemetry;
mod trajectory_clock;
mod warning;
mod warning_watch;

pub use config::{AfterStop, FALSE_WARNING_RATE, MIN_SCORE, Pace, RobotSetup, RunConfig};
pub use considered::{CandidateEvaluation, EvaluatedMotion};
pub use detections::check_detections;
pub use error::{RunError, check_score};
pub use event::{Observer, RunEvent, ignore_events};
pub use execution::{Ending, Execution, Pause, StopCause, StopKind};
pub use executor::{
    Executor, ExecutorError, NoExecutor, RecordedRound, Recording, RobotState, SampleSink,
};
pub use first_plan::FirstPlan;
pub use force_ramp::ForceRamp;
pub use order::{MotionOrder, Setpoint};
pub use own_strategy::OwnStrategy;
pub use round::{ExecutedMotion, PlannedRound, Round};
pub use session::{Session, Stage};
pub use stroke_watch::StrokeEnd;
pub use telemetry::{RecordedSample, SampleStatus, Stamp, StampClock, TelemetrySample};
pub use trajectory_clock::{TrajectoryClock, TrajectoryTimeError};
pub use warning::{AlikeEpisode, OnWarning, RunWarning, WarningChannel, WarningSpan};
pub use warning_watch::WarningWatch;

pub use crate::control::Wrench;
