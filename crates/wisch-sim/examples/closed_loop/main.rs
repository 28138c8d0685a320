//! The closed loop on shipped scenarios: what each round was predicted, estimated and really to achieve.
//!
//! ```text
//! cargo run --release --package wisch-sim --example closed_loop -- [scenario ...] [--seeds N] [--first-seed N]
//! ```

use std::ops::ControlFlow;
use std::time::Instant;
use wisch::interpret::EventKind;
use wisch::run::{PlannedRound, Round, RunEvent, Session};
use wisch_io::load_task;
use wisch_sim::{GroundTruth, SimulationSettings, Site, World};
use wisch_testkit::{AnyError, Robot, by_density, humanoid, run_config, scenario};

const SCENARIOS: [&str; 3] = [
    "chopping-board",
    "failure-tilted-table",
    "failure-human-push",
];

fn main() -> Result<(), AnyError> {
    let mut names = Vec::new();
    let (mut seeds, mut first) = (5, 1);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--seeds" => seeds = arguments.next().unwrap_or_default().parse()?,
            "--first-seed" => first = arguments.next().unwrap_or_default().parse()?,
            _ => names.push(argument),
        }
    }
    if names.is_empty() {
        names.extend(SCENARIOS.map(str::to_owned));
    }
    let robot = humanoid();
    println!(
        "{:22} {:>4} {:>5} {:>6} {:>6} {:>15} {:>6} {:>6} {:>7} {:>6} {:>6} {:>6} {:>5} {:>6} {:>5} verdict",
        "",
        "seed",
        "round",
        "pred %",
        "est %",
        "90 %",
        "true %",
        "diff",
        "contact",
        "tilt°",
        "off mm",
        "F N",
        "s",
        "xreal",
        "coll"
    );
    for name in &names {
        let (mut errors, mut held, mut count) = (Vec::new(), 0, 0);
        for seed in first..first + seeds {
            let lines = trial(name, seed, &robot)?;
            for (error, is_held) in lines.into_iter().flatten() {
                errors.push(error);
                held += usize::from(is_held);
                count += 1;
            }
        }
        if count > 0 {
            let mean = errors.iter().sum::<f64>() / count as f64;
            let worst = errors.iter().copied().fold(0.0, f64::max);
            println!(
                "{name}: |estimated - true| {mean:.1} points on average, {worst:.1} at worst; interval holds the truth in {held} of {count}"
            );
        }
    }
    Ok(())
}

fn trial(name: &str, seed: u64, robot: &Robot) -> Result<Vec<Option<(f64, bool)>>, AnyError> {
    let loaded = load_task(&scenario(name), &by_density(seed))?;
    let task = &loaded.task;
    let reality = SimulationSettings::of(&loaded)?;
    let mut begin = Instant::now();
    let mut seconds = Vec::new();
    let mut world = World::new(&Site::of(task), reality, task.seed)?;
    let session = Session::new(task, run_config(&loaded)).with_belief(loaded.belief());
    let mut session = session.with_robot(robot.performer());
    session.run(&mut world, &mut |event| {
        match event {
            RunEvent::Executing(_) => begin = Instant::now(),
            RunEvent::Interpreting { .. } => seconds.push(begin.elapsed().as_secs_f64()),
            _ => (),
        }
        ControlFlow::Continue(())
    })?;
    (session.rounds().iter())
        .zip(world.truth())
        .zip(&seconds)
        .map(|((round, truth), &seconds)| line(name, seed, round, truth, seconds))
        .collect()
}

fn line(
    name: &str,
    seed: u64,
    round: &Round,
    world: &GroundTruth,
    seconds: f64,
) -> Result<Option<(f64, bool)>, AnyError> {
    let told = &round.interpretation;
    let estimate = &told.performance;
    let collisions: Vec<String> = (told.events.iter())
        .filter(|event| event.kind == EventKind::Collision)
        .map(|event| format!("{:.2}-{:.2}", event.start, event.end))
        .collect();
    let PlannedRound { plan, task, .. } = &round.motion;
    let truth = world.performance(&plan.graph.goal, &task.surface)?;
    let plane = told.plane;
    println!(
        "{name:22} {seed:4} {:5} {:6.1} {:6.1} {:>15} {:>6} {:>6} {:7.2} {:>6} {:>6} {:6.2} {:5.1} {:6.1} {:5} {} {}",
        round.motion.number,
        100.0 * round.motion.prediction.performance.ratio(),
        100.0 * estimate.mean,
        format!(
            "{:.1} to {:.1}",
            100.0 * estimate.low,
            100.0 * estimate.high
        ),
        truth.map_or("-".to_owned(), |t| format!("{:.1}", 100.0 * t)),
        truth.map_or("-".to_owned(), |t| format!(
            "{:+.1}",
            100.0 * (estimate.mean - t)
        )),
        told.contact_share,
        plane.map_or("-".to_owned(), |p| format!("{:.2}", p.tilt.to_degrees())),
        plane.map_or("-".to_owned(), |p| format!("{:.1}", 1e3 * p.offset)),
        world.contact_force.mean(),
        round.execution.duration,
        round.execution.duration / seconds,
        collisions.len(),
        round.verdict.as_str(),
        collisions.join(" "),
    );
    Ok(truth.map(|truth| {
        let is_held = (estimate.low..=estimate.high).contains(&truth);
        (100.0 * (estimate.mean - truth).abs(), is_held)
    }))
}
