//! Reasons why a path cannot be timed.

use super::{MAX_GRID_INTERVALS, MAX_WAYPOINTS, MIN_BLEND_TOLERANCE};
use thiserror::Error;

/// The reason why a path cannot be timed. Waypoints, segments and joints count from 0.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TimingError {
    /// The path has fewer than two waypoints.
    #[error("the path needs at least 2 waypoints, {count} given")]
    TooFewWaypoints {
        /// Number of waypoints given.
        count: usize,
    },
    /// There are more waypoints than [`MAX_WAYPOINTS`].
    #[error("{count} waypoints exceed the limit of {MAX_WAYPOINTS}")]
    TooManyWaypoints {
        /// Number of waypoints given.
        count: usize,
    },
    /// A waypoint has no joints.
    #[error("waypoint 0 has no joint positions; expected at least one")]
    NoJoints,
    /// A waypoint has another number of joints than the first one.
    #[error("waypoint {waypoint} has {count} joint positions, but waypoint 0 has {expected}")]
    UnequalWaypoints {
        /// Index of the waypoint.
        waypoint: usize,
        /// Number of its positions.
        count: usize,
        /// Number of positions of the first waypoint.
        expected: usize,
    },
    /// A position is not a finite number.
    #[error("waypoint {waypoint}, joint {joint}: position {value} is not a finite number")]
    PositionNotFinite {
        /// Index of the waypoint.
        waypoint: usize,
        /// Index of the joint.
        joint: usize,
        /// Its position [rad or m].
        value: f64,
    },
    /// A waypoint lies outside a joint's range.
    #[error(
        "waypoint {waypoint}, joint \"{joint}\": position {value} is outside its range {lower} to {upper}"
    )]
    PositionOutOfRange {
        /// Index of the waypoint.
        waypoint: usize,
        /// Name of the joint.
        joint: String,
        /// Its position [rad or m].
        value: f64,
        /// The range's lower end [rad or m].
        lower: f64,
        /// The range's upper end [rad or m].
        upper: f64,
    },
    /// Limits and path disagree about the number of joints.
    #[error("limits are given for {limits} joints, but the path has {path}")]
    UnequalJoints {
        /// Number of joints with limits.
        limits: usize,
        /// Number of joints of the path.
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
    /// A mimic joint refers to a column that does not exist.
    #[error("joint \"{joint}\" follows column {column}, but there are limits of {columns} columns")]
    NoSuchColumn {
        /// The joint's name.
        joint: String,
        /// Index of the column.
        column: usize,
        /// Number of columns.
        columns: usize,
    },
    /// The number of times differs from the number of segments.
    #[error("{times} segment times are given for {segments} segments")]
    UnequalSegments {
        /// Number of times given.
        times: usize,
        /// Number of segments of the path.
        segments: usize,
    },
    /// A segment's shortest time is negative or not finite.
    #[error("segment {segment}: shortest time {value} s is not a finite number of at least 0")]
    SegmentTimeOutOfRange {
        /// Index of the segment; segment i joins waypoints i and i + 1.
        segment: usize,
        /// The time given \[s\].
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
        /// Number of intervals given.
        value: usize,
    },
}
