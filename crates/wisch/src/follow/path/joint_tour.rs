//! A tour in joint space: an order of nodes, and configurations at them, with little joint travel.
//!
//! A tree of nearest neighbours reaches all nodes from one configuration, each from a node near it, so that
//! neighbours have similar configurations. These are smoothed, a tour is found by the joint distances between
//! them, and the joint travel along the tour is minimised.

use super::arm::{Arm, widest_step};
use super::free_yaw::start_configurations;
use super::joint_travel::{joint_distance, minimise_joint_travel, movement, touch_down_near};
use crate::geometry::Point2;
use crate::plan::{Plan, order_nodes};
use crate::robot::JointPositions;
use rayon::prelude::*;

/// Largest step of a joint between neighbours with similar configurations [rad or m].
const ALIKE: f64 = 0.6;
/// Number of neighbours whose mean a configuration moves to.
const NEIGHBOURS: usize = 6;
/// Number of smoothing passes over all configurations.
const SWEEPS: usize = 10;
/// Weight of the tool's path against the mean joint travel per path length [1]: of orders with the same joint
/// travel, the shorter is faster.
const WAY_SHARE: f64 = 0.25;

/// An order of nodes with a configuration at each.
pub(in crate::follow) struct JointTour {
    /// Indices of the given nodes, stroke by stroke.
    pub strokes: Vec<Vec<usize>>,
    /// Configuration at each of the given nodes.
    pub at: Vec<JointPositions>,
}

/// One configuration at each place, similar between neighbours.
struct Spread {
    at: Vec<JointPositions>,
    /// Sum of the joint distances from each place to the place that it was reached from [rad].
    movement: f64,
    /// Sum of the distances between these places [m].
    length: f64,
}

/// Returns an order of the nodes of a plan to absorb in which the joints move less than in the given order;
/// `None` if there is none, or if a node is not reached from its neighbours.
pub(in crate::follow) fn joint_tour(
    arm: &Arm,
    now: &JointPositions,
    plan: &Plan,
    nodes: &[usize],
    seed: u64,
) -> Option<JointTour> {
    let places: Vec<Point2> = nodes.iter().map(|&n| plan.graph.position(n)).collect();
    let from = start_configurations(arm, now, seed);
    let spreads: Vec<Spread> = (from.par_iter())
        .filter_map(|start| Spread::from(arm, &places, start))
        .collect();
    let spread = (spreads.into_iter()).min_by(|a, b| a.movement.total_cmp(&b.movement))?;
    let mut at = spread.at;
    relax(arm, &places, &mut at);
    let rate = spread.movement / spread.length.max(plan.lift_height);
    let start = (0..at.len())
        .min_by(|&a, &b| joint_distance(now, &at[a]).total_cmp(&joint_distance(now, &at[b])))?;
    let cost = |a: usize, b: usize| {
        joint_distance(&at[a], &at[b]) + WAY_SHARE * rate * (places[a] - places[b]).norm()
    };
    let lift = 2.0 * plan.lift_height * rate;
    let strokes = order_nodes(arm.task, plan, nodes, start, cost, lift, seed).ok()?;
    let minimised = |order: &[usize]| {
        let line: Vec<Point2> = order.iter().map(|&i| places[i]).collect();
        let mut row: Vec<JointPositions> = order.iter().map(|&i| at[i]).collect();
        minimise_joint_travel(arm, &line, &mut row);
        (joint_distance(now, &row[0]) + movement(&row), row)
    };
    let order: Vec<usize> = strokes.iter().flatten().copied().collect();
    let given: Vec<usize> = (0..at.len()).collect();
    let ((least, row), (most, _)) = rayon::join(|| minimised(&order), || minimised(&given));
    for (&i, q) in order.iter().zip(row) {
        at[i] = q;
    }
    (least < most).then_some(JointTour { strokes, at })
}

impl Spread {
    /// Reaches all places from the one nearest to the tool in a configuration, always the place nearest to
    /// those reached so far.
    fn from(arm: &Arm, places: &[Point2], start: &JointPositions) -> Option<Self> {
        let tool = arm.tool_on_surface(start)?;
        let distance = |i: usize| (places[i] - tool).norm();
        let first = (0..places.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)))?;
        let mut at: Vec<Option<JointPositions>> = vec![None; places.len()];
        let mut nearest: Vec<(f64, usize)> = vec![(f64::INFINITY, first); places.len()];
        let (mut next, mut configuration) = (first, touch_down_near(arm, places[first], start)?);
        let (mut movement, mut length) = (0.0, 0.0);
        loop {
            at[next] = Some(configuration);
            for (i, known) in nearest.iter_mut().enumerate() {
                let distance = (places[i] - places[next]).norm();
                if at[i].is_none() && distance < known.0 {
                    *known = (distance, next);
                }
            }
            (next, configuration) = loop {
                let open = (0..places.len()).filter(|&i| at[i].is_none());
                let Some(i) = open.min_by(|&a, &b| nearest[a].0.total_cmp(&nearest[b].0)) else {
                    let at = at.into_iter().collect::<Option<Vec<_>>>()?;
                    return Some(Self {
                        at,
                        movement,
                        length,
                    });
                };
                let (distance, from) = nearest[i];
                if distance == f64::INFINITY {
                    return None;
                }
                let from = at[from]?;
                match touch_down_near(arm, places[i], &from) {
                    Some(q) if widest_step(&from, &q) <= ALIKE => {
                        movement += joint_distance(&from, &q);
                        length += distance;
                        break (i, q);
                    }
                    // Tries again from another place, once one is reached.
                    _ => nearest[i].0 = f64::INFINITY,
                }
            };
        }
    }
}

/// Smoothing: moves each configuration to the mean of its neighbours' configurations, where these are similar.
fn relax(arm: &Arm, places: &[Point2], at: &mut [JointPositions]) {
    let neighbours: Vec<Vec<usize>> = (0..places.len())
        .map(|i| {
            let distance = |j: &usize| (places[i] - places[*j]).norm();
            let mut others: Vec<usize> = (0..places.len()).filter(|&j| j != i).collect();
            others.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
            others.truncate(NEIGHBOURS);
            others
        })
        .collect();
    for _ in 0..SWEEPS {
        for i in 0..at.len() {
            let alike: Vec<JointPositions> = (neighbours[i].iter().map(|&j| at[j]))
                .filter(|q| widest_step(&at[i], q) <= ALIKE)
                .collect();
            if alike.len() < 2 {
                continue;
            }
            let mean: JointPositions = (0..at[i].len())
                .map(|k| alike.iter().map(|q| q[k]).sum::<f64>() / alike.len() as f64)
                .collect();
            if let Some(q) = touch_down_near(arm, places[i], &mean) {
                at[i] = q;
            }
        }
    }
}
