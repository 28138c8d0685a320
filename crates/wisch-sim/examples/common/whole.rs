//! How the examples run the whole loop.

use wisch::follow::WorkcellConfig;
use wisch::plan::{CoverageStrategy, PlanConfig};
use wisch::run::RunConfig;
use wisch_io::TaskFile;

/// As `wisch run` does it, with plans by density.
pub fn run_config(file: &TaskFile, seed: u64) -> RunConfig {
    let robot = file.robot();
    RunConfig {
        plan: PlanConfig {
            strategy: CoverageStrategy::Kde,
            seed,
            bandwidth: file.bandwidth_m(),
            lift_height: file.lift_height_m(),
        },
        variants: file.plan_variants(),
        workcell: WorkcellConfig {
            group: robot.and_then(|robot| robot.group.clone()),
            second_group: robot.and_then(|robot| robot.second_group.clone()),
            world_from_robot: robot.and_then(|robot| robot.world_from_robot),
            ..WorkcellConfig::default()
        },
        target: file.target_performance(),
        max_rounds: file.max_rounds(),
        ..RunConfig::default()
    }
}
