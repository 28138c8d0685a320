//! Digests that identify the inputs of a run.

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
