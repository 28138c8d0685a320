//! The drive of the base between its poses: A* over position and heading around obstacles, straightened; paper
//! §3.3.

use crate::follow::{FollowConfig, Workcell};
use crate::geometry::{PlanarPose, wrap_angle};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::collections::hash_map::{Entry, HashMap};
use std::f64::consts::TAU;

/// Pitch of the grid [m].
const PITCH: f64 = 0.1;
/// Number of headings of the grid.
const HEADINGS: i32 = 24;
/// Number of cells around start and goal in which the path may lie [cells].
const SWERVE: i32 = 30;
/// Cost of rotation, as a driving distance [m/rad]. The base drives at 0.5 m/s and turns at 0.5 rad/s.
const TURN_COST: f64 = 1.0;
/// Costs are whole micrometres, so that comparisons are exact.
const COST_UNIT: f64 = 1e-6;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Node {
    Start,
    /// Cells and headings relative to the goal.
    Cell([i32; 3]),
}

/// Returns poses of the base from one pose to another, both included; `None` if there is no free path. The arm
/// stays in the ready posture.
pub(in crate::follow) fn drive(
    cell: &Workcell,
    from: &PlanarPose,
    to: &PlanarPose,
    config: &FollowConfig,
) -> Option<Vec<PlanarPose>> {
    let to = PlanarPose::new(
        to.position,
        from.heading + wrap_angle(to.heading - from.heading),
    );
    let is_free = |a: &PlanarPose, b: &PlanarPose| {
        let (a, b) = (
            cell.standing(cell.ready_posture(), a),
            cell.standing(cell.ready_posture(), b),
        );
        let contact = cell
            .base_collisions()
            .segment_contact(&a, &b, config.margin);
        matches!(contact, Ok(None))
    };
    if is_free(from, &to) {
        return Some(vec![*from, to]);
    }
    let turn = TAU / f64::from(HEADINGS);
    let away = (from.position - to.position) / PITCH;
    let reach = [away.x, away.y].map(|cells| cells.abs().ceil() as i32 + SWERVE);
    let pose = |node: Node| match node {
        Node::Start => *from,
        Node::Cell([i, j, k]) => PlanarPose::new(
            to.position + PITCH * nalgebra::Vector2::new(f64::from(i), f64::from(j)),
            to.heading + f64::from(k) * turn,
        ),
    };
    let cost = |a: &PlanarPose, b: &PlanarPose| {
        let way = (b.position - a.position).norm() + TURN_COST * (b.heading - a.heading).abs();
        (way / COST_UNIT).round() as u64
    };
    let near_start = || {
        let k = (from.heading - to.heading) / turn;
        let around = |value: f64| [value.floor() as i32, value.floor() as i32 + 1];
        let mut cells = Vec::with_capacity(8);
        for i in around(away.x) {
            for j in around(away.y) {
                cells.extend(around(k).map(|k| [i, j, k]));
            }
        }
        cells
    };
    let successors = |&node: &Node| {
        let cells = match node {
            Node::Start => near_start(),
            Node::Cell([i, j, k]) => {
                let mut cells = vec![[i, j, k - 1], [i, j, k + 1]];
                for di in -1..=1 {
                    for dj in -1..=1 {
                        if (di, dj) != (0, 0) {
                            cells.push([i + di, j + dj, k]);
                        }
                    }
                }
                cells
            }
        };
        let here = pose(node);
        cells
            .into_iter()
            .filter(|[i, j, k]| i.abs() <= reach[0] && j.abs() <= reach[1] && k.abs() <= HEADINGS)
            .map(Node::Cell)
            .filter(|&next| is_free(&here, &pose(next)))
            .map(|next| (next, cost(&here, &pose(next))))
            .collect::<Vec<_>>()
    };
    let estimate = |&node: &Node| cost(&pose(node), &to);
    let goal = Node::Cell([0, 0, 0]);
    let nodes = cheapest_path(Node::Start, goal, successors, estimate)?;
    let path: Vec<PlanarPose> = nodes.into_iter().map(pose).collect();
    Some(straighten(path, is_free))
}

/// Returns the cheapest path from one node to another, both included (Hart, Nilsson and Raphael, *A Formal
/// Basis for the Heuristic Determination of Minimum Cost Paths*, 1968). `estimate` must never exceed the cost
/// to the goal.
fn cheapest_path(
    start: Node,
    goal: Node,
    successors: impl Fn(&Node) -> Vec<(Node, u64)>,
    estimate: impl Fn(&Node) -> u64,
) -> Option<Vec<Node>> {
    let mut reached: HashMap<Node, (Option<Node>, u64)> = HashMap::from([(start, (None, 0))]);
    let mut open = BinaryHeap::from([OpenNode {
        key: (Reverse(0), 0),
        node: start,
    }]);
    while let Some(OpenNode { key, node }) = open.pop() {
        let (_, cost) = key;
        if node == goal {
            let parent = |node: &Node| reached[node].0;
            let mut path: Vec<Node> = std::iter::successors(Some(goal), parent).collect();
            path.reverse();
            return Some(path);
        }
        // A cheaper path to this node has been found since.
        if cost > reached[&node].1 {
            continue;
        }
        for (next, step) in successors(&node) {
            let cost = cost + step;
            match reached.entry(next) {
                Entry::Occupied(known) if known.get().1 <= cost => continue,
                Entry::Occupied(mut known) => _ = known.insert((Some(node), cost)),
                Entry::Vacant(new) => _ = new.insert((Some(node), cost)),
            }
            let key = (Reverse(cost + estimate(&next)), cost);
            open.push(OpenNode { key, node: next });
        }
    }
    None
}

/// A node of the open list: the least total cost first, of equal costs the node farthest from the start.
struct OpenNode {
    key: (Reverse<u64>, u64),
    node: Node,
}

impl Ord for OpenNode {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.key.cmp(&other.key)
    }
}

impl PartialOrd for OpenNode {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for OpenNode {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Eq for OpenNode {}

/// Removes every pose that is not needed for a free path.
fn straighten(
    path: Vec<PlanarPose>,
    is_free: impl Fn(&PlanarPose, &PlanarPose) -> bool,
) -> Vec<PlanarPose> {
    let mut kept = vec![path[0]];
    let mut at = 0;
    while at + 1 < path.len() {
        let next = (at + 1..path.len())
            .rev()
            .find(|&k| k == at + 1 || is_free(&path[at], &path[k]))
            .unwrap_or(at + 1);
        kept.push(path[next]);
        at = next;
    }
    kept
}
