//! Errors of a memory.

use crate::observations::ObservationFault;
use crate::record::RecordFault;
use crate::telemetry::TelemetryError;
use parquet::errors::ParquetError;
use std::io;
use std::path::{Path, PathBuf};

/// The reason why a memory cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum MemoryError {
    /// The operating system refuses an operation.
    #[error("{}: {error}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The folder does not exist.
    #[error("{}: there is no memory of episodes", path.display())]
    NoMemory {
        /// Path of the folder.
        path: PathBuf,
    },
    /// A name cannot be an episode's.
    #[error("episode {id:?}: a name may have at most {limit} letters, digits and -")]
    Id {
        /// The name.
        id: String,
        /// Largest number of characters.
        limit: usize,
    },
    /// An episode with this name exists already, complete or in progress.
    #[error("{}: episode {id:?} already exists", path.display())]
    Exists {
        /// Path of the memory.
        path: PathBuf,
        /// The name.
        id: String,
    },
    /// The episode does not exist.
    #[error("{}: there is no episode {id:?}{}", path.display(), likely(nearest))]
    Unknown {
        /// Path of the memory.
        path: PathBuf,
        /// The name.
        id: String,
        /// The most similar name; empty without episodes.
        nearest: String,
    },
    /// A record cannot be parsed.
    #[error("{}: {what}", path.display())]
    Json {
        /// Path of the file.
        path: PathBuf,
        /// Place and description of the fault.
        what: String,
    },
    /// A record contradicts itself.
    #[error("{}: {fault}", path.display())]
    Record {
        /// Path of the file.
        path: PathBuf,
        /// The fault.
        fault: RecordFault,
    },
    /// Observations are invalid.
    #[error("{}: {fault}", path.display())]
    Observations {
        /// Path of the file.
        path: PathBuf,
        /// The fault.
        fault: ObservationFault,
    },
    /// The record belongs to another episode.
    #[error("{}: the record in the folder of {id:?} is that of {found:?}", path.display())]
    Other {
        /// Path of the file.
        path: PathBuf,
        /// Episode of the folder.
        id: String,
        /// Episode of the record.
        found: String,
    },
    /// A file differs from what was written.
    #[error("{}: {what}", path.display())]
    Changed {
        /// Path of the file.
        path: PathBuf,
        /// Description of the difference.
        what: String,
    },
    /// Telemetry is still being written.
    #[error("{}: this telemetry is not finished", path.display())]
    Unfinished {
        /// Path of the file.
        path: PathBuf,
    },
    /// A round has no telemetry.
    #[error("episode {id}: round {round} has no telemetry{}", because(why))]
    NoTelemetry {
        /// Name of the episode.
        id: String,
        /// Number of the round, from 1.
        round: usize,
        /// Reason; empty if unknown.
        why: String,
    },
    /// An episode cannot have a file of this name.
    #[error("episode {id}: {name:?} cannot be the name of a file in it")]
    Name {
        /// Name of the episode.
        id: String,
        /// Name of the file.
        name: String,
    },
    /// Error of the telemetry.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
}

impl MemoryError {
    /// Whether a file could not be written because the disk is full.
    pub fn is_disk_full(&self) -> bool {
        let of = |error: &io::Error| {
            use io::ErrorKind::{QuotaExceeded, StorageFull};
            matches!(error.kind(), StorageFull | QuotaExceeded)
        };
        match self {
            Self::File { error, .. } => of(error),
            Self::Telemetry(TelemetryError::File { error, .. }) => of(error),
            Self::Telemetry(TelemetryError::Parquet {
                error: ParquetError::External(error),
                ..
            }) => error.downcast_ref().is_some_and(of),
            _ => false,
        }
    }
}

fn likely(nearest: &str) -> String {
    match nearest {
        "" => String::new(),
        nearest => format!("; the nearest is {nearest:?}"),
    }
}

fn because(why: &str) -> String {
    match why {
        "" => String::new(),
        why => format!(": {why}"),
    }
}

/// Wraps an error of the operating system at a file.
pub(super) fn at(path: &Path) -> impl FnOnce(io::Error) -> MemoryError + '_ {
    |error| MemoryError::File {
        path: path.to_path_buf(),
        error,
    }
}
