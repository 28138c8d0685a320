//! Tables as named columns in a binary file: Parquet, Arrow, and archives of NumPy arrays.

use super::cell::{Cell, TakeRow};
use crate::error::ReadFault;
use std::borrow::Cow;
use std::cell::Cell as Flag;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Largest number of rows in a table: more than an hour at 1 kHz.
const MOST_ROWS: usize = 5_000_000;

/// Largest unpacked length of an array or column [bytes].
const MOST_UNPACKED: u64 = 1 << 30;

/// Marks a missing whole number or date, as in NumPy.
pub(super) const MISSING: i64 = i64::MIN;

/// Columns of a file.
#[derive(Debug, Default)]
pub(super) struct Heads {
    /// Names of the columns with one value in each row.
    pub names: Vec<String>,
    /// Names of the other columns, for example lists.
    pub unread: Vec<String>,
}

/// Values of a column.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Values {
    /// Numbers; missing ones are NaN.
    Reals(Vec<f64>),
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Nanoseconds since 1970, and whether they are in UTC.
    Dates(Vec<i64>, bool),
    Texts(Texts),
}

/// Texts of a column, concatenated.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Texts {
    all: String,
    ends: Vec<usize>,
}

impl Texts {
    /// Appends a text; an empty text stands for a missing one.
    pub fn push(&mut self, column: &str, text: &str) -> Result<(), ReadFault> {
        let len = self.all.len() + text.len();
        check_unpacked(format_args!("column {column:?}"), len as u64)?;
        self.all.push_str(text);
        self.ends.push(self.all.len());
        Ok(())
    }

    fn get(&self, row: usize) -> &str {
        let start = row.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.all[start..self.ends[row]]
    }
}

impl Values {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Reals(values) => values.len(),
            Self::Whole(values) | Self::Dates(values, _) => values.len(),
            Self::Texts(values) => values.ends.len(),
        }
    }

    fn cell(&self, row: usize) -> Cell<'_> {
        match self {
            Self::Reals(values) if values[row].is_nan() => Cell::Empty,
            Self::Reals(values) => Cell::Real(values[row]),
            Self::Whole(values) | Self::Dates(values, _) if values[row] == MISSING => Cell::Empty,
            Self::Whole(values) => Cell::Whole(values[row]),
            Self::Dates(values, in_utc) => Cell::Date(values[row], *in_utc),
            Self::Texts(values) => match values.get(row).trim() {
                "" => Cell::Empty,
                text => Cell::Text(Cow::Borrowed(text)),
            },
        }
    }
}

/// A table of columns, some of which are read.
#[derive(Debug)]
pub(super) struct Columnar {
    pub names: Vec<String>,
    /// The columns that are read, by index.
    columns: Vec<Option<Values>>,
}

impl Columnar {
    /// Combines columns with their indices; all must have the same number of rows.
    pub fn from_columns(
        names: Vec<String>,
        indices: &[usize],
        values: Vec<Values>,
    ) -> Result<Self, ReadFault> {
        let mut columns = vec![None; names.len()];
        for (&index, values) in indices.iter().zip(values) {
            columns[index] = Some(values);
        }
        let named = names.iter().zip(&columns);
        let mut lengths = named.filter_map(|(name, values)| Some((name, values.as_ref()?.len())));
        if let Some((first, rows)) = lengths.next()
            && let Some((other, others)) = lengths.find(|(_, length)| *length != rows)
        {
            return Err(ReadFault::Rows {
                columns: [first.clone(), other.clone()],
                rows: [rows, others],
            });
        }
        Ok(Self { names, columns })
    }

    /// Calls `take` with the requested values of each row and the row's number from 1.
    pub fn visit_rows(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
        let columns = wanted.iter().map(|&k| self.columns[k].as_ref());
        let columns: Vec<Option<&Values>> = columns.collect();
        let rows = (self.columns.iter().flatten().next()).map_or(0, Values::len);
        let mut cells = Vec::with_capacity(columns.len());
        for row in 0..rows {
            cells.clear();
            let values = columns.iter();
            cells
                .extend(values.map(|values| values.map_or(Cell::Empty, |values| values.cell(row))));
            if !take(row + 1, &cells)? {
                break;
            }
        }
        Ok(())
    }
}

/// Checks the number of rows against the limit.
pub(super) fn check_rows(rows: usize) -> Result<(), ReadFault> {
    if rows > MOST_ROWS {
        return Err(ReadFault::TooManyRows {
            rows,
            limit: MOST_ROWS,
        });
    }
    Ok(())
}

/// Checks an unpacked length [bytes] against the limit.
pub(super) fn check_unpacked(what: impl Display, len: u64) -> Result<(), ReadFault> {
    if len > MOST_UNPACKED {
        return Err(ReadFault::Unpacked {
            what: what.to_string(),
            len,
            limit: MOST_UNPACKED,
        });
    }
    Ok(())
}

/// Returns the error for a damaged file of a format.
pub(super) fn damaged(kind: &'static str, error: impl ToString) -> ReadFault {
    ReadFault::Table {
        kind,
        error: error.to_string(),
    }
}

thread_local! {
    static IS_GUARDED: Flag<bool> = const { Flag::new(false) };
}

/// Whether this thread runs a third-party reader whose panics become errors of the file, so that a panic hook should
/// not report them.
pub fn catches_panics() -> bool {
    IS_GUARDED.get()
}

/// Runs a third-party reader, and turns its panic on a damaged file into an error.
pub(super) fn catch_panics<T>(
    kind: &'static str,
    read: impl FnOnce() -> Result<T, ReadFault>,
) -> Result<T, ReadFault> {
    IS_GUARDED.set(true);
    // Partial results of a panicking reader are discarded, so unwinding leaves no broken state.
    let read = catch_unwind(AssertUnwindSafe(read));
    IS_GUARDED.set(false);
    read.unwrap_or_else(|panic| {
        let message = panic.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| panic.downcast_ref::<&str>().copied());
        Err(damaged(kind, message.unwrap_or("no reason given")))
    })
}
