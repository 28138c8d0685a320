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
    let file = &loaded.file;
    let robot = file.robot();
    RunConfig {
        plan: loaded.config.clone(),
        variants: file.plan_variants(),
        workcell: WorkcellConfig {
            group: robot.and_then(|robot| robot.group.clone()),
            second_group: robot.and_then(|robot| robot.second_group.clone()),
            world_from_robot: robot.and_then(|robot| robot.world_from_robot),
            ..WorkcellConfig::default()
        },
        target: file.target_performance(),
        max_rounds: file.max_rounds(),
        after_stop: AfterStop::Retreat,
        ..RunConfig::default()
    }
}
