//! `wisch eval scenarios`: shipped scenarios over many seeds.

use super::super::words::counted;
use super::{Provenance, cannot, points, write};
use crate::args::{GlobalArgs, ScenarioEvaluationArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use rayon::prelude::*;
use serde::Serialize;
use std::fmt::Write as _;
use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};
use wisch_eval::{Quartiles, ScenarioRun, ScenarioScores};

/// The schema of what is written.
const SCHEMA: u32 = 1;

/// What is written of an evaluation.
#[derive(Debug, Serialize)]
struct ScenariosRecord {
    #[serde(flatten)]
    provenance: Provenance,
    is_touch_only: bool,
    scenarios: Vec<ScenarioScores>,
    runs: Vec<ScenarioRun>,
}

/// Wipes scenarios over many seeds, and sums up.
pub fn scenarios(args: &ScenarioEvaluationArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let provenance = Provenance::begin("wisch scenarios", SCHEMA, args.first_seed, args.worlds)?;
    let out = &args.out;
    let path = out.join("scenarios.json");
    if path.exists() {
        let place = path.display();
        return Err(Failure::new(format!("{place}: is there already"))
            .with_help("choose another folder with --out: a published figure is not drawn twice"));
    }
    fs::create_dir_all(out).map_err(|error| cannot(out, "write there", &error))?;
    let [first, last] = provenance.seeds;
    let cases: Vec<(&String, u64)> = (first..=last)
        .flat_map(|seed| args.tasks.iter().map(move |task| (task, seed)))
        .collect();
    let progress = Progress::start(global);
    let (done, all) = (AtomicUsize::new(0), cases.len());
    progress.say(format!("0 of {}", counted(all, "run")));
    let rounds = args.rounds.map(|rounds| rounds as usize);
    let evaluated: Vec<_> = (cases.par_iter())
        .map(|(task, seed)| {
            let run = ScenarioRun::evaluate(task, *seed, rounds, args.touch_only);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.say(format!("{done} of {}", counted(all, "run")));
            run.map_err(|error| Failure::new(format!("{task}, {error}")))
        })
        .collect();
    drop(progress);
    let (runs, failures): (Vec<_>, Vec<_>) = evaluated.into_iter().partition(Result::is_ok);
    let runs: Vec<ScenarioRun> = runs.into_iter().flatten().collect();
    for failure in failures.iter().filter_map(|failed| failed.as_ref().err()) {
        remark(&failure.to_string());
    }
    let of = |task: &String| {
        let own: Vec<ScenarioRun> = (runs.iter().filter(|run| run.scenario == *task))
            .cloned()
            .collect();
        ScenarioScores::of(task, &own)
    };
    let record = ScenariosRecord {
        provenance,
        is_touch_only: args.touch_only,
        scenarios: args.tasks.iter().map(of).collect(),
        runs,
    };
    let table = in_words(&record);
    let text = serde_json::to_string_pretty(&record).map_err(Failure::new)?;
    write(&path, &(text + "\n"))?;
    write(&out.join("scenarios.md"), &table)?;
    if args.json {
        let line = serde_json::to_string(&record).map_err(Failure::new)?;
        print(&(line + "\n"))?;
    } else if !global.quiet {
        print(&table)?;
    }
    Ok(if failures.is_empty() {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

fn in_words(record: &ScenariosRecord) -> String {
    let senses = if record.is_touch_only {
        "touch alone"
    } else {
        "the scenarios' senses"
    };
    let mut text = record.provenance.in_words(senses) + ".\n\n";
    text += "| scenario | runs | rounds | after round 1 | of what was elsewhere | at the end | met | claimed | false | 90 % holds | error | pushes told |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for scores in &record.scenarios {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            scores.scenario,
            scores.runs,
            scores.rounds,
            quartiles(scores.first),
            quartiles(scores.moved),
            quartiles(scores.last),
            scores.met,
            scores.claimed,
            scores.false_claims,
            scores.held,
            points(scores.error),
            scores.collisions,
        );
    }
    text += "\nWhat is so, in points of performance: median (quartiles; least to greatest).\n";
    text
}

fn quartiles(of: Option<Quartiles>) -> String {
    let Some(Quartiles([least, first, median, third, greatest])) = of else {
        return "–".to_owned();
    };
    format!(
        "{} ({} to {}; {} to {})",
        points(median),
        points(first),
        points(third),
        points(least),
        points(greatest)
    )
}
