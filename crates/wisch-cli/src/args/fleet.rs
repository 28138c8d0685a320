//! Arguments of what moves episodes between a memory and a fleet's store.

use super::MemoryArgs;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// Arguments of `memory push`.
#[derive(Debug, Args)]
pub struct PushArgs {
    /// The fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder
    #[arg(value_name = "URL")]
    pub url: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Name of the robot, where the model's name in the episodes does not tell robots apart
    #[arg(long, value_name = "NAME")]
    pub robot: Option<String>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory pull`.
#[derive(Debug, Args)]
pub struct PullArgs {
    /// The fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder
    #[arg(value_name = "URL")]
    pub url: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Which episodes.
    #[command(flatten)]
    pub filter: FleetFilter,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Which episodes of a fleet.
#[derive(Debug, Args)]
pub struct FleetFilter {
    /// Of a fleet, episodes that ended then or later: a day or a time (UTC), such as 2026-11-22T08:00:00Z
    #[arg(long, value_name = "TIME")]
    pub since: Option<String>,
    /// Of a fleet, episodes that began then or earlier; a day counts whole
    #[arg(long, value_name = "TIME")]
    pub until: Option<String>,
    /// Of a fleet, episodes of this robot; repeatable
    #[arg(long, value_name = "NAME")]
    pub robot: Vec<String>,
    /// Of a fleet, episodes in which something of this class happened, such as HumanCollision; repeatable
    #[arg(long, value_name = "CLASS")]
    pub class: Vec<String>,
    /// Of a fleet, this episode; repeatable
    #[arg(long, value_name = "ID")]
    pub episode: Vec<String>,
    /// Of a fleet, episodes for which this holds, in SQL, such as "performance <= 0.8"
    #[arg(long = "where", value_name = "SQL")]
    pub condition: Option<String>,
}

/// A fleet that is asked instead of a memory.
#[derive(Debug, Args)]
pub struct FleetArgs {
    /// Ask a fleet: pull the episodes that the filters select, then ask those
    #[arg(long, value_name = "URL", conflicts_with = "memory")]
    pub fleet: Option<String>,
    /// Folder in which episodes of the fleet are kept for the next question
    #[arg(long, value_name = "DIR", default_value = "fleet-episodes", requires = "fleet", value_hint = ValueHint::DirPath)]
    pub fleet_cache: PathBuf,
    /// Which episodes.
    #[command(flatten)]
    pub filter: FleetFilter,
}
