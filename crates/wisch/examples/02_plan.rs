//! Plan a task, and predict what the plan does to the dirt.
//!
//! ```text
//! cargo run -p wisch --example 02_plan
//! ```

use std::error::Error;
use wisch::plan::predict;
use wisch::run::{NoExecutor, Stage, ignore_events};
use wisch_io::{LoadOptions, load_task};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let mut session = loaded.session();
    session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;

    let plan = session.plan().ok_or("there is no plan")?;
    let (strokes, way) = (plan.strokes.len(), plan.contact_distance());
    println!("{} places {strokes} strokes, {way:.2} m", plan.strategy);

    let prediction = predict(&loaded.task, plan, |_| ());
    let collected = 100.0 * prediction.performance.ratio();
    println!("{collected:.0} % are predicted to be collected");
    Ok(())
}
