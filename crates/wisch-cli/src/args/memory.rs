//! Arguments of `memory`, and the memory that keeps runs.

use super::{LoggedArgs, MemoryPullArgs, MemoryPushArgs};
use clap::{Args, Subcommand, ValueHint};
use std::path::PathBuf;
use wisch_memory::neem::NeemConfig;

/// The memory that keeps a run as an episode.
#[derive(Debug, Args)]
#[command(next_help_heading = "Memory")]
pub struct KeepArgs {
    /// Folder of the memory that stores the run as an episode with its telemetry
    #[arg(long, value_name = "DIR", default_value = DEFAULT_MEMORY, value_hint = ValueHint::DirPath)]
    pub memory: PathBuf,
    /// Do not store the run as an episode
    #[arg(long, conflicts_with = "memory")]
    pub no_memory: bool,
}

/// The memory to read.
#[derive(Debug, Args)]
pub struct MemoryArgs {
    /// Folder of the memory
    #[arg(long, value_name = "DIR", default_value = DEFAULT_MEMORY, value_hint = ValueHint::DirPath)]
    pub memory: PathBuf,
}

/// Default folder of the memory.
pub const DEFAULT_MEMORY: &str = "episodes";

/// The subcommands of `memory`.
#[derive(Debug, Subcommand)]
pub enum MemoryCommand {
    /// List the episodes, oldest first
    #[command(after_help = "\
Examples:
  wisch memory list
  wisch memory list --json | jq 'select(.performance < 0.8) | .id'")]
    List(MemoryListArgs),
    /// Show the events of an episode
    #[command(after_help = "\
Examples:
  wisch memory show 20261122-005612-3f2a
  wisch memory show 20261122-005612-3f2a --json | jq '.individuals[] | .class' | sort | uniq -c")]
    Show(EpisodeArgs),
    /// Interpret a log of tool poses and forces, and add it to the memory as an episode
    #[command(after_help = "\
Examples:
  wisch memory import wipe.mcap --task board.toml
  wisch memory import log.csv --task board.toml --csv-columns t=time,x=px --start-s 1795308972

The options of the log are those of `wisch interpret`. Tables and simulated bags often count time from 0: \
set the date with --start-s.")]
    Import(Box<ImportArgs>),
    /// Verify the checksum and contents of every file of every episode
    #[command(after_help = "\
Exit codes: 0 all episodes are intact, 1 some files are damaged, 2 an error.")]
    Verify(MemoryVerifyArgs),
    /// Find drifts and sudden changes of robot, tool and surface over the episodes, and forecast when a limit is reached
    #[command(after_help = "\
Examples:
  wisch memory health
  wisch memory health --surface chopping_board --tool sponge
  wisch memory health --json | jq '.groups[] | select(.needs_attention) | .surface'

Runs of the same robot, tool, surface, dirt, press force and source form one group. \
A finding needs seven of them. The table states which values the episodes lack.

Exit codes: 0 nothing is found that needs attention, 1 something needs attention, 2 an error.")]
    Health(MemoryHealthArgs),
    /// Delete an episode for good
    Forget(EpisodeArgs),
    /// Export episodes as narrative-enabled episodic memories (NEEM) for KnowRob and openEASE
    #[command(after_help = "\
Examples:
  wisch memory export --neem neem
  wisch memory export --neem neem 20261122-005612-3f2a --tf-rate-hz 50

The folder has one subfolder for each collection, each a dump that mongorestore and KnowRob read: triples, \
annotations, inferred and tf, and two collections that only wisch writes: wrench, and observation with the \
camera's dirt locations. It also holds meta.json and semco.owl. Without ID, damaged and changed episodes are left out; the \
output names each with the reason.

Exit codes: 0 success, 1 some episodes were left out, 2 an error.")]
    Export(ExportArgs),
    /// Copy the episodes to a fleet: a store that many robots share
    #[command(after_help = "\
Examples:
  wisch memory push s3://robots/fleet --robot kitchen-7
  wisch memory push /mnt/fleet --memory episodes

Needs the companion program wisch-fleet. It skips episodes that the fleet already has, and resumes an interrupted push. \
Credentials come from the environment (AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY, AWS_ENDPOINT, …) or from \
~/.aws/credentials.")]
    Push(MemoryPushArgs),
    /// Copy episodes of a fleet into this memory, byte for byte
    #[command(after_help = "\
Examples:
  wisch memory pull s3://robots/fleet --since 2026-11-01 --class HumanCollision
  wisch memory pull /mnt/fleet --where \"performance <= 0.8\" --memory doubtful

Exit codes: 0 success, 1 some episodes were left out, 2 an error.")]
    Pull(MemoryPullArgs),
}

/// Arguments of `memory import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The log.
    #[command(flatten)]
    pub source: LoggedArgs,
    /// Time of the log's first sample, in seconds since 1970 (UTC) [default: from the log]
    #[arg(long, help_heading = "Memory", value_name = "SECONDS", value_parser = parse_start)]
    pub start_s: Option<f64>,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory export`.
#[derive(Debug, Args)]
pub struct ExportArgs {
    /// Names of the episodes, as listed by `wisch memory list` [default: all]
    #[arg(value_name = "ID")]
    pub ids: Vec<String>,
    /// Folder to create for the NEEM
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub neem: PathBuf,
    /// Rate at which the pose of each frame is written [Hz]
    #[arg(long, value_name = "HZ", default_value_t = NeemConfig::default().tf_rate_hz, allow_negative_numbers = true)]
    pub tf_rate_hz: f64,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory list`.
#[derive(Debug, Args)]
pub struct MemoryListArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object per episode instead of the table
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory health`.
#[derive(Debug, Args)]
pub struct MemoryHealthArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Assess only the runs of this robot
    #[arg(long, value_name = "NAME")]
    pub robot: Option<String>,
    /// Assess only the runs with this tool
    #[arg(long, value_name = "NAME")]
    pub tool: Option<String>,
    /// Assess only the runs on this surface
    #[arg(long, value_name = "NAME")]
    pub surface: Option<String>,
    /// Print one JSON object instead of the table
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory verify`.
#[derive(Debug, Args)]
pub struct MemoryVerifyArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// An episode of a memory.
#[derive(Debug, Args)]
pub struct EpisodeArgs {
    /// Name of the episode, as listed by `wisch memory list`
    #[arg(value_name = "ID")]
    pub id: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

fn parse_start(text: &str) -> Result<f64, String> {
    let seconds: f64 = text
        .parse()
        .map_err(|_| format!("{text:?} is not a number"))?;
    if (0.0..LATEST_START_S).contains(&seconds) {
        return Ok(seconds);
    }
    Err(format!("{seconds} s is outside 0 to {LATEST_START_S} s"))
}

/// Upper limit of a start time [s since 1970]: the year 2286, when the seconds reach eleven digits.
const LATEST_START_S: f64 = 1e10;
