//! What tells the inputs of one run from those of another.

use std::hash::{DefaultHasher, Hasher};

/// A digest of files and settings, each with its name. It is the same for the same build of the program alone: enough to
/// tell whether a killed run can be gone on with.
#[derive(Debug, Clone, Default)]
pub struct InputDigest(DefaultHasher);

impl InputDigest {
    /// Takes in a file or a setting.
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
            // Lengths tell ("ab", "c") from ("a", "bc").
            self.0.write_usize(part.len());
            self.0.write(part);
        }
    }

    /// The digest of all that was taken in.
    pub fn value(&self) -> u64 {
        self.0.finish()
    }
}
