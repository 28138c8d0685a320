//! Statements of a driver about its samples, as messages: the quality of the wrench, pauses, and
//! absolute stamps.

use crate::ros2::messages::{
    Header, NANOSECONDS_PER_SECOND, RecordedTimeReference, Time, TimeReference,
};
use wisch::interpret::WrenchQuality;
use wisch::run::{SampleStatus, Stamp, StampClock};

/// Word for a sample of a paused motion.
const PAUSED: &str = "paused";

/// Returns quality and pause as text, for a message that holds until the next one.
pub(super) fn to_text(status: &SampleStatus) -> String {
    let quality = status.wrench.as_str();
    if status.is_paused {
        format!("{quality} {PAUSED}")
    } else {
        quality.to_owned()
    }
}

/// Parses the text of [`to_text`]; the status has no stamp.
pub(super) fn from_text(text: &str) -> Result<SampleStatus, String> {
    let (quality, rest) = text.split_once(' ').unwrap_or((text, ""));
    let found = WrenchQuality::ALL
        .into_iter()
        .find(|q| q.as_str() == quality);
    match (found, rest) {
        (Some(wrench), "" | PAUSED) => Ok(SampleStatus {
            stamp: None,
            wrench,
            is_paused: rest == PAUSED,
        }),
        _ => Err(format!("{text:?} is no status of a sample")),
    }
}

/// Returns a stamp as a message. `time`: the sample's time in the log [ns].
pub(super) fn to_message(time: u64, stamp: Stamp) -> TimeReference<'static> {
    TimeReference {
        header: Header {
            stamp: Time::from_nanoseconds(time),
            frame_id: "",
        },
        time_ref: Time::from_nanoseconds(stamp.nanoseconds),
        source: stamp.clock.as_str(),
    }
}

/// Parses the message of [`to_message`].
pub(super) fn from_message(message: &RecordedTimeReference) -> Result<Stamp, String> {
    let name = &message.source;
    let clock = StampClock::ALL.into_iter().find(|c| c.as_str() == name);
    let clock = clock.ok_or_else(|| format!("{name:?} is no clock of stamps"))?;
    let Time { sec, nanosec } = message.time_ref;
    let seconds = u64::try_from(sec).map_err(|_| format!("a stamp of {sec} s is negative"))?;
    Ok(Stamp {
        nanoseconds: seconds * NANOSECONDS_PER_SECOND + u64::from(nanosec),
        clock,
    })
}
