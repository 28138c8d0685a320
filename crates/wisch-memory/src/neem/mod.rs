//! Episodes as a narrative-enabled episodic memory (NEEM), the format of openEASE and KnowRob.
//!
//! A NEEM is a folder with collections of BSON documents, each as a database dump:
//!
//! ```text
//! meta.json                     metadata: title, author, time
//! semco.owl                     the ontology of wiping
//! triples/roslog/triples.bson   triples with closures and times
//! annotations/roslog/…          comments
//! inferred/roslog/…             a reader's cache, empty
//! tf/roslog/tf.bson             poses of frames over time
//! wrench/roslog/wrench.bson     forces and torques over time (own schema, since no standard exists)
//! observation/roslog/…          camera observations before and after each round (own schema)
//! ```
//!
//! [`NeemWriter`] writes one document at a time, [`import`] reads the episodes back from the triples, and
//! [`observations`] reads the camera observations.

mod document;
mod dump;
mod import;
mod meta;
mod observation;
mod stored;
mod triples;
mod writer;

#[cfg(test)]
mod tests;

pub use document::GRAPH;
pub use dump::DumpError;
pub use import::{Triples, import, records};
pub use meta::{NeemMeta, utc};
pub use observation::{NeemRound, observations};
pub use stored::PoseSource;
pub use triples::{Object, Triple, ontology_triples, triples};
pub use writer::{FrameSample, NeemConfig, NeemReport, NeemWriter, WrenchSample};

use crate::frames::FrameError;
use crate::observations::ObservationFault;
use crate::record::RecordFault;
use crate::store::MemoryError;
use crate::telemetry::TelemetryError;
use std::io;
use std::path::{Path, PathBuf};
use wisch::source_location::UnknownName;

/// The reason why a NEEM cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum NeemError {
    /// A file cannot be written or read.
    #[error("{path}: {error}", path = .path.display())]
    Io {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The target exists already.
    #[error("{path}: there is something already; choose a new path", path = .path.display())]
    Exists {
        /// The target.
        path: PathBuf,
    },
    /// A document is not valid BSON.
    #[error("{path}: {error}", path = .path.display())]
    Dump {
        /// Path of the file.
        path: PathBuf,
        /// Fault of the document.
        error: DumpError,
    },
    /// A document is not a triple.
    #[error("{path}: document {number} is not a triple: {what}", path = .path.display())]
    Triple {
        /// Path of the file.
        path: PathBuf,
        /// Index of the document, from 0.
        number: u64,
        /// Description of the fault.
        what: &'static str,
    },
    /// A document is not an observation.
    #[error("{path}: document {number} is not an observation: {what}", path = .path.display())]
    Observation {
        /// Path of the file.
        path: PathBuf,
        /// Index of the document, from 0.
        number: u64,
        /// Description of the fault.
        what: &'static str,
    },
    /// An episode's observations cannot be exported.
    #[error("episode {episode:?}: round {round}: {fault}")]
    Observations {
        /// Name of the episode.
        episode: String,
        /// Number of the round in it, from 1.
        round: usize,
        /// Fault of the observations.
        fault: ObservationFault,
    },
    /// A name has an unknown prefix.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A name cannot be part of an IRI.
    #[error("{name:?} has a character that IRIs do not allow")]
    Name {
        /// The name.
        name: String,
    },
    /// A record uses a relation or class that the export itself derives: whole, time or name of an individual.
    #[error("{name} may not occur in a record, because the export derives it")]
    Reserved {
        /// The property of the relation, or the class.
        name: String,
    },
    /// The namespace of an IRI has no prefix.
    #[error("{iri:?}: its namespace has no prefix")]
    Iri {
        /// The IRI.
        iri: String,
    },
    /// A record cannot be exported, or triples do not make a valid record.
    #[error("episode {episode:?}: {fault}")]
    Record {
        /// Name of the episode.
        episode: String,
        /// Fault of the record.
        fault: RecordFault,
    },
    /// Triples do not make a complete episode.
    #[error("episode {episode:?}: {what}")]
    Incomplete {
        /// Name of the episode.
        episode: String,
        /// What is missing or contradictory.
        what: String,
    },
    /// An episode occurs twice.
    #[error("episode {episode:?} occurs twice")]
    Twice {
        /// Name of the episode.
        episode: String,
    },
    /// The pose rate is not positive.
    #[error("tf_rate_hz: {rate} is not above 0")]
    Rate {
        /// The rate \[Hz\].
        rate: f64,
    },
    /// An episode of the memory cannot be read.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// Telemetry cannot be read.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
    /// Frames cannot be computed.
    #[error(transparent)]
    Frames(#[from] FrameError),
    /// A sample has a number that is not finite.
    #[error("{frame}: a sample at {time} s has a number that is not finite")]
    Sample {
        /// Name of the frame.
        frame: String,
        /// Time of the sample [s since 1970].
        time: f64,
    },
}

/// Collection of the camera observations.
const OBSERVATIONS: &str = "observation";

/// Adds the path of a file to an error.
fn at(path: &Path) -> impl Fn(io::Error) -> NeemError {
    move |error| NeemError::Io {
        path: path.to_owned(),
        error,
    }
}

/// Path of a collection's file in a NEEM's folder.
fn collection_file(neem: &Path, collection: &str) -> PathBuf {
    neem.join(collection)
        .join("roslog")
        .join(format!("{collection}.bson"))
}
