//! Load a task and print its contents.
//!
//! ```text
//! cargo run -p wisch --example 01_load
//! ```

use std::error::Error;
use wisch_io::{LoadOptions, load_task};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let task = &loaded.task;
    let (action, medium, tool) = (task.action, &task.medium, &task.tool.name);
    println!(
        "{}: {action} {medium} on {} with a {tool}",
        task.name, task.surface.name
    );
    println!("{} particles are on it", task.particles.len());
    println!("press with {} N", task.interaction.press_force_n);
    println!("target {:.0} %", 100.0 * loaded.run.target);
    Ok(())
}
