//! Mapping from metres on the surface to units of a picture, with axes.

use super::numbers::{count_decimals, find_tick_step, format_decimal, px};
use maud::{Markup, html};
use std::fmt::Write;
use wisch::geometry::{Bounds2, PlanarPose, Point2, Region, Vector2};

/// Space for the numbers of the axes, left and below.
const AXIS_LEFT: f64 = 48.0;
const AXIS_BELOW: f64 = 40.0;
/// Wanted distance between two numbers on an axis.
const TICK_PITCH: f64 = 90.0;

/// The shown part of the surface plane, and its place in the picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    low: Point2,
    high: Point2,
    /// Units of the picture per metre.
    pub(crate) scale: f64,
    left: f64,
    top: f64,
}

impl View {
    /// Fits `bounds` [m] into a box of at most `size` units whose corner lies at (`left`, `top`).
    pub(crate) fn fit(bounds: Bounds2, left: f64, top: f64, size: Vector2) -> Self {
        let extent = bounds.size();
        let scale = (size.x / extent.x).min(size.y / extent.y);
        Self {
            low: bounds.min,
            high: bounds.max,
            scale: if scale.is_finite() { scale } else { 1.0 },
            left,
            top,
        }
    }

    /// Like [`View::fit`], at the top of the picture and centred in its width.
    pub(crate) fn centred(bounds: Bounds2, size: Vector2) -> Self {
        let view = Self::fit(bounds, 0.0, 0.0, size);
        Self {
            left: (size.x - view.width()) / 2.0,
            ..view
        }
    }

    /// Like [`View::centred`], with space for axes on the left and below.
    pub(crate) fn with_axes(bounds: Bounds2, size: Vector2) -> Self {
        let inner = Vector2::new(size.x - AXIS_LEFT - 12.0, size.y);
        let view = Self::centred(bounds, inner);
        Self {
            left: AXIS_LEFT + view.left,
            top: 10.0,
            ..view
        }
    }

    pub(crate) fn width(&self) -> f64 {
        (self.high.x - self.low.x) * self.scale
    }

    pub(crate) fn height(&self) -> f64 {
        (self.high.y - self.low.y) * self.scale
    }

    /// Returns the lower end of the axes.
    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.height() + AXIS_BELOW
    }

    pub(crate) fn left(&self) -> f64 {
        self.left
    }

    pub(crate) fn top(&self) -> f64 {
        self.top
    }

    /// Maps a point of the surface [m] to the picture, where y points down.
    pub(crate) fn at(&self, p: Point2) -> (f64, f64) {
        (
            self.left + (p.x - self.low.x) * self.scale,
            self.top + (self.high.y - p.y) * self.scale,
        )
    }

    /// Returns closed rings as an SVG path.
    pub(crate) fn rings<'a>(&self, rings: impl IntoIterator<Item = &'a [Point2]>) -> String {
        let mut pen = Pen::default();
        for ring in rings {
            pen.line(ring.iter().map(|&p| self.at(p)));
            if !ring.is_empty() {
                pen.close();
            }
        }
        pen.path()
    }

    /// Returns an open line as an SVG path.
    pub(crate) fn line(&self, points: impl IntoIterator<Item = Point2>) -> String {
        let mut pen = Pen::default();
        pen.line(points.into_iter().map(|p| self.at(p)));
        pen.path()
    }

    /// Returns the tool's footprint at a pose as an SVG path.
    pub(crate) fn footprint(&self, footprint: &Region, surface_from_tool: &PlanarPose) -> String {
        let rings: Vec<Vec<Point2>> = footprint
            .polygons()
            .iter()
            .flat_map(|polygon| polygon.rings())
            .map(|ring| {
                ring.iter()
                    .map(|&p| surface_from_tool.transform(p))
                    .collect()
            })
            .collect();
        self.rings(rings.iter().map(Vec::as_slice))
    }

    /// Draws axes with numbers in metres around the view.
    pub(crate) fn axes(&self) -> Markup {
        let step = find_tick_step(TICK_PITCH / self.scale);
        let (right, bottom) = (self.left + self.width(), self.top + self.height());
        let ticks = |low: f64, high: f64| {
            ((low / step).ceil() as i64..=(high / step).floor() as i64)
                .map(move |i| i as f64 * step)
        };
        let digits = count_decimals(step);
        html! {
            rect class="axis" x=(px(self.left)) y=(px(self.top)) width=(px(self.width())) height=(px(self.height())) {}
            @for x in ticks(self.low.x, self.high.x) {
                @let at = self.at(Point2::new(x, self.low.y)).0;
                path class="axis" d=(format!("M{} {}v5", px(at), px(bottom))) {}
                @if at < right - 46.0 {
                    text class="text quiet small middle" x=(px(at)) y=(px(bottom + 17.0)) { (format_decimal(x, digits)) }
                }
            }
            @for y in ticks(self.low.y, self.high.y) {
                @let at = self.at(Point2::new(self.low.x, y)).1;
                path class="axis" d=(format!("M{} {}h-5", px(self.left), px(at))) {}
                @if at > self.top + 18.0 {
                    text class="text quiet small end" x=(px(self.left - 8.0)) y=(px(at + 4.0)) { (format_decimal(y, digits)) }
                }
            }
            text class="text quiet small end" x=(px(right)) y=(px(bottom + 17.0)) { "x [m]" }
            text class="text quiet small end" x=(px(self.left - 8.0)) y=(px(self.top + 9.0)) { "y [m]" }
        }
    }

    /// Draws a scale bar of a round length in the lower left corner of the view.
    pub(crate) fn scale_bar(&self) -> Markup {
        let length = find_tick_step(0.12 * self.width() / self.scale);
        let (x, y) = (self.left + 12.0, self.top + self.height() - 12.0);
        let label = if length < 0.995 {
            format!("{} cm", (length * 100.0 * 10.0).round() / 10.0)
        } else {
            format!("{length} m")
        };
        html! {
            path class="axis" d=(format!("M{} {}v4h{}v-4", px(x), px(y - 4.0), px(length * self.scale))) {}
            text class="text small" x=(px(x)) y=(px(y - 8.0)) { (label) }
        }
    }
}

/// A builder of an SVG path.
#[derive(Debug, Default)]
pub(crate) struct Pen(String);

impl Pen {
    pub(crate) fn line(&mut self, points: impl IntoIterator<Item = (f64, f64)>) {
        for (i, (x, y)) in points.into_iter().enumerate() {
            let _ = write!(
                self.0,
                "{}{} {}",
                if i == 0 { 'M' } else { 'L' },
                px(x),
                px(y)
            );
        }
    }

    /// Adds a point, which is visible through its round line cap.
    pub(crate) fn dot(&mut self, (x, y): (f64, f64)) {
        let _ = write!(self.0, "M{} {}h0", px(x), px(y));
    }

    pub(crate) fn ring(&mut self, (x, y): (f64, f64), radius: f64) {
        // Rounding comes first: arcs whose chord differs from their diameter do not form a circle.
        let radius = (radius * 10.0).round() / 10.0;
        let (r, d) = (px(radius), px(2.0 * radius));
        let _ = write!(
            self.0,
            "M{} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0-{d} 0",
            px(x - radius),
            px(y)
        );
    }

    pub(crate) fn cross(&mut self, (x, y): (f64, f64), reach: f64) {
        let (r, d) = (reach, px(2.0 * reach));
        let _ = write!(
            self.0,
            "M{} {}l{d} {d}M{} {}l{d}-{d}",
            px(x - r),
            px(y - r),
            px(x - r),
            px(y + r)
        );
    }

    pub(crate) fn slash(&mut self, (x, y): (f64, f64), reach: f64) {
        let d = px(2.0 * reach);
        let _ = write!(self.0, "M{} {}l{d}-{d}", px(x - reach), px(y + reach));
    }

    pub(crate) fn close(&mut self) {
        self.0.push('z');
    }

    pub(crate) fn path(self) -> String {
        self.0
    }
}
