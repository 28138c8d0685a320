//! Configurations of the whole loop for tests and examples.

use wisch::follow::WorkcellConfig;
use wisch::plan::CoverageStrategy;
use wisch::run::{AfterStop, RunConfig};
use wisch_io::{LoadOptions, LoadedTask};

/// Returns load options for a scenario with a seed, and plans by density.
pub fn by_density(seed: u64) -> LoadOptions {
    LoadOptions {
        strategy: Some(CoverageStrategy::Kde.into()),
        seed: Some(seed),
        ..LoadOptions::default()
    }
}

/// Returns the configuration that `wisch run` uses.
pub fn run_config(loaded: &LoadedTask) -> RunConfig {
    let (run, robot) = (&loaded.run, loaded.file.robot.as_ref());
    RunConfig {
        plan: run.plan.clone(),
        variants: run.variants,
        workcell: WorkcellConfig {
            world_from_robot: robot.and_then(|robot| robot.world_from_robot),
            ..run.workcell.clone()
        },
        target: run.target,
        max_rounds: run.max_rounds,
        after_stop: AfterStop::Retreat,
        ..RunConfig::default()
    }
}
