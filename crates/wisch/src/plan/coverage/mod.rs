//! Coverage strategies: where the nodes of the graph stand; paper §3.2, Fig. 4.

mod grid;
mod kde;
mod rrt;

use grid::cell_count;
pub use grid::grid;
pub use kde::{CoverageDensity, KdeConfig, data_bandwidth, kde};
pub use rrt::{RrtConfig, rrt};

use super::{FreeSpace, PlanError};
use crate::geometry::Point2;
use crate::represent::UnknownName;
use std::str::FromStr;

/// Largest number of nodes for one surface. It is the number of cells r_s apart in the surface's bounding box:
/// 20 m x 20 m for a sponge.
pub const MAX_NODES: usize = 100_000;

/// How nodes are distributed over the surface.
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
    /// Every strategy, in the order of the paper; names in flags, files and error texts are taken from here.
    pub const ALL: [Self; 3] = [Self::Grid, Self::Rrt, Self::Kde];

    /// The name used in task files, flags and results.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Rrt => "rrt",
            Self::Kde => "kde",
        }
    }

    /// Whether the nodes depend on the bandwidth of a density estimate.
    pub(super) fn uses_bandwidth(self) -> bool {
        self == Self::Kde
    }

    /// Returns the nodes of the strategy, in the surface frame [m].
    ///
    /// # Errors
    /// [`PlanError::TooManyNodes`] before any node is placed.
    pub(super) fn nodes(self, input: &CoverageInput<'_>) -> Result<Vec<Point2>, PlanError> {
        let pitch = input.space.radius();
        let count = cell_count(input.space, pitch);
        Ok(match self {
            Self::Grid | Self::Rrt if count > MAX_NODES => {
                let surface = input.space.surface().name.clone();
                return Err(PlanError::TooManyNodes {
                    surface,
                    count,
                    pitch,
                    advice: "take a wider tool, plan a part of the surface, or use the strategy kde, which places nodes only where dirt lies",
                });
            }
            Self::Grid => grid(input.space),
            Self::Rrt => rrt(
                input.space,
                input.tool_start,
                &RrtConfig {
                    seed: input.seed,
                    ..RrtConfig::default()
                },
            ),
            Self::Kde => kde(
                input.space,
                input.particles,
                &KdeConfig {
                    bandwidth: input.bandwidth,
                    reach: input.tool_reach,
                },
            ),
        })
    }
}

/// Input of a coverage strategy. Places are in the surface frame.
pub(super) struct CoverageInput<'a> {
    pub(super) space: &'a FreeSpace,
    /// Positions of the dirt [m].
    pub(super) particles: &'a [Point2],
    /// Start of the tool [m].
    pub(super) tool_start: Point2,
    /// Distance within which the tool at a node reaches a particle [m].
    pub(super) tool_reach: f64,
    pub(super) seed: u64,
    /// Bandwidth of a density estimate [m]; `None` takes it from the data.
    pub(super) bandwidth: Option<f64>,
}

impl std::fmt::Display for CoverageStrategy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}

impl FromStr for CoverageStrategy {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let named = Self::ALL.into_iter().find(|s| s.as_str() == name);
        named.ok_or_else(|| UnknownName::new("strategy", name, Self::ALL.map(Self::as_str)))
    }
}
