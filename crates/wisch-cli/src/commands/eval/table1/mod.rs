//! `wisch eval table1`: reproduces the paper's Table 1.

mod page;
mod record;

use super::journal::{Cases, Evaluated};
use super::wipings::{
    find_heading, format_csv, format_header, format_mean, format_row, format_runs_as_csv,
};
use super::{Provenance, begin_evidence, conclude, find_outcome, finish_evidence, write};
use crate::args::{GlobalArgs, Table1Args};
use crate::failure::Failure;
use crate::terminal::Outcome;
use record::{Table1Record, format_paper_figure, list_columns, write_lead};
use std::fmt::Write as _;
use std::path::Path;
use wisch::plan::Strategy;
use wisch::represent::Action;
use wisch_eval::{
    Quantity, Table1Case, Table1Row, Table1Run, Table1Setup, TaskCase, WipingExtent,
    build_table1_rows, table1_figures,
};
use wisch_io::load_task;

/// Schema number of the record.
const SCHEMA: u32 = 1;

/// Evaluates the runs of a part, and makes the table of all runs in the folder.
pub fn table1(args: &Table1Args, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let (first, seeds) = (args.seeds.first_seed, args.seeds.seeds);
    let provenance = Provenance::begin("wisch table1", SCHEMA, first, seeds);
    let setup = Table1Setup {
        extent: args.extent.extent(),
        is_limited: args.within_shortest,
        settings: args.settings.clone(),
        pictured_seed: first,
    };
    let all = list_cases(args, provenance.seeds);
    check(&all, &setup)?;
    let cases = Cases {
        noun: "run",
        all: &all,
        case_of: &|run: &Table1Run| run.case.clone(),
        is_same: &|run| run.setup == setup,
        name: &Table1Case::name,
        evaluate: &|case| {
            let run = case.evaluate(&setup);
            run.map_err(|message| Failure::new(format!("{}: {message}", case.name())))
        },
    };
    let out = &args.out;
    let is_executed = setup.extent == WipingExtent::Executed;
    let evidence = begin_evidence(&args.evidence, Some((out, &args.journal)), is_executed)?;
    let Evaluated { all: runs, failed } = cases.evaluate_part(out, &args.journal, global)?;
    let rows = build_table1_rows(&runs);
    let own = || rows.iter().filter(|row| row.is_papers_own);
    let mut record = Table1Record {
        provenance,
        setup,
        reached: [own().filter(|row| row.is_reached).count(), own().count()],
        rows,
        runs,
    };
    write(&out.join("runs.csv"), &format_runs(&record.runs)?)?;
    write(&out.join("table1.csv"), &rows_table(&record.rows)?)?;
    write(&out.join("table1.html"), &page::page(&record)?)?;
    for run in &mut record.runs {
        run.score.picture = None;
    }
    let table = in_words(&record);
    conclude(out, "table1", &record, &table, args.json, global)?;
    let figures = table1_figures(&record.rows, record.reached);
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

/// All runs, each with its number.
fn list_cases(args: &Table1Args, [first, last]: [u64; 2]) -> Vec<(u64, Table1Case)> {
    let is_asked = |task: &TaskCase| {
        let mut named = args.cells.iter().flat_map(|cells| &cells.0);
        args.cells.is_empty() || named.any(|named| named == task)
    };
    // All three actions move dirt, so a setting that suits one suits all.
    let fits = |strategy: &Strategy| strategy.fits(Action::Absorb);
    let is_wanted = |strategy: &Strategy| match args.strategies.is_empty() {
        true => fits(strategy),
        false => args.strategies.contains(strategy),
    };
    let strategies: Vec<Strategy> = Strategy::ALL.into_iter().filter(is_wanted).collect();
    let of = |task: TaskCase| {
        let of = move |strategy: &Strategy| {
            let strategy = strategy.to_string();
            (first..=last).map(move |seed| Table1Case {
                task,
                strategy: strategy.clone(),
                seed,
            })
        };
        strategies.iter().flat_map(of)
    };
    (0..)
        .zip(TaskCase::cases_by_action().filter(is_asked).flat_map(of))
        .collect()
}

/// Reads each task once, so that a wrong key is reported before the long computation.
fn check(cases: &[(u64, Table1Case)], setup: &Table1Setup) -> Result<(), Failure> {
    let mut seen = Vec::new();
    for (_, case) in cases {
        if !seen.contains(&case.task) {
            seen.push(case.task);
            let options = case.load_options(setup).map_err(Failure::new)?;
            load_task(Path::new(case.task.scenario()), &options)?;
        }
    }
    Ok(())
}

fn in_words(record: &Table1Record) -> String {
    let columns = list_columns(&record.setup);
    let is_executed = record.setup.extent == WipingExtent::Executed;
    let mut text = write_lead(record) + "\n\n";
    let names = columns.iter().flat_map(|(quantity, paper)| {
        let paper = paper.map(|_| "paper".to_owned());
        [Some(find_heading(*quantity).0.to_owned()), paper]
            .into_iter()
            .flatten()
    });
    let claimed = is_executed.then(|| "claimed".to_owned());
    text += &format_header(
        ["", "", "", "runs"]
            .map(str::to_owned)
            .into_iter()
            .chain(names)
            .chain(claimed),
    );
    for line in &record.rows {
        let keys = [line.action, line.surface, &line.strategy].map(str::to_owned);
        let figures = columns.iter().flat_map(|&(quantity, paper)| {
            let ours = format_mean(&line.ours, quantity);
            let is_bold = quantity == Quantity::Predicted && line.is_reached;
            let ours = if is_bold { format!("**{ours}**") } else { ours };
            let paper = paper.map(|of| format_paper_figure(line, of(&line.paper)));
            [Some(ours), paper].into_iter().flatten()
        });
        let claimed = line.claimed.map(|claimed| claimed.to_string());
        let runs = line.runs.to_string();
        text += &format_row(keys.into_iter().chain([runs]).chain(figures).chain(claimed));
    }
    let [reached, own] = record.reached;
    if own > 0 {
        let _ = write!(
            text,
            "\n{reached} of {own} of the paper's cells reach its performance.\n"
        );
    }
    text += "\nMeans over the seeds. Bold: the paper's performance is reached. Strategies that the paper does not have are compared with its best\n\
             figure of three, in brackets. Computation is wall time on one core; the paper's figure is that of another planner on another machine.\n";
    text
}

/// Formats the runs as CSV.
fn format_runs(runs: &[Table1Run]) -> Result<String, Failure> {
    let rows = runs.iter().map(|run| {
        let Table1Case {
            task,
            strategy,
            seed,
        } = &run.case;
        let keys = [task.action().as_str(), task.place(), strategy].map(str::to_owned);
        (
            keys.into_iter().chain([seed.to_string()]).collect(),
            &run.score,
        )
    });
    format_runs_as_csv(&["action", "surface", "strategy", "seed"], rows)
}

/// Formats the means of each cell and strategy, with the paper's figures, as CSV.
fn rows_table(rows: &[Table1Row]) -> Result<String, Failure> {
    let names = [
        "action",
        "surface",
        "strategy",
        "runs",
        "is_papers_own",
        "paper_performance_percent",
        "paper_distance_m",
        "paper_execution_s",
        "paper_computation_s",
        "claimed",
    ];
    let header = names.into_iter().chain(Quantity::ALL.map(Quantity::as_str));
    let rows = rows.iter().map(|row| {
        let paper = row.paper;
        let keys = [
            row.action.to_owned(),
            row.surface.to_owned(),
            row.strategy.clone(),
            row.runs.to_string(),
            row.is_papers_own.to_string(),
            paper.performance_percent.to_string(),
            paper.distance_m.to_string(),
            paper.execution_s.to_string(),
            paper.computation_s.to_string(),
            row.claimed
                .map_or_else(String::new, |claimed| claimed.to_string()),
        ];
        let means = Quantity::ALL.map(|quantity| {
            let ours = row.ours.get(&quantity);
            ours.map_or_else(String::new, |ours| ours.mean.to_string())
        });
        keys.into_iter().chain(means).collect()
    });
    format_csv(header.map(str::to_owned).collect(), rows)
}
