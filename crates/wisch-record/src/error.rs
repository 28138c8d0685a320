//! Why something of a run could not be kept.

use crate::sink::SinkError;
use std::io;
use std::path::PathBuf;
use wisch_memory::MemoryError;
use wisch_telemetry::WriteError;

/// Why something of a run could not be kept.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// The episode cannot be kept.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// A bag cannot be written.
    #[error(transparent)]
    Bag(#[from] WriteError),
    /// The results cannot be written.
    #[error(transparent)]
    Results(#[from] wisch_io::Error),
    /// The file that others read while the run goes on cannot be written.
    #[error("{}: cannot write there: {error}", .place.display())]
    Live {
        /// The file.
        place: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// What a killed run could be resumed with cannot be written.
    #[error("{}: cannot write there: {error}", .place.display())]
    State {
        /// The folder.
        place: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A recording cannot be read.
    #[error("{}: cannot read the recording: {error}", .place.display())]
    Unreadable {
        /// The file.
        place: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A recording is longer than any that is read.
    #[error("{}: the recording is longer than {limit_mib} MiB", .place.display())]
    TooLong {
        /// The file.
        place: PathBuf,
        /// The limit [MiB].
        limit_mib: u64,
    },
    /// A sink that was added ended the run.
    #[error(transparent)]
    Sink(#[from] SinkError),
    /// Nothing was planned, so that there are no results.
    #[error("no round was planned, so there is nothing to keep")]
    Nothing,
    /// A fault of this library.
    #[error("internal error: {0}")]
    Internal(String),
}

/// An error that no input should bring about.
pub(crate) fn internal(error: impl std::fmt::Display) -> RecordError {
    RecordError::Internal(error.to_string())
}
