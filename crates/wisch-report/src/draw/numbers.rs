//! Formats of numbers in pictures and on pages.

/// Formats a coordinate of a picture to a tenth of a unit.
pub(crate) fn px(value: f64) -> String {
    let tenths = (value * 10.0).round() as i64;
    if tenths % 10 == 0 {
        (tenths / 10).to_string()
    } else {
        format!("{:.1}", tenths as f64 / 10.0)
    }
}

/// Formats a number with a given number of digits and a typographic minus sign.
pub(crate) fn format_decimal(value: f64, digits: usize) -> String {
    let text = format!("{:.digits$}", value.abs());
    if value < 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        format!("\u{2212}{text}")
    } else {
        text
    }
}

/// Formats a share as per cent with one decimal.
pub(crate) fn format_percent(share: f64) -> String {
    format!("{:.1} %", share * 100.0)
}

/// Formats a count with separated thousands.
pub(crate) fn group_thousands(count: usize) -> String {
    let digits = count.to_string();
    let first = digits.len() % 3;
    digits
        .char_indices()
        .flat_map(|(i, digit)| {
            let gap = i > 0 && i % 3 == first;
            gap.then_some('\u{202f}').into_iter().chain([digit])
        })
        .collect()
}

/// Returns the smallest round step (1, 2 or 5 times a power of ten) of at least `wanted`.
pub(crate) fn find_tick_step(wanted: f64) -> f64 {
    if !(wanted.is_finite() && wanted > 0.0) {
        return 1.0;
    }
    let power = 10f64.powf(wanted.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|f| f * power >= wanted * (1.0 - 1e-9))
        .unwrap_or(10.0);
    factor * power
}

/// Returns the number of decimals that distinguish multiples of `step`.
pub(crate) fn count_decimals(step: f64) -> usize {
    (-(step.log10() + 1e-9).floor()).clamp(0.0, 6.0) as usize
}

/// Returns the smallest and the largest value; 0 and 0 without values.
pub(crate) fn find_range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    if low <= high { (low, high) } else { (0.0, 0.0) }
}
