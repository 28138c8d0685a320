//! `wisch studio`: the page on which runs are begun, watched and asked about. Its server is a program of its own.

use super::companion::Companion;
use crate::args::{GlobalArgs, StudioArgs};
use crate::failure::Failure;
use crate::terminal::Outcome;
use std::process::Command;
use wisch_memory::ask::EngineCommand;

const STUDIO: Companion = Companion {
    name: "wisch-studio",
    building: "building the studio, once: a minute or two",
    is_workspace: false,
};

/// Becomes the server: what signals this process signals the server, and one does not outlive the other.
pub fn studio(args: &StudioArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let program = STUDIO.find_or_build(global)?;
    let wisch = std::env::current_exe()
        .map_err(|error| Failure::new(format!("this program cannot be found: {error}")))?;
    let mut server = Command::new(&program);
    server.arg("--memory").arg(&args.memory.memory);
    server.arg("--wisch").arg(wisch);
    if let Some(EngineCommand::Scryer(engine)) = EngineCommand::scryer() {
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

/// Runs a program in place of this one; what it returns is why it cannot.
#[cfg(unix)]
fn become_program(server: &mut Command) -> Result<Outcome, String> {
    use std::os::unix::process::CommandExt;
    Err(server.exec().to_string())
}

/// Runs a program, and ends with it. Ctrl-C reaches both.
#[cfg(not(unix))]
fn become_program(server: &mut Command) -> Result<Outcome, String> {
    match server.status() {
        Ok(ended) if ended.success() => Ok(Outcome::Done),
        // It has said why.
        Ok(ended) => Err(format!("it ended: {ended}")),
        Err(error) => Err(error.to_string()),
    }
}
