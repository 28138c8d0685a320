//! Check sums of an episode's files.

use super::error::{MemoryError, at};
use crate::checked_file::BLOCK;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// File of the check sums in an episode.
pub(super) const SUMS_FILE: &str = "checksums.json";

/// Check sums of all files, by name.
pub(super) type Sums = BTreeMap<String, FileSum>;

/// Length and check sum of a file when it was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct FileSum {
    /// Length [bytes].
    bytes: u64,
    /// CRC-32, as in zip files.
    crc32: u32,
    /// CRC-32 of each block, for files that are read in parts; older episodes have none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    blocks: Vec<u32>,
}

impl FileSum {
    /// Returns length and check sum of a file in its present state.
    pub(super) fn of(path: &Path) -> Result<Self, MemoryError> {
        let mut file = File::open(path).map_err(at(path))?;
        Self::of_opened(&mut file, path)
    }

    /// Returns length and check sum of an open file at `path`.
    pub(super) fn of_opened(file: &mut File, path: &Path) -> Result<Self, MemoryError> {
        let mut hasher = crc32fast::Hasher::new();
        let mut bytes = 0;
        let mut blocks = Vec::new();
        let mut block = Vec::with_capacity(BLOCK);
        loop {
            block.clear();
            let mut part = file.by_ref().take(BLOCK as u64);
            let read = part.read_to_end(&mut block).map_err(at(path))?;
            if read == 0 {
                break;
            }
            hasher.update(&block);
            blocks.push(crc32fast::hash(&block));
            bytes += read as u64;
        }
        if !is_read_in_parts(path) {
            blocks.clear();
        }
        Ok(Self {
            bytes,
            crc32: hasher.finalize(),
            blocks,
        })
    }

    /// Returns the check sums of a file's blocks. For older episodes, it reads the whole file to compute them.
    pub(super) fn of_blocks(&self, path: &Path) -> Result<Vec<u32>, MemoryError> {
        if !self.blocks.is_empty() || self.bytes == 0 {
            return Ok(self.blocks.clone());
        }
        let now = Self::of(path)?;
        match self.difference(&now) {
            None => Ok(now.blocks),
            Some(what) => Err(MemoryError::Changed {
                path: path.to_path_buf(),
                what,
            }),
        }
    }

    /// Returns how a file differs from this, if it does.
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

/// Whether a file is read in parts, like telemetry.
fn is_read_in_parts(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "parquet")
}
