//! Why a path cannot be timed.

use super::{MAX_GRID_INTERVALS, MAX_WAYPOINTS, MIN_BLEND_TOLERANCE};
use thiserror::Error;

/// Why a path cannot be timed. Waypoints, segments and joints count from 0.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TimingError {
    /// A motion needs a start and an end.
    #[error("a path needs at least 2 waypoints, not {count}")]
    TooFewWaypoints {
        /// How many were given.
        count: usize,
    },
    /// There are more waypoints than [`MAX_WAYPOINTS`].
    #[error("{count} waypoints exceed the limit of {MAX_WAYPOINTS}")]
    TooManyWaypoints {
        /// How many were given.
        count: usize,
    },
    /// A path needs joints.
    #[error("waypoint 0 has no joint positions")]
    NoJoints,
    /// A waypoint has another number of joints than the first one.
    #[error("waypoint {waypoint} has {count} joint positions, but waypoint 0 has {expected}")]
    UnequalWaypoints {
        /// The offending waypoint.
        waypoint: usize,
        /// How many positions it has.
        count: usize,
        /// How many the first one has.
        expected: usize,
    },
    /// A position is not a finite number.
    #[error("waypoint {waypoint}, joint {joint}: position {value} is not a finite number")]
    PositionNotFinite {
        /// The offending waypoint.
        waypoint: usize,
        /// The offending joint.
        joint: usize,
        /// Its position [rad or m].
        value: f64,
    },
    /// A waypoint lies outside a joint's range.
    #[error(
        "waypoint {waypoint}, joint \"{joint}\": position {value} is outside its range {lower} to {upper}"
    )]
    PositionOutOfRange {
        /// The offending waypoint.
        waypoint: usize,
        /// The joint's name.
        joint: String,
        /// Its position [rad or m].
        value: f64,
        /// The range's lower end [rad or m].
        lower: f64,
        /// The range's upper end [rad or m].
        upper: f64,
    },
    /// Limits and path disagree on the number of joints.
    #[error("limits are given for {limits} joints, but the path has {path}")]
    UnequalJoints {
        /// Joints with limits.
        limits: usize,
        /// Joints of the path.
        path: usize,
    },
    /// A joint's range is empty or not a number.
    #[error("joint \"{joint}\": range {lower} to {upper} contains no position")]
    EmptyRange {
        /// The joint's name.
        joint: String,
        /// The range's lower end [rad or m].
        lower: f64,
        /// The range's upper end [rad or m].
        upper: f64,
    },
    /// A velocity or acceleration limit is not a positive, finite number.
    #[error("joint \"{joint}\": {quantity} limit {value} is not a positive, finite number")]
    LimitNotPositive {
        /// The joint's name.
        joint: String,
        /// `velocity` or `acceleration`.
        quantity: &'static str,
        /// The limit given.
        value: f64,
    },
    /// A joint follows a column that there is not.
    #[error("joint \"{joint}\" follows column {column}, but there are limits of {columns} columns")]
    NoSuchColumn {
        /// The joint's name.
        joint: String,
        /// The column.
        column: usize,
        /// How many there are.
        columns: usize,
    },
    /// Not one time per segment.
    #[error("{times} segment times are given for {segments} segments")]
    UnequalSegments {
        /// How many times were given.
        times: usize,
        /// How many segments the path has.
        segments: usize,
    },
    /// A segment's shortest time is negative or not finite.
    #[error("segment {segment}: shortest time {value} s is not a finite number of at least 0")]
    SegmentTimeOutOfRange {
        /// The offending segment; segment i joins waypoints i and i + 1.
        segment: usize,
        /// The time given [s].
        value: f64,
    },
    /// The blend tolerance is too small, infinite or not a number.
    #[error("blend tolerance {value} must be finite and at least {MIN_BLEND_TOLERANCE}")]
    BlendToleranceOutOfRange {
        /// The tolerance given [rad or m].
        value: f64,
    },
    /// The grid is too coarse or too fine.
    #[error("{value} grid intervals per piece are not between 2 and {MAX_GRID_INTERVALS}")]
    GridOutOfRange {
        /// The number given.
        value: usize,
    },
}
