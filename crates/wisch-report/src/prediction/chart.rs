//! Performance over the distance wiped.

use super::layers::Drawing;
use crate::draw::{Panel, Pen, axes, count_decimals, find_tick_step, format_decimal, px};
use maud::html;

const HEIGHT: f64 = 210.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 170.0;

/// Returns the x coordinate of a distance [m] out of `total` in a chart of a given width.
pub(crate) fn across(distance: f64, total: f64, width: f64) -> f64 {
    let share = if total > 0.0 { distance / total } else { 0.0 };
    LEFT + share * (width - LEFT - RIGHT)
}

/// Returns the y coordinate of a performance in [0, 1].
pub(crate) fn down(performance: f64) -> f64 {
    BOTTOM - performance * (BOTTOM - TOP)
}

/// Draws the performance over the distance in contact.
pub(crate) fn performance(drawing: &Drawing, width: f64) -> Panel {
    let frames = drawing.input.frames.frames();
    let total = frames.last().map_or(0.0, |frame| frame.distance);
    let places: Vec<(f64, f64)> = frames
        .iter()
        .map(|f| {
            (
                across(f.distance, total, width),
                down(f.performance.ratio()),
            )
        })
        .collect();
    let (mut curve, mut under) = (Pen::default(), Pen::default());
    curve.line(places.iter().copied());
    if let (Some(first), Some(last)) = (places.first(), places.last()) {
        under.line(
            [(first.0, BOTTOM)]
                .into_iter()
                .chain(places.iter().copied())
                .chain([(last.0, BOTTOM)]),
        );
        under.close();
    }
    let step = find_tick_step(total / (width / 110.0));
    let digits = count_decimals(step);
    let last = if total > 0.0 {
        (total / step + 1e-9) as i64
    } else {
        0
    };
    let ticks = (0..=last).map(|tick| {
        let distance = tick as f64 * step;
        (
            across(distance, total, width),
            format_decimal(distance, digits),
        )
    });
    let body = html! {
        text class="text small quiet" x=("12") y=(px(TOP - 12.0)) { (drawing.achieved()) }
        (axes::draw_ticks_beside(axes::list_quarters(down), [LEFT, width - RIGHT], 8.0))
        (axes::draw_ticks_below(ticks, BOTTOM, 19.0))
        path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(BOTTOM), px(width - RIGHT))) {}
        path class="under" d=(under.path()) {}
        path class="curve" d=(curve.path()) {}
        text class="text small quiet end" x=(px(width - RIGHT)) y=(px(BOTTOM + 35.0)) { "distance in contact [m]" }
    };
    Panel {
        width,
        height: HEIGHT,
        body,
    }
}
