//! How the tool turns while it moves through nodes.

use super::{SemanticDirectedGraph, Stroke};
use crate::geometry::{PlanarPose, wrap_angle};
use crate::represent::{Action, Task};
use std::f64::consts::{PI, TAU};

/// Largest range of headings within a stroke [rad]; the range of a common wrist joint is somewhat larger.
const WINDING: f64 = 5.0;
/// Number of constant headings that are tried, evenly around the circle.
const CONSTANT_HEADINGS: usize = 24;

/// How a coverage strategy turns the tool along its strokes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum YawRule {
    /// The tool points from each node to the next, and turns evenly along the edges; paper §3.3.
    Blended,
    /// The broad side stays across the motion along whole edges; the tool turns on the spot at nodes.
    AlongEdges,
    /// One heading for all strokes: of several tried headings, the one with the best predicted
    /// effect.
    Constant,
    /// The rule with the best predicted effect. Constant headings are tried only if the tool
    /// absorbs the dirt, because pushed dirt must stay in front of the tool.
    #[default]
    Best,
}

impl YawRule {
    /// Returns the headings among which the predicted effect chooses, those that turn the tool least first.
    pub(super) fn choices(self, task: &Task) -> Vec<YawPattern> {
        let around = if is_symmetric(task) { PI } else { TAU };
        let constant = (0..CONSTANT_HEADINGS)
            .map(|i| YawPattern::Constant(around * i as f64 / CONSTANT_HEADINGS as f64));
        match self {
            Self::Blended => vec![YawPattern::Blended],
            Self::AlongEdges => vec![YawPattern::AlongEdges],
            Self::Constant => constant.collect(),
            Self::Best if task.action == Action::Absorb => constant
                .chain([YawPattern::Blended, YawPattern::AlongEdges])
                .collect(),
            Self::Best => vec![YawPattern::Blended, YawPattern::AlongEdges],
        }
    }
}

/// How the tool turns along the strokes of one candidate plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum YawPattern {
    Blended,
    AlongEdges,
    /// [rad]
    Constant(f64),
}

impl YawPattern {
    /// Returns the strokes through chains of nodes.
    pub(super) fn strokes(
        self,
        task: &Task,
        graph: &SemanticDirectedGraph,
        chains: &[Vec<usize>],
    ) -> Vec<Stroke> {
        let symmetric = is_symmetric(task);
        let strokes = chains.iter().flat_map(|chain| {
            let planned = self.along(graph, chain, symmetric);
            split_by_winding(planned)
        });
        strokes.collect()
    }

    fn along(self, graph: &SemanticDirectedGraph, chain: &[usize], symmetric: bool) -> Stroke {
        let mut nodes = chain.to_vec();
        nodes.dedup();
        let headings = match self {
            Self::Constant(heading) => vec![heading; nodes.len().max(2) - 1],
            Self::Blended | Self::AlongEdges => edge_headings(graph, &nodes, symmetric),
        };
        let mut stroke = Stroke {
            nodes: Vec::with_capacity(nodes.len()),
            poses: Vec::with_capacity(nodes.len()),
        };
        for (i, &node) in nodes.iter().enumerate() {
            let before = i.checked_sub(1).map(|edge| headings[edge]);
            let after = headings.get(i).copied().or(before).unwrap_or(0.0);
            let arriving = before.filter(|&before| self == Self::AlongEdges && before != after);
            for heading in arriving.into_iter().chain([after]) {
                stroke.nodes.push(node);
                stroke
                    .poses
                    .push(PlanarPose::new(graph.position(node), heading));
            }
        }
        stroke
    }
}

/// Returns the heading of every edge between nodes, continuous (not wrapped) [rad]. A tool that is the same
/// after half a turn (`symmetric`) takes the nearer of the two headings, unless that exceeds the range of a
/// stroke.
fn edge_headings(graph: &SemanticDirectedGraph, nodes: &[usize], symmetric: bool) -> Vec<f64> {
    let period = if symmetric { PI } else { TAU };
    let mut headings: Vec<f64> = Vec::with_capacity(nodes.len());
    let mut range = Range::default();
    for pair in nodes.windows(2) {
        let way = graph.position(pair[1]) - graph.position(pair[0]);
        let way = libm::atan2(way.y, way.x);
        let heading = match headings.last() {
            None => way,
            Some(&last) => {
                let turn = wrap_angle((way - last) * TAU / period) * period / TAU;
                let is_wound = symmetric && !range.with(last + turn).is_reached();
                last + turn - if is_wound { period.copysign(turn) } else { 0.0 }
            }
        };
        range = range.with(heading);
        headings.push(heading);
    }
    headings
}

/// Splits a stroke where its headings exceed the range [`WINDING`]: between the parts the tool is lifted and
/// turned back.
fn split_by_winding(stroke: Stroke) -> Vec<Stroke> {
    let mut strokes = Vec::new();
    let mut begin = 0;
    let mut range = Range::default();
    for (i, pose) in stroke.poses.iter().enumerate() {
        let with = range.with(pose.heading);
        range = if with.is_reached() {
            with
        } else {
            strokes.push(part(&stroke, begin..i));
            // Between two nodes the next part starts again at the first, with the heading that the tool has
            // after turning there.
            begin = if stroke.nodes[i - 1] == stroke.nodes[i] {
                i
            } else {
                i - 1
            };
            Range::default()
                .with(stroke.poses[begin].heading)
                .with(pose.heading)
        };
    }
    strokes.push(part(&stroke, begin..stroke.poses.len()));
    strokes
}

fn part(stroke: &Stroke, of: std::ops::Range<usize>) -> Stroke {
    Stroke {
        nodes: stroke.nodes[of.clone()].to_vec(),
        poses: stroke.poses[of].to_vec(),
    }
}

/// Range of the headings that a tool has had [rad].
#[derive(Clone, Copy, Default)]
struct Range(Option<[f64; 2]>);

impl Range {
    fn with(self, heading: f64) -> Self {
        let [least, most] = self.0.unwrap_or([heading; 2]);
        Self(Some([least.min(heading), most.max(heading)]))
    }

    /// Whether a wrist can turn through this range.
    fn is_reached(self) -> bool {
        self.0.is_none_or(|[least, most]| most - least <= WINDING)
    }
}

/// Whether half a turn of the tool changes nothing about its effect.
fn is_symmetric(task: &Task) -> bool {
    task.action == Action::Absorb && task.tool.is_half_turn_symmetric()
}

#[cfg(test)]
mod tests {
    use super::super::{Node, NodeRole};
    use super::*;
    use crate::geometry::Point2;
    use crate::represent::GoalState;

    fn graph(places: &[[f64; 2]]) -> SemanticDirectedGraph {
        let nodes = places.iter().map(|&[x, y]| Node {
            position: Point2::new(x, y),
            role: NodeRole::Coverage,
        });
        SemanticDirectedGraph {
            nodes: nodes.collect(),
            edges: Vec::new(),
            goal: GoalState::Absorbed,
            max_edge_length: None,
            unreachable: Vec::new(),
        }
    }

    /// A spiral of square turns to the left.
    fn spiral(edges: usize) -> SemanticDirectedGraph {
        let (mut x, mut y) = (0.0, 0.0);
        let mut places = vec![[x, y]];
        for i in 0..edges {
            let length = 0.1 * (edges - i) as f64;
            let (dx, dy) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][i % 4];
            (x, y) = (x + dx * length, y + dy * length);
            places.push([x, y]);
        }
        graph(&places)
    }

    fn turned(stroke: &Stroke) -> f64 {
        let headings = stroke.poses.iter().map(|pose| pose.heading);
        headings.clone().fold(f64::MIN, f64::max) - headings.fold(f64::MAX, f64::min)
    }

    #[test]
    fn along_edges_the_broad_side_stays_across_the_motion() {
        let graph = graph(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
        let stroke = YawPattern::AlongEdges.along(&graph, &[0, 1, 2], false);
        assert_eq!(stroke.nodes, [0, 1, 1, 2]);
        let moved = stroke.motions().filter(|motion| motion.travel().1 > 0.0);
        for motion in moved {
            let way = motion.to.position - motion.from.position;
            assert_eq!(motion.from.heading, libm::atan2(way.y, way.x));
            assert_eq!(motion.to.heading, motion.from.heading);
        }
        let blended = YawPattern::Blended.along(&graph, &[0, 1, 2], false);
        assert_eq!(blended.nodes, [0, 1, 2]);
        let headings: Vec<f64> = blended.poses.iter().map(|pose| pose.heading).collect();
        assert_eq!(headings, [0.0, PI / 2.0, PI / 2.0]);
    }

    #[test]
    fn no_stroke_winds_the_tool_up() {
        let graph = spiral(12);
        let chain: Vec<usize> = (0..=12).collect();
        for headings in [YawPattern::Blended, YawPattern::AlongEdges] {
            for symmetric in [false, true] {
                let whole = headings.along(&graph, &chain, symmetric);
                let parts = split_by_winding(whole.clone());
                assert!(parts.iter().all(|part| turned(part) <= WINDING));
                // A tool that is symmetric under half a turn need not be lifted.
                assert_eq!(parts.len() > 1, !symmetric, "{headings:?}");
                let length: f64 = parts.iter().map(Stroke::length).sum();
                assert!((length - whole.length()).abs() < 1e-12);
            }
        }
        let constant = YawPattern::Constant(0.3).along(&graph, &chain, false);
        assert_eq!(turned(&constant), 0.0);
    }

    #[test]
    fn a_node_alone_is_touched() {
        let graph = graph(&[[0.2, 0.1]]);
        for headings in [
            YawPattern::Blended,
            YawPattern::AlongEdges,
            YawPattern::Constant(0.0),
        ] {
            assert_eq!(headings.along(&graph, &[0], false).poses.len(), 1);
        }
    }
}
