//! Arguments of `robot`.

use super::values::{parse_package, parse_setting};
use clap::{Args, Subcommand, ValueHint};
use std::path::PathBuf;
use wisch::robot::MapConfig;

/// The subcommands of `robot`.
#[derive(Debug, Subcommand)]
pub enum RobotCommand {
    /// Check a URDF and its SRDF for missing or inconsistent data
    #[command(after_help = "\
Examples:
  wisch robot check robots/humanoid.urdf
  wisch robot check arm.urdf --package arm_description=../arm_description
  wisch robot check arm.urdf --srdf config/arm.srdf
  wisch robot check arm.urdf --json | jq '.findings[] | select(.severity == \"warning\")'

Exit codes: 0 no warnings, 1 warnings, 2 errors.")]
    Check(RobotCheckArgs),
    /// Build a capability map: the poses that an arm reaches, by voxel and direction
    #[command(after_help = "\
Examples:
  wisch robot map humanoid
  wisch robot map my_robot.urdf --group manipulator --out my_robot.reach

wisch uses the map for base placement. It finds a map beside the URDF with the same name and the ending \
.reach; the option --map of other commands names another file. A map is valid for one robot: rebuild it after changing the \
robot.")]
    Map(RobotMapArgs),
    /// Write the SRDF of a robot that has only a URDF: groups, a ready posture, and pairs of links that need no collision check
    #[command(after_help = "\
Examples:
  wisch robot setup my_robot.urdf
  wisch robot setup arm.urdf --tip tool0 --package arm_description=../arm_description
  wisch robot setup arm.urdf --task board.toml --force
  wisch robot setup pr2.urdf --mobile

wisch finds the arms by their chains of joints and the names of their links. From random postures it finds \
the pairs of links that need no collision check, and a ready posture: without self-collision, away from limits, \
with high manipulability, and with the tool pointing down in front of the robot or at the task's surface. \
Comments in the file state what was chosen and why.

Exit codes: 0 the SRDF is written, 1 no arm or no collision-free posture was found and nothing is \
written, 2 an error.")]
    Setup(RobotSetupArgs),
    /// Show what a ROS 2 robot reports, and what forbids a motion; sends no command
    #[command(after_help = "\
Examples:
  wisch robot doctor ur5e.toml

The robot file states topics, services and limits; docs/ros2.md describes it. Needs the companion program \
wisch-ros2, as do push-test and fake.

Exit codes: 0 nothing forbids a motion, 1 something forbids a motion, 2 an error, such as a robot that is not found.")]
    Doctor(RobotDoctorArgs),
    /// Test sign and axes of a ROS 2 robot's force by hand; writes ROBOT.commissioned.toml, which `wisch run --on` requires
    #[command(after_help = "\
Examples:
  wisch robot push-test ur5e.toml

The robot does not move. You push the tool in two directions.

Exit codes: 0 the file is written, 2 an error; then nothing is written.")]
    PushTest(RobotPushTestArgs),
    /// Simulate a ROS 2 robot and the dirt of a task, behind the robot's topics, services and action
    #[command(after_help = "\
Examples:
  wisch robot fake arm-board --as arm7.toml

The simulation runs in real time until it reads the command quit from its standard input. Other commands push the \
tool or cause faults: wisch-ros2 fake --help lists them.")]
    Fake(RobotFakeArgs),
}

/// Arguments of `robot doctor`.
#[derive(Debug, Args)]
pub struct RobotDoctorArgs {
    /// The robot file
    #[arg(value_name = "ROBOT.toml", value_hint = ValueHint::FilePath)]
    pub robot: PathBuf,
}

/// Arguments of `robot push-test`.
#[derive(Debug, Args)]
pub struct RobotPushTestArgs {
    /// The robot file
    #[arg(value_name = "ROBOT.toml", value_hint = ValueHint::FilePath)]
    pub robot: PathBuf,
    /// Do not wait for the Enter key
    #[arg(long)]
    pub yes: bool,
}

/// Arguments of `robot fake`.
#[derive(Debug, Args)]
pub struct RobotFakeArgs {
    /// Task file, or name of a shipped scenario
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// Robot file of the robot to simulate
    #[arg(long = "as", value_name = "ROBOT.toml", value_hint = ValueHint::FilePath)]
    pub robot: PathBuf,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub settings: Vec<String>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
}

/// Arguments of `robot setup`.
#[derive(Debug, Args)]
pub struct RobotSetupArgs {
    /// URDF of the robot; expand xacro files first
    #[arg(value_name = "URDF", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Link that holds the tool; repeatable, one for each arm [default: found by its name and its joints]
    #[arg(long = "tip", value_name = "LINK")]
    pub tips: Vec<String>,
    /// Declare that the robot's base drives, if the URDF has no joints for that
    #[arg(long)]
    pub mobile: bool,
    /// Task for which the ready posture is chosen: with its tool, over its surface, clear of its scene
    #[arg(long, value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: Option<PathBuf>,
    /// Override a value of the task, such as robot.position_m=[0,-0.6,0]; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting, requires = "task")]
    pub settings: Vec<(String, String)>,
    /// Seed of the random postures
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// File to write, ending in .srdf [default: beside the URDF with the same name, where wisch finds it]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long)]
    pub force: bool,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = parse_package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `robot map`.
#[derive(Debug, Args)]
pub struct RobotMapArgs {
    /// Shipped robot (humanoid, arm7, arm6), or URDF file
    #[arg(value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: String,
    /// SRDF planning group to map [default: the first group]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Voxel size [m], 0.001 to 10
    #[arg(long, value_name = "METRES", default_value_t = MapConfig::default().voxel, allow_negative_numbers = true)]
    pub voxel_m: f64,
    /// Number of random configurations to sample
    #[arg(long, value_name = "N", default_value_t = MapConfig::default().samples)]
    pub samples: u64,
    /// File to write, ending in .reach [default: beside the URDF; for a shipped robot, in the working
    /// directory]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = parse_package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `robot check`.
#[derive(Debug, Args)]
pub struct RobotCheckArgs {
    /// URDF to check; expand xacro files first
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// SRDF to check with the URDF [default: the file beside the URDF with the same name, if it exists]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub srdf: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = parse_package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}
