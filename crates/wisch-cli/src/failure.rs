//! Errors as the user reads them: one sentence, and what to do about it.

use std::path::Path;

/// Why a command could not do its work.
#[derive(Debug, thiserror::Error)]
#[error("{sentence}")]
pub struct Failure {
    sentence: String,
    help: Option<String>,
}

impl Failure {
    /// An error that says what is wrong, where, and what the limit is.
    pub fn new(sentence: impl std::fmt::Display) -> Self {
        Self {
            sentence: sentence.to_string(),
            help: None,
        }
    }

    /// The same, with the file that led there named first.
    pub fn within(self, file: &Path) -> Self {
        Self {
            sentence: format!("{}: {}", file.display(), self.sentence),
            ..self
        }
    }

    /// What the user can do about it.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// Adds what the user can do about it.
    pub fn with_help(self, help: impl std::fmt::Display) -> Self {
        Self {
            help: Some(help.to_string()),
            ..self
        }
    }
}

impl From<wisch_io::Error> for Failure {
    fn from(error: wisch_io::Error) -> Self {
        Self {
            sentence: error.to_string(),
            help: error.help(),
        }
    }
}
