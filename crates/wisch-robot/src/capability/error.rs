//! Errors of capability maps.

use super::RobotHash;
use crate::RobotError;

/// A reason why a map cannot be built or read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// The chain or its positions do not fit the robot.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A setting is outside its range.
    #[error("map.{field}: {value} is outside {lower} to {upper}")]
    Setting {
        /// Name of the setting.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Its least value.
        lower: f64,
        /// Its largest value.
        upper: f64,
    },
    /// A sliding joint without limits.
    #[error(
        "joint {joint:?} slides without limits, so its reach is unbounded: give it position limits"
    )]
    Unlimited {
        /// Name of the joint.
        joint: String,
    },
    /// The map would have too many cells.
    #[error(
        "map of {voxels} voxels of {voxel} m (reach {reach:.2} m) in {directions} directions exceeds the limit of {limit} cells"
    )]
    TooFine {
        /// Number of voxels.
        voxels: f64,
        /// Number of directions.
        directions: usize,
        /// Reach of the tool from the base \[m\].
        reach: f64,
        /// Edge of a voxel \[m\].
        voxel: f64,
        /// Largest number of cells: voxels times directions.
        limit: usize,
    },
    /// No sample was within limits and free of collision.
    #[error(
        "none of {samples} random positions of the chain is within limits and free of collision: check the posture and the collision shapes"
    )]
    NothingReached {
        /// Number of samples.
        samples: u64,
    },
    /// A map file holds a map in which no pose is reachable.
    #[error(
        "capability map {file:?} reaches nothing, as that of an arm that cannot tilt its tool; work without a map"
    )]
    ReachesNothing {
        /// Name of the map, as given to the reader.
        file: String,
    },
    /// The chain reaches cells of the map, but the centre of none of them.
    #[error(
        "random positions of the chain are in {cells} cells, but the centre of none of them can be reached: a map has the tool's axis in fixed directions, which an arm that cannot tilt its tool (SCARA, gantry, palletizer) never has; work without a map"
    )]
    NoCenterReached {
        /// Number of cells with random positions.
        cells: usize,
    },
    /// The bytes are no capability map.
    #[error("{file}: no capability map: {problem}")]
    Format {
        /// Name of the file.
        file: String,
        /// Fault of the bytes, in words.
        problem: String,
    },
    /// The map has another version of the format.
    #[error(
        "{file}: capability map of format {found}, this program reads format {expected}: build it again with `wisch robot map`"
    )]
    Version {
        /// Name of the file.
        file: String,
        /// Version of the file.
        found: u32,
        /// Version that this program reads.
        expected: u32,
    },
    /// The map is that of another robot.
    #[error(
        "{file}: capability map of another robot (it has {found}, the robot is {expected}): build it again with `wisch robot map`"
    )]
    OtherRobot {
        /// Name of the file.
        file: String,
        /// Hash of the robot for which the map was built.
        found: RobotHash,
        /// Hash of the robot with which the map is used.
        expected: RobotHash,
    },
}
