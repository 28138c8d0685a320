//! Particles from files: a list of places or an estimate, and a mask or photo.

mod image;
mod list;
#[cfg(test)]
mod tests;

pub use image::{MaskSource, mask_particles, observed_in_image};
pub use list::{csv_particles, observed_in_list, particles_from_csv, particles_to_csv};

use wisch::represent::{Cluster, ParticleError, SourceError};

/// How the initial particles are made.
#[derive(Debug, Clone, PartialEq)]
pub enum ParticleSource {
    /// The places of the surface, in square cells.
    Surface {
        /// About how many.
        count: usize,
    },
    /// Evenly over the free surface.
    Uniform {
        /// How many.
        count: usize,
    },
    /// Heaps.
    Clusters {
        /// How many particles in all.
        count: usize,
        /// The heaps among which they are shared.
        clusters: Vec<Cluster>,
    },
    /// Listed in a file.
    Csv {
        /// Its path, relative to the task file.
        file: String,
    },
    /// Seen in a mask or photo.
    Image(MaskSource),
}

/// Why a source yields no particles.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ParticleSourceError {
    /// They could not be drawn, or the distribution refused them.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// A list of particles is not one.
    #[error("{file}:{line}: {problem}")]
    Line {
        /// The file.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// What is wrong there.
        problem: String,
    },
    /// A list without a single particle.
    #[error("{file}: it lists no particle, at least 1 is needed")]
    EmptyList {
        /// The file.
        file: String,
    },
    /// An image that cannot be used.
    #[error("{file}: {problem}")]
    Image {
        /// The file.
        file: String,
        /// What is wrong with it.
        problem: String,
    },
}

impl From<ParticleError> for ParticleSourceError {
    fn from(error: ParticleError) -> Self {
        Self::Source(error.into())
    }
}
