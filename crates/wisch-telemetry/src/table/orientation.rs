//! Orientations from the numbers in logs.

use crate::options::OrientationForm;
use crate::quantity::{Quantity, QuantityError, check_finite};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use wisch::geometry::{Pose, Vector3};

/// Largest deviation of a matrix from a rotation [1]: logs round to a few digits.
const MATRIX_TOLERANCE: f64 = 0.02;
/// Largest deviation of the zeros of a homogeneous matrix [1].
const ZERO: f64 = 1e-6;

impl OrientationForm {
    /// This crate's names of its numbers.
    pub(super) const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Quaternion => &["qx", "qy", "qz", "qw"],
            Self::RotationVector => &["rx", "ry", "rz"],
            Self::RollPitchYaw => &["roll", "pitch", "yaw"],
            Self::Abc => &["a", "b", "c"],
            Self::Matrix => &[
                "m0", "m1", "m2", "m3", "m4", "m5", "m6", "m7", "m8", "m9", "m10", "m11", "m12",
                "m13", "m14", "m15",
            ],
        }
    }
}

/// Returns the pose with a position [m] and the numbers of an orientation, with angles in radians.
pub(super) fn pose(form: OrientationForm, numbers: &[f64]) -> Result<Pose, QuantityError> {
    let (position, turn) = numbers.split_at(3);
    check_finite(Pose::NUMBERS, position)?;
    check_finite(form.names(), turn)?;
    let rotation = match (form, turn) {
        (OrientationForm::Quaternion, _) => return Pose::from_numbers(numbers),
        (OrientationForm::RotationVector, &[x, y, z]) => {
            UnitQuaternion::from_scaled_axis(Vector3::new(x, y, z))
        }
        (OrientationForm::RollPitchYaw, &[roll, pitch, yaw]) => {
            UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        }
        // R = Rz(a) Ry(b) Rx(c).
        (OrientationForm::Abc, &[a, b, c]) => UnitQuaternion::from_euler_angles(c, b, a),
        (_, columns) => rotation_of(columns)?,
    };
    let position = Vector3::new(position[0], position[1], position[2]);
    Ok(Pose::from_parts(position.into(), rotation))
}

/// Returns the rotation in a homogeneous matrix, column by column.
fn rotation_of(columns: &[f64]) -> Result<UnitQuaternion<f64>, QuantityError> {
    if [3, 7, 11].iter().any(|&k| columns[k].abs() > ZERO) {
        return Err(QuantityError::MatrixRows);
    }
    let column = |k: usize| Vector3::from_row_slice(&columns[4 * k..4 * k + 3]);
    let matrix = Matrix3::from_columns(&[column(0), column(1), column(2)]);
    let deviation = (matrix.transpose() * matrix - Matrix3::identity()).amax();
    if deviation > MATRIX_TOLERANCE || matrix.determinant() < 0.0 {
        return Err(QuantityError::Matrix { deviation });
    }
    let rotation = Rotation3::from_matrix_eps(&matrix, 1e-12, 100, Rotation3::identity());
    Ok(UnitQuaternion::from_rotation_matrix(&rotation))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A rotation about x by c, then about y by b, then about z by a, in every form that can state it.
        #[test]
        fn every_form_states_the_same_rotation(a in -3.0..3.0, b in -1.5..1.5, c in -3.0..3.0) {
            let about = |axis: Vector3, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
            let turn = about(Vector3::z(), a) * about(Vector3::y(), b) * about(Vector3::x(), c);
            let matrix = Pose::from_parts(Vector3::new(1.0, 2.0, 3.0).into(), turn).to_homogeneous();
            let quaternion = turn.coords.as_slice().to_vec();
            let forms = [
                (OrientationForm::Quaternion, quaternion),
                (OrientationForm::RotationVector, turn.scaled_axis().as_slice().to_vec()),
                (OrientationForm::RollPitchYaw, vec![c, b, a]),
                (OrientationForm::Abc, vec![a, b, c]),
                (OrientationForm::Matrix, matrix.as_slice().to_vec()),
            ];
            for (form, numbers) in forms {
                prop_assert_eq!(numbers.len(), form.names().len());
                let pose = pose(form, &[&[1.0, 2.0, 3.0], &numbers[..]].concat()).unwrap();
                prop_assert!(pose.rotation.angle_to(&turn) < 1e-7, "{:?}", form);
                prop_assert_eq!(pose.translation.vector, Vector3::new(1.0, 2.0, 3.0));
            }
        }
    }

    #[test]
    fn a_matrix_row_by_row_is_refused() {
        let matrix = Pose::translation(0.4, 0.0, 0.2)
            .to_homogeneous()
            .transpose();
        let numbers = [&[0.0; 3], matrix.as_slice()].concat();
        let refused = pose(OrientationForm::Matrix, &numbers).unwrap_err();
        assert!(matches!(refused, QuantityError::MatrixRows), "{refused}");
    }

    #[test]
    fn a_matrix_that_is_not_a_rotation_is_refused() {
        let mut matrix = Pose::identity().to_homogeneous();
        matrix[(0, 0)] = -1.0;
        let numbers = [&[0.0; 3], matrix.as_slice()].concat();
        let mirrored = pose(OrientationForm::Matrix, &numbers).unwrap_err();
        assert!(
            mirrored.to_string().contains("is not a rotation"),
            "{mirrored}"
        );
    }
}
