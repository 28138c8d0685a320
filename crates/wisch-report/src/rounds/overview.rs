//! Predicted, estimated and true performance of all rounds.

use super::input::{RoundView, RoundsInput};
use crate::draw::{Entry, Figure, Panel, axes, format_percent, legend, px};
use maud::{Markup, html};

/// Width of the picture; narrower than other pictures, so that its numbers are readable on a phone.
const WIDTH: f64 = 520.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 60.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 214.0;
const HEIGHT: f64 = BOTTOM + 44.0;
/// Maximum width of a bar.
const WIDEST: f64 = 40.0;
/// Minimum width of a bar with a number above it.
const NUMBERED: f64 = 22.0;
fn map_down(share: f64) -> f64 {
    BOTTOM - share.clamp(0.0, 1.0) * (BOTTOM - TOP)
}

/// The content of a bar.
struct Bar {
    class: &'static str,
    share: f64,
    /// Ends of the whisker.
    range: Option<[f64; 2]>,
}

fn list_bars(round: &RoundView) -> Vec<Bar> {
    let estimate = round.interpretation.performance;
    let bar = |class, share| Bar {
        class,
        share,
        range: None,
    };
    let mut bars = vec![
        bar("bar-predicted", round.predicted),
        Bar {
            range: (estimate.low < estimate.high).then_some([estimate.low, estimate.high]),
            ..bar("bar-estimated", estimate.mean)
        },
    ];
    bars.extend(round.truth.map(|(_, share)| bar("bar-true", share)));
    bars
}

/// Draws up to three bars per round, and the target.
pub(crate) fn bars(input: &RoundsInput) -> Figure {
    let groups: Vec<Vec<Bar>> = input.rounds.iter().map(list_bars).collect();
    let each = (RIGHT - LEFT) / groups.len().max(1) as f64;
    let most = groups.iter().map(Vec::len).max().unwrap_or(1) as f64;
    let width = (0.8 * each / most).min(WIDEST);
    let numbered = width >= NUMBERED;
    // Numbers of rounds must not overlap.
    let every = (24.0 / each).ceil().max(1.0) as usize;
    let target = map_down(input.target);
    let middle = |i: usize| LEFT + each * (i as f64 + 0.5);
    let placed: Vec<(&Bar, f64)> = (groups.iter().enumerate())
        .flat_map(|(i, group)| {
            let left = middle(i) - 0.5 * width * group.len() as f64;
            let places = (0..group.len()).map(move |k| left + width * k as f64);
            group.iter().zip(places)
        })
        .collect();
    let body = html! {
        text class="text small quiet" x="12" y="14" { "performance" }
        (axes::draw_ticks_beside(axes::list_quarters(map_down), [LEFT, RIGHT], 8.0))
        @for (bar, left) in &placed { (draw(bar, *left, width)) }
        @for (i, round) in input.rounds.iter().enumerate().step_by(every) {
            text class="text small quiet middle" x=(px(middle(i))) y=(px(BOTTOM + 18.0)) { (round.number) }
        }
        path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(BOTTOM), px(RIGHT))) {}
        path class="target" d=(format!("M{} {}H{}", px(LEFT), px(target), px(RIGHT))) {}
        @if numbered {
            @for (bar, left) in &placed { (draw_number(bar, left + 0.5 * width)) }
        }
        text class="text small" x=(px(RIGHT + 6.0)) y=(px(target + 1.0)) { "target" }
        text class="text small quiet" x=(px(RIGHT + 6.0)) y=(px(target + 14.0)) { (format_percent(input.target)) }
        text class="text small quiet end" x=(px(RIGHT)) y=(px(BOTTOM + 36.0)) { "round" }
    };
    Figure {
        panel: Panel {
            width: WIDTH,
            height: HEIGHT,
            body,
        },
        entries: list_entries(input),
        what: "Predicted, estimated and true performance by round".to_owned(),
    }
}

fn draw(bar: &Bar, left: f64, width: f64) -> Markup {
    let (top, middle) = (map_down(bar.share), left + 0.5 * width);
    let room = (0.08 * width).min(2.0);
    html! {
        rect class=(bar.class) x=(px(left + room)) y=(px(top)) width=(px(width - 2.0 * room)) height=(px(BOTTOM - top)) {}
        @if let Some([low, high]) = bar.range {
            @let arm = (0.2 * width).min(6.0);
            path class="whisker" d=(format!(
                "M{0} {1}h{2}M{3} {1}V{4}M{0} {4}h{2}",
                px(middle - arm), px(map_down(high)), px(2.0 * arm), px(middle), px(map_down(low))
            )) {}
        }
    }
}

/// Draws the number above a bar and its whisker.
fn draw_number(bar: &Bar, middle: f64) -> Markup {
    let top = map_down(bar.range.map_or(bar.share, |[_, high]| high.max(bar.share)));
    html! {
        text class="text small middle halo" x=(px(middle)) y=(px(top - 5.0)) { (format!("{:.0}", 100.0 * bar.share)) }
    }
}

fn list_entries(input: &RoundsInput) -> Vec<Entry> {
    let was_seen = |round: &RoundView| round.interpretation.observation.is_some();
    let estimated = if input.rounds.iter().any(was_seen) {
        "estimated from touch and sight, with 90 % interval"
    } else {
        "estimated from touch, with 90 % interval"
    };
    let mut entries = vec![
        legend::area("bar-predicted", "predicted by the plan"),
        legend::area("bar-estimated", estimated),
    ];
    if input.rounds.iter().any(|round| round.truth.is_some()) {
        entries.push(legend::area("bar-true", "true"));
    }
    entries.push(legend::line("target", "target"));
    entries
}
