//! `wisch studio`: the page on which runs are begun, watched and asked about. Its server is a program of its own.

use super::companion::{Companion, Workspace};
use crate::args::{GlobalArgs, StudioArgs};
use crate::failure::Failure;
use crate::terminal::Outcome;
use std::path::PathBuf;
use std::process::Command;
use wisch_memory::ask::EngineCommand;

const STUDIO: Companion = Companion {
    name: "wisch-studio",
    building: "building the studio, once: a minute or two",
    workspace: Workspace::Shared,
};

/// Begins the server, and ends with it.
pub fn studio(args: &StudioArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let program = find(global)?;
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
    let ended = server
        .status()
        .map_err(|error| Failure::new(format!("{}: {error}", program.display())))?;
    match ended.code() {
        Some(0) => Ok(Outcome::Done),
        // It has said why.
        _ => Err(Failure::new(format!("the studio ended: {ended}"))),
    }
}

fn find(global: &GlobalArgs) -> Result<PathBuf, Failure> {
    if let Some(program) = STUDIO.find() {
        return Ok(program);
    }
    let built = STUDIO.build(global);
    let built = built.map_err(|why| Failure::new(why).with_help(STUDIO.install()))?;
    let program = built.then(|| STUDIO.find()).flatten();
    program.ok_or_else(|| {
        Failure::new(format!("{} cannot be found", STUDIO.name)).with_help(STUDIO.install())
    })
}
