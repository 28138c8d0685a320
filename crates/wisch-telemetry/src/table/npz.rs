//! Tables in archives of NumPy arrays (.npz): an array for each column, or an array with several columns.

use super::columnar::{Heads, MISSING, Values, check_rows, check_unpacked, damaged};
use crate::error::ReadFault;
use std::cell::RefCell;
use std::io::{Cursor, Read};
use zip::ZipArchive;
use zip::result::ZipError;

/// First bytes of an archive.
pub(super) const MAGIC: &[u8] = b"PK\x03\x04";

/// Name of the format in messages.
pub(super) const KIND: &str = "npz";

/// Largest number of arrays in an archive.
const MOST_MEMBERS: usize = 1000;

/// Largest number of columns in one array.
const MOST_PER_ROW: usize = 1024;

/// Largest length of an array's head [bytes].
const HEAD_READ: u64 = 65_536;

/// An archive, and the positions of its columns.
pub(super) struct NpzTable<'a> {
    archive: RefCell<ZipArchive<Cursor<&'a [u8]>>>,
    members: Vec<Member>,
    /// Member of the archive, and position in its rows, of each column.
    places: Vec<(usize, usize)>,
}

/// An array in the archive.
struct Member {
    /// Its index in the archive.
    index: usize,
    name: String,
    head: Head,
}

/// Head of an array.
#[derive(Debug, Clone, PartialEq)]
struct Head {
    /// Its length [bytes].
    len: usize,
    is_big_endian: bool,
    kind: char,
    /// Length of a number [bytes].
    size: usize,
    /// Unit of dates and durations [ns].
    unit: i64,
    by_columns: bool,
    rows: usize,
    per_row: usize,
}

/// Opens an archive and reads the names of its columns.
pub(super) fn open(bytes: &[u8]) -> Result<(Heads, NpzTable<'_>), ReadFault> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(fault)?;
    if archive.len() > MOST_MEMBERS {
        let count = archive.len();
        let error = format!("{count} arrays exceed the limit of {MOST_MEMBERS}");
        return Err(damaged(KIND, error));
    }
    let (mut heads, mut members, mut places) = (Heads::default(), Vec::new(), Vec::new());
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(fault)?;
        let name = file.name().map_err(fault)?.into_owned();
        let Some(name) = name.strip_suffix(".npy") else {
            continue;
        };
        let mut begin = Vec::new();
        let read = file.take(HEAD_READ).read_to_end(&mut begin);
        read.map_err(|error| damaged(KIND, error))?;
        let Some(head) = Head::parse(&begin) else {
            heads.unread.push(name.to_owned());
            continue;
        };
        for place in 0..head.per_row {
            places.push((members.len(), place));
            heads.names.push(match head.per_row {
                1 => name.to_owned(),
                _ => format!("{name}_{place}"),
            });
        }
        members.push(Member {
            index,
            name: name.to_owned(),
            head,
        });
    }
    if heads.names.is_empty() && heads.unread.is_empty() {
        return Err(damaged(KIND, "the archive holds no array of NumPy (.npy)"));
    }
    let table = NpzTable {
        archive: RefCell::new(archive),
        members,
        places,
    };
    Ok((heads, table))
}

/// Reads the columns with these indices, in the order of the archive.
pub(super) fn read(table: &NpzTable<'_>, indices: &[usize]) -> Result<Vec<Values>, ReadFault> {
    let mut archive = table.archive.borrow_mut();
    let mut columns = Vec::with_capacity(indices.len());
    let mut unpacked: Option<(usize, Vec<u8>)> = None;
    for &index in indices {
        let (number, place) = table.places[index];
        let member = &table.members[number];
        let bytes = match unpacked.take() {
            Some((last, bytes)) if last == number => bytes,
            _ => member.unpack(&mut archive)?,
        };
        columns.push(member.column(&bytes, place)?);
        unpacked = Some((number, bytes));
    }
    Ok(columns)
}

fn fault(error: ZipError) -> ReadFault {
    damaged(KIND, error)
}

impl Head {
    /// Parses the head of an array; `None` if the array is not a table of numbers.
    fn parse(bytes: &[u8]) -> Option<Self> {
        let version = *bytes.strip_prefix(b"\x93NUMPY")?.first()?;
        let (start, text_len) = match version {
            1 => (
                10,
                u16::from_le_bytes(*bytes.get(8..)?.first_chunk()?).into(),
            ),
            _ => (12, u32::from_le_bytes(*bytes.get(8..)?.first_chunk()?)),
        };
        let len = usize::try_from(text_len).ok()?.checked_add(start)?;
        let text = std::str::from_utf8(bytes.get(start..len)?).ok()?;
        let value = |key: &str| {
            let (_, value) = text.split_once(key)?;
            Some(value.trim_start_matches(['\'', '"', ':', ' ']))
        };
        let descr = value("descr")?.split(['\'', '"']).next()?;
        let shape = value("shape")?.strip_prefix('(')?.split(')').next()?;
        let shape = shape.split(',').map(str::trim);
        let shape = shape.filter(|part| !part.is_empty());
        let shape: Vec<usize> = shape.map(|part| part.parse().ok()).collect::<Option<_>>()?;
        let (rows, per_row) = match shape[..] {
            [rows] => (rows, 1),
            [rows, per_row] if (1..=MOST_PER_ROW).contains(&per_row) => (rows, per_row),
            _ => return None,
        };
        let mut chars = descr.chars();
        let (order, kind) = (chars.next()?, chars.next()?);
        let size: usize = chars.as_str().split('[').next()?.parse().ok()?;
        let unit = time_unit(descr);
        let is_read = match kind {
            'f' => [4, 8].contains(&size),
            'i' | 'u' => [1, 2, 4, 8].contains(&size),
            'M' | 'm' => size == 8 && unit.is_some(),
            _ => false,
        };
        is_read.then_some(Self {
            len,
            is_big_endian: order == '>',
            kind,
            size,
            unit: unit.unwrap_or(1),
            by_columns: value("fortran_order")?.starts_with("True"),
            rows,
            per_row,
        })
    }
}

/// Returns the unit of a date or duration [ns]: datetime64[ns] is "<M8[ns]".
fn time_unit(descr: &str) -> Option<i64> {
    Some(match descr.split_once('[')?.1 {
        "s]" => 1_000_000_000,
        "ms]" => 1_000_000,
        "us]" => 1000,
        "ns]" => 1,
        _ => return None,
    })
}

impl Member {
    /// Unpacks the numbers of the array.
    fn unpack(&self, archive: &mut ZipArchive<Cursor<&[u8]>>) -> Result<Vec<u8>, ReadFault> {
        let head = &self.head;
        check_rows(head.rows)?;
        let numbers = head.rows.saturating_mul(head.per_row);
        let len = numbers.saturating_mul(head.size);
        check_unpacked(format_args!("array {:?}", self.name), len as u64)?;
        let mut file = archive.by_index(self.index).map_err(fault)?;
        let mut bytes = Vec::new();
        // Reading one byte more than expected reaches the end, where the archive's checksum is verified.
        let mut source = (&mut file).take((head.len + len + 1) as u64);
        let read = source.read_to_end(&mut bytes);
        read.map_err(|error| damaged(KIND, format!("array {:?}: {error}", self.name)))?;
        if bytes.len() != head.len + len {
            let (found, expected) = (bytes.len().saturating_sub(head.len), len);
            let error = format!(
                "array {:?} has {found} bytes of numbers; expected {expected}",
                self.name
            );
            return Err(damaged(KIND, error));
        }
        Ok(bytes.split_off(head.len))
    }

    /// Returns the numbers at one position of each row.
    fn column(&self, bytes: &[u8], place: usize) -> Result<Values, ReadFault> {
        let head = &self.head;
        let (of_row, of_place) = if head.by_columns {
            (1, head.rows)
        } else {
            (head.per_row, 1)
        };
        let bits = bytes.chunks_exact(head.size).skip(place * of_place);
        let bits = bits.step_by(of_row).take(head.rows).map(|bytes| {
            let join = |number: u64, byte: &u8| (number << 8) | u64::from(*byte);
            if head.is_big_endian {
                bytes.iter().fold(0, join)
            } else {
                bytes.iter().rev().fold(0, join)
            }
        });
        // Sign extension: the top bit holds the sign.
        let signed = |bits: u64| {
            let unused = 64 - 8 * head.size;
            (bits << unused) as i64 >> unused
        };
        Ok(match (head.kind, head.size) {
            ('f', 4) => Values::Reals(
                bits.map(|bits| f32::from_bits(bits as u32).into())
                    .collect(),
            ),
            ('f', _) => Values::Reals(bits.map(f64::from_bits).collect()),
            // A duration is exact as a date, and in seconds it is not.
            ('M' | 'm', _) => {
                let date = |time: i64| match time {
                    MISSING => MISSING,
                    time => time.saturating_mul(head.unit),
                };
                Values::Dates(
                    bits.map(|bits| date(bits as i64)).collect(),
                    head.kind == 'm',
                )
            }
            ('u', _) => {
                let whole = |bits: u64| i64::try_from(bits).unwrap_or(i64::MAX);
                Values::Whole(bits.map(whole).collect())
            }
            _ => Values::Whole(bits.map(signed).collect()),
        })
    }
}
