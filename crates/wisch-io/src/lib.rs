//! The files of robotic wiping: task files, the knowledge base, robots, plans, trajectories, and shipped data.
//!
//! [`load_task`] reads a task file and returns a task with its configuration. The method itself is the crate [`wisch`].
//!
//! Units are SI and radians, except for file keys that end in another unit.

mod assets;
mod digest;
mod error;
mod goal_file;
mod gravity;
mod kept_files;
mod knowledge;
mod load;
mod output;
mod particles;
mod process;
mod records;
mod robots;
mod shell;
mod task_file;
mod up_axis;

pub use assets::{
    KnowledgeSource, read, read_beside, read_text, scenario_files, shipped_scenarios,
};
pub use digest::{FileDigest, InputDigest};
pub use error::Error;
pub use goal_file::GoalFile;
pub use kept_files::{ChangedFile, KeptFiles};
pub use knowledge::{InteractionRevision, KnowledgeFileError, RevisedFile, parse_knowledge};
pub use load::{
    Derivation, LoadOptions, LoadedTask, load_task, load_task_with, parse_task, read_task_name,
    wipes_all_patches,
};
pub use output::{
    FOLLOWING_FILE, INTERPRETATION_FILE, KilledRuns, Leftover, NewFolder, OutputFile, OutputFolder,
    PARTICLES_AFTER_FILE, PARTICLES_BEFORE_FILE, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE,
    PLAN_FILE, RECORDING_FILE, REPORT_FILE, ROUNDS_FILE, Replaceable, TCP_PATH_FILE,
    TRAJECTORY_FILE, Unfinished, UnfinishedPath, path_in_results, remove_unfinished,
    round_file_name,
};
pub use particles::{
    MaskSource, ParticleSource, ParticleSourceError, csv_particles, mask_particles,
    particles_from_csv, particles_to_csv, read_observed_image, read_observed_list,
};
pub use process::{
    DoneRecord, DriverRobotRecord, EXECUTOR_PROTOCOL, EndingRecord, Intake, MAX_SILENCE_S,
    ObservationRecord, PauseRecord, PauseSwitch, ProcessExecutor, ProcessOptions, ResumeRecord,
    SampleRecord, StampClockRecord, StopKindRecord, WrenchAxes, WrenchQualityRecord,
    kill_executors,
};
pub use records::{
    AbandonedRecord, AlikeEpisodeRecord, AttemptRecord, BendContactRecord, CandidateSummary,
    ContactResidualRecord, EVENT_SCHEMA, EventRecord, EventWriter, ExecutedBy, FollowedRecord,
    FollowingSummary, GoalRecord, INTERPRETATION_FORMAT, InterpretationRecord, LogRecord,
    LoopSummary, MotionRecord, NodeRecord, PLAN_FORMAT, PLAN_SCHEMA, PlacementRecord, PlanRecord,
    PlanRecordError, PlanarPoseRecord, PlaneRecord, PoseRecord, PredictionSummary,
    RegistrationRecord, RobotTrajectory, RoleRecord, RoundSummary, RoundTimes, RunEventRecord,
    SUMMARY_SCHEMA, ShapeRecord, StrokeRecord, Summary, TreatmentSummary, WarningRecord,
    WaypointRecord, WipedRecord, planned_path_csv, tcp_path_csv,
};
pub use robots::{MAP_EXTENSION, Robot, RobotFiles, robot_meshes, robot_warnings, shipped_robots};
pub use shell::shell_word;
pub use task_file::{
    Intent, RackTool, ReadFile, RobotDescription, RobotRecord, TaskError, TaskFile,
    check_tool_extent, find_underside_offset,
};
pub use up_axis::up_axis_remark;
