//! The table `drift`: the assessment of `wisch memory health` over the first rounds of all sources. No file holds it.

use super::columns::{
    Column, ColumnKind, MEDIUM, PRESS_FORCE, ROBOT, SURFACE, TOOL, Table, column,
};
use super::project::UNKNOWN_ROBOT;
use super::rows::{Cell, Rows};
use datafusion::arrow::array::{Array, AsArray, Float64Array, RecordBatch, StringArray};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type};
use datafusion::common::{DataFusionError, Result};
use wisch_memory::health::{
    ChannelAssessment, ChannelHealth, ChannelState, FirstRun, GroupHealth, HealthChannel,
    assess_groups, group_runs,
};

const PER_CHANNEL: &str = "unit of the channel";

const fn number(name: &'static str, about: &'static str) -> Column {
    column(name, ColumnKind::Number, PER_CHANNEL, about)
}

/// The table `drift`.
pub const DRIFT: Table = Table {
    name: "drift",
    about: "one row per channel of comparable runs, as `wisch memory health` assesses them; computed for each statement",
    columns: &[
        ROBOT,
        TOOL,
        SURFACE,
        MEDIUM,
        PRESS_FORCE,
        column(
            "source",
            ColumnKind::Text,
            "–",
            "`executed`, `simulated`, or `imported logs`",
        ),
        column(
            "runs",
            ColumnKind::Whole,
            "–",
            "number of comparable runs with a date",
        ),
        column(
            "channel",
            ColumnKind::Text,
            "–",
            "quantity that is assessed, such as `surface offset`",
        ),
        column("unit", ColumnKind::Text, "–", "its unit; 1 for a share"),
        column(
            "recorded",
            ColumnKind::Whole,
            "–",
            "number of runs that record the channel",
        ),
        column(
            "state",
            ColumnKind::Text,
            "–",
            "`assessed`, `too few`, `not recorded`, or `outdated`; all further columns are null unless `assessed`",
        ),
        number(
            "value",
            "present value by the line since the last sudden change; null if too few runs follow the change",
        ),
        number("value_low", "lower end of its 95 % interval"),
        number("value_high", "upper end of its 95 % interval"),
        number(
            "per_run",
            "change per run since the last sudden change; of a stiffness, the change of its logarithm",
        ),
        number("per_run_low", "lower end of its 95 % interval"),
        number("per_run_high", "upper end of its 95 % interval"),
        column(
            "p_value",
            ColumnKind::Number,
            "1",
            "probability that chance explains the change per run, adjusted to all tests of the table",
        ),
        column(
            "is_drift",
            ColumnKind::Truth,
            "–",
            "whether chance does not explain it; null if the runs are too few to show a drift",
        ),
        column(
            "changed_s",
            ColumnKind::Number,
            "s",
            "start of the first run after the last sudden change, since 1970 UTC; null without one",
        ),
        number("value_before", "value before that change"),
        number("value_after", "value after it"),
        column(
            "change_p_value",
            ColumnKind::Number,
            "1",
            "probability that chance explains that change, adjusted to all tests; the change is only possible above 0.01",
        ),
        column(
            "runs_since",
            ColumnKind::Whole,
            "–",
            "number of runs since that change, or of all runs",
        ),
        number("limit_low", "lower limit of the channel; null without one"),
        number("limit_high", "upper limit of the channel; null without one"),
        column(
            "runs_to_limit",
            ColumnKind::Number,
            "–",
            "forecast: number of runs until the limit; null without a drift towards a limit",
        ),
        column(
            "runs_to_limit_earliest",
            ColumnKind::Number,
            "–",
            "that number by the fastest change of the interval",
        ),
        column(
            "runs_to_limit_latest",
            ColumnKind::Number,
            "–",
            "that number by the slowest change; null if it never reaches the limit",
        ),
        column(
            "needs_attention",
            ColumnKind::Truth,
            "–",
            "whether something was found; null if nothing was, and the runs are too few to show a drift",
        ),
        column(
            "advice",
            ColumnKind::Text,
            "–",
            "what to do about it; null if nothing was found",
        ),
    ],
};

/// Statement over the first rounds; [`assess`] reads its answer.
pub const FIRST_ROUNDS: &str = "\
SELECT r.episode, r.robot, r.tool, r.surface, r.medium, r.press_force_n, r.true_performance, e.start_s, e.end_s, e.target,
       r.predicted_performance, r.mean_normal_force_n, r.contact_share, r.plane_offset_m, r.plane_tilt_rad,
       r.tool_stiffness_n_per_m,
       CASE WHEN r.verdict IN ('performance unknown', 'cannot be told') THEN NULL ELSE r.performance END AS performance
FROM rounds AS r JOIN episodes AS e ON r.episode = e.episode
WHERE r.round = 1";

/// Column of the first rounds that holds a channel.
const fn column_of(channel: HealthChannel) -> &'static str {
    match channel {
        HealthChannel::ContactForce => "mean_normal_force_n",
        HealthChannel::ContactShare => "contact_share",
        HealthChannel::Offset => "plane_offset_m",
        HealthChannel::Tilt => "plane_tilt_rad",
        HealthChannel::Stiffness => "tool_stiffness_n_per_m",
        HealthChannel::Performance => "performance",
    }
}

/// Returns the rows of the table from the first rounds.
///
/// # Errors
/// If the batches are not an answer to [`FIRST_ROUNDS`].
pub fn assess(first_rounds: &[RecordBatch]) -> Result<RecordBatch> {
    let mut runs = Vec::new();
    for batch in first_rounds {
        add_runs(batch, &mut runs)?;
    }
    // The order of an answer depends on the number of threads.
    runs.sort_by(|(a, _), (b, _)| a.cmp(b));
    let runs = runs.into_iter().map(|(_, run)| run);
    let mut rows = Rows::new(&DRIFT);
    for group in &assess_groups(&group_runs(runs)).groups {
        for channel in &group.channels {
            push(&mut rows, group, channel);
        }
    }
    Ok(rows.take())
}

/// Adds the first rounds of a batch, each with the name of its episode.
fn add_runs(batch: &RecordBatch, runs: &mut Vec<(String, FirstRun)>) -> Result<()> {
    let column = |name: &str, kind: &DataType| {
        let column = batch.column_by_name(name).ok_or_else(|| {
            DataFusionError::Internal(format!("the first rounds have no column {name}"))
        })?;
        Ok::<_, DataFusionError>(cast(column, kind)?)
    };
    let texts = |name| {
        let column = column(name, &DataType::Utf8)?;
        Ok::<_, DataFusionError>(column.as_string::<i32>().clone())
    };
    let numbers = |name| {
        let column = column(name, &DataType::Float64)?;
        Ok::<_, DataFusionError>(column.as_primitive::<Float64Type>().clone())
    };
    let names = ["robot", "tool", "surface", "medium"].map(texts);
    let [robot, tool, surface, medium] = names;
    let (robot, tool, surface, medium) = (robot?, tool?, surface?, medium?);
    let episode = texts("episode")?;
    let facts = [
        "press_force_n",
        "true_performance",
        "start_s",
        "end_s",
        "target",
        "predicted_performance",
    ];
    let [force, truth, start, end, target, predicted] = facts.map(numbers);
    let (force, truth, start) = (force?, truth?, start?);
    let (end, target, predicted) = (end?, target?, predicted?);
    let mut channels = Vec::new();
    for channel in HealthChannel::ALL {
        channels.push(numbers(column_of(channel))?);
    }
    for row in 0..batch.num_rows() {
        let text =
            |column: &StringArray| column.is_valid(row).then(|| column.value(row).to_owned());
        let number = |column: &Float64Array| column.is_valid(row).then(|| column.value(row));
        let run = FirstRun {
            robot: text(&robot).filter(|name| name != UNKNOWN_ROBOT),
            tool: text(&tool),
            surface: text(&surface),
            medium: text(&medium),
            press_force_n: number(&force),
            is_simulated: number(&truth).is_some(),
            interval: [&start, &end].map(|column| number(column).unwrap_or(f64::NAN)),
            values: HealthChannel::ALL.map(|channel| number(&channels[channel as usize])),
            target: number(&target),
            predicted: number(&predicted),
        };
        runs.push((text(&episode).unwrap_or_default(), run));
    }
    Ok(())
}

fn push(rows: &mut Rows, group: &GroupHealth, health: &ChannelHealth) {
    let whole = |count: usize| Cell::Whole(Some(i32::try_from(count).unwrap_or(i32::MAX)));
    let (state, assessed) = match &health.state {
        ChannelState::NotRecorded => ("not recorded", None),
        ChannelState::TooFew { .. } => ("too few", None),
        ChannelState::Outdated { .. } => ("outdated", None),
        ChannelState::Assessed(assessed) => ("assessed", Some(assessed.as_ref())),
    };
    let advice = assessed.map(|assessed| {
        let found = assessed.findings.iter().map(|finding| finding.advice);
        let mut advice: Vec<&str> = found.collect();
        advice.dedup();
        advice.join("; ")
    });
    let mut cells = vec![
        Cell::Text(Some(group.robot.as_deref().unwrap_or(UNKNOWN_ROBOT))),
        Cell::Text(group.tool.as_deref()),
        Cell::Text(group.surface.as_deref()),
        Cell::Text(group.medium.as_deref()),
        Cell::Number(group.press_force_n),
        Cell::Text(Some(group.source.as_str())),
        whole(group.runs),
        Cell::Text(Some(health.channel.as_str())),
        Cell::Text(Some(health.unit)),
        whole(health.recorded),
        Cell::Text(Some(state)),
    ];
    cells.extend(list_trend(assessed));
    cells.push(Cell::Text(
        advice.as_deref().filter(|advice| !advice.is_empty()),
    ));
    rows.push(&cells);
}

/// Returns the cells from `value` to `needs_attention`.
fn list_trend(assessed: Option<&ChannelAssessment>) -> [Cell<'static>; 19] {
    let trend = assessed.and_then(|assessed| assessed.trend.as_ref());
    let change = assessed.and_then(|assessed| assessed.change.as_ref());
    let left = trend.and_then(|trend| trend.runs_to_limit.as_ref());
    let limit = |side: usize| {
        let limit = assessed.and_then(|assessed| assessed.limits[side].as_ref());
        Cell::Number(limit.map(|limit| limit.value))
    };
    let can_show = trend.is_some_and(|trend| trend.can_show_drift);
    let is_found = assessed.map(|assessed| !assessed.findings.is_empty());
    let runs_since = assessed.and_then(|assessed| i32::try_from(assessed.runs_since).ok());
    [
        Cell::Number(trend.map(|trend| trend.value)),
        Cell::Number(trend.map(|trend| trend.value_within[0])),
        Cell::Number(trend.map(|trend| trend.value_within[1])),
        Cell::Number(trend.map(|trend| trend.per_run)),
        Cell::Number(trend.map(|trend| trend.per_run_within[0])),
        Cell::Number(trend.map(|trend| trend.per_run_within[1])),
        Cell::Number(trend.map(|trend| trend.p_adjusted)),
        Cell::Truth(trend.filter(|_| can_show).map(|trend| trend.is_drift)),
        Cell::Number(change.map(|change| change.time_s)),
        Cell::Number(change.map(|change| change.before)),
        Cell::Number(change.map(|change| change.after)),
        Cell::Number(change.map(|change| change.p_adjusted)),
        Cell::Whole(runs_since),
        limit(0),
        limit(1),
        Cell::Number(left.map(|left| left.estimate)),
        Cell::Number(left.map(|left| left.earliest)),
        Cell::Number(left.and_then(|left| left.latest)),
        Cell::Truth(is_found.filter(|is_found| *is_found || can_show)),
    ]
}
