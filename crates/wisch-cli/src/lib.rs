//! The program `wisch`: plan, predict and report robotic wiping from the command line.
//!
//! `args` holds the command line and its help; each command has a file in `commands`. The crate `wisch_io` reads and
//! writes files: its `records` are the objects that `--json` prints, and its `output` replaces folders of results.

mod args;
mod commands;
mod failure;
mod progress;
mod terminal;

use std::ffi::OsString;

/// Runs the program and returns its exit code: 0 done, 1 goal not met, 2 error.
///
/// `args`: the command line, with the program's name first. The function assumes that it owns its process: it sets the
/// panic hook, installs signal handlers during runs, and exits the process after help texts and invalid arguments.
pub fn main_with(args: impl IntoIterator<Item = OsString>) -> u8 {
    let args: Vec<OsString> = args.into_iter().collect();
    terminal::run(&args, || {
        let cli = args::Cli::read(&args)
            .unwrap_or_else(|error| terminal::exit_with_parser_message(&error));
        terminal::prepare(&cli.global)?;
        commands::run(&cli)
    })
}
