//! Errors of a telemetry file.

use parquet::errors::ParquetError;
use std::io;
use std::path::PathBuf;

/// The reason why telemetry cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum TelemetryError {
    /// The operating system refuses an operation.
    #[error("{}: {error}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The file is not a complete Parquet file, or is damaged.
    #[error("{}: {place}: {error}", path.display())]
    Parquet {
        /// Path of the file.
        path: PathBuf,
        /// Place in the file.
        place: String,
        /// Error of the Parquet reader.
        error: ParquetError,
    },
    /// A Parquet file, but not telemetry of this program.
    #[error("{}: {what}", path.display())]
    Foreign {
        /// Path of the file.
        path: PathBuf,
        /// What is missing or different.
        what: String,
    },
    /// The column does not exist.
    #[error("{}: there is no column {name:?}; the nearest is {nearest:?}", path.display())]
    Column {
        /// Path of the file.
        path: PathBuf,
        /// The name.
        name: String,
        /// The most similar name.
        nearest: String,
    },
    /// Two columns have the same name.
    #[error("{}: there are two columns {name:?}", path.display())]
    Twice {
        /// Path of the file.
        path: PathBuf,
        /// The name.
        name: String,
    },
    /// A time is out of range.
    #[error("time: {time} s is not between 0 and {limit} s")]
    Time {
        /// The time \[s\].
        time: f64,
        /// The latest allowed time \[s\].
        limit: f64,
    },
    /// A time is not later than the previous one.
    #[error("time: {time} s is not later than the previous sample's, {last} s")]
    Backwards {
        /// The time \[s\].
        time: f64,
        /// Time of the previous sample \[s\].
        last: f64,
    },
    /// An array has the wrong length.
    #[error("{what}: {count} values; expected {expected}")]
    Count {
        /// Name of the array.
        what: &'static str,
        /// Its number of values.
        count: usize,
        /// Expected number of values.
        expected: usize,
    },
}
