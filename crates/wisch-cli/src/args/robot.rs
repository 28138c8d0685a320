//! Arguments of `robot`.

use super::package;
use clap::{Args, Subcommand, ValueHint};
use std::path::PathBuf;
use wisch::robot::MapConfig;

/// What to do with a robot.
#[derive(Debug, Subcommand)]
pub enum RobotCommand {
    /// Report what is missing or odd in a robot's URDF
    #[command(after_help = "\
Examples:
  wisch robot check robots/humanoid.urdf
  wisch robot check arm.urdf --package arm_description=../arm_description
  wisch robot check arm.urdf --json | jq '.findings[] | select(.severity == \"warning\")'

Exit codes: 0 fine (notes at most), 1 warnings that matter, 2 no robot can be made of it.")]
    Check(RobotCheckArgs),
    /// Build the capability map of a robot: what its arm can reach, in voxels and directions
    #[command(after_help = "\
Examples:
  wisch robot map humanoid
  wisch robot map my_robot.urdf --group manipulator --out my_robot.reach

The map is used to find where a mobile base should stand. Beside the URDF, with its name and the
ending .reach, it is found by itself; elsewhere, --map names it. It belongs to this very robot: change
the robot, and build it anew.")]
    Map(RobotMapArgs),
}

/// Arguments of `robot map`.
#[derive(Debug, Args)]
pub struct RobotMapArgs {
    /// A robot that is shipped, or a URDF
    #[arg(value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: String,
    /// The group of the robot's SRDF that reaches [default: the first]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Edge of a voxel [m], 0.001 to 10
    #[arg(long, value_name = "METRES", default_value_t = MapConfig::default().voxel, allow_negative_numbers = true)]
    pub voxel_m: f64,
    /// Random postures that are looked at
    #[arg(long, value_name = "N", default_value_t = MapConfig::default().samples)]
    pub samples: u64,
    /// Where to write it, a file that ends in .reach [default: beside the URDF; of a robot that is
    /// shipped, here]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// Where the files of package://NAME are; may be given more than once
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `robot check`.
#[derive(Debug, Args)]
pub struct RobotCheckArgs {
    /// The robot's URDF; xacro files are to be expanded first
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Where the files of package://NAME are; may be given more than once
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}
