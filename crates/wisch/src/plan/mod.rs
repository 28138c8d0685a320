//! From a task to strokes: nodes that cover the surface, a graph with the action's policy, an order,
//! and the predicted effect; paper §3.2 to §3.4.

mod adaptive;
mod bend;
mod candidates;
mod clearance;
mod config;
mod coverage;
mod edge_margin;
mod error;
mod given_strokes;
mod graph;
mod lanes;
mod nominal_times;
mod objective;
mod planner;
mod policies;
mod predict;
mod score;
mod strategy;
mod strokes;
mod subplans;
mod tour;
mod tree;
mod yaw;

pub use bend::BendContact;
pub use clearance::FreeSpace;
pub use config::{PlanConfig, SearchConfig};
pub use coverage::{
    CoverageDensity, CoverageStrategy, KdeConfig, MAX_NODES, RrtConfig, data_bandwidth, grid, kde,
    rrt,
};
pub use error::PlanError;
pub use given_strokes::{
    StrokeFault, StrokeOverBorder, check_strokes, describe_over_border, plan_from_strokes,
};
pub use graph::{Node, NodeRole, SemanticDirectedGraph};
pub use objective::has_predicted_gain;
pub(crate) use planner::highest_score;
pub use planner::{Candidate, Planner, Portfolio, find_unreachable_share, plan};
pub(crate) use policies::{order_nodes, rejoin_nodes};
pub use predict::{Prediction, PredictionProgress, predict};
pub use score::PlanScore;
pub use strategy::Strategy;
pub use strokes::{Plan, Stroke, TcpWaypoint};
pub use tour::{
    CostMatrix, MAX_TOUR_COST, MAX_TOUR_NODES, TourConfig, TourError, shortest_path_from,
    shortest_tour,
};
pub use yaw::YawRule;
