//! Arguments of `ask`.

use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// Arguments of `ask`.
#[derive(Debug, Args)]
pub struct AskArgs {
    /// The query, in Prolog; without one, queries are read line by line
    #[arg(value_name = "QUERY")]
    pub query: Option<String>,
    /// The memory to ask
    #[arg(long, value_name = "DIR", default_value = "episodes", value_hint = ValueHint::DirPath)]
    pub memory: PathBuf,
    /// The Prolog system that answers: scryer (the program wisch-prolog) or swi (SWI-Prolog); without it, the first
    /// of them that is there
    #[arg(long, value_name = "NAME")]
    pub engine: Option<EngineChoice>,
    /// Print the answers as one JSON object
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print the answers as a table of comma-separated values
    #[arg(long)]
    pub csv: bool,
    /// Draw what the query shows, with its answers, into one HTML file
    #[arg(long, value_name = "FILE", requires = "query", value_hint = ValueHint::FilePath)]
    pub view: Option<PathBuf>,
    /// Most answers
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub limit: u32,
    /// Most seconds for a query
    #[arg(long, value_name = "S", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub timeout: u32,
    /// Most megabytes of memory for the Prolog system
    #[arg(long, value_name = "MB", default_value_t = 4096, value_parser = clap::value_parser!(u32).range(256..=1_048_576))]
    pub memory_limit: u32,
    /// List the predicates that queries may use, and what they say
    #[arg(long)]
    pub list: bool,
}

/// A Prolog system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EngineChoice {
    /// Scryer Prolog, the program wisch-prolog.
    Scryer,
    /// SWI-Prolog.
    Swi,
}
