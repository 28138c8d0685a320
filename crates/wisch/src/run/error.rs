//! Why a session cannot go on.

use super::ExecutorError;
use crate::follow::FollowError;
use crate::interpret::InterpretError;
use crate::plan::PlanError;
use crate::represent::ParticleError;

/// Why a session cannot go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// No plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// No robot was given that could follow the plan.
    #[error("there is no robot to follow the plan")]
    NoRobot,
    /// No motion.
    #[error(transparent)]
    Follow(#[from] FollowError),
    /// No execution.
    #[error(transparent)]
    Execute(#[from] ExecutorError),
    /// An execution that left the robot with another number of joints than it has.
    #[error(
        "round {round}: the executor ended with {found} positions, the robot has {expected} joints"
    )]
    Positions {
        /// The round, from 1.
        round: usize,
        /// Positions that came back.
        found: usize,
        /// Variables of the robot.
        expected: usize,
    },
    /// No interpretation.
    #[error(transparent)]
    Interpret(#[from] InterpretError),
    /// Dirt at places that are none.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}
