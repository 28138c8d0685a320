//! Tables and numbers that the evaluations with wiping runs share.

use super::super::words::internal;
use crate::failure::Failure;
use wisch_eval::{ExecutionScore, Quantity, QuantitySummary, Statistics, WipingScore};

/// Cell of a missing value.
pub(super) const NONE: &str = "–";

/// Inverse of the resolution to which values are rounded, so that rounding errors do not show.
const PER_ONE: f64 = 1e9;

/// Names of the columns before and after a run's quantities.
const BEFORE: &str = "plan_strategy";
const AFTER: [&str; 5] = ["before", "low", "high", "verdict", "claimed"];

/// Formats the runs as CSV, one row per run. `names`: headings of the key cells that identify a run. Empty cells have no
/// value in this evaluation.
pub(super) fn format_runs_as_csv<'a>(
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
            let value = quantity.value(score);
            value.map_or_else(String::new, |value| value.to_string())
        });
        (keys.into_iter())
            .chain([score.strategy.clone()])
            .chain(after)
            .chain(values)
            .collect()
    });
    format_csv(header.map(str::to_owned).collect(), rows)
}

/// Formats a table as CSV (RFC 4180).
pub(super) fn format_csv(
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

/// Returns the heading of a quantity in tables and its number of decimals; shares are in percent.
pub(super) const fn find_heading(quantity: Quantity) -> (&'static str, usize) {
    match quantity {
        Quantity::Planned => ("planned %", 2),
        Quantity::Predicted => ("predicted %", 2),
        Quantity::Limited => ("within the paper's shortest path %", 2),
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

/// Formats a value of a quantity.
pub(super) fn format_figure(quantity: Quantity, value: f64) -> String {
    let (name, decimals) = find_heading(quantity);
    let factor = if name.ends_with('%') { 100.0 } else { 1.0 };
    // Means that differ only by rounding errors get the same text.
    let value = (factor * value * PER_ONE).round() / PER_ONE;
    format!("{value:.decimals$}")
}

/// Formats the mean of a quantity.
pub(super) fn format_mean(summary: &QuantitySummary, quantity: Quantity) -> String {
    of(summary, quantity, |of| format_figure(quantity, of.mean))
}

/// Formats the median and the quartiles of a quantity.
pub(super) fn format_quartiles(summary: &QuantitySummary, quantity: Quantity) -> String {
    of(summary, quantity, |of| {
        let [_, first, median, third, _] =
            of.quartiles.0.map(|value| format_figure(quantity, value));
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

/// Formats a row of a Markdown table.
pub(super) fn format_row(cells: impl IntoIterator<Item = String>) -> String {
    // An unescaped bar would split the cell.
    let cells: Vec<String> = cells
        .into_iter()
        .map(|cell| cell.replace('|', "\\|"))
        .collect();
    format!("| {} |\n", cells.join(" | "))
}

/// Formats the first two rows of a Markdown table.
pub(super) fn format_header(names: impl IntoIterator<Item = String>) -> String {
    let names: Vec<String> = names.into_iter().collect();
    let rule = "|---".repeat(names.len());
    format!("{}{rule}|\n", format_row(names))
}
