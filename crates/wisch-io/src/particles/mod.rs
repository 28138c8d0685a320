//! Particles from files: a list of places or an estimate, and a mask or photo.

mod image;
mod list;
#[cfg(test)]
mod tests;

pub use image::{MaskSource, mask_particles, read_observed_image};
pub use list::{csv_particles, particles_from_csv, particles_to_csv, read_observed_list};

use wisch::represent::{Cluster, ParticleError, SourceError};

/// The source of the initial particles.
#[derive(Debug, Clone, PartialEq)]
pub enum ParticleSource {
    /// Points of the surface, at the centres of square cells.
    Surface {
        /// Approximate number of points.
        count: usize,
    },
    /// Uniform over the free surface.
    Uniform {
        /// Number of particles.
        count: usize,
    },
    /// Heaps.
    Clusters {
        /// Total number of particles.
        count: usize,
        /// The heaps.
        clusters: Vec<Cluster>,
    },
    /// A list in a file.
    Csv {
        /// Its path, relative to the task file.
        file: String,
    },
    /// Detected in a mask or photo.
    Image(MaskSource),
}

/// An error of a source of particles.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ParticleSourceError {
    /// The particles could not be drawn or are invalid.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// An invalid line in a list of particles.
    #[error("{file}:{line}: {problem}")]
    Line {
        /// The file.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// The problem.
        problem: String,
    },
    /// A list without particles.
    #[error(
        "{file}: the list has no particles; at least 1 is required, except in the list of an observation"
    )]
    EmptyList {
        /// The file.
        file: String,
    },
    /// A file without anything to read.
    #[error(
        "{file}: there is neither a row nor a header; write a place per line, x,y in metres. Only the list of an observation may be empty, and has the header x,y then"
    )]
    Blank {
        /// The file.
        file: String,
    },
    /// An image that cannot be used.
    #[error("{file}: {problem}")]
    Image {
        /// The file.
        file: String,
        /// The problem.
        problem: String,
    },
}

impl From<ParticleError> for ParticleSourceError {
    fn from(error: ParticleError) -> Self {
        Self::Source(error.into())
    }
}
