//! Rows as a Parquet file, sorted so that a query for a robot, a day or a time reads little of it.

use super::columns::{ColumnKind, Table};
use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::datatypes::SchemaRef;
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, Encoding, ZstdLevel};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::schema::types::ColumnPath;

/// Version of the files: major and minor. A new column needs a new minor version; a change that an older program would
/// misread needs a new major version.
pub const VERSION: [u32; 2] = [1, 1];

/// Key of a file's version.
pub const VERSION_KEY: &str = "wisch.fleet";

/// Rows of a row group: the events of a robot on a day are in one or two groups.
const GROUP_ROWS: usize = 65_536;
/// Rows of a page.
const PAGE_ROWS: usize = 8_192;

/// Returns writer properties that DataFusion exploits: statistics of every row group and page, and the sort order by
/// robot, day and episode.
pub fn properties(table: &Table) -> WriterProperties {
    let mut properties = WriterProperties::builder()
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_max_row_group_row_count(Some(GROUP_ROWS))
        .set_data_page_row_count_limit(PAGE_ROWS)
        .set_created_by(format!("wisch-fleet {}", env!("CARGO_PKG_VERSION")))
        .set_key_value_metadata(Some(vec![KeyValue::new(
            VERSION_KEY.to_owned(),
            format!("{}.{}", VERSION[0], VERSION[1]),
        )]));
    for column in table.columns {
        let path = ColumnPath::new(vec![column.name.to_owned()]);
        if matches!(column.kind, ColumnKind::Number | ColumnKind::Single) {
            // Byte stream split puts similar bytes next to each other.
            properties = properties
                .set_column_dictionary_enabled(path.clone(), false)
                .set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT);
        }
    }
    properties.build()
}

/// Writes batches of a table as a file with their schema.
///
/// # Errors
/// If Parquet cannot write it.
pub fn to_bytes<'a>(
    table: &Table,
    schema: SchemaRef,
    batches: impl IntoIterator<Item = &'a RecordBatch>,
) -> Result<Vec<u8>, ParquetError> {
    let mut writer = ArrowWriter::try_new(Vec::new(), schema, Some(properties(table)))?;
    for batch in batches {
        writer.write(batch)?;
    }
    writer.into_inner()
}
