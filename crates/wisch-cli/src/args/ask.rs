//! Arguments of `ask`.

use super::SelectionArgs;
use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// Arguments of `ask`.
#[derive(Debug, Args)]
pub struct AskArgs {
    /// Prolog query; without one, an interactive prompt
    #[arg(value_name = "QUERY")]
    pub query: Option<String>,
    /// Folder of the memory [default: episodes; with --fleet a temporary folder]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub memory: Option<PathBuf>,
    /// Query episodes of a fleet (s3://BUCKET/PREFIX or a folder); the selected episodes are copied to the memory first
    #[arg(long, value_name = "URL")]
    pub fleet: Option<String>,
    /// The selected episodes of a fleet.
    #[command(flatten)]
    pub selection: SelectionArgs,
    /// Prolog system: scryer (the companion program wisch-prolog) or swi (SWI-Prolog) [default: the first installed]
    #[arg(long, value_name = "NAME")]
    pub engine: Option<EngineChoice>,
    /// Print the answers as one JSON object
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print the answers as CSV
    #[arg(long)]
    pub csv: bool,
    /// Write the answers, the plots and the scene that the query shows, and the recordings of its episodes into this HTML file
    #[arg(long, value_name = "FILE", requires = "query", value_hint = ValueHint::FilePath)]
    pub view: Option<PathBuf>,
    /// Maximum number of answers
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub limit: u32,
    /// Time limit of a query [s]
    #[arg(long, value_name = "S", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub timeout: u32,
    /// Memory limit of the Prolog system [MB]
    #[arg(long, value_name = "MB", default_value_t = 4096, value_parser = clap::value_parser!(u32).range(256..=1_048_576))]
    pub memory_limit: u32,
    /// List the predicates that queries may call, with their meaning
    #[arg(long)]
    pub list: bool,
}

/// A Prolog system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EngineChoice {
    /// Scryer Prolog, in the companion program wisch-prolog.
    Scryer,
    /// SWI-Prolog.
    Swi,
}
