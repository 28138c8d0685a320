//! The program `wisch-fleet`.

mod args;
mod clusters;
mod commands;

use args::{FleetCli, FleetCommand};
use clap::Parser;
use std::io;
use std::process::ExitCode;
use std::thread;
use wisch_fleet::ask::STACK;
use wisch_fleet::store::FleetError;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    /// It ran, but not as hoped.
    NotAsHoped,
}

fn main() -> ExitCode {
    let cli = FleetCli::parse();
    // Statements are trees, which DataFusion walks by recursion.
    let worked = thread::scope(|scope| {
        let main = thread::Builder::new().stack_size(STACK);
        let working = main
            .spawn_scoped(scope, || begin(&cli.command))
            .map_err(system)?;
        // A panic has said what it is.
        working
            .join()
            .unwrap_or_else(|_| Err(system(io::Error::other("this was not expected"))))
    });
    match worked {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::NotAsHoped) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn begin(command: &FleetCommand) -> Result<Outcome, FleetError> {
    let mut runtime = tokio::runtime::Builder::new_multi_thread();
    let runtime = runtime.thread_stack_size(STACK).enable_all().build();
    runtime.map_err(system)?.block_on(run(command))
}

fn system(error: io::Error) -> FleetError {
    FleetError::Asked(format!("this program cannot run: {error}"))
}

async fn run(command: &FleetCommand) -> Result<Outcome, FleetError> {
    match command {
        FleetCommand::Sql(args) => commands::sql(args).await,
        FleetCommand::Views(args) => commands::views(args),
        FleetCommand::Columns(args) => commands::columns(args),
        FleetCommand::Push(args) => commands::push(args).await,
        FleetCommand::Pull(args) => commands::pull(args).await,
        FleetCommand::Compact(args) => commands::compact(args).await,
        FleetCommand::Retain(args) => commands::retain(args).await,
        FleetCommand::Verify(args) => commands::verify(args).await,
        FleetCommand::Scheduler(args) => clusters::scheduler(args).await,
        FleetCommand::Executor(args) => clusters::executor(args).await,
    }
}
