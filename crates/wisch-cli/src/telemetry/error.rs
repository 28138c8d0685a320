//! What can be wrong with a bag.

use std::path::PathBuf;

/// Why telemetry could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The system refuses.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
    /// The bag cannot be written.
    #[error("{}: {error}", path.display())]
    Mcap {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: mcap::McapError,
    },
    /// A message cannot be laid out.
    #[error("a message of {topic}: {error}")]
    Message {
        /// The topic.
        topic: &'static str,
        /// What is wrong.
        error: cdr::Error,
    },
    /// A time that no log bears.
    #[error("a sample's time of {time} s is not within 0 to {limit} s")]
    Time {
        /// The time [s].
        time: f64,
        /// The limit [s].
        limit: f64,
    },
    /// Samples out of order.
    #[error("a sample's time of {time} s is not after that of the sample before, {last} s")]
    Backwards {
        /// The time [s].
        time: f64,
        /// That of the sample before [s].
        last: f64,
    },
    /// A sample of another robot.
    #[error("a sample has {count} {what}, but the bag has {joints} joints")]
    Joints {
        /// Which array.
        what: &'static str,
        /// How many values it has.
        count: usize,
        /// How many it should have.
        joints: usize,
    },
}
