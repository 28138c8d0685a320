//! The quantities whose course over episodes is assessed.

use serde::Serialize;

/// A quantity that a round records, and whose course over episodes is assessed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HealthChannel {
    /// Mean contact force on a surface \[N\], without its sign.
    ContactForce,
    /// Share of the time on the surface with the tool in contact \[1\].
    ContactShare,
    /// Localisation error of a surface along its normal \[m\].
    Offset,
    /// Angle between the surface that was found and the believed one \[rad\].
    Tilt,
    /// Stiffness of a tool [N/m]; its logarithm changes linearly.
    Stiffness,
    /// Estimated performance \[1\].
    Performance,
}

impl HealthChannel {
    /// All channels, in the order of a report.
    pub const ALL: [Self; 6] = [
        Self::ContactForce,
        Self::ContactShare,
        Self::Offset,
        Self::Tilt,
        Self::Stiffness,
        Self::Performance,
    ];

    /// Name of the channel in reports for people.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::ContactForce => "contact force",
            Self::ContactShare => "contact share",
            Self::Offset => "surface offset",
            Self::Tilt => "surface tilt",
            Self::Stiffness => "tool stiffness",
            Self::Performance => "performance",
        }
    }

    /// Unit of the values; 1 stands for a share.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::ContactForce => "N",
            Self::Offset => "m",
            Self::Tilt => "rad",
            Self::Stiffness => "N/m",
            Self::ContactShare | Self::Performance => "1",
        }
    }

    /// Property of a round that holds the value.
    pub(crate) const fn property(self) -> &'static str {
        match self {
            Self::ContactForce => "semco:meanNormalForce",
            Self::ContactShare => "semco:contactShare",
            Self::Offset => "semco:planeOffset",
            Self::Tilt => "semco:planeTilt",
            Self::Stiffness => "semco:toolStiffness",
            Self::Performance => "semco:performance",
        }
    }

    /// Returns the value in the scale of the fit; `None` for a value outside that scale.
    pub(crate) fn scale(self, value: f64) -> Option<f64> {
        let scaled = match self {
            Self::ContactForce => value.abs(),
            Self::Stiffness => value.ln(),
            _ => value,
        };
        scaled.is_finite().then_some(scaled)
    }

    pub(crate) fn unscaled(self, value: f64) -> f64 {
        match self {
            Self::Stiffness => value.exp(),
            _ => value,
        }
    }

    /// Resolution of the values, in the scale of the fit: their least standard deviation, and the least change of a drift.
    pub(crate) const fn resolution(self) -> f64 {
        match self {
            Self::ContactForce => 0.05,
            Self::Offset => 2e-4,
            Self::Tilt => 1e-3,
            Self::Stiffness | Self::ContactShare | Self::Performance => 0.02,
        }
    }

    /// Whether a change in this direction is an improvement. `by`: the change, in the scale of the fit.
    pub(crate) fn is_better(self, by: f64) -> bool {
        match self {
            Self::ContactShare | Self::Performance => by > 0.0,
            Self::Tilt => by < 0.0,
            Self::ContactForce | Self::Offset | Self::Stiffness => false,
        }
    }
}
