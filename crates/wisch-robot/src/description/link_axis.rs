//! Axes of links, along which tools are held.

use crate::geometry::Pose;
use nalgebra::{Translation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// An axis of a link's frame, in either direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LinkAxis {
    /// Along x, as in many humanoids and service robots.
    X,
    /// Against x.
    NegativeX,
    /// Along y.
    Y,
    /// Against y.
    NegativeY,
    /// Along z, as in the frames `tool0` and `flange` of industrial arms.
    #[default]
    Z,
    /// Against z.
    NegativeZ,
}

impl LinkAxis {
    /// All axes of a link, in the order of the variants.
    pub const ALL: [Self; 6] = [
        Self::X,
        Self::NegativeX,
        Self::Y,
        Self::NegativeY,
        Self::Z,
        Self::NegativeZ,
    ];

    /// Name of the axis, as files have it: "x" or "-x".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::NegativeX => "-x",
            Self::Y => "y",
            Self::NegativeY => "-y",
            Self::Z => "z",
            Self::NegativeZ => "-z",
        }
    }

    /// Returns the axis of a name; `None` for any other text.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|axis| axis.as_str() == name)
    }

    /// Returns the frame at the link's origin whose z axis is this axis.
    ///
    /// ```
    /// use wisch_robot::LinkAxis;
    /// let z = LinkAxis::NegativeX.frame() * nalgebra::Point3::new(0.0, 0.0, 1.0);
    /// assert!((z.coords - nalgebra::Vector3::new(-1.0, 0.0, 0.0)).norm() < 1e-12);
    /// ```
    pub fn frame(self) -> Pose {
        let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
        let rotation = match self {
            Self::X => about(Vector3::y_axis(), FRAC_PI_2),
            Self::NegativeX => about(Vector3::y_axis(), -FRAC_PI_2),
            Self::Y => about(Vector3::x_axis(), -FRAC_PI_2),
            Self::NegativeY => about(Vector3::x_axis(), FRAC_PI_2),
            Self::Z => UnitQuaternion::identity(),
            Self::NegativeZ => about(Vector3::x_axis(), PI),
        };
        Pose::from_parts(Translation3::identity(), rotation)
    }
}

impl std::fmt::Display for LinkAxis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}
