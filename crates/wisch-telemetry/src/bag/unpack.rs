//! Decompression of a bag's chunks and messages.

use crate::error::ReadFault;
use std::borrow::Cow;
use std::io::{self, Read};

/// A reason why a chunk cannot be unpacked.
#[derive(Debug)]
pub(crate) enum UnpackError {
    /// Its compression is unknown.
    Unknown,
    /// It is larger than the limit.
    TooLong,
    /// The decompressor's error.
    Damaged(String),
}

impl From<io::Error> for UnpackError {
    fn from(error: io::Error) -> Self {
        Self::Damaged(error.to_string())
    }
}

/// Unpacks a chunk's records, given the name of their compression. Returns at most `limit` bytes.
pub(crate) fn unpack<'a>(
    compression: &str,
    packed: &'a [u8],
    limit: usize,
) -> Result<Cow<'a, [u8]>, UnpackError> {
    match compression {
        "" => Ok(packed.into()),
        "lz4" => {
            let mut plain = Vec::new();
            append(lz4::Decoder::new(packed)?, &mut plain, limit)?;
            Ok(plain.into())
        }
        "zstd" => unzstd(packed, limit).map(Into::into),
        _ => Err(UnpackError::Unknown),
    }
}

/// Unpacks Zstandard data, which may consist of several frames.
fn unzstd(packed: &[u8], limit: usize) -> Result<Vec<u8>, UnpackError> {
    let mut plain = Vec::new();
    append(zstd::Decoder::with_buffer(packed)?, &mut plain, limit)?;
    Ok(plain)
}

/// First bytes of a Zstandard frame; a CDR message begins with a zero.
const ZSTD_MAGIC: [u8; 4] = [0x28, 0xb5, 0x2f, 0xfd];

/// Largest unpacked message [bytes].
const MAX_MESSAGE_LEN: usize = 64 << 20;

/// Whether a single message is packed, as rosbag2 does in its compression mode for messages.
pub(crate) fn is_packed(message: &[u8]) -> bool {
    message.starts_with(&ZSTD_MAGIC)
}

/// Unpacks a message that was packed by itself.
pub(crate) fn unpack_message(topic: &str, message: &[u8]) -> Result<Vec<u8>, ReadFault> {
    unzstd(message, MAX_MESSAGE_LEN).map_err(|error| ReadFault::PackedMessage {
        topic: topic.to_owned(),
        error: match error {
            UnpackError::Damaged(error) => error,
            UnpackError::TooLong | UnpackError::Unknown => {
                format!("it exceeds the limit of {MAX_MESSAGE_LEN} bytes")
            }
        },
    })
}

fn append(source: impl Read, plain: &mut Vec<u8>, limit: usize) -> Result<(), UnpackError> {
    let left = (limit - plain.len()) as u64;
    source.take(left + 1).read_to_end(plain)?;
    if plain.len() > limit {
        return Err(UnpackError::TooLong);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    const LIMIT: usize = 1 << 20;

    fn text() -> Vec<u8> {
        (0..3000)
            .flat_map(|i| format!("line {i}\n").into_bytes())
            .collect()
    }

    fn zstd() -> Vec<u8> {
        zstd::encode_all(text().as_slice(), 1).unwrap()
    }

    fn lz4() -> Vec<u8> {
        let mut encoder = lz4::EncoderBuilder::new().build(Vec::new()).unwrap();
        encoder.write_all(&text()).unwrap();
        let (packed, result) = encoder.finish();
        result.unwrap();
        packed
    }

    #[test]
    fn chunks_are_unpacked_completely() {
        assert_eq!(*unpack("", &text(), LIMIT).unwrap(), text());
        assert_eq!(*unpack("lz4", &lz4(), LIMIT).unwrap(), text());
        assert_eq!(*unpack("zstd", &zstd(), LIMIT).unwrap(), text());
        let twice = [zstd(), zstd()].concat();
        assert_eq!(
            *unpack("zstd", &twice, LIMIT).unwrap(),
            [text(), text()].concat()
        );
        assert!(matches!(
            unpack("bz2", &zstd(), LIMIT),
            Err(UnpackError::Unknown)
        ));
    }

    #[test]
    fn a_message_is_unpacked_completely() {
        assert!(is_packed(&zstd()) && !is_packed(&[0, 1, 0, 0]));
        assert_eq!(unpack_message("/p", &zstd()).unwrap(), text());
        let refused = unpack_message("/p", &zstd()[..9]).unwrap_err().to_string();
        assert!(
            refused.starts_with("topic /p: a packed message cannot be unpacked: "),
            "{refused}"
        );
    }

    #[test]
    fn too_long_or_damaged_chunks_are_refused() {
        for (name, packed) in [("lz4", lz4()), ("zstd", zstd())] {
            let short = unpack(name, &packed, text().len() - 1);
            assert!(matches!(short, Err(UnpackError::TooLong)), "{name}");
            assert!(unpack(name, &packed, text().len()).is_ok(), "{name}");
            let half = unpack(name, &packed[..packed.len() / 2], LIMIT);
            // A cut between blocks gives fewer bytes, which the chunk's header reveals.
            assert!(
                half.is_err() || half.is_ok_and(|plain| plain.len() < text().len()),
                "{name}"
            );
            assert!(
                unpack(name, b"no frame of any kind", LIMIT).is_err(),
                "{name}"
            );
        }
    }
}
