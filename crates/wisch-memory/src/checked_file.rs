//! Files whose bytes are verified against check sums as they are read.

use bytes::Bytes;
use parquet::errors::ParquetError;
use parquet::file::reader::{ChunkReader, Length};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Length of a block with its own check sum [bytes]: about a column over ten seconds, so that reading a column reads
/// little else.
pub(crate) const BLOCK: usize = 1 << 15;

/// A file for the Parquet reader.
#[derive(Debug, Clone)]
pub(crate) struct CheckedFile(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    len: u64,
    /// CRC-32 of each block; `None` without check sums.
    sums: Option<Vec<u32>>,
    source: Mutex<Source>,
}

#[derive(Debug)]
struct Source {
    file: File,
    /// The last block that was read; headers are read bit by bit.
    last: Option<(usize, Bytes)>,
}

impl CheckedFile {
    /// Opens a file with the check sums of its blocks; without them, nothing is verified.
    ///
    /// # Errors
    /// If the file cannot be opened, or its length does not match the check sums.
    pub fn open(path: &Path, sums: Option<Vec<u32>>) -> io::Result<Self> {
        let file = File::open(path)?;
        let len = file.metadata()?.len();
        if let Some(sums) = &sums
            && sums.len() as u64 != len.div_ceil(BLOCK as u64)
        {
            let blocks = sums.len();
            return Err(damaged(format!(
                "it is {len} bytes long, but has check sums of {blocks} blocks"
            )));
        }
        let source = Mutex::new(Source { file, last: None });
        Ok(Self(Arc::new(Inner { len, sums, source })))
    }

    fn read(&self, start: u64, length: usize) -> io::Result<Bytes> {
        let mut bytes = Vec::with_capacity(length);
        let mut at = start;
        while bytes.len() < length {
            let rest = self.0.from(at)?;
            if rest.is_empty() {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            let taken = rest.len().min(length - bytes.len());
            bytes.extend_from_slice(&rest[..taken]);
            at += taken as u64;
        }
        Ok(bytes.into())
    }
}

impl Inner {
    /// Returns the rest of the block around this byte; empty at the end.
    fn from(&self, at: u64) -> io::Result<Bytes> {
        let block = usize::try_from(at / BLOCK as u64).map_err(io::Error::other)?;
        let within = (at % BLOCK as u64) as usize;
        let mut source = self.source.lock().unwrap_or_else(PoisonError::into_inner);
        let whole = match &source.last {
            Some((last, bytes)) if *last == block => bytes.clone(),
            _ => {
                let bytes = self.block(&mut source.file, block)?;
                source.last = Some((block, bytes.clone()));
                bytes
            }
        };
        Ok(whole.slice(within.min(whole.len())..))
    }

    fn block(&self, file: &mut File, block: usize) -> io::Result<Bytes> {
        let start = block as u64 * BLOCK as u64;
        let len = self.len.saturating_sub(start).min(BLOCK as u64) as usize;
        let mut bytes = vec![0; len];
        file.seek(SeekFrom::Start(start))?;
        file.read_exact(&mut bytes)?;
        if let Some(sums) = &self.sums
            && len > 0
            && sums.get(block) != Some(&crc32fast::hash(&bytes))
        {
            let end = start + len as u64;
            return Err(damaged(format!(
                "bytes {start} to {end} are not what was written, by their check sum"
            )));
        }
        Ok(bytes.into())
    }
}

fn damaged(what: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}

impl Length for CheckedFile {
    fn len(&self) -> u64 {
        self.0.len
    }
}

impl ChunkReader for CheckedFile {
    type T = CheckedRead;

    fn get_read(&self, start: u64) -> Result<CheckedRead, ParquetError> {
        Ok(CheckedRead {
            file: self.clone(),
            at: start,
        })
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes, ParquetError> {
        Ok(self.read(start, length)?)
    }
}

/// Reader from a position on.
#[derive(Debug)]
pub(crate) struct CheckedRead {
    file: CheckedFile,
    at: u64,
}

impl Read for CheckedRead {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let rest = self.file.0.from(self.at)?;
        let len = rest.len().min(out.len());
        out[..len].copy_from_slice(&rest[..len]);
        self.at += len as u64;
        Ok(len)
    }
}
