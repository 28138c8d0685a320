//! Random tasks and robots: each task is planned, followed and audited. Exits 1 on any fault or
//! panic, and if fewer than 70 % of a hundred or more are followed, wholly or in part.
//!
//! ```text
//! cargo run --release --package wisch --example random_problems -- [count, default 1000] [first seed, default 0]
//! ```

use rayon::prelude::*;
use std::collections::BTreeMap;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::Instant;
use wisch_testkit::{Problem, ShippedRobot, SolvedProblem, robots};

/// Least share of at least [`MANY`] problems that must be followed, wholly or in part: a program
/// that refuses all of them would have no faults.
const LEAST_FOLLOWED: f64 = 0.7;
/// Least number of problems to which [`LEAST_FOLLOWED`] applies.
const MANY: usize = 100;

/// Index of a seed's robot and the result; `None` if it panicked.
type Row = (usize, Option<SolvedProblem>);

fn main() -> Result<ExitCode, Box<dyn Error + Send + Sync>> {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().map_or(Ok(1000), |text| text.parse())?;
    let first: u64 = arguments.next().map_or(Ok(0), |text| text.parse())?;
    let robots = robots();
    let begin = Instant::now();
    let outcomes: Vec<(u64, Row, f64)> = (first..first.saturating_add(count))
        .into_par_iter()
        .map(|seed| {
            let begin = Instant::now();
            let tried = tried(seed, &robots);
            (seed, tried, begin.elapsed().as_secs_f64())
        })
        .collect();
    let seconds = begin.elapsed().as_secs_f64();

    let mut table: BTreeMap<String, [usize; 3]> = BTreeMap::new();
    let mut sound = true;
    for (seed, (robot, outcome), _) in &outcomes {
        let row = match outcome {
            Some(SolvedProblem::Whole) => "1 followed whole".into(),
            Some(SolvedProblem::Partly) => "2 followed partly".into(),
            Some(SolvedProblem::NotAtAll) => "3 not at all".into(),
            Some(SolvedProblem::Refused(why)) => format!("4 refused: {why}"),
            Some(SolvedProblem::Faulty(faults)) => {
                sound = false;
                println!("seed {seed}: {} faults, first: {}", faults.len(), faults[0]);
                "5 audit faults".into()
            }
            None => {
                sound = false;
                println!("seed {seed}: panic");
                "6 panics".into()
            }
        };
        table.entry(row).or_default()[*robot] += 1;
    }
    println!(
        "{:>8} {:>8} {:>8}",
        robots[0].name, robots[1].name, robots[2].name
    );
    for (row, [arm7, arm6, humanoid]) in &table {
        println!("{arm7:8} {arm6:8} {humanoid:8}  {}", &row[2..]);
    }
    let is_followed = |outcome: &Option<SolvedProblem>| {
        matches!(outcome, Some(SolvedProblem::Whole | SolvedProblem::Partly))
    };
    let followed = (outcomes.iter())
        .filter(|(_, (_, outcome), _)| is_followed(outcome))
        .count();
    let share = followed as f64 / outcomes.len().max(1) as f64;
    println!("{:.1} % followed, whole or in part", 100.0 * share);
    sound &= outcomes.len() < MANY || share >= LEAST_FOLLOWED;
    let slowest = outcomes.iter().max_by(|a, b| a.2.total_cmp(&b.2));
    if let Some((seed, _, longest)) = slowest {
        println!("{count} problems in {seconds:.1} s, the longest {longest:.1} s (seed {seed})");
    }
    Ok(if sound {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(1)
    })
}

fn tried(seed: u64, robots: &[ShippedRobot]) -> Row {
    match Problem::random(seed) {
        Ok(problem) => {
            let outcome = catch_unwind(AssertUnwindSafe(|| problem.outcome(robots)));
            (problem.robot, outcome.ok())
        }
        Err(error) => (0, Some(SolvedProblem::Refused(error.to_string()))),
    }
}
