//! Episodic memory of robotic wiping: every run is an episode that answers queries.
//!
//! An episode consists of its telemetry and of a graph of [`Individual`]s: the wiping, its rounds and strokes, detected
//! events, and participants. The [`Catalogue`] holds the graphs of all episodes in columns.

pub mod ask;
pub mod catalogue;
mod checked_file;
mod columns;
pub mod frames;
pub mod health;
mod id;
mod known_round;
pub mod neem;
mod observations;
pub mod ontology;
mod record;
mod remember;
mod robot;
mod statements;
pub mod store;
pub mod telemetry;
pub mod view;
pub mod warnings;

pub use catalogue::{Catalogue, CatalogueNode, IndividualId};
pub use frames::{FrameError, Frames, LOG_COLUMNS, PoseAt, RoundScene, Sampling, StoredPose};
pub use id::{date_and_time, episode_id, is_date, local_date_and_time};
pub use known_round::{
    CUT_REMARK, KnownRound, RecordedMotion, is_same_motion, may_be_same_observations,
};
pub use observations::{OBSERVATIONS_SCHEMA, ObservationFault, RoundObservations};
pub use ontology::Ontology;
pub use record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, RecordFault, Value};
pub use remember::{
    EpisodeHeader, EpisodeRound, GoalOutcome, RememberedGoal, RememberedPart, RememberedStep,
    RoundLog, StepKind, remember, remember_goal, remember_log,
};
pub use robot::RobotText;
pub use store::{Episode, EpisodeWriter, Fault, Memory, MemoryError, RECORDING_FILE, live_path};
pub use telemetry::{Mark, Series, Telemetry, TelemetryError, TelemetryHead, TelemetryWriter};
