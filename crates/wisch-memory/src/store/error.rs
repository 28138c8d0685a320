//! What can be wrong with a memory.

use crate::observations::ObservationFault;
use crate::record::RecordFault;
use crate::telemetry::TelemetryError;
use std::io;
use std::path::{Path, PathBuf};

/// Why a memory cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum MemoryError {
    /// What the system says.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What it says.
        error: io::Error,
    },
    /// There is no such folder.
    #[error("{}: there is no memory of episodes", path.display())]
    NoMemory {
        /// Where it was looked for.
        path: PathBuf,
    },
    /// A name that cannot be that of an episode.
    #[error("episode {id:?}: a name is made of at most {limit} letters, digits and -")]
    Id {
        /// The name.
        id: String,
        /// Most characters.
        limit: usize,
    },
    /// There is an episode of this name already, whole or being written.
    #[error("{}: episode {id:?} is there already", path.display())]
    Exists {
        /// The memory.
        path: PathBuf,
        /// The name.
        id: String,
    },
    /// No such episode.
    #[error("{}: there is no episode {id:?}{}", path.display(), likely(nearest))]
    Unknown {
        /// The memory.
        path: PathBuf,
        /// The name.
        id: String,
        /// The most similar one, if there is any episode.
        nearest: String,
    },
    /// A record that is none.
    #[error("{}: {what}", path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// Where and why.
        what: String,
    },
    /// A record that contradicts itself.
    #[error("{}: {fault}", path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        fault: RecordFault,
    },
    /// Observations that are none.
    #[error("{}: {fault}", path.display())]
    Observations {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        fault: ObservationFault,
    },
    /// A record in the folder of another episode.
    #[error("{}: this is the record of {found:?}, not of {id:?}", path.display())]
    Other {
        /// The file.
        path: PathBuf,
        /// Whose folder it is.
        id: String,
        /// Whose record it is.
        found: String,
    },
    /// A file that is not what was written.
    #[error("{}: {what}", path.display())]
    Changed {
        /// The file.
        path: PathBuf,
        /// How it differs.
        what: String,
    },
    /// Telemetry that is still being written.
    #[error("{}: this telemetry is not finished", path.display())]
    Unfinished {
        /// The file.
        path: PathBuf,
    },
    /// A round of which no telemetry was kept.
    #[error("episode {id}: round {round} has no telemetry{}", because(why))]
    NoTelemetry {
        /// The episode.
        id: String,
        /// The round, from 1.
        round: usize,
        /// Why it was not kept; empty where that is not known.
        why: String,
    },
    /// A file that an episode cannot have.
    #[error("episode {id}: {name:?} cannot be the name of a file in it")]
    Name {
        /// The episode.
        id: String,
        /// The name.
        name: String,
    },
    /// Telemetry.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
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

/// An error of the system at a file.
pub(super) fn at(path: &Path) -> impl FnOnce(io::Error) -> MemoryError + '_ {
    |error| MemoryError::File {
        path: path.to_path_buf(),
        error,
    }
}
