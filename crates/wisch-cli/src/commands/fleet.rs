//! The memory of a fleet. The companion program `wisch-fleet` copies episodes there and back.

use super::companion::Companion;
use crate::args::{GlobalArgs, MemoryPullArgs, MemoryPushArgs, SelectionArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, remark};
use serde_json::Value;
use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Stdio};

const FLEET: Companion = Companion {
    name: "wisch-fleet",
    building: "building wisch-fleet; this happens once and takes about 15 minutes on two cores",
    is_workspace: true,
};

/// Copies the episodes of a memory to a fleet.
pub fn push(args: &MemoryPushArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let memory: &OsStr = args.memory.memory.as_ref();
    let mut fleet = begin(global, ["push".as_ref(), memory, args.url.as_ref()])?;
    if let Some(robot) = &args.robot {
        fleet.args(["--robot", robot]);
    }
    run_to_end(fleet, args.json, global)
}

/// Copies episodes of a fleet into a memory.
pub fn pull(args: &MemoryPullArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let memory: &OsStr = args.memory.memory.as_ref();
    let mut fleet = begin(global, ["pull".as_ref(), args.url.as_ref(), memory])?;
    fleet.args(args.selection.to_arguments());
    run_to_end(fleet, args.json, global)
}

/// Copies the selected episodes into a memory before a query, and prints a note with their number.
///
/// # Errors
/// If the fleet cannot be read.
pub fn fetch(
    url: &str,
    selection: &SelectionArgs,
    memory: &Path,
    global: &GlobalArgs,
) -> Result<(), Failure> {
    let mut fleet = begin(global, ["pull".as_ref(), url.as_ref(), memory.as_os_str()])?;
    fleet.args(selection.to_arguments()).arg("--json");
    fleet.stdout(Stdio::piped());
    let output = fleet.spawn().and_then(|child| child.wait_with_output());
    let output = output.map_err(|error| Failure::new(format!("{}: {error}", FLEET.name)))?;
    // Exit code 1: some episodes were left out, and wisch-fleet has named them.
    if !matches!(output.status.code(), Some(0 | 1)) {
        return Err(failed(output.status));
    }
    let said: Value = serde_json::from_slice(&output.stdout).unwrap_or_default();
    if !global.quiet {
        let number = |name: &str| said[name].as_u64().unwrap_or_default();
        remark(&format!(
            "{} of {} episodes of {url} are selected; {} were pulled now ({:.1} MB)",
            number("selected"),
            number("of"),
            number("episodes"),
            number("bytes") as f64 * 1e-6,
        ));
        let left_out = said["left_out"].as_array().map_or(0, Vec::len);
        if left_out > 0 {
            remark(&format!(
                "{left_out} of the selected episodes cannot be read and are missing from the answers"
            ));
        }
    }
    Ok(())
}

fn begin<const N: usize>(global: &GlobalArgs, arguments: [&OsStr; N]) -> Result<Command, Failure> {
    let mut fleet = Command::new(FLEET.find_or_build(global)?);
    fleet.args(arguments);
    Ok(fleet)
}

fn run_to_end(mut fleet: Command, json: bool, global: &GlobalArgs) -> Result<Outcome, Failure> {
    if json {
        fleet.arg("--json");
    } else if global.quiet {
        fleet.stdout(Stdio::null());
    }
    let status = fleet.status();
    let status = status.map_err(|error| Failure::new(format!("{}: {error}", FLEET.name)))?;
    match status.code() {
        Some(0) => Ok(Outcome::Done),
        Some(1) => Ok(Outcome::GoalNotMet),
        _ => Err(failed(status)),
    }
}

/// Makes a failure from an exit status; wisch-fleet has printed the reason.
fn failed(status: std::process::ExitStatus) -> Failure {
    Failure::new(format!("{} ended: {status}", FLEET.name))
}
