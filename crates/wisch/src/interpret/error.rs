//! Errors of the interpretation.

use thiserror::Error;

/// A reason why a log cannot be interpreted. Samples are numbered from 0, in the order of
/// [`Interpreter::push`](super::Interpreter::push).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum InterpretError {
    /// A setting is out of its range.
    #[error("{name}: {value} is not within {expected}")]
    Config {
        /// Field of [`InterpretConfig`](super::InterpretConfig).
        name: &'static str,
        /// Its value.
        value: f64,
        /// Its range, in words.
        expected: &'static str,
    },
    /// No uncertain parameter has this name.
    #[error("{name} is not a field of `Uncertainty`")]
    NoSuchUncertainty {
        /// The requested name.
        name: String,
    },
    /// A sample is not later than the one before it.
    #[error(
        "sample {sample}: time {time} s is not after {previous} s, the time of the sample before it"
    )]
    TimeNotIncreasing {
        /// Number of the sample.
        sample: usize,
        /// Its time \[s\].
        time: f64,
        /// Time of the sample before \[s\].
        previous: f64,
    },
    /// A measurement is not finite or exceeds the range of every robot.
    #[error("sample {sample}: {field} = {value} exceeds the limit of ±{limit:e}")]
    Measurement {
        /// Number of the sample.
        sample: usize,
        /// Name and unit of the measured quantity.
        field: &'static str,
        /// Its value; NaN where it is not a number.
        value: f64,
        /// Largest absolute value.
        limit: f64,
    },
    /// A belief without members.
    #[error("a belief needs at least 1 member, not 0")]
    NoMembers,
    /// The cells of a density map are too small or too large.
    #[error("cell size {cell_size} m gives {cells} cells, not 1 to {limit}")]
    Cells {
        /// Side of a cell \[m\].
        cell_size: f64,
        /// Resulting number of cells.
        cells: f64,
        /// Largest number of cells.
        limit: usize,
    },
}

/// Least value, largest value, and both in words.
pub(super) type Range = (f64, f64, &'static str);

/// Checks that a setting is within its range; NaN is within none.
///
/// # Errors
/// The setting, if it is out of its range.
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
