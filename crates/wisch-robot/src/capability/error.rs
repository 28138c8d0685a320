//! Why a map cannot be made or read.

use super::RobotHash;
use crate::RobotError;

/// What can be wrong with a map, or with what it should be made from.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// The chain or its positions do not fit the robot.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A setting outside its range.
    #[error("map.{field}: {value} is outside {lower} to {upper}")]
    Setting {
        /// Its name.
        field: &'static str,
        /// What it is.
        value: f64,
        /// The least it may be.
        lower: f64,
        /// The most it may be.
        upper: f64,
    },
    /// A sliding joint that may be anywhere.
    #[error("joint {joint:?} slides without limits: no map can hold all places it reaches")]
    Unlimited {
        /// The joint.
        joint: String,
    },
    /// More cells than are kept.
    #[error(
        "map of {voxels} voxels of {voxel} m (reach {reach:.2} m) in {directions} directions exceeds the limit of {limit} cells"
    )]
    TooFine {
        /// Number of voxels.
        voxels: f64,
        /// Number of directions.
        directions: usize,
        /// Farthest that the tool can be from the base [m].
        reach: f64,
        /// Edge of a voxel [m].
        voxel: f64,
        /// The most cells: voxels times directions.
        limit: usize,
    },
    /// No sample was free of collisions and within limits.
    #[error(
        "none of {samples} random positions of the chain is within limits and free of collision"
    )]
    NothingReached {
        /// How many were tried.
        samples: u64,
    },
    /// The bytes are no map.
    #[error("{file}: no capability map: {problem}")]
    Format {
        /// The name of the bytes.
        file: String,
        /// What is wrong.
        problem: String,
    },
    /// The map is of another version of the format.
    #[error(
        "{file}: capability map of format {found}, this program reads format {expected}: wisch robot map builds it again"
    )]
    Version {
        /// The name of the bytes.
        file: String,
        /// Its format.
        found: u32,
        /// The one that is read.
        expected: u32,
    },
    /// The map is of another robot.
    #[error(
        "{file}: capability map of another robot (it has {found}, the robot is {expected}): build it again"
    )]
    OtherRobot {
        /// The name of the bytes.
        file: String,
        /// Of the robot that the map was made from.
        found: RobotHash,
        /// Of the robot at hand.
        expected: RobotHash,
    },
}
