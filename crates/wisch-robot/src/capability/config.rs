//! Settings of a capability map.

use super::MapError;
use super::directions::FREQUENCIES;
use crate::geometry::Pose;
use crate::{LinkId, RobotModel};

/// The tool whose reach is mapped, and the chain that moves it.
#[derive(Debug, Clone, Copy)]
pub struct MapRequest<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// Base link, around which space is divided into voxels.
    pub base: LinkId,
    /// Tip link, which carries the tool.
    pub tip: LinkId,
    /// Pose of the tool in the tip; the map is about its z axis.
    pub tip_from_tool: Pose,
    /// Positions of all variables of the robot (n) [rad or m]; those of the chain are ignored.
    pub posture: &'a [f64],
}

/// Resolution and effort of a capability map.
///
/// ```
/// use wisch_robot::MapConfig;
/// let finer = MapConfig { frequency: 6, ..MapConfig::default() };
/// assert_eq!(finer.directions(), 362);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapConfig {
    /// Edge of a voxel \[m\].
    pub voxel: f64,
    /// Number of parts into which each edge of an icosahedron is cut, to give the grid of directions.
    pub frequency: u32,
    /// Number of random joint positions to try.
    pub samples: u64,
    /// Seed of the random positions.
    pub seed: u64,
    /// Largest number of reached neighbours from which inverse kinematics starts, before a pose
    /// counts as out of reach.
    pub starts: u32,
    /// Number of poses tried in each boundary cell, besides its centre.
    pub refinements: u32,
}

impl Default for MapConfig {
    /// Voxels of 5 cm, directions 18° apart.
    fn default() -> Self {
        Self {
            voxel: 0.05,
            frequency: 4,
            samples: 1_000_000,
            seed: 0,
            starts: 4,
            refinements: 4,
        }
    }
}

impl MapConfig {
    /// Number of directions: 10 frequency² + 2.
    pub const fn directions(&self) -> usize {
        let frequency = self.frequency as usize;
        frequency
            .saturating_mul(frequency)
            .saturating_mul(10)
            .saturating_add(2)
    }

    /// Checks that every setting is within its range.
    pub(super) fn check(&self) -> Result<(), MapError> {
        let (coarsest, finest) = (*FREQUENCIES.start() as f64, *FREQUENCIES.end() as f64);
        for (field, value, lower, upper) in [
            ("voxel", self.voxel, 1e-3, 10.0),
            ("frequency", f64::from(self.frequency), coarsest, finest),
            ("samples", self.samples as f64, 1.0, 1e12),
            ("starts", f64::from(self.starts), 1.0, 100.0),
            ("refinements", f64::from(self.refinements), 0.0, 100.0),
        ] {
            if !(lower..=upper).contains(&value) {
                return Err(MapError::Setting {
                    field,
                    value,
                    lower,
                    upper,
                });
            }
        }
        Ok(())
    }
}

/// Stage of building a capability map, for reports of progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MapStage {
    /// Random positions; progress counts positions.
    Sampling,
    /// Inverse kinematics from cell to cell; progress counts cells tried, of those known so far.
    Spreading,
    /// Inverse kinematics within boundary cells; progress counts cells.
    Refining,
}
