//! Arguments of `learn`.

use clap::{Args, ValueHint};
use std::path::PathBuf;

/// Arguments of `learn`.
#[derive(Debug, Args)]
pub struct LearnArgs {
    /// Bags of rounds that were looked at before and after, and folders of runs
    #[arg(value_name = "BAGS", required_unless_present_any = ["memory", "episodes"], value_hint = ValueHint::AnyPath)]
    pub bags: Vec<PathBuf>,
    /// Folder of a memory whose episodes teach: those of --episode, or all that were looked at [default of --episode:
    /// episodes]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub memory: Option<PathBuf>,
    /// Name of an episode of the memory, as listed by `wisch memory list`; repeatable
    #[arg(long = "episode", value_name = "ID")]
    pub episodes: Vec<String>,
    /// Task file of what was wiped; repeatable, each bag or episode goes with the task of its name [default: the shipped
    /// scenario of that name]
    #[arg(long = "task", value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub tasks: Vec<PathBuf>,
    /// Knowledge base that is to learn: folder with tools, media, surfaces, interactions [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
    /// Print what changes in the knowledge base as a unified diff, and write nothing
    #[arg(long, conflicts_with = "out")]
    pub diff: bool,
    /// File for the learned interactions
    #[arg(long, value_name = "FILE", default_value = "learned.toml", value_hint = ValueHint::FilePath)]
    pub out: PathBuf,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}
