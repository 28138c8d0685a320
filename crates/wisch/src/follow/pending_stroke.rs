//! Pending strokes: the part of a plan that is not yet followed.

use super::path::stroke_run::Corner;
use super::{AbandonedNode, Attempt};
use crate::geometry::wrap_angle;
use crate::plan::Stroke;

/// A pending node.
#[derive(Debug, Clone, Copy)]
pub(super) struct PendingNode {
    pub node: usize,
    pub corner: Corner,
    /// Index of its stroke in the plan.
    pub stroke: usize,
}

/// The pending part of a planned stroke, or a rejoined stroke.
#[derive(Debug, Clone)]
pub(super) struct PendingStroke {
    /// The pending nodes; the tool touches down at the first.
    pub nodes: Vec<PendingNode>,
    /// Whether the first node has been wiped already.
    pub begun: bool,
    /// Whether the node after the first has been abandoned.
    pub skipped: bool,
}

impl PendingStroke {
    /// Returns a whole stroke as pending. `stroke_of` returns the index of a node's stroke in the plan.
    pub fn from_stroke(stroke: &Stroke, stroke_of: impl Fn(usize) -> usize) -> Self {
        let nodes = stroke.nodes.iter().zip(&stroke.poses);
        Self::from_nodes(nodes.map(|(&node, &pose)| PendingNode {
            node,
            corner: Corner { pose, near: None },
            stroke: stroke_of(node),
        }))
    }

    /// Returns a pending stroke through these nodes.
    pub fn from_nodes(nodes: impl Iterator<Item = PendingNode>) -> Self {
        Self {
            nodes: nodes.collect(),
            begun: false,
            skipped: false,
        }
    }

    /// Whether the stroke contains a node.
    pub fn has(&self, node: usize) -> bool {
        self.nodes.iter().any(|waiting| waiting.node == node)
    }

    /// The nodes that are still pending.
    pub fn pending(&self) -> &[PendingNode] {
        let passed = if self.begun { self.copies(0) } else { 0 };
        &self.nodes[passed..]
    }

    /// Number of consecutive copies of the node at an index: two if the tool turns on it.
    pub fn copies(&self, at: usize) -> usize {
        let [first, ..] = &self.nodes[at..] else {
            return 0;
        };
        let same = |waiting: &&PendingNode| waiting.node == first.node;
        self.nodes[at..].iter().take_while(same).count()
    }

    /// Leaves the wiped node: the tool touches down at the next.
    pub fn touch_down_at_next(&mut self) {
        self.nodes.remove(0);
        self.begun = false;
        self.skipped = false;
    }

    /// Returns the stroke through its nodes.
    pub fn stroke(&self) -> Stroke {
        Stroke {
            nodes: self.nodes.iter().map(|waiting| waiting.node).collect(),
            poses: self
                .nodes
                .iter()
                .map(|waiting| waiting.corner.pose)
                .collect(),
        }
    }
}

/// Splits nodes into those at which the tool can touch down, and abandoned nodes with their attempts.
pub(super) fn split_by_touch(
    left: &[PendingNode],
    untouched: Vec<Option<Vec<Attempt>>>,
) -> (Vec<usize>, Vec<AbandonedNode>) {
    let (mut nodes, mut abandoned) = (Vec::new(), Vec::new());
    for (waiting, attempts) in left.iter().zip(untouched) {
        match attempts {
            None => nodes.push(waiting.node),
            Some(attempts) => abandoned.push(AbandonedNode {
                node: waiting.node,
                stroke: waiting.stroke,
                attempts,
            }),
        }
    }
    (nodes, abandoned)
}

/// Number of pending nodes.
pub(super) fn count_pending(open: &[PendingStroke]) -> usize {
    open.iter().map(|open| open.pending().len()).sum()
}

/// Removes the next node from the pending strokes. If the node before it has been wiped already,
/// the tool moves on in contact from there to the following node. If that has failed before, the
/// tool touches down again at the following node.
pub(super) fn abandon_next(
    open: &mut Vec<PendingStroke>,
    attempts: Vec<Attempt>,
) -> Option<AbandonedNode> {
    let first = &mut open[0];
    let is_turn = first.begun && first.copies(0) > 1;
    if first.begun && first.skipped || is_turn {
        first.touch_down_at_next();
        return None;
    }
    let at = usize::from(first.begun && first.nodes.len() > 1);
    let given_up = first.nodes[at];
    first.nodes.drain(at..at + first.copies(at));
    if let [before, after, ..] = &mut first.nodes[..]
        && at == 1
    {
        let [from, to] = [&before.corner.pose, &after.corner.pose];
        let towards = to.position - from.position;
        let wanted = towards.y.atan2(towards.x);
        let turn = wrap_angle(wanted - from.heading);
        before.corner.pose.heading += turn;
        first.skipped = true;
    }
    let is_done = match first.nodes.len() {
        0 => true,
        1 => first.begun,
        _ => false,
    };
    if is_done {
        open.remove(0);
    }
    Some(AbandonedNode {
        node: given_up.node,
        stroke: given_up.stroke,
        attempts,
    })
}
