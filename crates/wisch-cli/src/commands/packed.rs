//! Recordings as they lie in folders.

use super::words::internal;
use crate::failure::Failure;
use flate2::{Compression, GzBuilder};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

/// Most bytes of a recording that is read.
const MAX_BYTES: u64 = 512 << 20;

/// A recording as it lies in a folder: the same recording is the same bytes.
pub fn packed(recording: &[u8]) -> Result<Vec<u8>, Failure> {
    let mut packing = GzBuilder::new().write(Vec::new(), Compression::default());
    let packed = packing.write_all(recording).and_then(|()| packing.finish());
    packed.map_err(internal)
}

/// The text of a recording that lies in a file.
pub fn read_packed(path: &Path) -> Result<String, Failure> {
    let broken = |error: io::Error| {
        Failure::new(format!(
            "{}: cannot read the recording: {error}",
            path.display()
        ))
    };
    let file = File::open(path).map_err(broken)?;
    let mut text = String::new();
    let mut unpacking = flate2::read::GzDecoder::new(file).take(MAX_BYTES + 1);
    unpacking.read_to_string(&mut text).map_err(broken)?;
    if text.len() as u64 > MAX_BYTES {
        return Err(Failure::new(format!(
            "{}: the recording is longer than {} MiB",
            path.display(),
            MAX_BYTES >> 20
        )));
    }
    Ok(text)
}
