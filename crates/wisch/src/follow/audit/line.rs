//! Deviation of the tool from its line, and of the second hand from its grip, at the positions of a robot.

use super::kinematics::{Frame, root_from_link};
use crate::follow::{GripDeviation, LineDeviation, ToolPose, Workcell};
use crate::geometry::{Edge, Point2, Vector3};
use crate::represent::{Cone, SurfaceShape, Task};

/// Largest rotation of a segment; corners farther apart are joined by several [rad].
const MAX_TURN: f64 = 0.5;
/// Largest distance of a segment from the arc that it replaces [m].
const MAX_SAGITTA: f64 = 5e-5;
/// Least radius of curvature of a cone for which segments are made [m]: beyond the outline, it may be less.
const LEAST_RADIUS: f64 = 0.01;
/// Length of the segments of a line over a mesh [m].
const CHORD_ON_MESH: f64 = 5e-3;
/// Weight of a rotation against a translation where the tool is compared with its line [m/rad].
const METRES_PER_RADIAN: f64 = 0.1;
/// Places of the line are no longer considered if they deviate by this much more than the best one [m].
const HOPELESS: f64 = 0.02;

/// Returns the tool's frame in the world.
pub(super) fn world_from_tool(cell: &Workcell, q: &[f64]) -> Frame {
    let root_from_tip = root_from_link(cell.robot(), cell.tip(), q);
    let root_from_tool = root_from_tip.then(&Frame::from_pose(cell.tip_from_tool()));
    Frame::from_pose(cell.world_from_root()).then(&root_from_tool)
}

/// A segment of a line: the tool moves straight from one point to another and turns on the way.
struct Segment {
    /// The tool at the start, relative to the surface: x, y, height [m], heading, tilt [rad].
    from: [f64; 5],
    /// Change of these over the segment.
    change: [f64; 5],
    world_from_begin: Frame,
    world_from_end: Frame,
    /// Vector of the straight path in the world [m].
    way: Vector3,
    /// Rotation vector from the start to the end [rad], in the tool's frame at the start.
    turn: Vector3,
}

/// The line of a tool.
pub(super) struct Line<'a> {
    task: &'a Task,
    segments: Vec<Segment>,
}

/// A place of the line at which the tool may be, and its largest deviation on the way there.
#[derive(Debug, Clone, Copy)]
struct Reached {
    segment: usize,
    /// Share of the segment.
    share: f64,
    worst: LineDeviation,
}

/// Returns the number of chords that stay within [`MAX_SAGITTA`] of the arc between two places: on
/// a curved surface, a straight line of the chart is an arc.
fn arcs(task: &Task, from: &[f64; 5], to: &[f64; 5]) -> f64 {
    let (radius, axis) = match &task.surface.shape {
        SurfaceShape::Plane => return 0.0,
        &SurfaceShape::Cylinder { radius, axis } => (radius, axis),
        SurfaceShape::Cone(cone) => return arcs_on_cone(cone, from, to),
        SurfaceShape::Mesh(_) => return (to[0] - from[0]).hypot(to[1] - from[1]) / CHORD_ON_MESH,
    };
    let across = (to[1] - from[1]) * axis.cos() - (to[0] - from[0]) * axis.sin();
    // A chord of length l has the sagitta l²/8R.
    let longest = (8.0 * radius.abs() * MAX_SAGITTA).sqrt();
    across.abs() / longest.min(MAX_TURN * radius.abs())
}

/// Returns the number of chords on a cone, by the tightest bend along the way.
fn arcs_on_cone(cone: &Cone, from: &[f64; 5], to: &[f64; 5]) -> f64 {
    let way = Edge {
        start: Point2::new(from[0], from[1]),
        end: Point2::new(to[0], to[1]),
    };
    let apex = Point2::from(apex_of(cone).xy());
    let radius = (way.distance(apex) * cone.half_angle.tan()).max(LEAST_RADIUS);
    let longest = (8.0 * radius * MAX_SAGITTA).sqrt();
    (way.end - way.start).norm() / longest.min(MAX_TURN * radius)
}

fn coordinates(pose: &ToolPose) -> [f64; 5] {
    let at = pose.surface_from_tool;
    [
        at.position.x,
        at.position.y,
        pose.height,
        at.heading,
        pose.tilt,
    ]
}

/// Returns the tool's frame in the world for coordinates relative to the surface.
fn placed(task: &Task, [x, y, height, heading, tilt]: [f64; 5]) -> Frame {
    let mut tool = Frame::rotate_about(&Vector3::z(), heading);
    match &task.surface.shape {
        SurfaceShape::Plane => tool.origin = Vector3::new(x, y, height),
        // `given_mesh.rs` checks the tool against the mesh as given.
        shape @ SurfaceShape::Mesh(_) => {
            tool = Frame::from_pose(&shape.place(Point2::new(x, y), height)).then(&tool);
        }
        &SurfaceShape::Cylinder { radius, axis } => {
            tool = roll(radius, axis, Vector3::new(x, y, height)).then(&tool);
        }
        SurfaceShape::Cone(cone) => {
            tool = roll_onto_cone(cone, Vector3::new(x, y, height)).then(&tool);
        }
    }
    if let Some(freedom) = task.tool.tilt {
        tool = tool.then(&Frame::rotate_about(&freedom.axis_in_tool, tilt));
    }
    Frame::from_pose(&task.surface.world_from_surface).then(&tool)
}

/// Returns the frame over a place of a chart that is rolled onto a cylinder. The plane is turned
/// about the axis of the cylinder, which lies one radius below the plane, and moved along that
/// axis.
fn roll(radius: f64, axis: f64, at: Vector3) -> Frame {
    let along = Vector3::new(axis.cos(), axis.sin(), 0.0);
    let across = Vector3::z().cross(&along);
    let to_axis = Frame {
        origin: -Vector3::z() * radius,
        ..Frame::identity()
    };
    let turn = Frame::rotate_about(&along, -at.dot(&across) / radius);
    let from_axis = Frame {
        origin: Vector3::z() * (radius + at.z) + along * at.dot(&along),
        ..Frame::identity()
    };
    to_axis.then(&turn).then(&from_axis)
}

/// Returns the apex of a cone, which lies in the plane of the surface's frame [m].
fn apex_of(cone: &Cone) -> Vector3 {
    let slant = cone.radius.abs() / cone.half_angle.sin();
    Vector3::new(cone.axis.cos(), cone.axis.sin(), 0.0) * -slant
}

/// Returns the frame over a place of a chart that is rolled onto a cone: about the apex, the plane is turned until the
/// line of the place is that of the origin, and then about the axis of the cone.
fn roll_onto_cone(cone: &Cone, at: Vector3) -> Frame {
    let along = Vector3::new(cone.axis.cos(), cone.axis.sin(), 0.0);
    let across = Vector3::z().cross(&along);
    let apex = apex_of(cone);
    let from_apex = at - apex;
    // Negative in a hollow, which lies on the other side of the axis.
    let sine = cone.half_angle.sin() * cone.radius.signum();
    let turn = from_apex.dot(&across).atan2(from_apex.dot(&along));
    let axis = along * cone.half_angle.cos() - Vector3::z() * sine;
    let moved = |origin: Vector3| Frame {
        origin,
        ..Frame::identity()
    };
    (moved(apex).then(&Frame::rotate_about(&axis, -turn / sine)))
        .then(&Frame::rotate_about(&Vector3::z(), -turn))
        .then(&moved(from_apex))
}

impl<'a> Line<'a> {
    /// Returns the line through these corners; `None` if there are fewer than two.
    pub fn new(task: &'a Task, corners: &[ToolPose]) -> Option<Self> {
        let mut segments = Vec::new();
        for pair in corners.windows(2) {
            let (from, to) = (coordinates(&pair[0]), coordinates(&pair[1]));
            let widest = (to[3] - from[3]).abs().max((to[4] - from[4]).abs());
            let arcs = arcs(task, &from, &to);
            let count = (widest / MAX_TURN).max(arcs).ceil().max(1.0);
            let change: [f64; 5] = std::array::from_fn(|i| (to[i] - from[i]) / count);
            for k in 0..count as usize {
                let from = std::array::from_fn(|i| from[i] + k as f64 * change[i]);
                let begin = placed(task, from);
                let end = placed(task, std::array::from_fn(|i| from[i] + change[i]));
                segments.push(Segment {
                    from,
                    change,
                    world_from_begin: begin,
                    way: end.origin - begin.origin,
                    turn: begin.rotation_to(&end),
                    world_from_end: end,
                });
            }
        }
        (!segments.is_empty()).then_some(Self { task, segments })
    }

    fn deviation_at(&self, segment: usize, share: f64, tool: &Frame) -> LineDeviation {
        let Segment { from, change, .. } = &self.segments[segment];
        let wanted = placed(
            self.task,
            std::array::from_fn(|i| from[i] + share * change[i]),
        );
        LineDeviation {
            position: (tool.origin - wanted.origin).norm(),
            rotation: wanted.rotation_to(tool).norm(),
        }
    }

    /// Returns the largest deviation of a motion of the tool that follows the line from its start to its end.
    ///
    /// This is the Fréchet distance: tool and line are both passed in their order, so that a line that returns on itself
    /// has to be followed as often, and no part of it may be left out. Of all ways to match them, that with the least
    /// deviation counts. `tools`: frames of the tool, so dense that it moves straight from one to the next.
    pub fn deviation_of(&self, tools: impl Iterator<Item = Frame>) -> LineDeviation {
        let mut reached: Vec<Reached> = Vec::new();
        let mut last: Option<Frame> = None;
        for tool in tools {
            reached = match &last {
                Some(before) => self.advance(&reached, before, &tool),
                None => {
                    let begin = Reached {
                        segment: 0,
                        share: 0.0,
                        worst: self.deviation_at(0, 0.0, &tool),
                    };
                    self.advance(&[begin], &tool, &tool)
                }
            };
            last = Some(tool);
        }
        let Some(tool) = last else {
            return LineDeviation::default();
        };
        // The rest of the line is left out where the tool ends.
        let mut rest = LineDeviation::default();
        let mut left = self.segments.len();
        let ends = reached.iter().rev().map(|place| {
            while left > place.segment {
                left -= 1;
                rest = join(rest, self.deviation_at(left, 1.0, &tool));
            }
            join(place.worst, rest)
        });
        let least = ends.min_by(|a, b| cost(a).total_cmp(&cost(b)));
        least.expect("the tool is somewhere")
    }

    /// Returns the places at which the tool may be after it has moved straight from `before` to `tool`, in the order of
    /// the line.
    fn advance(&self, reached: &[Reached], before: &Frame, tool: &Frame) -> Vec<Reached> {
        let mut next: Vec<Reached> = Vec::with_capacity(reached.len() + 2);
        let mut least = f64::INFINITY;
        // The largest deviation on the best way to the start of the segment.
        let mut passed: Option<LineDeviation> = None;
        let mut waiting = reached.iter().peekable();
        let first = reached.first().map_or(0, |place| place.segment);
        for (i, segment) in self.segments.iter().enumerate().skip(first) {
            let here = waiting.next_if(|place| place.segment == i);
            let entered = passed.map(|worst| (worst, 0.0));
            let stayed = here.map(|place| (place.worst, place.share));
            let places = entered.into_iter().chain(stayed).map(|(worst, from)| {
                let share = segment.nearest(tool).clamp(from, 1.0);
                let worst = join(worst, self.deviation_at(i, share, tool));
                Reached {
                    segment: i,
                    share,
                    worst,
                }
            });
            if let Some(place) = places.min_by(|a, b| cost(&a.worst).total_cmp(&cost(&b.worst))) {
                least = least.min(cost(&place.worst));
                next.push(place);
            }
            // The end of the segment is passed while the tool moves.
            let ends = (here.map(|place| place.worst).into_iter().chain(passed))
                .map(|worst| join(worst, segment.deviation_of_end(before, tool)));
            passed = ends.min_by(|a, b| cost(a).total_cmp(&cost(b)));
            let is_hopeless = passed.is_none_or(|worst| cost(&worst) > least + HOPELESS);
            if is_hopeless {
                passed = None;
                if waiting.peek().is_none() {
                    break;
                }
            }
        }
        next.retain(|place| cost(&place.worst) <= least + HOPELESS);
        next
    }
}

/// Returns a deviation as a length [m].
fn cost(off: &LineDeviation) -> f64 {
    off.position + METRES_PER_RADIAN * off.rotation
}

/// Returns the larger position and the larger rotation of two deviations.
fn join(a: LineDeviation, b: LineDeviation) -> LineDeviation {
    LineDeviation {
        position: a.position.max(b.position),
        rotation: a.rotation.max(b.rotation),
    }
}

impl Segment {
    /// Returns the share of the segment that is nearest to the tool, also beyond the ends of the
    /// segment. It is the share by position, or by orientation if the segment is mostly a rotation.
    fn nearest(&self, tool: &Frame) -> f64 {
        let (way, turn) = (self.way, self.turn);
        if way.norm() >= METRES_PER_RADIAN * turn.norm() && way.norm() > 0.0 {
            (tool.origin - self.world_from_begin.origin).dot(&way) / way.norm_squared()
        } else if turn.norm() > 0.0 {
            self.world_from_begin.rotation_to(tool).dot(&turn) / turn.norm_squared()
        } else {
            0.0
        }
    }

    /// Returns the least deviation from the end of the segment of a tool that moves straight from one frame to another.
    fn deviation_of_end(&self, before: &Frame, tool: &Frame) -> LineDeviation {
        let (moved, turned) = (tool.origin - before.origin, before.rotation_to(tool));
        let to_end = self.world_from_end.origin - before.origin;
        let turn_to_end = before.rotation_to(&self.world_from_end);
        let weight = METRES_PER_RADIAN * METRES_PER_RADIAN;
        let length = moved.norm_squared() + weight * turned.norm_squared();
        let share = if length > 0.0 {
            ((moved.dot(&to_end) + weight * turned.dot(&turn_to_end)) / length).clamp(0.0, 1.0)
        } else {
            0.0
        };
        LineDeviation {
            position: (to_end - moved * share).norm(),
            rotation: (turn_to_end - turned * share).norm(),
        }
    }
}

/// Deviation of the second hand from its grip; zero if one hand holds the tool.
pub(super) fn off_grip(cell: &Workcell, q: &[f64]) -> GripDeviation {
    let Some(second) = cell.second_arm() else {
        return GripDeviation::default();
    };
    let (robot, grip) = (cell.robot(), second.grip());
    let root_from_tool =
        root_from_link(robot, cell.tip(), q).then(&Frame::from_pose(cell.tip_from_tool()));
    let root_from_hand = root_from_link(robot, second.chain().tip(), q)
        .then(&Frame::from_pose(second.tip_from_hand()));
    // The hand closes along its y axis; the bar has no direction, so the angle is taken to the nearer end.
    let along_bar = (root_from_tool.rotation * grip.axis_in_tool.into_inner())
        .dot(&root_from_hand.rotation.column(1));
    GripDeviation {
        position: (root_from_tool.point(&grip.point_in_tool) - root_from_hand.origin).norm(),
        lean: (along_bar.abs().min(1.0).acos() - grip.max_lean).max(0.0),
    }
}
