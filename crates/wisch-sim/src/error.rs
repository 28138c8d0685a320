//! Why an execution cannot begin or go on.

use wisch::represent::SourceError;
use wisch::robot::RobotError;

/// Why an execution cannot begin or go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// The robot's description does not do.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// Dirt finds no place where it shall lie.
    #[error("the real dirt: {0}")]
    Dirt(#[from] SourceError),
    /// There is no joint between the world and the tool that moves.
    #[error("robot {robot:?}: no joint moves the tool")]
    NothingMoves {
        /// The robot.
        robot: String,
    },
    /// The tool has no underside.
    #[error("the tool's footprint has no area that could touch a surface")]
    NoFootprint,
    /// The surface has no area.
    #[error("the surface's outline has no area that could be touched")]
    NoSurface,
    /// A joint moves too little mass for a torque to mean anything.
    #[error(
        "at {time:.3} s the mass matrix of the robot is not positive definite: some joint moves no inertia"
    )]
    NoInertia {
        /// When [s].
        time: f64,
    },
    /// The simulation has come apart.
    #[error(
        "at {time:.3} s joint {joint:?} of the simulated robot moves at {velocity} rad/s or m/s, beyond {limit}"
    )]
    Diverged {
        /// When [s].
        time: f64,
        /// The joint.
        joint: String,
        /// Its velocity.
        velocity: f64,
        /// The limit.
        limit: f64,
    },
}
