//! Why a session cannot go on.

use super::ExecutorError;
use crate::follow::FollowError;
use crate::interpret::InterpretError;
use crate::plan::{PlanError, Prediction};
use crate::represent::{Action, ParticleError};

/// Whether a plan is predicted to score well enough for it to be executed, see [`Prediction::score`]. What treats the surface loses
/// no dirt.
///
/// # Errors
/// [`RunError::LosesDirt`] with the score.
pub fn check_score(prediction: &Prediction, action: Action, least: f64) -> Result<(), RunError> {
    let score = prediction.score();
    if action.treats() || score >= least {
        return Ok(());
    }
    let of = |count: usize| count as f64 / prediction.performance.initial.max(1) as f64;
    Err(RunError::LosesDirt {
        achieved: of(prediction.performance.achieved),
        lost: of(prediction.performance.lost),
        score,
        least,
    })
}

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
    /// The plan is predicted to lose too much of the dirt.
    #[error(
        "the plan is not executed: it is predicted to bring {:.1} % of the dirt where it belongs and to lose {:.1} %, a score of {score:.2} (the former less three times the latter), the least is {least:.2}; try another strategy, as --strategy best, another goal or skim edge, or let it by [plan] min_score",
        100.0 * achieved, 100.0 * lost
    )]
    LosesDirt {
        /// Share of the dirt that is predicted to be where it belongs [1].
        achieved: f64,
        /// Share that is predicted to be lost [1].
        lost: f64,
        /// The plan's score [1].
        score: f64,
        /// The least at which it would be executed [1].
        least: f64,
    },
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
    /// The robot does not stand where its motion begins.
    #[error(
        "round {round}: joint {joint:?} stands {distance:.3} {unit} from where the motion begins, more than the limit of {limit} {unit} (start_rad): the motion is not executed"
    )]
    Start {
        /// The round, from 1.
        round: usize,
        /// The joint that is farthest away.
        joint: String,
        /// How far [rad or m].
        distance: f64,
        /// The limit [rad or m].
        limit: f64,
        /// "rad" or "m".
        unit: &'static str,
    },
    /// Nobody knows where the robot was stopped.
    #[error(
        "round {round}: the executor did not report where the robot was stopped, so no motion can begin there"
    )]
    UnknownState {
        /// The round that cannot begin, from 1.
        round: usize,
    },
    /// No interpretation.
    #[error(transparent)]
    Interpret(#[from] InterpretError),
    /// Dirt at places that are none.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}
