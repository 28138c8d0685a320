//! The scenarios and the robots of the repository.

use std::error::Error;
use std::path::{Path, PathBuf};
use wisch::robot::{CapabilityMap, RobotModel, Srdf};
use wisch::run::Performer;
use wisch_io::RobotDescription;

/// What can go wrong in an example.
pub type AnyError = Box<dyn Error + Send + Sync>;

/// The scenarios of the paper's Table 1.
pub const TABLE_1: [&str; 3] = ["chopping-board", "table", "windshield"];

/// The repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The task file of a shipped scenario, to be loaded by [`wisch_io::load_task`].
pub fn scenario(name: &str) -> PathBuf {
    root().join(format!("scenarios/{name}.toml"))
}

/// A shipped robot.
pub struct ShippedRobot {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub model: RobotModel,
    /// Its groups and postures.
    pub srdf: Srdf,
    /// What its arm reaches, if its base moves.
    pub map: Option<CapabilityMap>,
}

impl ShippedRobot {
    /// The robot as a session takes it.
    pub const fn performer(&self) -> Performer<'_> {
        Performer {
            robot: &self.model,
            srdf: Some(&self.srdf),
            map: self.map.as_ref(),
        }
    }
}

/// The shipped robots: arm7, arm6, humanoid.
///
/// # Panics
/// When what is shipped cannot be read.
pub fn robots() -> [ShippedRobot; 3] {
    ["arm7", "arm6", "humanoid"].map(robot)
}

/// The mobile humanoid.
///
/// # Panics
/// When what is shipped cannot be read.
pub fn humanoid() -> ShippedRobot {
    robot("humanoid")
}

pub(crate) fn robot(name: &'static str) -> ShippedRobot {
    let description = RobotDescription::Named(name.to_owned());
    let robot = wisch_io::Robot::read(&description, Path::new(""), None, &[]);
    let robot = robot.expect("what is shipped can be read");
    ShippedRobot {
        name,
        srdf: robot.srdf.expect("groups and postures are shipped"),
        model: robot.model,
        map: robot.map,
    }
}
