//! From a task to strokes: nodes that cover the surface, a graph with the action's policy, an order,
//! and the predicted effect; paper §3.2 to §3.4.

mod adaptive;
mod candidates;
mod clearance;
mod coverage;
mod error;
mod given_strokes;
mod graph;
mod heading;
mod lanes;
mod objective;
mod planner;
mod portfolio;
mod predict;
mod strategy;
mod strokes;
mod subplans;
mod tour;
mod tree;

pub use candidates::best_subplan_of_candidates;
pub use clearance::FreeSpace;
pub use coverage::{
    CoverageDensity, CoverageStrategy, KdeConfig, MAX_NODES, RrtConfig, data_bandwidth, grid, kde,
    rrt,
};
pub use error::PlanError;
pub use given_strokes::{
    StrokeFault, StrokeOverBorder, check_strokes, describe_over_border, plan_of_strokes,
};
pub use graph::{Node, NodeRole, SemanticDirectedGraph};
pub use heading::HeadingRule;
pub use objective::is_gainful;
pub use planner::{PlanConfig, SearchConfig, cheapest_chains, joined_anew};
pub(crate) use portfolio::most_worth;
pub use portfolio::{
    Candidate, Portfolio, best_plan, plan, plan_around, plan_for_any, portfolio, worth,
};
pub use predict::{Prediction, PredictionProgress, predict};
pub use strategy::Strategy;
pub use strokes::{Plan, Stroke, TcpWaypoint};
pub use subplans::best_subplan;
pub use tour::{
    CostMatrix, MAX_TOUR_COST, MAX_TOUR_NODES, TourConfig, TourError, shortest_path_from,
    shortest_tour,
};
