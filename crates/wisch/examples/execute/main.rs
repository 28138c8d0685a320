//! Executes one scenario in the physics world and prints what really happened: forces, distances, dirt.
//!
//! ```text
//! cargo run --release --package wisch --example execute -- [scenario, default chopping-board] [seed, default 1]
//! ```

#[path = "../shipped/robot.rs"]
mod robot;
#[path = "../shipped/mod.rs"]
mod shipped;

use robot::humanoid;
use shipped::{AnyError, knowledge, scenario, task};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;
use wisch::execute::{Dirt, ExecuteConfig, execute};
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan, predict};
use wisch::represent::{Intent, Performance};

fn main() -> Result<(), AnyError> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments
        .next()
        .unwrap_or_else(|| "chopping-board".to_owned());
    let seed: u64 = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let log = arguments.next();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let knowledge = knowledge(&root.join("knowledge"))?;
    let robot = humanoid(&root.join("robots"))?;
    let file = scenario(&root.join(format!("scenarios/{name}.toml")))?;
    let Intent::Action { action, .. } = file.intent() else {
        return Err(format!("{name} names no action").into());
    };
    let task = task(&file, *action, seed, &knowledge, &root)?;
    let reality = file.reality(&task, &knowledge)?;
    let config = PlanConfig {
        strategy: CoverageStrategy::Kde,
        seed,
        bandwidth: file.bandwidth_m(),
        lift_height: file.lift_height_m(),
    };
    let plan = plan(&task, &config)?;
    let cell_config = WorkcellConfig {
        world_from_robot: file.robot().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(robot.model.clone(), Some(&robot.srdf), &task, &cell_config)?;
    let followed = follow(
        &task,
        &plan,
        &cell,
        robot.map.as_ref(),
        &FollowConfig::default(),
        &mut |_| (),
    )?;
    let wiped = Plan {
        strokes: followed.strokes.clone(),
        ..plan.clone()
    };
    let predicted = predict(&task, &wiped, |_| ());

    let dirt = Dirt::scatter(&task.particles, &reality, seed);
    let begin = Instant::now();
    let mut lines = String::from("t,phase,px,py,pz,cx,cy,cz,fx,fy,fz,ex,ey,ez\n");
    let executed = execute(
        &task,
        &cell,
        &followed,
        &reality,
        &dirt,
        &ExecuteConfig::default(),
        &mut |s| {
            if log.is_some() {
                use std::fmt::Write;
                let (p, c) = (
                    s.world_from_tool.translation,
                    s.world_from_commanded.translation,
                );
                let (f, e) = (s.controller.force, s.external.force);
                let _ = writeln!(
                    lines,
                    "{:.3},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                    s.time,
                    s.phase.as_str(),
                    p.x,
                    p.y,
                    p.z,
                    c.x,
                    c.y,
                    c.z,
                    f.x,
                    f.y,
                    f.z,
                    e.x,
                    e.y,
                    e.z
                );
            }
            ControlFlow::Continue(())
        },
    )?;
    if let Some(log) = log {
        std::fs::write(log, lines)?;
    }
    let seconds = begin.elapsed().as_secs_f64();
    let truth = &executed.truth;
    let performance = Performance::of(&truth.dirt.particles()?, &plan.graph.goal, &task.surface);
    println!(
        "executed {:.1} s in {seconds:.1} s: {:.1} times real time",
        executed.duration,
        executed.duration / seconds
    );
    println!(
        "predicted {:.1} %, true {:.1} %",
        100.0 * predicted.performance.ratio(),
        100.0 * performance.ratio()
    );
    println!(
        "contact force {:.2} +- {:.2} N, lost {:.1} %",
        truth.contact_force.mean(),
        truth.contact_force.deviation(),
        100.0 * truth.lost_share
    );
    println!(
        "tool within {:.2} mm of the plane, {:.2} mm of its line; f_c at most {:.2} N",
        1e3 * truth.max_plane_distance,
        1e3 * truth.max_lateral_error,
        truth.max_controller_force
    );
    Ok(())
}
