//! Interpret a bag of poses and forces, and plan the next round from the result.
//!
//! Any bag with a pose and a force is suitable; this one is of a sponge that moves once over the
//! board.
//!
//! ```text
//! cargo run -p wisch --example 05_interpret
//! ```

use std::error::Error;
use wisch::follow::Phase;
use wisch::geometry::Pose;
use wisch::interpret::{Belief, InterpretConfig, TouchSample, interpret};
use wisch::plan::plan;
use wisch::recover::next_task;
use wisch::run::TelemetrySample;
use wisch_io::{LoadOptions, load_task};
use wisch_telemetry::{BagHead, BagWriter, LogOptions, read};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let (task, board) = (&loaded.task, loaded.task.surface.world_from_surface);
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("wipe.mcap");
    let mut bag = BagWriter::create(&file, BagHead::from_surface_pose(board))?;
    for k in 0..2000 {
        let time = f64::from(k) * 1e-3;
        let world_from_tool = board * Pose::translation(0.1 * time - 0.1, -0.06, 0.0);
        let touch = TouchSample::new(time, world_from_tool, task.surface_reaction());
        bag.write(&TelemetrySample::from_touch(&touch, 0, Phase::Wipe(0)))?;
    }
    bag.finish()?;

    let log = read(&file, &LogOptions::default())?;
    let goal = task.goal().ok_or("the task leaves its goal open")?;
    let believed = Belief::from_particles(task.particles.clone());
    let config = InterpretConfig::from_task(task);
    let estimate = interpret(&log.samples, task, &believed, &goal, &config)?;
    println!("{:.0} % are at the goal", 100.0 * estimate.performance.mean);

    let next = next_task(task, &goal, &estimate, task.seed + 1)?;
    let way = plan(&next, &loaded.run.plan)?.contact_distance();
    println!("the next round wipes {way:.2} m");
    Ok(())
}
