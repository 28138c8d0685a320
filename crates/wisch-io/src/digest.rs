//! Digests that identify the inputs of a run.

use std::fmt;
use std::hash::{DefaultHasher, Hasher};

/// A digest of named files and settings. It is comparable only within one build of the program, which suffices to check
/// whether a killed run can be resumed.
#[derive(Debug, Clone, Default)]
pub struct InputDigest(DefaultHasher);

impl InputDigest {
    /// Adds a file or a setting.
    ///
    /// ```
    /// let digest = |text: &str| {
    ///     let mut digest = wisch_io::InputDigest::default();
    ///     digest.add("task.toml", text);
    ///     digest.value()
    /// };
    /// assert_eq!(digest("seed = 1"), digest("seed = 1"));
    /// assert_ne!(digest("seed = 1"), digest("seed = 2"));
    /// ```
    pub fn add(&mut self, name: &str, contents: impl AsRef<[u8]>) {
        for part in [name.as_bytes(), contents.as_ref()] {
            // Lengths distinguish ("ab", "c") from ("a", "bc").
            self.0.write_usize(part.len());
            self.0.write(part);
        }
    }

    /// The digest of all added inputs.
    pub fn value(&self) -> u64 {
        self.0.finish()
    }
}

/// A digest of the contents of files, which is the same in every version of the program. It does not protect against deliberate
/// collisions.
///
/// ```
/// let digest = wisch_io::FileDigest::from_contents(b"wipe");
/// assert_eq!(digest.to_string(), "fnv1a-64:a677e1f655ab0e66:4");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileDigest {
    bytes: u64,
    /// 64-bit FNV-1a hash (Fowler, Noll, Vo).
    hash: u64,
}

impl FileDigest {
    /// The digest of no bytes.
    pub const EMPTY: Self = Self {
        bytes: 0,
        hash: 0xcbf2_9ce4_8422_2325,
    };

    /// Returns the digest of a file's contents.
    pub fn from_contents(contents: &[u8]) -> Self {
        let mut digest = Self::EMPTY;
        digest.add(contents);
        digest
    }

    /// Adds bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        for byte in bytes {
            // FNV-1a: hash = (hash xor byte) * (2^40 + 2^8 + 0xb3) modulo 2^64
            self.hash = (self.hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The last 16 bits of the hash.
    pub const fn last_bits(&self) -> u16 {
        self.hash as u16
    }
}

impl fmt::Display for FileDigest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "fnv1a-64:{:016x}:{}", self.hash, self.bytes)
    }
}
