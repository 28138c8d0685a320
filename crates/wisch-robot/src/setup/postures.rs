//! Postures within the limits of a robot.

use crate::{JointKind, LinkId, RobotModel};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::PI;

/// Largest number of variables between two near links.
pub(super) const MAX_NEAR_VARIABLES: usize = 3;
/// Largest number of draws of a posture in which the joints that follow others are within their
/// limits.
const MAX_DRAWS: usize = 2000;
/// Range of a sliding joint without limits [m].
const UNLIMITED_SLIDE: f64 = 1.0;
/// Longest range of a sliding joint that is searched completely [m]. A longer range stands for
/// missing limits; only its part near 0 is searched.
const LONGEST_SLIDE: f64 = 100.0;

/// Returns the posture in the middle of all limits, with 0 for unlimited joints: n positions [rad or m].
pub fn middle_posture(robot: &RobotModel) -> Vec<f64> {
    let middle = |i: usize| {
        let range = robot.variable(i).limits.position;
        range.map_or(0.0, |range| f64::midpoint(range.lower, range.upper))
    };
    (0..robot.dof()).map(middle).collect()
}

/// Returns the posture of the joints that no group moves: the middle of their limits, where wisch keeps a joint that
/// no ready state names. If a joint that follows others is outside its own limits there, the variables that drive it
/// are at 0, or at random positions, and are returned as well: a ready state must name them.
pub fn held_posture(robot: &RobotModel) -> (Vec<f64>, Vec<usize>) {
    let middle = middle_posture(robot);
    let faults = robot.limit_faults(&middle).unwrap_or_default();
    let outside = |name: &str| faults.iter().any(|fault| fault.joint == name);
    let drives = robot.joints().iter().filter(|joint| outside(&joint.name));
    let mut driving: Vec<usize> = drives
        .flat_map(|joint| joint.drive.terms.iter().map(|&(variable, _)| variable))
        .collect();
    driving.sort_unstable();
    driving.dedup();
    if driving.is_empty() {
        return (middle, driving);
    }
    let default = default_posture(robot);
    let mut random = random_stream(0, 0);
    let mut q = middle.clone();
    for draw in 0..MAX_DRAWS {
        for &variable in &driving {
            let (lower, upper) = range_of(robot, variable);
            q[variable] = match draw {
                0 => default[variable],
                _ => lower + random.random::<f64>() * (upper - lower),
            };
        }
        if is_within_limits(robot, &q) {
            return (q, driving);
        }
    }
    (middle, Vec::new())
}

/// Returns the posture that MoveIt calls the default: 0, or the middle of the limits of a joint that cannot be at 0.
pub(super) fn default_posture(robot: &RobotModel) -> Vec<f64> {
    let mut q = middle_posture(robot);
    for (i, position) in q.iter_mut().enumerate() {
        let range = robot.variable(i).limits.position;
        if range.is_none_or(|range| (range.lower..=range.upper).contains(&0.0)) {
            *position = 0.0;
        }
    }
    q
}

/// Returns a random stream of its own for each index.
pub(super) fn random_stream(seed: u64, index: usize) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(index as u64);
    random
}

/// Whether all joints, including those that follow others, are within their limits.
pub(super) fn is_within_limits(robot: &RobotModel, q: &[f64]) -> bool {
    robot.limit_faults(q).is_ok_and(|faults| faults.is_empty())
}

/// Returns the range of a variable that is searched: its limits, or π or 1 m about 0. Of a slide with very wide limits it is
/// the part within 1 m of its position nearest to 0.
pub(super) fn range_of(robot: &RobotModel, variable: usize) -> (f64, f64) {
    let joint = robot.variable(variable);
    match (joint.limits.position, joint.kind) {
        (Some(range), JointKind::Prismatic) if range.upper - range.lower > LONGEST_SLIDE => {
            let middle = 0.0_f64.clamp(range.lower, range.upper);
            (
                range.lower.max(middle - UNLIMITED_SLIDE),
                range.upper.min(middle + UNLIMITED_SLIDE),
            )
        }
        (Some(range), _) => (range.lower, range.upper),
        (None, JointKind::Prismatic) => (-UNLIMITED_SLIDE, UNLIMITED_SLIDE),
        (None, _) => (-PI, PI),
    }
}

/// Returns the variables that move two links against each other, sorted.
pub(super) fn variables_between(robot: &RobotModel, pair: [LinkId; 2]) -> Vec<usize> {
    let [above_a, above_b] = pair.map(|link| {
        let joints = robot.joints_above(link);
        joints.map(|joint| joint.child).collect::<Vec<LinkId>>()
    });
    let only_a = above_a.iter().filter(|link| !above_b.contains(link));
    let only_b = above_b.iter().filter(|link| !above_a.contains(link));
    let joints = only_a.chain(only_b).filter_map(|link| {
        let above = robot.links()[link.index()].parent?;
        Some(&robot.joints()[above.index()])
    });
    let mut variables: Vec<usize> = joints
        .flat_map(|joint| joint.drive.terms.iter().map(|&(variable, _)| variable))
        .collect();
    variables.sort_unstable();
    variables.dedup();
    variables
}
