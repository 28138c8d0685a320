//! The humanoid of the repository, for the examples.

use super::shipped::{AnyError, text};
use std::path::Path;
use wisch::robot::{CapabilityMap, RobotHash, RobotModel, Srdf};

/// A robot as the repository ships it.
pub struct Robot {
    /// The robot.
    pub model: RobotModel,
    /// Its groups and states.
    pub srdf: Srdf,
    /// What it reaches, if that was computed.
    pub map: Option<CapabilityMap>,
}

/// The mobile humanoid.
pub fn humanoid(folder: &Path) -> Result<Robot, AnyError> {
    let urdf = text(&folder.join("humanoid.urdf"))?;
    let mut no_meshes = |file: &str| Err(format!("{file}: there are no meshes"));
    let model = RobotModel::from_urdf("humanoid.urdf", &urdf, &mut no_meshes)?;
    let srdf = Srdf::parse(
        "humanoid.srdf",
        &text(&folder.join("humanoid.srdf"))?,
        &model,
    )?;
    let map = match std::fs::read(folder.join("humanoid.reach")) {
        Ok(bytes) => Some(CapabilityMap::from_bytes(
            "humanoid.reach",
            &bytes,
            RobotHash::of(&model),
        )?),
        Err(_) => None,
    };
    Ok(Robot { model, srdf, map })
}
