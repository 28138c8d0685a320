//! A first tour: the cheapest edges that fit together, then the loose fragments end to end.

use super::problem::{Neighbours, Problem};

/// Fragments of a growing tour: every node has at most two links and no links close a ring.
struct Fragments {
    links: Vec<[Option<usize>; 2]>,
    /// For the end of a fragment, its other end; for a lone node, the node itself.
    other_end: Vec<usize>,
}

impl Fragments {
    fn of_lone_nodes(node_count: usize) -> Self {
        Self {
            links: vec![[None; 2]; node_count],
            other_end: (0..node_count).collect(),
        }
    }

    fn is_end(&self, node: usize) -> bool {
        self.links[node][1].is_none()
    }

    fn can_link(&self, a: usize, b: usize) -> bool {
        self.is_end(a) && self.is_end(b) && self.other_end[a] != b
    }

    fn link(&mut self, a: usize, b: usize) {
        for (from, to) in [(a, b), (b, a)] {
            let free = usize::from(self.links[from][0].is_some());
            self.links[from][free] = Some(to);
        }
        let (far_a, far_b) = (self.other_end[a], self.other_end[b]);
        self.other_end[far_a] = far_b;
        self.other_end[far_b] = far_a;
    }

    /// Iterates over the nodes of a fragment from one of its ends to the other.
    fn walk(&self, end: usize) -> impl Iterator<Item = usize> + '_ {
        let mut previous = None;
        let mut current = Some(end);
        std::iter::from_fn(move || {
            let here = current?;
            current = self.links[here]
                .into_iter()
                .flatten()
                .find(|&next| Some(next) != previous);
            previous = Some(here);
            Some(here)
        })
    }
}

/// Returns a closed tour through all nodes of the problem that uses its fixed edge.
pub(super) fn tour(problem: &Problem, neighbours: &Neighbours) -> Vec<usize> {
    let node_count = problem.node_count();
    let mut fragments = Fragments::of_lone_nodes(node_count);
    if let Some((a, b)) = problem.fixed_edge() {
        fragments.link(a, b);
    }

    let mut edges: Vec<(f64, usize, usize)> = (0..node_count)
        .flat_map(|a| {
            neighbours
                .of(a)
                .iter()
                .map(move |near| (near.cost, a.min(near.node), a.max(near.node)))
        })
        .collect();
    edges.sort_by(|x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
    for (_, a, b) in edges {
        if fragments.can_link(a, b) {
            fragments.link(a, b);
        }
    }

    let mut ends: Vec<usize> = (0..node_count).filter(|&i| fragments.is_end(i)).collect();
    let mut tour: Vec<usize> = Vec::with_capacity(node_count);
    while let Some(nearest) = (0..ends.len()).min_by(|&x, &y| {
        let distance = |index: usize| {
            tour.last()
                .map_or(0.0, |&last| problem.cost(last, ends[index]))
        };
        distance(x).total_cmp(&distance(y))
    }) {
        let near_end = ends[nearest];
        let far_end = fragments.other_end[near_end];
        tour.extend(fragments.walk(near_end));
        ends.retain(|&end| end != near_end && end != far_end);
    }
    tour
}
