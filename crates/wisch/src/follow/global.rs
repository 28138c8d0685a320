//! The global method: a deterministic search over the discretised null space along an edge, after
//! Huaman and Stilman (2012); paper §3.3.
//!
//! The edge is cut into layers. Each layer has configurations for all values of the tool's freedoms
//! from several starts; a way from one layer to the next exists if the tool can follow its line while
//! the joints go from the one to the other. Depth first, the nearest configuration first; what has
//! failed once is not entered again, so the search ends, and within the discretisation it is complete.

use super::arm::Arm;
use super::freedom::{Freedom, deviation, turned_along};
use super::{ToolPose, Touch};
use crate::geometry::PlanarPose;
use crate::robot::JointPositions;

/// Distance between layers [m].
const LAYER: f64 = 0.03;
/// Turn between layers of an edge on which the tool only turns [rad].
const LAYER_TURN: f64 = 0.2;
/// Starts of the inverse kinematics for each pose, the current configuration among them.
const STARTS: u64 = 4;
/// Most freedoms that are looked at in a layer.
const MAX_FREEDOMS: usize = 18;
/// Furthest a joint moves from one layer to the next [rad or m].
const MAX_CHANGE: f64 = 0.8;
/// Configurations nearer than this are the same [rad or m].
const SAME: f64 = 0.05;

/// Part of a stroke, from one node to the next.
#[derive(Debug, Clone)]
pub(super) struct Leg {
    /// Configurations after the start, the last at the node.
    pub configurations: Vec<JointPositions>,
    /// Corners of the tool's line after the start, the last at the node.
    pub line: Vec<ToolPose>,
    /// How far the tool is turned away from the plan at the node, and by how much more on the way [rad].
    pub turned: f64,
}

struct State {
    pose: ToolPose,
    q: JointPositions,
    failed: bool,
}

/// A way in contact to the node at `goal`, in any orientation that the tool's freedoms allow.
pub(super) fn search(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    planned: [&PlanarPose; 2],
    freedoms: &[Freedom],
) -> Option<Leg> {
    let straight = turned_along(planned, freedoms.first()?, from);
    let way = from.distance(&straight) / LAYER;
    let turn = (straight.surface_from_tool.heading - from.surface_from_tool.heading).abs();
    let count = (way.max(turn / LAYER_TURN).ceil() as usize).max(1);
    // The far end first: most edges that cannot be followed end out of reach.
    let mut layers: Vec<Vec<State>> = Vec::with_capacity(count);
    for i in (1..=count).rev() {
        let layer = states(arm, start, from, planned, i as f64 / count as f64, freedoms);
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
    let against_plan = Freedom {
        rotation: end.surface_from_tool.heading - planned[1].heading,
        tilt: end.tilt,
    };
    Some(Leg {
        turned: deviation(&against_plan, planned[0], from, symmetric),
        line: legs.iter().map(|(_, pose)| *pose).collect(),
        configurations: legs.into_iter().flat_map(|(path, _)| path).collect(),
    })
}

/// Free configurations at a share of the edge.
fn states(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    planned: [&PlanarPose; 2],
    s: f64,
    freedoms: &[Freedom],
) -> Vec<State> {
    let stride = freedoms.len().div_ceil(MAX_FREEDOMS).max(1);
    let mut states: Vec<State> = Vec::new();
    for (i, freedom) in freedoms.iter().step_by(stride).enumerate() {
        // The rotation against the plan is that at the goal, all along: layers change it where they must.
        let end = turned_along(planned, freedom, from);
        let place = from.towards(&end, s).surface_from_tool.position;
        let turn_left = (1.0 - s) * (planned[1].heading - planned[0].heading);
        let heading = end.surface_from_tool.heading - turn_left;
        let pose = ToolPose {
            surface_from_tool: PlanarPose::new(place, heading),
            ..end
        };
        for k in 0..STARTS {
            let found = if k == 0 {
                arm.reach(&pose, start)
            } else {
                arm.reach_anyhow(&pose, &[], arm.config.seed ^ (i as u64 * STARTS + k), 1)
            };
            let Ok(q) = found else { continue };
            let is_new = |state: &State| {
                (state.pose != pose)
                    || state
                        .q
                        .iter()
                        .zip(q.iter())
                        .any(|(a, b)| (a - b).abs() > SAME)
            };
            if states.iter().all(is_new) && arm.is_free_at(&q, Touch::Surface) {
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
    let change = |q: &JointPositions| {
        let changes = start.iter().zip(q.iter()).map(|(a, b)| (a - b).abs());
        changes.fold(0.0, f64::max)
    };
    let mut order: Vec<(f64, usize)> = layers[depth]
        .iter()
        .enumerate()
        .map(|(i, state)| (change(&state.q), i))
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
        // Whatever leads here: there is no way on.
        layers[depth][i].failed = true;
    }
    false
}

/// The way of the joints from one configuration to another while the tool follows its line.
fn connect(
    arm: &Arm,
    start: &JointPositions,
    from: &ToolPose,
    end: &JointPositions,
    to: &ToolPose,
) -> Option<Vec<JointPositions>> {
    let widest = start
        .iter()
        .zip(end.iter())
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    let steps = (from.distance(to) / arm.config.step)
        .max(widest / (0.25 * arm.config.max_joint_step))
        .ceil()
        .max(1.0) as usize;
    let mut path = Vec::with_capacity(steps);
    let mut at = *start;
    for i in 1..=steps {
        let s = i as f64 / steps as f64;
        let next = if i == steps {
            *end
        } else {
            let guess: JointPositions = start
                .iter()
                .zip(end.iter())
                .map(|(a, b)| a + s * (b - a))
                .collect();
            arm.reach(&from.towards(to, s), &guess).ok()?
        };
        let middle = from.towards(to, (i as f64 - 0.5) / steps as f64);
        let is_way = !arm.jumps(&at, &next)
            && arm.is_on_line(&at, &next, &middle)
            && arm.is_free(&at, &next, Touch::Surface).is_ok();
        if !is_way {
            return None;
        }
        path.push(next);
        at = next;
    }
    Some(path)
}
