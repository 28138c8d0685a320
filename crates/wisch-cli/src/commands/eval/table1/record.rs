//! The record of a Table 1 evaluation, and the parts that all its output formats share.

use super::super::super::words::format_count;
use super::super::Provenance;
use serde::Serialize;
use wisch_eval::{PaperFigures, Quantity, Table1Row, Table1Run, Table1Setup, WipingExtent};

/// The record of an evaluation.
#[derive(Debug, Serialize)]
pub(super) struct Table1Record {
    #[serde(flatten)]
    pub(super) provenance: Provenance,
    pub(super) setup: Table1Setup,
    /// Number of the paper's cells in which its performance is reached, and number of the paper's cells.
    pub(super) reached: [usize; 2],
    pub(super) rows: Vec<Table1Row>,
    pub(super) runs: Vec<Table1Run>,
}

/// A column of the table: a quantity, and the paper's figure for it if the paper has one.
pub(super) type Column = (Quantity, Option<fn(&PaperFigures) -> f64>);

/// Returns the columns for the extent of an evaluation.
pub(super) fn list_columns(setup: &Table1Setup) -> Vec<Column> {
    let predicted: Column = (Quantity::Predicted, Some(|paper| paper.performance_percent));
    let mut columns = vec![predicted];
    if setup.extent != WipingExtent::Planned {
        columns.push((Quantity::Planned, None));
    }
    if setup.is_limited {
        columns.push((Quantity::Limited, None));
    }
    if setup.extent == WipingExtent::Executed {
        columns.extend([(Quantity::Estimated, None), (Quantity::Truth, None)]);
        columns.extend([(Quantity::TrueLoss, None), (Quantity::Rounds, None)]);
    }
    columns.push((Quantity::OutOfReach, None));
    columns.push((Quantity::DistanceM, Some(|paper| paper.distance_m)));
    columns.push((Quantity::Lifts, None));
    if setup.extent != WipingExtent::Planned {
        columns.push((Quantity::Abandoned, None));
        columns.push((Quantity::ExecutionS, Some(|paper| paper.execution_s)));
    }
    columns.push((Quantity::ComputationS, Some(|paper| paper.computation_s)));
    columns
}

/// Formats a figure of the paper; in brackets if the paper does not have the strategy.
pub(super) fn format_paper_figure(row: &Table1Row, figure: f64) -> String {
    if row.is_papers_own {
        format!("{figure:.2}")
    } else {
        format!("({figure:.2})")
    }
}

pub(super) fn write_lead(record: &Table1Record) -> String {
    let settings = record.setup.settings.iter();
    format!(
        "{}{}: {}.",
        record.provenance.in_words(record.setup.extent.as_str()),
        settings
            .map(|(key, value)| format!(", {key} = {value}"))
            .collect::<String>(),
        format_count(record.runs.len(), "run"),
    )
}
