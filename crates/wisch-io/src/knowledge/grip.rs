//! The records of a tool's grips.

use serde::Deserialize;
use toml::Spanned;

use super::KnowledgeFileError;
use super::source::{ANGLE_RAD, Limits, POINT_M, Source, UNIT_NORM};
use nalgebra::{Translation3, Unit, UnitQuaternion};
use std::f64::consts::FRAC_PI_2;
use std::ops::Bound::Included;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::represent::{Grip, SecondGrip};

/// Limits of a hand's lean on a bar [rad]: 0 is across the bar, a right angle along it.
const LEAN_RAD: Limits = (Included(0.0), Included(FRAC_PI_2));

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GripRecord {
    point_m: Spanned<[f64; 3]>,
    hand_rpy_rad: Spanned<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SecondGripRecord {
    point_m: Spanned<[f64; 3]>,
    axis_in_tool: Spanned<[f64; 3]>,
    max_lean_rad: Spanned<f64>,
}

impl Source<'_> {
    pub(super) fn grip(self, record: &GripRecord) -> Result<Grip, KnowledgeFileError> {
        let [roll, pitch, yaw] = self.each("hand_rpy_rad", &record.hand_rpy_rad, ANGLE_RAD)?;
        let point = Point3::from(self.each("point_m", &record.point_m, POINT_M)?);
        Ok(Grip {
            tool_from_hand: Pose::from_parts(
                Translation3::from(point),
                UnitQuaternion::from_euler_angles(roll, pitch, yaw),
            ),
        })
    }

    pub(super) fn second_grip(
        self,
        record: &SecondGripRecord,
    ) -> Result<SecondGrip, KnowledgeFileError> {
        let axis = Vector3::from(*record.axis_in_tool.get_ref());
        let at = self.place(&record.axis_in_tool);
        self.within("length of axis_in_tool", at, axis.norm(), UNIT_NORM)?;
        Ok(SecondGrip {
            point_in_tool: Point3::from(self.each("point_m", &record.point_m, POINT_M)?),
            axis_in_tool: Unit::new_normalize(axis),
            max_lean: self.number("max_lean_rad", &record.max_lean_rad, LEAN_RAD)?,
        })
    }

    fn each(
        self,
        field: &'static str,
        values: &Spanned<[f64; 3]>,
        limits: Limits,
    ) -> Result<[f64; 3], KnowledgeFileError> {
        for &value in values.get_ref() {
            self.within(field, self.place(values), value, limits)?;
        }
        Ok(*values.get_ref())
    }
}
