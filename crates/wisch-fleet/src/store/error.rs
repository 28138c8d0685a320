//! Errors of a fleet.

use datafusion::error::DataFusionError;
use std::path::PathBuf;
use wisch_memory::{MemoryError, TelemetryError};

/// An error of a fleet: why it cannot be read, written or queried.
#[derive(Debug, thiserror::Error)]
pub enum FleetError {
    /// A URL is not a place of a fleet.
    #[error("{url}: {what}")]
    Url {
        /// The URL, without secrets.
        url: String,
        /// Description of the fault.
        what: String,
    },
    /// The store reports an error.
    #[error("{object}: {}", without_echo(&error.to_string()))]
    Store {
        /// Name of the object.
        object: String,
        /// Error of the store.
        error: object_store::Error,
    },
    /// An object differs from what was written.
    #[error("{object}: {what}")]
    Damaged {
        /// Name of the object.
        object: String,
        /// Description of the difference.
        what: String,
    },
    /// A newer program wrote an object.
    #[error("{object}: version {}.{} is not supported; this program reads versions up to {limit}.x", found[0], found[1])]
    Version {
        /// Name of the object.
        object: String,
        /// Its version.
        found: [u32; 2],
        /// The newest major version that is supported.
        limit: u32,
    },
    /// Two different episodes have the same name.
    #[error(
        "episode {id}: {here} (checksums.json {here_identity}) and {there} (checksums.json {there_identity}) are different episodes with the same name"
    )]
    Conflict {
        /// Name of the episodes.
        id: String,
        /// The episode to be transferred.
        here: String,
        /// SHA-256 of its check sums.
        here_identity: String,
        /// The episode at the target.
        there: String,
        /// SHA-256 of its check sums.
        there_identity: String,
    },
    /// An episode exceeds a limit of archives.
    #[error("episode {id}: {count} {what} exceed the limit of {limit} for an archive")]
    TooLarge {
        /// Name of the episode.
        id: String,
        /// The limited quantity, with its unit.
        what: String,
        /// Its value.
        count: u64,
        /// The limit.
        limit: u64,
    },
    /// Other writers committed first too often.
    #[error("{url}: {tries} times another writer committed first; nothing is lost, try again")]
    Contended {
        /// URL of the fleet.
        url: String,
        /// Number of attempts.
        tries: usize,
    },
    /// Error of the memory.
    #[error("{0}")]
    Memory(#[from] MemoryError),
    /// The operating system refuses an operation on a file.
    #[error("{}: {error}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: std::io::Error,
    },
    /// A statement is invalid, or cannot be answered.
    #[error("{}", first_line(.0))]
    Sql(#[from] DataFusionError),
    /// The scheduler reports an error, or is not reachable.
    #[error("{address}: {what}")]
    Cluster {
        /// Address of the scheduler.
        address: String,
        /// Description of the error.
        what: String,
    },
    /// A request is invalid.
    #[error("{0}")]
    Asked(String),
}

impl From<TelemetryError> for FleetError {
    fn from(error: TelemetryError) -> Self {
        Self::Memory(error.into())
    }
}

/// Removes a server's echo from a store's error: an S3 server's answer to a wrong signature holds the access key.
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
            "; the store rejects the credentials of the environment (AWS_ACCESS_KEY_ID, \
             AWS_SECRET_ACCESS_KEY) or of ~/.aws/credentials"
        }
        _ => "",
    };
    let before = text[..begin].trim_end().trim_end_matches(':');
    format!("{before}: {code}{help}")
}

/// Returns the first line of DataFusion's message, without a backtrace.
fn first_line(error: &DataFusionError) -> String {
    without_echo(&error.strip_backtrace())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn credentials_echoed_by_a_server_are_not_printed() {
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
