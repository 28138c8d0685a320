//! Why a log cannot be interpreted.

use thiserror::Error;

/// Why a log cannot be interpreted. Samples count from 0, in the order in which they were pushed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum InterpretError {
    /// A setting makes no sense.
    #[error("{name}: {value} is not within {expected}")]
    Config {
        /// Field of [`InterpretConfig`](super::InterpretConfig).
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// There is no such uncertainty.
    #[error("{name}: no field of the uncertainty")]
    NoSuchUncertainty {
        /// What was asked for.
        name: String,
    },
    /// A sample does not come after the one before.
    #[error("sample {sample}: time {time} s is not after {previous} s, the time of the one before")]
    TimeNotIncreasing {
        /// The offending sample.
        sample: usize,
        /// Its time [s].
        time: f64,
        /// Time of the sample before [s].
        previous: f64,
    },
    /// A measurement is not a number, or none that a robot measures.
    #[error("sample {sample}: {field} = {value} exceeds the limit of ±{limit:e}")]
    Measurement {
        /// The offending sample.
        sample: usize,
        /// Which of its fields.
        field: &'static str,
        /// Its value; NaN where it is not a number.
        value: f64,
        /// Largest size it may have.
        limit: f64,
    },
    /// A belief needs members.
    #[error("a belief needs at least 1 member, not 0")]
    NoMembers,
    /// The cells of a map are too small or too large to count particles in.
    #[error("cell size {cell_size} m gives {cells} cells, not 1 to {limit}")]
    Cells {
        /// Side of a cell [m].
        cell_size: f64,
        /// How many cells that makes.
        cells: f64,
        /// How many there may be.
        limit: usize,
    },
}

/// Least and largest value, and both in words.
pub(super) type Range = (f64, f64, &'static str);

/// Whether a setting is within its range; what is no number is in none.
///
/// # Errors
/// The setting, if it is not.
pub(super) fn within(
    (name, value, range): (&'static str, f64, Range),
) -> Result<(), InterpretError> {
    let (least, most, expected) = range;
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(InterpretError::Config {
        name,
        value,
        expected,
    })
}
