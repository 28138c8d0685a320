//! The quality of measured wrenches, as a driver states it.

/// Quality of a measured wrench, as the driver states it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum WrenchQuality {
    /// It is a new measurement within the sensor's range.
    #[default]
    Ok,
    /// It repeats an earlier measurement.
    Stale,
    /// A part of it is at the end of the sensor's range.
    Saturated,
    /// The sensor was not tared since it was started, or since its load changed.
    Untared,
}

impl WrenchQuality {
    /// All qualities, in the order of the variants.
    pub const ALL: [Self; 4] = [Self::Ok, Self::Stale, Self::Saturated, Self::Untared];

    /// Name of the quality, as files and messages have it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Stale => "stale",
            Self::Saturated => "saturated",
            Self::Untared => "untared",
        }
    }

    /// Whether the wrench shows what the tool touches.
    pub fn is_usable(self) -> bool {
        self == Self::Ok
    }
}

/// Numbers of samples whose wrench is not usable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct UnusableWrenches {
    /// Repetitions of earlier measurements.
    pub stale: usize,
    /// Measurements at the end of the sensor's range.
    pub saturated: usize,
    /// Measurements of a sensor that was not tared.
    pub untared: usize,
    /// Measurements whose pose repeats an earlier one although the force changes.
    pub frozen_pose: usize,
    /// Measurements before the first pose or after the last, with forces that change as in contact.
    pub missing_pose: usize,
}

impl UnusableWrenches {
    /// Counts one sample.
    pub const fn add(&mut self, quality: WrenchQuality) {
        match quality {
            WrenchQuality::Ok => {}
            WrenchQuality::Stale => self.stale += 1,
            WrenchQuality::Saturated => self.saturated += 1,
            WrenchQuality::Untared => self.untared += 1,
        }
    }

    /// Returns the share of a log \[1\] of which the touch is lost, if these samples are a `share` of it.
    ///
    /// A sensor is untared until it is tared, usually before it first touches: untared samples count as lost touch only if
    /// they are most of the log.
    pub fn lost_share(&self, share: f64) -> f64 {
        let untared = share * self.untared as f64 / self.count().max(1) as f64;
        if untared > 0.5 {
            share
        } else {
            share - untared
        }
    }

    /// Number of all these samples.
    pub const fn count(&self) -> usize {
        self.stale + self.saturated + self.untared + self.frozen_pose + self.missing_pose
    }
}

#[cfg(test)]
mod tests {
    use super::UnusableWrenches;

    #[test]
    fn an_approach_with_an_untared_sensor_loses_no_touch() {
        let of = |stale, untared| UnusableWrenches {
            stale,
            untared,
            ..UnusableWrenches::default()
        };
        assert_eq!(of(0, 300).lost_share(0.3), 0.0);
        assert!((of(100, 200).lost_share(0.3) - 0.1).abs() < 1e-12);
        assert_eq!(of(0, 900).lost_share(0.9), 0.9);
    }
}
