//! Task error of the inverse kinematics.

use super::RotationGoal;
use crate::geometry::{Pose, Vector3};
use nalgebra::{UnitQuaternion, Vector6};

/// Target of a descent.
pub(super) struct Target {
    pub(super) base_from_tool: Pose,
    pub(super) goal: RotationGoal,
}

/// Remaining error, in the axes of the base.
#[derive(Debug, Clone, Copy)]
pub(super) struct TaskError {
    /// Vector from the tool centre point to its target [m].
    pub(super) position: Vector3,
    /// Rotation vector from the tool to its target [rad], of the rotations that count.
    pub(super) rotation: Vector3,
}

impl Target {
    /// Returns the error of a tool at `base_from_tool`.
    pub(super) fn error(&self, base_from_tool: &Pose) -> TaskError {
        let target = &self.base_from_tool;
        TaskError {
            position: target.translation.vector - base_from_tool.translation.vector,
            rotation: match self.goal {
                RotationGoal::Full => {
                    rotation_vector(&(target.rotation * base_from_tool.rotation.inverse()))
                }
                RotationGoal::AboutToolZFree => swing(
                    &(base_from_tool.rotation * Vector3::z()),
                    &(target.rotation * Vector3::z()),
                ),
            },
        }
    }
}

impl TaskError {
    /// Position error, then rotation error.
    pub(super) fn vector(&self) -> Vector6<f64> {
        let (p, r) = (&self.position, &self.rotation);
        Vector6::new(p.x, p.y, p.z, r.x, r.y, r.z)
    }

    pub(super) fn squared(&self) -> f64 {
        self.position.norm_squared() + self.rotation.norm_squared()
    }
}

/// Returns the rotation vector, axis times angle of at most π: the logarithm, accurate for small angles and near π.
pub(super) fn rotation_vector(rotation: &UnitQuaternion<f64>) -> Vector3 {
    let half = if rotation.w < 0.0 {
        -rotation.coords
    } else {
        rotation.coords
    };
    let (imaginary, real) = (half.xyz(), half.w);
    let sine = imaginary.norm();
    // The limit of 2 atan(x) / x at zero is 2.
    let scale = if sine > 0.0 {
        2.0 * sine.atan2(real) / sine
    } else {
        2.0
    };
    scale * imaginary
}

/// Returns the shortest rotation vector that takes one unit vector to another.
pub(super) fn swing(from: &Vector3, to: &Vector3) -> Vector3 {
    let product = from.cross(to);
    // For nearly opposite directions the product is mostly rounding error, so its part along `from` is removed.
    let normal = product - from.dot(&product) * from;
    let (sine, cosine) = (normal.norm(), from.dot(to));
    if sine > 0.0 {
        return (sine.atan2(cosine) / sine) * normal;
    }
    if cosine > 0.0 {
        return Vector3::zeros();
    }
    // For opposite directions any perpendicular axis is correct.
    let across = from.cross(&Vector3::ith(from.iamin(), 1.0));
    across.normalize() * std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn unit() -> impl Strategy<Value = Vector3> {
        let part = || -1.0..1.0;
        [part(), part(), part()]
            .prop_map(Vector3::from)
            .prop_filter("long enough to normalize", |v| v.norm() > 1e-3)
            .prop_map(|v| v.normalize())
    }

    /// Angles of all sizes, many of them near 0 and π.
    fn angle() -> impl Strategy<Value = f64> {
        let tiny = || (-16.0..0.0).prop_map(|e| 10f64.powf(e));
        prop_oneof![0.0..PI, tiny(), tiny().prop_map(|a| PI - a)]
    }

    proptest! {
        #[test]
        fn the_rotation_vector_keeps_all_digits(axis in unit(), angle in angle()) {
            let (sine, cosine) = (0.5 * angle).sin_cos();
            let v = sine * axis;
            let rotation = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(cosine, v.x, v.y, v.z));
            let opposite = UnitQuaternion::new_unchecked(-rotation.into_inner());
            let expected = angle * axis;
            for q in [rotation, opposite] {
                let found = rotation_vector(&q);
                // At π the two directions are the same rotation.
                let off = (found - expected).norm().min((found + expected).norm() + 2.0 * (PI - angle));
                prop_assert!(off <= 1e-14 * angle, "{found} for {expected}");
            }
        }

        #[test]
        fn the_swing_turns_one_direction_into_the_other(from in unit(), axis in unit(), angle in angle()) {
            let across = from.cross(&axis);
            prop_assume!(across.norm() > 1e-3);
            let across = UnitQuaternion::from_axis_angle(&nalgebra::Unit::new_normalize(across), angle);
            let to = across * from;
            let found = swing(&from, &to);
            prop_assert!(found.dot(&from).abs() < 1e-14 * PI);
            prop_assert!((found.norm() - angle).abs() < 1e-14);
            prop_assert!((UnitQuaternion::from_scaled_axis(found) * from - to).norm() < 1e-14);
        }
    }

    #[test]
    fn no_turn_is_zero_and_the_opposite_direction_is_half_a_turn_away() {
        assert_eq!(
            rotation_vector(&UnitQuaternion::identity()),
            Vector3::zeros()
        );
        for from in [Vector3::x(), Vector3::y(), Vector3::z()] {
            assert_eq!(swing(&from, &from), Vector3::zeros());
            let half = swing(&from, &-from);
            assert_eq!((half.dot(&from), half.norm()), (0.0, PI));
        }
    }
}
