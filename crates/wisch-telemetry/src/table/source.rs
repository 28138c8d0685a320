//! Tables of any format, as rows of cells.

#[cfg(feature = "arrow")]
use super::arrow_file;
use super::cell::TakeRow;
use super::columnar::{Columnar, Heads, Values, catch_panics};
use super::delimited::Delimited;
use super::layout::Layout;
use super::{arrow, npz, parquet_file};
use crate::error::ReadFault;
use crate::options::LogOptions;

/// A table of some format.
pub(super) enum Source<'a> {
    Text(Delimited<'a>),
    Columns(Columnar),
}

impl<'a> Source<'a> {
    /// Opens a table, recognises its format by its first bytes, and finds its columns.
    pub fn open(bytes: &'a [u8], options: &LogOptions) -> Result<(Self, Layout), ReadFault> {
        if bytes.starts_with(parquet_file::MAGIC) {
            let (kind, open) = (parquet_file::KIND, parquet_file::open);
            return Self::columns(kind, || open(bytes), parquet_file::read, options);
        }
        #[cfg(feature = "arrow")]
        if arrow::is_arrow(bytes) {
            let (kind, open) = (arrow_file::KIND, arrow_file::open);
            return Self::columns(kind, || open(bytes), arrow_file::read, options);
        }
        #[cfg(not(feature = "arrow"))]
        if arrow::is_arrow(bytes) {
            return Err(ReadFault::NoArrow);
        }
        if bytes.starts_with(npz::MAGIC) {
            return Self::columns(npz::KIND, || npz::open(bytes), npz::read, options);
        }
        let text = std::str::from_utf8(bytes).map_err(|error| ReadFault::NotText {
            byte: error.valid_up_to(),
        })?;
        let (table, layout) = Delimited::open(text, |names| Layout::find(names, options))?;
        Ok((Self::Text(table), layout))
    }

    /// Reads the requested columns of a file, which are found by the names of all its columns.
    fn columns<File>(
        kind: &'static str,
        open: impl FnOnce() -> Result<(Heads, File), ReadFault>,
        read: impl FnOnce(&File, &[usize]) -> Result<Vec<Values>, ReadFault>,
        options: &LogOptions,
    ) -> Result<(Self, Layout), ReadFault> {
        let (heads, file) = catch_panics(kind, open)?;
        let layout = Layout::find(&heads.names, options).map_err(|fault| {
            if heads.unread.is_empty() {
                return fault;
            }
            ReadFault::BesideUnread {
                fault: Box::new(fault),
                columns: heads.unread,
            }
        })?;
        let mut indices = layout.indices();
        indices.sort_unstable();
        indices.dedup();
        let values = catch_panics(kind, || read(&file, &indices))?;
        let table = Columnar::from_columns(heads.names, &indices, values)?;
        Ok((Self::Columns(table), layout))
    }

    /// Names of all columns.
    pub fn names(&self) -> &[String] {
        match self {
            Self::Text(table) => table.names(),
            Self::Columns(table) => &table.names,
        }
    }

    /// Passes each row on.
    pub fn visit_rows(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
        match self {
            Self::Text(table) => table.visit_rows(wanted, take),
            Self::Columns(table) => table.visit_rows(wanted, take),
        }
    }

    /// Returns the name of a row in messages.
    pub fn place(&self, row: usize) -> String {
        match self {
            Self::Text(_) => format!("line {row}"),
            Self::Columns(_) => format!("row {row}"),
        }
    }

    /// Whether commas were read as decimal separators.
    pub fn has_decimal_commas(&self) -> bool {
        matches!(self, Self::Text(table) if table.has_decimal_commas())
    }

    /// Whether the table ends within a row.
    pub fn is_cut_off(&self) -> bool {
        matches!(self, Self::Text(table) if table.is_cut_off())
    }
}
