//! The target surface as an obstacle: to the robot and its hand always, to the tool whenever it must not touch
//! it.

use crate::follow::FollowError;
use crate::geometry::{Point2, Point3, Pose, Vector3};
use crate::plan::Plan;
use crate::represent::{SurfaceShape, Task};
use crate::robot::{CollisionModel, JointKind, Kinematics, LinkId, RobotModel};
use nalgebra::{Translation3, UnitQuaternion};
use std::f64::consts::TAU;

/// Assumed thickness of the surface [m]: its carrier is unknown, so that it is only a sheet.
const THICKNESS: f64 = 1e-3;
/// Depth of the space behind the surface that the tool avoids [m]: its contents are unknown.
const BEHIND: f64 = 1.0;
/// Depth of the hand below the tool's contact plane above which it counts as below the surface [m].
const HAND_TOLERANCE: f64 = 1e-3;
/// Largest number of points of the hand that are checked; the deepest points are taken.
const HAND_POINTS: usize = 64;
/// Number of yaws of the tool that are tried for a place at which the hand extends beyond the
/// border beside the tool.
const HAND_YAWS: usize = 16;

/// The surface and the space behind it, as obstacles of collision models.
pub(super) struct TargetSurface {
    /// Name of the surface among the obstacles.
    pub face: String,
    /// Name of the space behind it, which only the tool avoids; `None` where the tool waits there.
    pub behind: Option<String>,
}

impl TargetSurface {
    /// Adds the surface of a task to models of a robot with its tool. `names` returns a unique name
    /// for a given name.
    ///
    /// # Errors
    /// An outline without area, or geometry that no collision check takes.
    pub fn add(
        task: &Task,
        root_from_world: &Pose,
        names: &dyn Fn(&str) -> String,
        waits_behind: bool,
        models: &mut [&mut CollisionModel],
    ) -> Result<Self, FollowError> {
        let surface = &task.surface;
        let root_from_surface = root_from_world * surface.world_from_surface;
        let face = names(&format!("surface {}", surface.name));
        let behind = names(&format!("space behind surface {}", surface.name));
        let mut solids = vec![(face.as_str(), surface.solid_below(THICKNESS))];
        if !waits_behind {
            solids.push((behind.as_str(), surface.solid_below(BEHIND)));
        }
        for (name, solid) in solids {
            let solid = solid.map_err(FollowError::Surface)?;
            for model in &mut *models {
                model.add_obstacle(name, root_from_surface, &solid)?;
            }
        }
        Ok(Self {
            face,
            behind: (!waits_behind).then_some(behind),
        })
    }
}

/// Whether the tool is behind the surface in a posture, within the extent of the surface.
pub(super) fn is_tool_behind(task: &Task, kinematics: &Kinematics<'_>, tool: &PlacedTool) -> bool {
    let root_from_tool = kinematics.world_from_link(tool.tip) * tool.tip_from_tool;
    let surface_from_root = task.surface.world_from_surface.inverse() * tool.world_from_root;
    let surface_from_tool = surface_from_root * root_from_tool;
    let is_behind = |vertex: &Point3| {
        let at = task.surface.shape.chart(surface_from_tool * vertex);
        (-BEHIND..0.0).contains(&at.height) && task.surface.outline.contains(at.place)
    };
    task.tool.mesh.vertices().iter().any(is_behind)
}

/// Where and how the robot holds the tool.
pub(super) struct PlacedTool {
    pub world_from_root: Pose,
    pub tip: LinkId,
    pub tip_from_tool: Pose,
}

/// Part of the hand that is below the surface at every node.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::follow) struct HandBelow {
    pub link: String,
    /// Depth below the tool's contact plane [m].
    pub depth: f64,
}

/// Returns the part of the hand that would be below the surface at every node of a plan, at any yaw and lean of
/// the tool; `None` if the hand is free at some node, or the plan has no nodes.
pub(super) fn hand_below(
    task: &Task,
    plan: &Plan,
    robot: &RobotModel,
    kinematics: &Kinematics<'_>,
    tool: &PlacedTool,
) -> Option<HandBelow> {
    let tool_from_root = (kinematics.world_from_link(tool.tip) * tool.tip_from_tool).inverse();
    let hand: Vec<(LinkId, Vec<Point3>)> = hand_links(robot, tool.tip)
        .into_iter()
        .map(|link| {
            let tool_from_link = tool_from_root * kinematics.world_from_link(link);
            let shapes = robot.links()[link.index()].collision.iter();
            let meshes = shapes.filter_map(|shape| shape.mesh_in_link());
            let points = meshes.flat_map(|mesh| mesh.vertices().to_vec());
            (link, points.map(|point| tool_from_link * point).collect())
        })
        .collect();
    let tilts: Vec<UnitQuaternion<f64>> = match task.tool.tilt {
        None => vec![UnitQuaternion::identity()],
        Some(tilt) => [0.0, tilt.range.min_rad, tilt.range.max_rad]
            .map(|angle| UnitQuaternion::from_axis_angle(&tilt.axis_in_tool, angle))
            .to_vec(),
    };
    let mut worst: Option<HandBelow> = None;
    for tilt in tilts {
        let mut below: Vec<(Point3, LinkId)> = Vec::new();
        for (link, points) in &hand {
            let leaning = points.iter().map(|point| tilt * point);
            below.extend(
                leaning
                    .filter(|p| p.z < -HAND_TOLERANCE)
                    .map(|p| (p, *link)),
            );
        }
        below.sort_by(|a, b| a.0.z.total_cmp(&b.0.z));
        below.truncate(HAND_POINTS);
        let &(deepest, link) = below.first()?;
        let is_over_border = |node: Point2| {
            (0..HAND_YAWS).any(|i| {
                let yaw = i as f64 / HAND_YAWS as f64 * TAU;
                let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
                let surface_from_tool = match &task.surface.shape {
                    SurfaceShape::Plane => {
                        Pose::from_parts(Translation3::new(node.x, node.y, 0.0), turn)
                    }
                    shape => shape.place(node, 0.0) * turn,
                };
                // On a bulge, what is below the tool's contact plane may still be above the surface.
                (below.iter()).all(|(p, _)| {
                    let at = task.surface.shape.chart(surface_from_tool * p);
                    at.height >= 0.0 || !task.surface.outline.contains(at.place)
                })
            })
        };
        let mut nodes = plan.graph.nodes.iter();
        if plan.graph.nodes.is_empty() || nodes.any(|node| is_over_border(node.position)) {
            return None;
        }
        worst.get_or_insert(HandBelow {
            link: robot.links()[link.index()].name.clone(),
            depth: -deepest.z,
        });
    }
    worst
}

/// Returns the links that move with the tool: those fixed to the tip, and all links that these carry.
fn hand_links(robot: &RobotModel, tip: LinkId) -> Vec<LinkId> {
    let mut first = tip;
    for joint in robot.joints_above(tip) {
        if joint.kind != JointKind::Fixed {
            break;
        }
        first = joint.parent;
    }
    robot.carried_links(first)
}
