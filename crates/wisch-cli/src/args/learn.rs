//! Arguments of `learn`.

use clap::{Args, ValueHint};
use std::path::PathBuf;

/// Arguments of `learn`.
#[derive(Debug, Args)]
pub struct LearnArgs {
    /// Bags with camera observations before and after wiping, and folders of runs
    #[arg(value_name = "BAGS", required_unless_present_any = ["memory", "episodes"], value_hint = ValueHint::AnyPath)]
    pub bags: Vec<PathBuf>,
    /// Folder of a memory to learn from: the episodes that --episode names, or all episodes that have camera
    /// observations [default with
    /// --episode: episodes]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub memory: Option<PathBuf>,
    /// Name of an episode of the memory, as listed by `wisch memory list`; repeatable
    #[arg(long = "episode", value_name = "ID")]
    pub episodes: Vec<String>,
    /// Task file that was executed; repeatable. Each bag or episode uses the task file whose `name` it states [default:
    /// for an episode, the task that it keeps; for a bag, the shipped scenario of that name]
    #[arg(long = "task", value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub tasks: Vec<PathBuf>,
    /// Knowledge base to update: folder with tools, media, surfaces, interactions [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
    /// Print the changes of the knowledge base as a unified diff and write no file
    #[arg(long, conflicts_with = "out")]
    pub diff: bool,
    /// File for the learned interactions
    #[arg(long, value_name = "FILE", default_value = "learned.toml", value_hint = ValueHint::FilePath)]
    pub out: PathBuf,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}
