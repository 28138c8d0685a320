//! Errors as the user reads them: one sentence, and what to do about it.

use std::path::Path;
use wisch_record::RecordError;

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

impl From<RecordError> for Failure {
    fn from(error: RecordError) -> Self {
        let help = match &error {
            RecordError::Memory(_) => {
                "--memory DIR keeps the episode elsewhere, --no-memory nowhere"
            }
            RecordError::Bag(_) | RecordError::State { .. } => "choose another folder with --out",
            RecordError::Results(error) => match error.help() {
                Some(help) => return Self::new(error).with_help(help),
                None => return Self::new(error),
            },
            RecordError::Live { .. } => {
                "--memory DIR keeps the episode elsewhere, and without --live nobody can look on"
            }
            RecordError::Sink(_) => "choose another file with --events",
            RecordError::Unreadable { .. } | RecordError::TooLong { .. } => {
                return Self::new(error);
            }
            RecordError::Nothing | RecordError::Internal(_) => {
                "this is a fault of wisch, not of your files; please report it"
            }
        };
        Self::new(error).with_help(help)
    }
}
