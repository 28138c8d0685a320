//! Tables as columns with names in a binary file: Parquet, Arrow, and archives of NumPy arrays.

use super::cell::{Cell, TakeRow};
use crate::error::ReadFault;
use std::borrow::Cow;
use std::cell::Cell as Flag;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Most rows of a table that is read: an hour and more at 1 kHz.
const MOST_ROWS: usize = 5_000_000;

/// Most that one array or column may be when it is unpacked [bytes].
const MOST_UNPACKED: u64 = 1 << 30;

/// Stands for a whole number or date that is missing, as NumPy has it.
pub(super) const MISSING: i64 = i64::MIN;

/// The columns of a file.
#[derive(Debug, Default)]
pub(super) struct Heads {
    /// The names of those that hold a value in each row.
    pub names: Vec<String>,
    /// The names of the others, such as lists.
    pub unread: Vec<String>,
}

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Values {
    /// Numbers; those that are missing are none (NaN).
    Reals(Vec<f64>),
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Nanoseconds since 1970, and whether they are in UTC.
    Dates(Vec<i64>, bool),
    Texts(Texts),
}

/// Texts of a column, one after the other.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Texts {
    all: String,
    ends: Vec<usize>,
}

impl Texts {
    /// Appends a text; an empty one is a missing one.
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
    /// How many rows there are.
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

/// A table as columns, of which some are read.
#[derive(Debug)]
pub(super) struct Columnar {
    pub names: Vec<String>,
    /// The columns that are read, by their index.
    columns: Vec<Option<Values>>,
}

impl Columnar {
    /// The columns of some indices, which all have the same number of rows.
    pub fn of(
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

    /// Hands the wanted values of each row over, with the row's number from 1.
    pub fn each(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
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

/// Refuses a table with more rows than are read.
pub(super) fn check_rows(rows: usize) -> Result<(), ReadFault> {
    if rows > MOST_ROWS {
        return Err(ReadFault::TooManyRows {
            rows,
            limit: MOST_ROWS,
        });
    }
    Ok(())
}

/// Refuses what would be too long when unpacked [bytes].
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

/// A fault of a file of some kind.
pub(super) fn damaged(kind: &'static str, error: impl ToString) -> ReadFault {
    ReadFault::Table {
        kind,
        error: error.to_string(),
    }
}

thread_local! {
    static IS_GUARDED: Flag<bool> = const { Flag::new(false) };
}

/// Whether this thread is in a reader of others, whose panic is caught and becomes an error of the file: what reports panics
/// has nothing to say of it.
pub fn catches_panics() -> bool {
    IS_GUARDED.get()
}

/// Readers of others panic on some damaged files: that, too, is a damaged file.
pub(super) fn guarded<T>(
    kind: &'static str,
    read: impl FnOnce() -> Result<T, ReadFault>,
) -> Result<T, ReadFault> {
    IS_GUARDED.set(true);
    // Nothing of what was half read is looked at afterwards.
    let read = catch_unwind(AssertUnwindSafe(read));
    IS_GUARDED.set(false);
    read.unwrap_or_else(|panic| {
        let said = panic.downcast_ref::<String>().map(String::as_str);
        let said = said.or_else(|| panic.downcast_ref::<&str>().copied());
        Err(damaged(kind, said.unwrap_or("no reason given")))
    })
}
