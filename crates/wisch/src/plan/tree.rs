//! Minimum spanning trees rooted in one or several goals: policies of collect and skim; paper §3.2.

use super::FreeSpace;
use crate::geometry::Point2;
use petgraph::unionfind::UnionFind;

/// A forest that leads every connected node to one of the roots.
pub(super) struct Forest {
    /// For each node the next one on its way to a root; `None` for roots and unreachable nodes.
    pub(super) parent: Vec<Option<usize>>,
    /// Nodes without a way to any root.
    pub(super) unreachable: Vec<usize>,
    /// The length up to which edges had to be allowed: at least l_max [m].
    pub(super) edge_length: f64,
}

/// Kruskal's algorithm from a virtual root that joins all `roots` at no cost.
///
/// The edges of a minimum spanning tree are the shortest that connect, so allowing edges longer than
/// `max_length` only where the tree would fall apart is what it does by itself. An edge to a goal beyond
/// the border counts less the r_s by which the goal lies outside: particles are pushed no further than
/// the border, and by full lengths hardly any tree would start from a goal of its own.
pub(super) fn forest(
    space: &FreeSpace,
    nodes: &[Point2],
    roots: &[usize],
    max_length: f64,
) -> Forest {
    let mut pairs: Vec<(f64, usize, usize)> = (0..nodes.len())
        .flat_map(|i| (i + 1..nodes.len()).map(move |j| (i, j)))
        .map(|(i, j)| {
            let outside = |node: usize| !space.surface().outline.contains(nodes[node]);
            let beyond = if outside(i) || outside(j) {
                space.radius()
            } else {
                0.0
            };
            ((nodes[i] - nodes[j]).norm() - beyond, i, j)
        })
        .collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut joined: UnionFind<usize> = UnionFind::new(nodes.len());
    for pair in roots.windows(2) {
        joined.union(pair[0], pair[1]);
    }
    let mut neighbours = vec![Vec::new(); nodes.len()];
    let mut edge_length = max_length;
    for (length, i, j) in pairs {
        if !joined.equiv(i, j) && space.is_clear_between(nodes[i], nodes[j]) {
            joined.union(i, j);
            neighbours[i].push(j);
            neighbours[j].push(i);
            edge_length = edge_length.max(length);
        }
    }
    let mut parent = vec![None; nodes.len()];
    let mut reached = vec![false; nodes.len()];
    let mut open: Vec<usize> = roots.to_vec();
    for &root in roots {
        reached[root] = true;
    }
    while let Some(node) = open.pop() {
        for &next in &neighbours[node] {
            if !reached[next] {
                reached[next] = true;
                parent[next] = Some(node);
                open.push(next);
            }
        }
    }
    let unreachable = (0..nodes.len()).filter(|&i| !reached[i]).collect();
    Forest {
        parent,
        unreachable,
        edge_length,
    }
}

/// The branches of a forest in the order in which they are worked off; paper §3.3.
///
/// From the leaf nearest the tool towards the root, then from the next nearest. A branch ends where
/// others still have to come in: the last to arrive takes what they brought along, so every edge is
/// wiped once and nothing is left at a junction.
pub(super) fn branches(
    nodes: &[Point2],
    parent: &[Option<usize>],
    start: Point2,
) -> Vec<Vec<usize>> {
    let mut pending = vec![0usize; nodes.len()];
    for to in parent.iter().flatten() {
        pending[*to] += 1;
    }
    let mut leaves: Vec<usize> = (0..nodes.len())
        .filter(|&i| pending[i] == 0 && parent[i].is_some())
        .collect();
    let mut tool = start;
    let mut branches = Vec::new();
    while let Some(nearest) = (0..leaves.len()).min_by(|&a, &b| {
        let distance = |i: usize| (nodes[leaves[i]] - tool).norm();
        distance(a).total_cmp(&distance(b))
    }) {
        let mut branch = vec![leaves.remove(nearest)];
        let mut at = branch[0];
        while let Some(next) = parent[at] {
            branch.push(next);
            pending[next] -= 1;
            at = next;
            if pending[next] > 0 {
                break;
            }
        }
        tool = nodes[at];
        branches.push(branch);
    }
    branches
}
