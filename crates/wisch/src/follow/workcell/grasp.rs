//! How hands hold a tool, and the tool's shape in the hand.

use crate::follow::FollowError;
use crate::geometry::{Mesh, Point3, Pose, Vector3};
use crate::represent::Tool;
use crate::robot::{Collision, LinkId, RobotModel, Shape};
use nalgebra::{Translation3, UnitQuaternion};
use std::f64::consts::PI;

/// Returns the end of a hand in the frame of its link: on the z axis, at the outermost point of the hand's
/// shapes.
pub(in crate::follow) fn tip_from_hand(robot: &RobotModel, tip: LinkId) -> Pose {
    let hand = &robot.links()[tip.index()].collision;
    let reach = hand.iter().map(outermost).fold(0.0, f64::max);
    Pose::translation(0.0, 0.0, reach)
}

/// Returns the pose of a tool in the frame of the link that leads it: by its grip, or without a grip by the
/// rear edge of its upper face, with the hand leaning back by `lean` [rad].
pub(in crate::follow) fn tip_from_tool(
    robot: &RobotModel,
    tip: LinkId,
    tool: &Tool,
    lean: f64,
) -> Pose {
    let hand_from_tool = match &tool.grip {
        Some(grip) => grip.tool_from_hand.inverse(),
        None => grip_at_rear_edge(tool, lean),
    };
    tip_from_hand(robot, tip) * hand_from_tool
}

/// Returns the pose of the tool in the hand, held at the rear edge of its upper face, with the hand leaning
/// back.
fn grip_at_rear_edge(tool: &Tool, lean: f64) -> Pose {
    let (low, high) = tool.mesh.bounds();
    let turned = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), lean);
    let grasped_in_tool = Vector3::new(low.x, 0.0, high.z);
    turned * Translation3::from(-grasped_in_tool)
}

/// Returns the tool without its rim. It may keep less clearance from the scene than the margin, because the
/// plan already keeps the collision sphere clear, which just contains the tool.
pub(in crate::follow) fn without_rim(mesh: &Mesh, rim: f64) -> Result<Mesh, FollowError> {
    let (low, high) = mesh.bounds();
    let middle = nalgebra::center(&low, &high);
    let size = high - low;
    let share = size.map(|side| ((side - 2.0 * rim) / side.max(f64::MIN_POSITIVE)).max(0.1));
    let vertices = mesh.vertices().iter();
    let vertices = vertices.map(|v| middle + (v - middle).component_mul(&share));
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).map_err(FollowError::Tool)
}

/// Returns the tool without compression: its underside lies below the tool centre point by the depth of its
/// compression in contact.
pub(in crate::follow) fn relax(mesh: &Mesh, compression_depth: f64) -> Result<Mesh, FollowError> {
    let stretched = |v: &Point3| {
        let share = (1.0 - v.z / (2.0 * compression_depth)).clamp(0.0, 1.0);
        Point3::new(v.x, v.y, v.z - compression_depth * share)
    };
    if compression_depth <= 0.0 {
        return Ok(mesh.clone());
    }
    let vertices = mesh.vertices().iter().map(stretched);
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).map_err(FollowError::Tool)
}

/// Returns the largest coordinate of a shape along its link's z axis [m].
fn outermost(collision: &Collision) -> f64 {
    let pose = &collision.link_from_shape;
    let along = |z: f64| (pose * Point3::new(0.0, 0.0, z)).z;
    let axis_z = (pose.rotation * Vector3::z()).z;
    let rim = |radius: f64| radius * (1.0 - axis_z * axis_z).max(0.0).sqrt();
    match &collision.shape {
        Shape::Sphere { radius } => along(0.0) + radius,
        Shape::Capsule { radius, length } => along(length / 2.0).max(along(-length / 2.0)) + radius,
        Shape::Cylinder { radius, length } => {
            along(length / 2.0).max(along(-length / 2.0)) + rim(*radius)
        }
        Shape::Box { size } => {
            let turned = pose.rotation.to_rotation_matrix();
            let half: f64 = (0..3).map(|i| turned[(2, i)].abs() * size[i] / 2.0).sum();
            along(0.0) + half
        }
        Shape::Mesh(mesh) => {
            let heights = mesh.vertices().iter().map(|vertex| (pose * vertex).z);
            heights.fold(f64::NEG_INFINITY, f64::max)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_at_rest_hangs_as_low_as_it_is_compressed_when_it_wipes() {
        let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap();
        let (low, high) = sponge.bounds();
        let (low_at_rest, high_at_rest) = relax(&sponge, 0.005).unwrap().bounds();
        assert!(
            (low.z - low_at_rest.z - 0.005).abs() < 1e-12,
            "{low_at_rest}"
        );
        assert_eq!((high, low.xy()), (high_at_rest, low_at_rest.xy()));
        assert_eq!(relax(&sponge, 0.0).unwrap(), sponge);
    }
}
