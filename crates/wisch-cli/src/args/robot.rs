//! Arguments of `robot`.

use super::package;
use clap::{Args, Subcommand, ValueHint};
use std::path::PathBuf;
use wisch::robot::MapConfig;

/// What to do with a robot.
#[derive(Debug, Subcommand)]
pub enum RobotCommand {
    /// Check a URDF, and the SRDF with it, for what is missing or inconsistent
    #[command(after_help = "\
Examples:
  wisch robot check robots/humanoid.urdf
  wisch robot check arm.urdf --package arm_description=../arm_description
  wisch robot check arm.urdf --srdf config/arm.srdf
  wisch robot check arm.urdf --json | jq '.findings[] | select(.severity == \"warning\")'

Exit codes: 0 fine (notes at most), 1 warnings that matter, 2 no robot can be made of it.")]
    Check(RobotCheckArgs),
    /// Build a capability map: which poses an arm reaches, by voxel and direction
    #[command(after_help = "\
Examples:
  wisch robot map humanoid
  wisch robot map my_robot.urdf --group manipulator --out my_robot.reach

The map is used for base placement. Beside the URDF, with its name and the ending .reach, it is found
automatically; elsewhere, --map names it. It is bound to this very robot: rebuild it after changing the
robot.")]
    Map(RobotMapArgs),
}

/// Arguments of `robot map`.
#[derive(Debug, Args)]
pub struct RobotMapArgs {
    /// Shipped robot (humanoid, arm7, arm6), or a URDF
    #[arg(value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: String,
    /// Planning group of the SRDF to map [default: the first]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Voxel size [m], 0.001 to 10
    #[arg(long, value_name = "METRES", default_value_t = MapConfig::default().voxel, allow_negative_numbers = true)]
    pub voxel_m: f64,
    /// Number of random configurations to sample
    #[arg(long, value_name = "N", default_value_t = MapConfig::default().samples)]
    pub samples: u64,
    /// File to write, ending in .reach [default: beside the URDF; of a shipped robot, the working
    /// directory]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
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
    /// SRDF to check with it [default: the one beside the URDF that has its name, if there is one]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub srdf: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object instead of the report
    #[arg(long)]
    pub json: bool,
}
