//! The result of an execution, and how it ended.

use super::{AfterStop, StrokeEnd};
use crate::follow::Phase;
use crate::robot::{JointKind, Range};
use std::fmt;

/// How an execution ended. An execution that ended early is interpreted up to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// All motions are done.
    Complete,
    /// The receiver of the samples stopped it.
    Stopped,
    /// It ended during a stroke that no longer had an effect; see
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
        "joint {joint:?} moves at {velocity:.2} {unit}/s, more than the limit of {limit:.2} {unit}/s",
        unit = kind.unit()
    )]
    Overspeed {
        /// Name of the joint.
        joint: String,
        /// Its velocity [rad/s or m/s].
        velocity: f64,
        /// The limit [rad/s or m/s].
        limit: f64,
        /// Kind of the joint, which gives the unit.
        kind: JointKind,
    },
    /// A reason that the robot reports.
    #[error("{}{reason}", kind.prefix())]
    Reported {
        /// Kind of the stop.
        kind: StopKind,
        /// The reported text.
        reason: String,
    },
    /// A joint is beyond its limits.
    #[error(
        "joint {joint:?} is at {position:.2} {unit}, outside its range of {:.2} to {:.2} {unit}",
        limits.lower,
        limits.upper,
        unit = kind.unit()
    )]
    Overshoot {
        /// Name of the joint.
        joint: String,
        /// Its position [rad or m].
        position: f64,
        /// Its range [rad or m].
        limits: Range,
        /// Kind of the joint, which gives the unit.
        kind: JointKind,
    },
}

/// Kind of a robot's stop, which decides whether the run continues by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StopKind {
    /// A person or an object pushed the robot.
    Push,
    /// The force on the tool exceeded its limit.
    Overload,
    /// A joint reached its limit.
    JointLimit,
    /// The robot left the tolerance of its trajectory.
    Tolerance,
    /// The robot's controller stopped it for another reason.
    ProtectiveStop,
    /// A person or a safety system pressed the emergency stop.
    EmergencyStop,
    /// A person stopped it.
    Operator,
    /// The connection to the robot was lost.
    LinkLost,
}

impl StopKind {
    /// All kinds of stops, in the order of the variants.
    pub const ALL: [Self; 8] = [
        Self::Push,
        Self::Overload,
        Self::JointLimit,
        Self::Tolerance,
        Self::ProtectiveStop,
        Self::EmergencyStop,
        Self::Operator,
        Self::LinkLost,
    ];

    /// Name of the kind, as messages and files have it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Push => "push",
            Self::Overload => "overload",
            Self::JointLimit => "joint_limit",
            Self::Tolerance => "tolerance",
            Self::ProtectiveStop => "protective_stop",
            Self::EmergencyStop => "emergency_stop",
            Self::Operator => "operator",
            Self::LinkLost => "link_lost",
        }
    }

    /// Text before a reported reason; empty for a protective stop, because the ending states it
    /// already.
    fn prefix(self) -> String {
        match self {
            Self::ProtectiveStop => String::new(),
            kind => format!("{kind}: "),
        }
    }

    /// Whether a run may continue by itself after such a stop, with a retreat from where the robot is.
    ///
    /// After a push or an overload it may. After a stop that a person or a safety system caused, and after a lost
    /// connection, it never does. For the other kinds the task decides.
    pub fn may_continue(self, after_stop: AfterStop) -> bool {
        match self {
            Self::Push | Self::Overload => true,
            Self::EmergencyStop | Self::Operator | Self::LinkLost => false,
            Self::JointLimit | Self::Tolerance | Self::ProtectiveStop => {
                after_stop != AfterStop::Wait
            }
        }
    }
}

impl fmt::Display for StopKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.as_str().replace('_', " "))
    }
}

impl StopCause {
    /// Kind of the stop that this cause implies.
    pub const fn kind(&self) -> StopKind {
        match self {
            Self::Astray { .. } => StopKind::Tolerance,
            Self::Overspeed { .. } => StopKind::ProtectiveStop,
            Self::Overshoot { .. } => StopKind::JointLimit,
            Self::Reported { kind, .. } => *kind,
        }
    }
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
    /// Pauses, in the order of time.
    pub pauses: Vec<Pause>,
    /// Number of dropped samples, because the observers of the run were too slow.
    pub dropped_samples: usize,
}

/// A pause of a motion, by the operator or by the robot.
#[derive(Debug, Clone, PartialEq)]
pub struct Pause {
    /// Time at which the pause begins, since the start of the motion \[s\].
    pub start: f64,
    /// Time at which the pause ends \[s\]; `None` if the motion ended during the pause.
    pub end: Option<f64>,
    /// Phase of the motion at the beginning of the pause.
    pub phase: Phase,
    /// Reason that the robot reports; may be empty.
    pub reason: String,
}

impl Execution {
    /// Returns the execution of an empty motion: the robot stays at `positions`.
    ///
    /// ```
    /// use wisch::run::{Ending, Execution};
    /// let execution = Execution::from_positions(&[0.1, -0.4]);
    /// assert_eq!((execution.duration, execution.ending), (0.0, Ending::Complete));
    /// ```
    pub fn from_positions(positions: &[f64]) -> Self {
        Self {
            duration: 0.0,
            ending: Ending::Complete,
            positions: positions.to_vec(),
            pauses: Vec::new(),
            dropped_samples: 0,
        }
    }
}
