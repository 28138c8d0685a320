//! An episode's folder as one object, and its telemetry as another: the same files always make the same bytes.

use super::error::FleetError;
use sha2::{Digest, Sha256};
use std::io::{self, Read};
use wisch_memory::Episode;

/// Most bytes of all files of an archive together.
const MOST_BYTES: u64 = 2 << 30;
/// Most files of an archive.
const MOST_FILES: usize = 10_000;
/// Longest path of a file [bytes].
const LONGEST_PATH: usize = 255;
/// How many times its packed length an archive may unpack to, once that is more than `ANY_RATIO` bytes.
const LARGEST_RATIO: u64 = 200;
const ANY_RATIO: u64 = 64 << 20;
const LEVEL: i32 = 3;
const SUMS_FILE: &str = "checksums.json";

/// An archive and its sum.
#[derive(Debug, Clone)]
pub struct Archive {
    /// `tar`, packed with `zstd`.
    pub bytes: bytes::Bytes,
    /// SHA-256 of that.
    pub sha256: String,
}

/// SHA-256 in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// What tells an episode from others of its name: SHA-256 of its check sums, which in turn say what each file is.
///
/// # Errors
/// An episode without check sums.
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
    /// Of an episode without its telemetry.
    ///
    /// # Errors
    /// What the system says, or more than an archive holds.
    pub fn of_episode(episode: &Episode) -> Result<Self, FleetError> {
        Self::of(episode, "the episode", |name| !is_telemetry(name))
            .map(|archive| archive.unwrap_or_else(Self::empty))
    }

    /// Of an episode's telemetry, if it has any.
    ///
    /// # Errors
    /// The same.
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
            // Nothing of when and by whom: only names and contents.
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

    /// One that was read.
    pub fn from_bytes(bytes: bytes::Bytes) -> Self {
        Self {
            sha256: sha256(&bytes),
            bytes,
        }
    }

    /// Its files, by name; `object` is where it was read.
    ///
    /// # Errors
    /// An archive that is cut off or broken, holds something else than files, or more than an archive may hold.
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
                let what =
                    format!("a path in it has {length} bytes, at most {LONGEST_PATH} are read");
                return Err(damaged(what));
            }
            let name = entry.path().map_err(broken)?.to_string_lossy().into_owned();
            let kind = entry.header().entry_type();
            if !kind.is_file() {
                return Err(damaged(format!("{name:?} in it is no file ({kind:?})")));
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

    /// What tells its episode from others of its name.
    ///
    /// # Errors
    /// An archive that is cut off or broken, or has no check sums.
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

/// What an archive unpacks to, as far as it may.
struct Bounded<R> {
    unpacked: R,
    packed: u64,
    limit: u64,
    left: u64,
}

impl<R: Read> Bounded<R> {
    fn new(unpacked: R, packed: u64) -> Self {
        let limit = (packed.saturating_mul(LARGEST_RATIO)).clamp(ANY_RATIO, MOST_BYTES);
        // Beside the files' bytes, each has a head, and is filled up to a whole block.
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
                "its {packed} bytes unpack to more than {limit}, the limit: {MOST_BYTES} bytes at most, and \
                 {LARGEST_RATIO} times its length beyond {ANY_RATIO}"
            ))
        })?;
        Ok(read)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An archive of these files, each of so many zeros.
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
    fn what_is_within_the_limits_is_unpacked() {
        let files = archive([("a/b.json".to_owned(), 3), ("zeros".to_owned(), ANY_RATIO)]);
        let files = files.files("x").unwrap();
        assert_eq!(files[0], ("a/b.json".to_owned(), vec![0; 3]));
        assert_eq!(files[1].1.len() as u64, ANY_RATIO);
    }

    #[test]
    fn an_archive_that_unpacks_to_too_much_names_its_limit() {
        let bomb = archive([("zeros".to_owned(), 2 * ANY_RATIO)]);
        let said = error(&bomb);
        let packed = bomb.bytes.len();
        assert!(packed < 20_000, "{packed}");
        assert!(
            said.contains("s3://fleet/x.tar.zst") && said.contains(&format!("its {packed} bytes")),
            "{said}"
        );
        assert!(
            said.contains("67108864") && said.contains("200 times"),
            "{said}"
        );
        // A name may be as long as a bomb.
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
            error(&long).contains("400 bytes, at most 255"),
            "{}",
            error(&long)
        );
    }

    #[test]
    fn what_is_no_file_is_not_unpacked() {
        let mut header = tar::Header::new_gnu();
        header.set_size(0);
        header.set_entry_type(tar::EntryType::Symlink);
        let mut tar = tar::Builder::new(zstd::Encoder::new(Vec::new(), LEVEL).unwrap());
        tar.append_link(&mut header, "task.toml", "/etc/passwd")
            .unwrap();
        let link = Archive::from_bytes(tar.into_inner().unwrap().finish().unwrap().into());
        assert!(error(&link).contains("is no file"), "{}", error(&link));
    }
}
