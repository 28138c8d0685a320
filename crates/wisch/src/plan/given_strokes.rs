//! Strokes that the user gives, as arrays or in a file: checks that the tool can make them, and the plan they
//! form.

use super::bend::check_bend;
use super::planner::find_unreachable_share;
use super::{FreeSpace, Node, NodeRole, Plan, PlanError, SemanticDirectedGraph, Strategy, Stroke};
use crate::geometry::{Bounds2, Mesh, PlanarPose, Point2};
use crate::represent::{Action, GoalState, Ground, OccupiedArea, SURFACE_SKIN, Task};
use parry3d_f64::math::{Pose as ParryPose, Rotation, Vector};
use parry3d_f64::query::intersection_test;
use parry3d_f64::shape::{ConvexPolyhedron, Cuboid, TriMesh};

/// Distance of the tool centre point beyond the outer border at most, over the shorter side of the tool, or
/// over its length where the action treats the surface [1]. A quarter of the tool then still lies on the
/// surface and keeps it from tipping.
const OVERHANG: f64 = 0.25;
/// Allowance for rounding [m]: a place this far off still counts as on the surface, and this length
/// of a path over a hole is ignored.
const TOLERANCE: f64 = 1e-6;
/// Step along a stroke between two collision checks of the tool [m], and the rotation between them [rad].
const STEP: f64 = 0.005;
const TURN: f64 = 0.05;
/// Height above the surface up to which the tool is checked against the scene [m]. The robot's collision check
/// covers what is higher.
const HEIGHT: f64 = 0.05;

/// The reason why the tool cannot make a stroke. Strokes and poses count from 0.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StrokeFault {
    /// A stroke has no pose.
    #[error("strokes[{stroke}] has no pose; expected at least one")]
    Empty {
        /// Index of the stroke.
        stroke: usize,
    },
    /// A number is not finite.
    #[error("strokes[{stroke}], pose {pose}: a number is not finite")]
    NotFinite {
        /// Index of the stroke.
        stroke: usize,
        /// Index of the pose.
        pose: usize,
    },
    /// The tool collides with an object of the scene.
    #[error(
        "strokes[{stroke}] leads the tool through {object:?} at ({x:.3}, {y:.3}) m in the surface frame, after pose {pose}; end the stroke before the object and begin another behind it"
    )]
    Obstacle {
        /// Index of the stroke.
        stroke: usize,
        /// Index of the pose before the collision.
        pose: usize,
        /// Name of the object.
        object: String,
        /// x of the tool centre point, in the surface frame \[m\].
        x: f64,
        /// y of the tool centre point, in the surface frame \[m\].
        y: f64,
    },
    /// The stroke presses the tool over a hole.
    #[error(
        "strokes[{stroke}] presses the tool over a hole of the surface for {length:.3} m about ({x:.3}, {y:.3}) m, after pose {pose}; end the stroke before the hole and begin another behind it"
    )]
    Hole {
        /// Index of the stroke.
        stroke: usize,
        /// Index of the pose before the hole.
        pose: usize,
        /// Length of the path over the hole \[m\].
        length: f64,
        /// x of the middle of that path, in the surface frame \[m\].
        x: f64,
        /// y of the middle of that path, in the surface frame \[m\].
        y: f64,
    },
    /// The tool leaves the surface too far.
    #[error(
        "strokes[{stroke}] leaves the surface by {distance:.3} m at ({x:.3}, {y:.3}) m, after pose {pose}; the tool centre point may be at most {limit:.3} m beyond the border"
    )]
    OffSurface {
        /// Index of the stroke.
        stroke: usize,
        /// Index of the pose before.
        pose: usize,
        /// Distance from the surface there \[m\].
        distance: f64,
        /// Largest distance allowed \[m\].
        limit: f64,
        /// x of the tool centre point, in the surface frame \[m\].
        x: f64,
        /// y of the tool centre point, in the surface frame \[m\].
        y: f64,
    },
}

/// A stroke that leaves the surface within the limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeOverBorder {
    /// Index of the stroke, from 0.
    pub stroke: usize,
    /// Distance of the tool centre point beyond the border \[m\].
    pub distance: f64,
    /// Whether the stroke skims over an edge that the task allows.
    pub skims: bool,
}

/// Describes which strokes leave the surface: one sentence for skims, one for all other strokes. Empty if no
/// stroke does.
pub fn describe_over_border(strokes: &[StrokeOverBorder]) -> Vec<String> {
    let sentence = |skims: bool, how: &str| {
        let some: Vec<_> = strokes.iter().filter(|one| one.skims == skims).collect();
        let first = some.first()?.stroke;
        let farthest = some.iter().map(|one| one.distance).fold(0.0, f64::max);
        let who = match some.len() {
            1 => format!("strokes[{first}] leaves"),
            count => format!("{count} strokes, strokes[{first}] first, leave"),
        };
        Some(format!(
            "{who} the surface by at most {farthest:.3} m {how}"
        ))
    };
    let skims = sentence(true, "over a skim edge, as a skim does");
    let others = sentence(false, "at its border, where part of the tool stays on it");
    skims.into_iter().chain(others).collect()
}

/// Checks strokes against the scene, the holes and the border of a task's surface. Returns the strokes that
/// leave the surface within the limit.
///
/// Where the tool's collision sphere is clear of the scene, so is the tool; elsewhere its footprint is moved
/// along the stroke.
///
/// # Errors
/// [`PlanError::Stroke`] for the first stroke that the tool cannot make; [`PlanError::Scene`] for
/// geometry that the collision library refuses.
pub fn check_strokes(task: &Task, strokes: &[Stroke]) -> Result<Vec<StrokeOverBorder>, PlanError> {
    check_bend(task)?;
    let meshes: Vec<Mesh> = task.obstacles_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &meshes, task.tool.collision_radius())?;
    let check = Check {
        obstacles: obstacles(task, &meshes)?,
        tool: tool_body(task),
        space,
        task,
    };
    let mut over_border = Vec::new();
    for (number, stroke) in strokes.iter().enumerate() {
        over_border.extend(check.check_stroke(number, &stroke.poses)?);
    }
    Ok(over_border)
}

/// Returns the plan that consists of the given strokes.
///
/// `strokes`: for each stroke the tool's poses from touching down to lifting off, in the surface frame. Between
/// poses the tool moves straight and turns evenly. `lift_height`: height by which the tool is lifted between
/// strokes \[m\].
///
/// Each pose becomes a node of the plan's graph. A collect without a goal in the task collects where the last
/// stroke ends.
///
/// # Errors
/// [`PlanError::Stroke`] for a stroke that the tool cannot make, see [`check_strokes`];
/// [`PlanError::NoTreatment`] for a treatment without a number of passes or a thickness.
pub fn plan_from_strokes(
    task: &Task,
    strokes: &[Vec<PlanarPose>],
    lift_height: f64,
) -> Result<Plan, PlanError> {
    if let Some(stroke) = strokes.iter().position(Vec::is_empty) {
        return Err(StrokeFault::Empty { stroke }.into());
    }
    let last = strokes.iter().flatten().last().map(|pose| pose.position);
    let goal = match (task.goal(), task.action) {
        (Some(goal), _) => goal,
        (None, Action::Collect) => GoalState::Collected {
            center: last.unwrap_or_else(Point2::origin),
            radius: task.tool.collision_radius(),
        },
        (None, action) => return Err(PlanError::NoTreatment { action }),
    };
    let mut nodes = Vec::new();
    let mut edges = Vec::new();
    let moves_dirt = matches!(task.action, Action::Collect | Action::Skim);
    let strokes: Vec<Stroke> = (strokes.iter())
        .map(|poses| {
            let first = nodes.len();
            nodes.extend(poses.iter().enumerate().map(|(i, pose)| Node {
                position: pose.position,
                role: match moves_dirt && i + 1 == poses.len() {
                    true => NodeRole::Goal,
                    false => NodeRole::Coverage,
                },
            }));
            edges.extend((first + 1..nodes.len()).map(|to| (to - 1, to)));
            Stroke {
                nodes: (first..nodes.len()).collect(),
                poses: poses.clone(),
            }
        })
        .collect();
    check_strokes(task, &strokes)?;
    Ok(Plan {
        strategy: Strategy::Own,
        strokes,
        graph: SemanticDirectedGraph {
            nodes,
            edges,
            goal,
            max_edge_length: None,
            unreachable: Vec::new(),
        },
        collision_radius: task.tool.collision_radius(),
        unreachable_share: find_unreachable_share(task)?,
        tool_start: task.tool_start,
        lift_height,
    })
}

/// Rounds a coordinate to the nanometre, so that rounding errors around zero are shown as zero [m].
fn round_to_nanometre(coordinate: f64) -> f64 {
    (coordinate * 1e9).round() / 1e9 + 0.0
}

/// An object above the surface, by its triangles and the area on which it stands.
struct Obstacle {
    name: String,
    triangles: Option<TriMesh>,
    stands_on: OccupiedArea,
}

/// Returns the obstacles of the scene, in the surface frame.
fn obstacles(task: &Task, meshes: &[Mesh]) -> Result<Vec<Obstacle>, PlanError> {
    let obstacle = |(object, mesh): (&crate::represent::SceneObject, &Mesh)| {
        let clipped = mesh.clip_above(SURFACE_SKIN).into_iter().flatten();
        let corners: Vec<Vector> = clipped.map(|p| Vector::new(p.x, p.y, p.z)).collect();
        let triangles: Vec<[u32; 3]> = (0..corners.len() as u32 / 3)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect();
        let mesh_above = (!triangles.is_empty()).then(|| TriMesh::new(corners, triangles));
        Ok(Obstacle {
            name: object.name.clone(),
            triangles: (mesh_above.transpose()).map_err(|e| PlanError::Scene(e.to_string()))?,
            stands_on: OccupiedArea::from_scene([mesh]),
        })
    };
    task.obstacles().zip(meshes).map(obstacle).collect()
}

/// Returns the part of the tool near the surface: the hull of its footprint, as high as the tool, starting just
/// above the surface.
fn tool_body(task: &Task) -> Option<ConvexPolyhedron> {
    let (_, high) = task.tool.mesh.bounds();
    let top = high.z.clamp(2.0 * SURFACE_SKIN, HEIGHT);
    let corners = task.tool.footprint.edges().map(|edge| edge.start);
    let points: Vec<Vector> = corners
        .flat_map(|p| [SURFACE_SKIN, top].map(|z| Vector::new(p.x, p.y, z)))
        .collect();
    ConvexPolyhedron::from_convex_hull(&points)
}

struct Check<'a> {
    task: &'a Task,
    space: FreeSpace,
    obstacles: Vec<Obstacle>,
    tool: Option<ConvexPolyhedron>,
}

impl Check<'_> {
    fn check_stroke(
        &self,
        stroke: usize,
        poses: &[PlanarPose],
    ) -> Result<Option<StrokeOverBorder>, StrokeFault> {
        // A file may hold strokes without poses, which do nothing.
        if poses.is_empty() {
            return Ok(None);
        }
        for (pose, PlanarPose { position, heading }) in poses.iter().enumerate() {
            if ![position.x, position.y, *heading]
                .iter()
                .all(|n| n.is_finite())
            {
                return Err(StrokeFault::NotFinite { stroke, pose });
            }
        }
        let mut over_border: Option<StrokeOverBorder> = None;
        let single = [poses[0], poses[0]];
        let legs: Vec<[PlanarPose; 2]> = match poses.len() {
            1 => vec![single],
            _ => poses.windows(2).map(|leg| [leg[0], leg[1]]).collect(),
        };
        for (pose, leg) in legs.iter().enumerate() {
            if let Some(found) = self.check_support(stroke, pose, leg)? {
                let distance = found.distance.max(over_border.map_or(0.0, |o| o.distance));
                over_border = Some(StrokeOverBorder { distance, ..found });
            }
            self.check_clearance(stroke, pose, leg)?;
        }
        Ok(over_border)
    }

    /// Checks that the surface carries the tool on a leg; returns the distance by which the tool leaves it
    /// within the limit.
    fn check_support(
        &self,
        stroke: usize,
        pose: usize,
        [from, to]: &[PlanarPose; 2],
    ) -> Result<Option<StrokeOverBorder>, StrokeFault> {
        let surface = &self.task.surface;
        let along = to.position - from.position;
        let mut farthest: Option<StrokeOverBorder> = None;
        for part in surface.split_move(from.position, to.position) {
            let [begin, end] = part.shares;
            let at = |share: f64| from.position + along * share;
            match part.ground {
                Ground::Surface => {}
                Ground::Hole(_) => {
                    let length = (end - begin) * along.norm();
                    let middle = at((begin + end) / 2.0);
                    let is_on_border = surface
                        .outline
                        .edges()
                        .any(|edge| edge.distance(middle) <= TOLERANCE);
                    if !is_on_border {
                        return Err(StrokeFault::Hole {
                            stroke,
                            pose,
                            length,
                            x: round_to_nanometre(middle.x),
                            y: round_to_nanometre(middle.y),
                        });
                    }
                }
                Ground::Beyond => {
                    // The distance from a convex border is greatest at an end; inside a notch it may be
                    // greatest in the middle.
                    let places = [begin, (begin + end) / 2.0, end].map(at);
                    let excess = |place: &Point2| {
                        let (distance, limit, _) = self.overhang(*place);
                        distance - limit
                    };
                    let farther = |a: &Point2, b: &Point2| excess(a).total_cmp(&excess(b));
                    let Some(place) = places.into_iter().max_by(farther) else {
                        continue;
                    };
                    let (distance, limit, skims) = self.overhang(place);
                    if distance > limit + TOLERANCE {
                        return Err(StrokeFault::OffSurface {
                            stroke,
                            pose,
                            distance,
                            limit,
                            x: round_to_nanometre(place.x),
                            y: round_to_nanometre(place.y),
                        });
                    }
                    let is_farther = farthest.is_none_or(|known| known.distance < distance);
                    if distance > TOLERANCE && is_farther {
                        farthest = Some(StrokeOverBorder {
                            stroke,
                            distance,
                            skims,
                        });
                    }
                }
            }
        }
        Ok(farthest)
    }

    /// Returns how far a place is beyond the border [m], how far it may be [m], and whether a skim over an edge
    /// allows that.
    fn overhang(&self, place: Point2) -> (f64, f64, bool) {
        let surface = &self.task.surface;
        let edges: Vec<_> = surface.outline.edges().collect();
        let distances = edges.iter().map(|edge| edge.distance(place));
        let distance = distances.fold(f64::INFINITY, f64::min);
        let skim = surface.skim_edges.iter().filter_map(|&i| edges.get(i));
        let to_skim_edge = skim
            .map(|edge| edge.distance(place))
            .fold(f64::INFINITY, f64::min);
        let may_skim = self.task.tool.collision_radius();
        if self.task.action == Action::Skim && to_skim_edge <= may_skim + TOLERANCE {
            return (to_skim_edge, may_skim, true);
        }
        let size = self
            .task
            .tool
            .footprint
            .bounds()
            .map(|bounds| bounds.size());
        let size = size.unwrap_or(self.task.tool.area_of_effect);
        // Lanes lead the tool over the border along its length.
        let side = if self.task.action.treats() {
            size.x
        } else {
            size.min()
        };
        (distance, OVERHANG * side, false)
    }

    /// Checks that the tool collides with nothing on a leg.
    fn check_clearance(
        &self,
        stroke: usize,
        pose: usize,
        [from, to]: &[PlanarPose; 2],
    ) -> Result<(), StrokeFault> {
        if self.obstacles.is_empty() || self.is_sphere_clear(from.position, to.position) {
            return Ok(());
        }
        let along = to.position - from.position;
        let turn = to.heading - from.heading;
        let steps = (along.norm() / STEP).max(turn.abs() / TURN).ceil().max(1.0);
        for step in 0..=steps as usize {
            let share = step as f64 / steps;
            let place = from.position + along * share;
            let heading = from.heading + turn * share;
            if let Some(object) = self.object_at(place, heading) {
                return Err(StrokeFault::Obstacle {
                    stroke,
                    pose,
                    object: object.to_owned(),
                    x: round_to_nanometre(place.x),
                    y: round_to_nanometre(place.y),
                });
            }
        }
        Ok(())
    }

    /// Whether the collision sphere is clear along the whole leg.
    fn is_sphere_clear(&self, from: Point2, to: Point2) -> bool {
        self.space.is_clear(from) && self.space.is_clear_between(from, to)
    }

    /// Returns the object with which the tool collides at a pose.
    fn object_at(&self, place: Point2, heading: f64) -> Option<&str> {
        let turn = Rotation::from_rotation_z(heading);
        let surface_from_tool = ParryPose::from_parts(Vector::new(place.x, place.y, 0.0), turn);
        let meets = |obstacle: &&Obstacle| {
            let is_inside = obstacle.stands_on.contains(place);
            let meets = |triangles: &TriMesh| {
                let origin = ParryPose::identity();
                let met = match &self.tool {
                    Some(tool) => intersection_test(&origin, triangles, &surface_from_tool, tool),
                    None => {
                        let bounds = self.task.tool.footprint.bounds();
                        let half =
                            bounds.map_or(self.task.tool.area_of_effect, |b: Bounds2| b.size());
                        let half = Vector::new(half.x / 2.0, half.y / 2.0, HEIGHT / 2.0);
                        intersection_test(
                            &origin,
                            triangles,
                            &surface_from_tool,
                            &Cuboid::new(half),
                        )
                    }
                };
                met.is_ok_and(|met| met.intersecting)
            };
            is_inside || obstacle.triangles.as_ref().is_some_and(meets)
        };
        self.obstacles.iter().find(meets).map(|o| o.name.as_str())
    }
}
