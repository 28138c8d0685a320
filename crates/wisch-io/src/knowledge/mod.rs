//! The files of the knowledge base, and what is wrong with one that is refused.

mod grip;
mod record;
mod revision;
mod source;
#[cfg(test)]
mod tests;

pub(crate) use record::is_entry_name;
pub(crate) use revision::revised;
pub use revision::{InteractionRevision, RevisedFile};

use wisch::represent::{KnowledgeBase, KnowledgeError, SurfaceScope};
use wisch::source_location::Place;

/// Reads knowledge from TOML texts, each with the name under which errors speak of it.
/// Entries may refer to those of any other text.
///
/// # Errors
///
/// A text that is not TOML or has other keys than those known, a schema other than 1, a name
/// given twice or used without being defined, or a value outside its limits: each with file,
/// line and column.
///
/// ```
/// let surfaces = "schema = 1\n[[surface]]\nname = \"table\"\nfriction = 0.4\n";
/// let knowledge = wisch_io::parse_knowledge(&[("surfaces.toml", surfaces)])?;
/// assert_eq!(knowledge.surface("table").unwrap().friction, 0.4);
/// # Ok::<(), wisch_io::KnowledgeFileError>(())
/// ```
pub fn parse_knowledge(files: &[(&str, &str)]) -> Result<KnowledgeBase, KnowledgeFileError> {
    record::read(files)
}

/// Why a knowledge file was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KnowledgeFileError {
    /// The text is not TOML, or not the TOML of a knowledge file.
    #[error("{at}: {message}")]
    Syntax {
        /// Where.
        at: Place,
        /// What the reader says.
        message: String,
    },
    /// The file is of a schema that this version does not read.
    #[error(
        "{at}: schema {found} is not supported, only schema {}",
        record::SCHEMA
    )]
    Schema {
        /// Where.
        at: Place,
        /// The schema of the file.
        found: i64,
    },
    /// A name that could not be one in PDDL, or that has a meaning of its own.
    #[error(
        "{at}: {name:?} is no name: a name is at most {} characters long, starts with a small letter, goes on with small letters, digits, `_` and `-`, and is not {:?}",
        record::NAME_MAX_LEN,
        SurfaceScope::ANY_NAME
    )]
    BadName {
        /// Where.
        at: Place,
        /// The name as given.
        name: String,
    },
    /// Two entries say the same of the same.
    #[error("{at}: {what} is already defined at {first}")]
    Duplicate {
        /// The later of the two.
        at: Place,
        /// The earlier of the two.
        first: Place,
        /// What they define.
        what: String,
    },
    /// An entry refers to something that is not defined.
    #[error("{at}: {error}")]
    UnknownReference {
        /// Where.
        at: Place,
        /// The name and those near it.
        #[source]
        error: Box<KnowledgeError>,
    },
    /// A number outside its limits.
    #[error("{at}: {field} = {value} is outside its limits: {limits}")]
    OutOfRange {
        /// Where.
        at: Place,
        /// The key, which ends in its unit.
        field: &'static str,
        /// The value as given.
        value: f64,
        /// What it may be.
        limits: String,
    },
    /// An entry contradicts itself or lacks something.
    #[error("{at}: {problem}")]
    Inconsistent {
        /// Where.
        at: Place,
        /// What does not fit.
        problem: String,
    },
}
