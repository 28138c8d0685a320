//! Yaw of the tool chosen by the robot, where the effect does not depend on it.

use super::arm::Arm;
use super::joint_travel::{joint_distance, minimise_joint_travel, on_surface};
use crate::geometry::{PlanarPose, Point2, wrap_angle};
use crate::robot::JointPositions;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Number of random configurations from which a stroke may start, beside the current one and the ready posture.
const STARTS: usize = 8;

/// Configurations of the arm along the line, with the tool's yaw free.
struct Track {
    /// Configurations at the corners that are reached, at least one.
    at: Vec<JointPositions>,
    /// Length of the joint path, with the path to the start [rad].
    movement: f64,
}

/// Returns configurations at the corners of a line between which the joints move little; `None` at a corner
/// where the tool cannot touch down.
///
/// Tracks start from several configurations. The longest is taken, of equal ones that with the shortest joint
/// path, and its joint travel is minimised. Where no track continues, the next tracks start anew.
pub(in crate::follow) fn configurations_with_free_yaw(
    arm: &Arm,
    now: &JointPositions,
    line: &[Point2],
    seed: u64,
) -> Vec<Option<JointPositions>> {
    let mut near: Vec<Option<JointPositions>> = Vec::new();
    let mut last = *now;
    while near.len() < line.len() {
        let begin = near.len();
        let seed = seed ^ (begin as u64) << 16;
        let Some(Track { mut at, .. }) = best_track(arm, &last, &line[begin..], seed) else {
            near.push(None);
            continue;
        };
        minimise_joint_travel(arm, &line[begin..begin + at.len()], &mut at);
        last = at[at.len() - 1];
        near.extend(at.into_iter().map(Some));
    }
    near
}

/// Returns start configurations for tracks: the current one, the ready posture and random ones.
pub(in crate::follow) fn start_configurations(
    arm: &Arm,
    now: &JointPositions,
    seed: u64,
) -> Vec<JointPositions> {
    let (ranges, mut random) = (arm.ranges(), ChaCha8Rng::seed_from_u64(seed));
    let anywhere = (0..STARTS).map(|_| {
        let any = |&[lower, upper]: &[f64; 2]| random.random_range(lower..=upper);
        ranges.iter().map(any).collect()
    });
    [*now, arm.ready_posture()]
        .into_iter()
        .chain(anywhere)
        .collect()
}

/// Returns the planned poses with the headings of the tool in these configurations, not wrapped.
pub(in crate::follow) fn poses_with_yaws(
    arm: &Arm,
    planned: &[PlanarPose],
    at: &[Option<JointPositions>],
) -> Vec<PlanarPose> {
    let mut before: Option<f64> = None;
    let pairs = planned.iter().zip(at);
    let heading = pairs.map(|(pose, q)| {
        let Some(q) = q else { return *pose };
        let turned = arm.heading(q);
        let heading = before.map_or(turned, |before| before + wrap_angle(turned - before));
        before = Some(heading);
        PlanarPose::new(pose.position, heading)
    });
    heading.collect()
}

/// Returns the best track from several start configurations; `None` if the tool cannot touch down at the first
/// corner.
fn best_track(arm: &Arm, now: &JointPositions, line: &[Point2], seed: u64) -> Option<Track> {
    let near = start_configurations(arm, now, seed).into_iter();
    let starts = near.filter_map(|near| arm.reach_with_free_yaw(&on_surface(line[0]), &near));
    let mut best: Option<Track> = None;
    for start in starts {
        let whole = best.as_ref().filter(|best| best.at.len() == line.len());
        let most = whole.map_or(f64::INFINITY, |best| best.movement);
        let track = Track::follow_line(arm, now, start, line, most);
        let is_better = best.as_ref().is_none_or(|best| {
            let (new, old) = (track.at.len(), best.at.len());
            new > old || new == old && track.movement < best.movement
        });
        if is_better {
            best = Some(track);
        }
    }
    best
}

impl Track {
    /// Moves the tool along the line from a configuration, until it is out of reach or the joints have moved
    /// more than `most` [rad].
    fn follow_line(
        arm: &Arm,
        now: &JointPositions,
        start: JointPositions,
        line: &[Point2],
        most: f64,
    ) -> Self {
        let mut track = Self {
            at: vec![start],
            movement: joint_distance(now, &start),
        };
        let mut q = start;
        for edge in line.windows(2) {
            let (from, to) = (edge[0], edge[1]);
            let steps = ((to - from).norm() / arm.config.step).ceil().max(1.0) as usize;
            let mut movement = track.movement;
            for i in 1..=steps {
                let place = from + (to - from) * (i as f64 / steps as f64);
                let Some(next) = arm.reach_with_free_yaw(&on_surface(place), &q) else {
                    return track;
                };
                movement += joint_distance(&q, &next);
                if arm.is_jump(&q, &next) || movement >= most {
                    return track;
                }
                q = next;
            }
            track.at.push(q);
            track.movement = movement;
        }
        track
    }
}
