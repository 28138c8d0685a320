//! The program `wisch-ros2`.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    wisch_ros2::run(wisch_ros2::ProgramLine::parse())
}
