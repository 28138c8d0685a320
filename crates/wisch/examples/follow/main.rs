//! The nine cells of the paper's Table 1, with KDE or another strategy, followed by the humanoid.
//! It prints the performance of the plan and of the strokes that the robot follows, the number of
//! abandoned nodes, the execution time beside that of the paper, and the duration of the
//! computation (§3.4).
//!
//! ```text
//! cargo run --release --package wisch --example follow -- [number of seeds, default 5] [first seed, default 1] [strategy, default kde]
//! ```
//!
//! Seeds run one after the other, so that the times of one cell are those of one run.

use std::time::Instant;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, audit, follow};
use wisch::plan::{CoverageStrategy, Plan, Strategy, predict};
use wisch::represent::Action;
use wisch::run::{NoExecutor, Session, Stage, ignore_events};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_testkit::{AnyError, ShippedRobot, TABLE_1, humanoid, scenario};

/// Table 1, KDE: action × scenario × (performance [%], execution time [s], computation time [s]).
const PAPER: [[[f64; 3]; 3]; 3] = [
    [
        [95.75, 27.71, 62.00],
        [70.50, 52.45, 169.92],
        [91.00, 66.11, 417.66],
    ],
    [
        [90.50, 43.28, 72.24],
        [41.75, 62.14, 270.56],
        [62.75, 97.56, 428.05],
    ],
    [
        [97.00, 45.81, 90.57],
        [53.00, 102.48, 275.58],
        [88.50, 96.03, 199.03],
    ],
];

/// Result of a trial.
struct Trial {
    performance: f64,
    planned: f64,
    nodes: usize,
    abandoned: usize,
    execution: f64,
    contact: f64,
    placements: usize,
    seconds: f64,
    off_line: f64,
    clearance: f64,
    faults: usize,
}

fn main() -> Result<(), AnyError> {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().map_or(Ok(5), |text| text.parse())?;
    let first: u64 = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let strategy: Strategy =
        (arguments.next()).map_or(Ok(CoverageStrategy::Kde.into()), |text| text.parse())?;
    if count == 0 {
        return Err("at least one seed is needed".into());
    }
    let robot = humanoid();
    println!("{strategy}, seeds {first} to {}", first + count - 1);
    println!(
        "{:18} {:>7} {:>7} {:>7} {:>9} {:>7} {:>7} {:>8} {:>6} {:>7} {:>7} {:>7} {:>7} {:>6}",
        "",
        "perf %",
        "planned",
        "paper",
        "abandoned",
        "exec s",
        "paper",
        "contact",
        "places",
        "comp s",
        "worst s",
        "off mm",
        "clear mm",
        "faults"
    );
    let mut all: Vec<Trial> = Vec::new();
    for (a, action) in Action::WIPING.into_iter().enumerate() {
        for (s, name) in TABLE_1.into_iter().enumerate() {
            let mut trials = Vec::new();
            for seed in first..first + count {
                let options = LoadOptions {
                    action: Some(action),
                    strategy: Some(strategy),
                    seed: Some(seed),
                    ..LoadOptions::default()
                };
                trials.push(trial(&load_task(&scenario(name), &options)?, &robot)?);
            }
            let mean = |of: &dyn Fn(&Trial) -> f64| {
                trials.iter().map(of).sum::<f64>() / trials.len() as f64
            };
            let most = |of: &dyn Fn(&Trial) -> f64| {
                trials.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
            };
            println!(
                "{action:7} {:10} {:7.2} {:7.2} {:7.2} {:4}/{:4} {:7.1} {:7.1} {:8.1} {:6.1} {:7.2} {:7.2} {:7.2} {:7.1} {:6}",
                name.trim_start_matches("chopping-"),
                mean(&|t| t.performance),
                mean(&|t| t.planned),
                PAPER[a][s][0],
                trials.iter().map(|t| t.abandoned).sum::<usize>(),
                trials.iter().map(|t| t.nodes).sum::<usize>(),
                mean(&|t| t.execution),
                PAPER[a][s][1],
                mean(&|t| t.contact),
                mean(&|t| t.placements as f64),
                mean(&|t| t.seconds),
                most(&|t| t.seconds),
                1e3 * most(&|t| t.off_line),
                -1e3 * most(&|t| -t.clearance),
                trials.iter().map(|t| t.faults).sum::<usize>(),
            );
            all.append(&mut trials);
        }
    }
    let abandoned: usize = all.iter().map(|trial| trial.abandoned).sum();
    let nodes: usize = all.iter().map(|trial| trial.nodes).sum();
    println!("{abandoned} of {nodes} nodes abandoned");
    Ok(())
}

fn trial(loaded: &LoadedTask, robot: &ShippedRobot) -> Result<Trial, AnyError> {
    let begin = Instant::now();
    let LoadedTask { file, task, .. } = loaded;
    let mut session = Session::new(task, loaded.run.clone()).with_robot(robot.robot_setup());
    session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
    let plan = session.plan().ok_or("no plan")?.clone();
    let config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(robot.model.clone(), Some(&robot.srdf), task, &config)?;
    let config = FollowConfig::default();
    let followed = follow(task, &plan, &cell, robot.map.as_ref(), &config, &mut |_| ())?;
    let seconds = begin.elapsed().as_secs_f64();
    let audit = audit(&followed, &cell, task, &config)?;
    for fault in audit.faults.iter().take(3) {
        println!("  seed {}: {fault}", task.seed);
    }
    for node in &followed.abandoned {
        let last = node.attempts.last();
        println!("  seed {}: node {}: {last:?}", task.seed, node.node);
    }
    let wiped = Plan {
        strokes: followed.strokes.clone(),
        ..plan.clone()
    };
    Ok(Trial {
        performance: 100.0 * predict(task, &wiped, |_| ()).performance.ratio(),
        planned: 100.0 * predict(task, &plan, |_| ()).performance.ratio(),
        nodes: plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum(),
        abandoned: followed.abandoned.len(),
        execution: followed.duration(),
        contact: followed.contact_time(),
        placements: followed.placements.len(),
        seconds,
        off_line: audit.line.position,
        clearance: audit.min_clearance,
        faults: audit.faults.len(),
    })
}
