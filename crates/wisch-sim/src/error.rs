//! Errors of the simulation.

use wisch::represent::SourceError;
use wisch::robot::RobotError;

/// Why an execution cannot begin or continue.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The robot's description is incomplete or inconsistent.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// The dirt of the settings does not fit on the surface.
    #[error("the simulated world's dirt cannot be placed: {0}")]
    Dirt(#[from] SourceError),
    /// No joint between the world and the tool moves.
    #[error(
        "robot {robot:?}: no joint moves the tool; the tool's link needs a moving joint between it and the world"
    )]
    NothingMoves {
        /// Name of the robot.
        robot: String,
    },
    /// The tool has no underside.
    #[error("the tool's footprint has no area; expected an underside that can touch the surface")]
    NoFootprint,
    /// The surface has no area.
    #[error("the surface's outline has no area; expected an area that the tool can touch")]
    NoSurface,
    /// The mass matrix is singular: some joint moves too little mass for a torque to be defined.
    #[error(
        "at {time:.3} s the mass matrix of the robot is not positive definite: some joint moves a link without mass or inertia; `wisch robot check` names it"
    )]
    NoInertia {
        /// Simulated time of the failure \[s\].
        time: f64,
    },
    /// The simulation has diverged.
    #[error(
        "the simulation diverged: at {time:.3} s joint {joint:?} moves at {velocity} {unit}/s, more than the limit of {limit} {unit}/s"
    )]
    Diverged {
        /// Simulated time of the failure \[s\].
        time: f64,
        /// Name of the joint.
        joint: String,
        /// Its velocity [rad/s or m/s].
        velocity: f64,
        /// The limit that it exceeds [rad/s or m/s].
        limit: f64,
        /// "rad", or "m" for a prismatic joint.
        unit: &'static str,
    },
    /// A joint that follows others does not stay with them: the simulation holds it to them by a spring, which oscillates if the
    /// joint's link is much lighter than what it carries.
    #[error(
        "the simulation of the robot is wrong: at {time:.3} s joint {joint:?}, which follows others (<mimic>), oscillates against them, as its link is too light for what it carries; execute the motions elsewhere with --executor, or make the link heavier"
    )]
    Oscillates {
        /// Simulated time of the failure \[s\].
        time: f64,
        /// Name of the joint.
        joint: String,
    },
}
