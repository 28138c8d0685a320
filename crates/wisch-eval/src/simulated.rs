//! The simulated world that a task describes, and the robot that wipes in it.

use wisch_io::{LoadedTask, Robot};
use wisch_sim::{Dirt, SimulationSettings, Site, World};

/// A world before anything is wiped in it.
pub(crate) struct SimulatedWorld {
    pub(crate) world: World,
    /// Where the dirt really lies.
    pub(crate) dirt: Dirt,
}

impl SimulatedWorld {
    /// The world of a task, drawn by the task's seed.
    pub(crate) fn of(loaded: &LoadedTask) -> Result<Self, String> {
        let settings = SimulationSettings::of(loaded).map_err(words)?;
        let (site, seed) = (Site::of(&loaded.task), loaded.task.seed);
        Ok(Self {
            dirt: Dirt::draw(&site, &settings, seed).map_err(words)?,
            world: World::new(&site, settings, seed).map_err(words)?,
        })
    }
}

/// The robot of a task, which has to have one.
pub(crate) fn robot_of(loaded: &LoadedTask) -> Result<Robot, String> {
    let robot = loaded.robot().map_err(words)?;
    robot.ok_or_else(|| "the scenario has no robot".to_owned())
}

pub(crate) fn words(error: impl std::fmt::Display) -> String {
    error.to_string()
}
