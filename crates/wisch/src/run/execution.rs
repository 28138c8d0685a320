//! The result of an execution, and how it ended.

use super::StrokeEnd;
use crate::robot::Range;

/// How an execution ended. One that ended early is interpreted up to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// All motions are done.
    Complete,
    /// The receiver of the samples stopped it.
    Stopped,
    /// It ended amid a stroke that no longer had an effect; see
    /// [`RunConfig::end_strokes_early`](super::RunConfig).
    Early {
        /// Time of the end \[s\].
        time: f64,
        /// Reason.
        cause: StrokeEnd,
    },
    /// The robot stopped itself, for example because it was caught on an object or far off its path.
    ProtectiveStop {
        /// Time of the stop \[s\].
        time: f64,
        /// Reason.
        cause: StopCause,
    },
}

impl Ending {
    /// Short name of the ending, as records have it.
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Stopped => "stopped",
            Self::Early { .. } => "ended early",
            Self::ProtectiveStop { .. } => "protective stop",
        }
    }
}

/// Why a robot stopped itself: the tool's position, a joint, or a reason that the robot reports.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StopCause {
    /// The tool is too far from its commanded position.
    #[error(
        "the tool is {distance:.2} m from its commanded position, more than the limit of {limit} m"
    )]
    Astray {
        /// Distance \[m\].
        distance: f64,
        /// The limit \[m\].
        limit: f64,
    },
    /// A joint is too fast.
    #[error(
        "joint {joint:?} moves at {velocity:.2} rad/s or m/s, more than the limit of {limit:.2}"
    )]
    Overspeed {
        /// Name of the joint.
        joint: String,
        /// Its velocity [rad/s or m/s].
        velocity: f64,
        /// The limit [rad/s or m/s].
        limit: f64,
    },
    /// A reason that the robot reports.
    #[error("{reason}")]
    Reported {
        /// The reported text.
        reason: String,
    },
    /// A joint is beyond its limits.
    #[error("joint {joint:?} is at {position:.2} rad or m, outside its range of {:.2} to {:.2}", limits.lower, limits.upper)]
    Overshoot {
        /// Name of the joint.
        joint: String,
        /// Its position [rad or m].
        position: f64,
        /// Its range [rad or m].
        limits: Range,
    },
}

/// The result of an execution, without its samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Execution {
    /// Duration \[s\].
    pub duration: f64,
    /// How it ended.
    pub ending: Ending,
    /// All n variables of the robot at the end [rad or m].
    pub positions: Vec<f64>,
}

impl Execution {
    /// Returns the execution of an empty motion: the robot stays at `positions`.
    pub fn at_rest(positions: &[f64]) -> Self {
        Self {
            duration: 0.0,
            ending: Ending::Complete,
            positions: positions.to_vec(),
        }
    }
}
