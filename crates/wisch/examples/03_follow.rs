//! Follow the plan with your own robot, and check the motion.
//!
//! An SRDF beside the URDF states which group of joints wipes and where it starts.
//!
//! ```text
//! cargo run -p wisch --example 03_follow
//! ```

use std::error::Error;
use wisch::run::{NoExecutor, Stage, ignore_events};
use wisch_io::{LoadOptions, Robot, load_task};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);
const URDF: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/arm7.urdf");

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let robot = Robot::load(URDF)?;
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session.run_until(Stage::Audited, &mut NoExecutor, &mut ignore_events)?;

    let (planned, audit) = session.first_motion().ok_or("there is no motion")?;
    let followed = &planned.followed;
    println!(
        "{} wipes for {:.0} s",
        robot.model.name(),
        followed.contact_time()
    );
    println!("{} nodes abandoned", followed.abandoned.len());
    println!("clearance {:.0} mm", 1e3 * audit.min_clearance);
    println!("the check finds {} faults", audit.faults.len());
    Ok(())
}
