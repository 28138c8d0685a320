//! Short tours and open paths through all nodes (the symmetric travelling salesman problem).
//!
//! Up to [`EXACT_NODES`] nodes the answer is optimal (dynamic programming after Held and Karp, 1962).
//! Above, a greedy start is improved by sequential exchanges (after Lin and Kernighan, 1973) and then
//! by many small random kicks. Each is repaired locally and undone unless it shortens the tour (iterated local
//! search; Johnson and McGeoch, 1997, survey both).

mod exact;
mod greedy;
mod local_search;
mod problem;
mod ring;

use crate::geometry::Point2;
use problem::Problem;
use thiserror::Error;

/// The most nodes a [`CostMatrix`] may have; its memory grows with their square (200 MB here).
pub const MAX_TOUR_NODES: usize = 5000;

/// The largest magnitude of a single cost, chosen so that sums along a tour stay finite.
pub const MAX_TOUR_COST: f64 = 1e100;

/// Up to this many nodes the answer is optimal; the table then has 2¹¹ · 11 entries.
const EXACT_NODES: usize = 12;

/// Why a tour cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TourError {
    /// A cost is not a number, infinite or too large.
    #[error(
        "cost between nodes {from} and {to} is {cost}; its magnitude must be at most {MAX_TOUR_COST:e}"
    )]
    CostOutOfRange {
        /// The lower index of the two nodes.
        from: usize,
        /// The higher index of the two nodes.
        to: usize,
        /// The offending cost.
        cost: f64,
    },
    /// There are more nodes than [`MAX_TOUR_NODES`].
    #[error("{count} nodes exceed the limit of {MAX_TOUR_NODES}")]
    TooManyNodes {
        /// Number of nodes that were given.
        count: usize,
    },
    /// The start is not one of the nodes.
    #[error("start node {start} does not exist: there are {count} nodes")]
    StartOutOfRange {
        /// The requested start.
        start: usize,
        /// Number of nodes.
        count: usize,
    },
}

/// Symmetric costs of moving between `n` nodes, n × n, row-major.
///
/// Costs need not obey the triangle inequality and may be negative. A forbidden move gets a large cost, for
/// example a thousand times the sum of all allowed costs: the answer then uses as few forbidden moves as it
/// can.
#[derive(Debug, Clone, PartialEq)]
pub struct CostMatrix {
    node_count: usize,
    costs: Vec<f64>,
}

impl CostMatrix {
    /// Returns the matrix of the costs `cost(i, j)` between `node_count` nodes; `cost` is called once per pair,
    /// with i < j.
    ///
    /// ```
    /// use wisch::plan::CostMatrix;
    /// let costs = CostMatrix::from_fn(3, |i, j| (i + j) as f64)?;
    /// assert_eq!(costs.cost(2, 1), 3.0);
    /// assert_eq!(costs.cost(2, 2), 0.0);
    /// # Ok::<(), wisch::plan::TourError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`TourError::TooManyNodes`] beyond [`MAX_TOUR_NODES`] and [`TourError::CostOutOfRange`] for a
    /// cost that is not a number or exceeds [`MAX_TOUR_COST`].
    pub fn from_fn(
        node_count: usize,
        mut cost: impl FnMut(usize, usize) -> f64,
    ) -> Result<Self, TourError> {
        if node_count > MAX_TOUR_NODES {
            return Err(TourError::TooManyNodes { count: node_count });
        }
        let mut costs = vec![0.0; node_count * node_count];
        for from in 0..node_count {
            for to in from + 1..node_count {
                let cost = cost(from, to);
                if cost.is_nan() || cost.abs() > MAX_TOUR_COST {
                    return Err(TourError::CostOutOfRange { from, to, cost });
                }
                costs[from * node_count + to] = cost;
                costs[to * node_count + from] = cost;
            }
        }
        Ok(Self { node_count, costs })
    }

    /// Returns the matrix of straight-line distances \[m\] between points of one frame \[m\].
    ///
    /// ```
    /// use wisch::{geometry::Point2, plan::CostMatrix};
    /// let costs = CostMatrix::euclidean(&[Point2::new(0.0, 0.0), Point2::new(3.0, 4.0)])?;
    /// assert_eq!(costs.cost(0, 1), 5.0);
    /// # Ok::<(), wisch::plan::TourError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`CostMatrix::from_fn`].
    pub fn euclidean(points: &[Point2]) -> Result<Self, TourError> {
        Self::from_fn(points.len(), |i, j| (points[i] - points[j]).norm())
    }

    /// Number of nodes n of the n × n matrix.
    pub fn node_count(&self) -> usize {
        self.node_count
    }

    /// Cost of moving between two nodes; 0 from a node to itself.
    ///
    /// # Panics
    ///
    /// If a node does not exist.
    pub fn cost(&self, from: usize, to: usize) -> f64 {
        assert!(
            to < self.node_count,
            "node {to} of {} nodes",
            self.node_count
        );
        self.costs[from * self.node_count + to]
    }

    /// Cost of visiting the nodes in the given order, without the way back.
    ///
    /// ```
    /// use wisch::plan::CostMatrix;
    /// let costs = CostMatrix::from_fn(3, |i, j| (i + j) as f64)?;
    /// assert_eq!(costs.path_cost(&[0, 1, 2]), 4.0);
    /// # Ok::<(), wisch::plan::TourError>(())
    /// ```
    pub fn path_cost(&self, path: &[usize]) -> f64 {
        path.windows(2)
            .map(|step| self.cost(step[0], step[1]))
            .sum()
    }

    /// Cost of visiting the nodes in the given order and returning to the first.
    ///
    /// ```
    /// use wisch::plan::CostMatrix;
    /// let costs = CostMatrix::from_fn(3, |i, j| (i + j) as f64)?;
    /// assert_eq!(costs.tour_cost(&[0, 1, 2]), 6.0);
    /// # Ok::<(), wisch::plan::TourError>(())
    /// ```
    pub fn tour_cost(&self, tour: &[usize]) -> f64 {
        match (tour.first(), tour.last()) {
            (Some(&first), Some(&last)) => self.path_cost(tour) + self.cost(last, first),
            _ => 0.0,
        }
    }
}

/// Effort of the search; without effect up to 12 nodes, where the answer is optimal.
#[derive(Debug, Clone, PartialEq)]
pub struct TourConfig {
    /// Number of random kicks per node; time grows in proportion.
    pub kicks_per_node: usize,
    /// Seed of the kicks; equal seeds give equal answers.
    pub seed: u64,
}

impl Default for TourConfig {
    fn default() -> Self {
        Self {
            kicks_per_node: 25,
            seed: 0,
        }
    }
}

/// The end of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Finish {
    /// At the start node.
    AtStart,
    /// At the node with the lowest cost.
    Anywhere,
}

/// Returns an order of all nodes that begins at `start`, ends anywhere and has a low [`CostMatrix::path_cost`].
///
/// Optimal up to 12 nodes. The same input gives the same answer.
///
/// ```
/// use wisch::{geometry::Point2, plan::{CostMatrix, TourConfig, shortest_path_from}};
/// let points = [0.0, 3.0, 1.0, 2.0].map(|x| Point2::new(x, 0.0));
/// let costs = CostMatrix::euclidean(&points)?;
/// assert_eq!(shortest_path_from(&costs, 0, &TourConfig::default())?, [0, 2, 3, 1]);
/// # Ok::<(), wisch::plan::TourError>(())
/// ```
///
/// # Errors
///
/// [`TourError::StartOutOfRange`] if `start` is not one of the nodes.
pub fn shortest_path_from(
    costs: &CostMatrix,
    start: usize,
    config: &TourConfig,
) -> Result<Vec<usize>, TourError> {
    let count = costs.node_count();
    if start >= count {
        return Err(TourError::StartOutOfRange { start, count });
    }
    Ok(solve(costs, start, Finish::Anywhere, config))
}

/// Returns an order of all nodes, beginning at node 0, with a low [`CostMatrix::tour_cost`].
///
/// Optimal up to 12 nodes; empty without nodes. The same input gives the same answer.
///
/// ```
/// use wisch::{geometry::Point2, plan::{CostMatrix, TourConfig, shortest_tour}};
/// let corners = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Point2::new(x, y));
/// let costs = CostMatrix::euclidean(&corners)?;
/// let tour = shortest_tour(&costs, &TourConfig::default());
/// assert_eq!(costs.tour_cost(&tour), 4.0);
/// # Ok::<(), wisch::plan::TourError>(())
/// ```
pub fn shortest_tour(costs: &CostMatrix, config: &TourConfig) -> Vec<usize> {
    if costs.node_count() == 0 {
        return Vec::new();
    }
    solve(costs, 0, Finish::AtStart, config)
}

fn solve(costs: &CostMatrix, start: usize, finish: Finish, config: &TourConfig) -> Vec<usize> {
    if costs.node_count() <= EXACT_NODES {
        exact::solve(costs, start, finish)
    } else {
        let problem = Problem {
            costs,
            start,
            finish,
        };
        local_search::solve(&problem, config)
    }
}
