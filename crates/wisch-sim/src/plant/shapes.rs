//! Collision shapes of surface, scene, robot and tool.

use super::held_tool::HeldTool;
use super::{ROBOT, SCENE, TOOL, groups, to_engine, vector};
use crate::SimulationSettings;
use rapier3d_f64::dynamics::RigidBodyHandle;
use rapier3d_f64::geometry::{ColliderBuilder, ColliderHandle, SharedShape};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::PhysicsWorld;
use wisch::follow::Workcell;
use wisch::geometry::{Mesh, Point2};
use wisch::represent::{ScenePart, Task};
use wisch::robot::{Articulation, Collision, Shape};

/// The tool can be compressed by up to this multiple of its compression depth [1].
const MAX_COMPRESSION: f64 = 2.0;

/// Returns the convex hull of points in a plane, extruded along z from `from` to `to` [m].
pub(super) fn prism(
    points: impl Iterator<Item = Point2>,
    from: f64,
    to: f64,
) -> Option<SharedShape> {
    let corners: Vec<engine::Vector> = points
        .flat_map(|p| [from, to].map(|z| engine::Vector::new(p.x, p.y, z)))
        .collect();
    SharedShape::convex_hull(&corners)
}

/// Adds the scene without robot, tool and surface. Returns the colliders that it added.
pub(super) fn add_scene(
    world: &mut PhysicsWorld,
    task: &Task,
    settings: &SimulationSettings,
) -> Vec<ColliderHandle> {
    let mut added = Vec::new();
    // The pose of the real robot differs from the believed one, so surface and scene are displaced
    // together.
    let world_from_surface = task.surface.world_from_surface;
    let moved = world_from_surface * settings.believed_from_real * world_from_surface.inverse();
    for object in &task.scene {
        let filter = match object.part {
            ScenePart::Robot | ScenePart::Tool => continue,
            ScenePart::Carrier => ROBOT,
            ScenePart::Obstacle => ROBOT | TOOL,
        };
        if let Some(shape) = trimesh(&object.mesh) {
            let collider = ColliderBuilder::new(shape)
                .position(to_engine(&(moved * object.world_from_object)))
                .collision_groups(groups(SCENE, filter));
            added.push(world.insert_collider(collider, None));
        }
    }
    added
}

fn trimesh(mesh: &Mesh) -> Option<SharedShape> {
    let vertices = mesh.vertices().iter().map(|p| vector(&p.coords)).collect();
    SharedShape::trimesh(vertices, mesh.triangles().to_vec()).ok()
}

fn hull(mesh: &Mesh) -> Option<SharedShape> {
    let points: Vec<_> = mesh.vertices().iter().map(|p| vector(&p.coords)).collect();
    SharedShape::convex_hull(&points)
}

/// Adds the robot's collision shapes to its bodies, and the tool's mesh to its hand.
pub(super) fn add_shapes(
    world: &mut PhysicsWorld,
    cell: &Workcell,
    tool: &HeldTool,
    articulation: &Articulation,
    compliant: &[usize],
    bodies: &[RigidBodyHandle],
) {
    let robot = cell.robot();
    for (link, at) in robot.links().iter().zip(0..) {
        let Ok(id) = robot.link(&robot.links()[at].name) else {
            continue;
        };
        let (Some(joint), joint_from_link) = articulation.carrier(id) else {
            continue;
        };
        // Drives hold the links that stand on the floor, and wheels are not simulated.
        if !is_compliant(articulation, compliant, joint) {
            continue;
        }
        for Collision {
            link_from_shape,
            shape,
        } in &link.collision
        {
            let Some(shape) = engine_shape(shape) else {
                continue;
            };
            let collider = ColliderBuilder::new(shape)
                .position(to_engine(&(joint_from_link * link_from_shape)))
                .density(0.0)
                .collision_groups(groups(ROBOT, SCENE));
            world.insert_collider(collider, Some(bodies[joint]));
        }
    }
    let (Some(joint), joint_from_tip) = articulation.carrier(cell.tip()) else {
        return;
    };
    // The compliant part belongs to the plate.
    let yielding = MAX_COMPRESSION * tool.depth.max(tool.rest);
    for part in &tool.parts {
        let firm = part
            .iter()
            .map(|p| engine::Vector::new(p.x, p.y, p.z.max(yielding)));
        let Some(shape) = SharedShape::convex_hull(&firm.collect::<Vec<_>>()) else {
            continue;
        };
        let collider = ColliderBuilder::new(shape)
            .position(to_engine(&(joint_from_tip * tool.tip_from_tool)))
            .density(0.0)
            .collision_groups(groups(TOOL, SCENE));
        world.insert_collider(collider, Some(bodies[joint]));
    }
}

/// Whether the controller drives a joint or one of its ancestors.
fn is_compliant(articulation: &Articulation, compliant: &[usize], joint: usize) -> bool {
    let mut at = Some(joint);
    while let Some(i) = at {
        let joint = &articulation.joints()[i];
        if joint
            .terms
            .iter()
            .any(|(variable, _)| compliant.contains(variable))
        {
            return true;
        }
        at = joint.parent;
    }
    false
}

fn engine_shape(shape: &Shape) -> Option<SharedShape> {
    Some(match shape {
        Shape::Box { size } => SharedShape::cuboid(size.x / 2.0, size.y / 2.0, size.z / 2.0),
        Shape::Cylinder { radius, length } => {
            let half = length / 2.0;
            // The engine's cylinders stand along y, the robot's along z.
            return cylinder_hull(*radius, half);
        }
        Shape::Capsule { radius, length } => {
            let end = engine::Vector::new(0.0, 0.0, length / 2.0);
            SharedShape::capsule(-end, end, *radius)
        }
        Shape::Sphere { radius } => SharedShape::ball(*radius),
        Shape::Mesh(mesh) => return hull(mesh),
    })
}

fn cylinder_hull(radius: f64, half: f64) -> Option<SharedShape> {
    const SIDES: usize = 24;
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / SIDES as f64;
        Point2::new(radius * angle.cos(), radius * angle.sin())
    };
    prism((0..SIDES).map(corner), -half, half)
}
