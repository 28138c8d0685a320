//! Checks that robot, hand and tool stay on their side of the target surface, and that the tool is pressed only
//! on the surface. It uses the audit's own kinematics and geometry, not the collision model.

use super::given_mesh::{GivenMesh, OffMesh};
use super::kinematics::{Frame, moved_by};
use crate::follow::{FollowConfig, Motion, Phase, TrajectorySample, Workcell};
use crate::geometry::{Bounds2, Edge, Mesh, Point2, Point3, Vector3, encloses};
use crate::represent::{Cone, Surface, SurfaceShape, Task};
use nalgebra::UnitQuaternion;

/// Depth of a body in the surface that is allowed for rounding [m].
const DEPTH_TOLERANCE: f64 = 1e-4;
/// Depth of the space behind the surface that the tool must avoid [m].
const BEHIND: f64 = 1.0;
/// Largest sagitta [m] by which the middle of a body's edge may be nearer to a curved surface than
/// its ends.
const MAX_SAGITTA: f64 = 1e-4;
/// Longest edge of a body over a mesh [m].
const EDGE_OVER_MESH: f64 = 0.04;
/// Allowed distance of the tool centre point over a hole while the tool is pressed [m]: twice its allowed
/// deviation from the line.
const HOLE_TOLERANCE: f64 = 2e-3;

/// A rigid body: the shapes of a link, or the tool.
struct Body {
    name: String,
    link: usize,
    /// Mesh in the frame of the link [m].
    mesh: Mesh,
    /// Bounding sphere in the frame of the link [m].
    middle: Point3,
    reach: f64,
}

/// The bodies of a work cell, to be checked against its target surface.
pub(super) struct SurfaceCheck<'a> {
    task: &'a Task,
    cell: &'a Workcell,
    surface_from_root: Frame,
    bounds: Bounds2,
    /// Links that variables move, without those that stand on a floor that is the surface.
    links: Vec<Body>,
    /// The tool at rest, and while it is pressed.
    relaxed: Body,
    pressed: Body,
    /// Allowed depth of points of the tool below the surface while it wipes [m].
    pressed_depth: f64,
    /// Whether the tool waits behind the surface, so that its way to the surface passes through that space.
    waits_behind: bool,
    /// The mesh of the surface, if it has one.
    given: Option<GivenMesh>,
    /// Box in the frame of the surface [m]: no edge of a body beyond it meets the mesh; `None` for
    /// a surface without a mesh.
    near: Option<[Vector3; 2]>,
}

/// A fault at the surface; times are those of the motion [s], places in the surface frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum SurfaceFault {
    /// A body is in the surface or has passed through it, or the tool is behind it.
    Through {
        time: f64,
        body: String,
        depth: f64,
        place: Point2,
    },
    /// The tool is pressed over a hole.
    OverHole { time: f64, place: Point2 },
    /// The pressed tool is too far from the given mesh, or its axis deviates from the mesh's
    /// normal.
    OffMesh {
        time: f64,
        place: Point2,
        off: OffMesh,
    },
}

/// The deepest place at which a body is in the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Penetration {
    depth: f64,
    place: Point2,
}

impl Body {
    fn new(name: &str, link: usize, mesh: Mesh) -> Self {
        let (low, high) = mesh.bounds();
        let middle = nalgebra::center(&low, &high);
        let vertices = mesh.vertices().iter();
        Self {
            name: name.to_owned(),
            link,
            reach: vertices.map(|p| (p - middle).norm()).fold(0.0, f64::max),
            middle,
            mesh,
        }
    }

    /// Returns the body with edges that stay straight over a surface.
    fn over(self, surface: &Surface) -> Self {
        // Where the radius of curvature is R, an edge of length l has the sagitta l²/8R.
        let longest = match surface.shape {
            SurfaceShape::Plane => return self,
            SurfaceShape::Cylinder { .. } | SurfaceShape::Cone(_) => {
                (8.0 * surface.least_radii().least() * MAX_SAGITTA).sqrt()
            }
            SurfaceShape::Mesh(_) => EDGE_OVER_MESH,
        };
        let mesh = self.mesh.split_edges(longest);
        Self { mesh, ..self }
    }
}

/// Returns a point in the frame of the surface as place in the chart and height [m].
fn unroll(shape: &SurfaceShape, point: Vector3) -> Vector3 {
    let (radius, axis) = match shape {
        SurfaceShape::Plane => return point,
        &SurfaceShape::Cylinder { radius, axis } => (radius, axis),
        SurfaceShape::Cone(cone) => return unroll_cone(cone, point),
        SurfaceShape::Mesh(_) => {
            let at = shape.chart(point.into());
            return Vector3::new(at.place.x, at.place.y, at.height);
        }
    };
    let along = Vector3::new(axis.cos(), axis.sin(), 0.0);
    let across = Vector3::z().cross(&along);
    // From the axis of the cylinder, which lies its radius below the chart.
    let from_axis = point + Vector3::z() * radius - along * point.dot(&along);
    let outwards = from_axis * radius.signum();
    let angle = outwards.dot(&across).atan2(outwards.z);
    let height = (from_axis.norm() - radius.abs()) * radius.signum();
    along * point.dot(&along) + across * (radius * angle) + Vector3::z() * height
}

/// Returns a point in the frame of the surface as place in the chart of a cone and height [m]: in the half plane through
/// axis and point, the coordinates are along the cone from its apex and along the normal.
fn unroll_cone(cone: &Cone, point: Vector3) -> Vector3 {
    let along = Vector3::new(cone.axis.cos(), cone.axis.sin(), 0.0);
    let across = Vector3::z().cross(&along);
    let (sine, cosine, side) = (
        cone.half_angle.sin(),
        cone.half_angle.cos(),
        cone.radius.signum(),
    );
    let slant = cone.radius.abs() / sine;
    let axis = along * cosine - Vector3::z() * (side * sine);
    let from_apex = point + along * slant;
    let outwards = (from_apex - axis * from_apex.dot(&axis)) * side;
    let at_origin = along * (side * sine) + Vector3::z() * cosine;
    let angle = outwards.dot(&across).atan2(outwards.dot(&at_origin)) * side * sine;
    let (on_axis, from_axis) = (from_apex.dot(&axis), outwards.norm());
    let distance = (on_axis * cosine + from_axis * sine).max(0.0);
    let height = (from_axis * cosine - on_axis * sine) * side;
    along * (distance * angle.cos() - slant)
        + across * (distance * angle.sin())
        + Vector3::z() * height
}

impl<'a> SurfaceCheck<'a> {
    pub fn new(cell: &'a Workcell, task: &'a Task, config: &FollowConfig) -> Option<Self> {
        let robot = cell.robot();
        let surface_from_world = task.surface.world_from_surface.inverse();
        let surface_from_root = Frame::from_pose(&(surface_from_world * cell.world_from_root()));
        let tool = |mesh: &Mesh| {
            let name = &task.tool.name;
            Body::new(
                name,
                cell.tip().index(),
                mesh.transform(cell.tip_from_tool()),
            )
            .over(&task.surface)
        };
        let depth = task.interaction.compression_depth_m;
        let mut check = Self {
            bounds: Bounds2::from_points(task.surface.outline.outer().iter().copied())?,
            links: Vec::new(),
            relaxed: tool(&relax_tool(&task.tool.mesh, depth)),
            pressed: tool(&task.tool.mesh),
            pressed_depth: leaning_depth(task)
                + depth
                + line_allowance(&task.tool.mesh, config)
                + hollow_depth(task),
            waits_behind: false,
            given: GivenMesh::new(task, config),
            near: near_mesh(&task.surface.shape),
            surface_from_root,
            task,
            cell,
        };
        let stands_on_it = check.standing_on_surface();
        let mut moves = vec![false; robot.links().len()];
        for joint in robot.joints() {
            let own = joint.drive.terms.iter().any(|&(_, factor)| factor != 0.0);
            moves[joint.child.index()] = moves[joint.parent.index()] || own;
        }
        for (i, link) in robot.links().iter().enumerate() {
            if !moves[i] || stands_on_it[i] {
                continue;
            }
            let meshes = link
                .collision
                .iter()
                .filter_map(|shape| shape.mesh_in_link());
            check
                .links
                .extend(meshes.map(|mesh| Body::new(&link.name, i, mesh).over(&task.surface)));
        }
        let mount = cell.mount();
        let holder = mount.holder.and_then(|holder| holder.mesh(mount.axis).ok());
        check.links.extend(holder.map(|mesh| {
            Body::new(
                &format!("holder of {}", task.tool.name),
                cell.tip().index(),
                mesh,
            )
            .over(&task.surface)
        }));
        let frames = check.frames(cell.ready_posture());
        let tool = &check.relaxed;
        let waiting = check.behind(tool, &frames[tool.link], DEPTH_TOLERANCE);
        check.waits_behind = waiting.is_some();
        Some(check)
    }

    /// Returns for each link whether it stands on the surface: only the base moves it, over a floor that
    /// contains the surface.
    fn standing_on_surface(&self) -> Vec<bool> {
        let robot = self.cell.robot();
        let mut stands = vec![false; robot.links().len()];
        let world_from_surface = Frame::from_pose(&self.task.surface.world_from_surface);
        let mut corners = self.task.surface.outline.outer().iter();
        let is_floor = self.task.surface.shape.is_plane()
            && corners.all(|p| {
                world_from_surface.point(&Point3::new(p.x, p.y, 0.0)).z <= DEPTH_TOLERANCE
            });
        let Some(base) = self.cell.base().filter(|_| is_floor) else {
            return stands;
        };
        stands[robot.root().index()] = true;
        for joint in robot.joints() {
            let mut terms = joint.drive.terms.iter();
            let own = terms.all(|(variable, _)| [base.x, base.y, base.yaw].contains(variable));
            stands[joint.child.index()] = stands[joint.parent.index()] && own;
        }
        stands
    }

    /// Returns the frame of every link in that of the surface, at the positions of all n variables [rad or m].
    fn frames(&self, q: &[f64]) -> Vec<Frame> {
        let robot = self.cell.robot();
        let mut frames = vec![self.surface_from_root; robot.links().len()];
        // A parent comes before its children.
        for joint in robot.joints() {
            frames[joint.child.index()] = frames[joint.parent.index()].then(&moved_by(joint, q));
        }
        frames
    }

    /// Returns the faults of a motion, for each body the deepest.
    pub fn faults(&self, motion: &Motion, samples: &[TrajectorySample]) -> Vec<SurfaceFault> {
        let touches = matches!(motion.phase, Phase::Wipe(_) | Phase::Lower | Phase::Lift);
        let (tool, tool_depth) = match touches {
            true => (&self.pressed, self.pressed_depth),
            false => (&self.relaxed, DEPTH_TOLERANCE),
        };
        let bodies: Vec<(&Body, f64)> = (self.links.iter().map(|body| (body, DEPTH_TOLERANCE)))
            .chain([(tool, tool_depth)])
            .collect();
        let mut worst: Vec<Option<(f64, Penetration)>> = vec![None; bodies.len()];
        let mut over_hole: Option<(f64, Point2)> = None;
        let mut off_mesh: Option<(f64, Point2, OffMesh)> = None;
        let mut before: Option<Vec<Frame>> = None;
        // For each body its vertices at the previous sample, if they were computed.
        let mut corners_before: Vec<Option<Vec<Vector3>>> = vec![None; bodies.len()];
        for sample in samples {
            let frames = self.frames(&sample.q);
            for (i, &(body, depth)) in bodies.iter().enumerate() {
                let now = &frames[body.link];
                let earlier = before.as_ref().map(|before| &before[body.link]);
                let known = &mut corners_before[i];
                let mut found = self.penetration(body, earlier, now, depth, known);
                if found.is_none() && !self.waits_behind && i + 1 == bodies.len() {
                    found = self.behind(body, now, depth);
                }
                let Some(found) = found else { continue };
                if worst[i].is_none_or(|(_, known)| found.depth > known.depth) {
                    worst[i] = Some((sample.time, found));
                }
            }
            if let (Some(given), Phase::Wipe(_)) = (&self.given, motion.phase) {
                let tool = self.tool_frame(&frames);
                let place = unroll(&self.task.surface.shape, tool.origin).xy();
                let is_beyond = !self.task.surface.outline.contains(place.into());
                let off = given.measure(&tool, is_beyond);
                if given.exceeds(&off) && off_mesh.is_none_or(|(.., most)| off.exceeds(&most)) {
                    off_mesh = Some((sample.time, place.into(), off));
                }
            }
            if over_hole.is_none() && matches!(motion.phase, Phase::Wipe(_)) {
                over_hole = self
                    .hole_under_tool(&frames)
                    .map(|place| (sample.time, place));
            }
            before = Some(frames);
        }
        let through = bodies.iter().zip(worst).filter_map(|((body, _), worst)| {
            let (time, Penetration { depth, place }) = worst?;
            Some(SurfaceFault::Through {
                time,
                body: body.name.clone(),
                depth,
                place,
            })
        });
        let over_hole = over_hole.map(|(time, place)| SurfaceFault::OverHole { time, place });
        let off_mesh =
            off_mesh.map(|(time, place, off)| SurfaceFault::OffMesh { time, place, off });
        through.chain(over_hole).chain(off_mesh).collect()
    }

    /// Returns the vertices of a body as places in the chart and heights [m].
    fn unrolled(&self, body: &Body, surface_from_link: &Frame) -> Vec<Vector3> {
        let vertices = body.mesh.vertices().iter();
        let shape = &self.task.surface.shape;
        let is_tool = body.link == self.relaxed.link && body.name == self.relaxed.name;
        let near = self.near.filter(|_| !is_tool);
        let is_far = |point: &Vector3| near.is_some_and(|near| distance_to_box(point, near) > 0.0);
        vertices
            .map(|p| match surface_from_link.point(p) {
                // Only vertices of links that may meet the mesh count; NaN is on neither side of
                // the surface.
                point if is_far(&point) => Vector3::repeat(f64::NAN),
                point => unroll(shape, point),
            })
            .collect()
    }

    /// Returns where a body is deeper in the surface than allowed, or has passed through it since the last
    /// sample.
    ///
    /// `known`: the vertices of the body at the last sample, if they are known; afterwards those of this sample.
    fn penetration(
        &self,
        body: &Body,
        earlier: Option<&Frame>,
        now: &Frame,
        may_be_deep: f64,
        known: &mut Option<Vec<Vector3>>,
    ) -> Option<Penetration> {
        let corners_before = known.take();
        let side = |frame: &Frame| {
            let in_space = frame.point(&body.middle);
            let middle = unroll(&self.task.surface.shape, in_space);
            let is_plane = self.task.surface.shape.is_plane();
            let is_far = |near| distance_to_box(&in_space, near) > body.reach;
            let is_beside = self.near.is_some_and(is_far)
                || is_plane
                    && (middle.x + body.reach < self.bounds.min.x
                        || middle.x - body.reach > self.bounds.max.x
                        || middle.y + body.reach < self.bounds.min.y
                        || middle.y - body.reach > self.bounds.max.y);
            let height = middle.z + may_be_deep;
            (height.abs() > body.reach || is_beside).then_some(height > 0.0)
        };
        let (side_now, side_before) = (side(now), earlier.and_then(side));
        if side_now.is_some() && (earlier.is_none() || side_now == side_before) {
            return None;
        }
        let corners = known.insert(self.unrolled(body, now));
        if let Some(found) = self.section(&body.mesh, corners, may_be_deep) {
            return Some(found);
        }
        // Vertices on the other side have passed through the surface if they crossed its plane within the
        // outline.
        let earlier = earlier?;
        let earlier = corners_before.unwrap_or_else(|| self.unrolled(body, earlier));
        let mut passed = corners.iter().zip(&earlier).filter_map(|(now, earlier)| {
            let [before, after] = [earlier.z + may_be_deep, now.z + may_be_deep];
            if (before < 0.0) == (after < 0.0) {
                return None;
            }
            let at = earlier + (now - earlier) * (before / (before - after));
            let place = Point2::new(at.x, at.y);
            self.task
                .surface
                .outline
                .contains(place)
                .then_some(Penetration {
                    depth: -now.z.min(earlier.z),
                    place,
                })
        });
        passed.next()
    }

    /// Returns the section of a mesh with the plane at depth `may_be_deep` below the surface, if it meets the
    /// outline.
    fn section(&self, mesh: &Mesh, corners: &[Vector3], may_be_deep: f64) -> Option<Penetration> {
        let height = |i: u32| corners[i as usize].z + may_be_deep;
        let lowest = corners.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
        let highest = corners
            .iter()
            .map(|p| p.z)
            .fold(f64::NEG_INFINITY, f64::max);
        if lowest + may_be_deep >= 0.0 || highest + may_be_deep <= 0.0 {
            return None;
        }
        let mut section: Vec<Edge> = Vec::new();
        for triangle in mesh.triangles() {
            let mut crossings = [0, 1, 2].into_iter().filter_map(|side| {
                let (a, b) = (triangle[side], triangle[(side + 1) % 3]);
                let (low, high) = if height(a) < height(b) {
                    (a, b)
                } else {
                    (b, a)
                };
                if !(height(low) < 0.0 && height(high) >= 0.0) {
                    return None;
                }
                let share = height(low) / (height(low) - height(high));
                let (low, high) = (corners[low as usize], corners[high as usize]);
                let at = low + (high - low) * share;
                Some(Point2::new(at.x, at.y))
            });
            if let (Some(start), Some(end)) = (crossings.next(), crossings.next()) {
                section.push(Edge { start, end });
            }
        }
        let outline = &self.task.surface.outline;
        let meets = |edge: &Edge| {
            outline.contains(edge.start) || outline.edges().any(|border| cross(edge, &border))
        };
        let place = match section.iter().find(|edge| meets(edge)) {
            Some(edge) => edge.start,
            // The section may enclose the whole surface.
            None => {
                let corner = *outline.outer().first()?;
                encloses(section.iter().copied(), corner).then_some(corner)?
            }
        };
        Some(Penetration {
            depth: -lowest,
            place,
        })
    }

    /// Returns where the tool is behind the surface, deeper than allowed.
    fn behind(&self, tool: &Body, frame: &Frame, may_be_deep: f64) -> Option<Penetration> {
        let middle = unroll(&self.task.surface.shape, frame.point(&tool.middle)).z;
        if middle - tool.reach > -may_be_deep || middle + tool.reach < -BEHIND {
            return None;
        }
        let mut corners = self.unrolled(tool, frame).into_iter();
        corners.find_map(|at| {
            let place = Point2::new(at.x, at.y);
            let is_behind = (-BEHIND..-may_be_deep).contains(&at.z);
            (is_behind && self.task.surface.outline.contains(place)).then_some(Penetration {
                depth: -at.z,
                place,
            })
        })
    }

    /// Returns the frame of the tool in that of the surface.
    fn tool_frame(&self, frames: &[Frame]) -> Frame {
        frames[self.cell.tip().index()].then(&Frame::from_pose(self.cell.tip_from_tool()))
    }

    /// Returns where the tool centre point is over a hole, farther from the hole's border than the tolerance.
    fn hole_under_tool(&self, frames: &[Frame]) -> Option<Point2> {
        let outline = &self.task.surface.outline;
        if outline.holes().is_empty() || self.task.interaction.gap_m > 0.0 {
            return None;
        }
        let tool = self.tool_frame(frames);
        let at = unroll(&self.task.surface.shape, tool.origin);
        let place = Point2::new(at.x, at.y);
        let mut holes = outline.holes().iter();
        let is_over = holes.any(|hole| {
            let edges = || {
                (0..hole.len()).map(|i| Edge {
                    start: hole[i],
                    end: hole[(i + 1) % hole.len()],
                })
            };
            encloses(edges(), place) && edges().all(|edge| edge.distance(place) > HOLE_TOLERANCE)
        });
        is_over.then_some(place)
    }
}

/// Returns the bounds of a mesh, extended on all sides by twice the longest edge of a body [m].
fn near_mesh(shape: &SurfaceShape) -> Option<[Vector3; 2]> {
    let SurfaceShape::Mesh(mesh) = shape else {
        return None;
    };
    let nowhere = Vector3::repeat(f64::INFINITY);
    let points = mesh.sheet().vertices().map(|vertex| vertex.point.coords);
    let [low, high] = points.fold([nowhere, -nowhere], |[low, high], p| {
        [low.inf(&p), high.sup(&p)]
    });
    let around = Vector3::repeat(2.0 * EDGE_OVER_MESH);
    Some([low - around, high + around])
}

/// Distance of a point from a box [m]; 0 within it.
fn distance_to_box(point: &Vector3, [low, high]: [Vector3; 2]) -> f64 {
    (point - point.sup(&low).inf(&high)).norm()
}

/// Returns the mesh of a tool at rest: its underside lies below the tool centre point by the depth of its
/// compression in contact [m].
fn relax_tool(mesh: &Mesh, compression_depth: f64) -> Mesh {
    let lowered = |p: &Point3| {
        let share = (1.0 - p.z / (2.0 * compression_depth)).clamp(0.0, 1.0);
        Point3::new(p.x, p.y, p.z - compression_depth * share)
    };
    if compression_depth <= 0.0 {
        return mesh.clone();
    }
    let vertices = mesh.vertices().iter().map(lowered).collect();
    Mesh::new(vertices, mesh.triangles().to_vec()).unwrap_or_else(|_| mesh.clone())
}

/// Returns the largest depth of a tool below its contact plane, upright or at its largest lean [m].
fn leaning_depth(task: &Task) -> f64 {
    let upright = UnitQuaternion::identity();
    let leans = task.tool.tilt.map_or(vec![upright], |tilt| {
        let range = [tilt.range.min_rad, tilt.range.max_rad];
        let turned = range.map(|angle| UnitQuaternion::from_axis_angle(&tilt.axis_in_tool, angle));
        [vec![upright], turned.to_vec()].concat()
    });
    let vertices = task.tool.mesh.vertices();
    let lowest = |lean: &UnitQuaternion<f64>| {
        let heights = vertices.iter().map(|p| (lean * p).z);
        heights.fold(0.0, f64::min)
    };
    -leans.iter().map(lowest).fold(0.0, f64::min)
}

/// Returns the largest depth of a tool's flat underside in a hollow, which its middle touches [m].
fn hollow_depth(task: &Task) -> f64 {
    let (radius, smoothed_by) = match &task.surface.shape {
        SurfaceShape::Plane => return 0.0,
        SurfaceShape::Cylinder { radius, .. } => (*radius, 0.0),
        SurfaceShape::Cone(_) => (-task.surface.least_radii().hollow, 0.0),
        SurfaceShape::Mesh(mesh) => (-mesh.least_radii().hollow, mesh.sheet().smoothed_by()),
    };
    let corners = task.tool.footprint.edges();
    let reach = corners
        .map(|edge| edge.start.coords.norm())
        .fold(0.0, f64::max);
    // A chord of half length l lies l²/2R off its arc.
    (-reach * reach / (2.0 * radius)).max(0.0) + smoothed_by
}

/// Returns the largest displacement of a point of the tool within the tolerances of its line [m].
fn line_allowance(mesh: &Mesh, config: &FollowConfig) -> f64 {
    let vertices = mesh.vertices().iter();
    let across = vertices.map(|p| p.coords.norm()).fold(0.0, f64::max);
    DEPTH_TOLERANCE + config.line_tolerance + config.turn_tolerance * across
}

/// Whether two edges cross.
fn cross(a: &Edge, b: &Edge) -> bool {
    let side = |edge: &Edge, p: Point2| (edge.end - edge.start).perp(&(p - edge.start));
    side(a, b.start) * side(a, b.end) < 0.0 && side(b, a.start) * side(b, a.end) < 0.0
}
