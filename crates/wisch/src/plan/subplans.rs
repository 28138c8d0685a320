//! Subplans: the best single stroke to execute before the next observation; paper §4.3.

use super::bend::check_bend;
use super::objective::{objective, objective_at_rest};
use super::yaw::YawPattern;
use super::{FreeSpace, Plan, PlanError, SemanticDirectedGraph, Stroke, predict};
use crate::represent::{GoalState, Task};

/// Length of a subplan of a tour, over the radius r_s of the collision sphere: about three widths of the tool,
/// as long as a wipe between two observations.
const TOUR_SUBPLAN: f64 = 6.0;
/// A subplan must gain at least one particle of this many.
const GAIN: usize = 250;
/// Largest number of tree nodes at which subplans begin; of more nodes, an evenly spread subset is used.
const MAX_BEGINNINGS: usize = 500;
/// Largest number of subplans in a plan that consists of subplans.
const MAX_SUBPLANS: usize = 24;

/// Returns a plan of subplans. Each is the best for the dirt that the subplans before it are predicted to
/// leave.
///
/// Straight paths do not turn the tool; near an edge, a turn would push dirt beside the tool over that edge.
pub(super) fn compose_subplans(task: &Task, plan: &Plan, space: &FreeSpace) -> Plan {
    let candidates = subplans(plan, task, space);
    let mut state = task.clone();
    let mut strokes = Vec::new();
    while strokes.len() < MAX_SUBPLANS {
        let Some(found) = best_among(&state, plan, &candidates) else {
            break;
        };
        let one = with_strokes(plan, vec![found.stroke]);
        state.particles = predict(&state, &one, |_| ()).particles;
        strokes.extend(one.strokes);
    }
    with_edges_of(plan, strokes)
}

/// The free space of a task.
pub(super) fn free_space_of(task: &Task) -> Result<FreeSpace, PlanError> {
    check_bend(task)?;
    let scene: Vec<_> = task.obstacles_in_surface().collect();
    FreeSpace::new(&task.surface, &scene, task.tool.collision_radius())
}

/// A subplan with its gain over doing nothing for as long [particles], and its length.
struct ScoredSubplan {
    stroke: Stroke,
    gain: i64,
    length: f64,
}

impl ScoredSubplan {
    fn is_better_than(&self, other: &Self) -> bool {
        self.gain > other.gain || self.gain == other.gain && self.length < other.length
    }
}

/// Returns the best subplan of several plans; if no subplan gains anything, the first plan without
/// strokes.
pub(super) fn best_of(task: &Task, plans: &[Plan], space: &FreeSpace) -> Plan {
    let mut best: Option<(ScoredSubplan, &Plan)> = None;
    for plan in plans {
        let found = best_among(task, plan, &subplans(plan, task, space));
        if let Some(found) = found
            && (best.as_ref()).is_none_or(|(best, _)| found.is_better_than(best))
        {
            best = Some((found, plan));
        }
    }
    match best {
        Some((found, plan)) => with_edges_of(plan, vec![found.stroke]),
        None => with_strokes(&plans[0], Vec::new()),
    }
}

/// Returns the best of some strokes, if it gains enough.
fn best_among(task: &Task, plan: &Plan, strokes: &[Stroke]) -> Option<ScoredSubplan> {
    let least = (task.particles.len() / GAIN).max(1) as i64;
    let mut one = with_strokes(plan, Vec::new());
    let now = objective_at_rest(task, &one);
    let mut best: Option<ScoredSubplan> = None;
    for stroke in strokes {
        one.strokes = vec![stroke.clone()];
        let at_rest = if task.has_running_film() {
            objective_at_rest(task, &one)
        } else {
            now
        };
        let found = ScoredSubplan {
            gain: objective(task, &one) - at_rest,
            length: stroke.length(),
            stroke: stroke.clone(),
        };
        let is_better = best.as_ref().is_none_or(|best| found.is_better_than(best));
        if found.gain >= least && is_better {
            best = Some(found);
        }
    }
    best
}

/// Returns all candidate subplans of a plan.
fn subplans(plan: &Plan, task: &Task, space: &FreeSpace) -> Vec<Stroke> {
    let graph = &plan.graph;
    let chains: Vec<Vec<usize>> = match graph.goal {
        GoalState::Collected { .. } | GoalState::Skimmed => {
            let successors = graph.successors();
            let spacing = graph.nodes.len().div_ceil(MAX_BEGINNINGS).max(1);
            (0..graph.nodes.len())
                .step_by(spacing)
                .flat_map(|node| {
                    let way = path_to_goal(&successors, node);
                    let straight = straight_path(graph, &way, space);
                    std::iter::once(way).chain(straight)
                })
                .filter(|chain| chain.len() > 1)
                .collect()
        }
        GoalState::Polished { .. } | GoalState::Dispensed { .. } => return plan.strokes.clone(),
        GoalState::Absorbed => {
            let longest = TOUR_SUBPLAN * plan.collision_radius;
            let strokes = plan.strokes.iter();
            strokes
                .flat_map(|stroke| pieces(graph, &stroke.nodes, longest))
                .collect()
        }
    };
    YawPattern::Blended.strokes(task, graph, &chains)
}

/// Returns the nodes from a node along the tree's edges to its root.
fn path_to_goal(successors: &[Option<usize>], node: usize) -> Vec<usize> {
    std::iter::successors(Some(node), |&at| successors[at]).collect()
}

/// Returns the straight path from the first to the last node, if it differs from the path along the tree and is
/// free.
fn straight_path(
    graph: &SemanticDirectedGraph,
    way: &[usize],
    space: &FreeSpace,
) -> Option<Vec<usize>> {
    let (&first, &last) = (way.first()?, way.last()?);
    let is_clear = || space.is_clear_between(graph.position(first), graph.position(last));
    (way.len() > 2 && is_clear()).then(|| vec![first, last])
}

/// Returns for every node of a chain the longest allowed piece that begins there. Pieces at the end that
/// another piece contains are left out.
fn pieces(graph: &SemanticDirectedGraph, chain: &[usize], longest: f64) -> Vec<Vec<usize>> {
    let mut pieces = Vec::new();
    for first in 0..chain.len() {
        let mut length = 0.0;
        let mut last = first;
        while let Some(&next) = chain.get(last + 1) {
            let edge = graph.position(next) - graph.position(chain[last]);
            length += edge.norm();
            // An edge longer than the limit is a piece of its own.
            if length > longest && last > first {
                break;
            }
            last += 1;
        }
        pieces.push(chain[first..=last].to_vec());
        if last + 1 == chain.len() {
            break;
        }
    }
    pieces
}

/// Returns the plan with these strokes; their edges replace the tree's edges from the same nodes.
fn with_edges_of(plan: &Plan, strokes: Vec<Stroke>) -> Plan {
    let mut plan = with_strokes(plan, strokes);
    let legs = plan.strokes.iter().flat_map(|stroke| {
        let pairs = stroke.nodes.windows(2);
        pairs.map(|pair| (pair[0], pair[1]))
    });
    let mut edges: Vec<(usize, usize)> = legs.collect();
    edges.sort_unstable();
    edges.dedup();
    let longest = edges
        .iter()
        .map(|&(from, to)| (plan.graph.position(to) - plan.graph.position(from)).norm())
        .fold(0.0, f64::max);
    let others = plan.graph.edges.iter();
    let others = others.filter(|(from, _)| !edges.iter().any(|(wiped, _)| wiped == from));
    edges.extend(others.copied().collect::<Vec<_>>());
    edges.sort_unstable();
    plan.graph.max_edge_length = plan.graph.max_edge_length.map(|limit| limit.max(longest));
    plan.graph.edges = edges;
    plan
}

fn with_strokes(plan: &Plan, strokes: Vec<Stroke>) -> Plan {
    Plan {
        strokes,
        ..plan.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Node, NodeRole};
    use super::*;
    use crate::geometry::Point2;

    fn chain(edges: &[f64]) -> SemanticDirectedGraph {
        let mut x = 0.0;
        let places = std::iter::once(0.0).chain(edges.iter().map(|edge| {
            x += edge;
            x
        }));
        SemanticDirectedGraph {
            nodes: places
                .map(|x| Node {
                    position: Point2::new(x, 0.0),
                    role: NodeRole::Coverage,
                })
                .collect(),
            edges: (0..edges.len()).map(|i| (i, i + 1)).collect(),
            goal: GoalState::Absorbed,
            max_edge_length: None,
            unreachable: Vec::new(),
        }
    }

    #[test]
    fn a_tour_falls_into_pieces_no_longer_than_allowed() {
        let graph = chain(&[0.25, 0.25, 0.25, 0.5]);
        let all = [0, 1, 2, 3, 4];
        assert_eq!(
            pieces(&graph, &all, 0.5),
            [vec![0, 1, 2], vec![1, 2, 3], vec![2, 3], vec![3, 4]]
        );
        assert_eq!(pieces(&graph, &all, 9.0), [all.to_vec()]);
        // An edge longer than the limit is kept.
        assert_eq!(pieces(&graph, &[3, 4], 0.1), [vec![3, 4]]);
        assert_eq!(pieces(&graph, &[2], 0.1), [vec![2]]);
    }

    #[test]
    fn a_way_ends_at_the_root() {
        let graph = chain(&[0.25, 0.25]);
        assert_eq!(path_to_goal(&graph.successors(), 0), [0, 1, 2]);
        assert_eq!(path_to_goal(&graph.successors(), 2), [2]);
    }
}
