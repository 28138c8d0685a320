//! The contents of the files that the program writes and reads. SI units, radians; keys end in their unit,
//! and poses say their frames.

mod followed;
mod interpretation;
mod plan;
mod rounds;
mod summary;
mod trajectory;

pub use followed::FollowedRecord;
pub use interpretation::{INTERPRETATION_FORMAT, InterpretationRecord, LogRecord};
pub use plan::{PLAN_FORMAT, PlanRecord};
pub use rounds::{LoopSummary, RoundSummary, RoundTimes};
pub use summary::{FollowingSummary, PredictionSummary, SUMMARY_SCHEMA, Summary};
pub use trajectory::{RobotTrajectory, tcp_path_csv};
