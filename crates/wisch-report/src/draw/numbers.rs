//! Numbers as they stand in pictures and on pages.

/// A coordinate of a picture, to a tenth of a unit.
pub(crate) fn px(value: f64) -> String {
    let tenths = (value * 10.0).round() as i64;
    if tenths % 10 == 0 {
        (tenths / 10).to_string()
    } else {
        format!("{:.1}", tenths as f64 / 10.0)
    }
}

/// A number of metres with a true minus sign.
pub(crate) fn metres(value: f64, digits: usize) -> String {
    let text = format!("{:.digits$}", value.abs());
    if value < 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        format!("\u{2212}{text}")
    } else {
        text
    }
}

/// A share as per cent with one decimal.
pub(crate) fn percent(share: f64) -> String {
    format!("{:.1} %", share * 100.0)
}

/// A count with its thousands set apart.
pub(crate) fn grouped(count: usize) -> String {
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

/// The round step (1, 2 or 5 times a power of ten) nearest above `wanted`.
pub(crate) fn tick_step(wanted: f64) -> f64 {
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

/// Decimals needed to tell multiples of `step` apart.
pub(crate) fn decimals(step: f64) -> usize {
    (-(step.log10() + 1e-9).floor()).clamp(0.0, 6.0) as usize
}

/// Smallest and largest; 0 where there are none.
pub(crate) fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    if low <= high { (low, high) } else { (0.0, 0.0) }
}
