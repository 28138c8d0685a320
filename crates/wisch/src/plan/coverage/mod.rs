//! Coverage strategies: where the nodes of the graph stand; paper §3.2, Fig. 4.

mod grid;
mod kde;
mod rrt;

pub use grid::grid;
pub use kde::{DensityMap, KdeConfig, data_bandwidth, kde};
pub use rrt::{RrtConfig, rrt};

use std::str::FromStr;

/// How nodes are spread over the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CoverageStrategy {
    /// Centres of square cells, blind to the particles.
    Grid,
    /// A rapidly exploring random tree over the free surface, blind to the particles.
    Rrt,
    /// Peaks of the particles' kernel density estimate (2).
    Kde,
}

impl CoverageStrategy {
    /// All strategies.
    pub const ALL: [Self; 3] = [Self::Grid, Self::Rrt, Self::Kde];

    /// The name used in task files, flags and results.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Rrt => "rrt",
            Self::Kde => "kde",
        }
    }
}

impl std::fmt::Display for CoverageStrategy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A strategy of that name does not exist.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("strategy \"{0}\" is not known; known are grid, rrt and kde")]
pub struct UnknownStrategy(String);

impl FromStr for CoverageStrategy {
    type Err = UnknownStrategy;

    fn from_str(name: &str) -> Result<Self, UnknownStrategy> {
        Self::ALL
            .into_iter()
            .find(|strategy| strategy.as_str() == name)
            .ok_or_else(|| UnknownStrategy(name.to_owned()))
    }
}
