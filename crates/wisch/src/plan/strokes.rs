//! Strokes, the tool's motions from touching down to lifting off, and the plan that they form.

use super::{Node, NodeRole, SemanticDirectedGraph, Strategy};
use crate::geometry::{PlanarPose, Point2};
use crate::represent::ToolMotion;

/// One motion in contact through a chain of nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// The nodes of the stroke in order; a node at which the tool turns on the spot stands here twice.
    pub nodes: Vec<usize>,
    /// Pose of the tool in the surface frame at each of these nodes. Headings are continuous (not
    /// wrapped), and change linearly along the edges between.
    pub poses: Vec<PlanarPose>,
}

/// One corner of the tool centre point's path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TcpWaypoint {
    /// Pose in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Height above the surface \[m\]; 0 in contact.
    pub height: f64,
}

impl Stroke {
    /// The motions in contact, edge by edge. A stroke of a single node is a touch without motion.
    pub fn motions(&self) -> impl Iterator<Item = ToolMotion> + '_ {
        let touch = (self.poses.len() == 1).then(|| ToolMotion {
            from: self.poses[0],
            to: self.poses[0],
        });
        self.poses
            .windows(2)
            .map(|pair| ToolMotion {
                from: pair[0],
                to: pair[1],
            })
            .chain(touch)
    }

    /// Length of the tool centre point's path in this stroke, all of it in contact \[m\].
    pub fn length(&self) -> f64 {
        self.motions().map(|motion| motion.travel().1).sum()
    }
}

/// Planned strokes and the graph that they come from.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The strategy that found the strokes.
    pub strategy: Strategy,
    /// Nodes and directed edges.
    pub graph: SemanticDirectedGraph,
    /// Strokes in the order of execution.
    pub strokes: Vec<Stroke>,
    /// Radius r_s of the collision sphere \[m\].
    pub collision_radius: f64,
    /// Share of the planned particles that the tool covers at no allowed pose, see
    /// [`FreeSpace::unreachable_share`](super::FreeSpace::unreachable_share) \[1\].
    pub unreachable_share: f64,
    /// Start of the tool, in the surface frame \[m\].
    pub tool_start: Point2,
    /// Height by which the tool is lifted between strokes \[m\].
    pub lift_height: f64,
}

impl Plan {
    /// Length of the tool centre point's path over all strokes, without lifted moves \[m\]; the distance of Table
    /// 1.
    pub fn contact_distance(&self) -> f64 {
        // An empty sum of f64 is -0.0.
        self.strokes
            .iter()
            .map(Stroke::length)
            .fold(0.0, |sum, length| sum + length)
    }

    /// Returns the plan up to a distance in contact \[m\]; the stroke in progress ends there.
    #[must_use]
    pub fn truncate(&self, distance: f64) -> Self {
        let mut cut = self.clone();
        cut.strokes.clear();
        let mut left = distance;
        for stroke in &self.strokes {
            if left <= 0.0 {
                break;
            }
            let mut kept = Stroke {
                nodes: stroke.nodes.first().copied().into_iter().collect(),
                poses: stroke.poses.first().copied().into_iter().collect(),
            };
            for (motion, &node) in stroke.motions().zip(stroke.nodes.iter().skip(1)) {
                let length = motion.travel().1;
                if length <= left {
                    kept.nodes.push(node);
                    kept.poses.push(motion.to);
                    left -= length;
                    continue;
                }
                let share = left / length;
                let way = motion.to.position - motion.from.position;
                let heading = motion.from.heading + motion.turn() * share;
                let end = PlanarPose::new(motion.from.position + way * share, heading);
                if let Some(&last) = kept.nodes.last() {
                    cut.graph.edges.push((last, cut.graph.nodes.len()));
                }
                kept.nodes.push(cut.graph.nodes.len());
                kept.poses.push(end);
                cut.graph.nodes.push(Node {
                    position: end.position,
                    role: NodeRole::Coverage,
                });
                left = 0.0;
                break;
            }
            cut.strokes.push(kept);
        }
        cut
    }

    /// Total distance, lifted moves included \[m\].
    pub fn total_distance(&self) -> f64 {
        self.tcp_path()
            .windows(2)
            .map(|leg| {
                let flat =
                    (leg[1].surface_from_tool.position - leg[0].surface_from_tool.position).norm();
                flat.hypot(leg[1].height - leg[0].height)
            })
            .fold(0.0, |sum, length| sum + length)
    }

    /// The corners of the tool centre point's whole path: approach, strokes, lifts and retreat.
    pub fn tcp_path(&self) -> Vec<TcpWaypoint> {
        let mut path = Vec::new();
        for stroke in &self.strokes {
            let (Some(first), Some(last)) = (stroke.poses.first(), stroke.poses.last()) else {
                continue;
            };
            let lifted = |pose| TcpWaypoint {
                surface_from_tool: pose,
                height: self.lift_height,
            };
            if path.is_empty() {
                let mut start = *first;
                start.position = self.tool_start;
                path.push(lifted(start));
            }
            path.push(lifted(*first));
            path.extend(stroke.poses.iter().map(|&pose| TcpWaypoint {
                surface_from_tool: pose,
                height: 0.0,
            }));
            path.push(lifted(*last));
        }
        path
    }
}
