//! Joint positions within their limits, and joint velocities, over time.

use super::input::{MotionInput, ShownContact};
use super::sampled::with_velocities;
use crate::draw::{
    Panel, Pen, axes, count_decimals, find_range, find_tick_step, format_decimal, px, shorten,
};
use maud::{Markup, html};
use wisch::follow::TrajectorySample;
use wisch::robot::Joint;

const WIDTH: f64 = 1000.0;
/// Left ends of names, positions and velocities, and the width of the curves.
const NAME: f64 = 12.0;
const POSITION: f64 = 224.0;
const VELOCITY: f64 = 640.0;
const CURVE: f64 = 346.0;
const TOP: f64 = 30.0;
const ROW: f64 = 92.0;
const CURVE_HEIGHT: f64 = 70.0;
/// Maximum number of drawn joints.
const MAX_ROWS: usize = 48;
/// A joint with a smaller range of motion counts as not moving [rad or m].
const STILL: f64 = 1e-6;
/// Minimum extent of a position axis [rad or m].
const LEAST_EXTENT: f64 = 0.02;
/// Maximum error of a simplified curve [units of the picture].
const TOLERANCE: f64 = 0.15;

/// A joint with its positions and velocities at all samples.
struct JointHistory<'a> {
    joint: &'a Joint,
    position: Vec<f64>,
    velocity: Vec<f64>,
}

/// The axis of a curve: values from `low` at the bottom to `high` at the top.
#[derive(Clone, Copy)]
struct Axis {
    left: f64,
    top: f64,
    low: f64,
    high: f64,
}

impl Axis {
    fn down(&self, value: f64) -> f64 {
        let share = (value - self.low) / (self.high - self.low);
        self.top + CURVE_HEIGHT * (1.0 - share.clamp(0.0, 1.0))
    }

    fn shows(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// The time axis.
struct Times<'a> {
    samples: &'a [&'a TrajectorySample],
    first: f64,
    duration: f64,
}

impl Times<'_> {
    fn across(&self, time: f64) -> f64 {
        let share = if self.duration > 0.0 {
            (time - self.first) / self.duration
        } else {
            0.0
        };
        CURVE * share.clamp(0.0, 1.0)
    }
}

/// Draws a row per moving joint: position with its limits on the left, velocity as a share of its limit on the right.
pub(crate) fn panel(input: &MotionInput) -> Panel {
    let samples = with_velocities(input);
    let first = samples.first().map_or(0.0, |s| s.time);
    let times = Times {
        samples: &samples,
        first,
        duration: samples.last().map_or(0.0, |s| s.time) - first,
    };
    let (moving, still): (Vec<JointHistory>, Vec<JointHistory>) = (input.robot.joints().iter())
        .filter(|joint| !joint.kind.unit().is_empty())
        .map(|joint| JointHistory::new(joint, &samples))
        .partition(JointHistory::moves);
    let rows = moving.len().min(MAX_ROWS);
    let bottom = TOP + ROW * rows as f64;
    let still = describe_still_joints(&still, moving.len() - rows);
    let height = bottom + 34.0 + 18.0 * still.len() as f64;
    let body = html! {
        (draw_contact(input, &times, bottom))
        @for (i, course) in moving.iter().take(rows).enumerate() {
            (draw_row(course, &times, TOP + ROW * i as f64))
        }
        @if rows > 0 {
            (draw_headings(bottom))
            @for left in [POSITION, VELOCITY] { (draw_time_axis(&times, left, bottom - (ROW - CURVE_HEIGHT))) }
        }
        @for (i, line) in still.iter().enumerate() {
            text class="text small quiet" x=(px(NAME)) y=(px(bottom + 34.0 + 18.0 * i as f64)) { (line) }
        }
    };
    Panel {
        width: WIDTH,
        height,
        body,
    }
}

impl<'a> JointHistory<'a> {
    fn new(joint: &'a Joint, samples: &[&TrajectorySample]) -> Self {
        Self {
            joint,
            position: samples.iter().map(|s| joint.drive.position(&s.q)).collect(),
            velocity: samples.iter().map(|s| joint.drive.rate(&s.qd)).collect(),
        }
    }

    fn moves(&self) -> bool {
        let (low, high) = find_range(self.position.iter().copied());
        high - low > STILL
    }

    /// Returns an axis around the positions, which includes a limit if it is near.
    fn position_axis(&self, top: f64) -> Axis {
        let (low, high) = find_range(self.position.iter().copied());
        let extent = (high - low).max(LEAST_EXTENT);
        let near = 0.8 * extent;
        let (mut from, mut to) = (low, high);
        if let Some(limits) = self.joint.limits.position {
            from = if low - limits.lower < near {
                from.min(limits.lower)
            } else {
                from
            };
            to = if limits.upper - high < near {
                to.max(limits.upper)
            } else {
                to
            };
        }
        let middle = 0.5 * (from + to);
        let half = 0.56 * (to - from).max(LEAST_EXTENT);
        Axis {
            left: POSITION,
            top,
            low: middle - half,
            high: middle + half,
        }
    }

    /// Returns the divisor of the velocities, and the axis of the quotient.
    fn velocity_axis(&self, top: f64) -> (f64, Axis) {
        let most = self
            .velocity
            .iter()
            .fold(0.0, |most: f64, v| most.max(v.abs()));
        let limit = self.joint.limits.velocity.filter(|&limit| limit > 0.0);
        let unit = limit.unwrap_or(if most > 0.0 { most } else { 1.0 });
        let half = 1.12 * (most / unit).max(1.0);
        let axis = Axis {
            left: VELOCITY,
            top,
            low: -half,
            high: half,
        };
        (unit, axis)
    }
}

fn draw_row(course: &JointHistory, times: &Times, top: f64) -> Markup {
    let joint = course.joint;
    let unit = joint.kind.unit();
    let positions = course.position_axis(top);
    let (of, velocities) = course.velocity_axis(top);
    let step = find_tick_step((positions.high - positions.low) / 4.5);
    let ticks = (positions.low / step).ceil() as i64..=(positions.high / step).floor() as i64;
    let limits = joint
        .limits
        .position
        .map(|limits| [limits.lower, limits.upper]);
    let bounds = limits.map_or("no limits".to_owned(), |[lower, upper]| {
        format!(
            "limits {} … {} {unit}",
            format_decimal(lower, 2),
            format_decimal(upper, 2)
        )
    });
    let (low, high) = find_range(course.position.iter().copied());
    let relative: Vec<f64> = course.velocity.iter().map(|v| v / of).collect();
    let fastest = relative.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    html! {
        text class="text strong" x=(px(NAME)) y=(px(top + 14.0)) { (shorten(&joint.name, 20)) }
        text class="text small quiet" x=(px(NAME)) y=(px(top + 31.0)) { (bounds) }
        text class="text small quiet" x=(px(NAME)) y=(px(top + 46.0)) { "moves " (format_decimal(low, 2)) " … " (format_decimal(high, 2)) " " (unit) }
        text class="text small quiet" x=(px(NAME)) y=(px(top + 61.0)) {
            @if joint.limits.velocity.is_some() {
                "at most " (format!("{:.0} %", 100.0 * fastest)) " of " (format!("{of}")) " " (unit) "/s"
            } @else {
                "at most " (format!("{of:.2}")) " " (unit) "/s, no limit"
            }
        }
        (draw_forbidden_bands(&positions, limits))
        @for tick in ticks {
            @let y = positions.down(tick as f64 * step);
            path class="rule" d=(format!("M{} {}h{}", px(POSITION), px(y), px(CURVE))) {}
            text class="text small quiet end" x=(px(POSITION - 6.0)) y=(px(y + 4.0)) { (format_decimal(tick as f64 * step, count_decimals(step))) }
        }
        (draw_limits(&positions, limits))
        rect class="axis" x=(px(POSITION)) y=(px(top)) width=(px(CURVE)) height=(px(CURVE_HEIGHT)) {}
        path class="course" d=(format_curve(times, &course.position, &positions)) {}
        (draw_forbidden_bands(&velocities, Some([-1.0, 1.0])))
        @for (value, label) in [(-1.0, "−100 %"), (0.0, "0"), (1.0, "100 %")] {
            @let y = velocities.down(value);
            path class="rule" d=(format!("M{} {}h{}", px(VELOCITY), px(y), px(CURVE))) {}
            text class="text small quiet end" x=(px(VELOCITY - 6.0)) y=(px(y + 4.0)) { (label) }
        }
        @if joint.limits.velocity.is_some() { (draw_limits(&velocities, Some([-1.0, 1.0]))) }
        rect class="axis" x=(px(VELOCITY)) y=(px(top)) width=(px(CURVE)) height=(px(CURVE_HEIGHT)) {}
        path class="course" d=(format_curve(times, &relative, &velocities)) {}
    }
}

/// Draws bands beyond the limits.
fn draw_forbidden_bands(axis: &Axis, limits: Option<[f64; 2]>) -> Markup {
    let [lower, upper] = limits.unwrap_or([axis.low, axis.high]);
    let bands = [
        (axis.top, axis.down(upper)),
        (axis.down(lower), axis.top + CURVE_HEIGHT),
    ];
    html! {
        @for (from, to) in bands.into_iter().filter(|(from, to)| to - from > 0.05) {
            rect class="forbidden" x=(px(axis.left)) y=(px(from)) width=(px(CURVE)) height=(px(to - from)) {}
        }
    }
}

fn draw_limits(axis: &Axis, limits: Option<[f64; 2]>) -> Markup {
    html! {
        @for limit in limits.into_iter().flatten().filter(|&limit| axis.shows(limit)) {
            path class="limit" d=(format!("M{} {}h{}", px(axis.left), px(axis.down(limit)), px(CURVE))) {}
        }
    }
}

/// Draws bands over all rows while the tool wipes.
fn draw_contact(input: &MotionInput, times: &Times, bottom: f64) -> Markup {
    let wiping = input
        .phases
        .iter()
        .filter(|phase| phase.contact == ShownContact::Wiping);
    let bands: Vec<(f64, f64)> = wiping
        .map(|phase| (times.across(phase.start), times.across(phase.end)))
        .filter(|(from, to)| to > from)
        .collect();
    let height = (bottom - (ROW - CURVE_HEIGHT) - TOP).max(0.0);
    html! {
        @for left in [POSITION, VELOCITY] {
            @for (from, to) in &bands {
                rect class="while-contact" x=(px(left + from)) y=(px(TOP)) width=(px(to - from)) height=(px(height)) {}
            }
        }
    }
}

fn draw_headings(bottom: f64) -> Markup {
    html! {
        text class="text small quiet" x=(px(POSITION)) y="20" { "position [rad or m]" }
        text class="text small quiet" x=(px(VELOCITY)) y="20" { "velocity, share of its limit" }
        rect class="while-contact" x=(px(POSITION + 170.0)) y="11" width="16" height="11" {}
        text class="text small quiet" x=(px(POSITION + 191.0)) y="20" { "wiping" }
        path class="limit" d=(format!("M{} 16h20", px(POSITION + 250.0))) {}
        text class="text small quiet" x=(px(POSITION + 275.0)) y="20" { "limit" }
        text class="text small quiet end" x=(px(VELOCITY + CURVE)) y=(px(bottom + 14.0)) { "time [s]" }
    }
}

fn draw_time_axis(times: &Times, left: f64, y: f64) -> Markup {
    let step = find_tick_step(times.duration / 6.0);
    let last = if times.duration > 0.0 {
        (times.duration / step + 1e-9) as i64
    } else {
        0
    };
    let ticks = (0..=last).map(|tick| {
        let time = times.first + tick as f64 * step;
        (
            left + times.across(time),
            format_decimal(time, count_decimals(step)),
        )
    });
    axes::draw_ticks_below(ticks, y, 17.0)
}

/// Returns lines with the names of joints that do not move, and the number of moving joints that are not drawn.
fn describe_still_joints(still: &[JointHistory], left_out: usize) -> Vec<String> {
    const LONGEST: usize = 150;
    let mut lines = Vec::new();
    if left_out > 0 {
        lines.push(format!("{left_out} more moving joints are not drawn."));
    }
    if still.is_empty() {
        return lines;
    }
    let mut line = String::from("Not moving: ");
    for (i, course) in still.iter().enumerate() {
        let name = shorten(&course.joint.name, 40);
        if line.chars().count() + name.chars().count() > LONGEST {
            lines.push(std::mem::take(&mut line));
        }
        if lines.len() >= MAX_ROWS {
            return lines;
        }
        line += &name;
        line += if i + 1 < still.len() { ", " } else { "." };
    }
    lines.push(line);
    lines
}

/// Returns the simplified curve of values as an SVG path.
fn format_curve(times: &Times, values: &[f64], axis: &Axis) -> String {
    let places: Vec<(f64, f64)> = (times.samples.iter().zip(values))
        .map(|(sample, &value)| (axis.left + times.across(sample.time), axis.down(value)))
        .collect();
    let mut pen = Pen::default();
    pen.line(simplify(&places));
    pen.path()
}

/// Simplifies a line with an error of at most [`TOLERANCE`] (Ramer 1972; Douglas and Peucker 1973), measured
/// vertically.
fn simplify(places: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let Some(last) = places.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut kept = vec![false; places.len()];
    kept[0] = true;
    kept[last] = true;
    let mut stretches = vec![(0, last)];
    while let Some((from, to)) = stretches.pop() {
        let (a, b) = (places[from], places[to]);
        let slope = if b.0 > a.0 {
            (b.1 - a.1) / (b.0 - a.0)
        } else {
            0.0
        };
        let off = |i: usize| (places[i].1 - a.1 - slope * (places[i].0 - a.0)).abs();
        let worst = (from + 1..to).max_by(|&i, &j| off(i).total_cmp(&off(j)));
        if let Some(worst) = worst.filter(|&worst| off(worst) > TOLERANCE) {
            kept[worst] = true;
            stretches.push((from, worst));
            stretches.push((worst, to));
        }
    }
    let places = places.iter().zip(kept);
    places
        .filter(|(_, kept)| *kept)
        .map(|(place, _)| *place)
        .collect()
}
