//! Formats numbers beside their limits, with enough digits to distinguish them.

/// Largest number of decimals.
const MOST: usize = 12;

/// Formats a number with at least `decimals` decimals. More decimals are added if the number would
/// otherwise read as its limit, or as on the other side of it.
pub(crate) fn format_beside_limit(limit: f64, number: f64, decimals: usize) -> String {
    let is_apart = |text: &String| {
        let shown = text.parse::<f64>();
        shown.is_ok_and(|shown| (shown < limit) == (number < limit) && shown != limit)
    };
    (decimals..=MOST)
        .map(|decimals| format!("{number:.decimals$}"))
        .find(is_apart)
        .unwrap_or_else(|| format!("{number:.decimals$}"))
}

#[cfg(test)]
mod tests {
    use super::format_beside_limit;

    #[test]
    fn a_number_near_its_limit_has_more_digits() {
        assert_eq!(format_beside_limit(0.005, 0.00312, 4), "0.0031");
        assert_eq!(format_beside_limit(0.005, 0.0049987, 4), "0.004999");
        assert_eq!(format_beside_limit(0.25, 0.25004, 4), "0.25004");
        assert_eq!(format_beside_limit(0.005, -0.02, 4), "-0.0200");
        // Equal numbers read alike.
        assert_eq!(format_beside_limit(0.5, 0.5, 2), "0.50");
    }
}
