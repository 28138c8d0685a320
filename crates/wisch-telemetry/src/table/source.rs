//! Tables of any format, as rows of cells.

use super::cell::TakeRow;
use super::delimited::Delimited;
use super::layout::Layout;
use crate::error::ReadFault;
use crate::options::LogOptions;

/// A table of some format.
pub(super) enum Source<'a> {
    Text(Delimited<'a>),
}

impl<'a> Source<'a> {
    /// Opens a table and finds its columns.
    pub fn open(bytes: &'a [u8], options: &LogOptions) -> Result<(Self, Layout), ReadFault> {
        let text = std::str::from_utf8(bytes).map_err(|error| ReadFault::NotText {
            byte: error.valid_up_to(),
        })?;
        let (table, layout) = Delimited::open(text, |names| Layout::of(names, options))?;
        Ok((Self::Text(table), layout))
    }

    /// The names of all columns.
    pub fn names(&self) -> &[String] {
        match self {
            Self::Text(table) => table.names(),
        }
    }

    /// Hands each row over.
    pub fn each(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
        match self {
            Self::Text(table) => table.each(wanted, take),
        }
    }

    /// Where a row stands, in words.
    pub fn place(&self, row: usize) -> String {
        match self {
            Self::Text(_) => format!("line {row}"),
        }
    }

    /// Whether commas were read as decimal points.
    pub fn has_decimal_commas(&self) -> bool {
        match self {
            Self::Text(table) => table.has_decimal_commas(),
        }
    }

    /// Whether the table ends in the middle of a row.
    pub fn is_cut_off(&self) -> bool {
        match self {
            Self::Text(table) => table.is_cut_off(),
        }
    }
}
