//! Frames as rotation matrices for inner loops, and the frame of a joint's axis.

use crate::geometry::{Pose, Vector3};
use nalgebra::UnitQuaternion;

/// Columns of a rotation matrix, and a translation. Their composition is cheaper than that of quaternions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub axes: [Vector3; 3],
    pub translation: Vector3,
}

impl Frame {
    pub fn identity() -> Self {
        Self::from_pose(&Pose::identity())
    }

    pub fn from_pose(pose: &Pose) -> Self {
        let rotation = pose.rotation.to_rotation_matrix().into_inner();
        Self {
            axes: [0, 1, 2].map(|i| rotation.column(i).into()),
            translation: pose.translation.vector,
        }
    }

    #[inline]
    pub fn turn(&self, v: &Vector3) -> Vector3 {
        let [x, y, z] = &self.axes;
        x * v.x + y * v.y + z * v.z
    }

    /// Applies the inverse rotation.
    #[inline]
    pub fn turn_back(&self, v: &Vector3) -> Vector3 {
        let [x, y, z] = &self.axes;
        Vector3::new(x.dot(v), y.dot(v), z.dot(v))
    }

    #[inline]
    pub fn then(&self, next: &Self) -> Self {
        let [x, y, z] = &next.axes;
        Self {
            axes: [self.turn(x), self.turn(y), self.turn(z)],
            translation: self.translation + self.turn(&next.translation),
        }
    }
}

/// Returns the rotation that takes the z axis to this one.
pub fn rotation_from_z(axis: &Vector3) -> UnitQuaternion<f64> {
    UnitQuaternion::rotation_between(&Vector3::z(), axis).unwrap_or_else(|| {
        UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)
    })
}
