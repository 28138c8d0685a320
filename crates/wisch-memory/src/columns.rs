//! Columns of numbers and texts in Parquet files, by row groups: the format that all files of the memory share.

use crate::checked_file::CheckedFile;
use parquet::basic::{Encoding, LogicalType, Repetition, Type as PhysicalType};
use parquet::column::reader::get_typed_column_reader;
use parquet::data_type::{
    ByteArray, ByteArrayType, DataType, DoubleType, FloatType, Int32Type, Int64Type,
};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterPropertiesBuilder;
use parquet::file::reader::FileReader;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Type of a column, with its encoding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Small whole numbers that repeat: dictionary encoding.
    Code,
    /// Increasing whole numbers: delta encoding.
    Growing,
    /// Increasing whole numbers of 32 bits: delta encoding.
    Growing32,
    /// Numbers of single precision: byte stream split, which puts similar bytes next to each other.
    Single,
    /// Numbers of double precision: byte stream split.
    Double,
    /// Texts.
    Text,
}

impl Kind {
    const fn physical(self) -> PhysicalType {
        match self {
            Self::Code | Self::Growing32 => PhysicalType::INT32,
            Self::Growing => PhysicalType::INT64,
            Self::Single => PhysicalType::FLOAT,
            Self::Double => PhysicalType::DOUBLE,
            Self::Text => PhysicalType::BYTE_ARRAY,
        }
    }

    const fn encoding(self) -> Option<Encoding> {
        match self {
            Self::Code | Self::Text => None,
            Self::Growing | Self::Growing32 => Some(Encoding::DELTA_BINARY_PACKED),
            Self::Single | Self::Double => Some(Encoding::BYTE_STREAM_SPLIT),
        }
    }
}

/// Returns the schema of columns with a value in each row.
///
/// # Errors
/// If Parquet rejects a name.
pub(crate) fn schema<'a>(
    columns: impl IntoIterator<Item = (&'a str, Kind)>,
) -> Result<TypePtr, ParquetError> {
    let mut fields = Vec::new();
    for (name, kind) in columns {
        let mut builder = Type::primitive_type_builder(name, kind.physical())
            .with_repetition(Repetition::REQUIRED);
        if kind == Kind::Text {
            builder = builder.with_logical_type(Some(LogicalType::String));
        }
        fields.push(Arc::new(builder.build()?));
    }
    let group = Type::group_type_builder("wisch").with_fields(fields);
    Ok(Arc::new(group.build()?))
}

/// Returns writer properties with the encodings of the columns.
pub(crate) fn with_encodings<'a>(
    mut builder: WriterPropertiesBuilder,
    columns: impl IntoIterator<Item = (&'a str, Kind)>,
) -> WriterPropertiesBuilder {
    for (name, kind) in columns {
        let path = ColumnPath::new(vec![name.to_owned()]);
        if let Some(encoding) = kind.encoding() {
            builder = builder
                .set_column_dictionary_enabled(path.clone(), false)
                .set_column_encoding(path, encoding);
        }
    }
    builder
}

/// Values of a column in a row group.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Values<'a> {
    /// [`Kind::Code`] and [`Kind::Growing32`].
    Ints(&'a [i32]),
    /// [`Kind::Growing`].
    Longs(&'a [i64]),
    /// [`Kind::Single`].
    Singles(&'a [f32]),
    /// [`Kind::Double`].
    Doubles(&'a [f64]),
    /// [`Kind::Text`].
    Texts(&'a [ByteArray]),
}

/// Writes a row group, with the columns in the order of the schema.
///
/// # Errors
/// If Parquet cannot write it.
pub(crate) fn write_group<'a, W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    columns: impl IntoIterator<Item = Values<'a>>,
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for values in columns {
        let Some(mut column) = group.next_column()? else {
            return Err(ParquetError::General(
                "there are more columns than names".to_owned(),
            ));
        };
        match values {
            Values::Ints(v) => column.typed::<Int32Type>().write_batch(v, None, None),
            Values::Longs(v) => column.typed::<Int64Type>().write_batch(v, None, None),
            Values::Singles(v) => column.typed::<FloatType>().write_batch(v, None, None),
            Values::Doubles(v) => column.typed::<DoubleType>().write_batch(v, None, None),
            Values::Texts(v) => column.typed::<ByteArrayType>().write_batch(v, None, None),
        }?;
        column.close()?;
    }
    group.close()?;
    Ok(())
}

/// Opens a file by its footer.
///
/// # Errors
/// If the file is cut off or damaged.
pub(crate) fn open(file: CheckedFile) -> Result<SerializedFileReader<CheckedFile>, ParquetError> {
    catch_panics(|| SerializedFileReader::new(file))
}

/// Reads the values of a column in a row group.
///
/// # Errors
/// If the column has another type, or its pages are damaged.
pub(crate) fn read_chunk<T: DataType>(
    file: &SerializedFileReader<CheckedFile>,
    group: usize,
    column: usize,
) -> Result<Vec<T::T>, ParquetError> {
    catch_panics(|| decode::<T>(file, group, column))
}

/// Runs the reader, and turns its panic on a damaged file (for example at a negative offset) into an error.
fn catch_panics<T>(read: impl FnOnce() -> Result<T, ParquetError>) -> Result<T, ParquetError> {
    // Partial results of a panicking reader are discarded, so unwinding leaves no broken state.
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|panic| {
        let message = panic.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| panic.downcast_ref::<&str>().copied());
        Err(ParquetError::General(format!(
            "the file is damaged: {}",
            message.unwrap_or("no reason given")
        )))
    })
}

fn decode<T: DataType>(
    file: &SerializedFileReader<CheckedFile>,
    group: usize,
    column: usize,
) -> Result<Vec<T::T>, ParquetError> {
    let schema = file.metadata().file_metadata().schema_descr();
    let found = schema.column(column).physical_type();
    if found != T::get_physical_type() {
        return Err(ParquetError::General(format!(
            "column {:?} holds {found}, not {}",
            schema.column(column).name(),
            T::get_physical_type()
        )));
    }
    let group = file.get_row_group(group)?;
    let rows = usize::try_from(group.metadata().num_rows()).unwrap_or_default();
    let mut reader = get_typed_column_reader::<T>(group.get_column_reader(column)?);
    let mut values = Vec::new();
    let (read, ..) = reader.read_records(rows, None, None, &mut values)?;
    if read != rows {
        return Err(ParquetError::General(format!(
            "column {:?} holds {read} of {rows} rows",
            schema.column(column).name()
        )));
    }
    Ok(values)
}

/// Returns the index of a column by its name.
pub(crate) fn find_column(file: &dyn FileReader, name: &str) -> Option<usize> {
    let columns = file.metadata().file_metadata().schema_descr().columns();
    columns.iter().position(|column| column.name() == name)
}
