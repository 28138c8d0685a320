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

/// Outcome of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    /// The command ran, but found faults.
    FaultsFound,
}

fn main() -> ExitCode {
    let cli = FleetCli::parse();
    // Statements are trees that DataFusion traverses by recursion, so a large stack is needed.
    let worked = thread::scope(|scope| {
        let main = thread::Builder::new().stack_size(STACK);
        let working = main
            .spawn_scoped(scope, || begin(&cli.command))
            .map_err(system)?;
        // A panic has printed its message already.
        working
            .join()
            .unwrap_or_else(|_| Err(system(io::Error::other("the program panicked"))))
    });
    match worked {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::FaultsFound) => ExitCode::from(1),
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
        FleetCommand::Forget(args) => commands::forget(args).await,
        FleetCommand::Compact(args) => commands::compact(args).await,
        FleetCommand::Retain(args) => commands::retain(args).await,
        FleetCommand::Verify(args) => commands::verify(args).await,
        FleetCommand::Scheduler(args) => clusters::scheduler(args).await,
        FleetCommand::Executor(args) => clusters::executor(args).await,
    }
}
