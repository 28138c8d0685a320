//! Recordings as they lie in folders.

use crate::error::{RecordError, internal};
use flate2::{Compression, GzBuilder};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

/// Most bytes of a recording that is read.
const MAX_BYTES: u64 = 512 << 20;

/// A recording as it lies in a folder, by gzip: the same recording is the same bytes.
pub(crate) fn packed(recording: &[u8]) -> Result<Vec<u8>, RecordError> {
    let mut packing = GzBuilder::new().write(Vec::new(), Compression::default());
    let packed = packing.write_all(recording).and_then(|()| packing.finish());
    packed.map_err(internal)
}

/// Reads the text of a recording from a file that [`write_results`](crate::write_results) or an episode holds.
///
/// # Errors
/// A file that cannot be read, or a recording of more than 512 MiB.
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
