//! What an execution gives, and how it ended.

use super::StrokeEnd;
use crate::robot::Range;

/// How an execution ended; one that ended early is interpreted as far as it went.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// All motions are done.
    Complete,
    /// Who took the samples stopped it.
    Stopped,
    /// It was ended amid a stroke that brought nothing any more; see [`RunConfig::end_strokes_early`](super::RunConfig).
    Early {
        /// When [s].
        time: f64,
        /// Why.
        cause: StrokeEnd,
    },
    /// The robot stopped itself, as robots do that are caught on something or led far astray.
    ProtectiveStop {
        /// When [s].
        time: f64,
        /// Why.
        cause: StopCause,
    },
}

impl Ending {
    /// The kind of it in a word or two, as records call it.
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Stopped => "stopped",
            Self::Early { .. } => "ended early",
            Self::ProtectiveStop { .. } => "protective stop",
        }
    }
}

/// Why a robot stopped itself: its position, a joint, or its own word.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StopCause {
    /// The tool is too far from where it was told to be.
    #[error("the tool is {distance:.2} m from where it was told to be, more than {limit} m")]
    Astray {
        /// How far [m].
        distance: f64,
        /// The limit [m].
        limit: f64,
    },
    /// A joint is too fast.
    #[error("joint {joint:?} moves at {velocity:.2} rad/s or m/s, more than {limit:.2}")]
    Overspeed {
        /// The joint.
        joint: String,
        /// Its velocity [rad/s or m/s].
        velocity: f64,
        /// The limit [rad/s or m/s].
        limit: f64,
    },
    /// What the robot itself says.
    #[error("{reason}")]
    Reported {
        /// Its words.
        reason: String,
    },
    /// A joint is beyond its limits.
    #[error("joint {joint:?} is at {position:.2} rad or m, beyond its limits {:.2} to {:.2}", limits.lower, limits.upper)]
    Overshoot {
        /// The joint.
        joint: String,
        /// Where it is [rad or m].
        position: f64,
        /// Where it may be [rad or m].
        limits: Range,
    },
}

/// What an execution gives, beside its samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Execution {
    /// How long it took [s].
    pub duration: f64,
    /// How it ended.
    pub ending: Ending,
    /// All n variables of the robot at the end [rad or m].
    pub positions: Vec<f64>,
}

impl Execution {
    /// One in which nothing has moved yet.
    pub fn at_rest(positions: &[f64]) -> Self {
        Self {
            duration: 0.0,
            ending: Ending::Complete,
            positions: positions.to_vec(),
        }
    }
}
