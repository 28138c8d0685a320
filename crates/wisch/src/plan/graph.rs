//! The semantic directed graph (3): nodes are positions of the tool centre point, edges are motions in contact.

use crate::geometry::{Edge, Point2};
use crate::represent::GoalState;

/// What a node is for: to cover the surface, or to collect particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NodeRole {
    /// Covers a part of the surface.
    Coverage,
    /// The place to which particles are pushed: n_goal, or a place beyond the edge over which they
    /// are skimmed.
    Goal,
}

/// A position of the tool centre point on the surface's plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Position in the surface frame \[m\].
    pub position: Point2,
    /// What the node is for.
    pub role: NodeRole,
}

/// Semantic directed graph SDG = {P, S_g, G_s} of the paper: the nodes, the directed edges, and the
/// goal state that they serve.
#[derive(Debug, Clone, PartialEq)]
pub struct SemanticDirectedGraph {
    /// All nodes, coverage nodes first.
    pub nodes: Vec<Node>,
    /// Directed edges (from, to): the tool moves that way in contact.
    pub edges: Vec<(usize, usize)>,
    /// The geometric goal state.
    pub goal: GoalState,
    /// Longest edge allowed, l_max \[m\]; `None` where the policy does not limit it.
    pub max_edge_length: Option<f64>,
    /// Nodes that no valid edge connects to the goal.
    pub unreachable: Vec<usize>,
}

impl SemanticDirectedGraph {
    /// Position of a node in the surface frame \[m\].
    pub fn position(&self, node: usize) -> Point2 {
        self.nodes[node].position
    }

    /// Returns for each node of a tree the node to which its edge leads.
    pub(crate) fn successors(&self) -> Vec<Option<usize>> {
        let mut successors = vec![None; self.nodes.len()];
        for &(from, to) in &self.edges {
            successors[from].get_or_insert(to);
        }
        successors
    }

    /// Whether a particle lies within `radius` r_s \[m\] of a connected node or of an edge.
    pub fn reaches(&self, particle: Point2, radius: f64) -> bool {
        let near_node = self.nodes.iter().enumerate().any(|(i, node)| {
            !self.unreachable.contains(&i) && (node.position - particle).norm() <= radius
        });
        near_node
            || self.edges.iter().any(|&(from, to)| {
                let edge = Edge {
                    start: self.position(from),
                    end: self.position(to),
                };
                edge.distance(particle) <= radius
            })
    }
}
