//! Why nothing can be learned.

use super::LEAST_PARTICLES;
use thiserror::Error;

/// Why a law cannot be fitted.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LearnError {
    /// A setting makes no sense.
    #[error("{name}: {value} is not within {expected}")]
    Config {
        /// Field of [`LearnConfig`](super::LearnConfig).
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// Exposures of other particles than were seen.
    #[error(
        "{law}, round {round}: {field} has {found} entries, but {expected} particles were seen before"
    )]
    Mismatch {
        /// Tool, medium and surface.
        law: String,
        /// The round, from 0.
        round: usize,
        /// Field of [`SeenRound`](super::SeenRound).
        field: &'static str,
        /// Entries.
        found: usize,
        /// Detections before.
        expected: usize,
    },
    /// A number that is none, or out of its range.
    #[error("{law}, round {round}: {field} = {value} is not within {expected}")]
    OutOfRange {
        /// Tool, medium and surface.
        law: String,
        /// The round, from 0.
        round: usize,
        /// Which number.
        field: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// Too little to say anything.
    #[error(
        "{law}: {particles} particles were touched and looked for in {rounds} rounds, and at least {LEAST_PARTICLES} are needed"
    )]
    TooFew {
        /// Tool, medium and surface.
        law: String,
        /// Particles that were touched and looked for.
        particles: usize,
        /// Rounds.
        rounds: usize,
    },
}
