//! What the evaluations share that wipe tasks: a table of their runs, and figures in words.

use super::super::words::internal;
use crate::failure::Failure;
use wisch_eval::{ExecutionScore, Quantity, QuantitySummary, Statistics, WipingScore};

/// What stands where there is nothing.
pub(super) const NONE: &str = "–";

/// Parts of one below which a figure is nothing but rounding.
const PER_ONE: f64 = 1e9;

/// What the columns before a run's own are called, and those after them.
const BEFORE: &str = "plan_strategy";
const AFTER: [&str; 5] = ["before", "low", "high", "verdict", "claimed"];

/// A row for each run, after what tells it from others, under these names. Empty cells have no value in this evaluation.
pub(super) fn runs_csv<'a>(
    names: &[&str],
    runs: impl Iterator<Item = (Vec<String>, &'a WipingScore)>,
) -> Result<String, Failure> {
    let quantities = Quantity::ALL.iter().map(|quantity| quantity.as_str());
    let header = (names.iter().copied())
        .chain([BEFORE])
        .chain(AFTER)
        .chain(quantities);
    let rows = runs.map(|(keys, score)| {
        let execution = score.execution.as_ref();
        let of = |of: fn(&ExecutionScore) -> String| execution.map_or_else(String::new, of);
        let after = [
            of(|execution| execution.before.to_string()),
            of(|execution| execution.low.to_string()),
            of(|execution| execution.high.to_string()),
            of(|execution| execution.verdict.clone()),
            of(|execution| execution.is_claimed.to_string()),
        ];
        let values = Quantity::ALL.iter().map(|quantity| {
            let value = quantity.of(score);
            value.map_or_else(String::new, |value| value.to_string())
        });
        (keys.into_iter())
            .chain([score.strategy.clone()])
            .chain(after)
            .chain(values)
            .collect()
    });
    csv(header.map(str::to_owned).collect(), rows)
}

/// A table as RFC 4180 has it.
pub(super) fn csv(
    header: Vec<String>,
    rows: impl Iterator<Item = Vec<String>>,
) -> Result<String, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in std::iter::once(header).chain(rows) {
        writer.write_record(row).map_err(internal)?;
    }
    let bytes = writer.into_inner().map_err(internal)?;
    String::from_utf8(bytes).map_err(internal)
}

/// How a quantity is called in tables, and how many decimals it has; shares are in per cent.
pub(super) const fn heading(quantity: Quantity) -> (&'static str, usize) {
    match quantity {
        Quantity::Planned => ("planned %", 2),
        Quantity::Predicted => ("predicted %", 2),
        Quantity::Limited => ("within the paper's shortest way %", 2),
        Quantity::Estimated => ("estimated %", 2),
        Quantity::TruthRound1 => ("true after round 1 %", 2),
        Quantity::Truth => ("true %", 2),
        Quantity::PredictedLoss => ("predicted loss %", 2),
        Quantity::TrueLoss => ("true loss %", 2),
        Quantity::OutOfReach => ("out of reach %", 2),
        Quantity::DistanceM => ("distance m", 2),
        Quantity::Lifts => ("lifts", 1),
        Quantity::Nodes => ("nodes", 1),
        Quantity::Abandoned => ("abandoned", 1),
        Quantity::Placements => ("placements", 1),
        Quantity::Faults => ("faults", 1),
        Quantity::Rounds => ("rounds", 1),
        Quantity::ExecutionS => ("execution s", 1),
        Quantity::ContactS => ("in contact s", 1),
        Quantity::ComputationS => ("computation s", 2),
    }
}

/// A value of a quantity in words.
pub(super) fn figure(quantity: Quantity, value: f64) -> String {
    let (name, decimals) = heading(quantity);
    let factor = if name.ends_with('%') { 100.0 } else { 1.0 };
    // Means that are equal but for rounding are written alike.
    let value = (factor * value * PER_ONE).round() / PER_ONE;
    format!("{value:.decimals$}")
}

/// The mean of a quantity in words.
pub(super) fn mean(summary: &QuantitySummary, quantity: Quantity) -> String {
    of(summary, quantity, |of| figure(quantity, of.mean))
}

/// The median and the quartiles of a quantity in words.
pub(super) fn quartiles(summary: &QuantitySummary, quantity: Quantity) -> String {
    of(summary, quantity, |of| {
        let [_, first, median, third, _] = of.quartiles.0.map(|value| figure(quantity, value));
        format!("{median} ({first} to {third})")
    })
}

fn of(
    summary: &QuantitySummary,
    quantity: Quantity,
    words: impl Fn(&Statistics) -> String,
) -> String {
    summary
        .get(&quantity)
        .map_or_else(|| NONE.to_owned(), words)
}

/// A row of a table in Markdown.
pub(super) fn row(cells: impl IntoIterator<Item = String>) -> String {
    // A bar would part a cell.
    let cells: Vec<String> = cells
        .into_iter()
        .map(|cell| cell.replace('|', "\\|"))
        .collect();
    format!("| {} |\n", cells.join(" | "))
}

/// The first two rows of one.
pub(super) fn header(names: impl IntoIterator<Item = String>) -> String {
    let names: Vec<String> = names.into_iter().collect();
    let rule = "|---".repeat(names.len());
    format!("{}{rule}|\n", row(names))
}
