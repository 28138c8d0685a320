//! Markers of a bag: surface and scene, goal, strokes, tool and force.

use super::topic::{FRAME_SURFACE, FRAME_TOOL, FRAME_WORLD};
use crate::ros2::messages::{Color, Marker, MarkerKind, Time, Vector3};
use std::f64::consts::TAU;
use wisch::geometry::{Mesh, Point2, Point3, Polygon, Pose};
use wisch::plan::Stroke;
use wisch::represent::{GoalState, SceneObject, ScenePart, Surface, SurfaceShape};
use wisch::run::TelemetrySample;

/// Heights above the surface of its face and of the drawings on it, which keep any two from sharing a plane [m].
const FACE_HEIGHT: f64 = 0.0005;
const LINE_HEIGHT: f64 = 0.001;
const STROKE_HEIGHT: f64 = 0.002;
/// Width of lines [m].
const LINE_WIDTH: f64 = 0.003;
/// Largest turn of the normal along a line that is drawn straight [rad].
const LARGEST_TURN: f64 = 0.05;
/// Number of corners of a drawn circle.
const CIRCLE_CORNERS: u32 = 48;
/// Length of the arrow of a force [m/N].
const FORCE_SCALE: f64 = 0.01;
/// Least force that is drawn [N]: the arrow of a smaller force would be shorter than its head.
const LEAST_FORCE: f64 = 1.0;
/// Diameters of an arrow's shaft and head [m].
const ARROW: [f64; 2] = [0.006, 0.014];

const FACE: Color = color(0.93, 0.91, 0.85, 1.0);
const OUTLINE: Color = color(0.25, 0.25, 0.25, 1.0);
const CARRIER: Color = color(0.76, 0.62, 0.44, 1.0);
const OBSTACLE: Color = color(0.62, 0.64, 0.67, 1.0);
const GOAL: Color = color(0.10, 0.60, 0.25, 1.0);
const FIRST_STROKE: Color = color(0.10, 0.35, 0.80, 1.0);
const LAST_STROKE: Color = color(0.65, 0.80, 1.0, 1.0);
const TOOL: Color = color(0.95, 0.75, 0.20, 1.0);
const FORCE: Color = color(0.85, 0.15, 0.15, 1.0);

const fn color(r: f32, g: f32, b: f32, a: f32) -> Color {
    Color { r, g, b, a }
}

/// The scene that a bag shows to viewers.
#[derive(Debug, Clone, Copy)]
pub struct BagScene<'a> {
    /// The target surface.
    pub surface: &'a Surface,
    /// Objects around the surface; robot and tool are shown separately.
    pub objects: &'a [SceneObject],
    /// The tool's surface in its own frame \[m\].
    pub tool: &'a Mesh,
    /// Goal of the task; a goal area for collected dirt is drawn.
    pub goal: &'a GoalState,
}

/// A marker with the points that draw it.
#[derive(Debug, Clone)]
pub(super) struct Drawn {
    frame: &'static str,
    /// What it shows; namespace and `id` together identify the marker.
    ns: String,
    id: i32,
    kind: MarkerKind,
    pose: Pose,
    scale: [f64; 3],
    color: Color,
    points: Vec<Vector3>,
}

impl Drawn {
    fn new(frame: &'static str, ns: &str, kind: MarkerKind, color: Color) -> Self {
        let scale = match kind {
            MarkerKind::Arrow => [ARROW[0], ARROW[1], 0.0],
            MarkerKind::LineStrip => [LINE_WIDTH, 0.0, 0.0],
            MarkerKind::Points => [LINE_WIDTH, LINE_WIDTH, 0.0],
            MarkerKind::TriangleList => [1.0; 3],
        };
        Self {
            frame,
            ns: ns.to_owned(),
            id: 0,
            kind,
            pose: Pose::identity(),
            scale,
            color,
            points: Vec::new(),
        }
    }

    fn through(mut self, points: impl IntoIterator<Item = Point3>) -> Self {
        self.points.extend(points.into_iter().map(at));
        self
    }

    /// Returns the message: a permanent marker that moves with its frame.
    pub fn marker(&self, time: u64) -> Marker<'_> {
        let [x, y, z] = self.scale;
        Marker {
            pose: (&self.pose).into(),
            frame_locked: true,
            ..Marker::new(
                (Time::from_nanoseconds(time), self.frame),
                (&self.ns, self.id),
                self.kind,
                (Vector3 { x, y, z }, self.color),
                &self.points,
            )
        }
    }
}

fn at(point: Point3) -> Vector3 {
    point.coords.into()
}

fn lift(shape: &SurfaceShape, place: Point2, height: f64) -> Point3 {
    shape.place(place, height).translation.vector.into()
}

/// Lifts a line of the chart to a height over the surface [m]; on a curved surface in short steps.
fn lift_line(shape: &SurfaceShape, corners: &[Point2], height: f64) -> Vec<Point3> {
    let mut points = Vec::with_capacity(corners.len());
    for pair in corners.windows(2) {
        let &[from, to] = pair else { continue };
        let steps = (shape.turn_between(from, to) / LARGEST_TURN)
            .ceil()
            .max(1.0) as usize;
        let on_line = (0..steps).map(|i| from + (to - from) * (i as f64 / steps as f64));
        points.extend(on_line.map(|place| lift(shape, place, height)));
    }
    points.extend(corners.last().map(|&place| lift(shape, place, height)));
    points
}

/// Lifts a triangle of the chart onto the surface; on a curved surface in strips along the axis, or from the apex.
fn lift_triangle(shape: &SurfaceShape, corners: [Point2; 3], lifted: &mut Vec<Point3>) {
    let past = |place: Point2, strip: f64| match shape {
        SurfaceShape::Cone(cone) => cone.past_roll(place, strip * LARGEST_TURN),
        _ => shape.roll(place) / LARGEST_TURN - strip,
    };
    let rolls = corners.map(|place| shape.roll(place) / LARGEST_TURN);
    let low = rolls.iter().copied().fold(f64::INFINITY, f64::min).floor();
    let high = rolls.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut strip = low;
    while strip < high.max(low + 0.5) {
        let from = keep_inside(&corners, |place| past(place, strip));
        let part = keep_inside(&from, |place| -past(place, strip + 1.0));
        if let [first, rest @ ..] = part.as_slice() {
            let fan = rest.windows(2).flat_map(|pair| [*first, pair[0], pair[1]]);
            lifted.extend(fan.map(|place| lift(shape, place, FACE_HEIGHT)));
        }
        strip += 1.0;
    }
}

/// Returns the part of a convex polygon where a linear function is at least 0.
fn keep_inside(polygon: &[Point2], inside: impl Fn(Point2) -> f64) -> Vec<Point2> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    let next = polygon.iter().cycle().skip(1);
    for (corner, next) in polygon.iter().zip(next) {
        let (here, there) = (inside(*corner), inside(*next));
        if here >= 0.0 {
            kept.push(*corner);
        }
        if (here >= 0.0) != (there >= 0.0) {
            kept.push(corner + (next - corner) * (here / (here - there)));
        }
    }
    kept
}

/// Draws the surface, the objects around it, and the goal area.
pub(super) fn scene(shown: &BagScene<'_>) -> Vec<Drawn> {
    let Surface { outline, shape, .. } = shown.surface;
    let mut all = vec![surface_face(outline, shape)];
    all.extend((0..).zip(outline.rings()).map(|(id, ring)| {
        let corners: Vec<Point2> = ring.iter().chain(ring.first()).copied().collect();
        let line = lift_line(shape, &corners, LINE_HEIGHT);
        Drawn {
            id,
            ..on_surface("outline", OUTLINE).through(line)
        }
    }));
    if let GoalState::Collected { center, radius } = shown.goal {
        let corner = |i: u32| {
            let (y, x) = (TAU * f64::from(i) / f64::from(CIRCLE_CORNERS)).sin_cos();
            Point2::new(center.x + radius * x, center.y + radius * y)
        };
        let circle: Vec<Point2> = (0..=CIRCLE_CORNERS).map(corner).collect();
        let line = lift_line(shape, &circle, LINE_HEIGHT);
        all.push(on_surface("goal", GOAL).through(line));
    }
    all.extend(shown.objects.iter().filter_map(|object| {
        let color = match object.part {
            ScenePart::Carrier => CARRIER,
            ScenePart::Obstacle => OBSTACLE,
            ScenePart::Robot | ScenePart::Tool => return None,
        };
        Some(Drawn {
            pose: object.world_from_object,
            ..solid(FRAME_WORLD, &object.name, color, &object.mesh)
        })
    }));
    all
}

/// Draws the strokes on a surface of this shape in their order, the first in the darkest colour.
pub(super) fn strokes(strokes: &[Stroke], shape: &SurfaceShape) -> Vec<Drawn> {
    let last = (strokes.len().max(2) - 1) as f32;
    let stroke = |(id, stroke): (i32, &Stroke)| {
        let share = id as f32 / last;
        let mixed = |from: f32, to: f32| from + share * (to - from);
        let [from, to] = [FIRST_STROKE, LAST_STROKE];
        let color = color(
            mixed(from.r, to.r),
            mixed(from.g, to.g),
            mixed(from.b, to.b),
            1.0,
        );
        let corners: Vec<Point2> = stroke.poses.iter().map(|pose| pose.position).collect();
        let line = on_surface("strokes", color).through(lift_line(shape, &corners, STROKE_HEIGHT));
        // A contact without motion is a point.
        let kind = if line.points.len() < 2 {
            MarkerKind::Points
        } else {
            line.kind
        };
        Drawn {
            id,
            kind,
            scale: [LINE_WIDTH; 3],
            ..line
        }
    };
    (0..).zip(strokes).map(stroke).collect()
}

pub(super) fn tool(mesh: &Mesh) -> Drawn {
    solid(FRAME_TOOL, "tool", TOOL, mesh)
}

/// Draws the force on the tool as an arrow from its tool centre point; `None` if the force is too small.
pub(super) fn force(sample: &TelemetrySample<'_>) -> Option<Drawn> {
    let force = sample.external.force;
    if force.norm() < LEAST_FORCE {
        return None;
    }
    let from = Point3::from(sample.world_from_tool.translation.vector);
    Some(no_force().through([from, from + FORCE_SCALE * force]))
}

/// Returns the marker that deletes the arrow.
pub(super) fn no_force() -> Drawn {
    Drawn::new(FRAME_WORLD, "force", MarkerKind::Arrow, FORCE)
}

fn on_surface(ns: &str, color: Color) -> Drawn {
    Drawn::new(FRAME_SURFACE, ns, MarkerKind::LineStrip, color)
}

fn solid(frame: &'static str, ns: &str, color: Color, mesh: &Mesh) -> Drawn {
    let corners = mesh.corners().flatten();
    Drawn::new(frame, ns, MarkerKind::TriangleList, color).through(corners)
}

fn surface_face(outline: &Polygon, shape: &SurfaceShape) -> Drawn {
    let face = Drawn::new(FRAME_SURFACE, "surface", MarkerKind::TriangleList, FACE);
    let mut corners = Vec::new();
    if let SurfaceShape::Mesh(mesh) = shape {
        let vertices: Vec<_> = mesh.sheet().vertices().collect();
        let raised =
            |i: u32| vertices[i as usize].point + vertices[i as usize].normal * FACE_HEIGHT;
        let triangles = mesh.sheet().triangles();
        let corners: Vec<Point3> = triangles
            .flat_map(|(corners, _)| corners.map(raised))
            .collect();
        return face.through(corners);
    }
    for triangle in triangles(outline) {
        lift_triangle(shape, triangle, &mut corners);
    }
    face.through(corners)
}

/// Triangulates a polygon with holes, counter-clockwise: cuts it at the height of every corner into trapezoids.
fn triangles(polygon: &Polygon) -> Vec<[Point2; 3]> {
    let mut heights: Vec<f64> = polygon.rings().flatten().map(|p| p.y).collect();
    heights.sort_unstable_by(f64::total_cmp);
    heights.dedup();
    let mut triangles = Vec::new();
    for slab in heights.windows(2) {
        let (low, high) = (slab[0], slab[1]);
        // Edges that cross the slab, sorted by their positions at its lower and upper end.
        let mut crossings: Vec<[f64; 2]> = (polygon.edges())
            .filter(|edge| {
                let (a, b) = (edge.start.y.min(edge.end.y), edge.start.y.max(edge.end.y));
                a <= low && b >= high
            })
            .map(|edge| {
                let x = |y: f64| {
                    let share = (y - edge.start.y) / (edge.end.y - edge.start.y);
                    edge.start.x + share * (edge.end.x - edge.start.x)
                };
                [x(low), x(high)]
            })
            .collect();
        crossings.sort_unstable_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
        for pair in crossings.chunks_exact(2) {
            let ([left_low, left_high], [right_low, right_high]) = (pair[0], pair[1]);
            let corners = [
                Point2::new(left_low, low),
                Point2::new(right_low, low),
                Point2::new(right_high, high),
                Point2::new(left_high, high),
            ];
            triangles.push([corners[0], corners[1], corners[2]]);
            triangles.push([corners[0], corners[2], corners[3]]);
        }
    }
    let is_flat = |t: &[Point2; 3]| double_area(t) <= 0.0;
    triangles.retain(|triangle| !is_flat(triangle));
    triangles
}

fn double_area([a, b, c]: &[Point2; 3]) -> f64 {
    (b - a).perp(&(c - a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Vector2;

    fn points(corners: &[[f64; 2]]) -> Vec<Point2> {
        corners.iter().map(|&[x, y]| Point2::new(x, y)).collect()
    }

    #[test]
    fn face_and_lines_of_a_cylinder_lie_on_it() {
        let (radius, axis) = (0.3, std::f64::consts::FRAC_PI_2);
        let shape = SurfaceShape::Cylinder { radius, axis };
        let from_axis = |p: &Vector3| p.x.hypot(p.z + radius);
        let outline = Polygon::rectangle(Vector2::new(1.2, 0.4));
        let face = surface_face(&outline, &shape);
        // 80 strips of two triangles each, twice along the diagonal.
        assert!((480..2000).contains(&face.points.len()));
        for p in &face.points {
            assert!((from_axis(p) - radius - FACE_HEIGHT).abs() < 1e-9, "{p:?}");
        }
        let stroke = lift_line(&shape, &points(&[[-0.6, 0.0], [0.6, 0.1]]), STROKE_HEIGHT);
        // 4 rad in steps of 0.05.
        assert_eq!(stroke.len(), 81);
        let flat = lift_line(
            &SurfaceShape::Plane,
            &points(&[[-0.6, 0.0], [0.6, 0.1]]),
            STROKE_HEIGHT,
        );
        assert_eq!(flat.len(), 2);
    }

    #[test]
    fn a_face_has_the_area_of_its_outline_without_holes() {
        let hole = points(&[[0.2, 0.2], [0.4, 0.25], [0.3, 0.5]]);
        let notched = [
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.6, 0.5],
            [0.4, 1.2],
            [0.0, 0.7],
        ];
        let polygons = [
            Polygon::rectangle(Vector2::new(0.4, 0.28)),
            Polygon::new(points(&notched), vec![hole]),
        ];
        for polygon in polygons {
            let triangles = triangles(&polygon);
            let area: f64 = triangles.iter().map(|t| double_area(t) / 2.0).sum();
            assert!((area - polygon.area()).abs() < 1e-12, "{area}");
            for [a, b, c] in triangles {
                let center = Point2::from((a.coords + b.coords + c.coords) / 3.0);
                assert!(polygon.contains(center), "{center}");
            }
        }
    }
}
