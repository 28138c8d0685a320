//! The simulated world of a task, and its robot.

use wisch_io::{LoadedTask, Robot};
use wisch_sim::{Dirt, WorkSurface, World};

/// A simulated world before wiping.
pub(crate) struct SimulatedWorld {
    pub(crate) world: World,
    /// True dirt locations.
    pub(crate) dirt: Dirt,
}

impl SimulatedWorld {
    /// Draws the world of a task with the task's seed.
    pub(crate) fn draw(loaded: &LoadedTask) -> Result<Self, String> {
        let settings = loaded.simulation.clone();
        let (site, seed) = (WorkSurface::from_task(&loaded.task), loaded.task.seed);
        Ok(Self {
            dirt: Dirt::draw(&site, &settings, seed).map_err(format_error)?,
            world: World::new(&site, settings, seed).map_err(format_error)?,
        })
    }
}

/// Returns the robot of a task, or a message without a robot.
pub(crate) fn read_robot(loaded: &LoadedTask) -> Result<Robot, String> {
    let robot = loaded.robot().map_err(format_error)?;
    robot.ok_or_else(|| "the scenario has no robot".to_owned())
}

pub(crate) fn format_error(error: impl std::fmt::Display) -> String {
    error.to_string()
}
