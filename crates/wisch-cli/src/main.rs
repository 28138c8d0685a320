//! The program `wisch`: plan, predict and report robotic wiping from the command line.
//!
//! `args` is what the user may type; each command has its file in `commands`; the crate `wisch_io` reads
//! and writes files; `records` is what `--json` prints; `output` puts results on the disk.

mod args;
mod commands;
mod failure;
mod progress;
mod terminal;

use std::process::ExitCode;

fn main() -> ExitCode {
    terminal::run(|| {
        let cli = args::Cli::read().unwrap_or_else(|error| terminal::refuse(&error));
        terminal::prepare(&cli.global)?;
        commands::run(&cli)
    })
}
