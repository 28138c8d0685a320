//! An episode's folder as one object, and its telemetry as another: the same files always make the same bytes.

use super::error::FleetError;
use sha2::{Digest, Sha256};
use std::io::Read;
use wisch_memory::Episode;

/// As much as a store takes in one request [bytes].
const LIMIT: u64 = 5 << 30;
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
    /// What the system says, or more than an object holds.
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
        if bytes.len() as u64 > LIMIT {
            return Err(FleetError::TooLarge {
                id: episode.id().to_owned(),
                what: what.to_owned(),
                bytes: bytes.len() as u64,
                limit: LIMIT,
            });
        }
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
    /// An archive that is cut off or broken.
    pub fn files(&self, object: &str) -> Result<Vec<(String, Vec<u8>)>, FleetError> {
        let broken = |error: std::io::Error| FleetError::Damaged {
            object: object.to_owned(),
            what: format!("it cannot be unpacked: {error}"),
        };
        let unpacked = zstd::Decoder::new(self.bytes.as_ref()).map_err(broken)?;
        let mut tar = tar::Archive::new(unpacked);
        let mut files = Vec::new();
        for entry in tar.entries().map_err(broken)? {
            let mut entry = entry.map_err(broken)?;
            let name = entry.path().map_err(broken)?.to_string_lossy().into_owned();
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
