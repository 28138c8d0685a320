//! Encounter of a particle with a footprint that moves and turns at once.
//!
//! In the tool frame a resting particle follows a smooth curve, and a carried one rests. The entry into the footprint
//! is found by Newton's method if bounds on the curve show that it crosses a single edge at most once, else by
//! bisection with a bound on the curve's deviation from its chord. The release from the leading boundary has a closed
//! form. A released particle that would be touched again at once slides instead: it follows the point of the edge that
//! moves along the edge, neither towards the particle nor away from it. The result is exact to about 1e-9 m for any
//! rotation; the distance over which a treating tool slides over a place, to about 2e-5 m where an edge only grazes it.

use super::motion::{CLEARANCE, ToolMotion};
use crate::geometry::{Bounds2, Edge, Point2, Vector2, encloses};

/// Deviation from the chord below which the curve counts as straight [m].
const STRAIGHT: f64 = 1e-12;
/// Shortest part of the motion that is examined for an entry, as a share of the motion [1].
const SHORTEST: f64 = 1e-13;
/// Deviation from the chord below which a curve near an edge counts as straight, where a treating tool slides [m].
const TOUCHES: f64 = 1e-9;
/// Largest number of steps towards a crossing of an edge; Newton's method needs about four.
const MAX_BRACKETED: usize = 64;
/// Largest number of Newton steps towards an entry; they start within a fraction of a millimetre of
/// it.
const MAX_REFINEMENTS: usize = 8;
/// Largest number of entries and releases of one particle in one motion.
const MAX_EVENTS: usize = 64;
/// Largest rotation between two checks of sliding, before its end is bisected [rad].
const SLIDING_TURN: f64 = 0.02;
/// Distance from the turning point of an edge within which a particle is at it [m].
const AT_TURNING_POINT: f64 = 1e-7;
/// Largest distance from the boundary of a particle that an earlier motion carried [m].
const LEFT_BEHIND: f64 = 2.0 * CLEARANCE;
/// Largest rotation between two samples of a carried particle's path [rad].
const SAMPLED_TURN: f64 = 0.05;
const MAX_WAY: usize = 64;

/// Path of a carried particle in the surface frame, from its first place to its last.
pub(super) struct Way {
    points: [Point2; MAX_WAY],
    len: usize,
}

impl Way {
    fn from(start: Point2) -> Self {
        let mut points = [Point2::origin(); MAX_WAY];
        points[0] = start;
        Self { points, len: 1 }
    }

    fn end(&self) -> Point2 {
        self.points[self.len - 1]
    }

    /// Appends a point; a full path overwrites its last point, so that its end stays correct.
    fn push(&mut self, point: Point2) {
        self.len = (self.len + 1).min(MAX_WAY);
        self.points[self.len - 1] = point;
    }

    pub(super) fn points(&self) -> &[Point2] {
        &self.points[..self.len]
    }
}

/// The point of the boundary at which a particle touches the footprint, in the tool frame.
#[derive(Clone, Copy)]
struct Touch<'a> {
    point_in_tool: Point2,
    edge: &'a Edge,
}

/// A motion of a footprint, with position and yaw linear in t ∈ [0, 1].
pub(super) struct SweptRotation<'a> {
    edges: &'a [Edge],
    motion: &'a ToolMotion,
    travel: Vector2,
    turn: f64,
    /// Sine and cosine of the yaw at both ends.
    ends: [(f64, f64); 2],
    /// Bounds of the edges in the tool frame.
    bounds: Bounds2,
}

impl<'a> SweptRotation<'a> {
    pub(super) fn new(edges: &'a [Edge], motion: &'a ToolMotion) -> Self {
        let turn = motion.turn();
        let corners = edges.iter().map(|edge| edge.start);
        Self {
            edges,
            motion,
            travel: motion.to.position - motion.from.position,
            turn,
            ends: [0.0, 1.0].map(|t| (motion.from.heading + turn * t).sin_cos()),
            bounds: Bounds2::from_points(corners).unwrap_or(Bounds2 {
                min: Point2::origin(),
                max: Point2::origin(),
            }),
        }
    }

    /// Whether the particle comes under the footprint at any time.
    pub(super) fn touches(&self, particle: Point2) -> bool {
        self.covers(self.in_tool(particle, 0.0)) || self.entry(particle, 0.0, 1.0).is_some()
    }

    /// Returns how far the tool slides over a resting particle [m].
    pub(super) fn slid(&self, particle: Point2) -> f64 {
        // The velocity of the tool at the particle is linear in time, so the travel has a closed form.
        let arm = particle - self.motion.from.position;
        let begin = self.travel + Vector2::new(-arm.y, arm.x) * self.turn;
        let change = -Vector2::new(-self.travel.y, self.travel.x) * self.turn;
        let mut crossings = Vec::new();
        let chord = Edge {
            start: self.in_tool(particle, 0.0),
            end: self.in_tool(particle, 1.0),
        };
        self.find_crossings(particle, &chord, [0.0, 1.0], &mut crossings);
        crossings.sort_unstable_by(f64::total_cmp);
        let (mut slid, mut from) = (0.0, 0.0);
        for to in crossings.into_iter().chain([1.0]) {
            if to > from && self.covers(self.in_tool(particle, from + (to - from) / 2.0)) {
                slid += arc_length(begin, change, from, to);
            }
            from = to;
        }
        slid
    }

    /// Appends the times in [from, to] at which a resting particle crosses an edge; `chord` joins its positions at these
    /// times, in the tool frame.
    ///
    /// The curve's second derivative bounds its deviation from the chord, so that most spans are decided at their ends.
    /// A span is halved only while an edge near it may be crossed more than once.
    fn find_crossings(
        &self,
        particle: Point2,
        chord: &Edge,
        [from, to]: [f64; 2],
        crossings: &mut Vec<f64>,
    ) {
        let deviation = self.deviation(chord, to - from);
        if self.passes(chord, deviation) {
            return;
        }
        let near = || {
            let depths = |edge| Some((edge, depths_near(edge, chord, deviation)?));
            self.edges.iter().filter_map(depths)
        };
        // The rate differs from its mean by at most four times the deviation per span.
        let is_crossed_once =
            |[at_start, at_end]: [f64; 2]| (at_end - at_start).abs() > 4.0 * deviation;
        if deviation > TOUCHES && !near().all(|(_, depths)| is_crossed_once(depths)) {
            let middle = from + (to - from) / 2.0;
            let (start, end) = (chord.start, chord.end);
            let between = self.in_tool(particle, middle);
            let halves = [
                (start, between, [from, middle]),
                (between, end, [middle, to]),
            ];
            for (start, end, span) in halves {
                self.find_crossings(particle, &Edge { start, end }, span, crossings);
            }
            return;
        }
        for (edge, [at_start, at_end]) in near() {
            if (at_start > 0.0) != (at_end > 0.0) {
                let guess = from + (to - from) * at_start / (at_start - at_end);
                crossings.push(self.crossing(particle, edge, [from, to], guess, at_start > 0.0));
            }
        }
    }

    /// Returns when a resting particle crosses the line of an edge, on whose two sides it is at the ends of a span.
    /// `guess`: first guess of the time; `leaves`: whether it is on the inner side first.
    fn crossing(
        &self,
        particle: Point2,
        edge: &Edge,
        [mut from, mut to]: [f64; 2],
        guess: f64,
        leaves: bool,
    ) -> f64 {
        let inward = -outward(edge);
        let mut t = guess;
        for _ in 0..MAX_BRACKETED {
            let point = self.in_tool(particle, t);
            let off = inward.dot(&(point - edge.start));
            if off.abs() < STRAIGHT {
                break;
            }
            *(if (off > 0.0) == leaves {
                &mut from
            } else {
                &mut to
            }) = t;
            let rate = -inward.dot(&self.velocity(point, t));
            let next = t - off / rate;
            t = if from < next && next < to {
                next
            } else {
                from + (to - from) / 2.0
            };
        }
        t
    }

    /// Returns the path along which the tool carries a particle; `None` if it never touches the particle.
    pub(super) fn ride(&self, particle: Point2) -> Option<Way> {
        let mut t = 0.0;
        let at_start = self.in_tool(particle, 0.0);
        let mut touch = (self.lift_onto_boundary(at_start)).or_else(|| self.keep_touch(at_start));
        if touch.is_none() {
            let (entry, new) = self.entry(particle, 0.0, 1.0)?;
            (t, touch) = (entry, Some(new));
        }
        let mut way = Way::from(particle);
        for _ in 0..MAX_EVENTS {
            if touch.is_none() {
                let Some((entry, new)) = self.entry(way.end(), t, 1.0) else {
                    break;
                };
                t = entry;
                touch = Some(new);
            }
            let Some(held) = touch.take() else { break };
            let release = self.release(held, t).min(1.0);
            self.follow(&mut way, t, release, held.edge, |_| held.point_in_tool);
            t = release;
            if self.is_at_turning_point(held, release) {
                t = self.slides_until(held.edge, release);
                self.follow(&mut way, release, t, held.edge, |t| {
                    self.turning_point(held.edge, t)
                });
            }
            if t >= 1.0 {
                break;
            }
        }
        (way.len > 1).then_some(way)
    }

    /// Appends the path of a particle that stays at a point of an edge between two times.
    fn follow(
        &self,
        way: &mut Way,
        from: f64,
        to: f64,
        edge: &Edge,
        point_in_tool: impl Fn(f64) -> Point2,
    ) {
        let samples = (self.turn.abs() * (to - from) / SAMPLED_TURN) as usize + 1;
        let gap = outward(edge) * CLEARANCE;
        for i in 0..=samples {
            let t = from + (to - from) * (i as f64 / samples as f64);
            way.push(self.in_surface(point_in_tool(t) + gap, t));
        }
    }

    /// Returns the point of an edge's line that has no velocity across the edge, in the tool frame.
    fn turning_point(&self, edge: &Edge, t: f64) -> Point2 {
        let normal = outward(edge);
        let along = Vector2::new(-normal.y, normal.x);
        let lever = Vector2::new(-edge.start.y, edge.start.x);
        let s = normal.dot(&self.travel_in_tool(t)) / self.turn + normal.dot(&lever);
        edge.start + along * s
    }

    fn is_at_turning_point(&self, touch: Touch, t: f64) -> bool {
        let turning_point = self.turning_point(touch.edge, t);
        (turning_point - touch.point_in_tool).norm() < AT_TURNING_POINT
    }

    /// Whether a particle at the turning point slides: the boundary would recede if it rode, and come over it if it
    /// stayed.
    fn slides(&self, edge: &Edge, t: f64) -> bool {
        let point = self.turning_point(edge, t);
        let normal = outward(edge);
        let along = Vector2::new(-normal.y, normal.x);
        let s = (point - edge.start).dot(&along);
        let travel = self.travel_in_tool(t);
        let advance_if_riding = -self.turn * normal.dot(&Vector2::new(-travel.y, travel.x));
        let advance_if_resting =
            advance_if_riding + self.turn * along.dot(&self.velocity(point, t));
        (0.0..=(edge.end - edge.start).norm()).contains(&s)
            && advance_if_riding < 0.0
            && advance_if_resting > 0.0
    }

    /// Returns the time until which a particle released at `from` slides along the edge; `from` if it does not slide.
    fn slides_until(&self, edge: &Edge, from: f64) -> f64 {
        let (mut sliding, mut over) = (from, from);
        while self.slides(edge, over) {
            sliding = over;
            if over >= 1.0 {
                return 1.0;
            }
            over = (over + SLIDING_TURN / self.turn.abs()).min(1.0);
        }
        if over > from {
            while over - sliding > SHORTEST {
                let middle = (sliding + over) / 2.0;
                if self.slides(edge, middle) {
                    sliding = middle;
                } else {
                    over = middle;
                }
            }
        }
        sliding
    }

    /// Sine and cosine of the yaw at time t.
    fn heading(&self, t: f64) -> (f64, f64) {
        if t == 0.0 {
            self.ends[0]
        } else if t == 1.0 {
            self.ends[1]
        } else {
            (self.motion.from.heading + self.turn * t).sin_cos()
        }
    }

    /// Whether a chord lies outside the footprint's bounds by more than `distance` on one side.
    fn passes(&self, chord: &Edge, distance: f64) -> bool {
        let (low, high) = (chord.start.inf(&chord.end), chord.start.sup(&chord.end));
        let Bounds2 { min, max } = self.bounds;
        low.x - max.x > distance
            || low.y - max.y > distance
            || min.x - high.x > distance
            || min.y - high.y > distance
    }

    /// Returns the position of a resting particle at time t in the tool frame.
    fn in_tool(&self, particle: Point2, t: f64) -> Point2 {
        let (sin, cos) = self.heading(t);
        let d = particle - (self.motion.from.position + self.travel * t);
        Point2::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x)
    }

    fn in_surface(&self, point_in_tool: Point2, t: f64) -> Point2 {
        let (sin, cos) = self.heading(t);
        let p = point_in_tool;
        self.motion.from.position
            + self.travel * t
            + Vector2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)
    }

    /// Translation since the beginning, in tool coordinates [m].
    fn travel_in_tool(&self, t: f64) -> Vector2 {
        let (sin, cos) = self.heading(t);
        let v = self.travel;
        Vector2::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x)
    }

    /// Velocity of a point fixed to the tool, in tool coordinates [m per motion].
    fn velocity(&self, point_in_tool: Point2, t: f64) -> Vector2 {
        self.travel_in_tool(t) + Vector2::new(-point_in_tool.y, point_in_tool.x) * self.turn
    }

    fn covers(&self, point_in_tool: Point2) -> bool {
        let point = Edge {
            start: point_in_tool,
            end: point_in_tool,
        };
        !self.passes(&point, 0.0) && encloses(self.edges.iter().copied(), point_in_tool)
    }

    /// Moves a particle under the footprint at touchdown to the boundary, along the direction in which the motion
    /// carries it.
    fn lift_onto_boundary(&self, point_in_tool: Point2) -> Option<Touch<'a>> {
        if !self.covers(point_in_tool) {
            return None;
        }
        let along = self.velocity(point_in_tool, 0.0);
        self.edges
            .iter()
            .filter_map(|edge| {
                let boundary = edge.end - edge.start;
                let turned = along.perp(&boundary);
                let offset = edge.start - point_in_tool;
                let s = offset.perp(&boundary) / turned;
                let share = offset.perp(&along) / turned;
                (s >= 0.0 && s.is_finite() && (0.0..=1.0).contains(&share)).then_some((s, edge))
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(s, edge)| Touch {
                point_in_tool: point_in_tool + along * s,
                edge,
            })
    }

    /// Returns the touch with which the boundary resumes carrying a particle that an earlier motion
    /// left at it. Without it, the particle would rest until the boundary has passed the clearance;
    /// the slower the boundary, the longer that takes.
    fn keep_touch(&self, point_in_tool: Point2) -> Option<Touch<'a>> {
        let point = Edge {
            start: point_in_tool,
            end: point_in_tool,
        };
        if self.passes(&point, LEFT_BEHIND) {
            return None;
        }
        self.edges.iter().find_map(|edge| {
            let along = edge.end - edge.start;
            let from_start = point_in_tool - edge.start;
            let share = from_start.dot(&along) / along.norm_squared();
            let normal = outward(edge);
            let gap = from_start.dot(&normal);
            if !(0.0..=1.0).contains(&share) || !(0.0..=LEFT_BEHIND).contains(&gap) {
                return None;
            }
            let touch = Touch {
                point_in_tool: point_in_tool - normal * gap,
                edge,
            };
            let advances = self.velocity(touch.point_in_tool, 0.0).dot(&normal) > 0.0;
            let slides = self.is_at_turning_point(touch, 0.0) && self.slides(edge, 0.0);
            (advances || slides).then_some(touch)
        })
    }

    /// Returns the first time in [from, to] at which a resting particle comes under the footprint.
    fn entry(&self, particle: Point2, from: f64, to: f64) -> Option<(f64, Touch<'a>)> {
        let (a, b) = (self.in_tool(particle, from), self.in_tool(particle, to));
        let span = to - from;
        let chord = Edge { start: a, end: b };
        let radius = self.radius(&chord, span);
        let deviation = self.deviation(&chord, span);
        if self.passes(&chord, deviation) {
            return None;
        }
        let curve = self.curve(a, from, span, radius);
        let is_open =
            |edge: &Edge| curve.may_enter(edge) && segment_distance(&chord, edge) <= deviation;
        let mut open = self.edges.iter().filter(|edge| is_open(edge));
        let first = open.next()?;
        if open.next().is_none() && curve.rises_over(first) {
            return self.only_entry(particle, first, &curve, from, span);
        }
        if deviation < STRAIGHT || span < SHORTEST {
            return self
                .edges
                .iter()
                .filter_map(|edge| entry_share(&chord, edge).map(|share| (share, edge)))
                .min_by(|p, q| p.0.total_cmp(&q.0))
                .map(|(share, edge)| {
                    let touch = Touch {
                        point_in_tool: a + (b - a) * share,
                        edge,
                    };
                    (from + span * share, touch)
                });
        }
        let middle = from + span / 2.0;
        self.entry(particle, from, middle)
            .or_else(|| self.entry(particle, middle, to))
    }

    /// Returns when a resting particle enters over the only edge whose line it crosses, at most once, in the span.
    fn only_entry(
        &self,
        particle: Point2,
        edge: &'a Edge,
        curve: &Curve,
        from: f64,
        span: f64,
    ) -> Option<(f64, Touch<'a>)> {
        let along = edge.end - edge.start;
        let depth = |point: Point2| along.perp(&(point - edge.start));
        let last = from + span;
        if depth(curve.start) > 0.0 || depth(self.in_tool(particle, last)) <= 0.0 {
            return None;
        }
        let mut t = from + span * curve.crossing(edge).clamp(0.0, 1.0);
        let mut point_in_tool = self.in_tool(particle, t);
        for _ in 0..MAX_REFINEMENTS {
            let off = depth(point_in_tool);
            if off.abs() < STRAIGHT * along.norm() {
                break;
            }
            let rate = -along.perp(&self.velocity(point_in_tool, t));
            t = (t - off / rate).clamp(from, last);
            point_in_tool = self.in_tool(particle, t);
        }
        let share = (point_in_tool - edge.start).dot(&along) / along.norm_squared();
        let touch = Touch {
            point_in_tool,
            edge,
        };
        (0.0..=1.0).contains(&share).then_some((t, touch))
    }

    /// Largest distance of a resting particle from the tool centre point in a span of time, at whose ends it is at those
    /// of the chord [m].
    fn radius(&self, chord: &Edge, span: f64) -> f64 {
        let ends = chord.start.coords.norm().max(chord.end.coords.norm());
        ends + self.travel.norm() * span
    }

    /// Bound on the distance of a resting particle's curve from its chord over a span of time, in the tool frame [m].
    fn deviation(&self, chord: &Edge, span: f64) -> f64 {
        // Second derivative of the curve: Coriolis and centripetal terms.
        let radius = self.radius(chord, span);
        let bend = self.turn.abs() * (2.0 * self.travel.norm() + self.turn.abs() * radius);
        bend * span * span / 8.0
    }

    /// Returns the path of a resting particle in the tool frame over a span of time; `radius` is its largest distance
    /// from the tool centre point in that span [m].
    fn curve(&self, start: Point2, from: f64, span: f64, radius: f64) -> Curve {
        let turn = self.turn;
        let travel = self.travel_in_tool(from);
        let acceleration =
            Vector2::new(-travel.y, travel.x) * (2.0 * turn) - start.coords * (turn * turn);
        let jerk = turn * turn * (3.0 * self.travel.norm() + turn.abs() * radius);
        Curve {
            start,
            velocity: -self.velocity(start, from) * span,
            acceleration: acceleration * (span * span),
            error: jerk * span * span * span / 6.0,
        }
    }

    /// Returns when the boundary at a touched point stops advancing or slides along the particle; infinite if it never
    /// does.
    ///
    /// Its normal velocity is |v| cos ψ(t) + c with ψ linear in t, so its zeros have a closed form.
    fn release(&self, touch: Touch, from: f64) -> f64 {
        let outward = outward(touch.edge);
        let slides = self.is_at_turning_point(touch, from) && self.slides(touch.edge, from);
        if slides || self.velocity(touch.point_in_tool, from).dot(&outward) <= 0.0 {
            return from;
        }
        let speed = self.travel.norm();
        let lever = Vector2::new(-touch.point_in_tool.y, touch.point_in_tool.x);
        let constant = self.turn * lever.dot(&outward);
        if constant.abs() >= speed {
            return f64::INFINITY;
        }
        let crossing = (-constant / speed).acos();
        let angle_at_zero = self.travel.y.atan2(self.travel.x)
            - self.motion.from.heading
            - outward.y.atan2(outward.x);
        let period = std::f64::consts::TAU / self.turn.abs();
        [crossing, -crossing]
            .map(|angle| {
                let t = (angle_at_zero - angle) / self.turn;
                t + ((from - t) / period).ceil() * period
            })
            .into_iter()
            .fold(f64::INFINITY, f64::min)
    }
}

/// A curve as start + velocity u + acceleration u²/2 with u in [0, 1], and a bound on its error [m].
struct Curve {
    start: Point2,
    velocity: Vector2,
    acceleration: Vector2,
    error: f64,
}

impl Curve {
    /// Whether the curve may pass from the outer side of an edge's line to the inner one.
    fn may_enter(&self, edge: &Edge) -> bool {
        let along = edge.end - edge.start;
        // Distance inside the line times the edge's length, as a quadratic in u.
        let at_start = along.perp(&(self.start - edge.start));
        let rate = along.perp(&self.velocity);
        let bend = along.perp(&self.acceleration);
        let at_end = at_start + rate + bend / 2.0;
        let (mut low, mut high) = (at_start.min(at_end), at_start.max(at_end));
        let turning_point = -rate / bend;
        if (0.0..=1.0).contains(&turning_point) {
            let there = at_start + rate * turning_point / 2.0;
            (low, high) = (low.min(there), high.max(there));
        }
        let error = self.error * along.abs().sum();
        low - error <= 0.0 && high + error > 0.0
    }

    /// Whether the curve moves inwards across an edge's line all the time.
    fn rises_over(&self, edge: &Edge) -> bool {
        let along = edge.end - edge.start;
        let at_start = along.perp(&self.velocity);
        let at_end = at_start + along.perp(&self.acceleration);
        at_start.min(at_end) > 3.0 * self.error * along.abs().sum()
    }

    /// Estimates when the curve crosses the line of an edge inwards.
    fn crossing(&self, edge: &Edge) -> f64 {
        let along = edge.end - edge.start;
        let missing = -along.perp(&(self.start - edge.start));
        let rate = along.perp(&self.velocity);
        let bend = along.perp(&self.acceleration);
        // Root of bend u²/2 + rate u − missing = 0, in the form that does not cancel.
        let root = (rate * rate + 2.0 * bend * missing).max(0.0).sqrt();
        2.0 * missing / (rate + root)
    }
}

/// Length of a path with velocity begin + change · t between two times: the arc length of a parabola.
fn arc_length(begin: Vector2, change: Vector2, from: f64, to: f64) -> f64 {
    let rate = change.norm();
    if rate * (to - from) < STRAIGHT {
        return (begin + change * ((from + to) / 2.0)).norm() * (to - from);
    }
    // The speed is least at `least_at`; relative to it, speed² = least² + (rate (t − least_at))².
    let least_at = -begin.dot(&change) / (rate * rate);
    let least = (begin + change * least_at).norm();
    let primitive = |t: f64| {
        let u = rate * (t - least_at);
        let speed = u.hypot(least);
        let slow = if least > 0.0 {
            least * least * (u / least).asinh()
        } else {
            0.0
        };
        (u * speed + slow) / (2.0 * rate)
    };
    primitive(to) - primitive(from)
}

/// Returns how far the ends of a chord lie inside the line of a boundary edge [m]; `None` if the chord is farther from the
/// edge than `distance`.
fn depths_near(edge: &Edge, chord: &Edge, distance: f64) -> Option<[f64; 2]> {
    let outward = outward(edge);
    let along = Vector2::new(-outward.y, outward.x);
    let offsets = [chord.start - edge.start, chord.end - edge.start];
    let is_apart = |[a, b]: [f64; 2], low: f64, high: f64| {
        (a < low - distance && b < low - distance) || (a > high + distance && b > high + distance)
    };
    let depths = offsets.map(|offset| -outward.dot(&offset));
    let places = offsets.map(|offset| along.dot(&offset));
    let length = along.dot(&(edge.end - edge.start));
    let is_near = length > 0.0 && !is_apart(depths, 0.0, 0.0) && !is_apart(places, 0.0, length);
    is_near.then_some(depths)
}

/// Unit normal of a boundary edge that points out of the footprint.
fn outward(edge: &Edge) -> Vector2 {
    let along = (edge.end - edge.start).normalize();
    Vector2::new(along.y, -along.x)
}

/// Share of a short chord (0..1) at which it crosses the edge inwards.
fn entry_share(chord: &Edge, edge: &Edge) -> Option<f64> {
    let along = edge.end - edge.start;
    let before = along.perp(&(chord.start - edge.start));
    let after = along.perp(&(chord.end - edge.start));
    if before > 0.0 || after <= 0.0 {
        return None;
    }
    let share = before / (before - after);
    let at = chord.start + (chord.end - chord.start) * share;
    let t = (at - edge.start).dot(&along) / along.norm_squared();
    (0.0..=1.0).contains(&t).then_some(share)
}

/// Distance between two segments [m]; 0 if they cross.
fn segment_distance(a: &Edge, b: &Edge) -> f64 {
    let side = |edge: &Edge, p: Point2| (edge.end - edge.start).perp(&(p - edge.start));
    let crossing =
        side(a, b.start) * side(a, b.end) < 0.0 && side(b, a.start) * side(b, a.end) < 0.0;
    if crossing {
        return 0.0;
    }
    a.distance(b.start)
        .min(a.distance(b.end))
        .min(b.distance(a.start))
        .min(b.distance(a.end))
}
