//! Buffer of rows for a table.

use super::columns::{ColumnKind, Table};
use datafusion::arrow::array::{
    ArrayRef, BooleanBuilder, Date32Builder, Float32Builder, Float64Builder, Int32Builder,
    Int64Builder, RecordBatch, StringBuilder,
};
use std::sync::Arc;

/// A value of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell<'a> {
    /// Of [`ColumnKind::Text`].
    Text(Option<&'a str>),
    /// Of [`ColumnKind::Number`].
    Number(Option<f64>),
    /// Of [`ColumnKind::Single`].
    Single(Option<f32>),
    /// Of [`ColumnKind::Whole`].
    Whole(Option<i32>),
    /// Of [`ColumnKind::Long`].
    Long(Option<i64>),
    /// Of [`ColumnKind::Truth`].
    Truth(Option<bool>),
    /// Of [`ColumnKind::Day`]: days since 1970.
    Day(i32),
}

/// Rows of a table, column by column.
pub struct Rows {
    table: &'static Table,
    columns: Vec<Builder>,
    rows: usize,
}

enum Builder {
    Text(StringBuilder),
    Number(Float64Builder),
    Single(Float32Builder),
    Whole(Int32Builder),
    Long(Int64Builder),
    Truth(BooleanBuilder),
    Day(Date32Builder),
}

impl Rows {
    /// Creates an empty buffer.
    pub fn new(table: &'static Table) -> Self {
        let builder = |kind| match kind {
            ColumnKind::Text => Builder::Text(StringBuilder::new()),
            ColumnKind::Number => Builder::Number(Float64Builder::new()),
            ColumnKind::Single => Builder::Single(Float32Builder::new()),
            ColumnKind::Whole => Builder::Whole(Int32Builder::new()),
            ColumnKind::Long => Builder::Long(Int64Builder::new()),
            ColumnKind::Truth => Builder::Truth(BooleanBuilder::new()),
            ColumnKind::Day => Builder::Day(Date32Builder::new()),
        };
        Self {
            columns: table.columns.iter().map(|c| builder(c.kind)).collect(),
            table,
            rows: 0,
        }
    }

    /// The table.
    pub fn table(&self) -> &'static Table {
        self.table
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// Adds a row, with cells in the order of the columns.
    ///
    /// # Panics
    /// If a cell's type is not that of its column.
    pub fn push(&mut self, cells: &[Cell<'_>]) {
        assert_eq!(cells.len(), self.columns.len(), "{}", self.table.name);
        for (place, (column, cell)) in self.columns.iter_mut().zip(cells).enumerate() {
            match (column, *cell) {
                (Builder::Text(column), Cell::Text(value)) => column.append_option(value),
                (Builder::Number(column), Cell::Number(value)) => column.append_option(value),
                (Builder::Single(column), Cell::Single(value)) => column.append_option(value),
                (Builder::Whole(column), Cell::Whole(value)) => column.append_option(value),
                (Builder::Long(column), Cell::Long(value)) => column.append_option(value),
                (Builder::Truth(column), Cell::Truth(value)) => column.append_option(value),
                (Builder::Day(column), Cell::Day(value)) => column.append_value(value),
                (_, cell) => panic!(
                    "{}.{}: {cell:?}",
                    self.table.name, self.table.columns[place].name
                ),
            }
        }
        self.rows += 1;
    }

    /// Returns all rows in one batch, and empties the buffer.
    pub fn take(&mut self) -> RecordBatch {
        let arrays = self.columns.iter_mut().map(|column| -> ArrayRef {
            match column {
                Builder::Text(column) => Arc::new(column.finish()),
                Builder::Number(column) => Arc::new(column.finish()),
                Builder::Single(column) => Arc::new(column.finish()),
                Builder::Whole(column) => Arc::new(column.finish()),
                Builder::Long(column) => Arc::new(column.finish()),
                Builder::Truth(column) => Arc::new(column.finish()),
                Builder::Day(column) => Arc::new(column.finish()),
            }
        });
        let arrays = arrays.collect();
        self.rows = 0;
        RecordBatch::try_new(self.table.schema(), arrays)
            .expect("every column has the kind that the table says")
    }
}
