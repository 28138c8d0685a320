//! From a task to strokes: nodes that cover the surface, a graph with the action's policy, an order,
//! and the predicted effect; paper §3.2 to §3.4.

mod clearance;
mod coverage;
mod goal;
mod graph;
mod planner;
mod predict;
mod segments;
mod strokes;
mod tour;
mod tree;
mod variants;
mod worth;

pub use clearance::FreeSpace;
pub use coverage::{
    CoverageStrategy, DensityMap, KdeConfig, RrtConfig, UnknownStrategy, data_bandwidth, grid, kde,
    rrt,
};
pub use goal::{Domain, GoalError, GoalLiteral, Problem, ResolvedGoal, Step, resolve_goal, solve};
pub use graph::{Node, NodeRole, SemanticDirectedGraph};
pub use planner::{Plan, PlanConfig, PlanError, plan};
pub use predict::{Prediction, Progress, predict};
pub use segments::{best_segment, best_segment_of_variants};
pub use strokes::{Stroke, TcpWaypoint};
pub use tour::{
    CostMatrix, MAX_TOUR_COST, MAX_TOUR_NODES, TourConfig, TourError, shortest_path_from,
    shortest_tour,
};
pub use variants::best_plan;
