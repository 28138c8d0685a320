//! The scenarios and the robots of the repository.

use std::error::Error;
use std::path::{Path, PathBuf};
use wisch::robot::{CapabilityMap, RobotModel, Srdf};
use wisch::run::RobotSetup;
use wisch_io::RobotDescription;

/// The error type of tests and examples: any error.
pub type AnyError = Box<dyn Error + Send + Sync>;

/// The scenarios of the paper's Table 1.
pub const TABLE_1: [&str; 3] = ["chopping-board", "table", "windshield"];

/// Returns the path of the repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns the task file of a shipped scenario, for [`wisch_io::load_task`].
pub fn scenario(name: &str) -> PathBuf {
    root().join(format!("scenarios/{name}.toml"))
}

/// A shipped robot, read from its URDF and SRDF.
pub struct ShippedRobot {
    /// Its name.
    pub name: &'static str,
    /// Its model.
    pub model: RobotModel,
    /// Its groups and postures.
    pub srdf: Srdf,
    /// Its capability map, if its base moves.
    pub map: Option<CapabilityMap>,
}

impl ShippedRobot {
    /// The robot setup for a session.
    pub const fn robot_setup(&self) -> RobotSetup<'_> {
        RobotSetup {
            robot: &self.model,
            srdf: Some(&self.srdf),
            map: self.map.as_ref(),
        }
    }
}

/// Returns the shipped robots: arm7, arm6, humanoid.
///
/// # Panics
/// If a shipped file cannot be read.
pub fn robots() -> [ShippedRobot; 3] {
    ["arm7", "arm6", "humanoid"].map(robot)
}

/// Returns the mobile humanoid.
///
/// # Panics
/// If a shipped file cannot be read.
pub fn humanoid() -> ShippedRobot {
    robot("humanoid")
}

pub(crate) fn robot(name: &'static str) -> ShippedRobot {
    let description = RobotDescription::Named(name.to_owned());
    let robot = wisch_io::Robot::read(&description, Path::new(""), None, &[]);
    let robot = robot.expect("the shipped files can be read");
    ShippedRobot {
        name,
        srdf: robot.srdf.expect("groups and postures are shipped"),
        model: robot.model,
        map: robot.map,
    }
}
