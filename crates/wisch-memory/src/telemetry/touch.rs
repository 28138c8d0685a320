//! Telemetry as input for the interpreter.

use super::{POSE, Telemetry, TelemetryError};
use nalgebra::{Quaternion, UnitQuaternion};
use std::ops::Range;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{TouchSample, UnusableWrenches};

impl Telemetry {
    /// Returns the tool poses in the world (columns `measured/…`) and the forces on the tool in the
    /// world's axes (columns `external/f…`) \[N\] of all samples with a usable wrench, and how many
    /// samples have no usable one.
    ///
    /// Numbers have single precision: positions within 1 m are exact to 30 nm, forces within 100 N to 4 µN.
    ///
    /// # Errors
    /// If the telemetry lacks these columns, or the file is damaged.
    pub fn touch_samples(&self) -> Result<(Vec<TouchSample>, UnusableWrenches), TelemetryError> {
        self.touch_samples_of(0..self.rows())
    }

    /// Returns the same as [`Self::touch_samples`], of some rows.
    pub(crate) fn touch_samples_of(
        &self,
        rows: Range<usize>,
    ) -> Result<(Vec<TouchSample>, UnusableWrenches), TelemetryError> {
        let qualities = self.wrench_qualities(rows.clone())?;
        let mut unusable = UnusableWrenches::default();
        for quality in &qualities {
            unusable.add(*quality);
        }
        let column = |name: String| self.values(&name, rows.clone());
        let times = self.times(rows.clone())?;
        let pose: Vec<Vec<f64>> = (POSE.iter())
            .map(|part| column(format!("measured/{part}")))
            .collect::<Result<_, _>>()?;
        let force: Vec<Vec<f64>> = (["fx", "fy", "fz"].iter())
            .map(|part| column(format!("external/{part}")))
            .collect::<Result<_, _>>()?;
        let sample = |(row, time): (usize, f64)| {
            let [x, y, z, qx, qy, qz, qw] =
                [0, 1, 2, 3, 4, 5, 6].map(|part: usize| pose[part][row]);
            TouchSample {
                time,
                world_from_tool: Pose::from_parts(
                    [x, y, z].into(),
                    UnitQuaternion::from_quaternion(Quaternion::new(qw, qx, qy, qz)),
                ),
                force: Vector3::new(force[0][row], force[1][row], force[2][row]),
            }
        };
        let usable = (times.into_iter().enumerate()).filter(|(row, _)| qualities[*row].is_usable());
        Ok((usable.map(sample).collect(), unusable))
    }
}
