//! The drawing of an estimator's calibration: reliability and width of its intervals.

use crate::draw::{Figure, Panel, Pen, axes, format_percent, legend, px};
use maud::{Markup, html};

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 372.0;
const TOP: f64 = 28.0;
const BOTTOM: f64 = 330.0;
/// Widths of the two plots, from left to right.
const RELIABILITY: [f64; 2] = [60.0, 362.0];
const WIDTHS: [f64; 2] = [440.0, 742.0];

/// An estimator with the statistics of its intervals.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationCurve {
    /// Name of the estimator.
    pub name: String,
    /// Statistics of its intervals, by level.
    pub levels: Vec<CalibrationLevel>,
}

/// Statistics of the intervals of one level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CalibrationLevel {
    /// Nominal probability of the interval \[1\].
    pub level: f64,
    /// Observed share of outcomes within the interval \[1\].
    pub coverage: f64,
    /// The 95 % interval of that share \[1\].
    pub bounds: [f64; 2],
    /// Mean width of the interval \[1\].
    pub width: f64,
}

/// Draws the reliability diagram and the widths of the intervals as SVG.
///
/// `title`: headline; `what`: description of the picture; `curves`: the estimators, that of wisch first.
pub fn calibration_drawing(title: &str, what: &str, curves: &[CalibrationCurve]) -> String {
    let classes = ["curve", "course", "trail", "driven"];
    let with_class = || curves.iter().zip(classes.iter().cycle());
    let entries = with_class().map(|(curve, class)| legend::line(class, curve.name.clone()));
    let mut entries: Vec<_> = entries.collect();
    entries.push(legend::line(
        "lifted",
        "ideal: observed share equals nominal probability",
    ));
    let widest = (curves.iter().flat_map(|curve| &curve.levels))
        .map(|level| level.width)
        .fold(0.1, f64::max);
    let body = html! {
        text class="text small quiet" x="8" y="14" { "share of outcomes within the interval" }
        (axes::draw_ticks_beside(axes::list_quarters(map_down), RELIABILITY, 6.0))
        (axes::draw_ticks_below(list_level_ticks(RELIABILITY), BOTTOM, 18.0))
        (draw_diagonal(RELIABILITY))
        @for (curve, class) in with_class() {
            (draw_curve(curve, class, RELIABILITY, |level| map_down(level.coverage)))
            @for level in &curve.levels {
                (draw_whisker(map_across(level.level, RELIABILITY), level.bounds))
            }
        }
        text class="text small quiet" x=(px(WIDTHS[0] - 44.0)) y="14" { "mean width of the interval (largest: " (format_percent(widest)) ")" }
        (axes::draw_ticks_beside(list_width_ticks(widest), WIDTHS, 6.0))
        (axes::draw_ticks_below(list_level_ticks(WIDTHS), BOTTOM, 18.0))
        @for (curve, class) in with_class() {
            (draw_curve(curve, class, WIDTHS, |level| map_down(level.width / widest)))
        }
        @for ends in [RELIABILITY, WIDTHS] {
            path class="axis" d=(format!("M{} {}H{}", px(ends[0]), px(BOTTOM), px(ends[1]))) {}
            text class="text small quiet end" x=(px(ends[1])) y=(px(BOTTOM + 34.0)) { "nominal probability of the interval" }
        }
    };
    let panel = Panel {
        width: WIDTH,
        height: HEIGHT,
        body,
    };
    let what = what.to_owned();
    let figure = Figure {
        panel,
        entries,
        what,
    };
    figure.standalone(title, [12.0, 12.0])
}

fn map_across(share: f64, [left, right]: [f64; 2]) -> f64 {
    left + (right - left) * share.clamp(0.0, 1.0)
}

fn map_down(share: f64) -> f64 {
    BOTTOM - share.clamp(0.0, 1.0) * (BOTTOM - TOP)
}

fn list_level_ticks(ends: [f64; 2]) -> impl Iterator<Item = (f64, String)> {
    [0.0, 0.5, 0.8, 0.95]
        .into_iter()
        .map(move |share| (map_across(share, ends), format_percent(share)))
}

fn list_width_ticks(widest: f64) -> impl Iterator<Item = (f64, String)> {
    (0..=4).map(move |quarter| {
        let share = f64::from(quarter) / 4.0;
        (map_down(share), format_percent(share * widest))
    })
}

fn draw_diagonal([left, right]: [f64; 2]) -> Markup {
    let d = format!("M{} {}L{} {}", px(left), px(BOTTOM), px(right), px(TOP));
    html! { path class="lifted" d=(d) {} }
}

fn draw_curve(
    curve: &CalibrationCurve,
    class: &str,
    ends: [f64; 2],
    y: impl Fn(&CalibrationLevel) -> f64,
) -> Markup {
    let mut pen = Pen::default();
    let points = curve
        .levels
        .iter()
        .map(|level| (map_across(level.level, ends), y(level)));
    pen.line(points);
    html! { path class=(class) d=(pen.path()) {} }
}

fn draw_whisker(x: f64, [low, high]: [f64; 2]) -> Markup {
    let d = format!("M{} {}V{}", px(x), px(map_down(low)), px(map_down(high)));
    html! { path class="whisker" d=(d) {} }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_has_a_line_and_its_whiskers_for_each_curve() {
        let level = |level: f64| CalibrationLevel {
            level,
            coverage: level - 0.1,
            bounds: [level - 0.15, level],
            width: 0.2,
        };
        let curve = |name: &str| CalibrationCurve {
            name: name.to_owned(),
            levels: vec![level(0.5), level(0.9)],
        };
        let svg = calibration_drawing("Calibration", "what", &[curve("one"), curve("other")]);
        assert_eq!(svg.matches("class=\"whisker\"").count(), 4);
        assert!(svg.contains("one") && svg.contains("other"));
        // 40 % of the outcomes are within the 50 % interval.
        assert!(svg.contains(&px(map_down(0.4))));
    }
}
