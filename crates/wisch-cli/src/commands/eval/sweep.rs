//! `wisch eval sweep`: runs a task with every combination of the given values of its keys.

use super::super::words::format_count;
use super::journal::{Cases, Evaluated};
use super::wipings::{
    find_heading, format_header, format_quartiles, format_row, format_runs_as_csv,
};
use super::{Provenance, begin_evidence, conclude, find_outcome, finish_evidence, write};
use crate::args::{GlobalArgs, SweepArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, remark};
use serde::Serialize;
use std::path::Path;
use wisch_eval::{
    Axis, Quantity, SweepCase, SweepCell, SweepRun, SweepSetup, WipingExtent, group_sweep_runs,
    list_combinations, sweep_figures,
};
use wisch_io::{LoadOptions, load_task, robot_warnings};

/// Schema number of the record.
const SCHEMA: u32 = 1;

/// The record of a sweep.
#[derive(Debug, Serialize)]
struct SweepRecord {
    #[serde(flatten)]
    provenance: Provenance,
    setup: SweepSetup,
    axes: Vec<Axis>,
    cells: Vec<SweepCell>,
    runs: Vec<SweepRun>,
}

/// Evaluates the runs of a part, and summarises all runs in the folder.
pub fn sweep(args: &SweepArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let (first, seeds) = (args.seeds.first_seed, args.seeds.seeds);
    let provenance = Provenance::begin("wisch sweep", SCHEMA, first, seeds);
    let combinations = list_combinations(&args.axes)
        .filter(|cells| (cells.len() as u64).saturating_mul(seeds) <= MAX_RUNS)
        .ok_or_else(|| {
            Failure::new(format!("the sweep has more than {MAX_RUNS} runs"))
                .with_help("give fewer values with --set, or fewer seeds with --seeds")
        })?;
    let setup = SweepSetup {
        task: args.task.clone(),
        inputs: check(args)?,
        keys: args.axes.iter().map(|axis| axis.key.clone()).collect(),
        extent: args.extent.extent(),
    };
    let [first, last] = provenance.seeds;
    let of = |values: &Vec<String>| {
        let values = values.clone();
        (first..=last).map(move |seed| SweepCase {
            values: values.clone(),
            seed,
        })
    };
    let all: Vec<(u64, SweepCase)> = (0..).zip(combinations.iter().flat_map(of)).collect();
    let name = |case: &SweepCase| {
        let values = setup.keys.iter().zip(&case.values);
        let values: String = values
            .map(|(key, value)| format!("{key}={value}, "))
            .collect();
        format!("{values}seed {}", case.seed)
    };
    let cases = Cases {
        noun: "run",
        all: &all,
        case_of: &|run: &SweepRun| run.case.clone(),
        is_same: &|run| run.setup == setup,
        name: &name,
        evaluate: &|case| {
            let run = case.evaluate(&setup);
            run.map_err(|message| Failure::new(format!("{}: {message}", name(case))))
        },
    };
    let out = &args.out;
    let is_executed = setup.extent == WipingExtent::Executed;
    let evidence = begin_evidence(&args.evidence, Some((out, &args.journal)), is_executed)?;
    let Evaluated { all: runs, failed } = cases.evaluate_part(out, &args.journal, global)?;
    let record = SweepRecord {
        provenance,
        axes: args.axes.clone(),
        cells: group_sweep_runs(&combinations, &runs),
        setup: setup.clone(),
        runs,
    };
    write(&out.join("runs.csv"), &format_runs(&record)?)?;
    let table = in_words(&record);
    conclude(out, "sweep", &record, &table, args.json, global)?;
    let figures = sweep_figures(&record.cells, &record.setup.keys);
    let counts = [record.runs.len(), all.len()];
    finish_evidence(
        evidence,
        &record.provenance,
        counts,
        Some(&args.journal),
        &figures,
    )?;
    Ok(find_outcome(failed))
}

/// Maximum number of runs of a sweep.
const MAX_RUNS: u64 = 1_000_000;

/// Reads the task with each value once, so that a wrong value is reported before the long computation. Returns a digest
/// of the inputs.
fn check(args: &SweepArgs) -> Result<String, Failure> {
    let keys: Vec<String> = args.axes.iter().map(|axis| axis.key.clone()).collect();
    for (place, key) in keys.iter().enumerate() {
        if key == "seed" {
            return Err(Failure::new("--set seed: a sweep sets the seeds itself")
                .with_help("choose seeds with --first-seed and --seeds"));
        }
        if keys[..place].contains(key) {
            return Err(Failure::new(format!("--set {key}: the key is given twice"))
                .with_help("give all values in one --set, separated by commas"));
        }
    }
    let load = |settings: Vec<(String, String)>| {
        let options = LoadOptions {
            settings,
            seed: Some(args.seeds.first_seed),
            ..LoadOptions::default()
        };
        load_task(Path::new(&args.task), &options)
    };
    // First without values, so that an error of the task itself is not blamed on a value.
    let loaded = load(Vec::new())?;
    // A robot that cannot be read is the error of the first run, if the runs need it.
    if let Ok(Some(robot)) = loaded.robot() {
        let warnings = robot_warnings(&robot.model);
        warnings.iter().for_each(|text| remark(text));
    }
    let firsts = || {
        args.axes
            .iter()
            .map(|axis| (axis.key.clone(), axis.values[0].clone()))
    };
    for (place, Axis { key, values }) in args.axes.iter().enumerate() {
        for (number, value) in values.iter().enumerate() {
            let alone = (key.clone(), value.clone());
            if load(vec![alone.clone()]).is_ok() {
                continue;
            }
            // The value may be valid only together with a value of another key.
            let mut all: Vec<_> = firsts().collect();
            all[place] = alone;
            let value = format!("--set {key}, value {} of {}", number + 1, values.len());
            load(all).map_err(|error| Failure::from(error).within(Path::new(&value)))?;
        }
    }
    Ok(format!("{:016x}", load(firsts().collect())?.inputs.value()))
}

fn in_words(record: &SweepRecord) -> String {
    let mut quantities = vec![Quantity::Predicted, Quantity::PredictedLoss];
    if record.setup.extent == WipingExtent::Executed {
        quantities.extend([Quantity::Estimated, Quantity::Truth, Quantity::TrueLoss]);
        quantities.push(Quantity::Rounds);
    }
    quantities.extend([Quantity::DistanceM, Quantity::Lifts]);
    if record.setup.extent != WipingExtent::Planned {
        quantities.extend([Quantity::Abandoned, Quantity::ExecutionS]);
    }
    quantities.push(Quantity::ComputationS);
    let mut text = format!(
        "{}: {} of {}.\n\n",
        record.provenance.in_words(record.setup.extent.as_str()),
        format_count(record.runs.len(), "run"),
        record.setup.task,
    );
    let is_executed = record.setup.extent == WipingExtent::Executed;
    let claimed = is_executed.then(|| "claimed".to_owned());
    let names = quantities
        .iter()
        .map(|&quantity| find_heading(quantity).0.to_owned());
    let keys = record.setup.keys.iter().cloned();
    text += &format_header(keys.chain(["runs".to_owned()]).chain(names).chain(claimed));
    for cell in &record.cells {
        let figures = quantities
            .iter()
            .map(|&quantity| format_quartiles(&cell.summary, quantity));
        let claimed = cell.claimed.map(|claimed| claimed.to_string());
        let values = cell.values.iter().cloned();
        text += &format_row(
            values
                .chain([cell.runs.to_string()])
                .chain(figures)
                .chain(claimed),
        );
    }
    text += "\nMedian (quartiles) over the seeds. Computation is wall time on one core.\n";
    text
}

/// Formats the runs as CSV.
fn format_runs(record: &SweepRecord) -> Result<String, Failure> {
    let keys = record.setup.keys.iter().map(String::as_str);
    let names: Vec<&str> = keys.chain(["seed"]).collect();
    let rows = record.runs.iter().map(|run| {
        let SweepCase { values, seed } = &run.case;
        (
            values.iter().cloned().chain([seed.to_string()]).collect(),
            &run.score,
        )
    });
    format_runs_as_csv(&names, rows)
}
