//! Quantities of a log: poses and forces.

use nalgebra::{Quaternion, UnitQuaternion};
use wisch::geometry::{Pose, Vector3};

/// Largest deviation of a quaternion's norm from 1 [1]: logs round to a few digits.
const QUATERNION_TOLERANCE: f64 = 0.01;

/// Sine of half the angle between two rotations below which they count as equal [1].
const SLERP_EPSILON: f64 = 1e-9;

/// A reason why numbers are not a pose or a force.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// A number is not finite.
    #[error("{name} is {value}, which is not finite")]
    NotFinite {
        /// Name of the number.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is missing.
    #[error("{name} is missing")]
    Missing {
        /// Name of the number.
        name: &'static str,
    },
    /// A matrix is not a rotation.
    #[error(
        "the matrix is not a rotation: its columns deviate from orthonormal by {deviation}, or it mirrors"
    )]
    Matrix {
        /// Largest deviation of its columns from orthonormal \[1\].
        deviation: f64,
    },
    /// A matrix is written row by row.
    #[error(
        "the matrix is not homogeneous column by column: m3, m7 and m11 are not 0; if it is written row by row, write it column by column, with the position in m12 to m14"
    )]
    MatrixRows,
    /// A quaternion is not a rotation.
    #[error(
        "the quaternion has a length of {norm}, which is not within {QUATERNION_TOLERANCE} of 1"
    )]
    Quaternion {
        /// Its norm \[1\].
        norm: f64,
    },
}

/// A quantity that a log states at an instant: a pose or a force.
pub(crate) trait Quantity: Sized + Copy + PartialEq {
    /// Name of the quantity in messages to the user.
    const NAME: &'static str;
    /// Names of its numbers, in order.
    const NUMBERS: &'static [&'static str];
    /// Where the numbers stand in a ROS message: the path of a message and the paths of the numbers in it, the
    /// likeliest first.
    const PLACES: &'static [(&'static str, &'static [&'static str])];

    /// Returns the quantity of the given numbers, which must be as many as [`Self::NUMBERS`].
    fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError>;

    /// Interpolates from this quantity (`share` 0) to `other` (`share` 1).
    fn between(&self, other: &Self, share: f64) -> Self;
}

impl Quantity for Pose {
    const NAME: &'static str = "pose";
    const NUMBERS: &'static [&'static str] = &["x", "y", "z", "qx", "qy", "qz", "qw"];
    const PLACES: &'static [(&'static str, &'static [&'static str])] = &[
        ("pose.pose", POSE_FIELDS),
        ("pose", POSE_FIELDS),
        ("", POSE_FIELDS),
        ("transform", TRANSFORM_FIELDS),
        ("", TRANSFORM_FIELDS),
    ];

    fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError> {
        check_finite(Self::NUMBERS, numbers)?;
        let quaternion = Quaternion::new(numbers[6], numbers[3], numbers[4], numbers[5]);
        let norm = quaternion.norm();
        if (norm - 1.0).abs() > QUATERNION_TOLERANCE {
            return Err(QuantityError::Quaternion { norm });
        }
        let translation = Vector3::new(numbers[0], numbers[1], numbers[2]);
        let rotation = UnitQuaternion::from_quaternion(quaternion);
        Ok(Self::from_parts(translation.into(), rotation))
    }

    fn between(&self, other: &Self, share: f64) -> Self {
        // For rotations half a turn apart, no direction of interpolation is shorter.
        self.try_lerp_slerp(other, share, SLERP_EPSILON)
            .unwrap_or(if share < 0.5 { *self } else { *other })
    }
}

const POSE_FIELDS: &[&str] = &[
    "position.x",
    "position.y",
    "position.z",
    "orientation.x",
    "orientation.y",
    "orientation.z",
    "orientation.w",
];

const TRANSFORM_FIELDS: &[&str] = &[
    "translation.x",
    "translation.y",
    "translation.z",
    "rotation.x",
    "rotation.y",
    "rotation.z",
    "rotation.w",
];

const WRENCH_FIELDS: &[&str] = &["force.x", "force.y", "force.z"];

impl Quantity for Vector3 {
    const NAME: &'static str = "wrench";
    const NUMBERS: &'static [&'static str] = &["fx", "fy", "fz"];
    const PLACES: &'static [(&'static str, &'static [&'static str])] =
        &[("wrench", WRENCH_FIELDS), ("", WRENCH_FIELDS)];

    fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError> {
        check_finite(Self::NUMBERS, numbers)?;
        Ok(Self::new(numbers[0], numbers[1], numbers[2]))
    }

    fn between(&self, other: &Self, share: f64) -> Self {
        self.lerp(other, share)
    }
}

pub(crate) fn check_finite(names: &[&'static str], numbers: &[f64]) -> Result<(), QuantityError> {
    let mut named = names.iter().zip(numbers);
    match named.find(|(_, value)| !value.is_finite()) {
        Some((&name, &value)) => Err(QuantityError::NotFinite { name, value }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_become_a_pose_with_the_quaternion_as_x_y_z_w() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let pose = Pose::from_numbers(&[1.0, 2.0, 3.0, 0.0, 0.0, half, half]).unwrap();
        let axis = pose * Vector3::x();
        assert!((axis - Vector3::y()).norm() < 1e-12);
        assert_eq!(pose.translation.vector, Vector3::new(1.0, 2.0, 3.0));
    }

    #[test]
    fn invalid_poses_and_forces_are_refused() {
        let refused = |numbers: &[f64]| Pose::from_numbers(numbers).unwrap_err().to_string();
        assert_eq!(
            refused(&[0.0; 7]),
            "the quaternion has a length of 0, which is not within 0.01 of 1"
        );
        assert_eq!(
            refused(&[0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0, 1.0]),
            "y is NaN, which is not finite"
        );
        assert!(Vector3::from_numbers(&[f64::INFINITY, 0.0, 0.0]).is_err());
    }

    #[test]
    fn poses_are_interpolated_along_the_shorter_rotation() {
        let rotation = |angle: f64| Pose::rotation(Vector3::z() * angle);
        let between = rotation(0.2).between(&rotation(0.6), 0.25);
        assert!((between.rotation.angle() - 0.3).abs() < 1e-12);
        let negated = Pose::from_parts(
            rotation(0.6).translation,
            UnitQuaternion::new_unchecked(-rotation(0.6).rotation.into_inner()),
        );
        let between = rotation(0.2).between(&negated, 0.25);
        assert!((between.rotation.angle() - 0.3).abs() < 1e-12);
    }
}
