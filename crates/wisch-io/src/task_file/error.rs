//! Errors of task files.

use crate::particles::ParticleSourceError;
use wisch::geometry::{FootprintError, MeshError};
use wisch::represent::KnowledgeError;
use wisch::source_location::{Place, UnknownName};

/// An error of a task file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TaskError {
    /// The text is not TOML.
    #[error("{at}: {message}")]
    Syntax {
        /// Location of the error.
        at: Place,
        /// Message of the TOML parser.
        message: String,
    },
    /// The file has a schema that this version does not support.
    #[error(
        "{at}: schema {found} is not supported; this version reads schema {}",
        super::SCHEMA
    )]
    Schema {
        /// Location of the error.
        at: Place,
        /// The schema of the file.
        found: String,
    },
    /// A key that does not exist.
    #[error("{at}: {}{unknown}", in_table(table))]
    UnknownKey {
        /// Location of the error.
        at: Place,
        /// The table of the key; empty for the top level.
        table: String,
        /// The key and similar keys.
        unknown: Box<UnknownName>,
    },
    /// A missing key.
    #[error("{at}: {}key \"{key}\" is missing", in_table(table))]
    Missing {
        /// Start of its table.
        at: Place,
        /// The table that lacks the key; empty for the top level.
        table: String,
        /// The key.
        key: &'static str,
    },
    /// A value of the wrong type.
    #[error("{at}: {key}: expected {expected}, found {found}")]
    WrongType {
        /// Location of the error.
        at: Place,
        /// The full key.
        key: String,
        /// The expected type.
        expected: String,
        /// The given type.
        found: String,
    },
    /// A number outside its limits.
    #[error("{at}: {key} = {value} is outside its limits: {limits}")]
    OutOfRange {
        /// Location of the error.
        at: Place,
        /// The full key, which ends in its unit.
        key: String,
        /// The value as given.
        value: String,
        /// The limits.
        limits: String,
    },
    /// Values that contradict each other or themselves.
    #[error("{at}: {}{problem}", in_table(key))]
    Inconsistent {
        /// Location of the error.
        at: Place,
        /// The full key; empty for the top level.
        key: String,
        /// The contradiction.
        problem: String,
    },
    /// An unknown name.
    #[error("{at}: {unknown}")]
    UnknownReference {
        /// Location of the error.
        at: Place,
        /// The name and similar names.
        unknown: Box<UnknownName>,
    },
    /// A setting with an unusable key.
    #[error("setting {key}: {problem}")]
    Setting {
        /// The dotted key.
        key: String,
        /// The problem.
        problem: String,
    },
    /// The knowledge base lacks an entry that the task uses.
    #[error("{at}: {error}{}", or_define(error))]
    Knowledge {
        /// Location in the task.
        at: Place,
        /// The missing entry.
        #[source]
        error: Box<KnowledgeError>,
    },
    /// A file of the task cannot be read.
    #[error("{at}: file {file:?}: {problem}")]
    File {
        /// Location in the task.
        at: Place,
        /// Its path.
        file: String,
        /// The problem.
        problem: String,
    },
    /// A mesh cannot be used.
    #[error("{at}: {error}")]
    Mesh {
        /// Location in the task.
        at: Place,
        /// The cause.
        #[source]
        error: MeshError,
    },
    /// A mesh whose size suggests other units than metres.
    #[error("{at}: mesh {file:?} is {extent} m long, expected {} m to {} m: {advice}", limits[0], limits[1])]
    MeshScale {
        /// Location in the task.
        at: Place,
        /// Its path.
        file: String,
        /// Its longest side after scaling \[m\].
        extent: f64,
        /// Smallest and largest allowed length \[m\].
        limits: [f64; 2],
        /// The probable unit, and what to do.
        advice: String,
    },
    /// The tool has no footprint.
    #[error("{at}: tool {tool:?}: {error}")]
    Footprint {
        /// Location of the tool in the task.
        at: Place,
        /// The tool.
        tool: String,
        /// The cause.
        #[source]
        error: FootprintError,
    },
    /// The particles could not be placed.
    #[error("{at}: particles: {error}")]
    Particles {
        /// Location of the particles in the task.
        at: Place,
        /// The cause.
        #[source]
        error: ParticleSourceError,
    },
}

impl TaskError {
    pub(super) fn particles(at: &Place, error: ParticleSourceError) -> Self {
        Self::Particles {
            at: at.clone(),
            error,
        }
    }
}

/// Returns advice how the task file can define a missing entry itself.
fn or_define(error: &KnowledgeError) -> &'static str {
    let KnowledgeError::Unknown(unknown) = error else {
        return "";
    };
    match unknown.kind {
        "tool" => "; or give footprint_m or mesh, which defines it here",
        "medium" => "; or give kind, which defines it here",
        "surface" => "; or give friction, which defines it here",
        _ => "",
    }
}

fn in_table(table: &str) -> String {
    match table {
        "" => String::new(),
        table => format!("{table}: "),
    }
}
