//! Names of episodes, and texts of times.

use jiff::Timestamp;
use jiff::tz::TimeZone;

/// Returns the name of an episode that begins at `start` [s since 1970]: date and time (UTC), and
/// `salt` as four hex digits, which distinguish episodes of the same second.
///
/// ```
/// assert_eq!(wisch_memory::episode_id(1_795_309_772.5, 0x3f2a), "20261122-010932-3f2a");
/// ```
pub fn episode_id(start: f64, salt: u16) -> String {
    format!("{}-{salt:04x}", in_utc(start, "%Y%m%d-%H%M%S"))
}

/// Returns date and time (UTC) of a time [s since 1970] as text.
///
/// ```
/// assert_eq!(wisch_memory::date_and_time(1_795_309_772.5), "2026-11-22 01:09:32");
/// ```
pub fn date_and_time(time: f64) -> String {
    in_utc(time, "%Y-%m-%d %H:%M:%S")
}

/// Returns date and time of a time [s since 1970] in the time zone of this machine, with the offset
/// from UTC.
///
/// ```
/// // The time is UTC where no time zone is set.
/// let text = wisch_memory::local_date_and_time(1_795_309_772.5);
/// assert!(text.starts_with("2026-11-2") && text.contains(":32 "), "{text}");
/// ```
pub fn local_date_and_time(time: f64) -> String {
    let zoned = timestamp(time).to_zoned(TimeZone::system());
    zoned.strftime("%Y-%m-%d %H:%M:%S %:z").to_string()
}

/// Earliest start of an episode that counts as a date [s since 1970]: the year 1990. Logs of simulators often count from 0.
const EARLIEST_DATE_S: f64 = 6.3e8;

/// Returns whether a time is a date, and not a count from the start of a log. `time`: seconds since 1970.
///
/// ```
/// assert!(wisch_memory::is_date(1_795_309_772.0));
/// assert!(!wisch_memory::is_date(12.5));
/// ```
pub fn is_date(time: f64) -> bool {
    time >= EARLIEST_DATE_S
}

/// Formats a time [s since 1970] by a `strftime` format (UTC), cut to whole seconds.
pub(crate) fn in_utc(time: f64, format: &str) -> String {
    timestamp(time).strftime(format).to_string()
}

/// Converts a time [s since 1970] to a timestamp, cut to whole seconds and clamped to the calendar's range.
fn timestamp(time: f64) -> Timestamp {
    let seconds = time.floor() as i64;
    let seconds = seconds.clamp(Timestamp::MIN.as_second(), Timestamp::MAX.as_second());
    Timestamp::from_second(seconds).unwrap_or_default()
}
