//! Errors of the learning.

use super::LEAST_PARTICLES;
use thiserror::Error;

/// A reason why a law cannot be fitted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LearnError {
    /// A setting is out of its range.
    #[error("{name}: {value} is not within {expected}")]
    Config {
        /// Field of [`LearnConfig`](super::LearnConfig).
        name: &'static str,
        /// Its value.
        value: f64,
        /// Its range, in words.
        expected: &'static str,
    },
    /// The number of exposures differs from the number of detections before the round.
    #[error(
        "{law}, round {round}: {field} has {found} entries, but {expected} particles were detected before the round"
    )]
    Mismatch {
        /// Tool, medium and surface of the law.
        law: String,
        /// Index of the round.
        round: usize,
        /// Field of [`ObservedRound`](super::ObservedRound).
        field: &'static str,
        /// Number of entries.
        found: usize,
        /// Number of detections before the round.
        expected: usize,
    },
    /// A value is not finite or out of its range.
    #[error("{law}, round {round}: {field} = {value} is not within {expected}")]
    OutOfRange {
        /// Tool, medium and surface of the law.
        law: String,
        /// Index of the round.
        round: usize,
        /// Name of the field.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Its range, in words.
        expected: &'static str,
    },
    /// Too few observed particles to fit a law.
    #[error(
        "{law}: {particles} particles were touched and observed in {rounds} rounds; at least {LEAST_PARTICLES} are needed"
    )]
    TooFew {
        /// Tool, medium and surface of the law.
        law: String,
        /// Number of particles that were touched and then observed.
        particles: usize,
        /// Number of rounds.
        rounds: usize,
    },
}
