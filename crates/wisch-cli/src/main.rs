//! The program `wisch`: plan, predict and report robotic wiping from the command line.
//!
//! `args` is what the user may type; each command has its file in `commands`; `assets` reads files
//! and the built-in knowledge; `records` are the files' contents; `output` puts them on the disk.

mod args;
mod assets;
mod commands;
mod failure;
mod output;
mod progress;
mod records;
mod robots;
mod terminal;
mod workplace;

use std::process::ExitCode;

fn main() -> ExitCode {
    terminal::run(|| {
        let cli = args::Cli::read();
        terminal::prepare(&cli.global)?;
        commands::run(&cli)
    })
}
