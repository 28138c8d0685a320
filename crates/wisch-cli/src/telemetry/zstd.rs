//! Unpacks chunks that are compressed with Zstandard, as many recorders do.

use mcap::sans_io::decompressor::{DecompressResult, Decompressor};
use mcap::{McapError, McapResult};
use ruzstd::decoding::StreamingDecoder;
use std::io::Read;

/// Unpacks a chunk whole on the first call, and hands it out as there is room.
pub(super) struct Zstd {
    /// Longest chunk that is unpacked [bytes].
    limit: usize,
    /// The chunk, once it is unpacked.
    plain: Option<Vec<u8>>,
    /// How much of it was handed out [bytes].
    handed: usize,
}

impl Zstd {
    /// Unpacks chunks up to a length [bytes].
    pub fn new(limit: usize) -> Self {
        Self {
            limit,
            plain: None,
            handed: 0,
        }
    }

    fn unpack(&self, mut packed: &[u8]) -> McapResult<Vec<u8>> {
        let mut plain = Vec::new();
        // A chunk may hold several frames.
        while !packed.is_empty() {
            let left = (self.limit - plain.len()) as u64;
            let frame = StreamingDecoder::new(&mut packed)
                .map_err(|error| McapError::DecompressionError(error.to_string()))?;
            frame.take(left + 1).read_to_end(&mut plain)?;
            if plain.len() > self.limit {
                return Err(McapError::ChunkTooLarge(plain.len() as u64));
            }
        }
        Ok(plain)
    }
}

impl Decompressor for Zstd {
    fn next_read_size(&self) -> usize {
        // All that the chunk has.
        usize::MAX
    }

    fn decompress(&mut self, packed: &[u8], room: &mut [u8]) -> McapResult<DecompressResult> {
        let (consumed, plain) = match self.plain.take() {
            Some(plain) => (0, plain),
            None => (packed.len(), self.unpack(packed)?),
        };
        let rest = &plain[self.handed..];
        let wrote = rest.len().min(room.len());
        room[..wrote].copy_from_slice(&rest[..wrote]);
        self.handed += wrote;
        self.plain = Some(plain);
        Ok(DecompressResult { consumed, wrote })
    }

    fn reset(&mut self) -> McapResult<()> {
        *self = Self::new(self.limit);
        Ok(())
    }

    fn name(&self) -> &'static str {
        "zstd"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ruzstd::encoding::{CompressionLevel, compress_to_vec};

    fn text() -> Vec<u8> {
        (0..3000)
            .flat_map(|i| format!("line {i}\n").into_bytes())
            .collect()
    }

    #[test]
    fn frames_come_out_whole_however_small_the_room() {
        let frame = compress_to_vec(text().as_slice(), CompressionLevel::Fastest);
        let packed = [frame.clone(), frame].concat();
        let mut zstd = Zstd::new(1 << 20);
        for room_len in [7, 1 << 20] {
            let (mut plain, mut room, mut left) =
                (Vec::new(), vec![0; room_len], packed.as_slice());
            loop {
                let result = zstd.decompress(left, &mut room).unwrap();
                left = &left[result.consumed..];
                plain.extend_from_slice(&room[..result.wrote]);
                if result.wrote == 0 {
                    break;
                }
            }
            assert_eq!(plain, [text(), text()].concat());
            zstd.reset().unwrap();
        }
    }

    #[test]
    fn too_long_or_damaged_chunks_are_refused() {
        let mut packed = compress_to_vec(text().as_slice(), CompressionLevel::Fastest);
        let refused = Zstd::new(100)
            .decompress(&packed, &mut [0; 10])
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            "chunk (de)compressed length exceeds limit: `101`"
        );
        packed.truncate(packed.len() / 2);
        assert!(
            Zstd::new(1 << 20)
                .decompress(&packed, &mut [0; 10])
                .is_err()
        );
        assert!(
            Zstd::new(1 << 20)
                .decompress(b"no frame", &mut [0; 10])
                .is_err()
        );
    }
}
