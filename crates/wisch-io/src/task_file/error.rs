//! Why a task file was refused.

use crate::particles::ParticleSourceError;
use wisch::geometry::{FootprintError, MeshError};
use wisch::represent::KnowledgeError;
use wisch::source_location::{Place, UnknownName};

/// Why a task file could not be read or does not become a task.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TaskError {
    /// The text is not TOML.
    #[error("{at}: {message}")]
    Syntax {
        /// Where.
        at: Place,
        /// What the reader says.
        message: String,
    },
    /// The file is of a schema that this version does not read.
    #[error("{at}: schema {found} is not supported, only schema {}", super::SCHEMA)]
    Schema {
        /// Where.
        at: Place,
        /// The schema of the file.
        found: String,
    },
    /// A key that does not exist.
    #[error("{at}: {}{unknown}", in_table(table))]
    UnknownKey {
        /// Where.
        at: Place,
        /// The table it stands in; empty for the top of the file.
        table: String,
        /// The key and those near it.
        unknown: Box<UnknownName>,
    },
    /// A key that is needed and not there.
    #[error("{at}: {}key \"{key}\" is missing", in_table(table))]
    Missing {
        /// Where its table starts.
        at: Place,
        /// The table that lacks it; empty for the top of the file.
        table: String,
        /// The key.
        key: &'static str,
    },
    /// A value of another type than its key takes.
    #[error("{at}: {key}: expected {expected}, found {found}")]
    WrongType {
        /// Where.
        at: Place,
        /// The full key.
        key: String,
        /// What it takes.
        expected: String,
        /// What was given.
        found: String,
    },
    /// A number outside its limits.
    #[error("{at}: {key} = {value} is outside its limits: {limits}")]
    OutOfRange {
        /// Where.
        at: Place,
        /// The full key, which ends in its unit.
        key: String,
        /// The value as given.
        value: String,
        /// What it may be.
        limits: String,
    },
    /// Values that contradict each other or themselves.
    #[error("{at}: {}{problem}", in_table(key))]
    Inconsistent {
        /// Where.
        at: Place,
        /// The full key; empty for the top of the file.
        key: String,
        /// What does not fit.
        problem: String,
    },
    /// A name that is none of those that may stand there.
    #[error("{at}: {unknown}")]
    UnknownReference {
        /// Where.
        at: Place,
        /// The name and those near it.
        unknown: Box<UnknownName>,
    },
    /// A setting whose key leads nowhere.
    #[error("setting {key}: {problem}")]
    Setting {
        /// The dotted key.
        key: String,
        /// What is wrong with it.
        problem: String,
    },
    /// The knowledge base does not have what the task asks for.
    #[error("{at}: {error}{}", or_define(error))]
    Knowledge {
        /// Where the task asks for it.
        at: Place,
        /// What it does not have.
        #[source]
        error: Box<KnowledgeError>,
    },
    /// A file that the task names cannot be had.
    #[error("{at}: file {file:?}: {problem}")]
    File {
        /// Where the task names it.
        at: Place,
        /// Its path.
        file: String,
        /// Why.
        problem: String,
    },
    /// A mesh cannot be used.
    #[error("{at}: {error}")]
    Mesh {
        /// Where the task names it.
        at: Place,
        /// Why.
        #[source]
        error: MeshError,
    },
    /// A mesh that was most likely drawn in other units.
    #[error("{at}: mesh {file:?} is {extent} m long, expected {} m to {} m: {advice}", limits[0], limits[1])]
    MeshScale {
        /// Where the task names it.
        at: Place,
        /// Its path.
        file: String,
        /// Its longest side after scaling [m].
        extent: f64,
        /// The least and the greatest that it may be [m].
        limits: [f64; 2],
        /// In which unit it probably is, and what to do.
        advice: String,
    },
    /// The tool leaves no footprint.
    #[error("{at}: tool {tool:?}: {error}")]
    Footprint {
        /// Where the task names the tool.
        at: Place,
        /// The tool.
        tool: String,
        /// Why.
        #[source]
        error: FootprintError,
    },
    /// The particles could not be placed.
    #[error("{at}: particles: {error}")]
    Particles {
        /// Where the task describes them.
        at: Place,
        /// Why.
        #[source]
        error: ParticleSourceError,
    },
}

/// How a task file says itself what the knowledge base does not have.
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
