//! What the driver has stated about the samples: quality of the wrench, and absolute stamps.

use super::{STAMP, STAMP_CLOCK_NOTE, Telemetry, TelemetryError, WRENCH_QUALITY};
use std::ops::Range;
use wisch::interpret::WrenchQuality;
use wisch::run::{Stamp, StampClock};

impl Telemetry {
    /// Returns the quality of the external wrench in some rows; [`WrenchQuality::Ok`] where it is not stated.
    ///
    /// # Errors
    /// If the file is damaged.
    pub fn wrench_qualities(
        &self,
        rows: Range<usize>,
    ) -> Result<Vec<WrenchQuality>, TelemetryError> {
        if !self.columns().contains(&WRENCH_QUALITY) {
            return Ok(vec![WrenchQuality::Ok; rows.len()]);
        }
        let codes = self.values(WRENCH_QUALITY, rows)?;
        let quality = |code: f64| {
            let is_index = code >= 0.0 && code.fract() == 0.0;
            let known = is_index.then(|| WrenchQuality::ALL.get(code as usize))?;
            known.copied()
        };
        let qualities = codes.into_iter().map(|code| {
            quality(code).ok_or_else(|| TelemetryError::Foreign {
                path: self.path().to_path_buf(),
                what: format!("{WRENCH_QUALITY} {code} is not the index of a quality"),
            })
        });
        qualities.collect()
    }

    /// The clock of the stamps; `None` if no sample has a stamp.
    pub fn stamp_clock(&self) -> Option<StampClock> {
        let name = self.notes().get(STAMP_CLOCK_NOTE)?;
        StampClock::ALL
            .into_iter()
            .find(|clock| clock.as_str() == name)
    }

    /// Returns the absolute stamp of each row, to the nanosecond; `None` where it is not stated.
    ///
    /// # Errors
    /// If the file is damaged.
    pub fn stamps(&self) -> Result<Vec<Option<Stamp>>, TelemetryError> {
        let Some(clock) = self.stamp_clock() else {
            return Ok(vec![None; self.rows()]);
        };
        let stamp = |time: i64| {
            let nanoseconds = u64::try_from(time).ok()?;
            Some(Stamp { nanoseconds, clock })
        };
        let times = self.whole_nanoseconds(STAMP)?;
        Ok(times.into_iter().map(stamp).collect())
    }
}
