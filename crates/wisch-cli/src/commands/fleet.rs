//! What goes to a fleet's store and comes from it: the program `wisch-fleet` does it, apart for the time that it takes to compile.

use super::companion::{Companion, Workspace};
use super::words::internal;
use crate::args::{FleetArgs, FleetFilter, GlobalArgs, PullArgs, PushArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, remark};
use serde::Deserialize;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const FLEET: Companion = Companion {
    name: "wisch-fleet",
    building: "building wisch-fleet, once: a quarter of an hour",
    workspace: Workspace::Own,
};

/// What `wisch-fleet pull --json` says.
#[derive(Debug, Deserialize)]
struct Pulled {
    ids: Vec<String>,
    of: usize,
    episodes: usize,
    bytes: u64,
}

/// Pushes a memory.
pub fn push(args: &PushArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let mut command = program(global)?;
    command.arg("push").arg(&args.memory.memory).arg(&args.url);
    if let Some(robot) = &args.robot {
        command.args(["--robot", robot]);
    }
    run(command, args.json, global)
}

/// Pulls episodes into a memory.
pub fn pull(args: &PullArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let mut command = program(global)?;
    command.arg("pull").arg(&args.url).arg(&args.memory.memory);
    filter(&mut command, &args.filter);
    run(command, args.json, global)
}

/// Pulls what the filters select, and says what came: the memory that then has them, and the names of those that are meant.
pub fn pull_to_ask(
    url: &str,
    args: &FleetArgs,
    global: &GlobalArgs,
) -> Result<(PathBuf, HashSet<String>), Failure> {
    let mut command = program(global)?;
    command.arg("pull").arg(url).arg(&args.fleet_cache).arg("--json");
    filter(&mut command, &args.filter);
    let ended = command.stderr(Stdio::inherit()).output();
    let ended = ended.map_err(|error| cannot_run(Path::new(FLEET.name), &error))?;
    if !ended.status.success() {
        return Err(Failure::new(format!("{url}: cannot be pulled from: {}", ended.status)));
    }
    let pulled: Pulled = serde_json::from_slice(&ended.stdout).map_err(internal)?;
    if !global.quiet {
        remark(&format!(
            "{url}: {} of {} episodes are asked, {} came now ({:.1} MB)",
            pulled.ids.len(),
            pulled.of,
            pulled.episodes,
            pulled.bytes as f64 * 1e-6
        ));
    }
    Ok((args.fleet_cache.clone(), pulled.ids.into_iter().collect()))
}

fn filter(command: &mut Command, filter: &FleetFilter) {
    let once = [
        ("--since", &filter.since),
        ("--until", &filter.until),
        ("--where", &filter.condition),
    ];
    for (name, value) in once {
        command.args(value.iter().map(|value| format!("{name}={value}")));
    }
    let repeated = [
        ("--robot", &filter.robot),
        ("--class", &filter.class),
        ("--episode", &filter.episode),
    ];
    for (name, values) in repeated {
        command.args(values.iter().map(|value| format!("{name}={value}")));
    }
}

fn program(global: &GlobalArgs) -> Result<Command, Failure> {
    if let Some(program) = FLEET.find() {
        return Ok(Command::new(program));
    }
    let built = FLEET.build(global);
    let built = built.map_err(|why| Failure::new(why).with_help(FLEET.install()))?;
    let program = built.then(|| FLEET.find()).flatten();
    program.map(Command::new).ok_or_else(|| {
        Failure::new(format!("{} cannot be found", FLEET.name)).with_help(FLEET.install())
    })
}

fn run(mut command: Command, json: bool, global: &GlobalArgs) -> Result<Outcome, Failure> {
    if json {
        command.arg("--json");
    } else if global.quiet {
        command.stdout(Stdio::null());
    }
    let ended = command.status();
    let ended = ended.map_err(|error| cannot_run(Path::new(FLEET.name), &error))?;
    match ended.code() {
        Some(0) => Ok(Outcome::Done),
        Some(1) => Ok(Outcome::GoalNotMet),
        // It has said why.
        _ => Err(Failure::new(format!("{} ended: {ended}", FLEET.name))),
    }
}

fn cannot_run(program: &Path, error: &std::io::Error) -> Failure {
    Failure::new(format!("{}: {error}", program.display()))
}
