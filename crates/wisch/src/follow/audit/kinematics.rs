//! Forward kinematics of the audit: rotation matrices by Rodrigues' formula, link by link up to the root.

use crate::geometry::{Point3, Pose, Vector3};
use crate::robot::{Joint, JointKind, LinkId, RobotModel};
use nalgebra::Matrix3;

/// A frame: the columns of its rotation matrix and its origin, in another frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub rotation: Matrix3<f64>,
    pub origin: Vector3,
}

impl Frame {
    pub fn identity() -> Self {
        Self {
            rotation: Matrix3::identity(),
            origin: Vector3::zeros(),
        }
    }

    pub fn from_pose(pose: &Pose) -> Self {
        Self {
            rotation: *pose.rotation.to_rotation_matrix().matrix(),
            origin: pose.translation.vector,
        }
    }

    /// Returns the frame rotated by an angle [rad] about an axis through the origin.
    pub fn rotate_about(axis: &Vector3, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            // Rodrigues: R = cos φ I + (1 − cos φ) a aᵀ + sin φ [a]×.
            rotation: Matrix3::identity() * cos
                + axis * axis.transpose() * (1.0 - cos)
                + axis.cross_matrix() * sin,
            origin: Vector3::zeros(),
        }
    }

    /// Composes two frames: `a_from_b.then(b_from_c)` is `a_from_c`.
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation * inner.rotation,
            origin: self.rotation * inner.origin + self.origin,
        }
    }

    /// Transforms a point from this frame to the outer frame.
    pub fn point(&self, inner: &Point3) -> Vector3 {
        self.rotation * inner.coords + self.origin
    }

    /// Returns the rotation vector from this frame's orientation to another's [rad], in this frame.
    pub fn rotation_to(&self, other: &Self) -> Vector3 {
        let turn = self.rotation.transpose() * other.rotation;
        let twice_sine = Vector3::new(
            turn[(2, 1)] - turn[(1, 2)],
            turn[(0, 2)] - turn[(2, 0)],
            turn[(1, 0)] - turn[(0, 1)],
        );
        let norm = twice_sine.norm();
        if norm == 0.0 {
            return twice_sine;
        }
        // For a rotation by φ, |twice_sine| = 2 sin φ and trace − 1 = 2 cos φ.
        twice_sine * (norm.atan2(turn.trace() - 1.0) / norm)
    }
}

/// Returns the frame of a joint's child in its parent, at the positions of all n variables [rad or m].
pub(super) fn moved_by(joint: &Joint, q: &[f64]) -> Frame {
    let terms = joint.drive.terms.iter();
    let position = joint.drive.offset + terms.map(|(i, factor)| factor * q[*i]).sum::<f64>();
    let moved = match joint.kind {
        JointKind::Fixed => Frame::identity(),
        JointKind::Revolute => Frame::rotate_about(&joint.axis, position),
        JointKind::Prismatic => Frame {
            rotation: Matrix3::identity(),
            origin: joint.axis.into_inner() * position,
        },
    };
    Frame::from_pose(&joint.parent_from_joint).then(&moved)
}

/// Returns the frame of a link in the robot's root, at the positions of all n variables [rad or m].
pub(super) fn root_from_link(robot: &RobotModel, link: LinkId, q: &[f64]) -> Frame {
    let mut at = link;
    let mut above_from_link = Frame::identity();
    while let Some(joint) = robot.links()[at.index()].parent {
        let joint = &robot.joints()[joint.index()];
        above_from_link = moved_by(joint, q).then(&above_from_link);
        at = joint.parent;
    }
    above_from_link
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tilted slide and a mimic revolute joint that counts the slide twice.
    const BENT: &str = r#"<robot name="bent"><link name="wall"/><link name="slide"/><link name="arm"/><link name="tip"/>
        <joint name="out" type="prismatic"><parent link="wall"/><child link="slide"/><axis xyz="0 0 1"/>
          <origin xyz="0 1 0" rpy="1.5707963267948966 0 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
        <joint name="turn" type="revolute"><parent link="slide"/><child link="arm"/><axis xyz="0 0 1"/>
          <mimic joint="out" multiplier="2" offset="0.5"/><limit lower="-4" upper="4" velocity="1" effort="1"/></joint>
        <joint name="end" type="fixed"><parent link="arm"/><child link="tip"/><origin xyz="0.5 0 0"/></joint>
        </robot>"#;

    #[test]
    fn a_bent_slide_and_a_turn_are_where_geometry_says() {
        let robot = RobotModel::from_urdf("bent", BENT, &mut |_| Err(String::new())).unwrap();
        let tip = robot.link("tip").unwrap();
        let frame = root_from_link(&robot, tip, &[0.2]);
        // The slide's z axis is the wall's −y; the arm turns by 2 · 0.2 + 0.5 about it.
        let (sin, cos) = 0.9_f64.sin_cos();
        let expected = Vector3::new(0.5 * cos, 1.0 - 0.2, 0.5 * sin);
        assert!((frame.origin - expected).norm() < 1e-12, "{frame:?}");
        let axis = Vector3::new(cos, 0.0, sin);
        assert!((frame.rotation * Vector3::x() - axis).norm() < 1e-12);
    }

    #[test]
    fn the_rotation_from_a_frame_to_another_is_what_turned_it() {
        let from = Frame::rotate_about(&Vector3::y(), 0.4);
        for angle in [0.0, 1e-9, -0.3, 3.0] {
            let to = from.then(&Frame::rotate_about(&Vector3::x(), angle));
            let turn = from.rotation_to(&to);
            assert!((turn - Vector3::x() * angle).norm() < 1e-12, "{turn}");
        }
    }
}
