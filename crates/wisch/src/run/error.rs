//! Reasons why a session cannot continue.

use super::ExecutorError;
use crate::follow::FollowError;
use crate::interpret::InterpretError;
use crate::plan::{PlanError, Prediction};
use crate::represent::{Action, ParticleError};

/// Checks that a plan's predicted score is high enough to execute it, see [`Prediction::score`]. Actions that
/// treat the surface lose no dirt and always pass.
///
/// `least`: lowest score allowed \[1\].
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

/// The reason why a session cannot continue.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// The planner found no plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// No robot was given that could follow the plan.
    #[error("the session has no robot, so it cannot follow the plan; give it a robot")]
    NoRobot,
    /// The follower found no motion.
    #[error(transparent)]
    Follow(#[from] FollowError),
    /// The plan is predicted to lose too much of the dirt.
    #[error(
        "the plan is not executed: it is predicted to bring {:.1} % of the dirt to the goal and to lose {:.1} %, a score of {score:.2} (the first share less three times the second), below the limit of {least:.2}; try another strategy, for example --strategy best, another goal or skim edge, or lower [plan] min_score",
        100.0 * achieved, 100.0 * lost
    )]
    LosesDirt {
        /// Share of the dirt that is predicted to end where it belongs \[1\].
        achieved: f64,
        /// Share of the dirt that is predicted to be lost \[1\].
        lost: f64,
        /// The plan's score \[1\].
        score: f64,
        /// Lowest score at which the plan would be executed \[1\].
        least: f64,
    },
    /// The executor failed.
    #[error(transparent)]
    Execute(#[from] ExecutorError),
    /// The executor reported another number of joints than the robot has.
    #[error(
        "round {round}: the executor reported {found} joint positions at the end, expected {expected}, or none if it does not measure them"
    )]
    Positions {
        /// The round, from 1.
        round: usize,
        /// Number of reported positions.
        found: usize,
        /// Number of the robot's variables.
        expected: usize,
    },
    /// Most detections of the camera are far from the surface.
    #[error(
        "{count} of {of} detections of the camera are beside surface {surface:?}, up to {farthest:.3} m from its edge: their unit or frame is probably wrong; expected metres in the frame of the believed surface, without dirt on other objects"
    )]
    DetectionsElsewhere {
        /// Name of the surface.
        surface: String,
        /// Number of detections beside the surface.
        count: usize,
        /// Number of all detections.
        of: usize,
        /// Largest distance of a detection from the surface's edge \[m\].
        farthest: f64,
    },
    /// The robot is not where its motion begins.
    #[error(
        "round {round}: joint {joint:?} is {distance:.3} {unit} from the start of the motion, more than the limit of {limit} {unit} (execution.start_rad), so the motion is not executed; move the joint to {start:.3} {unit}{}",
        describe_end_before(*round)
    )]
    Start {
        /// The round, from 1.
        round: usize,
        /// The joint with the largest distance.
        joint: String,
        /// Its distance from the start of the motion [rad or m].
        distance: f64,
        /// The limit [rad or m].
        limit: f64,
        /// Its position at the start of the motion [rad or m].
        start: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// The first sample of a motion shows the robot neither at the start of the motion nor on its
    /// way until then.
    #[error(
        "round {round}: at {time:.3} s the executor reports joint {joint:?} {distance:.3} {unit} from {place}, more than the limit of {limit} {unit}, so the motion is stopped; expected a robot that stands where the motion begins, and positions in rad and m, in the order of the robot's variables"
    )]
    StartsElsewhere {
        /// The round, from 1.
        round: usize,
        /// Time of the sample since the start of the motion \[s\].
        time: f64,
        /// The joint with the largest distance.
        joint: String,
        /// Distance of this joint from the expected position [rad or m].
        distance: f64,
        /// The expected position, in words.
        place: &'static str,
        /// The limit [rad or m].
        limit: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// The executor states two positions of the robot that contradict each other.
    #[error(
        "after the motion of round {round}, joint {joint:?} is at {measured:.3} {unit} by {by}, but at {stated:.3} {unit} by {message}, {:.3} {unit} apart; the limit is {limit:.3} {unit} (execution.start_rad, and the way of the joint in the time between both), so nothing moves until it is known where the robot is; make the executor report measured positions in both, and start again if someone moved the robot",
        (measured - stated).abs()
    )]
    Whereabouts {
        /// The round after whose motion the positions differ, from 1.
        round: usize,
        /// The joint that differs most.
        joint: String,
        /// Its position by the measurement [rad or m].
        measured: f64,
        /// The measurement, in words.
        by: &'static str,
        /// Its position by the later statement [rad or m].
        stated: f64,
        /// The later statement, in words.
        message: &'static str,
        /// Largest distance that the motion explains [rad or m].
        limit: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// The last measured pose of the tool is not that of the stated or planned end of the motion.
    #[error(
        "round {round}: by the last sample the tool is {distance:.3} m from the end of the motion, more than the limit of {limit:.3} m, so nothing moves until it is known where the robot is; make the executor report measured joint positions in \"sample\" and \"done\""
    )]
    EndsElsewhere {
        /// The round, from 1.
        round: usize,
        /// Distance of the tool from the end of the motion \[m\].
        distance: f64,
        /// The limit \[m\].
        limit: f64,
    },
    /// The executor reported another number of velocities than the robot has variables.
    #[error(
        "round {round}: the executor reported {found} joint velocities before the motion, expected {expected}, or none if it does not measure them"
    )]
    Velocities {
        /// The round, from 1.
        round: usize,
        /// Number of reported velocities.
        found: usize,
        /// Number of the robot's variables.
        expected: usize,
    },
    /// The robot moves before its motion begins.
    #[error(
        "round {round}: joint {joint:?} moves at {velocity:.3} {unit}/s, more than the limit of {limit} {unit}/s for a robot at rest, so the motion is not executed; wait until the robot stands still"
    )]
    Moving {
        /// The round, from 1.
        round: usize,
        /// The fastest joint.
        joint: String,
        /// Its speed [rad/s or m/s].
        velocity: f64,
        /// The limit [rad/s or m/s].
        limit: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// The position at which the robot was stopped is unknown.
    #[error(
        "round {round}: the executor did not report where the robot was stopped, so the next motion has no start; make the executor report its joint positions"
    )]
    UnknownState {
        /// The round that cannot begin, from 1.
        round: usize,
    },
    /// The interpretation failed.
    #[error(transparent)]
    Interpret(#[from] InterpretError),
    /// A particle position is not finite.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

/// Returns why a robot is not where the motion of a round begins, as a suffix of the message; empty in the first round.
fn describe_end_before(round: usize) -> String {
    match round {
        0 | 1 => String::new(),
        _ => format!(
            "; it did not end the motion of round {} where that was planned: something blocked or moved it, or its effort limits are too low",
            round - 1
        ),
    }
}
