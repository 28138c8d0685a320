//! `wisch eval goals`: runs a goal of several parts over many seeds.

use super::super::goal::{GoalPart, GoalSummary, TakenStep, read_goal};
use super::super::run::run_goal;
use super::super::words::internal;
use super::journal::{Cases, Evaluated};
use super::scenarios::{format_quartiles, in_percent};
use super::{Provenance, begin_evidence_of, conclude, find_outcome, finish_evidence};
use crate::args::{Cli, Command, GlobalArgs, GoalEvaluationArgs, WipeArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, run_without_notes};
use serde::Serialize;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::Path;
use wisch_eval::{
    GoalPartScore, GoalRunScore, GoalScores, Quartiles, SIMULATION_CODE, goal_figures,
};
use wisch_io::InputDigest;

/// Schema number of the record.
const SCHEMA: u32 = 1;
/// The code, besides that of planning, on which the figures depend.
const GOAL_CODE: [&str; 8] = [
    SIMULATION_CODE,
    "crates/wisch-cli/src/commands/goal",
    "crates/wisch-cli/src/commands/job.rs",
    "crates/wisch-cli/src/commands/rounds.rs",
    "crates/wisch-cli/src/commands/run.rs",
    "crates/wisch-cli/src/commands/swept.rs",
    "crates/wisch-cli/src/commands/wipe.rs",
    "crates/wisch-record/src",
];

/// The record of an evaluation.
#[derive(Debug, Serialize)]
struct GoalsRecord {
    #[serde(flatten)]
    provenance: Provenance,
    goal: GoalScores,
    runs: Vec<GoalRunScore>,
}

/// Runs a goal over many seeds, and summarises the runs.
pub fn goals(args: &GoalEvaluationArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let provenance = Provenance::begin("wisch goals", SCHEMA, args.first_seed, args.worlds);
    let [first, last] = provenance.seeds;
    check(args)?;
    let all: Vec<(u64, u64)> = (0..).zip(first..=last).collect();
    let inputs = digest_inputs(&args.task)?;
    let (task, out) = (&args.task, &args.out);
    let name = |seed: &u64| format!("seed {seed}");
    let cases = Cases {
        noun: "run",
        all: &all,
        case_of: &|run: &GoalRunScore| run.seed,
        is_same: &|run| run.task == *task && run.inputs == inputs,
        name: &name,
        evaluate: &|seed| {
            let folder = out.join(format!("results-{seed}"));
            let score = evaluate(args, *seed, &folder);
            // The results of a run take some 100 MB.
            let _ = std::fs::remove_dir_all(&folder);
            score.map_err(|failure| failure.after(&name(seed)))
        },
    };
    let parts = Some((&**out, &args.journal));
    let evidence = begin_evidence_of(&args.evidence, parts, &GOAL_CODE)?;
    let Evaluated { all: runs, failed } = cases.evaluate_part(out, &args.journal, global)?;
    let record = GoalsRecord {
        provenance,
        goal: GoalScores::summarise(task, &runs),
        runs,
    };
    let table = in_words(&record, args.touch_only);
    conclude(out, "goals", &record, &table, args.json, global)?;
    let figures = goal_figures(&record.goal);
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

/// Checks that the task has a goal of several parts, before the first run.
fn check(args: &GoalEvaluationArgs) -> Result<(), Failure> {
    let cli = run_args(args, args.first_seed, &args.out)?;
    match &cli.command {
        Command::Run(run) if read_goal(&run.follow.task)?.is_none() => {
            let failure = Failure::new("the goal has a single part").within(Path::new(&args.task));
            Err(failure.with_help("evaluate it with wisch eval scenarios"))
        }
        _ => Ok(()),
    }
}

/// Digests the task file, or the version of the program that ships the scenario.
fn digest_inputs(task: &str) -> Result<String, Failure> {
    let mut digest = InputDigest::default();
    let path = Path::new(task);
    if path.is_file() {
        digest.add(task, &wisch_io::read_text(path)?);
    } else {
        digest.add(task, env!("CARGO_PKG_VERSION"));
    }
    Ok(format!("{:016x}", digest.value()))
}

/// Returns the arguments of one run, as on the command line of `wisch run`.
fn run_args(args: &GoalEvaluationArgs, seed: u64, folder: &Path) -> Result<Cli, Failure> {
    let words = ["wisch", "run", "--quiet", "--no-memory", "--force"];
    let mut words: Vec<OsString> = words.map(OsString::from).to_vec();
    words.extend(args.touch_only.then(|| "--touch-only".into()));
    words.extend(["--seed".into(), seed.to_string().into()]);
    words.extend(["--out".into(), folder.into(), "--".into()]);
    words.push(args.task.clone().into());
    Cli::read(&words).map_err(Failure::new)
}

/// Runs the goal once.
fn evaluate(args: &GoalEvaluationArgs, seed: u64, folder: &Path) -> Result<GoalRunScore, Failure> {
    let cli = run_args(args, seed, folder)?;
    let Command::Run(WipeArgs { follow, rounds, .. }) = &cli.command else {
        return Err(internal(
            "the arguments of `wisch run` were parsed as another command",
        ));
    };
    let summary = run_without_notes(|| run_goal(follow, rounds, &cli.global))?;
    Ok(GoalRunScore {
        task: args.task.clone(),
        inputs: digest_inputs(&args.task)?,
        seed,
        parts: score_parts(&summary),
        expected_s: summary.expected_s,
        took_s: summary.took_s,
        best_order_s: summary.best_order_s,
        ordering_s: summary.ordering_s,
    })
}

/// Scores the parts of the goal by the last steps that served them.
fn score_parts(summary: &GoalSummary) -> Vec<GoalPartScore> {
    let score = |part: &GoalPart| {
        let serves = |step: &&TakenStep| step.part.as_deref() == Some(&*part.part);
        let last = (summary.steps.iter().rfind(serves)).and_then(|step| step.summary.as_ref());
        let execution = last.and_then(|last| last.execution.as_ref());
        GoalPartScore {
            part: part.part.clone(),
            is_claimed: part.holds,
            reason: part.left_out.clone(),
            target: last.and_then(|last| Some(last.prediction?.target_performance)),
            estimated: execution.map(|execution| execution.final_estimated),
            truth: execution.and_then(|execution| execution.final_true),
        }
    };
    summary.parts.iter().map(score).collect()
}

fn in_words(record: &GoalsRecord, is_touch_only: bool) -> String {
    let senses = if is_touch_only {
        "touch only"
    } else {
        "the task's senses"
    };
    let mut text = record.provenance.in_words(senses) + ".\n\n";
    let scores = &record.goal;
    text += "| part of the goal | runs | reached | claimed | false | true performance |\n";
    text += "|---|---|---|---|---|---|\n";
    for part in &scores.parts {
        let truth = part.truth.map_or_else(|| "–".to_owned(), in_percent);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {truth} |",
            part.part, scores.runs, part.reached, part.claimed, part.false_claims,
        );
    }
    let _ = writeln!(
        text,
        "| all parts | {} | {} | {} | {} | |",
        scores.runs, scores.reached, scores.claimed, scores.false_claims
    );
    let plain = |of: Option<Quartiles>, decimals: usize| {
        let number = |value: f64| format!("{value:.decimals$}");
        of.map_or_else(|| "–".to_owned(), |of| format_quartiles(of, number))
    };
    let _ = write!(
        text,
        "\nReached: at most 5 points below the target; false: claimed, and more than 10 points below it. True performance \
         in percent: median (quartiles; minimum to maximum), as in the following numbers.\n\n\
         - Time of all steps [s]: {}\n\
         - as a multiple of the expected time: {}\n\
         - as a multiple of the best order with the times that the steps took: {}\n\
         - Time to compute the order [s]: {}\n",
        plain(scores.took_s, 1),
        plain(scores.of_expected, 2),
        plain(scores.of_best_order, 2),
        plain(scores.ordering_s, 4),
    );
    text
}
