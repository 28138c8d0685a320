//! Cells of tables, and what takes rows of them.

use crate::error::ReadFault;
use std::borrow::Cow;

/// A cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Cell<'a> {
    Empty,
    /// Text, its decimal point a point.
    Text(Cow<'a, str>),
}

impl Cell<'_> {
    /// The text of a cell.
    pub fn text(&self) -> &str {
        match self {
            Self::Empty => "",
            Self::Text(text) => text,
        }
    }

    /// Its number, if it is one.
    pub fn number(&self) -> Option<f64> {
        self.text().parse().ok()
    }
}

/// Takes a row: its number and the cells that are wanted. Where it returns false, no more rows are read.
pub(super) type TakeRow<'a> = dyn FnMut(usize, &[Cell<'_>]) -> Result<bool, ReadFault> + 'a;
