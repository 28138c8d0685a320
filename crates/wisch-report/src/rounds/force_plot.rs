//! Force and height over time, with events below; paper Fig. 9, 16 and 18.

use super::input::{RoundView, RoundsInput};
use super::reduce::{self, Dot};
use super::words;
use crate::draw::{
    Entry, Figure, Panel, Pen, WIDTH, axes, count_decimals, find_range, find_tick_step,
    format_decimal, legend, px,
};
use maud::{Markup, html};
use wisch::interpret::{Event, EventKind, PathPiece, Touch};

/// Left and right end of the curves.
const LEFT: f64 = 92.0;
const RIGHT: f64 = WIDTH - 22.0;
const TOP: f64 = 30.0;
const HEIGHT: f64 = 170.0;
/// Gap between the two plots, for the lower one's caption.
const BETWEEN: f64 = 34.0;
const LANE: f64 = 17.0;
/// Confident contact (10): f' from, to.
const CONFIDENT: [f64; 2] = [0.9, 1.0];
/// Shown height of lifted moves above the measured contacts: a share of their extent, and a minimum [m].
const LIFT_SHOWN: f64 = 0.012;
/// Minimum extent of the axis of heights [m].
const LEAST_HEIGHT: f64 = 0.004;
/// Maximum number of drawn events in a lane.
const MAX_SPANS: usize = 400;

const MILLIMETRES: f64 = 1e3;

/// One of the two plots.
struct Plot {
    top: f64,
    low: f64,
    high: f64,
}

impl Plot {
    fn down(&self, value: f64) -> f64 {
        let share = (value - self.low) / (self.high - self.low);
        self.top + HEIGHT * (1.0 - share.clamp(0.0, 1.0))
    }
}

/// The axis of time.
struct Times {
    first: f64,
    last: f64,
}

impl Times {
    fn new(path: &[PathPiece]) -> Self {
        Self {
            first: path.first().map_or(0.0, |piece| piece.time[0]),
            last: path.last().map_or(0.0, |piece| piece.time[1]),
        }
    }

    fn duration(&self) -> f64 {
        self.last - self.first
    }

    fn across(&self, time: f64) -> f64 {
        let share = if self.duration() > 0.0 {
            (time - self.first) / self.duration()
        } else {
            0.5
        };
        LEFT + share.clamp(0.0, 1.0) * (RIGHT - LEFT)
    }

    /// Returns left end and width of a span, at least a visible width; `None` if it lies outside.
    fn place(&self, [from, to]: [f64; 2]) -> Option<(f64, f64)> {
        let inside = from <= self.last && to >= self.first && from <= to;
        inside.then(|| {
            let (left, right) = (self.across(from), self.across(to));
            (left, (right - left).max(1.5))
        })
    }
}

pub(crate) fn figure(input: &RoundsInput, round: &RoundView) -> Figure {
    let found = round.interpretation;
    let path = reduce::select_drawable(found);
    let times = Times::new(&path);
    let press = input.task.interaction.press_force_n;
    let forces = build_force_plot(&path, press);
    let heights = build_height_plot(&path, forces.top + HEIGHT + BETWEEN);
    let bottom = heights.top + HEIGHT;
    let pushes: Vec<_> = (round.pushes.iter())
        .filter_map(|&push| times.place(push))
        .collect();
    let (lanes, below) = draw_lanes(&found.events, &pushes, &times, bottom + 12.0);
    // Duration of a unit of the picture: closer pushes look like one.
    let gap = times.duration() / (RIGHT - LEFT);
    let collisions: Vec<_> = (reduce::find_spans(&path, Touch::FalsePositive, gap).into_iter())
        .filter_map(|span| times.place(span))
        .collect();
    let losses: Vec<_> = (found.events.iter())
        .filter(|event| event.kind == EventKind::ContactLoss)
        .take(MAX_SPANS)
        .filter_map(|event| times.place([event.start, event.end]))
        .collect();
    let reference = if found.plane.is_some() {
        "the fitted plane"
    } else {
        "the believed surface"
    };
    let body = html! {
        @for plot in [&forces, &heights] {
            (draw_bands(plot, &pushes, "true-push"))
            (draw_bands(plot, &losses, "contact-lost"))
            (draw_bands(plot, &collisions, "collision"))
        }
        text class="text small quiet" x=(px(LEFT)) y="14" { "normal force on the surface [N], negative where the tool presses" }
        (draw_commanded_force(&forces, press))
        (draw_scale(&forces, 1.0))
        (draw_curves(&path, &times, &forces, |piece| piece.normal_force))
        text class="text small quiet" x=(px(LEFT)) y=(px(heights.top - 8.0)) { "height above " (reference) " [mm]" (draw_cut_note(&path, &heights)) }
        (draw_scale(&heights, MILLIMETRES))
        (draw_curves(&path, &times, &heights, |piece| piece.height))
        (lanes)
        (draw_time_axis(&times, bottom + 12.0 + below))
        @if path.is_empty() {
            text class="text middle" x=(px((LEFT + RIGHT) / 2.0)) y=(px(forces.top + HEIGHT / 2.0)) { "The log is empty." }
        }
    };
    Figure {
        panel: Panel {
            width: WIDTH,
            height: bottom + below + 54.0,
            body,
        },
        entries: list_entries(&path, &losses, &pushes),
        what: format!("Normal force, and height above {reference}, over time"),
    }
}

fn build_force_plot(path: &[PathPiece], press: f64) -> Plot {
    let (low, high) = find_range(path.iter().map(|piece| piece.normal_force));
    Plot {
        top: TOP,
        low: low.min(-1.25 * press) - 0.04 * press,
        high: high.max(0.15 * press) + 0.04 * press,
    }
}

/// Returns the axis of heights around the measured contacts; lifted moves are cut off.
fn build_height_plot(path: &[PathPiece], top: f64) -> Plot {
    let touched = path.iter().filter(|piece| piece.touch != Touch::Free);
    let (low, highest_touched) = find_range(touched.map(|piece| piece.height));
    let (lowest, highest) = find_range(path.iter().map(|piece| piece.height));
    let high = highest.min(highest_touched + LIFT_SHOWN);
    let low = lowest.max(low.min(0.0) - LIFT_SHOWN).min(0.0);
    let margin = 0.06 * (high - low).max(LEAST_HEIGHT);
    Plot {
        top,
        low: low.min(-0.3 * LEAST_HEIGHT) - margin,
        high: high.max(LEAST_HEIGHT) + margin,
    }
}

fn draw_cut_note(path: &[PathPiece], heights: &Plot) -> Markup {
    let cut = path.iter().any(|piece| piece.height > heights.high);
    html! { @if cut { "; lifted moves extend above the plot" } }
}

/// Draws spans over the whole height of a plot.
fn draw_bands(plot: &Plot, places: &[(f64, f64)], class: &str) -> Markup {
    html! {
        @for (left, width) in places {
            rect class=(class) x=(px(*left)) y=(px(plot.top)) width=(px(*width)) height=(px(HEIGHT)) {}
        }
    }
}

/// Draws the commanded force, and the band of confident contact.
fn draw_commanded_force(plot: &Plot, press: f64) -> Markup {
    let [weak, full] = CONFIDENT.map(|share| plot.down(-share * press));
    html! {
        rect class="confident-band" x=(px(LEFT)) y=(px(weak)) width=(px(RIGHT - LEFT)) height=(px(full - weak)) {}
        path class="target" d=(format!("M{} {}H{}", px(LEFT), px(full), px(RIGHT))) {}
        text class="text small quiet end halo" x=(px(RIGHT - 4.0)) y=(px(full + 13.0)) {
            "f_min = " (format_decimal(-press, count_decimals(press))) " N"
        }
    }
}

/// Draws the value axis of a plot. `unit`: shown units per unit of the values.
fn draw_scale(plot: &Plot, unit: f64) -> Markup {
    let step = find_tick_step(unit * (plot.high - plot.low) / 5.0);
    let ticks = (unit * plot.low / step).ceil() as i64..=(unit * plot.high / step).floor() as i64;
    html! {
        @for tick in ticks {
            @let value = tick as f64 * step;
            @let y = plot.down(value / unit);
            path class=(if tick == 0 { "axis" } else { "rule" }) d=(format!("M{} {}H{}", px(LEFT), px(y), px(RIGHT))) {}
            text class="text small quiet end" x=(px(LEFT - 6.0)) y=(px(y + 4.0)) { (format_decimal(value, count_decimals(step))) }
        }
        rect class="axis" x=(px(LEFT)) y=(px(plot.top)) width=(px(RIGHT - LEFT)) height=(px(HEIGHT)) {}
    }
}

fn draw_curves(
    path: &[PathPiece],
    times: &Times,
    plot: &Plot,
    value: impl Fn(&PathPiece) -> f64,
) -> Markup {
    let dots: Vec<Dot> = (path.iter())
        .map(|piece| Dot {
            x: times.across(0.5 * (piece.time[0] + piece.time[1])),
            y: plot.down(value(piece)),
            touch: piece.touch,
        })
        .collect();
    let runs = reduce::split_runs(&reduce::find_peaks(&dots));
    let draw = |touch: Touch| {
        let (mut lines, mut alone) = (Pen::default(), Pen::default());
        for run in runs.iter().filter(|run| run.touch == touch) {
            match run.points.as_slice() {
                [only] => alone.dot(*only),
                points => lines.line(points.iter().copied()),
            }
        }
        [(lines.path(), None), (alone.path(), Some("stroke-width:6"))]
    };
    html! {
        @for touch in [Touch::Free, Touch::Weak, Touch::Confident, Touch::FalsePositive] {
            @for (path, style) in draw(touch) {
                @if !path.is_empty() { path class=(find_class(touch)) style=[style] d=(path) {} }
            }
        }
    }
}

/// Returns the CSS class of a line of a contact class.
const fn find_class(touch: Touch) -> &'static str {
    match touch {
        Touch::Free => "touch-free",
        Touch::Weak => "touch-weak",
        Touch::Confident => "touch-confident",
        Touch::FalsePositive => "touch-false",
    }
}

/// Draws a row of spans for each kind of event, and a row of true pushes; returns their height, too.
fn draw_lanes(events: &[Event], pushes: &[(f64, f64)], times: &Times, top: f64) -> (Markup, f64) {
    let spans = |kind: EventKind| -> Vec<(f64, f64)> {
        let of_kind = events.iter().filter(|event| event.kind == kind);
        of_kind
            .take(MAX_SPANS)
            .filter_map(|event| times.place([event.start, event.end]))
            .collect()
    };
    let detected =
        words::KINDS.map(|kind| (words::kind_name(kind), find_event_class(kind), spans(kind)));
    let truth = ("true push", "event-push", pushes.to_vec());
    let lanes: Vec<_> = (detected.into_iter().chain([truth]))
        .filter(|(_, _, spans)| !spans.is_empty())
        .collect();
    let body = html! {
        @for (i, (name, class, spans)) in lanes.iter().enumerate() {
            @let y = top + LANE * i as f64;
            text class="text small quiet end" x=(px(LEFT - 6.0)) y=(px(y + 10.0)) { (name) }
            rect class="lane" x=(px(LEFT)) y=(px(y)) width=(px(RIGHT - LEFT)) height=(px(LANE - 4.0)) {}
            @for (left, width) in spans {
                rect class=(class) x=(px(*left)) y=(px(y)) width=(px(*width)) height=(px(LANE - 4.0)) {}
            }
        }
    };
    (body, LANE * lanes.len() as f64)
}

const fn find_event_class(kind: EventKind) -> &'static str {
    match kind {
        EventKind::Contact => "event-contact",
        EventKind::ContactLoss => "event-loss",
        EventKind::Push => "event-collision",
        EventKind::HandGuiding => "event-guided",
        EventKind::Landing | EventKind::Overload | EventKind::Vibration => "event-loss",
        EventKind::StickSlip => "event-stick",
        EventKind::Approach | EventKind::Stroke | EventKind::Lift | EventKind::Retreat => "",
    }
}

fn draw_time_axis(times: &Times, top: f64) -> Markup {
    let step = find_tick_step(times.duration() / 7.0);
    let moments = (times.first / step).ceil() as i64..=(times.last / step).floor() as i64;
    let moments = moments.filter(|_| times.duration() > 0.0);
    let ticks = moments.map(|tick| {
        let time = tick as f64 * step;
        (
            times.across(time),
            format_decimal(time, count_decimals(step)),
        )
    });
    html! {
        path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(top), px(RIGHT))) {}
        (axes::draw_ticks_below(ticks, top, 18.0))
        @if times.duration() <= 0.0 {
            text class="text small quiet middle" x=(px((LEFT + RIGHT) / 2.0)) y=(px(top + 18.0)) { (format_decimal(times.first, 3)) }
        }
        text class="text small quiet end" x=(px(RIGHT)) y=(px(top + 34.0)) { "time [s]" }
    }
}

fn list_entries(path: &[PathPiece], losses: &[(f64, f64)], pushes: &[(f64, f64)]) -> Vec<Entry> {
    let has = |touch| path.iter().any(|piece| piece.touch == touch);
    let classes = [
        (Touch::Confident, "confident contact"),
        (Touch::Weak, "weak contact"),
        (Touch::Free, "no contact"),
    ];
    let mut entries: Vec<Entry> = (classes.into_iter())
        .filter(|(touch, _)| has(*touch))
        .map(|(touch, label)| legend::line(find_class(touch), label))
        .collect();
    entries.push(legend::area(
        "confident-band",
        "confident force, 0.9 ≤ f' ≤ 1",
    ));
    if has(Touch::FalsePositive) {
        entries.push(Entry {
            label: "false positive: force away from the plane".to_owned(),
            sample: html! {
                rect class="collision" x="3" y="-7" width="18" height="14" {}
                path class="touch-false" d="M3 0h18" {}
            },
        });
    }
    if !losses.is_empty() {
        entries.push(legend::area("contact-lost", "contact loss"));
    }
    if !pushes.is_empty() {
        entries.push(legend::area(
            "true-push",
            "true push (unknown to the robot)",
        ));
    }
    entries
}
