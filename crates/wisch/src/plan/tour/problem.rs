//! The tour problem, closed or open, and the nearest neighbours of each node.
//!
//! An open path is a closed tour with one more node: it is next to the start by a fixed edge, and it
//! costs nothing to reach from anywhere. Leaving it out leaves a path with a free end.

use super::{CostMatrix, Finish};

/// Number of nearest neighbours that are kept for each node.
const NEIGHBOUR_COUNT: usize = 8;

/// The problem of a closed tour; one edge may be fixed.
pub(super) struct Problem<'a> {
    pub(super) costs: &'a CostMatrix,
    pub(super) start: usize,
    pub(super) finish: Finish,
}

impl Problem<'_> {
    pub(super) fn node_count(&self) -> usize {
        match self.finish {
            Finish::AtStart => self.costs.node_count(),
            Finish::Anywhere => self.costs.node_count() + 1,
        }
    }

    pub(super) fn cost(&self, a: usize, b: usize) -> f64 {
        if a.max(b) < self.costs.node_count() {
            self.costs.cost(a, b)
        } else {
            0.0
        }
    }

    /// The edge that every tour must use.
    pub(super) fn fixed_edge(&self) -> Option<(usize, usize)> {
        match self.finish {
            Finish::AtStart => None,
            Finish::Anywhere => Some((self.start, self.costs.node_count())),
        }
    }

    pub(super) fn is_fixed(&self, a: usize, b: usize) -> bool {
        self.fixed_edge()
            .is_some_and(|edge| edge == (a, b) || edge == (b, a))
    }
}

/// A neighbour of a node and the cost between the two.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbour {
    pub(super) node: usize,
    pub(super) cost: f64,
}

/// For each node its nearest neighbours, nearest first.
pub(super) struct Neighbours {
    all: Vec<Neighbour>,
}

impl Neighbours {
    pub(super) fn nearest(problem: &Problem) -> Self {
        let node_count = problem.node_count();
        let mut all = Vec::with_capacity(node_count * NEIGHBOUR_COUNT);
        let by_cost =
            |x: &Neighbour, y: &Neighbour| x.cost.total_cmp(&y.cost).then(x.node.cmp(&y.node));
        for from in 0..node_count {
            let mut others: Vec<Neighbour> = (0..node_count)
                .filter(|&node| node != from)
                .map(|node| Neighbour {
                    node,
                    cost: problem.cost(from, node),
                })
                .collect();
            others.select_nth_unstable_by(NEIGHBOUR_COUNT, by_cost);
            others.truncate(NEIGHBOUR_COUNT);
            others.sort_by(by_cost);
            all.extend(others);
        }
        Self { all }
    }

    pub(super) fn of(&self, node: usize) -> &[Neighbour] {
        &self.all[node * NEIGHBOUR_COUNT..][..NEIGHBOUR_COUNT]
    }
}
