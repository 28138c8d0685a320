//! One segment of a plan at a time: what is worth wiping next, before anybody looks; paper §4.3.

use super::variants::{plan_variants, worth};
use super::{Plan, PlanConfig, PlanError, SemanticDirectedGraph, Stroke, predict};
use crate::represent::{Action, GoalState, ParticleDistribution, Performance, Task};

/// Length of a segment of a tour, over the radius r_s of the collision sphere: about three widths of the
/// tool, as far as a wipe reaches before one looks.
const TOUR_SEGMENT: f64 = 6.0;

/// The plan with nothing but that one of its segments which is predicted to gain most; without any stroke,
/// if none is predicted to gain anything.
///
/// A segment is what makes sense by itself: of a tree, the way from any node on to the goal, for half of it
/// would bring nothing to where it belongs; of a tour, a piece of three tool widths. What counts is the
/// predicted number of particles that reach the goal, less those that leave the surface over a wrong edge;
/// among equals the shorter way.
pub fn best_segment(task: &Task, plan: &Plan) -> Plan {
    let found = best_of(task, std::slice::from_ref(plan));
    found.map_or_else(|| with_strokes(plan, Vec::new()), |found| found.plan)
}

/// The best segment ([`best_segment`]) of `count` plans, the variants of [`best_plan`](super::best_plan).
///
/// # Errors
/// Those of [`plan`](super::plan()), if no variant gives a plan.
pub fn best_segment_of_variants(
    task: &Task,
    to_plan_on: &ParticleDistribution,
    config: &PlanConfig,
    count: usize,
) -> Result<Plan, PlanError> {
    let plans = plan_variants(task, to_plan_on, config, count)?;
    let found = best_of(task, &plans);
    Ok(found.map_or_else(|| with_strokes(&plans[0], Vec::new()), |found| found.plan))
}

/// A segment as a plan, and what is said for it.
struct Found {
    plan: Plan,
    worth: i64,
    length: f64,
}

fn best_of(task: &Task, plans: &[Plan]) -> Option<Found> {
    let mut best: Option<Found> = None;
    for plan in plans {
        let now = worth(&Performance::of(
            &task.particles,
            &plan.graph.goal,
            &task.surface,
        ));
        for stroke in segments(plan, task) {
            let length = stroke.length();
            let segment = with_strokes(plan, vec![stroke]);
            let worth = worth(&predict(task, &segment, |_| ()).performance);
            let is_better = best.as_ref().is_none_or(|best| {
                worth > best.worth || worth == best.worth && length < best.length
            });
            if worth > now && is_better {
                best = Some(Found {
                    plan: segment,
                    worth,
                    length,
                });
            }
        }
    }
    best
}

fn segments(plan: &Plan, task: &Task) -> Vec<Stroke> {
    let symmetric = task.action == Action::Absorb && task.tool.is_half_turn_symmetric();
    let graph = &plan.graph;
    let chains: Vec<Vec<usize>> = match graph.goal {
        GoalState::Collected { .. } | GoalState::Skimmed => (0..graph.nodes.len())
            .map(|node| way_to_goal(graph, node))
            .filter(|chain| chain.len() > 1)
            .collect(),
        GoalState::Absorbed => {
            let longest = TOUR_SEGMENT * plan.collision_radius;
            let strokes = plan.strokes.iter();
            strokes
                .flat_map(|stroke| pieces(graph, &stroke.nodes, longest))
                .collect()
        }
    };
    let along = |chain| Stroke::along(graph, chain, symmetric);
    chains.into_iter().map(along).collect()
}

/// From a node along the tree's edges to its root.
fn way_to_goal(graph: &SemanticDirectedGraph, node: usize) -> Vec<usize> {
    std::iter::successors(Some(node), |&at| graph.successor(at)).collect()
}

/// For every node of a chain the piece that begins there and is as long as is allowed; pieces that only end
/// what another piece wipes as well are left out.
fn pieces(graph: &SemanticDirectedGraph, chain: &[usize], longest: f64) -> Vec<Vec<usize>> {
    let mut pieces = Vec::new();
    for first in 0..chain.len() {
        let mut length = 0.0;
        let mut last = first;
        while let Some(&next) = chain.get(last + 1) {
            let edge = graph.position(next) - graph.position(chain[last]);
            length += edge.norm();
            // An edge longer than that is a piece of its own.
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
        // An edge that is too long is not left out for that.
        assert_eq!(pieces(&graph, &[3, 4], 0.1), [vec![3, 4]]);
        assert_eq!(pieces(&graph, &[2], 0.1), [vec![2]]);
    }

    #[test]
    fn a_way_ends_at_the_root() {
        let graph = chain(&[0.25, 0.25]);
        assert_eq!(way_to_goal(&graph, 0), [0, 1, 2]);
        assert_eq!(way_to_goal(&graph, 2), [2]);
    }
}
