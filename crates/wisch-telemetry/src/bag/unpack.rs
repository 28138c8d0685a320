//! Unpacks the chunks of a bag.

use ruzstd::decoding::StreamingDecoder;
use std::borrow::Cow;
use std::io::{self, Read};

/// Why a chunk cannot be unpacked.
#[derive(Debug)]
pub(crate) enum UnpackError {
    /// It is packed in a way that is not read.
    Unknown,
    /// It is longer than the limit.
    TooLong,
    /// What the unpacking says.
    Damaged(String),
}

impl From<io::Error> for UnpackError {
    fn from(error: io::Error) -> Self {
        Self::Damaged(error.to_string())
    }
}

/// A chunk's records, by the name of how they are packed. Never more than `limit` bytes come out.
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

fn unzstd(mut packed: &[u8], limit: usize) -> Result<Vec<u8>, UnpackError> {
    let mut plain = Vec::new();
    // A chunk may hold several frames.
    while !packed.is_empty() {
        let frame = StreamingDecoder::new(&mut packed)
            .map_err(|error| UnpackError::Damaged(error.to_string()))?;
        append(frame, &mut plain, limit)?;
    }
    Ok(plain)
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
    use ruzstd::encoding::{CompressionLevel, compress_to_vec};
    use std::io::Write;

    const LIMIT: usize = 1 << 20;

    fn text() -> Vec<u8> {
        (0..3000)
            .flat_map(|i| format!("line {i}\n").into_bytes())
            .collect()
    }

    fn zstd() -> Vec<u8> {
        compress_to_vec(text().as_slice(), CompressionLevel::Fastest)
    }

    fn lz4() -> Vec<u8> {
        let mut encoder = lz4::EncoderBuilder::new().build(Vec::new()).unwrap();
        encoder.write_all(&text()).unwrap();
        let (packed, result) = encoder.finish();
        result.unwrap();
        packed
    }

    #[test]
    fn chunks_come_out_whole() {
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
    fn too_long_or_damaged_chunks_are_refused() {
        for (name, packed) in [("lz4", lz4()), ("zstd", zstd())] {
            let short = unpack(name, &packed, text().len() - 1);
            assert!(matches!(short, Err(UnpackError::TooLong)), "{name}");
            assert!(unpack(name, &packed, text().len()).is_ok(), "{name}");
            let half = unpack(name, &packed[..packed.len() / 2], LIMIT);
            // A cut may fall between blocks: then less comes out, which the chunk's header tells.
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
