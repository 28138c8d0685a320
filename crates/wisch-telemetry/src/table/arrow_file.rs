//! Tables in Arrow's interprocess format: files (Feather) and streams.

use super::arrow::{CONTINUATION, FEATHER_1, MAGIC};
use super::columnar::{Heads, MISSING, Texts, Values, check_rows, check_unpacked, damaged};
use crate::error::ReadFault;
use arrow_array::cast::AsArray;
use arrow_array::types::{
    ArrowPrimitiveType, DurationMicrosecondType, DurationMillisecondType, DurationNanosecondType,
    DurationSecondType, Float16Type, Float32Type, Float64Type, Int8Type, Int16Type, Int32Type,
    Int64Type, TimestampMicrosecondType, TimestampMillisecondType, TimestampNanosecondType,
    TimestampSecondType, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, ArrayRef};
use arrow_buffer::Buffer;
use arrow_ipc::convert::fb_to_schema;
use arrow_ipc::reader::read_record_batch;
use arrow_ipc::{Endianness, Message, MessageHeader, RecordBatch, root_as_message};
use arrow_schema::{ArrowError, DataType, SchemaRef, TimeUnit};
use std::collections::HashMap;
use std::sync::Arc;

/// Name of the format in messages.
pub(super) const KIND: &str = "Arrow";

/// Length of the magic bytes with the zeros that pad them to a multiple of 8 bytes.
const HEAD_LEN: usize = 8;
const ZEROS: [u8; 8] = [0; 8];

/// Length prefix that marks an unpacked buffer in a packed message.
const NOT_PACKED: i64 = -1;

/// A file after its schema, and the indices of its columns among the fields of the schema.
pub(super) struct ArrowTable<'a> {
    messages: Messages<'a>,
    schema: SchemaRef,
    fields: Vec<usize>,
}

/// Opens a file and reads the names of its columns.
pub(super) fn open(bytes: &[u8]) -> Result<(Heads, ArrowTable<'_>), ReadFault> {
    let mut messages = Messages::of(bytes)?;
    let schema = messages.next().transpose()?;
    let schema = schema.and_then(|(message, _)| message.header_as_schema());
    let schema = schema.ok_or_else(|| damaged(KIND, "it does not begin with a schema"))?;
    if schema.endianness() != Endianness::Little {
        return Err(damaged(
            KIND,
            "its numbers are big-endian, but only little-endian is read",
        ));
    }
    let schema = Arc::new(fb_to_schema(schema));
    let (mut heads, mut fields) = (Heads::default(), Vec::new());
    for (index, field) in schema.fields().iter().enumerate() {
        if field.data_type().is_nested() {
            heads.unread.push(field.name().clone());
        } else {
            heads.names.push(field.name().clone());
            fields.push(index);
        }
    }
    let table = ArrowTable {
        messages,
        schema,
        fields,
    };
    Ok((heads, table))
}

/// Reads the columns with these indices.
pub(super) fn read(table: &ArrowTable<'_>, indices: &[usize]) -> Result<Vec<Values>, ReadFault> {
    let fields: Vec<usize> = indices.iter().map(|&index| table.fields[index]).collect();
    let mut columns = Vec::with_capacity(fields.len());
    for &field in &fields {
        let field = table.schema.field(field);
        columns.push(
            empty(field.data_type()).ok_or_else(|| ReadFault::ColumnType {
                column: field.name().clone(),
                kind: field.data_type().to_string(),
            })?,
        );
    }
    let mut rows = 0_usize;
    for message in table.messages.clone() {
        let (message, body) = message?;
        // Dictionaries are not supported.
        if message.header_type() == MessageHeader::DictionaryBatch {
            continue;
        }
        let batch = message.header_as_record_batch();
        let batch = batch.ok_or_else(|| damaged(KIND, "a message holds no rows"))?;
        rows = rows.saturating_add(usize::try_from(batch.length()).unwrap_or(usize::MAX));
        check_rows(rows)?;
        check_buffers(&batch, body)?;
        let read = read_record_batch(
            &Buffer::from(body.to_vec()),
            batch,
            table.schema.clone(),
            &HashMap::new(),
            Some(&fields),
            &message.version(),
        )
        .map_err(fault)?;
        for ((array, values), &field) in read.columns().iter().zip(&mut columns).zip(&fields) {
            append(array, table.schema.field(field).name(), values)?;
        }
    }
    Ok(columns)
}

fn fault(error: ArrowError) -> ReadFault {
    damaged(KIND, error)
}

/// Iterator over the messages of a file or stream, each with its body.
#[derive(Debug, Clone)]
struct Messages<'a> {
    rest: &'a [u8],
}

impl<'a> Messages<'a> {
    fn of(bytes: &'a [u8]) -> Result<Self, ReadFault> {
        if bytes.starts_with(FEATHER_1) {
            let error = "version 1 of Feather is not read; write version 2";
            return Err(damaged(KIND, error));
        }
        if !bytes.starts_with(MAGIC) {
            return Ok(Self { rest: bytes });
        }
        // A file is a stream, followed by the positions and lengths of its messages and by the magic bytes.
        let rest = bytes.get(HEAD_LEN..).and_then(|rest| {
            let (rest, len) = rest.strip_suffix(MAGIC)?.split_last_chunk()?;
            let len = usize::try_from(i32::from_le_bytes(*len)).ok()?;
            rest.get(..rest.len().checked_sub(len)?)
        });
        let mut rest = rest.ok_or_else(|| damaged(KIND, "it is cut off: its end is missing"))?;
        while let Some(messages) = rest.strip_prefix(&ZEROS) {
            rest = messages;
        }
        Ok(Self { rest })
    }

    fn read(&mut self) -> Option<Result<(Message<'a>, &'a [u8]), ReadFault>> {
        let rest = self.rest.strip_prefix(&CONTINUATION).unwrap_or(self.rest);
        if rest.is_empty() || rest.starts_with(&[0; 4]) {
            return None;
        }
        let taken = |rest: &'a [u8]| -> Option<(&'a [u8], &'a [u8])> {
            let (len, rest) = rest.split_first_chunk()?;
            rest.split_at_checked(usize::try_from(i32::from_le_bytes(*len)).ok()?)
        };
        let cut = || damaged(KIND, "a message is cut off");
        let Some((head, rest)) = taken(rest) else {
            return Some(Err(cut()));
        };
        let message = match root_as_message(head) {
            Ok(message) => message,
            Err(error) => return Some(Err(damaged(KIND, error))),
        };
        let body = usize::try_from(message.bodyLength()).ok();
        let Some((body, rest)) = body.and_then(|len| rest.split_at_checked(len)) else {
            return Some(Err(cut()));
        };
        self.rest = rest;
        Some(Ok((message, body)))
    }
}

impl<'a> Iterator for Messages<'a> {
    type Item = Result<(Message<'a>, &'a [u8]), ReadFault>;

    fn next(&mut self) -> Option<Self::Item> {
        let message = self.read();
        if !matches!(message, Some(Ok(_))) {
            self.rest = &[];
        }
        message
    }
}

/// Checks that the buffers of a batch exist, and how long they are when unpacked: the reader trusts both.
fn check_buffers(batch: &RecordBatch<'_>, body: &[u8]) -> Result<(), ReadFault> {
    let cut = || damaged(KIND, "a column of some rows is cut off");
    let is_packed = batch.compression().is_some();
    let mut unpacked = 0_u64;
    for buffer in batch.buffers().into_iter().flatten() {
        let [start, len] = [buffer.offset(), buffer.length()].map(usize::try_from);
        let (start, len) = (start.map_err(|_| cut())?, len.map_err(|_| cut())?);
        let end = start.checked_add(len).ok_or_else(cut)?;
        let bytes = body.get(start..end).ok_or_else(cut)?;
        let stated = bytes
            .first_chunk()
            .map(|stated| i64::from_le_bytes(*stated));
        let len = match stated.filter(|&stated| is_packed && stated != NOT_PACKED) {
            Some(stated) => u64::try_from(stated).map_err(|_| cut())?,
            None => len as u64,
        };
        unpacked = unpacked.saturating_add(len);
    }
    check_unpacked("a batch of rows", unpacked)
}

/// Returns an empty column of a type, if the type is supported.
fn empty(kind: &DataType) -> Option<Values> {
    Some(match kind {
        DataType::Float16 | DataType::Float32 | DataType::Float64 => Values::Reals(Vec::new()),
        DataType::Int8
        | DataType::Int16
        | DataType::Int32
        | DataType::Int64
        | DataType::UInt8
        | DataType::UInt16
        | DataType::UInt32
        | DataType::UInt64 => Values::Whole(Vec::new()),
        DataType::Timestamp(_, zone) => Values::Dates(Vec::new(), zone.is_some()),
        // A duration is exact as a date, and in seconds it is not.
        DataType::Duration(_) => Values::Dates(Vec::new(), true),
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => {
            Values::Texts(Texts::default())
        }
        _ => return None,
    })
}

/// Appends the values of a batch of rows.
fn append(array: &ArrayRef, name: &str, values: &mut Values) -> Result<(), ReadFault> {
    let is_appended = match values {
        Values::Reals(reals) => append_reals(array, reals),
        Values::Whole(whole) => append_whole(array, whole),
        Values::Dates(dates, _) => append_dates(array, dates),
        Values::Texts(texts) => return append_texts(array, name, texts),
    };
    is_appended.ok_or_else(|| damaged(KIND, "some rows have another type than the schema"))
}

fn append_reals(array: &ArrayRef, reals: &mut Vec<f64>) -> Option<()> {
    let missing = f64::NAN;
    match array.data_type() {
        DataType::Float16 => each::<Float16Type, _>(array, reals, missing, |n| n.to_f64()),
        DataType::Float32 => each::<Float32Type, _>(array, reals, missing, f64::from),
        DataType::Float64 => each::<Float64Type, _>(array, reals, missing, |n| n),
        _ => None,
    }
}

fn append_whole(array: &ArrayRef, whole: &mut Vec<i64>) -> Option<()> {
    match array.data_type() {
        DataType::Int8 => each::<Int8Type, _>(array, whole, MISSING, i64::from),
        DataType::Int16 => each::<Int16Type, _>(array, whole, MISSING, i64::from),
        DataType::Int32 => each::<Int32Type, _>(array, whole, MISSING, i64::from),
        DataType::Int64 => each::<Int64Type, _>(array, whole, MISSING, |n| n),
        DataType::UInt8 => each::<UInt8Type, _>(array, whole, MISSING, i64::from),
        DataType::UInt16 => each::<UInt16Type, _>(array, whole, MISSING, i64::from),
        DataType::UInt32 => each::<UInt32Type, _>(array, whole, MISSING, i64::from),
        DataType::UInt64 => each::<UInt64Type, _>(array, whole, MISSING, |n| {
            i64::try_from(n).unwrap_or(i64::MAX)
        }),
        _ => None,
    }
}

fn append_dates(array: &ArrayRef, dates: &mut Vec<i64>) -> Option<()> {
    let size = match array.data_type() {
        DataType::Timestamp(unit, _) | DataType::Duration(unit) => nanoseconds(*unit),
        _ => return None,
    };
    let date = |n: i64| n.saturating_mul(size);
    match array.data_type() {
        DataType::Timestamp(unit, _) => match unit {
            TimeUnit::Second => each::<TimestampSecondType, _>(array, dates, MISSING, date),
            TimeUnit::Millisecond => {
                each::<TimestampMillisecondType, _>(array, dates, MISSING, date)
            }
            TimeUnit::Microsecond => {
                each::<TimestampMicrosecondType, _>(array, dates, MISSING, date)
            }
            TimeUnit::Nanosecond => each::<TimestampNanosecondType, _>(array, dates, MISSING, date),
        },
        DataType::Duration(unit) => match unit {
            TimeUnit::Second => each::<DurationSecondType, _>(array, dates, MISSING, date),
            TimeUnit::Millisecond => {
                each::<DurationMillisecondType, _>(array, dates, MISSING, date)
            }
            TimeUnit::Microsecond => {
                each::<DurationMicrosecondType, _>(array, dates, MISSING, date)
            }
            TimeUnit::Nanosecond => each::<DurationNanosecondType, _>(array, dates, MISSING, date),
        },
        _ => None,
    }
}

/// Returns the length of a unit of time [ns].
const fn nanoseconds(unit: TimeUnit) -> i64 {
    match unit {
        TimeUnit::Second => 1_000_000_000,
        TimeUnit::Millisecond => 1_000_000,
        TimeUnit::Microsecond => 1000,
        TimeUnit::Nanosecond => 1,
    }
}

/// Appends each value of a numeric array, and `missing` for each missing value.
fn each<T: ArrowPrimitiveType, V: Copy>(
    array: &ArrayRef,
    values: &mut Vec<V>,
    missing: V,
    of: impl Fn(T::Native) -> V,
) -> Option<()> {
    let numbers = array.as_primitive_opt::<T>()?.iter();
    values.extend(numbers.map(|number| number.map_or(missing, &of)));
    Some(())
}

fn append_texts(array: &ArrayRef, name: &str, texts: &mut Texts) -> Result<(), ReadFault> {
    let mut push = |text: Option<&str>| texts.push(name, text.unwrap_or_default());
    if let Some(array) = array.as_string_opt::<i32>() {
        return array.iter().try_for_each(&mut push);
    }
    if let Some(array) = array.as_string_opt::<i64>() {
        return array.iter().try_for_each(&mut push);
    }
    match array.as_string_view_opt() {
        Some(array) => array.iter().try_for_each(push),
        None => Err(damaged(KIND, "some rows have another type than the schema")),
    }
}
