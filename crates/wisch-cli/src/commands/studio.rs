//! `wisch studio`: the page on which users start, watch and query runs. Its server is a companion program.

use super::companion::Companion;
use crate::args::{GlobalArgs, StudioArgs};
use crate::failure::Failure;
use crate::terminal::Outcome;
use std::process::Command;
use wisch_memory::ask::EngineCommand;

const STUDIO: Companion = Companion {
    name: "wisch-studio",
    building: "building the studio; this happens once and takes one or two minutes",
    is_workspace: false,
};

/// Replaces this process by the server, so that signals reach the server and neither outlives the other.
pub fn studio(args: &StudioArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let program = STUDIO.find_or_build(global)?;
    let wisch = std::env::current_exe().map_err(|error| {
        Failure::new(format!("the path of the program wisch is unknown: {error}"))
    })?;
    let mut server = Command::new(&program);
    server.arg("--memory").arg(&args.memory.memory);
    server.arg("--wisch").arg(wisch);
    if let Some(EngineCommand::Scryer(engine)) = EngineCommand::find_scryer() {
        server.arg("--engine").arg(engine);
    }
    server.args(["--host", &args.host]);
    server.args(["--port", &args.port.to_string()]);
    if args.open {
        server.arg("--open");
    }
    become_program(&mut server)
        .map_err(|what| Failure::new(format!("{}: {what}", program.display())))
}

/// Replaces this process by a program. It returns only if that fails.
#[cfg(unix)]
fn become_program(server: &mut Command) -> Result<Outcome, String> {
    use std::os::unix::process::CommandExt;
    Err(server.exec().to_string())
}

/// Runs a program and waits for it. Ctrl-C reaches both.
#[cfg(not(unix))]
fn become_program(server: &mut Command) -> Result<Outcome, String> {
    match server.status() {
        Ok(ended) if ended.success() => Ok(Outcome::Done),
        // The program has printed the reason.
        Ok(ended) => Err(format!("it ended: {ended}")),
        Err(error) => Err(error.to_string()),
    }
}
