//! Robust statistics of weighted values.

/// Weighted median. The weights are times, as a fast motion yields the most pieces. 0 for an empty list.
pub(in crate::interpret) fn median(mut weighed: Vec<(f64, f64)>) -> f64 {
    weighed.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let all: f64 = weighed.iter().map(|&(_, weight)| weight).sum();
    let mut passed = 0.0;
    let middle = weighed.iter().find(|&&(_, weight)| {
        passed += 2.0 * weight;
        passed > all
    });
    middle.or(weighed.last()).map_or(0.0, |&(value, _)| value)
}

/// Standard deviation of weighted values about `middle`, from the median of their distances.
pub(super) fn spread(weighed: Vec<(f64, f64)>, middle: f64) -> f64 {
    let distances = weighed
        .into_iter()
        .map(|(value, weight)| ((value - middle).abs(), weight));
    1.4826 * median(distances.collect())
}

/// Returns the mode of values by the half-sample method: halves of least width, one inside the other (Robertson and
/// Cryer, 1974). `None` for an empty list.
pub(super) fn mode(mut values: Vec<f64>) -> Option<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let mut part = &values[..];
    // Within an eighth of the sample it is chance which half is narrower.
    while part.len() > 8.max(values.len() / 8) {
        let half = part.len().div_ceil(2);
        let width = |first: usize| part[first + half - 1] - part[first];
        let first = (0..=part.len() - half).min_by(|&a, &b| width(a).total_cmp(&width(b)))?;
        part = &part[first..first + half];
    }
    part.get(part.len() / 2).copied()
}
