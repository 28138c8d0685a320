//! Errors as the user reads them: one sentence, and advice on what to do.

use std::path::Path;
use wisch_record::RecordError;

/// An error that ends a command: a sentence and optional advice.
#[derive(Debug, thiserror::Error)]
#[error("{sentence}")]
pub struct Failure {
    sentence: String,
    help: Option<String>,
}

impl Failure {
    /// Makes an error from a sentence that states the problem, its location and the limit.
    pub fn new(sentence: impl std::fmt::Display) -> Self {
        Self {
            sentence: sentence.to_string(),
            help: None,
        }
    }

    /// Puts the name of a file before the sentence.
    pub fn within(self, file: &Path) -> Self {
        Self {
            sentence: format!("{}: {}", file.display(), self.sentence),
            ..self
        }
    }

    /// Puts the part of the work that failed before the sentence.
    pub fn after(self, part: &str) -> Self {
        Self {
            sentence: format!("{part}: {}", self.sentence),
            ..self
        }
    }

    /// The advice on what to do.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// Adds advice on what to do.
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

impl From<RecordError> for Failure {
    fn from(error: RecordError) -> Self {
        let help = match &error {
            RecordError::Memory(_) => {
                "choose another folder with --memory DIR, or keep no episode with --no-memory"
            }
            RecordError::Bag(_) | RecordError::State { .. } => "choose another folder with --out",
            RecordError::Results(error) => match error.help() {
                Some(help) => return Self::new(error).with_help(help),
                None => return Self::new(error),
            },
            RecordError::Live { .. } => {
                "choose another folder with --memory DIR, or leave out --live"
            }
            RecordError::Sink(_) => "choose another file with --events",
            RecordError::Unreadable { .. } | RecordError::TooLong { .. } => {
                return Self::new(error);
            }
            RecordError::Nothing | RecordError::Internal(_) => {
                "this is an error in wisch, not in your files; please report it"
            }
        };
        Self::new(error).with_help(help)
    }
}
