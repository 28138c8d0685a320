//! Archives: an episode's folder as one object, and its telemetry as another. The same files always give the same
//! bytes.

use super::error::FleetError;
use sha2::{Digest, Sha256};
use std::io::{self, Read};
use wisch_memory::Episode;

/// Largest size of all files in an archive [bytes].
const MOST_BYTES: u64 = 2 << 30;
/// Largest number of files in an archive.
const MOST_FILES: usize = 10_000;
/// Longest path of a file [bytes].
const LONGEST_PATH: usize = 255;
/// Largest ratio of unpacked to packed length of an archive, above `ANY_RATIO` bytes [1].
const LARGEST_RATIO: u64 = 200;
const ANY_RATIO: u64 = 64 << 20;
const LEVEL: i32 = 3;
const SUMS_FILE: &str = "checksums.json";

/// An archive and its checksum.
#[derive(Debug, Clone)]
pub struct Archive {
    /// `tar`, compressed with `zstd`.
    pub bytes: bytes::Bytes,
    /// SHA-256 of the bytes.
    pub sha256: String,
}

/// Returns the SHA-256 in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Returns the identity of an episode, which distinguishes episodes with the same name: the SHA-256 of its check sums.
///
/// # Errors
/// If the episode has no check sums.
pub fn identity_of(episode: &Episode) -> Result<String, FleetError> {
    let path = episode.folder().join(SUMS_FILE);
    let bytes = std::fs::read(&path).map_err(|error| FleetError::File { path, error })?;
    Ok(sha256(&bytes))
}

/// Whether a file of an episode is telemetry.
pub(crate) fn is_telemetry(name: &str) -> bool {
    !name.contains('/') && name.starts_with("round-") && name.ends_with(".parquet")
}

impl Archive {
    /// Archives an episode without its telemetry.
    ///
    /// # Errors
    /// If a file cannot be read, or an archive cannot hold the episode.
    pub fn of_episode(episode: &Episode) -> Result<Self, FleetError> {
        Self::of(episode, "the episode", |name| !is_telemetry(name))
            .map(|archive| archive.unwrap_or_else(Self::empty))
    }

    /// Archives an episode's telemetry, if it has any.
    ///
    /// # Errors
    /// As [`Self::of_episode`].
    pub fn of_telemetry(episode: &Episode) -> Result<Option<Self>, FleetError> {
        Self::of(episode, "telemetry", is_telemetry)
    }

    fn empty() -> Self {
        Self {
            bytes: bytes::Bytes::new(),
            sha256: sha256(&[]),
        }
    }

    fn of(
        episode: &Episode,
        what: &str,
        belongs: impl Fn(&str) -> bool,
    ) -> Result<Option<Self>, FleetError> {
        let mut names = episode.files()?;
        names.retain(|name| belongs(name));
        if names.is_empty() {
            return Ok(None);
        }
        let failed = |name: &str| {
            let path = episode.folder().join(name);
            |error| FleetError::File { path, error }
        };
        let mut length = 0;
        for name in &names {
            let metadata = std::fs::metadata(episode.folder().join(name));
            length += metadata.map_err(failed(name))?.len();
        }
        let too_large = |count: u64, unit: &str, limit: u64| FleetError::TooLarge {
            id: episode.id().to_owned(),
            what: format!("{unit} of {what}"),
            count,
            limit,
        };
        if length > MOST_BYTES {
            return Err(too_large(length, "bytes", MOST_BYTES));
        }
        if names.len() > MOST_FILES {
            return Err(too_large(names.len() as u64, "files", MOST_FILES as u64));
        }
        let packed = zstd::Encoder::new(Vec::new(), LEVEL).map_err(failed(""))?;
        let mut tar = tar::Builder::new(packed);
        for name in &names {
            let path = episode.folder().join(name);
            let mut file = std::fs::File::open(&path).map_err(failed(name))?;
            let length = file.metadata().map_err(failed(name))?.len();
            // No times and owners: only names and contents.
            let mut header = tar::Header::new_gnu();
            header.set_size(length);
            header.set_mode(0o644);
            header.set_entry_type(tar::EntryType::Regular);
            tar.append_data(&mut header, name, &mut file)
                .map_err(failed(name))?;
        }
        let packed = tar.into_inner().map_err(failed(""))?;
        let bytes = packed.finish().map_err(failed(""))?;
        Ok(Some(Self::from_bytes(bytes.into())))
    }

    /// Wraps the bytes of an archive that was read.
    pub fn from_bytes(bytes: bytes::Bytes) -> Self {
        Self {
            sha256: sha256(&bytes),
            bytes,
        }
    }

    /// Returns its files, by name; `object` is the name of the archive in errors.
    ///
    /// # Errors
    /// If the archive is cut off or damaged, holds entries other than files, or exceeds a limit.
    pub fn files(&self, object: &str) -> Result<Vec<(String, Vec<u8>)>, FleetError> {
        let damaged = |what: String| FleetError::Damaged {
            object: object.to_owned(),
            what,
        };
        let broken = |error: io::Error| damaged(format!("it cannot be unpacked: {error}"));
        let unpacked = Bounded::new(
            zstd::Decoder::new(self.bytes.as_ref()).map_err(broken)?,
            self.bytes.len() as u64,
        );
        let mut tar = tar::Archive::new(unpacked);
        let mut files = Vec::new();
        for entry in tar.entries().map_err(broken)? {
            let mut entry = entry.map_err(broken)?;
            let length = entry.path_bytes().len();
            if length > LONGEST_PATH {
                let what = format!("a path in it has {length} bytes; the limit is {LONGEST_PATH}");
                return Err(damaged(what));
            }
            let name = entry.path().map_err(broken)?.to_string_lossy().into_owned();
            let kind = entry.header().entry_type();
            if !kind.is_file() {
                return Err(damaged(format!("{name:?} in it is not a file ({kind:?})")));
            }
            if files.len() == MOST_FILES {
                return Err(damaged(format!("it has more than {MOST_FILES} files")));
            }
            let mut contents = Vec::new();
            entry.read_to_end(&mut contents).map_err(broken)?;
            files.push((name, contents));
        }
        Ok(files)
    }

    /// Returns the identity of its episode.
    ///
    /// # Errors
    /// If the archive is cut off or damaged, or has no check sums.
    pub fn identity(&self, object: &str) -> Result<String, FleetError> {
        let files = self.files(object)?;
        let sums = files.iter().find(|(name, _)| name == SUMS_FILE);
        sums.map(|(_, bytes)| sha256(bytes))
            .ok_or_else(|| FleetError::Damaged {
                object: object.to_owned(),
                what: format!("it has no {SUMS_FILE}"),
            })
    }
}

/// Reader of an archive with a limit on the unpacked length.
struct Bounded<R> {
    unpacked: R,
    packed: u64,
    limit: u64,
    left: u64,
}

impl<R: Read> Bounded<R> {
    fn new(unpacked: R, packed: u64) -> Self {
        let limit = (packed.saturating_mul(LARGEST_RATIO)).clamp(ANY_RATIO, MOST_BYTES);
        // Each file also has a header, and is padded to a whole block.
        let limit = limit + 2048 * MOST_FILES as u64;
        Self {
            unpacked,
            packed,
            limit,
            left: limit,
        }
    }
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.unpacked.read(buffer)?;
        self.left = self.left.checked_sub(read as u64).ok_or_else(|| {
            let (packed, limit) = (self.packed, self.limit);
            io::Error::other(format!(
                "its {packed} bytes unpack to more than the limit of {limit} bytes: at most {MOST_BYTES} bytes, and above \
                 {ANY_RATIO} bytes at most {LARGEST_RATIO} times the packed length"
            ))
        })?;
        Ok(read)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns an archive of files of zeros, with the given lengths.
    fn archive(files: impl IntoIterator<Item = (String, u64)>) -> Archive {
        let packed = zstd::Encoder::new(Vec::new(), LEVEL).unwrap();
        let mut tar = tar::Builder::new(packed);
        for (name, length) in files {
            let mut header = tar::Header::new_gnu();
            header.set_size(length);
            header.set_entry_type(tar::EntryType::Regular);
            tar.append_data(&mut header, name, io::repeat(0).take(length))
                .unwrap();
        }
        Archive::from_bytes(tar.into_inner().unwrap().finish().unwrap().into())
    }

    fn error(archive: &Archive) -> String {
        archive
            .files("s3://fleet/x.tar.zst")
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn an_archive_within_the_limits_is_unpacked() {
        let files = archive([("a/b.json".to_owned(), 3), ("zeros".to_owned(), ANY_RATIO)]);
        let files = files.files("x").unwrap();
        assert_eq!(files[0], ("a/b.json".to_owned(), vec![0; 3]));
        assert_eq!(files[1].1.len() as u64, ANY_RATIO);
    }

    #[test]
    fn an_archive_that_unpacks_to_too_much_names_its_limit() {
        let bomb = archive([("zeros".to_owned(), 2 * ANY_RATIO)]);
        let message = error(&bomb);
        let packed = bomb.bytes.len();
        assert!(packed < 20_000, "{packed}");
        assert!(
            message.contains("s3://fleet/x.tar.zst")
                && message.contains(&format!("its {packed} bytes")),
            "{message}"
        );
        assert!(
            message.contains("67108864") && message.contains("200 times"),
            "{message}"
        );
        // A name may be a decompression bomb as well.
        let mut head = tar::Header::new_gnu();
        head.set_size(2 * ANY_RATIO);
        head.set_entry_type(tar::EntryType::GNULongName);
        let mut tar = tar::Builder::new(zstd::Encoder::new(Vec::new(), LEVEL).unwrap());
        tar.append_data(&mut head, "name", io::repeat(b'a').take(2 * ANY_RATIO))
            .unwrap();
        let long = Archive::from_bytes(tar.into_inner().unwrap().finish().unwrap().into());
        assert!(error(&long).contains("67108864"), "{}", error(&long));
    }

    #[test]
    fn an_archive_of_too_many_files_or_too_long_a_path_names_its_limit() {
        let many = archive((0..=MOST_FILES).map(|number| (number.to_string(), 0)));
        assert!(
            error(&many).contains("more than 10000 files"),
            "{}",
            error(&many)
        );
        let long = archive([("a/".repeat(200), 0)]);
        assert!(
            error(&long).contains("400 bytes; the limit is 255"),
            "{}",
            error(&long)
        );
    }

    #[test]
    fn an_entry_that_is_not_a_file_is_refused() {
        let mut header = tar::Header::new_gnu();
        header.set_size(0);
        header.set_entry_type(tar::EntryType::Symlink);
        let mut tar = tar::Builder::new(zstd::Encoder::new(Vec::new(), LEVEL).unwrap());
        tar.append_link(&mut header, "task.toml", "/etc/passwd")
            .unwrap();
        let link = Archive::from_bytes(tar.into_inner().unwrap().finish().unwrap().into());
        assert!(error(&link).contains("is not a file"), "{}", error(&link));
    }
}
