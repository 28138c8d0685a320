//! Episodes as tables: the columns, the rows of a record, and the files of rows.

pub mod columns;
pub mod drift;
pub mod file;
mod project;
pub mod rows;
mod telemetry;

pub use columns::{Column, ColumnKind, TABLES, Table, table};
pub use drift::DRIFT;
pub use project::{Keep, Projection, day_of, robot_of};

/// All tables that statements can use: those of the files, and the computed one.
pub fn all_tables() -> impl Iterator<Item = &'static Table> {
    TABLES.iter().chain([&DRIFT])
}
