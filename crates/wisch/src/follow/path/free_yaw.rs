//! Headings of the tool that are the robot's to choose, where its effect does not depend on them.

use super::arm::Arm;
use super::taut::{drawn_taut, on_surface, way};
use crate::geometry::{PlanarPose, Point2, wrap_angle};
use crate::robot::JointPositions;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Random configurations in which a stroke may begin, beside the current one and the ready posture.
const STARTS: usize = 8;

/// The tool moved along the line with its yaw left to the arm.
struct Track {
    /// At the corners that it comes to, at least one.
    at: Vec<JointPositions>,
    /// The length of the joints' way, that to the start included [rad].
    movement: f64,
}

/// Configurations at the corners of a line between which the joints move little, none at a corner where the tool cannot be put
/// down: of the tracks from several configurations the one that leads furthest, and of these the one along which they move
/// least, drawn taut. Where none leads on, the next begin anew.
pub(in crate::follow) fn eased(
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
        drawn_taut(arm, &line[begin..begin + at.len()], &mut at);
        last = at[at.len() - 1];
        near.extend(at.into_iter().map(Some));
    }
    near
}

/// Configurations from which tracks may lead, of which some put the tool down at a place: the current one, the ready posture
/// and random ones.
pub(in crate::follow) fn starts(arm: &Arm, now: &JointPositions, seed: u64) -> Vec<JointPositions> {
    let (ranges, mut random) = (arm.ranges(), ChaCha8Rng::seed_from_u64(seed));
    let anywhere = (0..STARTS).map(|_| {
        let any = |&[lower, upper]: &[f64; 2]| random.random_range(lower..=upper);
        ranges.iter().map(any).collect()
    });
    [*now, arm.ready()].into_iter().chain(anywhere).collect()
}

/// The poses of the tool at some places with the headings that it has in these configurations, without wraps.
pub(in crate::follow) fn headed(
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

/// Of the tracks from several configurations the best; nothing if the tool cannot be put down at the first corner.
fn best_track(arm: &Arm, now: &JointPositions, line: &[Point2], seed: u64) -> Option<Track> {
    let near = starts(arm, now, seed).into_iter();
    let starts = near.filter_map(|near| arm.reach_with_free_yaw(&on_surface(line[0]), &near));
    let mut best: Option<Track> = None;
    for start in starts {
        let whole = best.as_ref().filter(|best| best.at.len() == line.len());
        let most = whole.map_or(f64::INFINITY, |best| best.movement);
        let track = Track::along(arm, now, start, line, most);
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
    /// The tool along the line from a configuration on, as far as it comes before joints have moved further than `most` [rad].
    fn along(
        arm: &Arm,
        now: &JointPositions,
        start: JointPositions,
        line: &[Point2],
        most: f64,
    ) -> Self {
        let mut track = Self {
            at: vec![start],
            movement: way(now, &start),
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
                movement += way(&q, &next);
                if arm.jumps(&q, &next) || movement >= most {
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
