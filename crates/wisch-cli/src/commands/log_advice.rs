//! Errors of logs that cannot be read, with advice.

use crate::failure::Failure;
use std::path::Path;
use wisch_telemetry::{ReadError, ReadFault, RecordingKind};

/// Longest delay of a message for which a wider window may be the remedy [s]; a counter that begins anew goes back by more.
const LONGEST_DELAY: f64 = 600.0;

/// Returns the error of a log that cannot be read, with advice if there is some.
pub(super) fn log_failure(error: ReadError, log: &Path) -> Failure {
    let advice = advice(&error.fault, log);
    let failure = Failure::new(error);
    match advice {
        Some(advice) => failure.with_help(advice),
        None => failure,
    }
}

/// Returns advice for a log that cannot be read.
fn advice(fault: &ReadFault, log: &Path) -> Option<String> {
    Some(match fault {
        ReadFault::Several { what, .. } => format!("choose one with --{what}-topic"),
        ReadFault::Nothing { what, unread, .. } if unread.is_empty() => {
            format!("choose a field of a larger message with --{what}-topic TOPIC:FIELD, or compute the pose from /joint_states with --urdf")
        }
        ReadFault::Nothing { .. } | ReadFault::Encoding { .. } => {
            "wisch reads ROS 2 messages only (cdr with ros2msg schemas): record the topics with ros2 bag record -s mcap, or export poses and forces as a table (CSV) with PlotJuggler or Foxglove".to_owned()
        }
        ReadFault::Truncated { .. } => {
            "append .active to the file name to read the complete part".to_owned()
        }
        ReadFault::TooEarly { byte: None, .. } => {
            "check what was recorded with ros2 bag info".to_owned()
        }
        ReadFault::TooEarly { messages: 0, .. } => {
            "a bag is readable chunk by chunk (of wisch run: one per second): wait for its first complete chunk, or copy the whole file".to_owned()
        }
        ReadFault::TooEarly { what, .. } => {
            format!("its first {what} may come later in the recording: wait for it, or copy the whole file")
        }
        ReadFault::OtherRecording {
            kind: RecordingKind::Sqlite | RecordingKind::Ros1,
        } => {
            let converted = log.with_extension("converted");
            format!(
                "convert it (pip install rosbags): rosbags-convert --src {} --dst {} --dst-storage mcap",
                log.display(),
                converted.display()
            )
        }
        ReadFault::OtherRecording { kind } => match kind {
            RecordingKind::Gzip => format!("unpack it first: gunzip --keep {}", log.display()),
            RecordingKind::Utf16 => {
                "save it as text in UTF-8, in a spreadsheet program as \"CSV UTF-8\"".to_owned()
            }
            _ => "write it as a table in CSV, Parquet or npz".to_owned(),
        },
        ReadFault::Compression { .. } => "recompress it with mcap compress --compression lz4".to_owned(),
        ReadFault::Apart { .. } => "see --max-gap-s".to_owned(),
        ReadFault::Unknown(error) if error.kind == "column" => {
            "name the columns with --csv-columns".to_owned()
        }
        ReadFault::NoTime { .. } | ReadFault::SameTime { .. } => {
            "give the sampling rate with --rate HZ, or the time column with --csv-columns t=NAME".to_owned()
        }
        ReadFault::SeveralColumns { .. } | ReadFault::DuplicateColumn { .. } => {
            "choose one with --csv-columns OURS=THEIRS".to_owned()
        }
        ReadFault::ValueCount { count, names, .. } if count > names => {
            "put values that contain separators in quotes (\"[1, 2]\")".to_owned()
        }
        ReadFault::Backwards { time, last, .. } if last - time > LONGEST_DELAY => {
            "no message is delayed for that long: add the missing days to times of day after midnight, or the range of a counter that has begun anew to its later times, or split a file that holds two logs".to_owned()
        }
        ReadFault::Backwards { .. } => {
            "allow longer delays with --reorder-s SECONDS, use a bag's recording times with --time log, or split a file that holds two logs".to_owned()
        }
        ReadFault::SeveralFrames { .. } => {
            "record each of them on a topic of its own, or filter the bag by frame_id".to_owned()
        }
        ReadFault::ClockSetBack { .. } => {
            "split the file where the clock was set back, and interpret each part, or use a bag's recording times with --time log".to_owned()
        }
        ReadFault::Time { .. } => {
            "set the unit with --time-unit-s, such as 1e-9 for nanoseconds".to_owned()
        }
        ReadFault::StillFrame { .. } => {
            "choose another frame with --pose-topic /tf:FRAME".to_owned()
        }
        ReadFault::BesideUnread { .. } => {
            "write one column per number, or name the columns with --csv-columns".to_owned()
        }
        ReadFault::Table { .. } | ReadFault::ColumnType { .. } => {
            "export the table again, or as text (CSV)".to_owned()
        }
        ReadFault::TooManyRows { .. } | ReadFault::Unpacked { .. } => {
            "split the log, or reduce its sampling rate".to_owned()
        }
        ReadFault::NoArrow => {
            "export it as Parquet (DataFrame.to_parquet in pandas), or build wisch with --features arrow".to_owned()
        }
        ReadFault::NoFile { .. } => "write it to a file first".to_owned(),
        _ => return None,
    })
}
