//! Contact of a compliant tool with a curved surface: where the tool touches, and with which
//! pressure.
//!
//! The tool is an elastic foundation (Johnson, Contact Mechanics, 1985, §4.3): a bed of independent springs under a
//! held force. Over the tangent plane at the tool centre point, the surface has the height h(q) = s·q − ½ qᵀBq, with the
//! slope s against the tool and the second fundamental form B. The nominal force compresses the springs by δ on a
//! plane. The pressure over the nominal one is then f′(q) = m + (s·q − ½ qᵀBq) / δ where it is positive, and 0
//! elsewhere, where the tool does not touch. Its mean over the footprint is the force, which determines m.
//!
//! - If the whole footprint touches, m follows from the second moments of the footprint, which are exact for every
//!   polygon. For a rectangle with sides L₁ and L₂ along the principal directions, all of it touches on a bulge if
//!   κ₁L₁² + κ₂L₂² ≤ 12 δ, and in a hollow if |κ₁L₁² + κ₂L₂²| ≤ 24 δ.
//! - Otherwise, m is the root of a convex function, which Newton's method approaches from one side. The integrals over
//!   the touched part are sums over the edges of the footprint: exact where the surface bends in one direction only,
//!   and by quadrature to about 1e-9 elsewhere. On a cylinder, a strip of the share Λ^(−1/3)
//!   touches, with Λ = κL²/12δ. Under a round pad of radius r on a sphere, a disc of the share
//!   Λ^(−1/2) touches, with Λ = κr²/4δ.
//!
//! The model neglects shear between the springs, and approximates the surface by a parabola under
//! the tool.

use super::{Interaction, LogNormal};
use crate::geometry::{Bounds2, Edge, Point2, Region, Vector2, encloses};
use nalgebra::{Matrix2, Rotation2};

/// Compression of a tool that counts as rigid \[m\]: even a dense rubber lip or a hard plate yields
/// by about a tenth of a millimetre.
pub const RIGID_COMPRESSION: f64 = 1e-4;
/// Largest pressure over the nominal one \[1\]: foam that is compressed twice as far as at nominal force begins to bottom
/// out, and its springs are no longer linear.
pub const MAX_PRESSURE: f64 = 2.0;
/// Largest value of [`effective_pressure`] [1]: planning assumes that the nominal pressure acts,
/// for every likelihood.
const MAX_EFFECTIVE: f64 = 0.6;
/// Ratio of the curvatures below which the smaller one counts as 0 [1].
const FLAT: f64 = 1e-12;
/// Largest number of steps of Newton's method; 4 to 8 are usual.
const MAX_STEPS: usize = 60;
/// Relative step at which Newton's method ends [1].
const CONVERGED: f64 = 1e-13;
/// Number of lines across one half of a tool on which its action is checked.
const LINES: usize = 200;
/// Number of parts of a smooth piece of an edge, where the integrand is no polynomial.
const PARTS: usize = 4;
/// Nodes and weights of the Gauss–Legendre rule with five points, exact for polynomials up to degree 9.
const GAUSS: [[f64; 2]; 5] = [
    [-0.906_179_845_938_664, 0.236_926_885_056_189_08],
    [-0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [0.0, 0.568_888_888_888_888_9],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [0.906_179_845_938_664, 0.236_926_885_056_189_08],
];

/// Returns the least pressure over the nominal pressure at which planning counts a place as touched
/// \[1\]: the median e^μ of the likelihood, at most 0.6.
pub fn effective_pressure(likelihood: &LogNormal) -> f64 {
    libm::exp(likelihood.mu).min(MAX_EFFECTIVE)
}

/// Returns the compression at nominal force \[m\] with which a rectangular pad touches with its
/// whole footprint, if its sides lie along the principal directions in the better of the two ways.
///
/// The pressure is least at the corners on bulges and in the middle in hollows, so that Σ κL²/12 over bulges and
/// Σ |κ|L²/24 over hollows are needed together.
///
/// # Parameters
/// - `curvatures`: principal curvatures \[1/m\], positive where the surface bulges towards the tool.
/// - `sides`: sides of the pad \[m\].
///
/// ```
/// use wisch::represent::find_needed_compression;
/// // The short side lies across a bulge of radius 0.5 m: 2 · 0.06² / 12.
/// assert!((find_needed_compression([2.0, 0.0], [0.1, 0.06]) - 0.0006).abs() < 1e-12);
/// ```
pub fn find_needed_compression(curvatures: [f64; 2], sides: [f64; 2]) -> f64 {
    let needed = |curvature: f64, side: f64| {
        let share = if curvature > 0.0 { 12.0 } else { 24.0 };
        curvature.abs() * side * side / share
    };
    let ([one, other], [x, y]) = (curvatures, sides);
    (needed(one, x) + needed(other, y)).min(needed(one, y) + needed(other, x))
}

/// The elastic foundation of a tool: its footprint, and its compression at nominal force.
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticFoundation {
    /// Boundary of the footprint, in the tool frame [m].
    edges: Vec<Edge>,
    /// Area of the footprint [m²].
    area: f64,
    /// Mean of the places in the footprint [m], and of their squares q qᵀ [m²].
    mean: Vector2,
    squares: Matrix2<f64>,
    /// Compression at nominal force on a plane [m].
    compression: f64,
}

impl ElasticFoundation {
    /// Returns the foundation of a footprint (tool frame \[m\]); `None` for a footprint without area.
    ///
    /// # Parameters
    /// - `compression`: compression δ at nominal force on a plane \[m\]; below [`RIGID_COMPRESSION`], the tool is rigid
    ///   and that value counts.
    pub fn new(footprint: &Region, compression: f64) -> Option<Self> {
        let edges: Vec<Edge> = footprint.edges().collect();
        let (mut area, mut mean, mut squares) = (0.0, Vector2::zeros(), Matrix2::zeros());
        for edge in &edges {
            // Triangles to the origin: area (a × b)/2, mean (a + b)/3, mean square (aaᵀ + bbᵀ + (a + b)(a + b)ᵀ)/12.
            let [a, b] = [edge.start.coords, edge.end.coords];
            let triangle = a.perp(&b) / 2.0;
            let sum = a + b;
            area += triangle;
            mean += sum * (triangle / 3.0);
            let square = a * a.transpose() + b * b.transpose() + sum * sum.transpose();
            squares += square * (triangle / 12.0);
        }
        (area > 0.0).then(|| Self {
            edges,
            area,
            mean: mean / area,
            squares: squares / area,
            compression: compression.max(RIGID_COMPRESSION),
        })
    }

    /// Returns the foundation of a tool with this footprint as the interaction compresses it; `None` for a tool that
    /// hovers, or a footprint without area.
    pub fn from_interaction(footprint: &Region, interaction: &Interaction) -> Option<Self> {
        if interaction.hovers() {
            return None;
        }
        Self::new(footprint, interaction.compression_depth_m)
    }

    /// Returns the pressure under the tool if it is pressed onto a curved surface.
    ///
    /// # Parameters
    /// - `force`: force over the nominal one \[1\], which is the mean of the pressure; above 0.
    /// - `slope`: slope of the surface against the tool at the tool centre point, in the tool frame \[1\].
    /// - `bend`: second fundamental form in the tool frame \[1/m\], positive where the surface bulges towards the tool.
    pub fn press(&self, force: f64, slope: Vector2, bend: &Matrix2<f64>) -> LocalPressure {
        self.press_with_least(force, slope, bend).0
    }

    /// Returns the pressure, see [`Self::press`], and its least value over the footprint [1].
    fn press_with_least(
        &self,
        force: f64,
        slope: Vector2,
        bend: &Matrix2<f64>,
    ) -> (LocalPressure, f64) {
        let scale = 1.0 / self.compression;
        let mut pressure = LocalPressure {
            middle: 0.0,
            rise: slope * scale,
            bend: bend * scale,
        };
        // All of it touches: mean of m + rise·q − ½ qᵀBq/δ = force.
        let bent = pressure.bend.component_mul(&self.squares).sum();
        pressure.middle = force - pressure.rise.dot(&self.mean) + bent / 2.0;
        let [least, _] = self.range(&pressure);
        if least >= 0.0 {
            return (pressure, least);
        }
        let axes = PrincipalAxes::of(&pressure);
        for _ in 0..MAX_STEPS {
            // Mean pressure and touched share are the function and its derivative. The function is convex and rises, so
            // that Newton's method stays above its root.
            let [mean, share] = self.integrate(&axes, pressure.middle);
            let step = (mean - force) / share;
            if !step.is_finite() {
                break;
            }
            pressure.middle -= step;
            if step.abs() <= CONVERGED * (pressure.middle.abs() + force) {
                break;
            }
        }
        (pressure, self.range(&pressure)[0])
    }

    /// Returns the pressure of an upright tool at nominal force, at a yaw \[rad\] against the axes
    /// of `bend`, the second fundamental form \[1/m\].
    pub fn press_upright(&self, bend: &Matrix2<f64>, yaw: f64) -> LocalPressure {
        self.press_turned(bend, &Rotation2::new(yaw)).0
    }

    /// Returns the pressure, see [`Self::press_upright`], and its least value over the footprint \[1\].
    pub(crate) fn press_turned(
        &self,
        bend: &Matrix2<f64>,
        turn: &Rotation2<f64>,
    ) -> (LocalPressure, f64) {
        let in_tool = turn.inverse().matrix() * bend * turn.matrix();
        self.press_with_least(1.0, Vector2::zeros(), &in_tool)
    }

    /// Returns the curvature up to which the pressure of an upright tool at nominal force is at
    /// least `least` everywhere under the tool: Frobenius norm of the second fundamental form
    /// [1/m].
    pub(crate) fn harmless_bend(&self, least: f64) -> f64 {
        // f′(q) = 1 + ½⟨C, S⟩ − ½ qᵀCq ≥ 1 − ½ |C| (|S| + r²), with S the mean square of the places, and C = B/δ.
        let corners = self
            .edges
            .iter()
            .map(|edge| edge.start.coords.norm_squared());
        let reach = self.squares.norm() + corners.fold(0.0, f64::max);
        // Less by the rounding errors of the pressure.
        (1.0 - 1e-9) * (2.0 * (1.0 - least).max(0.0) * self.compression / reach)
    }

    /// Returns the least and the largest value of f′ over the footprint \[1\]; below 0 where the tool does not touch.
    pub fn range(&self, pressure: &LocalPressure) -> [f64; 2] {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        let mut add = |place: Vector2| {
            let value = pressure.value(place);
            range = [range[0].min(value), range[1].max(value)];
        };
        for edge in &self.edges {
            let along = edge.end - edge.start;
            add(edge.start.coords);
            let line = pressure.on_line(edge.start.coords, along);
            let turning_point = line.slope / line.bend;
            if turning_point > 0.0 && turning_point < 1.0 {
                add(edge.start.coords + along * turning_point);
            }
        }
        let stationary = (pressure.bend.try_inverse()).map(|inverse| inverse * pressure.rise);
        if let Some(place) = stationary.filter(|place| place.iter().all(|x| x.is_finite()))
            && encloses(self.edges.iter().copied(), Point2::from(place))
        {
            add(place);
        }
        range
    }

    /// Returns the share of the footprint that touches \[1\].
    pub fn touched_share(&self, pressure: &LocalPressure) -> f64 {
        if self.range(pressure)[0] >= 0.0 {
            return 1.0;
        }
        self.integrate(&PrincipalAxes::of(pressure), pressure.middle)[1]
    }

    /// Returns the width of the strip that the tool treats as it moves along its x axis \[m\]: the
    /// lines along x that cross the part of its bounds whose pressure reaches `least`. The strip
    /// lies about the tool centre point. If the tool does not act in the middle, there is a strip
    /// at either end, and the result is the width of the narrower one.
    pub fn acting_width(&self, pressure: &LocalPressure, least: f64) -> f64 {
        let corners = self.edges.iter().map(|edge| edge.start);
        let Some(bounds) = Bounds2::from_points(corners) else {
            return 0.0;
        };
        let acts = |lateral: f64| {
            let line = pressure.on_line(Vector2::new(0.0, lateral), Vector2::x());
            let range = line.exceeds(least);
            if range.is_between {
                range.low.max(bounds.min.x) < range.high.min(bounds.max.x)
            } else {
                range.low > bounds.min.x || range.high < bounds.max.x
            }
        };
        let is_in_middle = acts(0.0);
        let sides = [bounds.min.y, bounds.max.y].map(|end| {
            let at = |i: usize| end * i as f64 / LINES as f64;
            let count = if is_in_middle {
                (1..=LINES).take_while(|&i| acts(at(i))).count()
            } else {
                // Lines at the ends: n of them span n − 1 steps.
                let acting = (1..=LINES).rev().take_while(|&i| acts(at(i)));
                acting.count().saturating_sub(1)
            };
            at(count).abs()
        });
        let width = sides[0].min(sides[1]);
        if is_in_middle { 2.0 * width } else { width }
    }

    /// Compression at nominal force on a plane \[m\].
    pub fn compression(&self) -> f64 {
        self.compression
    }

    /// Returns the mean of the positive part of f′ over the footprint and the share on which it is positive [1].
    fn integrate(&self, axes: &PrincipalAxes, middle: f64) -> [f64; 2] {
        // Green's theorem: ∬ g du dv = −∮ G du, with G(u, v) the integral of g from 0 to v.
        let sums = self.edges.iter().fold([0.0; 2], |sums, edge| {
            let part = axes.integrate_edge(edge, middle);
            [sums[0] - part[0], sums[1] - part[1]]
        });
        sums.map(|sum| sum / self.area)
    }
}

/// Pressure under a tool over the nominal pressure, as a function of place: f′(q) = m + r·q − ½ qᵀCq.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalPressure {
    /// Value at the tool centre point \[1\]; below 0 if the tool does not touch there.
    pub middle: f64,
    /// Gradient at the tool centre point, along x and y of the tool \[1/m\].
    pub rise: Vector2,
    /// Decrease of the gradient, in the tool frame \[1/m²\]: the bend of the surface over the compression.
    pub bend: Matrix2<f64>,
}

impl LocalPressure {
    /// Returns the pressure at a place under the tool (tool frame \[m\]), from 0 to [`MAX_PRESSURE`].
    pub fn evaluate(&self, place: Point2) -> f64 {
        self.value(place.coords).clamp(0.0, MAX_PRESSURE)
    }

    /// Returns the largest pressure on a straight way under the tool (tool frame \[m\]), from 0 to [`MAX_PRESSURE`].
    pub fn largest_between(&self, from: Point2, to: Point2) -> f64 {
        let line = self.on_line(from.coords, to - from);
        let turning_point = (line.slope / line.bend).clamp(0.0, 1.0);
        let inside = if line.bend > 0.0 {
            line.at(turning_point)
        } else {
            f64::NEG_INFINITY
        };
        let largest = line.at(0.0).max(line.at(1.0)).max(inside);
        largest.clamp(0.0, MAX_PRESSURE)
    }

    /// f′ without its limits [1].
    fn value(&self, place: Vector2) -> f64 {
        self.middle + self.rise.dot(&place) - 0.5 * place.dot(&(self.bend * place))
    }

    /// Returns f′ on a line, as a parabola in the distance along `direction` over its length.
    pub(super) fn on_line(&self, start: Vector2, direction: Vector2) -> Parabola {
        Parabola {
            value: self.value(start),
            slope: (self.rise - self.bend * start).dot(&direction),
            bend: direction.dot(&(self.bend * direction)),
        }
    }
}

/// A parabola p(t) = value + slope · t − bend · t²/2.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parabola {
    value: f64,
    slope: f64,
    bend: f64,
}

/// Where a parabola is positive: between two points, or everywhere but between them.
#[derive(Debug, Clone, Copy)]
pub(super) struct PositiveRange {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) is_between: bool,
}

impl Parabola {
    fn at(&self, t: f64) -> f64 {
        self.value + t * (self.slope - 0.5 * self.bend * t)
    }

    /// Integral from 0 to t.
    fn primitive(&self, t: f64) -> f64 {
        t * (self.value + t * (self.slope / 2.0 - self.bend * t / 6.0))
    }

    /// Returns the two roots in ascending order, if there are two.
    fn roots(&self) -> Option<[f64; 2]> {
        let discriminant = self.slope * self.slope + 2.0 * self.bend * self.value;
        if discriminant <= 0.0 || self.bend == 0.0 {
            return None;
        }
        // In the form that does not cancel: one root by addition, the other by their product −2 value / bend.
        let sum = self.slope + libm::sqrt(discriminant).copysign(self.slope);
        let roots = [sum / self.bend, -2.0 * self.value / sum];
        Some([roots[0].min(roots[1]), roots[0].max(roots[1])])
    }

    /// Returns the zeros, of which one or both may not be finite.
    fn zeros(&self) -> [f64; 2] {
        let linear = [-self.value / self.slope, f64::NAN];
        match self.roots() {
            Some(roots) => roots,
            None if self.bend == 0.0 => linear,
            None => [f64::NAN; 2],
        }
    }

    /// Returns where the parabola exceeds a limit; at every finite distance where it is constant and above it.
    pub(super) fn exceeds(&self, limit: f64) -> PositiveRange {
        let above = Self {
            value: self.value - limit,
            ..*self
        };
        let nowhere = [f64::INFINITY, f64::NEG_INFINITY];
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        let ([low, high], is_between) = match above.roots() {
            Some(roots) => (roots, above.bend > 0.0),
            // Without roots, a parabola has one sign.
            None if above.bend > 0.0 => (nowhere, true),
            None if above.bend < 0.0 => (everywhere, true),
            None if above.slope == 0.0 && above.value >= 0.0 => (everywhere, true),
            None if above.slope == 0.0 => (nowhere, true),
            None => {
                let root = -above.value / above.slope;
                let rises = above.slope > 0.0;
                let range = [[f64::NEG_INFINITY, root], [root, f64::INFINITY]];
                (range[usize::from(rises)], true)
            }
        };
        PositiveRange {
            low,
            high,
            is_between,
        }
    }
}

/// A pressure in its principal axes: u in the direction of the larger curvature, v across it.
struct PrincipalAxes {
    /// Directions of u and v in the tool frame.
    axes: [Vector2; 2],
    rise: [f64; 2],
    bend: [f64; 2],
}

impl PrincipalAxes {
    fn of(pressure: &LocalPressure) -> Self {
        let [a, b, d] = [(0, 0), (0, 1), (1, 1)].map(|place| pressure.bend[place]);
        let angle = 0.5 * libm::atan2(2.0 * b, a - d);
        let (half, spread) = (0.5 * (a + d), libm::hypot(b, 0.5 * (a - d)));
        let first = Vector2::new(libm::cos(angle), libm::sin(angle));
        let second = Vector2::new(-first.y, first.x);
        let (axes, [most, least]) = if half >= 0.0 {
            ([first, second], [half + spread, half - spread])
        } else {
            // Turned by a right angle, the axes stay right-handed.
            ([second, -first], [half - spread, half + spread])
        };
        let least = if least.abs() <= FLAT * most.abs() {
            0.0
        } else {
            least
        };
        Self {
            rise: axes.map(|axis| axis.dot(&pressure.rise)),
            bend: [most, least],
            axes,
        }
    }

    /// Returns the integrals over u along an edge of G and of its length, where G(u, v) is the integral of the positive
    /// part of f′ from (u, 0) to (u, v).
    fn integrate_edge(&self, edge: &Edge, middle: f64) -> [f64; 2] {
        let [start, end] = [edge.start, edge.end]
            .map(|p| [self.axes[0].dot(&p.coords), self.axes[1].dot(&p.coords)]);
        let (run, rise) = (end[0] - start[0], end[1] - start[1]);
        if run == 0.0 {
            return [0.0; 2];
        }
        // Along u, the value of f′ at v = 0, as a parabola in the share t of the edge.
        let foot = Parabola {
            value: middle + start[0] * (self.rise[0] - 0.5 * self.bend[0] * start[0]),
            slope: (self.rise[0] - self.bend[0] * start[0]) * run,
            bend: self.bend[0] * run * run,
        };
        let mut cuts = [0.0; 8];
        cuts[1] = 1.0;
        let mut count = 2;
        // Kinks of G: where f′ vanishes at v = 0, where it vanishes on the edge, and where it vanishes for one v only.
        let on_edge = Parabola {
            value: foot.value + start[1] * (self.rise[1] - 0.5 * self.bend[1] * start[1]),
            slope: foot.slope + (self.rise[1] - self.bend[1] * start[1]) * rise,
            bend: foot.bend + self.bend[1] * rise * rise,
        };
        let peak = Parabola {
            value: foot.value + self.rise[1] * self.rise[1] / (2.0 * self.bend[1]),
            ..foot
        };
        for kinks in [foot, on_edge, peak] {
            for root in kinks.zeros() {
                if root > 0.0 && root < 1.0 {
                    cuts[count] = root;
                    count += 1;
                }
            }
        }
        let cuts = &mut cuts[..count];
        cuts.sort_by(f64::total_cmp);
        let value = |t: f64| {
            let across = Parabola {
                value: foot.at(t),
                slope: self.rise[1],
                bend: self.bend[1],
            };
            integrate_positive(&across, start[1] + rise * t)
        };
        let mut sums = [0.0; 2];
        for pair in cuts.windows(2) {
            let part = if self.bend[1] == 0.0 {
                integrate_polynomial(&value, [pair[0], pair[1]])
            } else {
                integrate_with_roots(&value, [pair[0], pair[1]])
            };
            sums = [sums[0] + part[0] * run, sums[1] + part[1] * run];
        }
        sums
    }
}

/// Integrals from 0 to v of the positive part of a parabola, and of the part on which it is positive.
fn integrate_positive(parabola: &Parabola, v: f64) -> [f64; 2] {
    let range = parabola.exceeds(0.0);
    let inside = if range.low <= range.high {
        let (to, from) = (
            v.clamp(range.low, range.high),
            0.0_f64.clamp(range.low, range.high),
        );
        [parabola.primitive(to) - parabola.primitive(from), to - from]
    } else {
        [0.0; 2]
    };
    if range.is_between {
        inside
    } else {
        [parabola.primitive(v) - inside[0], v - inside[1]]
    }
}

/// Integrates a polynomial of degree up to 9 over a range.
fn integrate_polynomial(value: &impl Fn(f64) -> [f64; 2], [from, to]: [f64; 2]) -> [f64; 2] {
    let (half, middle) = ((to - from) / 2.0, (to + from) / 2.0);
    GAUSS.iter().fold([0.0; 2], |sums, [node, weight]| {
        let found = value(middle + half * node);
        [0, 1].map(|i| sums[i] + weight * half * found[i])
    })
}

/// Integrates a function that behaves like a square root at the ends of the range: t = middle + half · sin θ.
fn integrate_with_roots(value: &impl Fn(f64) -> [f64; 2], [from, to]: [f64; 2]) -> [f64; 2] {
    use std::f64::consts::{FRAC_PI_2, PI};
    let (half, middle) = ((to - from) / 2.0, (to + from) / 2.0);
    let turned = |angle: f64| {
        let weight = half * libm::cos(angle);
        value(middle + half * libm::sin(angle)).map(|found| weight * found)
    };
    let width = PI / PARTS as f64;
    (0..PARTS).fold([0.0; 2], |sums, part| {
        let begin = width * part as f64 - FRAC_PI_2;
        let found = integrate_polynomial(&turned, [begin, begin + width]);
        [sums[0] + found[0], sums[1] + found[1]]
    })
}

#[cfg(test)]
mod tests;
