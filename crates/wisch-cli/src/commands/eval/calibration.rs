//! `wisch eval calibration`: compares estimates with ground truth in randomised worlds.

use super::super::words::{format_count, percent};
use super::journal::{Cases, Evaluated};
use super::{
    Provenance, begin_evidence, conclude, find_outcome, finish_evidence, format_points, write,
};
use crate::args::{CalibrationArgs, GlobalArgs, SensesChoice};
use crate::failure::Failure;
use crate::terminal::Outcome;
use serde::Serialize;
use std::fmt::Write as _;
use wisch_eval::{
    Calibration, GroupScores, MethodScores, Senses, WorldCase, WorldScore, calibration_figures,
};
use wisch_report::{CalibrationCurve, CalibrationLevel, calibration_drawing};

/// Schema number of the record.
const SCHEMA: u32 = 1;

/// The record of an evaluation.
#[derive(Debug, Serialize)]
struct CalibrationRecord {
    #[serde(flatten)]
    provenance: Provenance,
    senses: Senses,
    /// Overrides of every task: keys and values.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    settings: Vec<(String, String)>,
    #[serde(flatten)]
    calibration: Calibration,
}

/// Evaluates the worlds of a part, and summarises all worlds in the folder.
pub fn calibration(args: &CalibrationArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let provenance = Provenance::begin("wisch calibration", SCHEMA, args.first_seed, args.worlds);
    let senses = match args.senses {
        SensesChoice::Touch => Senses::Touch,
        SensesChoice::Sight => Senses::TouchAndSight,
    };
    let [first, last] = provenance.seeds;
    let all: Vec<(u64, u64)> = (first..=last).map(|seed| (seed, seed)).collect();
    let cases = Cases {
        noun: "world",
        all: &all,
        case_of: &|world: &WorldScore| world.case.seed,
        is_same: &|world| {
            world.senses == senses
                && world.variants == args.variant
                && world.settings == args.settings
        },
        name: &|seed| format!("seed {seed}"),
        evaluate: &|&seed| {
            WorldCase::from_seed(seed)
                .evaluate(senses, &args.variant, &args.settings)
                .map_err(Failure::new)
        },
    };
    let out = &args.out;
    let evidence = begin_evidence(&args.evidence, Some((out, &args.journal)), true)?;
    let Evaluated {
        all: worlds,
        failed,
    } = cases.evaluate_part(out, &args.journal, global)?;
    let record = CalibrationRecord {
        provenance,
        senses,
        settings: args.settings.clone(),
        calibration: Calibration::summarise(&worlds, &args.variant),
    };
    let table = in_words(&record);
    write(&out.join("reliability.svg"), &draw_calibration(&record))?;
    conclude(out, "calibration", &record, &table, args.json, global)?;
    let figures = calibration_figures(&record.calibration, senses);
    let cases = [worlds.len(), all.len()];
    finish_evidence(
        evidence,
        &record.provenance,
        cases,
        Some(&args.journal),
        &figures,
    )?;
    Ok(find_outcome(failed))
}

fn in_words(record: &CalibrationRecord) -> String {
    let calibration = &record.calibration;
    let senses = match record.senses {
        Senses::Touch => "touch only",
        Senses::TouchAndSight => "touch and sight",
    };
    let mut text = format!(
        "{}{}: {} with {}.\n\n",
        record.provenance.in_words(senses),
        (record.settings.iter())
            .map(|(key, value)| format!(", {key} = {value}"))
            .collect::<String>(),
        format_count(calibration.worlds, "world"),
        format_count(calibration.rounds, "round"),
    );
    text += "| estimator | CRPS | error | bias | 50 % | 80 % | 90 % | 95 % | width of 90 % |\n";
    text += "|---|---|---|---|---|---|---|---|---|\n";
    for method in &calibration.methods {
        let _ = writeln!(text, "| {} |{}", method.name, method_cells(method));
    }
    let _ = writeln!(
        text,
        "\nCRPS, error, bias and width in percentage points of performance; for intervals, the share of rounds whose true performance they contain.\n"
    );
    text += "| group | worlds | rounds | in 90 % interval (95 % bounds) | width | CRPS | error | paper's error | end ≥ 90 % | claimed | met | false |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for group in &calibration.groups {
        let _ = writeln!(text, "{}", group_row(group));
    }
    let claims = &calibration.claims;
    let _ = writeln!(
        text,
        "\nGoals: {} claimed, {} met, {} claimed and met, {} claimed falsely by more than 10 points; {} undecided by touch.",
        claims.claimed,
        claims.met,
        claims.claimed_and_met,
        claims.false_claims,
        claims.undecided_by_touch
    );
    let pushes = &calibration.pushes;
    let _ = writeln!(
        text,
        "Pushes: {} in {}, {} detected, {} starts and {} ends within 50 ms; in {} without a push, {} detections at collisions with objects, {} false detections.",
        pushes.pushes,
        format_count(pushes.rounds, "round"),
        pushes.found,
        pushes.starts,
        pushes.ends,
        format_count(pushes.undisturbed, "round"),
        pushes.obstructed,
        pushes.false_detections
    );
    text
}

fn method_cells(method: &MethodScores) -> String {
    let mut cells = format!(
        " {} | {} | {} |",
        format_points(method.crps),
        format_points(method.error),
        format_points(method.bias)
    );
    if method.coverage.is_empty() {
        return cells + " – | – | – | – | – |";
    }
    for level in &method.coverage {
        let _ = write!(cells, " {} |", percent(level.share));
    }
    let width = method.coverage.iter().find(|level| level.level == 0.9);
    let _ = write!(
        cells,
        " {} |",
        width.map_or_else(String::new, |level| format_points(level.width))
    );
    cells
}

fn group_row(group: &GroupScores) -> String {
    if group.rounds == 0 {
        let (name, worlds) = (&group.name, group.worlds);
        return format!("| {name} | {worlds} | 0 | – | – | – | – | – | – | – | – | – |");
    }
    let at_90 = group
        .method
        .coverage
        .iter()
        .find(|level| level.level == 0.9);
    let (held, width) = at_90.map_or_else(Default::default, |level| {
        let [low, high] = level.bounds;
        let held = format!(
            "{} ({} to {})",
            percent(level.share),
            format_points(low),
            format_points(high)
        );
        (held, format_points(level.width))
    });
    format!(
        "| {} | {} | {} | {held} | {width} | {} | {} | {} | {} | {} | {} | {} |",
        group.name,
        group.worlds,
        group.rounds,
        format_points(group.method.crps),
        format_points(group.method.error),
        format_points(group.paper_error),
        percent(group.ended_at_90),
        group.claims.claimed,
        group.claims.met,
        group.claims.false_claims,
    )
}

fn draw_calibration(record: &CalibrationRecord) -> String {
    let curve = |method: &MethodScores| CalibrationCurve {
        name: method.name.to_owned(),
        levels: (method.coverage.iter())
            .map(|level| CalibrationLevel {
                level: level.level,
                coverage: level.share,
                bounds: level.bounds,
                width: level.width,
            })
            .collect(),
    };
    let methods = record.calibration.methods.iter();
    let with_intervals = methods.filter(|method| !method.coverage.is_empty());
    let curves: Vec<CalibrationCurve> = with_intervals.map(curve).collect();
    let what = format!(
        "{} in {}, seeds {} to {}",
        format_count(record.calibration.rounds, "round"),
        format_count(record.calibration.worlds, "world"),
        record.provenance.seeds[0],
        record.provenance.seeds[1]
    );
    calibration_drawing("Reliability of the intervals", &what, &curves)
}
