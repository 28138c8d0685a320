//! Tables in Parquet files.

use super::columnar::{Heads, MISSING, Texts, Values, check_rows, check_unpacked, damaged};
use crate::error::ReadFault;
use bytes::Bytes;
use parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::ColumnDescriptor;

/// First bytes of a Parquet file.
pub(super) const MAGIC: &[u8] = b"PAR1";

/// Name of the format in messages.
pub(super) const KIND: &str = "Parquet";

/// Number of values in one batch.
const BATCH: usize = 8192;

/// A file and the indices of its columns among the leaves of its schema.
pub(super) struct ParquetTable {
    file: SerializedFileReader<Bytes>,
    leaves: Vec<usize>,
}

/// Opens a file and reads the names of its columns.
pub(super) fn open(bytes: &[u8]) -> Result<(Heads, ParquetTable), ReadFault> {
    let file = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(fault)?;
    let metadata = file.metadata();
    let groups = metadata.row_groups().iter();
    let rows = groups.map(|group| usize::try_from(group.num_rows()).unwrap_or(usize::MAX));
    check_rows(rows.fold(0, usize::saturating_add))?;
    let schema = metadata.file_metadata().schema_descr();
    let (mut heads, mut leaves) = (Heads::default(), Vec::new());
    for leaf in 0..schema.num_columns() {
        let column = schema.column(leaf);
        let name = column.path().string();
        // Values of a list repeat within a row.
        if column.max_rep_level() == 0 {
            heads.names.push(name);
            leaves.push(leaf);
        } else {
            heads.unread.push(name);
        }
    }
    Ok((heads, ParquetTable { file, leaves }))
}

/// Reads the columns with these indices.
pub(super) fn read(table: &ParquetTable, indices: &[usize]) -> Result<Vec<Values>, ReadFault> {
    let metadata = table.file.metadata();
    let schema = metadata.file_metadata().schema_descr();
    let mut columns = Vec::with_capacity(indices.len());
    for &index in indices {
        let leaf = table.leaves[index];
        let column = schema.column(leaf);
        let name = column.path().string();
        let mut values = empty(&column).ok_or_else(|| ReadFault::ColumnType {
            column: name.clone(),
            kind: column.physical_type().to_string(),
        })?;
        let lengths = metadata.row_groups().iter().map(|group| {
            let length = group.columns().get(leaf)?.uncompressed_size();
            u64::try_from(length).ok()
        });
        let length = lengths.map(|length| length.unwrap_or(u64::MAX));
        let length = length.fold(0, u64::saturating_add);
        check_unpacked(format_args!("column {name:?}"), length)?;
        for group in 0..metadata.num_row_groups() {
            let group = table.file.get_row_group(group).map_err(fault)?;
            let reader = group.get_column_reader(leaf).map_err(fault)?;
            append(reader, &column, &name, &mut values)?;
        }
        columns.push(values);
    }
    Ok(columns)
}

fn fault(error: ParquetError) -> ReadFault {
    damaged(KIND, error)
}

/// Returns an empty column, if its type is supported.
fn empty(column: &ColumnDescriptor) -> Option<Values> {
    let is_text = matches!(column.logical_type_ref(), Some(LogicalType::String))
        || column.converted_type() == ConvertedType::UTF8;
    Some(match column.physical_type() {
        Type::DOUBLE | Type::FLOAT => Values::Reals(Vec::new()),
        Type::INT32 => Values::Whole(Vec::new()),
        Type::INT64 => match timestamp(column) {
            Some((_, in_utc)) => Values::Dates(Vec::new(), in_utc),
            None => Values::Whole(Vec::new()),
        },
        Type::INT96 => Values::Dates(Vec::new(), false),
        Type::BYTE_ARRAY if is_text => Values::Texts(Texts::default()),
        _ => return None,
    })
}

/// Returns the unit of a time since 1970 [ns], and whether the time is in UTC.
fn timestamp(column: &ColumnDescriptor) -> Option<(i64, bool)> {
    match (column.logical_type_ref(), column.converted_type()) {
        (Some(LogicalType::Timestamp(time)), _) => {
            let size = match time.unit {
                TimeUnit::MILLIS => 1_000_000,
                TimeUnit::MICROS => 1000,
                TimeUnit::NANOS => 1,
            };
            Some((size, time.is_adjusted_to_u_t_c))
        }
        (_, ConvertedType::TIMESTAMP_MILLIS) => Some((1_000_000, true)),
        (_, ConvertedType::TIMESTAMP_MICROS) => Some((1000, true)),
        _ => None,
    }
}

/// Appends the values of a group of rows.
fn append(
    reader: ColumnReader,
    column: &ColumnDescriptor,
    name: &str,
    values: &mut Values,
) -> Result<(), ReadFault> {
    let unit = timestamp(column).map_or(1, |(unit, _)| unit);
    let before = values.len();
    match (reader, values) {
        (ColumnReader::DoubleColumnReader(reader), Values::Reals(reals)) => {
            each(reader, column, before, |value| {
                reals.push(value.unwrap_or(f64::NAN));
                Ok(())
            })
        }
        (ColumnReader::FloatColumnReader(reader), Values::Reals(reals)) => {
            each(reader, column, before, |value| {
                reals.push(value.map_or(f64::NAN, f64::from));
                Ok(())
            })
        }
        (ColumnReader::Int32ColumnReader(reader), Values::Whole(whole)) => {
            each(reader, column, before, |value| {
                whole.push(value.map_or(MISSING, i64::from));
                Ok(())
            })
        }
        (
            ColumnReader::Int64ColumnReader(reader),
            Values::Whole(whole) | Values::Dates(whole, _),
        ) => each(reader, column, before, |value| {
            whole.push(value.map_or(MISSING, |value| value.saturating_mul(unit)));
            Ok(())
        }),
        (ColumnReader::Int96ColumnReader(reader), Values::Dates(dates, _)) => {
            each(reader, column, before, |value| {
                dates.push(value.map_or(MISSING, |value| value.to_nanos()));
                Ok(())
            })
        }
        (ColumnReader::ByteArrayColumnReader(reader), Values::Texts(texts)) => {
            each(reader, column, before, |value| {
                let bytes = value.as_ref().map_or(&[][..], |value| value.data());
                let text = std::str::from_utf8(bytes).map_err(|error| damaged(KIND, error))?;
                texts.push(name, text)
            })
        }
        _ => Err(damaged(
            KIND,
            "a group of rows has another type than the schema",
        )),
    }
}

/// Passes each value of a column on, `None` for a missing one; `before` rows were read earlier.
fn each<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    column: &ColumnDescriptor,
    before: usize,
    mut take: impl FnMut(Option<T::T>) -> Result<(), ReadFault>,
) -> Result<(), ReadFault> {
    let full = column.max_def_level();
    let mut rows = before;
    loop {
        let (mut levels, mut values) = (Vec::new(), Vec::new());
        let levels_out = (full > 0).then_some(&mut levels);
        let read = reader.read_records(BATCH, levels_out, None, &mut values);
        let (records, ..) = read.map_err(fault)?;
        if records == 0 {
            return Ok(());
        }
        rows += records;
        // A few bytes may encode any number of equal values.
        check_rows(rows)?;
        let mut values = values.into_iter();
        if full == 0 {
            values.try_for_each(|value| take(Some(value)))?;
        } else {
            for level in levels {
                take(if level == full { values.next() } else { None })?;
            }
        }
    }
}
