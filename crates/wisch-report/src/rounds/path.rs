//! The tool's path over the surface in space, coloured by contact force; paper Fig. 10 and 17.

use super::input::{RoundView, RoundsInput};
use super::reduce::{self, Stretch};
use crate::draw::{Entry, Figure, Panel, Pen, find_tick_step, format_decimal, legend, px, surface};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Point3};
use wisch::interpret::{FittedPlane, Touch};

/// Direction of view: azimuth from the front to the right, and elevation [rad].
const AZIMUTH: f64 = 0.5;
const ELEVATION: f64 = 0.56;
/// Width of the picture; narrower than the maps, so that it fits on a phone.
const WIDTH: f64 = 620.0;
const SIZE: [f64; 2] = [WIDTH - 2.0 * MARGIN, 400.0];
const MARGIN: f64 = 20.0;
/// Space below the path, for the scale in the lower left corner.
const BELOW: f64 = 44.0;
/// Approximate length of a stretch of the path [units of the picture].
const STRETCH: f64 = 2.0;
/// Shown margin around the surface, as a share of its size [1].
const AROUND: f64 = 0.15;
/// Factors by which heights may be enlarged, and their maximum extent as a share of the surface's [1].
const STRETCHING: [f64; 6] = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0];
const HEIGHT_SHARE: f64 = 0.35;
/// Minimum half thickness of the fitted plane's box, for visibility [m].
const LEAST_HALF: f64 = 0.5e-3;
/// Half thickness of the box in RMS distances of the inliers; nearly all inliers are within.
const HALF_IN_RMS: f64 = 3.0;
/// Classes of contact by f', from weak to full.
const LEVELS: [&str; 5] = ["touch-1", "touch-2", "touch-3", "touch-4", "touch-5"];

/// A parallel projection of points in the frame of the believed surface [m].
struct Projection {
    /// Factor by which heights are enlarged [1].
    stretching: f64,
    /// Units of the picture per metre.
    scale: f64,
    origin: (f64, f64),
}

impl Projection {
    /// Projects a point to right and up on the screen, at one unit per metre.
    fn flat(stretching: f64, p: Point3) -> (f64, f64) {
        let (sin, cos) = AZIMUTH.sin_cos();
        let (rise, level) = ELEVATION.sin_cos();
        let away = cos * p.y - sin * p.x;
        (
            cos * p.x + sin * p.y,
            rise * away + level * stretching * p.z,
        )
    }

    /// Fits points into the picture.
    fn new(stretching: f64, places: impl Iterator<Item = Point3>) -> Self {
        let bounds = Bounds2::from_points(places.map(|p| {
            let (x, y) = Self::flat(stretching, p);
            Point2::new(x, y)
        }));
        let bounds = bounds.unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::new(1.0, 1.0),
        });
        let extent = bounds.size();
        let scale = (SIZE[0] / extent.x).min(SIZE[1] / extent.y);
        let scale = if scale.is_finite() { scale } else { 1.0 };
        Self {
            stretching,
            scale,
            origin: (
                MARGIN + 0.5 * (SIZE[0] - scale * extent.x) - scale * bounds.min.x,
                MARGIN + scale * bounds.max.y,
            ),
        }
    }

    fn at(&self, p: Point3) -> (f64, f64) {
        let (x, y) = Self::flat(self.stretching, p);
        (
            self.origin.0 + self.scale * x,
            self.origin.1 - self.scale * y,
        )
    }

    fn ring(&self, places: &[Point3]) -> String {
        self.line(places) + "z"
    }

    fn line(&self, places: &[Point3]) -> String {
        let mut pen = Pen::default();
        pen.line(places.iter().map(|&p| self.at(p)));
        pen.path()
    }
}

pub(crate) fn figure(input: &RoundsInput, round: &RoundView) -> Figure {
    let found = round.interpretation;
    let outline = &input.task.surface.outline;
    let bounds = surface::extent(&input.task.surface);
    let corners = list_corners(&bounds);
    let plane = (found.plane.as_ref()).and_then(|plane| PlaneBox::new(plane, &corners));
    let path = reduce::select_drawable(found);
    let reach = AROUND * bounds.size().norm();
    let near = |p: &Point3| {
        let beyond = (p.xy() - bounds.center()).abs() - 0.5 * bounds.size();
        beyond.x.max(beyond.y) < reach && p.z.abs() < reach
    };
    let travelled: Vec<Point3> = (path.iter().map(|piece| piece.position))
        .filter(near)
        .collect();
    let shown: Vec<Point3> = (corners.iter().copied())
        .chain(plane.iter().flat_map(PlaneBox::corners))
        .chain(travelled)
        .collect();
    let stretching = find_height_factor(&shown, bounds.size().norm());
    let projection = Projection::new(stretching, shown.iter().copied());
    let stretches = reduce::split_stretches(&path, STRETCH / projection.scale);
    let base: Vec<Vec<Point3>> = (outline.rings())
        .map(|ring| ring.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect())
        .collect();
    let lowest = shown.iter().map(|&p| projection.at(p).1);
    let height = lowest.fold(0.0, f64::max) + BELOW;
    let base: String = base.iter().map(|ring| projection.ring(ring)).collect();
    let body = html! {
        svg x="0" y="0" width=(px(WIDTH)) height=(px(height)) viewBox=(format!("0 0 {} {}", px(WIDTH), px(height))) {
            path class="believed-surface" d=(base) {}
            @if let Some(plane) = &plane { (plane.draw(&projection)) }
            (draw_path(&projection, path.first().map(|piece| piece.position), &stretches))
            (draw_axis_lengths(&projection, height, &shown))
        }
    };
    Figure {
        panel: Panel {
            width: WIDTH,
            height,
            body,
        },
        entries: list_entries(&stretches, plane.as_ref(), stretching),
        what: format!(
            "The tool's path over the surface, coloured by contact force; {}",
            describe_height_scale(stretching)
        ),
    }
}

/// Describes the scale of heights.
fn describe_height_scale(stretching: f64) -> String {
    if stretching > 1.0 {
        format!("heights enlarged {stretching} times")
    } else {
        "heights to scale".to_owned()
    }
}

/// Returns the corners of bounds, anticlockwise from the lower left.
fn list_corners(bounds: &Bounds2) -> [Point3; 4] {
    let (low, high) = (bounds.min, bounds.max);
    [
        (low.x, low.y),
        (high.x, low.y),
        (high.x, high.y),
        (low.x, high.y),
    ]
    .map(|(x, y)| Point3::new(x, y, 0.0))
}

/// Returns the largest factor with which heights stay within their share of the picture.
fn find_height_factor(shown: &[Point3], extent: f64) -> f64 {
    let (low, high) = (shown.iter()).fold((0.0, 0.0), |(low, high): (f64, f64), p| {
        (low.min(p.z), high.max(p.z))
    });
    let fits = |factor: &&f64| **factor * (high - low) <= HEIGHT_SHARE * extent;
    STRETCHING.iter().rev().find(fits).copied().unwrap_or(1.0)
}

/// The fitted plane over the surface, as thick as the spread of its inliers.
struct PlaneBox {
    top: [Point3; 4],
    bottom: [Point3; 4],
    half: f64,
}

impl PlaneBox {
    /// Makes the box; `None` for a steep plane.
    fn new(plane: &FittedPlane, corners: &[Point3; 4]) -> Option<Self> {
        const STEEPEST: f64 = 0.2;
        let (n, p) = (plane.normal, plane.point);
        if !(n.z > STEEPEST && p.coords.iter().chain(n.iter()).all(|v| v.is_finite())) {
            return None;
        }
        let half = (HALF_IN_RMS * plane.rms).max(LEAST_HALF);
        let lifted = |by: f64| {
            corners.map(|c| {
                let fall = n.x * (c.x - p.x) + n.y * (c.y - p.y);
                Point3::new(c.x, c.y, p.z - fall / n.z + by)
            })
        };
        Some(Self {
            top: lifted(half),
            bottom: lifted(-half),
            half,
        })
    }

    fn corners(&self) -> impl Iterator<Item = Point3> {
        self.top.into_iter().chain(self.bottom)
    }

    /// Draws the two visible sides and the top.
    fn draw(&self, projection: &Projection) -> Markup {
        let side = |i: usize| {
            let j = (i + 1) % 4;
            [self.bottom[i], self.bottom[j], self.top[j], self.top[i]]
        };
        html! {
            @for face in [side(0), side(1), self.top] {
                path class="fitted-plane" d=(projection.ring(&face)) {}
            }
        }
    }
}

/// Draws the path with free motion below contact, and pushes on top.
fn draw_path(projection: &Projection, start: Option<Point3>, stretches: &[Stretch]) -> Markup {
    let mut lines: Vec<(&str, Vec<Point3>)> = Vec::new();
    let mut before = start;
    for stretch in stretches {
        let class = find_class(stretch);
        match lines.last_mut() {
            Some((of, places)) if *of == class => places.push(stretch.end),
            _ => lines.push((class, before.into_iter().chain([stretch.end]).collect())),
        }
        before = Some(stretch.end);
    }
    let of = |class: &str| -> String {
        let same = lines.iter().filter(|(other, _)| *other == class);
        same.map(|(_, places)| projection.line(places)).collect()
    };
    html! {
        @for class in ["touch-free"].into_iter().chain(LEVELS).chain(["touch-false"]) {
            @let line = of(class);
            @if !line.is_empty() { path class=(class) d=(line) {} }
        }
    }
}

fn find_class(stretch: &Stretch) -> &'static str {
    match stretch.touch {
        Touch::Free => "touch-free",
        Touch::FalsePositive => "touch-false",
        Touch::Weak | Touch::Confident => LEVELS[find_level(stretch.normalized_force)],
    }
}

/// Returns the index of the fifth of full force.
fn find_level(normalized_force: f64) -> usize {
    ((5.0 * normalized_force).ceil() as usize).clamp(1, 5) - 1
}

/// Draws a round length along each axis in the lower left corner.
fn draw_axis_lengths(projection: &Projection, height: f64, shown: &[Point3]) -> Markup {
    /// Approximate length of the lines [units of the picture].
    const LONG: f64 = 50.0;
    let origin = (MARGIN + 4.0, height - 34.0);
    let high = shown.iter().fold(0.0, |high: f64, p| high.max(p.z.abs()));
    let upright = projection.scale * projection.stretching * ELEVATION.cos();
    let flat = find_tick_step(0.5 * LONG / projection.scale);
    let up = find_tick_step((0.3 * high).clamp(12.0 / upright, LONG / upright) / 2.0);
    let end = |p: Point3| {
        let (x, y) = Projection::flat(projection.stretching, p);
        let scale = projection.scale;
        (origin.0 + scale * x, origin.1 - scale * y)
    };
    let (x, y, z) = (
        end(Point3::new(flat, 0.0, 0.0)),
        end(Point3::new(0.0, flat, 0.0)),
        end(Point3::new(0.0, 0.0, up)),
    );
    let mut lines = Pen::default();
    for tip in [x, y, z] {
        lines.line([origin, tip]);
    }
    let centimetres = format_decimal(100.0 * flat, usize::from(flat < 0.0095));
    html! {
        path class="axis" d=(lines.path()) {}
        text class="text small" x=(px(x.0 + 4.0)) y=(px(x.1 + 8.0)) { "x, " (centimetres) " cm" }
        text class="text small" x=(px(y.0 + 4.0)) y=(px(y.1 + 9.0)) { "y, " (centimetres) " cm" }
        text class="text small" x=(px(z.0 - 4.0)) y=(px(z.1.min(y.1) - 6.0)) { "z, " (format_decimal(1e3 * up, usize::from(up < 0.9e-3))) " mm" }
    }
}

fn list_entries(stretches: &[Stretch], plane: Option<&PlaneBox>, stretching: f64) -> Vec<Entry> {
    let has = |wanted: &str| {
        stretches
            .iter()
            .any(|stretch| find_class(stretch) == wanted)
    };
    let mut entries = Vec::new();
    for (i, level) in LEVELS.iter().enumerate().filter(|(_, level)| has(level)) {
        let label = format!(
            "contact, f' {:.1} to {:.1}",
            0.2 * i as f64,
            0.2 * (i + 1) as f64
        );
        entries.push(legend::line(level, label));
    }
    if has("touch-free") {
        entries.push(legend::line("touch-free", "no contact"));
    }
    if has("touch-false") {
        entries.push(legend::line(
            "touch-false",
            "false positive: force away from the plane",
        ));
    }
    if let Some(plane) = plane {
        let half = format_decimal(1e3 * plane.half, 1);
        entries.push(legend::area(
            "fitted-plane",
            format!("fitted plane, ± {half} mm"),
        ));
    }
    entries.push(legend::area(
        "believed-surface",
        format!("believed surface ({})", describe_height_scale(stretching)),
    ));
    entries
}
