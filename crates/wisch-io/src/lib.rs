//! The files of robotic wiping: task files, the knowledge base, robots, plans, trajectories, and what is shipped.
//!
//! A task file becomes a task and its configuration by [`load_task`]; the method itself is the crate [`wisch`].
//!
//! Units are SI and radians, but for file keys that end in another unit.

mod assets;
mod error;
mod knowledge;
mod load;
mod particles;
mod records;
mod robots;
mod task_file;

pub use assets::{KnowledgeSource, beside, read, read_text};
pub use error::Error;
pub use knowledge::{KnowledgeFileError, parse_knowledge};
pub use load::{Derivation, LoadOptions, LoadedTask, load_task};
pub use particles::{
    MaskSource, ParticleSource, ParticleSourceError, csv_particles, mask_particles,
    particles_from_csv, particles_to_csv,
};
pub use records::{
    AbandonedRecord, AttemptRecord, EventRecord, FollowedRecord, GoalRecord, INTERPRETATION_FORMAT,
    InterpretationRecord, LogRecord, MotionRecord, NodeRecord, PLAN_FORMAT, PLAN_SCHEMA,
    PlacementRecord, PlanRecord, PlanRecordError, PlanarPoseRecord, PlaneRecord, PoseRecord,
    RobotTrajectory, RoleRecord, StrokeRecord, WaypointRecord, WipedRecord, tcp_path_csv,
};
pub use robots::{MAP_EXTENSION, Robot, RobotFiles, robot_meshes, shipped_robots};
pub use task_file::{
    ExecutionRecord, FrictionChange, Intent, Push, ReadFile, RobotDescription, RobotRecord,
    TaskError, TaskFile,
};
