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

    /// Number of all these samples.
    pub const fn count(&self) -> usize {
        self.stale + self.saturated + self.untared
    }
}
