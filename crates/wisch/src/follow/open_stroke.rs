//! What of a plan is still to be wiped.

use super::path::stroke_run::Corner;
use super::{AbandonedNode, Attempt};
use crate::geometry::wrap_angle;
use crate::plan::Stroke;

/// A node still to be passed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Waiting {
    pub node: usize,
    pub corner: Corner,
    /// The number of its stroke in the plan.
    pub stroke: usize,
}

/// What is left of a planned stroke, or one of what was joined anew.
#[derive(Debug, Clone)]
pub(super) struct Open {
    /// Its nodes from the next on; the first is where the tool has to be put down.
    pub nodes: Vec<Waiting>,
    /// Whether the first of them has been wiped already.
    pub begun: bool,
    /// Whether the node after it has been given up.
    pub skipped: bool,
}

impl Open {
    /// A whole stroke; `stroke_of` says of a node in which of the plan it is.
    pub fn of(stroke: &Stroke, stroke_of: impl Fn(usize) -> usize) -> Self {
        let nodes = stroke.nodes.iter().zip(&stroke.poses);
        Self::through(nodes.map(|(&node, &pose)| Waiting {
            node,
            corner: Corner { pose, near: None },
            stroke: stroke_of(node),
        }))
    }

    /// A stroke through these nodes, not begun.
    pub fn through(nodes: impl Iterator<Item = Waiting>) -> Self {
        Self {
            nodes: nodes.collect(),
            begun: false,
            skipped: false,
        }
    }

    /// Whether a node is in it.
    pub fn has(&self, node: usize) -> bool {
        self.nodes.iter().any(|waiting| waiting.node == node)
    }

    /// The nodes that are still to be passed.
    pub fn unpassed(&self) -> &[Waiting] {
        let passed = if self.begun { self.copies(0) } else { 0 };
        &self.nodes[passed..]
    }

    /// How often in a row the node there is in it: twice where the tool is turned on it.
    pub fn copies(&self, at: usize) -> usize {
        let [first, ..] = &self.nodes[at..] else {
            return 0;
        };
        let same = |waiting: &&Waiting| waiting.node == first.node;
        self.nodes[at..].iter().take_while(same).count()
    }

    /// Leaves the wiped node that it has come to: the tool is put down at the next.
    pub fn put_down_anew(&mut self) {
        self.nodes.remove(0);
        self.begun = false;
        self.skipped = false;
    }

    /// The stroke through its nodes.
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

/// The nodes on which the tool can be put down, and the others with what was tried.
pub(super) fn apart(
    left: &[Waiting],
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

/// How many nodes are still to be passed.
pub(super) fn waiting(open: &[Open]) -> usize {
    open.iter().map(|open| open.unpassed().len()).sum()
}

/// Takes the next node off what is open. The node before it, if wiped already, heads for the one after; if
/// that has failed before, the tool is put down anew at the one after.
pub(super) fn give_up(open: &mut Vec<Open>, attempts: Vec<Attempt>) -> Option<AbandonedNode> {
    let first = &mut open[0];
    let is_turn = first.begun && first.copies(0) > 1;
    if first.begun && first.skipped || is_turn {
        first.put_down_anew();
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
