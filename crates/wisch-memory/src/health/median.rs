//! The median, and the standard deviation that follows from deviations from it.

/// Standard deviation of normal numbers over their median absolute deviation.
pub(super) const DEVIATION_OF_MEDIAN: f64 = 1.4826;

/// Returns the median, for an even number the mean of the two middle values; 0 for no values. Reorders the values.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    let count = values.len();
    if count == 0 {
        return 0.0;
    }
    let (below, &mut upper, _) = values.select_nth_unstable_by(count / 2, f64::total_cmp);
    if count % 2 == 1 {
        return upper;
    }
    let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    0.5 * (lower + upper)
}
