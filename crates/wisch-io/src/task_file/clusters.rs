//! Heaps of dirt, believed or true.

use super::TaskError;
use super::deserialize::At;
use super::values::{PositionM, SigmaM, Weight, point};
use schemars::JsonSchema;
use serde::Deserialize;
use wisch::represent::Cluster;

/// Maximum number of clusters.
const MAX_CLUSTERS: usize = 10_000;

/// A heap: a normal distribution of particles.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Cluster")]
pub(super) struct ClusterTable {
    /// Centre, surface frame [m].
    pub(super) center_m: [PositionM; 2],
    /// Standard deviation [m].
    pub(super) sigma_m: SigmaM,
    /// Weight relative to the other heaps.
    #[serde(default = "weight")]
    pub(super) weight: Weight,
}

fn weight() -> Weight {
    Weight(1.0)
}

/// Reads the heaps and checks their number.
pub(super) fn heaps(clusters: &At<Vec<ClusterTable>>) -> Result<Vec<Cluster>, TaskError> {
    let found = clusters.value.len();
    if !(1..=MAX_CLUSTERS).contains(&found) {
        return Err(clusters.inconsistent(format!(
            "{found} clusters are outside the limits of 1 to {MAX_CLUSTERS}"
        )));
    }
    Ok(clusters.value.iter().map(Cluster::from).collect())
}

impl From<&ClusterTable> for Cluster {
    fn from(table: &ClusterTable) -> Self {
        Self {
            center: point(table.center_m),
            sigma: table.sigma_m.0,
            weight: table.weight.0,
        }
    }
}
