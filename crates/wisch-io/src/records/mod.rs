//! The contents of files. Units are SI and radians; keys end in their unit, and poses state their frames.

mod event;
mod followed;
mod interpretation;
mod plan;
mod plan_differences;
mod rounds;
mod shape;
mod summary;
mod trajectory;
mod warning;

pub use event::{EVENT_SCHEMA, EventWriter, RunEventRecord};
pub use followed::{
    AbandonedRecord, AttemptRecord, FollowedRecord, MotionRecord, PlacementRecord, WipedRecord,
};
pub use interpretation::{
    ContactResidualRecord, EventRecord, INTERPRETATION_FORMAT, InterpretationRecord, LogRecord,
    PlaneRecord, RegistrationRecord,
};
pub use plan::{
    GoalRecord, NodeRecord, PLAN_FORMAT, PLAN_SCHEMA, PlanRecord, PlanRecordError,
    PlanarPoseRecord, PoseRecord, RoleRecord, StrokeRecord, WaypointRecord,
};
pub use rounds::{ExecutedBy, LoopSummary, RoundSummary, RoundTimes};
pub use shape::{BendContactRecord, ShapeRecord};
pub use summary::{
    CandidateSummary, FollowingSummary, PredictionSummary, SUMMARY_SCHEMA, Summary,
    TreatmentSummary,
};
pub use trajectory::{RobotTrajectory, planned_path_csv, tcp_path_csv};
pub use warning::{AlikeEpisodeRecord, WarningRecord};
