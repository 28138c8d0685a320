//! Minimum spanning trees rooted in one or several goals: policies of collect and skim; paper §3.2.

use super::FreeSpace;
use crate::geometry::{Bounds2, DisjointSets, Point2, PointGrid};

/// A forest that leads every connected node to one of the roots.
pub(super) struct Forest {
    /// For each node the next node on the path to its root; `None` for roots and unreachable nodes.
    pub(super) parent: Vec<Option<usize>>,
    /// Nodes without a path to any root.
    pub(super) unreachable: Vec<usize>,
    /// Length of the longest edge that was allowed: at least l_max [m].
    pub(super) edge_length: f64,
}

/// Largest number of node pairs that are examined. Up to 6000 nodes have fewer pairs, so that no edge is
/// overlooked.
const MOST_PAIRS: usize = 20_000_000;
/// Ratio of the longest edges of two consecutive bands [1].
const BAND: f64 = 1.5;

/// Computes the minimum spanning forest by Kruskal's algorithm, from a virtual root that joins all `roots` at
/// no cost.
///
/// The edges of a minimum spanning tree are the shortest that connect. Edges longer than `max_length` are
/// therefore taken only where the tree would otherwise fall apart. An edge to a goal beyond the
/// border counts its length minus r_s, by which the goal lies outside, because particles are pushed
/// only up to the border. With full lengths, hardly any tree would start from its own goal.
///
/// Edges are examined in bands of growing length, and only between parts that are not yet connected: that takes
/// n log n time on a grid of n nodes. Nodes that [`MOST_PAIRS`] pairs do not connect are unreachable.
pub(super) fn forest(
    space: &FreeSpace,
    nodes: &[Point2],
    roots: &[usize],
    max_length: f64,
) -> Forest {
    let mut joined = Components::of(nodes.len());
    for pair in roots.windows(2) {
        joined.union(pair[0], pair[1]);
    }
    let outline = &space.surface().outline;
    let is_outside: Vec<bool> = nodes.iter().map(|node| !outline.contains(*node)).collect();
    let length = |i: usize, j: usize| {
        let beyond = if is_outside[i] || is_outside[j] {
            space.radius()
        } else {
            0.0
        };
        (nodes[i] - nodes[j]).norm() - beyond
    };
    let longest =
        Bounds2::from_points(nodes.iter().copied()).map_or(0.0, |bounds| bounds.size().norm());
    let grid = PointGrid::from_points(nodes, max_length.max(f64::MIN_POSITIVE));
    let mut neighbours = vec![Vec::new(); nodes.len()];
    let mut edge_length = max_length;
    let mut looked_at = 0;
    let [mut least, mut most] = [f64::NEG_INFINITY, max_length];
    while joined.parts > 1 && least < longest && looked_at < MOST_PAIRS {
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        // A pair of nodes from two parts has at least one node outside the largest part.
        let largest = joined.largest();
        for i in (0..nodes.len()).filter(|&i| joined.part(i) != largest) {
            grid.visit_within(nodes[i], most + space.radius(), |j, _| {
                let is_new = j > i || joined.part(j) == largest;
                if !is_new || joined.part(i) == joined.part(j) || looked_at >= MOST_PAIRS {
                    return;
                }
                let length = length(i, j);
                if length > least && length <= most {
                    pairs.push((length, i.min(j), i.max(j)));
                    looked_at += 1;
                }
            });
        }
        pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        for (length, i, j) in pairs {
            if joined.part(i) != joined.part(j) && space.is_clear_between(nodes[i], nodes[j]) {
                joined.union(i, j);
                neighbours[i].push(j);
                neighbours[j].push(i);
                edge_length = edge_length.max(length);
            }
        }
        [least, most] = [most, BAND * most];
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

/// Returns the branches of a forest in the order of execution; paper §3.3.
///
/// The first branch starts at the leaf nearest the tool, the next at the nearest leaf that is left. A branch
/// ends at a junction where another branch still has to arrive. The last branch to arrive takes the dirt of all
/// of them along, so every edge is wiped once and no dirt stays at a junction.
pub(super) fn branches(
    nodes: &[Point2],
    parent: &[Option<usize>],
    start: Point2,
) -> Vec<Vec<usize>> {
    let mut pending = vec![0usize; nodes.len()];
    for to in parent.iter().flatten() {
        pending[*to] += 1;
    }
    let mut leaves = PointGrid::new(cell_size(nodes));
    for leaf in (0..nodes.len()).filter(|&i| pending[i] == 0 && parent[i].is_some()) {
        leaves.insert(leaf, nodes[leaf]);
    }
    let mut tool = start;
    let mut branches = Vec::new();
    while let Some(leaf) = leaves.nearest(tool) {
        leaves.remove(leaf, nodes[leaf]);
        let mut branch = vec![leaf];
        let mut at = leaf;
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

/// Side of square cells that hold about one node each [m].
fn cell_size(nodes: &[Point2]) -> f64 {
    let size =
        Bounds2::from_points(nodes.iter().copied()).map_or(1.0, |bounds| bounds.size().max());
    (size / (nodes.len().max(1) as f64).sqrt()).max(1e-6)
}

/// Disjoint sets of connected nodes, with their sizes (union-find).
struct Components {
    parts_of: DisjointSets,
    sizes: Vec<usize>,
    parts: usize,
}

impl Components {
    fn of(count: usize) -> Self {
        Self {
            parts_of: DisjointSets::new(count),
            sizes: vec![1; count],
            parts: count,
        }
    }

    /// Returns the representative of a node's part.
    fn part(&self, node: usize) -> usize {
        self.parts_of.find(node)
    }

    /// Joins the parts of two nodes.
    fn union(&mut self, a: usize, b: usize) {
        let size = self.sizes[self.part(a)] + self.sizes[self.part(b)];
        if self.parts_of.union(a, b) {
            let part = self.part(a);
            self.sizes[part] = size;
            self.parts -= 1;
        }
    }

    /// Returns the part with the most nodes.
    fn largest(&self) -> usize {
        let size = |node: &usize| {
            (
                self.sizes[self.part(*node)],
                std::cmp::Reverse(self.part(*node)),
            )
        };
        let node = (0..self.sizes.len()).max_by_key(size).unwrap_or(0);
        self.part(node)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, Polygon, Pose, Vector2, Vector3};
    use crate::represent::Surface;

    fn space(walls: &[Mesh]) -> FreeSpace {
        let surface = Surface {
            name: "floor".into(),
            outline: Polygon::rectangle(Vector2::new(100.0, 100.0)),
            world_from_surface: Pose::identity(),
            skim_edges: vec![],
            shape: Default::default(),
        };
        FreeSpace::new(&surface, walls, 0.1).unwrap()
    }

    fn wall(at: [f64; 2], size: [f64; 2]) -> Mesh {
        let mesh = Mesh::cuboid(Vector3::new(size[0], size[1], 1.0)).unwrap();
        mesh.transform(&Pose::translation(at[0], at[1], 0.5))
    }

    fn cells(columns: usize, rows: usize) -> Vec<Point2> {
        let cell = |i: usize| Point2::new((i % columns) as f64, (i / columns) as f64) * 0.1;
        (0..columns * rows).map(cell).collect()
    }

    #[test]
    fn a_tree_of_sixty_thousand_cells_has_an_edge_less_than_nodes() {
        let nodes = cells(300, 200);
        let forest = forest(&space(&[]), &nodes, &[0], 0.2);
        assert_eq!(forest.unreachable, [0_usize; 0]);
        assert_eq!(forest.parent.iter().flatten().count(), nodes.len() - 1);
        let edges = forest.parent.iter().enumerate();
        let length: f64 = edges
            .filter_map(|(i, parent)| Some((nodes[i] - nodes[(*parent)?]).norm()))
            .sum();
        // The length of a spanning tree of square cells is its number of edges times the pitch.
        assert!(
            (length - 0.1 * (nodes.len() - 1) as f64).abs() < 1e-6,
            "{length}"
        );
        let branches = branches(&nodes, &forest.parent, Point2::origin());
        let edges: usize = branches.iter().map(|branch| branch.len() - 1).sum();
        assert_eq!(edges, nodes.len() - 1);
    }

    #[test]
    fn distant_groups_are_joined_by_the_shortest_edge_between_them() {
        let mut nodes = cells(3, 3);
        nodes.extend(
            cells(3, 3)
                .iter()
                .map(|node| node + Vector2::new(20.0, 0.0)),
        );
        let forest = forest(&space(&[]), &nodes, &[0], 0.2);
        assert_eq!(forest.unreachable, [0_usize; 0]);
        assert!((forest.edge_length - 19.8).abs() < 1e-9);
    }

    #[test]
    fn nodes_behind_a_wall_without_a_gap_are_unreachable() {
        let nodes = [0.0, 0.1, 1.0].map(|x| Point2::new(x, 0.0));
        let forest = forest(&space(&[wall([0.5, 0.0], [0.1, 90.0])]), &nodes, &[0], 0.2);
        assert_eq!(forest.unreachable, [2]);
    }
}
