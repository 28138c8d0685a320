//! The command line of `wisch-ros2`.

use crate::drive::{DriveOptions, serve};
use crate::robot_file::{RobotFile, TEMPLATE};
use crate::{doctor, fake, guard, ping, push_test};
use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Exit code of an error.
const ERROR: u8 = 2;
/// Exit code of a doctor that found something that forbids a motion.
const REFUSED: u8 = 1;

/// Execute the motions of wisch on robots that speak ROS 2
#[derive(Debug, Parser)]
#[command(
    name = "wisch-ros2",
    version,
    after_help = "\
`wisch run TASK --on ROBOT.toml` and the commands `wisch robot doctor`, `push-test` and `fake` start this program.

Exit codes: 0 success, 1 the doctor found something that forbids a motion, 2 an error."
)]
pub struct ProgramLine {
    #[command(subcommand)]
    command: RobotLinkCommand,
}

#[derive(Debug, Subcommand)]
enum RobotLinkCommand {
    /// Execute motions that arrive on standard input, by the executor protocol
    Execute {
        /// The robot file
        #[arg(value_name = "ROBOT.toml")]
        robot: PathBuf,
        /// Share of the planned speed
        #[arg(long, value_name = "SHARE", default_value_t = 1.0, value_parser = speed)]
        speed: f64,
        /// Move above the surface, without force and without taring
        #[arg(long)]
        air: bool,
        /// Permit motions after a stop: an operator is asked before each motion that arrives
        #[arg(long)]
        operated: bool,
    },
    /// Show what the robot reports, and what forbids a motion; commands nothing
    Doctor {
        /// The robot file
        #[arg(value_name = "ROBOT.toml")]
        robot: PathBuf,
    },
    /// Test sign and axes of the measured force by hand, and write ROBOT.commissioned.toml
    PushTest {
        /// The robot file
        #[arg(value_name = "ROBOT.toml")]
        robot: PathBuf,
        /// Do not wait for the Enter key
        #[arg(long)]
        yes: bool,
    },
    /// Simulate the robot and the dirt of a task, behind the robot's topics, services and action
    #[command(after_help = fake::COMMANDS)]
    Fake {
        /// Task file, or name of a shipped scenario
        #[arg(value_name = "TASK")]
        task: PathBuf,
        /// The robot file
        #[arg(long = "as", value_name = "ROBOT.toml")]
        robot: PathBuf,
        /// Override a value of the task file; repeatable
        #[arg(long = "set", value_name = "KEY=VALUE")]
        settings: Vec<String>,
        /// Random seed [default: the task's]
        #[arg(long, value_name = "N")]
        seed: Option<u64>,
    },
    /// Print a commented robot file
    Template,
    /// Measure round trips over DDS to a program that sends each message back; peers/ros2/link.py is one
    #[command(hide = true)]
    Ping {
        /// The robot file, for its table [link]
        #[arg(value_name = "ROBOT.toml")]
        robot: PathBuf,
        /// Messages a second [Hz]
        #[arg(long, default_value_t = 1000.0, value_parser = positive)]
        rate: f64,
        /// Duration [s]
        #[arg(long, default_value_t = 8.0, value_parser = positive)]
        seconds: f64,
    },
    /// Cancel the robot's goal when standard input ends; another process of this program starts it
    #[command(hide = true)]
    Guard { robot: PathBuf },
}

fn speed(text: &str) -> Result<f64, String> {
    let speed = text.parse().ok();
    let is_share = |speed: &f64| *speed > 0.0 && *speed <= 1.0;
    speed
        .filter(is_share)
        .ok_or_else(|| "expected a number above 0 and at most 1".to_owned())
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok();
    let is_in_range = |number: &f64| *number > 0.0 && *number <= 1e4;
    number
        .filter(is_in_range)
        .ok_or_else(|| "expected a number above 0 and at most 10000".to_owned())
}

/// Runs a command, and returns its exit code.
pub fn run(cli: ProgramLine) -> ExitCode {
    match dispatch(cli.command) {
        Ok(code) => code,
        Err(text) => {
            eprintln!("error: {text}");
            ExitCode::from(ERROR)
        }
    }
}

fn dispatch(command: RobotLinkCommand) -> Result<ExitCode, String> {
    let read = |path: &PathBuf| RobotFile::read(path).map_err(|error| error.to_string());
    match command {
        RobotLinkCommand::Execute {
            robot,
            speed,
            air,
            operated,
        } => {
            let options = DriveOptions {
                speed,
                is_in_air: air,
                is_operated: operated,
            };
            serve(&robot, options);
        }
        RobotLinkCommand::Doctor { robot } => {
            if !doctor::examine(read(&robot)?)? {
                return Ok(ExitCode::from(REFUSED));
            }
        }
        RobotLinkCommand::PushTest { robot, yes } => push_test::test(read(&robot)?, !yes)?,
        RobotLinkCommand::Fake {
            task,
            robot,
            settings,
            seed,
        } => fake::simulate_robot(&task, &read(&robot)?, &settings, seed)?,
        RobotLinkCommand::Template => print!("{TEMPLATE}"),
        RobotLinkCommand::Ping {
            robot,
            rate,
            seconds,
        } => ping::measure(&read(&robot)?, rate, seconds)?,
        RobotLinkCommand::Guard { robot } => {
            guard::watch(&read(&robot)?).map_err(|error| error.to_string())?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
