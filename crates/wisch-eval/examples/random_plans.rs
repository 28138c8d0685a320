//! Random tasks, planned by every strategy, to check that `best` is the best. Exits 1 on a panic.
//!
//! ```text
//! cargo run --release --package wisch-eval --example random_plans -- [count, default 200] [first seed, default 1000] [evidence file]
//! ```
//!
//! The predicted performance of `best` is compared with the best of grid, rrt and kde. One effect
//! model evaluates all plans, for the dirt that the planner assumes.

use rayon::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::ExitCode;
use wisch::plan::{Plan, PlanConfig, Planner, Strategy, plan, predict};
use wisch::represent::{Action, Task};
use wisch_eval::{EvidenceFile, PLANNING_CODE, PublishedFigure, Quartiles, binomial_interval};
use wisch_testkit::{AnyError, any_task};

/// Result of a task.
struct Row {
    seed: u64,
    action: Action,
    /// Performance [points] of the best of the three, and of `best`.
    performance: [f64; 2],
    /// Particles lost by the same two.
    lost: [usize; 2],
    chosen: Strategy,
}

fn main() -> Result<ExitCode, AnyError> {
    // An evidence file is named as those of `wisch eval` are.
    let typed = std::env::args().skip(1);
    let mut arguments = typed.filter(|argument| argument != "--evidence");
    let count: u64 = arguments.next().map_or(Ok(200), |text| text.parse())?;
    let first: u64 = arguments.next().map_or(Ok(1000), |text| text.parse())?;
    let code = [&PLANNING_CODE[..], &["crates/wisch-testkit/src"]].concat();
    let evidence = arguments.next();
    let evidence = evidence.map(|path| EvidenceFile::begin(Path::new(&path), &code, None));
    let evidence = evidence.transpose()?;
    let tried: Vec<_> = (first..first.saturating_add(count))
        .into_par_iter()
        .map(|seed| (seed, catch_unwind(AssertUnwindSafe(|| row(seed)))))
        .collect();
    let mut rows = Vec::new();
    let mut panics = 0;
    for (seed, tried) in tried {
        match tried {
            Ok(Ok(row)) => rows.push(row),
            Ok(Err(error)) => println!("seed {seed}: refused: {error}"),
            Err(_) => {
                println!("seed {seed}: panic");
                panics += 1;
            }
        }
    }
    println!("{} of {count} tasks have a plan", rows.len());
    for action in Action::WIPING {
        let of: Vec<&Row> = rows.iter().filter(|row| row.action == action).collect();
        let mut gains: Vec<f64> = of
            .iter()
            .map(|row| row.performance[1] - row.performance[0])
            .collect();
        gains.sort_by(f64::total_cmp);
        let (Some(least), Some(most)) = (gains.first(), gains.last()) else {
            continue;
        };
        let mean = |which: usize| {
            of.iter().map(|row| row.performance[which]).sum::<f64>() / of.len() as f64
        };
        let lost = |which: usize| of.iter().map(|row| row.lost[which]).sum::<usize>();
        println!(
            "{action:7} {:3} tasks: best {:.1} %, of the three {:.1} % (means); gain {:+.1} points at least, {:+.1} median, {:+.1} at most; lost {} against {} particles",
            of.len(),
            mean(1),
            mean(0),
            least,
            gains[gains.len() / 2],
            most,
            lost(1),
            lost(0),
        );
    }
    for row in rows
        .iter()
        .filter(|row| row.performance[1] < row.performance[0] - 1.0)
    {
        println!(
            "seed {}: {} {:.1} % by {}, {:.1} % by one of the three; lost {} against {}",
            row.seed,
            row.action,
            row.performance[1],
            row.chosen,
            row.performance[0],
            row.lost[1],
            row.lost[0]
        );
    }
    if let Some(evidence) = evidence {
        let seeds = [first, first.saturating_add(count.saturating_sub(1))];
        evidence.finish(
            seeds,
            [count as usize - panics, panics],
            &figures(&rows, count as usize),
        )?;
    }
    Ok(ExitCode::from(u8::from(panics > 0)))
}

/// The published figures of all tasks, and of those of each action.
fn figures(rows: &[Row], count: usize) -> Vec<PublishedFigure> {
    let share = |row, hits: usize, trials: usize| {
        let place = ["all tasks", row, "result"];
        let bounds = binomial_interval(hits, trials).map(|bound| 100.0 * bound);
        let value = 100.0 * hits as f64 / trials as f64;
        PublishedFigure::from_value(place, value, "%", 1)
            .with_interval("95 % binomial", bounds)
            .with_count(trials, "tasks")
    };
    let is_close = |row: &&Row| row.performance[1] >= row.performance[0] - 1.0;
    let close = rows.iter().filter(is_close).count();
    let mut figures = vec![
        share("tasks without a plan", count - rows.len(), count),
        share(
            "tasks in which `best` is at most 1 point below",
            close,
            rows.len(),
        ),
    ];
    for action in Action::WIPING {
        let of: Vec<&Row> = rows.iter().filter(|row| row.action == action).collect();
        let gains = of.iter().map(|row| row.performance[1] - row.performance[0]);
        let Some(Quartiles([least, first, median, third, most])) =
            Quartiles::from_values(gains.collect())
        else {
            continue;
        };
        let place = |column| ["by action", action.as_str(), column];
        let gain = |column, value| PublishedFigure::from_value(place(column), value, "points", 1);
        let lost = |which: usize| of.iter().map(|row| row.lost[which]).sum::<usize>();
        figures.extend([
            PublishedFigure::from_count(place("tasks"), of.len()),
            gain("median gain", median)
                .with_interval("quartiles", [first, third])
                .with_count(of.len(), "tasks"),
            gain("least gain", least),
            gain("greatest gain", most),
            PublishedFigure::from_count(place("particles lost by `best`"), lost(1)),
            PublishedFigure::from_count(place("lost by the paper's strategy"), lost(0)),
        ]);
    }
    figures
}

fn row(seed: u64) -> Result<Row, AnyError> {
    let task = any_task(seed)?;
    let config = PlanConfig {
        strategy: Strategy::Best,
        seed,
        ..PlanConfig::default()
    };
    let candidates = Planner::new(&task, &config).plan_by_every_strategy()?;
    let of_three = candidates.into_iter().filter_map(|(strategy, candidate)| {
        let candidate = candidate.ok()?;
        (!strategy.is_searched()).then(|| effect(&task, &candidate.plan))
    });
    let three = of_three.max_by(|a, b| a.0.total_cmp(&b.0));
    let best = plan(&task, &config)?;
    let (performance, lost) = effect(&task, &best);
    let (of_three, lost_by_three) = three.unwrap_or_default();
    Ok(Row {
        seed,
        action: task.action,
        performance: [of_three, performance],
        lost: [lost_by_three, lost],
        chosen: best.strategy,
    })
}

/// Predicted performance [points] and particles lost.
fn effect(task: &Task, plan: &Plan) -> (f64, usize) {
    let predicted = predict(task, plan, |_| ()).performance;
    (100.0 * predicted.ratio(), predicted.lost)
}
