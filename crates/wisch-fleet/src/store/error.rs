//! What can be wrong with a fleet's memory.

use datafusion::error::DataFusionError;
use std::path::PathBuf;
use wisch_memory::{MemoryError, TelemetryError};

/// Why a fleet cannot be read, written or asked.
#[derive(Debug, thiserror::Error)]
pub enum FleetError {
    /// Not a place.
    #[error("{url}: {what}")]
    Url {
        /// As it was given, without what may be secret.
        url: String,
        /// What is wrong with it.
        what: String,
    },
    /// What the store says of an object.
    #[error("{object}: {}", without_echo(&error.to_string()))]
    Store {
        /// The object.
        object: String,
        /// What it says.
        error: object_store::Error,
    },
    /// An object that is not what was written.
    #[error("{object}: {what}")]
    Damaged {
        /// The object.
        object: String,
        /// How it differs.
        what: String,
    },
    /// Something that a newer program wrote.
    #[error("{object}: version {}.{} is not supported, this program reads versions up to {limit}.x", found[0], found[1])]
    Version {
        /// The object.
        object: String,
        /// Its version.
        found: [u32; 2],
        /// The newest major version that is read.
        limit: u32,
    },
    /// Two episodes of one name.
    #[error(
        "episode {id}: {here} (checksums.json {here_identity}) and {there} (checksums.json {there_identity}) are two episodes of one name"
    )]
    Conflict {
        /// Their name.
        id: String,
        /// The one that was to be moved.
        here: String,
        /// SHA-256 of its check sums.
        here_identity: String,
        /// The one that is there.
        there: String,
        /// SHA-256 of its check sums.
        there_identity: String,
    },
    /// More than an archive holds.
    #[error("episode {id}: {count} {what} are more than the {limit} that an archive holds")]
    TooLarge {
        /// The episode.
        id: String,
        /// What of it, with its unit.
        what: String,
        /// How much there is.
        count: u64,
        /// How much there may be.
        limit: u64,
    },
    /// Others were faster too often.
    #[error("{url}: {tries} times another writer was faster; nothing is lost, try again")]
    Contended {
        /// The fleet.
        url: String,
        /// How often it was tried.
        tries: usize,
    },
    /// What wisch-memory says.
    #[error("{0}")]
    Memory(#[from] MemoryError),
    /// What the system says of a file.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What it says.
        error: std::io::Error,
    },
    /// A statement that is none, or that cannot be answered.
    #[error("{}", in_short(.0))]
    Sql(#[from] DataFusionError),
    /// What a scheduler says, or that none does.
    #[error("{address}: {what}")]
    Cluster {
        /// The scheduler.
        address: String,
        /// What is wrong.
        what: String,
    },
    /// What is asked for cannot be.
    #[error("{0}")]
    Asked(String),
}

impl From<TelemetryError> for FleetError {
    fn from(error: TelemetryError) -> Self {
        Self::Memory(error.into())
    }
}

/// A store's error without what a server echoes: an S3 server's answer to a wrong signature holds the access key.
pub(crate) fn without_echo(text: &str) -> String {
    let Some(begin) = text.find("<?xml").or_else(|| text.find("<Error")) else {
        return text.to_owned();
    };
    let part = |name: &str| {
        let (open, close) = (format!("<{name}>"), format!("</{name}>"));
        let after = text.split_once(&open)?.1;
        Some(after.split_once(&close)?.0.to_owned())
    };
    let code = part("Code").unwrap_or_default();
    let help = match code.as_str() {
        "InvalidAccessKeyId" | "SignatureDoesNotMatch" | "AccessDenied" => {
            "; the store does not take the credentials of the environment (AWS_ACCESS_KEY_ID, \
             AWS_SECRET_ACCESS_KEY) or of ~/.aws/credentials"
        }
        _ => "",
    };
    let before = text[..begin].trim_end().trim_end_matches(':');
    format!("{before}: {code}{help}")
}

/// DataFusion's message in the first line, without a back trace.
fn in_short(error: &DataFusionError) -> String {
    without_echo(&error.strip_backtrace())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_server_echoes_of_credentials_is_not_repeated() {
        let body = "403 Forbidden: <?xml version=\"1.0\"?><Error><Code>SignatureDoesNotMatch</Code>\
                    <AWSAccessKeyId>AKIASECRET</AWSAccessKeyId></Error>";
        let error = FleetError::Store {
            object: "s3://bucket/log".to_owned(),
            error: object_store::Error::Generic {
                store: "S3",
                source: body.into(),
            },
        };
        let text = error.to_string();
        assert!(text.contains("SignatureDoesNotMatch"), "{text}");
        assert!(text.contains("AWS_ACCESS_KEY_ID"), "{text}");
        assert!(!text.contains("AKIASECRET"), "{text}");
    }
}
