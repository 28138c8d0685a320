//! What a map is made of, how finely and how carefully.

use super::MapError;
use super::directions::FREQUENCIES;
use crate::geometry::Pose;
use crate::{LinkId, RobotModel};

/// The tool whose reach is mapped, and the chain of joints that moves it.
#[derive(Debug, Clone, Copy)]
pub struct MapTool<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// The link round which space is cut into voxels.
    pub base: LinkId,
    /// The link that carries the tool.
    pub tip: LinkId,
    /// The tool in the frame of the tip; its z axis is the one that counts.
    pub tip_from_tool: Pose,
    /// Positions of all variables of the robot (n) [rad or m]; those of the chain do not count.
    pub posture: &'a [f64],
}

/// How finely and how carefully a map is made.
///
/// ```
/// use wisch_robot::MapConfig;
/// let finer = MapConfig { frequency: 6, ..MapConfig::default() };
/// assert_eq!(finer.directions(), 362);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapConfig {
    /// Edge of a voxel [m].
    pub voxel: f64,
    /// Into how many parts the edges of an icosahedron are cut to have the grid of directions.
    pub frequency: u32,
    /// How many random positions of the joints are tried.
    pub samples: u64,
    /// Seed of the random positions.
    pub seed: u64,
    /// From how many poses reached nearby inverse kinematics starts at most, before a pose counts as
    /// out of reach.
    pub starts: u32,
    /// How many poses are tried of a cell at the boundary, besides its centre.
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

    /// Whether every setting is in its range.
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

/// What building a map is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MapStage {
    /// Random positions, of all to be tried.
    Sampling,
    /// Inverse kinematics from cell to cell: cells tried, of those known so far to be worth it.
    Spreading,
    /// Inverse kinematics within the cells at the boundary, of all of these.
    Refining,
}
