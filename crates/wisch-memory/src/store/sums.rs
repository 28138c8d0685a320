//! Check sums of an episode's files.

use super::error::{MemoryError, at};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Where they stand in an episode.
pub(super) const SUMS_FILE: &str = "checksums.json";

/// Read at a time [bytes].
const BLOCK: usize = 1 << 16;

/// Of every file by name.
pub(super) type Sums = BTreeMap<String, FileSum>;

/// What a file was when it was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct FileSum {
    /// Its length [bytes].
    bytes: u64,
    /// Its CRC-32, as in zip files.
    crc32: u32,
}

impl FileSum {
    /// Of a file as it is now.
    pub(super) fn of(path: &Path) -> Result<Self, MemoryError> {
        let mut file = File::open(path).map_err(at(path))?;
        let mut hasher = crc32fast::Hasher::new();
        let mut bytes = 0;
        let mut block = vec![0; BLOCK];
        loop {
            match file.read(&mut block).map_err(at(path))? {
                0 => break,
                read => {
                    hasher.update(&block[..read]);
                    bytes += read as u64;
                }
            }
        }
        Ok(Self {
            bytes,
            crc32: hasher.finalize(),
        })
    }

    /// How a file differs from this.
    pub(super) fn difference(&self, now: &Self) -> Option<String> {
        if now.bytes != self.bytes {
            let (now, then) = (now.bytes, self.bytes);
            return Some(format!("it is {now} bytes long, but {then} were written"));
        }
        (now.crc32 != self.crc32).then(|| {
            let (now, then) = (now.crc32, self.crc32);
            format!("its check sum is {now:08x}, but {then:08x} was written")
        })
    }
}
