//! What is read from a log: poses and forces.

use nalgebra::{Quaternion, UnitQuaternion};
use wisch::geometry::{Pose, Vector3};

/// How far the length of a quaternion may be from 1 before it is no rotation: logs round to some digits.
const QUATERNION_TOLERANCE: f64 = 0.01;

/// Below this sine of half the angle between them, two rotations are as good as one [1].
const SLERP_EPSILON: f64 = 1e-9;

/// Numbers that are no pose or no force.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// A number that is none.
    #[error("{name} is {value}, which is not finite")]
    NotFinite {
        /// What it stands for.
        name: &'static str,
        /// The number.
        value: f64,
    },
    /// A number that is not there.
    #[error("{name} is missing")]
    Missing {
        /// What it stands for.
        name: &'static str,
    },
    /// A matrix that is no rotation.
    #[error(
        "the matrix is no rotation: its columns miss being orthonormal by {deviation}, or mirror"
    )]
    Matrix {
        /// By how much.
        deviation: f64,
    },
    /// A quaternion that is no rotation.
    #[error(
        "the quaternion has a length of {norm}, which is not within {QUATERNION_TOLERANCE} of 1"
    )]
    Quaternion {
        /// Its length.
        norm: f64,
    },
}

/// A pose or a force: what a log says at an instant.
pub(crate) trait Quantity: Sized + Copy + PartialEq {
    /// What it is called in messages to the user.
    const NAME: &'static str;
    /// The numbers that it is made of, in order.
    const NUMBERS: &'static [&'static str];
    /// Where these numbers stand in a ROS message: the path of a message and their paths in it, most likely first.
    const PLACES: &'static [(&'static str, &'static [&'static str])];

    /// The quantity, from as many numbers as it has names.
    fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError>;

    /// Between this (share 0) and another (share 1).
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
        // Half a turn apart there is no way to prefer.
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
        let turned = pose * Vector3::x();
        assert!((turned - Vector3::y()).norm() < 1e-12);
        assert_eq!(pose.translation.vector, Vector3::new(1.0, 2.0, 3.0));
    }

    #[test]
    fn numbers_that_are_no_pose_or_force_are_refused() {
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
    fn poses_are_interpolated_the_short_way() {
        let turned = |angle: f64| Pose::rotation(Vector3::z() * angle);
        let between = turned(0.2).between(&turned(0.6), 0.25);
        assert!((between.rotation.angle() - 0.3).abs() < 1e-12);
        let negated = Pose::from_parts(
            turned(0.6).translation,
            UnitQuaternion::new_unchecked(-turned(0.6).rotation.into_inner()),
        );
        let between = turned(0.2).between(&negated, 0.25);
        assert!((between.rotation.angle() - 0.3).abs() < 1e-12);
    }
}
