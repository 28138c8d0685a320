//! Where the tool goes: the order in which nodes are visited.

mod tour;

pub use tour::{
    CostMatrix, MAX_TOUR_COST, MAX_TOUR_NODES, TourConfig, TourError, shortest_path_from,
    shortest_tour,
};
