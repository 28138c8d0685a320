//! How a value changes over the episodes on a surface: least squares over the first rounds of each.

use super::rows::node_name;
use super::term::Term;
use crate::catalogue::{Catalogue, Node, entries};
use std::collections::{BTreeMap, HashMap};

/// Fewest episodes that make a trend.
const FEWEST: usize = 5;

/// `t(Surface, Slope, First, Last)` for each surface: what a property of first rounds loses or gains by the episode, and
/// where the line begins and ends; of values without their sign where `is_absolute`.
pub fn trends(catalogue: &Catalogue, property: &str, is_absolute: bool) -> Vec<Term> {
    let mut by_surface: HashMap<Node, Vec<(f64, f64)>> = HashMap::new();
    let values = catalogue.numbers(property);
    // Only rounds have a number.
    for &(id, round) in catalogue.numbers("semco:round") {
        let surface = entries(catalogue.relations("semco:actsOnSurface"), id).first();
        if round < 1.5
            && let (Some([start, _]), Some((_, surface))) = (catalogue.interval(id), surface)
        {
            let series = by_surface.entry(*surface).or_default();
            let values = entries(values, id).iter().map(|(_, value)| *value);
            let amounts = values.map(|value| if is_absolute { value.abs() } else { value });
            series.extend(amounts.map(|value| (start, value)));
        }
    }
    let named = by_surface.into_iter();
    let named = named.filter_map(|(surface, values)| match node_name(catalogue, surface) {
        Term::Atom(name) => Some((name, values)),
        _ => None,
    });
    let series: BTreeMap<String, Vec<(f64, f64)>> = named.collect();
    let long = series
        .into_iter()
        .filter(|(_, values)| values.len() >= FEWEST);
    let trends = long.map(|(surface, mut values)| {
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        let values: Vec<f64> = values.into_iter().map(|(_, value)| value).collect();
        let line = line(&values).map(Term::Float);
        Term::compound("t", [vec![Term::Atom(surface)], line.to_vec()].concat())
    });
    trends.collect()
}

/// The least squares line through values in a row: slope, first and last.
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
    let slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    let first = (sy - slope * sx) / n;
    [slope, first, first + slope * (n - 1.0)]
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn a_line_is_found_again() {
        let values: Vec<f64> = (0..7).map(|x| 3.0 - 0.25 * f64::from(x)).collect();
        let found = line(&values);
        for (found, is) in found.iter().zip([-0.25, 3.0, 1.5]) {
            assert!((found - is).abs() < 1e-12, "{found} for {is}");
        }
    }
}
