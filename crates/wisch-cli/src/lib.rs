//! The program `wisch`: plan, predict and report robotic wiping from the command line.
//!
//! `args` is what the user may type; each command has its file in `commands`; the crate `wisch_io` reads
//! and writes files; `records` is what `--json` prints; `output` puts results on the disk.

mod args;
mod commands;
mod failure;
mod progress;
mod terminal;

use std::ffi::OsString;

/// Runs the program with these arguments, its own name first, and says its exit code: 0 done, 1 goal not met, 2 error.
///
/// It is made to be all that its process does: it sets the hook of panics, watches for Ctrl-C where a run can be resumed, and
/// ends the process where help is asked for or the command line is wrong.
pub fn main_with(args: impl IntoIterator<Item = OsString>) -> u8 {
    let args: Vec<OsString> = args.into_iter().collect();
    terminal::run(&args, || {
        let cli = args::Cli::read(&args).unwrap_or_else(|error| terminal::refuse(&error));
        terminal::prepare(&cli.global)?;
        commands::run(&cli)
    })
}
