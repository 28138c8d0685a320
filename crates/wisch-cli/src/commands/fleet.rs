//! A fleet's memory. Who brings episodes there and back is a program of its own.

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
    building: "building wisch-fleet, once: a quarter of an hour on two cores",
    is_workspace: true,
};

/// Brings the episodes of a memory into a fleet.
pub fn push(args: &MemoryPushArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let memory: &OsStr = args.memory.memory.as_ref();
    let mut fleet = begin(global, ["push".as_ref(), memory, args.url.as_ref()])?;
    if let Some(robot) = &args.robot {
        fleet.args(["--robot", robot]);
    }
    ended(fleet, args.json, global)
}

/// Brings episodes of a fleet into a memory.
pub fn pull(args: &MemoryPullArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let memory: &OsStr = args.memory.memory.as_ref();
    let mut fleet = begin(global, ["pull".as_ref(), args.url.as_ref(), memory])?;
    fleet.args(args.selection.to_arguments());
    ended(fleet, args.json, global)
}

/// Brings what is selected into a memory that is to be asked, and says what that was.
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
    // With 1, episodes were left out, each of which was named.
    if !matches!(output.status.code(), Some(0 | 1)) {
        return Err(failed(output.status));
    }
    let said: Value = serde_json::from_slice(&output.stdout).unwrap_or_default();
    if !global.quiet {
        let number = |name: &str| said[name].as_u64().unwrap_or_default();
        remark(&format!(
            "{} of {} episodes of {url} are selected; {} of them were pulled now ({:.1} MB)",
            number("selected"),
            number("of"),
            number("episodes"),
            number("bytes") as f64 * 1e-6,
        ));
        let left_out = said["left_out"].as_array().map_or(0, Vec::len);
        if left_out > 0 {
            remark(&format!(
                "{left_out} of them cannot be read: the answers lack them"
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

fn ended(mut fleet: Command, json: bool, global: &GlobalArgs) -> Result<Outcome, Failure> {
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

/// It has said why.
fn failed(status: std::process::ExitStatus) -> Failure {
    Failure::new(format!("{} ended: {status}", FLEET.name))
}
