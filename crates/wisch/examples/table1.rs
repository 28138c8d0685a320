//! The predicted performance of the three scenarios beside the paper's Table 1 (§3.4).
//!
//! ```text
//! cargo run --release --package wisch --example table1 -- [number of seeds, default 5] [first seed, default 1] [plans tried by adaptive]
//! ```
//!
//! Distances are those in contact; "short" is the performance where plans may be no longer than the shortest of the paper's three. The paper's computation times are of another planner on another
//! machine, so only ours are printed.

use rayon::prelude::*;
use std::time::Instant;
use wisch::plan::{PlanConfig, SearchConfig, Strategy, plan, predict};
use wisch::represent::Action;
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_testkit::{AnyError, TABLE_1, scenario};

/// Table 1, performance [%]: action × scenario × (grid, rrt, kde).
const PAPER_PERFORMANCE: [[[f64; 3]; 3]; 3] = [
    [
        [84.25, 85.00, 95.75],
        [77.00, 79.50, 70.50],
        [90.13, 90.50, 91.00],
    ],
    [
        [86.50, 86.75, 90.50],
        [70.25, 69.25, 41.75],
        [48.50, 39.25, 62.75],
    ],
    [
        [88.00, 80.25, 97.00],
        [71.75, 65.50, 53.00],
        [94.50, 88.50, 88.50],
    ],
];

/// Table 1, distance [m]: action × scenario × (grid, rrt, kde).
const PAPER_DISTANCE: [[[f64; 3]; 3]; 3] = [
    [[1.52, 1.41, 1.90], [4.34, 4.10, 3.24], [4.44, 4.84, 4.69]],
    [[1.54, 1.45, 1.90], [3.68, 3.60, 2.92], [4.97, 4.76, 4.22]],
    [[1.81, 1.62, 2.01], [5.48, 4.95, 3.75], [5.58, 5.65, 5.89]],
];

/// Mean over the trials of one cell.
#[derive(Default, Clone, Copy)]
struct Trial {
    performance: f64,
    distance: f64,
    nodes: f64,
    unreachable: f64,
    short: f64,
    milliseconds: f64,
}

fn main() -> Result<(), AnyError> {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().map_or(Ok(5), |text| text.parse())?;
    let first: u64 = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let evaluations = arguments.next().map(|text| text.parse()).transpose()?;
    let search = SearchConfig {
        evaluations: evaluations.unwrap_or(SearchConfig::default().evaluations),
        ..SearchConfig::default()
    };
    if count == 0 {
        return Err("at least one seed is needed".into());
    }

    println!("seeds {first} to {}", first + count - 1);
    println!(
        "{:26} {:>7} {:>7}   {:>8} {:>8} {:>6} {:>12} {:>8} {:>8}",
        "", "perf %", "paper", "dist m", "paper", "nodes", "unreachable", "short %", "ms"
    );
    let mut reached = 0;
    for (a, action) in Action::WIPING.into_iter().enumerate() {
        for (s, name) in TABLE_1.into_iter().enumerate() {
            let tasks = (first..first + count)
                .into_par_iter()
                .map(|seed| {
                    let options = LoadOptions {
                        action: Some(action),
                        seed: Some(seed),
                        ..LoadOptions::default()
                    };
                    load_task(&scenario(name), &options)
                })
                .collect::<Result<Vec<LoadedTask>, _>>()?;
            // Beside what the paper does not have, its best performance and its shortest way.
            let (best, shortest) = best_of(PAPER_PERFORMANCE[a][s], PAPER_DISTANCE[a][s]);
            let strategies = Strategy::ALL
                .into_iter()
                .filter(|&strategy| strategy != Strategy::Best);
            for (k, strategy) in strategies.enumerate() {
                let trials = tasks
                    .par_iter()
                    .map(|loaded| trial(loaded, strategy, search, shortest))
                    .collect::<Result<Vec<Trial>, AnyError>>()?;
                let mean =
                    |of: fn(&Trial) -> f64| trials.iter().map(of).sum::<f64>() / count as f64;
                let performance = mean(|trial| trial.performance);
                let paper = PAPER_PERFORMANCE[a][s].get(k).copied().unwrap_or(best);
                let paper_distance = PAPER_DISTANCE[a][s].get(k).copied().unwrap_or(shortest);
                let is_reached = performance >= paper;
                reached += usize::from(is_reached && k < 3);
                println!(
                    "{action:7} {:10} {strategy:8} {performance:7.2} {paper:7.2} {} {:8.2} {:8.2} {:6.1} {:10.1} % {:8.2} {:8.1}",
                    name.trim_start_matches("chopping-"),
                    if is_reached { "≥" } else { "<" },
                    mean(|trial| trial.distance),
                    paper_distance,
                    mean(|trial| trial.nodes),
                    mean(|trial| trial.unreachable),
                    mean(|trial| trial.short),
                    mean(|trial| trial.milliseconds),
                );
            }
        }
    }
    println!("{reached} of 27 cells reach the paper's performance");
    Ok(())
}

fn best_of(performances: [f64; 3], distances: [f64; 3]) -> (f64, f64) {
    let best = performances.into_iter().fold(0.0, f64::max);
    (best, distances.into_iter().fold(f64::INFINITY, f64::min))
}

/// Plans and predicts; also with the paper's `shortest` way [m] as the longest that a plan may take.
fn trial(
    loaded: &LoadedTask,
    strategy: Strategy,
    search: SearchConfig,
    shortest: f64,
) -> Result<Trial, AnyError> {
    let begin = Instant::now();
    let task = &loaded.task;
    let config = PlanConfig {
        strategy,
        search,
        ..loaded.config
    };
    let plan = plan(task, &config)?;
    let milliseconds = 1e3 * begin.elapsed().as_secs_f64();
    let prediction = predict(task, &plan, |_| ());
    let short = PlanConfig {
        max_distance: Some(shortest),
        ..config
    };
    let short = predict(task, &wisch::plan::plan(task, &short)?, |_| ());
    Ok(Trial {
        performance: 100.0 * prediction.performance.ratio(),
        distance: plan.contact_distance(),
        nodes: plan.graph.nodes.len() as f64,
        unreachable: 100.0 * plan.unreachable_share,
        short: 100.0 * short.performance.ratio(),
        milliseconds,
    })
}
