//! Records of an MCAP file, from its beginning. No index is needed, so a file without an end is readable; see
//! <https://mcap.dev/spec>.
//!
//! This module splits the records instead of the `mcap` crate, which reads beyond a chunk whose records claim to be
//! longer than the chunk.

use super::unpack::{UnpackError, unpack};
use crate::error::ReadFault;
use mcap::read::ChannelAccumulator;
use mcap::records::{Record, op};
use mcap::{Channel, MAGIC, McapError, parse_record};
use std::collections::BTreeMap;
use std::io::{self, Read};

/// Largest record that is read, unpacked [bytes]: above the largest chunks that recorders write.
const MAX_RECORD_LEN: usize = 256 << 20;

/// Length of kind and length of a record, before its body [bytes].
const HEAD_LEN: usize = 9;

/// An entry of a file.
pub(crate) enum Entry<'a> {
    /// A message: its channel, its time of recording [ns], and its bytes.
    Message(&'a Channel<'a>, u64, &'a [u8]),
    /// Metadata of the whole file: its name, and keys with values.
    Notes(&'a str, &'a BTreeMap<String, String>),
}

/// Callback that receives an entry.
pub(crate) type Take<'a> = dyn FnMut(Entry<'_>) -> Result<(), ReadFault> + 'a;

/// How a file ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ending {
    /// After its last record.
    Footer,
    /// Before its last record, at this byte.
    CutOff {
        /// Length of the file.
        byte: u64,
    },
}

/// Calls `each` with every entry, in the order of the file.
///
/// # Errors
/// If the file cannot be read, if `each` fails, or for every fault of the file except an early end.
pub(crate) fn entries(source: impl Read, each: &mut Take<'_>) -> Result<Ending, ReadFault> {
    let mut file = Records { source, byte: 0 };
    let magic = file.take(MAGIC.len() as u64)?;
    if magic.len() < MAGIC.len() && MAGIC.starts_with(&magic) {
        return Ok(Ending::CutOff { byte: file.byte });
    }
    if magic != MAGIC {
        let bytes: Vec<String> = magic.iter().map(|byte| format!("{byte:02x}")).collect();
        return Err(ReadFault::NotABag {
            found: bytes.join(" "),
        });
    }
    let mut known = ChannelAccumulator::default();
    loop {
        let byte = file.byte;
        let head = file.take(HEAD_LEN as u64)?;
        let Some((kind, len)) = kind_and_length(&head) else {
            return Ok(Ending::CutOff { byte: file.byte });
        };
        let is_read = [
            op::SCHEMA,
            op::CHANNEL,
            op::MESSAGE,
            op::CHUNK,
            op::METADATA,
        ]
        .contains(&kind);
        if !is_read {
            if file.skip(len)? < len {
                return Ok(Ending::CutOff { byte: file.byte });
            }
            if kind == op::FOOTER {
                return Ok(Ending::Footer);
            }
            continue;
        }
        if len > MAX_RECORD_LEN as u64 {
            return Err(ReadFault::RecordLength {
                byte,
                len,
                limit: MAX_RECORD_LEN,
            });
        }
        let body = file.take(len)?;
        if (body.len() as u64) < len {
            return Ok(Ending::CutOff { byte: file.byte });
        }
        record(kind, &body, byte, &mut known, each)?;
    }
}

/// A file and the position of the reader in it.
struct Records<R> {
    source: R,
    byte: u64,
}

impl<R: Read> Records<R> {
    /// Reads the next bytes; fewer at the file's end.
    fn take(&mut self, len: u64) -> Result<Vec<u8>, ReadFault> {
        let mut bytes = Vec::new();
        (self.source.by_ref().take(len))
            .read_to_end(&mut bytes)
            .map_err(ReadFault::System)?;
        self.byte += bytes.len() as u64;
        Ok(bytes)
    }

    /// Skips bytes and returns their number.
    fn skip(&mut self, len: u64) -> Result<u64, ReadFault> {
        let mut rest = self.source.by_ref().take(len);
        let skipped = io::copy(&mut rest, &mut io::sink()).map_err(ReadFault::System)?;
        self.byte += skipped;
        Ok(skipped)
    }
}

/// Parses the head of a record; `None` if it is cut off.
fn kind_and_length(head: &[u8]) -> Option<(u8, u64)> {
    let (kind, len) = head.split_first()?;
    Some((*kind, u64::from_le_bytes(len.try_into().ok()?)))
}

fn record(
    kind: u8,
    body: &[u8],
    byte: u64,
    known: &mut ChannelAccumulator<'static>,
    each: &mut Take<'_>,
) -> Result<(), ReadFault> {
    let damaged = |error: McapError| ReadFault::Damaged {
        byte,
        error: error.to_string(),
    };
    match parse_record(kind, body).map_err(damaged)? {
        Record::Schema { header, data } => {
            known.add_schema_from_slice(header, &data).map_err(damaged)
        }
        Record::Channel(channel) => known.add_channel(channel).map_err(damaged),
        Record::Message { header, data } => {
            let unknown = McapError::UnknownChannel(header.sequence, header.channel_id);
            let channel = known
                .get(header.channel_id)
                .ok_or_else(|| damaged(unknown))?;
            each(Entry::Message(&channel, header.log_time, &data))
        }
        Record::Metadata(notes) => each(Entry::Notes(&notes.name, &notes.metadata)),
        Record::Chunk { header, data } => {
            let plain =
                unpack(&header.compression, &data, MAX_RECORD_LEN).map_err(
                    |error| match error {
                        UnpackError::Unknown => ReadFault::Compression {
                            byte,
                            compression: header.compression.clone(),
                        },
                        UnpackError::TooLong => ReadFault::RecordLength {
                            byte,
                            len: header.uncompressed_size,
                            limit: MAX_RECORD_LEN,
                        },
                        UnpackError::Damaged(error) => ReadFault::Damaged { byte, error },
                    },
                )?;
            // The whole chunk is checked before any of its records is used.
            if plain.len() as u64 != header.uncompressed_size {
                let error = format!(
                    "a chunk unpacks to {} bytes, but states {}",
                    plain.len(),
                    header.uncompressed_size
                );
                return Err(ReadFault::Damaged { byte, error });
            }
            let (saved, calculated) = (header.uncompressed_crc, crc32fast::hash(&plain));
            if saved != 0 && saved != calculated {
                return Err(damaged(McapError::BadChunkCrc { saved, calculated }));
            }
            inner_records(&plain, byte, known, each)
        }
        _ => Ok(()),
    }
}

/// Splits the records of a chunk that begins at this byte of the file.
fn inner_records(
    mut plain: &[u8],
    byte: u64,
    known: &mut ChannelAccumulator<'static>,
    each: &mut Take<'_>,
) -> Result<(), ReadFault> {
    while !plain.is_empty() {
        let overrun = || ReadFault::Damaged {
            byte,
            error: McapError::UnexpectedEoc.to_string(),
        };
        let (head, rest) = plain.split_at_checked(HEAD_LEN).ok_or_else(overrun)?;
        let (kind, len) = kind_and_length(head).ok_or_else(overrun)?;
        let len = usize::try_from(len).map_err(|_| overrun())?;
        let (body, rest) = rest.split_at_checked(len).ok_or_else(overrun)?;
        plain = rest;
        // The format allows no chunks inside a chunk.
        if [op::SCHEMA, op::CHANNEL, op::MESSAGE].contains(&kind) {
            record(kind, body, byte, known, each)?;
        }
    }
    Ok(())
}
