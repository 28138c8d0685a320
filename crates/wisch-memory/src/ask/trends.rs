//! Trends over the episodes with a surface or tool, as terms: a robust line through the first rounds since the last sudden
//! change.

use super::rows::node_name;
use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId, entries};
use crate::health::{
    ChannelState, HealthChannel, LEAST_OFFSET, RobustLine, assess_groups, find_cause, find_changes,
    gather_groups, median,
};
use std::collections::{BTreeMap, HashMap};

/// Least number of episodes for a line.
const FEWEST: usize = 5;
/// Episodes at either end of a series from whose median its first and last value follow: one outlier is ignored.
const NEWEST: usize = 3;
/// Probability up to which chance does not explain a slope [1].
const MAX_P_VALUE: f64 = 0.05;

/// Returns the quantity whose trend a query calls by this name.
pub fn channel_of(name: &str) -> Option<HealthChannel> {
    Some(match name {
        "contact_force" => HealthChannel::ContactForce,
        "localization" => HealthChannel::Offset,
        "wear" => HealthChannel::Stiffness,
        _ => return None,
    })
}

/// Relation of the round by which episodes are grouped.
const fn grouping(channel: HealthChannel) -> &'static str {
    match channel {
        HealthChannel::Stiffness => "semco:usesTool",
        _ => "semco:actsOnSurface",
    }
}

/// A first round: begin and end of its episode [s since 1970], and a value.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    begin: f64,
    end: f64,
    value: f64,
    round: IndividualId,
}

/// Returns the first rounds by surface or tool, in the order of their episodes' ends.
fn first_rounds(
    catalogue: &Catalogue,
    channel: HealthChannel,
    [from, to]: [f64; 2],
) -> BTreeMap<String, Vec<Point>> {
    let mut by_node: HashMap<CatalogueNode, Vec<Point>> = HashMap::new();
    let values = catalogue.numbers(channel.property());
    // Only rounds have a number.
    for &(round, number) in catalogue.numbers("semco:round") {
        let node = entries(catalogue.relations(grouping(channel)), round).first();
        let value = entries(values, round).first();
        if let (true, Some((_, node)), Some((_, value))) = (number < 1.5, node, value) {
            let [begin, end] = catalogue.episode_of(round).interval;
            if from <= begin && end <= to {
                let point = Point {
                    begin,
                    end,
                    value: *value,
                    round,
                };
                by_node.entry(*node).or_default().push(point);
            }
        }
    }
    let named = by_node.into_iter();
    let named = named.filter_map(|(node, mut points)| {
        // A simulation runs faster than the clock, so an episode may begin before the end of the previous one.
        points.sort_by(|a, b| (a.end.total_cmp(&b.end)).then(a.begin.total_cmp(&b.begin)));
        match node_name(catalogue, node) {
            Term::Atom(name) => Some((name, points)),
            _ => None,
        }
    });
    named.collect()
}

fn scale(channel: HealthChannel, points: Vec<Point>) -> Vec<Point> {
    let scaled = points.into_iter();
    let scaled = scaled.filter_map(|point| {
        let value = channel.scale(point.value)?;
        Some(Point { value, ..point })
    });
    scaled.collect()
}

/// Returns the first index after each sudden change, in order.
fn changes_of(channel: HealthChannel, values: &[f64]) -> Vec<usize> {
    let found = find_changes(values, channel.resolution()).into_iter();
    found.map(|change| change.place).collect()
}

/// Returns `t(Thing, Slope, First, Last)` for each surface or tool: the slope per episode since the last sudden change,
/// and both ends of the line, over the episodes in an interval [s since 1970].
pub fn drifts(catalogue: &Catalogue, channel: HealthChannel, within: [f64; 2]) -> Vec<Term> {
    let series = first_rounds(catalogue, channel, within).into_iter();
    let lines = series.filter_map(|(name, points)| {
        let points = scale(channel, points);
        let values: Vec<f64> = points.iter().map(|point| point.value).collect();
        let since = changes_of(channel, &values).last().copied().unwrap_or(0);
        let latest = &values[since..];
        (latest.len() >= FEWEST).then(|| {
            let fitted = RobustLine::fit(latest, channel.resolution());
            let [first, last] = fitted.ends.map(|value| channel.unscaled(value));
            let line = [fitted.slope, first, last].map(Term::Float);
            Term::compound("t", [vec![Term::Atom(name)], line.to_vec()].concat())
        })
    });
    lines.collect()
}

/// Returns `d(runs(Robot, Tool, Surface), Channel, PerRun, P, Runs)` for each drift of the health report: change per run
/// in the channel's unit, adjusted probability that chance explains it, and runs until a limit, or `none`.
pub fn health_drifts(catalogue: &Catalogue) -> Vec<Term> {
    let none = || Term::atom("none");
    let thing = |name: &Option<String>| match name {
        Some(name) => Term::Atom(format!("semco:{name}")),
        None => none(),
    };
    let mut found = Vec::new();
    for group in assess_groups(&gather_groups(catalogue)).groups {
        let runs = [&group.robot, &group.tool, &group.surface].map(thing);
        for health in &group.channels {
            let ChannelState::Assessed(assessed) = &health.state else {
                continue;
            };
            if let Some(trend) = assessed.trend.as_ref().filter(|trend| trend.is_drift) {
                let left = trend.runs_to_limit.as_ref();
                let parts = vec![
                    Term::compound("runs", runs.to_vec()),
                    Term::Atom(health.channel.as_str().replace(' ', "_")),
                    Term::Float(trend.per_run),
                    Term::Float(trend.p_adjusted),
                    left.map_or_else(none, |left| Term::Float(left.estimate)),
                ];
                found.push(Term::compound("d", parts));
            }
        }
    }
    found
}

/// Returns `c(Thing, Time, Before, After)` for each sudden change: start of the first episode after it [s since 1970],
/// and the values before and after.
pub fn changes(catalogue: &Catalogue, channel: HealthChannel, within: [f64; 2]) -> Vec<Term> {
    let mut found = Vec::new();
    for (name, points) in first_rounds(catalogue, channel, within) {
        let points = scale(channel, points);
        let values: Vec<f64> = points.iter().map(|point| point.value).collect();
        let places = changes_of(channel, &values);
        let bounds: Vec<usize> = [vec![0], places.clone(), vec![values.len()]].concat();
        let ends =
            |from: usize, to: usize| RobustLine::fit(&values[from..to], channel.resolution()).ends;
        for (k, place) in places.iter().enumerate() {
            let [_, before] = ends(bounds[k], *place);
            let [after, _] = ends(*place, bounds[k + 2]);
            let [before, after] = [before, after].map(|value| channel.unscaled(value));
            let numbers = [points[*place].begin, before, after].map(Term::Float);
            let parts = [vec![Term::atom(&name)], numbers.to_vec()].concat();
            found.push(Term::compound("c", parts));
        }
    }
    found
}

/// Returns the value at the last place of a series, the median of the newest episodes, moved to the last one by the robust
/// slope since the last sudden change, unless chance explains it. A lasting change counts as soon as most of these episodes show it.
fn end_of(channel: HealthChannel, values: &[f64]) -> f64 {
    let since = changes_of(channel, values).last().copied().unwrap_or(0);
    let latest = &values[since..];
    let newest = &latest[latest.len().saturating_sub(NEWEST)..];
    let line = RobustLine::fit(latest, channel.resolution());
    let slope = if line.p <= MAX_P_VALUE {
        line.slope
    } else {
        0.0
    };
    median(&mut newest.to_vec()) + slope * 0.5 * newest.len().saturating_sub(1) as f64
}

/// Returns `s(Name, Change, Cause)` for each surface whose localisation error changed: the change from the first to the
/// last episode [m], see [`end_of`], and its cause.
pub fn causes(catalogue: &Catalogue, within: [f64; 2]) -> Vec<Term> {
    let number = |property: &str, round| {
        let value = entries(catalogue.numbers(property), round).first();
        value.map(|(_, value)| *value)
    };
    let series = first_rounds(catalogue, HealthChannel::Offset, within).into_iter();
    let found = series.filter_map(|(name, points)| {
        let offsets: Vec<f64> = points.iter().map(|point| point.value).collect();
        let touches = points.iter().map(|point| {
            let channels = [HealthChannel::ContactForce, HealthChannel::Stiffness];
            channels.map(|channel| number(channel.property(), point.round))
        });
        let (by_means, cause) = find_cause(&offsets, &touches.collect::<Vec<_>>(), None)?;
        let reversed: Vec<f64> = offsets.iter().rev().copied().collect();
        let [first, last] = [&reversed, &offsets].map(|way| end_of(HealthChannel::Offset, way));
        let moved = last - first;
        // A surface that moved and came back has no change from the first episode to the last.
        if moved.abs() < LEAST_OFFSET || moved * by_means <= 0.0 {
            return None;
        }
        let parts = [
            Term::Atom(name),
            Term::Float(moved),
            Term::atom(cause.as_str()),
        ];
        Some(Term::compound("s", parts))
    });
    found.collect()
}

/// Returns time and value of each first round with a thing, in order: `Time-Value` [s since 1970].
pub fn series(catalogue: &Catalogue, channel: HealthChannel, thing: &str) -> Vec<Term> {
    let all = [f64::NEG_INFINITY, f64::INFINITY];
    let mut by_name = first_rounds(catalogue, channel, all);
    let points = by_name.remove(thing).unwrap_or_default();
    let pairs = points.iter();
    let pairs = pairs.map(|point| Term::compound("-", [point.begin, point.value].map(Term::Float)));
    pairs.collect()
}
