//! Why a task cannot be planned.

use super::{MAX_NODES, StrokeFault, TourError};
use crate::represent::Action;

/// Why no plan could be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// No node fits on the surface.
    #[error(
        "surface \"{surface}\": no place is free for a tool that needs {diameter:.3} m of clearance"
    )]
    NoFreeNode {
        /// Name of the surface.
        surface: String,
        /// d_s [m].
        diameter: f64,
    },
    /// A surface that is too large for its tool.
    #[error(
        "surface \"{surface}\": {count} nodes {pitch:.4} m apart exceed the limit of {MAX_NODES}; {advice}"
    )]
    TooManyNodes {
        /// Name of the surface.
        surface: String,
        /// How many nodes cover it.
        count: usize,
        /// Their distance [m].
        pitch: f64,
        /// What to do.
        advice: &'static str,
    },
    /// The goal node given by the user cannot be taken.
    #[error(
        "goal node ({x:.3}, {y:.3}) m on surface \"{surface}\": {distance:.3} m from the nearest obstacle or off the surface, the tool needs {radius:.3} m"
    )]
    GoalNotFree {
        /// Name of the surface.
        surface: String,
        /// Its x [m].
        x: f64,
        /// Its y [m].
        y: f64,
        /// Distance to the scene [m].
        distance: f64,
        /// r_s [m].
        radius: f64,
    },
    /// A skim has no edge to push over.
    #[error(
        "surface \"{surface}\": a skim needs at least one edge in skim_edges with free space beyond it"
    )]
    NoSkimEdge {
        /// Name of the surface.
        surface: String,
    },
    /// A strategy that is none for what is to be done.
    #[error("strategy \"{strategy}\" plans no {action}; it is planned by {fitting}")]
    StrategyDoesNotFit {
        /// As given.
        strategy: &'static str,
        /// What is to be done.
        action: Action,
        /// Strategies that plan that.
        fitting: String,
    },
    /// A surface is to be treated, and it is not said to what.
    #[error("{action}: the task does not say how often, or how thick")]
    NoTreatment {
        /// What is to be done.
        action: Action,
    },
    /// The scene's geometry cannot be used.
    #[error("scene: {0}")]
    Scene(String),
    /// A stroke that came from outside cannot be made.
    #[error(transparent)]
    Stroke(#[from] StrokeFault),
    /// The user's own strategy gives no strokes.
    #[error("own strategy: {0}")]
    OwnStrategy(String),
    /// The tour could not be solved.
    #[error(transparent)]
    Tour(#[from] TourError),
}
