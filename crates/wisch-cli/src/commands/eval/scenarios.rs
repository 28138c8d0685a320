//! `wisch eval scenarios`: runs scenarios or tasks over many seeds.

use super::journal::one_on_each_core;
use super::{
    Provenance, begin_evidence, conclude, file_failure, find_outcome, finish_evidence,
    format_points,
};
use crate::args::{GlobalArgs, ScenarioEvaluationArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, remark};
use serde::Serialize;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use wisch_eval::{Quartiles, ScenarioRun, ScenarioScores, scenario_figures};
use wisch_io::{LoadOptions, load_task};

/// Schema number of the record.
const SCHEMA: u32 = 1;

/// The record of an evaluation.
#[derive(Debug, Serialize)]
struct ScenariosRecord {
    #[serde(flatten)]
    provenance: Provenance,
    is_touch_only: bool,
    scenarios: Vec<ScenarioScores>,
    runs: Vec<ScenarioRun>,
}

/// Runs scenarios over many seeds, and summarises the runs.
pub fn scenarios(args: &ScenarioEvaluationArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let provenance = Provenance::begin("wisch scenarios", SCHEMA, args.first_seed, args.worlds);
    let out = &args.out;
    let path = out.join("scenarios.json");
    if path.exists() {
        let place = path.display();
        return Err(Failure::new(format!("{place}: the file exists already"))
            .with_help("choose another folder with --out"));
    }
    // A task that cannot be loaded is named before the first run.
    for task in &args.tasks {
        load_task(Path::new(task), &LoadOptions::default())?;
    }
    fs::create_dir_all(out).map_err(|error| file_failure(out, "write the folder", &error))?;
    let evidence = begin_evidence(&args.evidence, None, true)?;
    let [first, last] = provenance.seeds;
    let cases: Vec<(&String, u64)> = (first..=last)
        .flat_map(|seed| args.tasks.iter().map(move |task| (task, seed)))
        .collect();
    let rounds = args.rounds.map(|rounds| rounds as usize);
    let evaluate = |(task, seed): &(&String, u64)| {
        ScenarioRun::evaluate(task, *seed, rounds, args.touch_only)
            .map_err(|error| Failure::new(format!("{task}, {error}")))
    };
    let results = one_on_each_core(&cases, "run", global, evaluate)?;
    let (runs, failures): (Vec<_>, Vec<_>) = results.into_iter().partition(Result::is_ok);
    let runs: Vec<ScenarioRun> = runs.into_iter().flatten().collect();
    for failure in failures.iter().filter_map(|failed| failed.as_ref().err()) {
        remark(&failure.to_string());
    }
    let of = |task: &String| {
        let own: Vec<ScenarioRun> = (runs.iter().filter(|run| run.scenario == *task))
            .cloned()
            .collect();
        ScenarioScores::summarise(task, &own)
    };
    let record = ScenariosRecord {
        provenance,
        is_touch_only: args.touch_only,
        scenarios: args.tasks.iter().map(of).collect(),
        runs,
    };
    let table = in_words(&record);
    conclude(out, "scenarios", &record, &table, args.json, global)?;
    let figures = scenario_figures(&record.scenarios);
    let counts = [record.runs.len(), cases.len()];
    finish_evidence(evidence, &record.provenance, counts, None, &figures)?;
    Ok(find_outcome(failures.len()))
}

fn in_words(record: &ScenariosRecord) -> String {
    let senses = if record.is_touch_only {
        "touch only"
    } else {
        "the scenarios' senses"
    };
    let mut text = record.provenance.in_words(senses) + ".\n\n";
    text += "| scenario | runs | rounds | after round 1 | of the misplaced dirt | at the end | met | claimed | false | in 90 % interval | error | pushes detected |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    let in_percent = |of: Option<Quartiles>| of.map_or_else(|| "–".to_owned(), in_percent);
    for scores in &record.scenarios {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            scores.scenario,
            scores.runs,
            scores.rounds,
            in_percent(scores.first),
            in_percent(scores.recovered),
            in_percent(scores.last),
            scores.met,
            scores.claimed,
            scores.false_claims,
            scores.covered,
            scores.error.map_or_else(|| "–".to_owned(), format_points),
            scores.collisions,
        );
    }
    text += "\nTrue performance in percent: median (quartiles; minimum to maximum).\n";
    text
}

/// Formats quartiles of shares in percent.
pub(super) fn in_percent(of: Quartiles) -> String {
    format_quartiles(of, format_points)
}

/// Formats the median with the other quartiles and the extremes.
pub(super) fn format_quartiles(of: Quartiles, number: impl Fn(f64) -> String) -> String {
    let [least, first, median, third, greatest] = of.0.map(number);
    format!("{median} ({first} to {third}; {least} to {greatest})")
}
