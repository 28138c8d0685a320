//! Performance over the distance wiped.

use super::panel::Panel;
use super::picture::Drawing;
use super::view::{Pen, decimals, metres, px, tick_step};
use maud::html;

const HEIGHT: f64 = 210.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 170.0;

/// Where a chart of this width puts a distance [m] out of `total`.
pub(super) fn across(distance: f64, total: f64, width: f64) -> f64 {
    let share = if total > 0.0 { distance / total } else { 0.0 };
    LEFT + share * (width - LEFT - RIGHT)
}

/// Where a chart puts a performance in [0, 1].
pub(super) fn down(performance: f64) -> f64 {
    BOTTOM - performance * (BOTTOM - TOP)
}

/// The share of particles at the goal over the distance travelled in contact.
pub(super) fn performance(drawing: &Drawing, width: f64) -> Panel {
    let frames = drawing.input.frames.all();
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
    let step = tick_step(total / (width / 110.0));
    let digits = decimals(step);
    let ticks = if total > 0.0 {
        (total / step + 1e-9) as i64
    } else {
        0
    };
    let body = html! {
        text class="text small quiet" x=("12") y=(px(TOP - 12.0)) { (drawing.achieved()) }
        @for quarter in 0..=4 {
            @let y = down(f64::from(quarter) / 4.0);
            path class="rule" d=(format!("M{} {}H{}", px(LEFT), px(y), px(width - RIGHT))) {}
            text class="text small quiet end" x=(px(LEFT - 8.0)) y=(px(y + 4.0)) { (25 * quarter) " %" }
        }
        @for tick in 0..=ticks {
            @let distance = tick as f64 * step;
            @let x = across(distance, total, width);
            path class="axis" d=(format!("M{} {}v5", px(x), px(BOTTOM))) {}
            text class="text small quiet middle" x=(px(x)) y=(px(BOTTOM + 19.0)) { (metres(distance, digits)) }
        }
        path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(BOTTOM), px(width - RIGHT))) {}
        path class="under" d=(under.path()) {}
        path class="curve" d=(curve.path()) {}
        text class="text small quiet end" x=(px(width - RIGHT)) y=(px(BOTTOM + 35.0)) { "distance wiped [m]" }
    };
    Panel {
        width,
        height: HEIGHT,
        body,
        keys: Vec::new(),
    }
}
