//! The whole loop: plan, follow, audit, execute, interpret, judge, and again until the goal is met; paper §4.
//!
//! A [`Session`] is the only thing here with state. It goes on one stage at a time, says what happens by [`RunEvent`]s,
//! and reaches the world through an [`Executor`] alone.

mod config;
mod considered;
mod error;
mod event;
mod execution;
mod executor;
mod order;
mod own_strategy;
mod round;
mod session;
mod stance;
mod stroke_watch;
mod telemetry;
mod trajectory_clock;

pub use config::{AfterStop, MIN_SCORE, Pace, Performer, RunConfig};
pub use considered::{Considered, ConsideredMotion};
pub use error::{RunError, check_score};
pub use event::{Observer, RunEvent, unobserved};
pub use execution::{Ending, Execution, StopCause};
pub use executor::{Executor, ExecutorError, NoExecutor, RecordedRound, Recording, SampleSink};
pub use order::{MotionOrder, Setpoint};
pub use own_strategy::OwnStrategy;
pub use round::{ExecutedMotion, PlannedRound, Round};
pub use session::{Session, Stage};
pub use stroke_watch::StrokeEnd;
pub use telemetry::{RecordedSample, TelemetrySample};
pub use trajectory_clock::{TrajectoryClock, TrajectoryTimeError};

pub use crate::control::Wrench;
