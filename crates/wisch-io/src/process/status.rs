//! What an executor states about its samples and its motion.

use serde::Deserialize;
use wisch::interpret::WrenchQuality;
use wisch::run::StampClock;
use wisch::source_location::UnknownName;

/// Quality of a measured wrench, as an executor writes it in a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(try_from = "String")]
pub struct WrenchQualityRecord(pub WrenchQuality);

impl TryFrom<String> for WrenchQualityRecord {
    type Error = UnknownName;

    fn try_from(name: String) -> Result<Self, UnknownName> {
        let found = WrenchQuality::ALL.into_iter().find(|q| q.as_str() == name);
        found.map(Self).ok_or_else(|| {
            let known = WrenchQuality::ALL.map(WrenchQuality::as_str);
            UnknownName::new("quality of a wrench", &name, known)
        })
    }
}

/// The clock of an executor's stamps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct StampClockRecord(pub StampClock);

impl TryFrom<String> for StampClockRecord {
    type Error = UnknownName;

    fn try_from(name: String) -> Result<Self, UnknownName> {
        let found = StampClock::ALL.into_iter().find(|c| c.as_str() == name);
        found.map(Self).ok_or_else(|| {
            let known = StampClock::ALL.map(StampClock::as_str);
            UnknownName::new("clock of stamps", &name, known)
        })
    }
}

/// The start of a pause, as an executor reports it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PauseRecord {
    /// Time since the start of the motion \[s\].
    pub time_s: f64,
    /// Cause; may be empty.
    #[serde(default)]
    pub reason: String,
}

/// The end of a pause, as an executor reports it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ResumeRecord {
    /// Time since the start of the motion \[s\].
    pub time_s: f64,
}
