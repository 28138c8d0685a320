//! Ticks and numbers of a plot's axes.

use super::numbers::px;
use maud::{Markup, html};

/// Draws ticks below a line at `y`, each with its number `drop` below the line.
pub(crate) fn draw_ticks_below(
    ticks: impl IntoIterator<Item = (f64, String)>,
    y: f64,
    drop: f64,
) -> Markup {
    html! {
        @for (x, number) in ticks {
            path class="axis" d=(format!("M{} {}v5", px(x), px(y))) {}
            text class="text small quiet middle" x=(px(x)) y=(px(y + drop)) { (number) }
        }
    }
}

/// Draws grid lines from `left` to `right`, each with its number `gap` to the left.
pub(crate) fn draw_ticks_beside(
    ticks: impl IntoIterator<Item = (f64, String)>,
    [left, right]: [f64; 2],
    gap: f64,
) -> Markup {
    html! {
        @for (y, number) in ticks {
            path class="rule" d=(format!("M{} {}H{}", px(left), px(y), px(right))) {}
            text class="text small quiet end" x=(px(left - gap)) y=(px(y + 4.0)) { (number) }
        }
    }
}

/// Returns the ticks 0, 25, 50, 75 and 100 % at the heights that `down` gives.
pub(crate) fn list_quarters(down: impl Fn(f64) -> f64) -> impl Iterator<Item = (f64, String)> {
    (0..=4).map(move |quarter| {
        let y = down(f64::from(quarter) / 4.0);
        (y, format!("{} %", 25 * quarter))
    })
}
