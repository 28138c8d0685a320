//! Errors of recording a run.

use crate::sink::SinkError;
use std::io;
use std::path::PathBuf;
use wisch_memory::MemoryError;
use wisch_telemetry::WriteError;

/// An error of recording a run.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// The episode cannot be written.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// A bag cannot be written.
    #[error(transparent)]
    Bag(#[from] WriteError),
    /// The results cannot be written.
    #[error(transparent)]
    Results(#[from] wisch_io::Error),
    /// The file of the live page cannot be written.
    #[error("{}: cannot write the file: {error}", .place.display())]
    Live {
        /// The file.
        place: PathBuf,
        /// The system's error.
        error: io::Error,
    },
    /// A checkpoint, from which a killed run could be resumed, cannot be written.
    #[error("{}: cannot write the checkpoint: {error}", .place.display())]
    State {
        /// The folder.
        place: PathBuf,
        /// The system's error.
        error: io::Error,
    },
    /// A recording cannot be read.
    #[error("{}: cannot read the recording: {error}", .place.display())]
    Unreadable {
        /// The file.
        place: PathBuf,
        /// The system's error.
        error: io::Error,
    },
    /// A recording exceeds the size limit.
    #[error("{}: the recording exceeds the limit of {limit_mib} MiB", .place.display())]
    TooLong {
        /// The file.
        place: PathBuf,
        /// The limit \[MiB\].
        limit_mib: u64,
    },
    /// A custom sink failed and stopped the run.
    #[error(transparent)]
    Sink(#[from] SinkError),
    /// No round was planned, so there are no results.
    #[error("no round was planned, so there are no results to write")]
    Nothing,
    /// An error in this library.
    #[error("internal error: {0}")]
    Internal(String),
}

/// Makes an error for a state that no input should cause.
pub(crate) fn internal(error: impl std::fmt::Display) -> RecordError {
    RecordError::Internal(error.to_string())
}
