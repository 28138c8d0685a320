//! Episodes as tables: the columns, the rows of a record, and the files of rows.

pub mod columns;
pub mod file;
mod project;
pub mod rows;
mod telemetry;

pub use columns::{Column, ColumnKind, TABLES, Table, table};
pub use project::{Keep, Projection, day_of, robot_of};
