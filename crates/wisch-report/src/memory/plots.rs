//! Diagrams of a query.

use super::names::local;
use crate::draw::{Pen, axes, decimals, px, range, tick_step};
use maud::{Markup, html};
use std::f64::consts::TAU;
use wisch_memory::view::{Diagram, Plot, PlotData};

const WIDTH: f64 = 460.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 14.0;
const HEIGHT: f64 = 220.0;
const ROW: f64 = 24.0;
/// Width of row labels, and of their numbers.
const LABELS: f64 = 136.0;
const NUMBERS: f64 = 58.0;
/// Maximum length of a label [characters].
const LETTERS: usize = 22;
/// Maximum number of rows and slices; other rows are omitted, other slices are merged.
const MAX_ROWS: usize = 60;
const MAX_SLICES: usize = 10;
/// Colours of slices, by their names on the page.
const HUES: [&str; 10] = [
    "left", "contact", "done", "lost", "plane", "goal", "tool", "limit", "quiet", "band-3",
];
/// Numbers above this multiple of their range are shown relative to the start of the axis.
const FAR: f64 = 1e4;

/// Draws a diagram with its headline.
pub(crate) fn draw_plot(plot: &Plot) -> Markup {
    let title = if plot.title.is_empty() {
        &plot.id
    } else {
        &plot.title
    };
    html! {
        figure class="plot" {
            h3 { (title) }
            @match &plot.data {
                PlotData::Amounts(amounts) if plot.diagram == Diagram::Pie => (draw_pie(amounts, title)),
                PlotData::Amounts(amounts) => (draw_bars(amounts, plot, title)),
                PlotData::Spans(spans) => (draw_timeline(spans, plot, title)),
                PlotData::Points(points) => (draw_points(points, plot, title)),
            }
        }
    }
}

fn note_no_data() -> Markup {
    html! { p class="note" { "The diagram has no data." } }
}

fn draw_pie(amounts: &[(String, f64)], title: &str) -> Markup {
    let total: f64 = amounts.iter().map(|(_, amount)| amount).sum();
    if total <= 0.0 {
        return note_no_data();
    }
    let mut slices: Vec<(String, f64)> = amounts.iter().take(MAX_SLICES).cloned().collect();
    if amounts.len() > MAX_SLICES {
        let rest = &amounts[MAX_SLICES - 1..];
        let rest_of_all = rest.iter().map(|(_, amount)| amount).sum();
        slices[MAX_SLICES - 1] = (format!("{} others", rest.len()), rest_of_all);
    }
    let height = (ROW * slices.len() as f64 + 20.0).max(220.0);
    let (radius, x, y) = (88.0, 96.0, height / 2.0);
    let mut angle = 0.0;
    let drawn: Vec<(String, &str, &str, f64, f64)> = (slices.iter().zip(HUES))
        .map(|((label, amount), hue)| {
            let share = amount / total;
            let from = angle;
            angle += share;
            (
                slice([x, y], radius, from, angle),
                label.as_str(),
                hue,
                *amount,
                share,
            )
        })
        .collect();
    html! {
        svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(height))) role="img" aria-label=(title) {
            @for (row, (path, label, hue, amount, share)) in drawn.iter().enumerate() {
                path class="slice" fill=(format!("var(--{hue})")) d=(path) {}
                @let at = (height - ROW * drawn.len() as f64) / 2.0 + ROW * row as f64;
                rect fill=(format!("var(--{hue})")) x="206" y=(px(at + 5.0)) width="13" height="13" rx="3" {}
                text class="text small" x="226" y=(px(at + 16.0)) {
                    (shorten_label(label)) " · " (format_number(*amount)) " · " (format!("{:.1} %", 100.0 * share))
                }
            }
        }
    }
}

/// Returns the path of a slice between two turns in [0, 1], clockwise from above.
fn slice([x, y]: [f64; 2], radius: f64, from: f64, to: f64) -> String {
    let at = |turn: f64| {
        let (sin, cos) = (TAU * turn).sin_cos();
        (px(x + radius * sin), px(y - radius * cos))
    };
    let r = px(radius);
    if to - from > 1.0 - 1e-9 {
        let d = px(2.0 * radius);
        return format!(
            "M{} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0-{d} 0z",
            px(x - radius),
            px(y)
        );
    }
    let ((x0, y0), (x1, y1)) = (at(from), at(to));
    let large = u8::from(to - from > 0.5);
    format!(
        "M{} {}L{x0} {y0}A{r} {r} 0 {large} 1 {x1} {y1}z",
        px(x),
        px(y)
    )
}

fn draw_bars(amounts: &[(String, f64)], plot: &Plot, title: &str) -> Markup {
    if amounts.is_empty() {
        return note_no_data();
    }
    let rows = &amounts[..amounts.len().min(MAX_ROWS)];
    let values = rows.iter().map(|(_, amount)| *amount);
    let low = values.clone().fold(0.0, f64::min);
    let high = values.fold(0.0, f64::max);
    let range = (high - low).max(f64::MIN_POSITIVE);
    let across = |value: f64| LABELS + (value - low) / range * (WIDTH - LABELS - NUMBERS);
    let zero = across(0.0);
    let bottom = TOP + ROW * rows.len() as f64;
    html! {
        svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(bottom + 28.0))) role="img" aria-label=(title) {
            @for (row, (label, amount)) in rows.iter().enumerate() {
                @let y = TOP + ROW * row as f64;
                @let (from, to) = (across(*amount).min(zero), across(*amount).max(zero));
                text class="text small end" x=(px(LABELS - 10.0)) y=(px(y + 16.0)) { (shorten_label(label)) }
                rect class="bar-estimated" x=(px(from)) y=(px(y + 4.0)) width=(px((to - from).max(1.0))) height=(px(ROW - 8.0)) rx="2" {}
                text class="text small quiet" x=(px(to + 7.0)) y=(px(y + 16.0)) { (format_number(*amount)) }
            }
            path class="axis" d=(format!("M{} {}V{}", px(zero), px(TOP), px(bottom))) {}
            text class="text small quiet end" x=(px(LABELS - 10.0)) y=(px(bottom + 18.0)) { (plot.x_label) }
            text class="text small quiet" x=(px(LABELS)) y=(px(bottom + 18.0)) { (plot.y_label) }
        }
        @if amounts.len() > rows.len() {
            p class="note" { "The diagram shows the first " (rows.len()) " of " (amounts.len()) " bars." }
        }
    }
}

fn draw_timeline(spans: &[(String, [f64; 2])], plot: &Plot, title: &str) -> Markup {
    if spans.is_empty() {
        return note_no_data();
    }
    let mut labels: Vec<&str> = Vec::new();
    for (label, _) in spans {
        if !labels.contains(&label.as_str()) && labels.len() < MAX_ROWS {
            labels.push(label);
        }
    }
    let ends = |place: usize| spans.iter().map(move |(_, span)| span[place]);
    let axis = Axis::new(
        ends(0).fold(f64::INFINITY, f64::min),
        ends(1).fold(f64::NEG_INFINITY, f64::max),
    );
    let across = |time: f64| LABELS + axis.share(time) * (WIDTH - LABELS - RIGHT);
    let bottom = TOP + ROW * labels.len() as f64;
    html! {
        svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(bottom + 44.0))) role="img" aria-label=(title) {
            @for (row, label) in labels.iter().enumerate() {
                @let y = TOP + ROW * row as f64;
                rect class="lane" x=(px(LABELS)) y=(px(y + 3.0)) width=(px(WIDTH - LABELS - RIGHT)) height=(px(ROW - 6.0)) {}
                text class="text small end" x=(px(LABELS - 10.0)) y=(px(y + 16.0)) { (shorten_label(label)) }
                @for (_, [from, to]) in spans.iter().filter(|(of, _)| of == label) {
                    rect class="bar-estimated" x=(px(across(*from))) y=(px(y + 3.0))
                        width=(px((across(*to) - across(*from)).max(2.0))) height=(px(ROW - 6.0)) {}
                }
            }
            (axis.below(bottom, LABELS, &plot.x_label))
        }
    }
}

fn draw_points(points: &[[f64; 2]], plot: &Plot, title: &str) -> Markup {
    if points.is_empty() {
        return note_no_data();
    }
    let axis = |place: usize| {
        let values = points.iter().map(|point| point[place]);
        let (low, high) = range(values);
        Axis::new(low, high)
    };
    let (x, y) = (axis(0), axis(1));
    let bottom = TOP + HEIGHT;
    let places = points.iter().map(|point| {
        (
            LEFT + x.share(point[0]) * (WIDTH - LEFT - RIGHT),
            bottom - y.share(point[1]) * HEIGHT,
        )
    });
    let (mut line, mut dots) = (Pen::default(), Pen::default());
    line.line(places.clone());
    places.for_each(|place| dots.dot(place));
    let heights =
        (y.ticks().into_iter()).map(|(value, text)| (bottom - y.share(value) * HEIGHT, text));
    html! {
        p class="note" { (y.full_label(&plot.y_label)) }
        svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(bottom + 44.0))) role="img" aria-label=(title) {
            (axes::beside(heights, [LEFT, WIDTH - RIGHT], 8.0))
            @if plot.diagram == Diagram::Line { path class="course" d=(line.path()) {} }
            @if plot.diagram == Diagram::Scatter || points.len() <= 60 {
                path class="dots-left" stroke-width="6" d=(dots.path()) {}
            }
            (x.below(bottom, LEFT, &plot.x_label))
        }
    }
}

/// Range and ticks of an axis.
struct Axis {
    low: f64,
    high: f64,
    step: f64,
    /// Value to which shown numbers are relative.
    origin: f64,
}

impl Axis {
    fn new(low: f64, high: f64) -> Self {
        let range = high - low;
        let range = if range > 0.0 {
            range
        } else {
            low.abs().max(1.0) * 0.1
        };
        let step = tick_step(range / 5.0);
        let low = (low / step).floor() * step;
        let high = ((high / step).ceil() * step).max(low + step);
        let is_far = low.abs() > FAR * range;
        Self {
            low,
            high,
            step,
            origin: if is_far { low } else { 0.0 },
        }
    }

    fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    fn ticks(&self) -> Vec<(f64, String)> {
        let count = ((self.high - self.low) / self.step).round() as usize;
        let digits = decimals(self.step);
        let ticks = (0..=count).map(|k| {
            let value = self.low + k as f64 * self.step;
            // Adding zero leaves no "-0".
            let written = (value - self.origin) / self.step;
            let text = format!("{:.digits$}", written.round() * self.step + 0.0);
            (value, text.replace('-', "\u{2212}"))
        });
        ticks.collect()
    }

    /// Returns the label, with the value to which shown numbers are relative.
    fn full_label(&self, label: &str) -> String {
        if self.origin == 0.0 {
            label.to_owned()
        } else {
            format!("{label} since {:.3}", self.origin)
                .trim()
                .to_owned()
        }
    }

    fn below(&self, bottom: f64, left: f64, label: &str) -> Markup {
        let across = |value: f64| left + self.share(value) * (WIDTH - left - RIGHT);
        let ticks = (self.ticks().into_iter()).map(|(value, text)| (across(value), text));
        html! {
            path class="axis" d=(format!("M{} {}H{}", px(left), px(bottom), px(WIDTH - RIGHT))) {}
            (axes::below(ticks, bottom, 19.0))
            text class="text small quiet end" x=(px(WIDTH - RIGHT)) y=(px(bottom + 37.0)) { (self.full_label(label)) }
        }
    }
}

/// Formats a number with four significant digits.
fn format_number(value: f64) -> String {
    let digits = (3.0 - value.abs().max(1e-12).log10().floor()).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    text.replace('-', "\u{2212}")
}

/// Shortens a label: an individual keeps its class and number, other names keep both ends.
fn shorten_label(label: &str) -> String {
    let label = local(label);
    let individual = label.split_once('_').and_then(|(class, rest)| {
        let (episode, number) = rest.rsplit_once('-')?;
        let is_number = number.bytes().all(|byte| byte.is_ascii_digit());
        (is_number && episode.contains('-')).then(|| format!("{class} {number}"))
    });
    let label = individual.unwrap_or_else(|| label.to_owned());
    let letters: Vec<char> = label.chars().collect();
    if letters.len() <= LETTERS {
        return label;
    }
    let half = LETTERS / 2;
    let ends = [&letters[..half], &letters[letters.len() - half + 1..]];
    let [first, last] = ends.map(|end| end.iter().collect::<String>());
    format!("{first}…{last}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_significant_digits() {
        let texts = [0.0, 1.0, -2.5, 0.012_345, 123.456, 98_765.4].map(format_number);
        assert_eq!(texts, ["0", "1", "−2.5", "0.01235", "123.5", "98765"]);
    }

    #[test]
    fn times_since_1970_are_relative_to_the_start_of_the_axis() {
        let axis = Axis::new(1_795_312_612.3, 1_795_312_616.9);
        assert_eq!(axis.full_label("time [s]"), "time [s] since 1795312612.000");
        let texts: Vec<String> = axis.ticks().into_iter().map(|(_, text)| text).collect();
        assert_eq!(texts, ["0", "1", "2", "3", "4", "5"]);
    }

    #[test]
    fn shortened_labels_stay_distinct() {
        assert_eq!(
            shorten_label("semco:Stroke_20261122-021522-785e-39"),
            "Stroke 39"
        );
        assert_eq!(shorten_label("sponge"), "sponge");
        assert_eq!(
            shorten_label("a_very_long_name_of_something-1"),
            "a_very_long…omething-1"
        );
    }

    #[test]
    fn slices_share_the_whole_circle() {
        let half = slice([0.0, 0.0], 10.0, 0.0, 0.5);
        assert_eq!(half, "M0 0L0 -10A10 10 0 0 1 0 10z");
        assert!(slice([0.0, 0.0], 10.0, 0.0, 1.0).starts_with("M-10 0a10 10"));
    }
}
