//! The files of the knowledge base and their errors.

mod grip;
mod record;
mod revision;
mod source;
#[cfg(test)]
mod tests;

pub(crate) use record::is_entry_name;
pub use revision::{InteractionRevision, RevisedFile};
pub(crate) use revision::{list_learned_rounds, revise_knowledge};

use wisch::represent::{KnowledgeBase, KnowledgeError, SurfaceScope};
use wisch::source_location::Place;

/// Reads a knowledge base from TOML texts. `files`: name (for error messages) and text of each file. Entries may refer to
/// entries of other files.
///
/// # Errors
///
/// If a text is not TOML, has unknown keys or another schema than 1, if a name is defined twice or undefined, or if a value
/// is outside its limits. The error states file, line and column.
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

/// An error of a knowledge file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KnowledgeFileError {
    /// The text is not TOML, or its keys are not those of a knowledge file.
    #[error("{at}: {message}")]
    Syntax {
        /// Location of the error in the file.
        at: Place,
        /// Message of the TOML parser.
        message: String,
    },
    /// The file has a schema that this version does not support.
    #[error(
        "{at}: schema {found} is not supported; this version reads schema {}",
        record::SCHEMA
    )]
    Schema {
        /// Location of the error in the file.
        at: Place,
        /// The schema of the file.
        found: i64,
    },
    /// A name that is invalid in PDDL or reserved.
    #[error(
        "{at}: {name:?} is not a valid name: a name has at most {} characters, a small letter first, then small letters, digits, `_` and `-`, and is not {:?}",
        record::NAME_MAX_LEN,
        SurfaceScope::ANY_NAME
    )]
    BadName {
        /// Location of the error in the file.
        at: Place,
        /// The given name.
        name: String,
    },
    /// Two entries define the same thing.
    #[error("{at}: {what} is already defined at {first}")]
    Duplicate {
        /// Location of the later entry.
        at: Place,
        /// Location of the earlier entry.
        first: Place,
        /// The thing that they define.
        what: String,
    },
    /// An entry refers to an undefined name.
    #[error("{at}: {error}")]
    UnknownReference {
        /// Location of the error in the file.
        at: Place,
        /// The name and similar names.
        #[source]
        error: Box<KnowledgeError>,
    },
    /// A number outside its limits.
    #[error("{at}: {field} = {value} is outside its limits: {limits}")]
    OutOfRange {
        /// Location of the error in the file.
        at: Place,
        /// The key, which ends in its unit.
        field: &'static str,
        /// The value as given.
        value: f64,
        /// The limits.
        limits: String,
    },
    /// An entry is inconsistent or incomplete.
    #[error("{at}: {problem}")]
    Inconsistent {
        /// Location of the error in the file.
        at: Place,
        /// The problem.
        problem: String,
    },
}
