//! Corrections of a force sensor: its bias, its scale, and the weight of the payload behind it.

use super::error::ReadFault;
use super::options::LogOptions;
use wisch::geometry::Vector3;

/// Acceleration of free fall [m/s²], along the world's −z.
const FREE_FALL: f64 = 9.806_65;

/// Correction of measured forces.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Correction {
    /// Bias, in the axes and with the sign of the measured force [N].
    bias: Vector3,
    /// Factor on the force without bias [1].
    scale: f64,
    /// Weight of the payload behind the sensor, in the task's world [N].
    weight: Vector3,
    /// Remarks on the corrections that apply.
    pub remarks: Vec<String>,
}

impl Correction {
    /// Returns the correction that the options state.
    ///
    /// # Errors
    /// If a number is not finite or out of its range.
    pub fn from_options(options: &LogOptions) -> Result<Self, ReadFault> {
        let mut remarks = Vec::new();
        if let Some(bias) = options.force_bias {
            check("--force-bias", bias.as_slice(), FINITE, f64::is_finite)?;
            remarks.push(format!(
                "by --force-bias, ({}, {}, {}) N are subtracted from the measured force, in its own axes",
                bias.x, bias.y, bias.z
            ));
        }
        if let Some(scale) = options.force_scale {
            let is_scale = |scale: f64| scale.is_finite() && scale > 0.0;
            check("--force-scale", &[scale], "finite and above 0", is_scale)?;
            remarks.push(format!(
                "by --force-scale, the measured force is multiplied by {scale}"
            ));
        }
        let mut weight = Vector3::zeros();
        if let Some(payload) = &options.payload {
            let is_mass = |mass: f64| mass.is_finite() && mass >= 0.0;
            let (mass, centre) = (payload.mass, payload.centre);
            check("--payload-mass", &[mass], "finite and at least 0", is_mass)?;
            check(
                "--payload-centre",
                centre.as_slice(),
                FINITE,
                f64::is_finite,
            )?;
            weight = Vector3::z() * (-FREE_FALL * mass);
            remarks.push(format!(
                "by --payload-mass, the weight of {mass} kg behind the sensor is subtracted from the force, rotated by each pose: {:.2} N along the world's -z",
                weight.norm()
            ));
            if centre != Vector3::zeros() {
                remarks.push(
                    "--payload-centre is not used: it affects torques only, which are not read"
                        .to_owned(),
                );
            }
        }
        Ok(Self {
            bias: options.force_bias.unwrap_or_else(Vector3::zeros),
            scale: options.force_scale.unwrap_or(1.0),
            weight,
            remarks,
        })
    }

    /// Returns the force without bias and scaled [N], in the same axes and with the same sign: (F − b) · s.
    pub fn remove_bias(&self, measured: Vector3) -> Vector3 {
        (measured - self.bias) * self.scale
    }

    /// Subtracts the payload's weight from a force on the tool in the task's world [N].
    pub fn without_weight(&self, force: Vector3) -> Vector3 {
        force - self.weight
    }
}

const FINITE: &str = "finite";

fn check(
    option: &'static str,
    numbers: &[f64],
    limit: &'static str,
    is_right: impl Fn(f64) -> bool,
) -> Result<(), ReadFault> {
    match numbers.iter().find(|&&number| !is_right(number)) {
        Some(&value) => Err(ReadFault::Option {
            option,
            value,
            limit,
        }),
        None => Ok(()),
    }
}
