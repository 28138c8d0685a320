//! The program `wisch-fleet`.

mod args;
mod clusters;
mod commands;

use args::{Cli, Command};
use clap::Parser;
use std::process::ExitCode;
use wisch_fleet::store::FleetError;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    /// It ran, but not as hoped.
    NotAsHoped,
}

#[tokio::main]
async fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(&cli.command).await {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::NotAsHoped) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

async fn run(command: &Command) -> Result<Outcome, FleetError> {
    match command {
        Command::Sql(args) => commands::sql(args).await,
        Command::Views(args) => commands::views(args),
        Command::Columns(args) => commands::columns(args),
        Command::Push(args) => commands::push(args).await,
        Command::Pull(args) => commands::pull(args).await,
        Command::Compact(args) => commands::compact(args).await,
        Command::Retain(args) => commands::retain(args).await,
        Command::Verify(args) => commands::verify(args).await,
        Command::Scheduler(args) => clusters::scheduler(args).await,
        Command::Executor(args) => clusters::executor(args).await,
    }
}
