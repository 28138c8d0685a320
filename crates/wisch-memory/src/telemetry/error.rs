//! What can be wrong with a telemetry file.

use parquet::errors::ParquetError;
use std::io;
use std::path::PathBuf;

/// Why telemetry cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum TelemetryError {
    /// What the system says.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What it says.
        error: io::Error,
    },
    /// Not a whole Parquet file, or broken in the middle.
    #[error("{}: {place}: {error}", path.display())]
    Parquet {
        /// The file.
        path: PathBuf,
        /// Where in it.
        place: String,
        /// What is wrong.
        error: ParquetError,
    },
    /// A Parquet file, but none of ours.
    #[error("{}: {what}", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What is missing, or different.
        what: String,
    },
    /// No such column.
    #[error("{}: there is no column {name:?}; the nearest is {nearest:?}", path.display())]
    Column {
        /// The file.
        path: PathBuf,
        /// The name.
        name: String,
        /// The most similar one.
        nearest: String,
    },
    /// Two columns of the same name.
    #[error("{}: there are two columns {name:?}", path.display())]
    Twice {
        /// The file.
        path: PathBuf,
        /// The name.
        name: String,
    },
    /// A time that is none.
    #[error("time: {time} s is not between 0 and {limit} s")]
    Time {
        /// The time [s].
        time: f64,
        /// The latest possible [s].
        limit: f64,
    },
    /// A time not after the last.
    #[error("time: {time} s does not come after {last} s")]
    Backwards {
        /// The time [s].
        time: f64,
        /// The one before [s].
        last: f64,
    },
    /// An array of another length.
    #[error("{what}: {count} values where there are {expected}")]
    Count {
        /// Of what.
        what: &'static str,
        /// How many came.
        count: usize,
        /// How many there should be.
        expected: usize,
    },
}
