//! Trends over the episodes with a surface or tool: a least-squares line through the first rounds since the last sudden
//! change.
//!
//! Changes are found by binary segmentation. A series is split where two lines fit so much better than one that chance
//! does not explain it (Bayesian information criterion, Schwarz 1978, with a stricter penalty).

use super::rows::node_name;
use super::term::Term;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId, entries};
use std::collections::{BTreeMap, HashMap};

/// Least number of episodes for a trend.
const FEWEST: usize = 5;
/// Least number of episodes on either side of a change, so that a single outlier is not a change.
const FEWEST_BESIDE_CHANGE: usize = 4;
/// Penalty of a change in log-likelihood: a factor on the logarithm of the length, and a constant.
const PENALTY: [f64; 2] = [5.0, 5.0];
/// Share of a change in height above which the tool is its cause, and below which the tool has no part in it [1].
const IS_CAUSE: f64 = 0.7;
const IS_NO_CAUSE: f64 = 0.3;
/// Least change in height whose cause is determined [m].
const LEAST_OFFSET: f64 = 1e-3;

/// A quantity whose trend over episodes is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drift {
    /// Mean contact force on a surface [N], without its sign.
    ContactForce,
    /// Localisation error of a surface along its normal [m].
    Localization,
    /// Stiffness of a tool [N/m]; its logarithm changes linearly.
    Wear,
}

impl Drift {
    /// Returns the quantity with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "contact_force" => Self::ContactForce,
            "localization" => Self::Localization,
            "wear" => Self::Wear,
            _ => return None,
        })
    }

    /// Relation of the round that groups episodes, and value whose trend is computed.
    const fn properties(self) -> [&'static str; 2] {
        match self {
            Self::ContactForce => ["semco:actsOnSurface", "semco:meanNormalForce"],
            Self::Localization => ["semco:actsOnSurface", "semco:planeOffset"],
            Self::Wear => ["semco:usesTool", "semco:toolStiffness"],
        }
    }

    /// Returns the value in the scale of the fit; `None` for a value outside that scale.
    fn scale(self, value: f64) -> Option<f64> {
        let scaled = match self {
            Self::ContactForce => value.abs(),
            Self::Localization => value,
            Self::Wear => value.ln(),
        };
        scaled.is_finite().then_some(scaled)
    }

    fn unscaled(self, value: f64) -> f64 {
        match self {
            Self::ContactForce | Self::Localization => value,
            Self::Wear => value.exp(),
        }
    }

    /// Least standard deviation of the values, in the scale of the fit.
    const fn scatter(self) -> f64 {
        match self {
            Self::ContactForce => 0.05,
            Self::Localization => 2e-4,
            Self::Wear => 0.02,
        }
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

/// Returns the first rounds by the object of a relation, in the order of their episodes' ends.
fn first_rounds(
    catalogue: &Catalogue,
    [relation, property]: [&str; 2],
    [from, to]: [f64; 2],
) -> BTreeMap<String, Vec<Point>> {
    let mut by_node: HashMap<CatalogueNode, Vec<Point>> = HashMap::new();
    let values = catalogue.numbers(property);
    // Only rounds have a number.
    for &(round, number) in catalogue.numbers("semco:round") {
        let node = entries(catalogue.relations(relation), round).first();
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

fn scale(drift: Drift, points: Vec<Point>) -> Vec<Point> {
    let scaled = points.into_iter();
    let scaled = scaled.filter_map(|point| {
        let value = drift.scale(point.value)?;
        Some(Point { value, ..point })
    });
    scaled.collect()
}

/// Returns `t(Thing, Slope, First, Last)` for each surface or tool: the slope per episode since the last sudden change,
/// and both ends of the line, over the episodes in an interval [s since 1970].
pub fn drifts(catalogue: &Catalogue, drift: Drift, within: [f64; 2]) -> Vec<Term> {
    let series = first_rounds(catalogue, drift.properties(), within).into_iter();
    let lines = series.filter_map(|(name, points)| {
        let points = scale(drift, points);
        let values: Vec<f64> = points.iter().map(|point| point.value).collect();
        let since = changes_of(&values, drift.scatter())
            .last()
            .copied()
            .unwrap_or(0);
        let latest = &values[since..];
        (latest.len() >= FEWEST).then(|| {
            let [slope, first, last] = line(latest);
            let [first, last] = [first, last].map(|value| drift.unscaled(value));
            let line = [slope, first, last].map(Term::Float);
            Term::compound("t", [vec![Term::Atom(name)], line.to_vec()].concat())
        })
    });
    lines.collect()
}

/// Returns `c(Thing, Time, Before, After)` for each sudden change: begin of the first episode after it [s since 1970],
/// and the values before and after.
pub fn changes(catalogue: &Catalogue, drift: Drift, within: [f64; 2]) -> Vec<Term> {
    let mut found = Vec::new();
    for (name, points) in first_rounds(catalogue, drift.properties(), within) {
        let points = scale(drift, points);
        let values: Vec<f64> = points.iter().map(|point| point.value).collect();
        let places = changes_of(&values, drift.scatter());
        let bounds: Vec<usize> = [vec![0], places.clone(), vec![values.len()]].concat();
        for (k, place) in places.iter().enumerate() {
            let [_, _, before] = line(&values[bounds[k]..*place]);
            let [_, after, _] = line(&values[*place..bounds[k + 2]]);
            let [before, after] = [before, after].map(|value| drift.unscaled(value));
            let numbers = [points[*place].begin, before, after].map(Term::Float);
            let parts = [vec![Term::atom(&name)], numbers.to_vec()].concat();
            found.push(Term::compound("c", parts));
        }
    }
    found
}

/// Returns `s(Change, Cause)` for each surface whose localisation error changed: the change [m] and its cause.
///
/// A softer tool is compressed further by the same force: at stiffness k and force F, the tool centre point is F / k
/// lower.
pub fn causes(catalogue: &Catalogue, within: [f64; 2]) -> Vec<Term> {
    let number = |property: &str, round| {
        let value = entries(catalogue.numbers(property), round).first();
        value.map(|(_, value)| *value)
    };
    let mut found = Vec::new();
    for (name, points) in first_rounds(catalogue, Drift::Localization.properties(), within) {
        let count = points.len();
        if count < FEWEST {
            continue;
        }
        // Means of the first and last third, which cover sudden and gradual changes.
        let some = (count / 3).max(2);
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let change = |values: &[f64]| mean(&values[count - some..]) - mean(&values[..some]);
        let offsets: Vec<f64> = points.iter().map(|point| point.value).collect();
        let moved = change(&offsets);
        if moved.abs() < LEAST_OFFSET {
            continue;
        }
        let sunk = points.iter().map(|point| {
            let force = number("semco:meanNormalForce", point.round)?;
            let stiffness = number("semco:toolStiffness", point.round)?;
            (stiffness > 0.0).then(|| -force.abs() / stiffness)
        });
        let cause = match sunk.collect::<Option<Vec<f64>>>() {
            None => "unknown",
            Some(sunk) => {
                let by_tool = change(&sunk) / moved;
                if by_tool >= IS_CAUSE && moved < 0.0 {
                    "worn_tool"
                } else if by_tool >= IS_CAUSE {
                    "stiffer_tool"
                } else if by_tool > IS_NO_CAUSE {
                    "tool_and_surface"
                } else if moved < 0.0 {
                    "lowered_surface"
                } else {
                    "raised_surface"
                }
            }
        };
        let parts = [Term::Atom(name), Term::Float(moved), Term::atom(cause)];
        found.push(Term::compound("s", parts));
    }
    found
}

/// Returns time and value of each first round with a thing, in order: `Time-Value` [s since 1970].
pub fn series(catalogue: &Catalogue, drift: Drift, thing: &str) -> Vec<Term> {
    let all = [f64::NEG_INFINITY, f64::INFINITY];
    let mut by_name = first_rounds(catalogue, drift.properties(), all);
    let points = by_name.remove(thing).unwrap_or_default();
    let pairs = points.iter();
    let pairs = pairs.map(|point| Term::compound("-", [point.begin, point.value].map(Term::Float)));
    pairs.collect()
}

/// Returns the first index after each sudden change, in order.
fn changes_of(values: &[f64], scatter: f64) -> Vec<usize> {
    let mut places = Vec::new();
    split(values, 0, scatter, &mut places);
    places.sort_unstable();
    places
}

fn split(values: &[f64], from: usize, scatter: f64, places: &mut Vec<usize>) {
    let count = values.len();
    if count < 2 * FEWEST_BESIDE_CHANGE {
        return;
    }
    let splits = FEWEST_BESIDE_CHANGE..=count - FEWEST_BESIDE_CHANGE;
    let costs = splits.map(|k| (k, squares(&values[..k]) + squares(&values[k..])));
    let Some((place, two)) = costs.min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return;
    };
    let n = count as f64;
    let variance = |squares: f64| squares / n + scatter * scatter;
    // Twice the gain in log-likelihood of normal residuals: n ln(S₁ / S₂).
    let gain = n * (variance(squares(values)) / variance(two)).ln();
    if gain > PENALTY[0] * n.ln() + PENALTY[1] {
        places.push(from + place);
        split(&values[..place], from, scatter, places);
        split(&values[place..], from + place, scatter, places);
    }
}

/// Returns the sum of squared residuals of the line.
fn squares(values: &[f64]) -> f64 {
    let [slope, first, _] = line(values);
    let left = (values.iter().enumerate()).map(|(x, y)| y - first - slope * x as f64);
    left.map(|left| left * left).sum()
}

/// Fits a least-squares line through equidistant values. Returns slope, first and last value of the line.
#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
fn line(values: &[f64]) -> [f64; 3] {
    let [mut sx, mut sy, mut sxx, mut sxy] = [0.0; 4];
    for (place, y) in values.iter().enumerate() {
        let x = place as f64;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    let n = values.len() as f64;
    // Normal equations: slope = (n Σxy − Σx Σy) / (n Σx² − (Σx)²).
    let slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    let first = (sy - slope * sx) / n;
    [slope, first, first + slope * (n - 1.0)]
}

#[cfg(test)]
mod tests {
    use super::{changes_of, line};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn a_line_is_recovered() {
        let values: Vec<f64> = (0..7).map(|x| 3.0 - 0.25 * f64::from(x)).collect();
        let found = line(&values);
        for (found, is) in found.iter().zip([-0.25, 3.0, 1.5]) {
            assert!((found - is).abs() < 1e-12, "{found} for {is}");
        }
    }

    /// Offsets [m] with a standard deviation of about half a millimetre.
    fn scattered(seed: u64, of: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        // The sum of three uniform numbers is approximately normal.
        let mut noise = || {
            (0..3)
                .map(|_| random.random_range(-0.5e-3..0.5e-3))
                .sum::<f64>()
        };
        (0..20).map(|k| of(k) + noise()).collect()
    }

    #[test]
    fn a_step_is_located_and_a_slope_has_no_step() {
        let mut found_elsewhere = 0;
        for seed in 0..100 {
            let step = scattered(seed, |k| if k < 12 { 0.0 } else { -5e-3 });
            let found = changes_of(&step, 2e-4);
            assert_eq!(found.len(), 1, "{seed}: {found:?}");
            found_elsewhere += usize::from(found != [12]);
            let slope = scattered(seed, |k| -3e-4 * k as f64);
            assert_eq!(changes_of(&slope, 2e-4), [0; 0], "{seed}");
            let mut outlier = scattered(seed, |_| 0.0);
            outlier[9] = 5e-3;
            assert_eq!(changes_of(&outlier, 2e-4), [0; 0], "{seed}");
        }
        assert!(found_elsewhere < 5, "{found_elsewhere}");
    }
}
