//! Cells of tables, and the callback that receives rows of them.

use crate::error::ReadFault;
use std::borrow::Cow;

/// A cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Cell<'a> {
    Empty,
    Real(f64),
    Whole(i64),
    /// Nanoseconds since 1970, and whether they are in UTC.
    Date(i64, bool),
    /// Text, with a point as decimal separator.
    Text(Cow<'a, str>),
}

impl Cell<'_> {
    /// The cell as text.
    pub fn text(&self) -> Cow<'_, str> {
        match self {
            Self::Empty => "".into(),
            Self::Real(number) => number.to_string().into(),
            Self::Whole(number) => number.to_string().into(),
            Self::Date(time, _) => format!("{time} ns since 1970").into(),
            Self::Text(text) => Cow::Borrowed(text),
        }
    }

    /// Returns its number, if it holds one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Empty | Self::Date(..) => None,
            Self::Real(number) => Some(*number),
            Self::Whole(number) => Some(*number as f64),
            Self::Text(text) => text.parse().ok(),
        }
    }
}

/// Callback that receives a row: its number and the requested cells. It returns false to stop reading.
pub(super) type TakeRow<'a> = dyn FnMut(usize, &[Cell<'_>]) -> Result<bool, ReadFault> + 'a;
