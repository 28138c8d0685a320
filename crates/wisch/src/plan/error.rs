//! Reasons why a task cannot be planned.

use super::{MAX_NODES, StrokeFault, TourError};
use crate::represent::{Action, ShapeFault};

/// The reason why the planner returned no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// No node fits on the surface.
    #[error(
        "surface \"{surface}\": no free place for the tool, which needs {diameter:.3} m of clearance; take a smaller tool{}",
        if *has_obstacles { " or move the obstacles" } else { " or a larger surface" }
    )]
    NoFreeNode {
        /// Name of the surface.
        surface: String,
        /// Required clearance, d_s \[m\].
        diameter: f64,
        /// Whether there are objects besides the surface.
        has_obstacles: bool,
    },
    /// No sample of the density lies at a free place, because the bandwidth is much larger than the surface.
    #[error(
        "surface \"{surface}\": the density of the dirt with plan.bandwidth_m = {bandwidth} has no sample at a free place; take a smaller bandwidth, such as {usual:.3}, or leave it out"
    )]
    BandwidthTooWide {
        /// Name of the surface.
        surface: String,
        /// The bandwidth \[m\].
        bandwidth: f64,
        /// A usual bandwidth, the radius of the tool's collision sphere \[m\].
        usual: f64,
    },
    /// One pass leaves at least twice the wanted thickness of a coat.
    #[error(
        "one pass leaves {:.4} mm, at least twice the wanted {:.4} mm: reduce the dispensed volume per metre, or take a wider tool",
        1e3 * per_pass,
        1e3 * thickness
    )]
    CoatTooThin {
        /// Wanted thickness \[m\].
        thickness: f64,
        /// Thickness that one pass leaves \[m\].
        per_pass: f64,
    },
    /// The surface is too large for the tool.
    #[error(
        "surface \"{surface}\": {count} nodes {pitch:.4} m apart exceed the limit of {MAX_NODES}; {advice}"
    )]
    TooManyNodes {
        /// Name of the surface.
        surface: String,
        /// Number of nodes that would cover it.
        count: usize,
        /// Distance between nodes \[m\].
        pitch: f64,
        /// What the user can do.
        advice: &'static str,
    },
    /// The goal node that the task gives is off the surface.
    #[error(
        "the goal (collect.goal_m) at ({x:.3}, {y:.3}) m is off the surface \"{surface}\"; choose a goal on the surface"
    )]
    GoalOffSurface {
        /// Name of the surface.
        surface: String,
        /// x of the goal node in the surface frame \[m\].
        x: f64,
        /// y of the goal node in the surface frame \[m\].
        y: f64,
    },
    /// The goal node that the task gives is too near an obstacle.
    #[error(
        "the goal (collect.goal_m) at ({x:.3}, {y:.3}) m on surface \"{surface}\" is {distance:.3} m from an obstacle, but the tool needs {radius:.3} m; choose another goal, a smaller tool, or move the obstacle"
    )]
    GoalNotFree {
        /// Name of the surface.
        surface: String,
        /// x of the goal node in the surface frame \[m\].
        x: f64,
        /// y of the goal node in the surface frame \[m\].
        y: f64,
        /// Distance from the goal node to the scene \[m\].
        distance: f64,
        /// Radius of the collision sphere, r_s \[m\].
        radius: f64,
    },
    /// A skim has no edge over which it may push.
    #[error(
        "surface \"{surface}\": a skim needs at least one edge in skim_edges with free space beyond it"
    )]
    NoSkimEdge {
        /// Name of the surface.
        surface: String,
    },
    /// The strategy does not plan the task's action.
    #[error(
        "strategy \"{strategy}\" cannot plan the action {action}; strategies that can: {fitting}"
    )]
    StrategyDoesNotFit {
        /// Name of the strategy.
        strategy: &'static str,
        /// The task's action.
        action: Action,
        /// Names of the strategies that plan this action.
        fitting: String,
    },
    /// The action treats the surface, and the task does not say how many passes or how thick a layer.
    #[error(
        "{action}: the task gives neither a number of passes nor a layer thickness; set polish.passes or dispense.thickness_m"
    )]
    NoTreatment {
        /// The task's action.
        action: Action,
    },
    /// The chart of the surface does not fit its shape.
    #[error("surface \"{surface}\": {fault}")]
    Shape {
        /// Name of the surface.
        surface: String,
        /// What does not fit.
        fault: ShapeFault,
    },
    /// The bend of the surface is too sharp for the tool.
    #[error(
        "tool \"{tool}\" on surface \"{surface}\": the tool touches up to {reach:.3} m from its centre, but the radius is {radius:.3} m; the model of contact holds up to one radius, so take a smaller tool"
    )]
    TooBent {
        /// Name of the tool.
        tool: String,
        /// Name of the surface.
        surface: String,
        /// Radius of the surface \[m\], negative where it is hollow.
        radius: f64,
        /// How far from its centre the tool touches \[m\].
        reach: f64,
    },
    /// A tool that hovers is too long for the bend.
    #[error(
        "tool \"{tool}\" hovers over surface \"{surface}\": over its length, a radius of {radius:.3} m bends by {sag:.4} m, more than the {limit:.4} m at which its ends still act and touch nothing; take a shorter tool"
    )]
    HoversOffBend {
        /// Name of the tool.
        tool: String,
        /// Name of the surface.
        surface: String,
        /// Radius of the surface \[m\], negative where it is hollow.
        radius: f64,
        /// Distance of the surface from its tangent plane at the ends of the tool \[m\].
        sag: f64,
        /// Largest permitted distance \[m\].
        limit: f64,
    },
    /// An object of the scene is near a curved surface.
    #[error(
        "surface \"{surface}\": an object of the scene is {distance:.3} m from its outer side, but the tool needs {needed:.3} m; the planner does not go around objects on curved surfaces yet; if the object is behind the surface, the outer side is the other one (surface.mesh.towards)"
    )]
    ObstacleOnBend {
        /// Name of the surface.
        surface: String,
        /// Distance of the object from the surface \[m\].
        distance: f64,
        /// Required distance \[m\]: the radius of the collision sphere, r_s, and the error of the search.
        needed: f64,
    },
    /// Loose dirt slides on a curved surface.
    #[error(
        "surface \"{surface}\": its slope reaches {slope:.0}°, on which dirt slides; on a curved surface, grains need a declared friction (medium.static_friction), and no liquid runs on it"
    )]
    SteepBend {
        /// Name of the surface.
        surface: String,
        /// Largest slope \[°\].
        slope: f64,
    },
    /// The scene's geometry cannot be used.
    #[error("scene: {0}")]
    Scene(String),
    /// The tool cannot make a stroke that the user gave.
    #[error(transparent)]
    Stroke(#[from] StrokeFault),
    /// The user's own strategy returned no usable strokes.
    #[error("own strategy: {0}")]
    OwnStrategy(String),
    /// The tour could not be solved.
    #[error(transparent)]
    Tour(#[from] TourError),
}
