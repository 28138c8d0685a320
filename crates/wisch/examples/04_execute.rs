//! Run the whole loop with your own executor: a robot whose tool follows the plan exactly.
//!
//! An executor for a real robot would send the setpoints to its controller, and return the
//! measurements.
//!
//! ```text
//! cargo run -p wisch --example 04_execute
//! ```

use std::error::Error;
use wisch::interpret::TouchSample;
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, SampleSink, ignore_events};
use wisch_io::{LoadOptions, load_task};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);

struct Exact;

impl Executor for Exact {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        Ok(order.play(0.01, sink, |at| {
            let force = order.task.surface_reaction() * f64::from(at.phase.is_contact());
            TouchSample::new(at.time, at.world_from_tool, force)
        }))
    }
}

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let robot = loaded.robot()?.ok_or("the task names no robot")?;
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session.run(&mut Exact, &mut ignore_events)?;
    for round in session.rounds() {
        let estimate = 100.0 * round.interpretation.performance.mean;
        let (number, verdict) = (round.motion.number, round.verdict.as_str());
        println!("round {number}: {estimate:.0} % by touch, {verdict}");
    }
    Ok(())
}
