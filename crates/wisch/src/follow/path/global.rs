//! The global method: a deterministic search over the discretised null space along an edge, after
//! Huaman and Stilman (2012); paper §3.3.
//!
//! The edge is cut into layers. Each layer has configurations for all orientations of the tool, from several
//! starts. Two configurations of consecutive layers are connected if the tool can follow its line while the
//! joints move from one to the other. The search is depth first, nearest configuration first. It never enters a
//! failed configuration again, so it ends, and it is complete within the discretisation.

use super::arm::{Arm, between, widest_step};
use super::tool_redundancy::{ToolOrientation, deviation, turn_along_edge};
use crate::follow::{AllowedContact, ToolPose};
use crate::geometry::PlanarPose;
use crate::robot::JointPositions;

/// Distance between layers [m].
const LAYER: f64 = 0.03;
/// Rotation between layers of an edge on which the tool only turns [rad].
const LAYER_TURN: f64 = 0.2;
/// Starts of the inverse kinematics for each pose, the current configuration among them.
const STARTS: u64 = 4;
/// Largest number of orientations in a layer.
const MAX_ORIENTATIONS: usize = 18;
/// Largest movement of a joint from one layer to the next [rad or m].
const MAX_CHANGE: f64 = 0.8;
/// Configurations nearer than this count as the same [rad or m].
const SAME: f64 = 0.05;

/// Part of a stroke, from one node to the next.
#[derive(Debug, Clone)]
pub(in crate::follow) struct Leg {
    /// Configurations after the start, the last at the node.
    pub configurations: Vec<JointPositions>,
    /// Corners of the tool's line after the start, the last at the node.
    pub line: Vec<ToolPose>,
    /// Rotation of the tool away from the plan at the node, and the additional rotation on the way [rad].
    pub turned: f64,
}

struct State {
    pose: ToolPose,
    q: JointPositions,
    failed: bool,
}

/// Searches for a path in contact to the node at `goal`, in any of these orientations of the tool.
pub(in crate::follow) fn search(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    planned: [&PlanarPose; 2],
    orientations: &[ToolOrientation],
) -> Option<Leg> {
    let straight = turn_along_edge(planned, orientations.first()?, from);
    let way = from.distance(&straight) / LAYER;
    let turn = (straight.surface_from_tool.heading - from.surface_from_tool.heading).abs();
    let count = (way.max(turn / LAYER_TURN).ceil() as usize).max(1);
    // The far end first: most edges that cannot be followed end out of reach.
    let mut layers: Vec<Vec<State>> = Vec::with_capacity(count);
    for i in (1..=count).rev() {
        let layer = states(
            arm,
            start,
            from,
            planned,
            i as f64 / count as f64,
            orientations,
        );
        if layer.is_empty() {
            return None;
        }
        layers.push(layer);
    }
    layers.reverse();
    let mut legs: Vec<(Vec<JointPositions>, ToolPose)> = Vec::new();
    let found = descend(arm, start, from, &mut layers, 0, &mut legs);
    let symmetric = arm.task.tool.is_half_turn_symmetric();
    let (_, end) = legs.last().filter(|_| found)?;
    let against_plan = ToolOrientation {
        rotation: end.surface_from_tool.heading - planned[1].heading,
        tilt: end.tilt,
    };
    Some(Leg {
        turned: deviation(&against_plan, planned[0], from, symmetric),
        line: legs.iter().map(|(_, pose)| *pose).collect(),
        configurations: legs.into_iter().flat_map(|(path, _)| path).collect(),
    })
}

/// Returns free configurations at a share of the edge.
fn states(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    planned: [&PlanarPose; 2],
    s: f64,
    orientations: &[ToolOrientation],
) -> Vec<State> {
    let stride = orientations.len().div_ceil(MAX_ORIENTATIONS).max(1);
    let mut states: Vec<State> = Vec::new();
    for (i, orientation) in orientations.iter().step_by(stride).enumerate() {
        // The rotation against the plan is that at the goal, all along: layers change it where they must.
        let end = turn_along_edge(planned, orientation, from);
        let place = from.interpolate(&end, s).surface_from_tool.position;
        let turn_left = (1.0 - s) * (planned[1].heading - planned[0].heading);
        let heading = end.surface_from_tool.heading - turn_left;
        let pose = ToolPose {
            surface_from_tool: PlanarPose::new(place, heading),
            ..end
        };
        for k in 0..STARTS {
            let seed = arm.config.seed ^ (i as u64 * STARTS + k);
            let found = match k {
                0 => arm.reach(&pose, start),
                1 => arm.reach_anyhow(&pose, &[], seed, 1),
                _ => arm.reach_anyhow(&pose, &[&arm.random_start(seed)], seed, 1),
            };
            let Ok(q) = found else { continue };
            let is_new = |state: &State| state.pose != pose || widest_step(&state.q, &q) > SAME;
            if states.iter().all(is_new) && arm.is_free_at(&q, AllowedContact::Surface) {
                states.push(State {
                    pose,
                    q,
                    failed: false,
                });
            }
        }
    }
    states
}

/// Continues the depth-first search from a configuration of a layer.
fn descend(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    layers: &mut [Vec<State>],
    depth: usize,
    legs: &mut Vec<(Vec<JointPositions>, ToolPose)>,
) -> bool {
    if depth == layers.len() {
        return true;
    }
    let mut order: Vec<(f64, usize)> = layers[depth]
        .iter()
        .enumerate()
        .map(|(i, state)| (widest_step(start, &state.q), i))
        .filter(|&(change, i)| change <= MAX_CHANGE && !layers[depth][i].failed)
        .collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, i) in order {
        if layers[depth][i].failed {
            continue;
        }
        let (pose, q) = (layers[depth][i].pose, layers[depth][i].q);
        let Some(path) = connect(arm, start, from, &q, &pose) else {
            continue;
        };
        legs.push((path, pose));
        if descend(arm, &q, &pose, layers, depth + 1, legs) {
            return true;
        }
        legs.pop();
        // No path continues from here, in any configuration.
        layers[depth][i].failed = true;
    }
    false
}

/// Returns the joint path from one configuration to another while the tool follows its line.
fn connect(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    end: &JointPositions,
    to: &ToolPose,
) -> Option<Vec<JointPositions>> {
    let steps = (from.distance(to) / arm.config.step)
        .max(widest_step(start, end) / (0.25 * arm.config.max_joint_step))
        .ceil()
        .max(1.0) as usize;
    let mut path = Vec::with_capacity(steps);
    let mut at = *start;
    for i in 1..=steps {
        let s = i as f64 / steps as f64;
        let next = if i == steps {
            *end
        } else {
            arm.reach(&from.interpolate(to, s), &between(start, end, s))
                .ok()?
        };
        let middle = from.interpolate(to, (i as f64 - 0.5) / steps as f64);
        let is_way = !arm.is_jump(&at, &next)
            && arm.is_on_line(&at, &next, &middle)
            && arm.is_free(&at, &next, AllowedContact::Surface).is_ok();
        if !is_way {
            return None;
        }
        path.push(next);
        at = next;
    }
    Some(path)
}
