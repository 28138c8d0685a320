//! Episodes as a narrative-enabled episodic memory (NEEM), the form in which openEASE and KnowRob keep theirs.
//!
//! A NEEM is a folder with collections of documents in BSON, each as a database dump:
//!
//! ```text
//! meta.json                     what it is, who made it and when
//! semco.owl                     the ontology of wiping
//! triples/roslog/triples.bson   what happened, as triples with closures and times
//! annotations/roslog/…          comments
//! inferred/roslog/…             a reader's cache, empty
//! tf/roslog/tf.bson             poses of frames over time
//! wrench/roslog/wrench.bson     forces and torques over time: our own, there is no standard for them
//! observation/roslog/…          what a camera saw of the dirt before and after each round: our own as well
//! ```
//!
//! [`NeemWriter`] writes one document at a time, [`import`] reads the episodes back from the triples, [`observations`] what
//! was seen in them.

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

/// Why a NEEM cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum NeemError {
    /// A file cannot be written or read.
    #[error("{path}: {error}", path = .path.display())]
    Io {
        /// Which.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// There is something already.
    #[error("{path}: there is something already", path = .path.display())]
    Exists {
        /// Where.
        path: PathBuf,
    },
    /// A document that is none.
    #[error("{path}: {error}", path = .path.display())]
    Dump {
        /// In which file.
        path: PathBuf,
        /// What is wrong with it.
        error: DumpError,
    },
    /// A document that is no triple.
    #[error("{path}: document {number} is no triple: {what}", path = .path.display())]
    Triple {
        /// In which file.
        path: PathBuf,
        /// Which, from 0.
        number: u64,
        /// What it lacks.
        what: &'static str,
    },
    /// A document that is no observation.
    #[error("{path}: document {number} is no observation: {what}", path = .path.display())]
    Observation {
        /// In which file.
        path: PathBuf,
        /// Which, from 0.
        number: u64,
        /// What is wrong.
        what: &'static str,
    },
    /// Observations that cannot be exported.
    #[error("episode {episode:?}: round {round}: {fault}")]
    Observations {
        /// Of which episode.
        episode: String,
        /// Of which of its rounds, from 1.
        round: usize,
        /// What is wrong.
        fault: ObservationFault,
    },
    /// A name with an unknown prefix.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A name that cannot be part of an IRI.
    #[error("{name:?} has a character that no IRI may have")]
    Name {
        /// The name.
        name: String,
    },
    /// A relation or class by which the export itself says an individual's whole, time or having a name.
    #[error("{name} is no relation or class of a record: the export says it by itself")]
    Reserved {
        /// The relation's property, or the class.
        name: String,
    },
    /// An IRI outside of the namespaces that have a prefix.
    #[error("{iri:?} lies in none of the namespaces that have a prefix")]
    Iri {
        /// The IRI.
        iri: String,
    },
    /// A record that cannot be exported, or triples that make no good record.
    #[error("episode {episode:?}: {fault}")]
    Record {
        /// Of which episode.
        episode: String,
        /// What is wrong.
        fault: RecordFault,
    },
    /// Triples that lack something that makes an episode.
    #[error("episode {episode:?}: {what}")]
    Incomplete {
        /// Of which episode.
        episode: String,
        /// What is wrong.
        what: String,
    },
    /// The same episode twice.
    #[error("episode {episode:?} is there twice")]
    Twice {
        /// Which.
        episode: String,
    },
    /// A rate that is none.
    #[error("tf_rate_hz: {rate} is not above 0")]
    Rate {
        /// The rate [Hz].
        rate: f64,
    },
    /// An episode of the memory that cannot be read.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// Telemetry that cannot be read.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
    /// Frames that cannot be computed.
    #[error(transparent)]
    Frames(#[from] FrameError),
    /// A sample with a number that is not finite.
    #[error("{frame}: a sample at {time} s has a number that is not finite")]
    Sample {
        /// Of which frame.
        frame: String,
        /// When [s since 1970].
        time: f64,
    },
}

/// The collection of what was seen.
const OBSERVATIONS: &str = "observation";

/// Names the file of a fault.
fn at(path: &Path) -> impl Fn(io::Error) -> NeemError {
    move |error| NeemError::Io {
        path: path.to_owned(),
        error,
    }
}

/// The collection's file below the folder of a NEEM.
fn collection_file(neem: &Path, collection: &str) -> PathBuf {
    neem.join(collection)
        .join("roslog")
        .join(format!("{collection}.bson"))
}
