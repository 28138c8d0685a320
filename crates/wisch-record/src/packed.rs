//! Compressed recordings in folders of results and episodes.

use crate::error::{RecordError, internal};
use flate2::{Compression, GzBuilder};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

/// Largest size of a recording that is read [bytes].
const MAX_BYTES: u64 = 512 << 20;

/// Compresses a recording with gzip; equal recordings give equal bytes.
pub(crate) fn pack(recording: &[u8]) -> Result<Vec<u8>, RecordError> {
    let mut packing = GzBuilder::new().write(Vec::new(), Compression::default());
    let packed = packing.write_all(recording).and_then(|()| packing.finish());
    packed.map_err(internal)
}

/// Reads a recording from a file that [`write_results`](crate::write_results) has written, or from an episode's.
///
/// # Errors
/// If the file cannot be read, or if the recording exceeds 512 MiB.
pub fn read_recording(path: &Path) -> Result<String, RecordError> {
    let broken = |error: io::Error| RecordError::Unreadable {
        place: path.to_owned(),
        error,
    };
    let file = File::open(path).map_err(broken)?;
    let mut text = String::new();
    let mut unpacking = flate2::read::GzDecoder::new(file).take(MAX_BYTES + 1);
    unpacking.read_to_string(&mut text).map_err(broken)?;
    if text.len() as u64 > MAX_BYTES {
        return Err(RecordError::TooLong {
            place: path.to_owned(),
            limit_mib: MAX_BYTES >> 20,
        });
    }
    Ok(text)
}
