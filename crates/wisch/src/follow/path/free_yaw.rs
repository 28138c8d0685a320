//! Headings of the tool that are the robot's to choose, where its effect does not depend on them.

use super::arm::Arm;
use crate::follow::ToolPose;
use crate::geometry::{PlanarPose, wrap_angle};
use crate::robot::JointPositions;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Random configurations in which a stroke may begin, beside the current one and the ready posture.
const STARTS: usize = 8;

/// A stroke along which the joints move little.
pub(in crate::follow) struct Eased {
    /// Its corners, with their headings.
    pub poses: Vec<PlanarPose>,
    /// The configuration at the first of them.
    pub start: JointPositions,
    /// The configuration at the last of them.
    pub end: JointPositions,
}

/// The tool moved along the line with its yaw left to the arm.
struct Track {
    /// At the corners that it comes to, at least one [rad].
    headings: Vec<f64>,
    start: JointPositions,
    end: JointPositions,
    /// How far the joints move, the way to the start included [rad].
    movement: f64,
}

/// The same corners with headings along which the joints move little: of the tracks from several configurations the one that
/// leads furthest, and of these the one along which they move least. Where none leads on, the next begin anew.
pub(in crate::follow) fn eased(
    arm: &Arm,
    now: &JointPositions,
    planned: &[PlanarPose],
    seed: u64,
) -> Option<Eased> {
    let mut poses = planned.to_vec();
    let mut begin = 0;
    let mut ends: Option<[JointPositions; 2]> = None;
    while begin < planned.len() {
        let at = ends.map_or(*now, |[_, end]| end);
        let seed = seed ^ (begin as u64) << 16;
        let Some(track) = best_track(arm, &at, &planned[begin..], seed) else {
            begin += 1;
            continue;
        };
        for (pose, &heading) in poses[begin..].iter_mut().zip(&track.headings) {
            pose.heading = heading;
        }
        begin += track.headings.len();
        let start = ends.map_or(track.start, |[start, _]| start);
        ends = Some([start, track.end]);
    }
    ends.map(|[start, end]| Eased { poses, start, end })
}

/// Of the tracks from several configurations the best; nothing if the tool cannot be put down at the first corner.
fn best_track(arm: &Arm, now: &JointPositions, planned: &[PlanarPose], seed: u64) -> Option<Track> {
    let (ranges, mut random) = (arm.ranges(), ChaCha8Rng::seed_from_u64(seed));
    let anywhere = (0..STARTS).map(|_| {
        let any = |&[lower, upper]: &[f64; 2]| random.random_range(lower..=upper);
        ranges.iter().map(any).collect()
    });
    let near = [*now, arm.ready()].into_iter().chain(anywhere);
    let starts = near.filter_map(|near| arm.reach_with_free_yaw(&on_surface(&planned[0]), &near));
    let mut best: Option<Track> = None;
    for start in starts {
        let whole = best
            .as_ref()
            .filter(|best| best.headings.len() == planned.len());
        let most = whole.map_or(f64::INFINITY, |best| best.movement);
        let track = Track::along(arm, now, start, planned, most);
        let is_better = best.as_ref().is_none_or(|best| {
            let (new, old) = (track.headings.len(), best.headings.len());
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
        planned: &[PlanarPose],
        most: f64,
    ) -> Self {
        let mut track = Self {
            headings: vec![arm.heading(&start)],
            start,
            end: start,
            movement: moved(now, &start),
        };
        for edge in planned.windows(2) {
            let (from, to) = (edge[0].position, edge[1].position);
            let steps = ((to - from).norm() / arm.config.step).ceil().max(1.0) as usize;
            let (mut q, mut heading, mut movement) = (track.end, track.heading(), track.movement);
            for i in 1..=steps {
                let place = from + (to - from) * (i as f64 / steps as f64);
                let pose = on_surface(&PlanarPose::new(place, heading));
                let Some(next) = arm.reach_with_free_yaw(&pose, &q) else {
                    return track;
                };
                movement += moved(&q, &next);
                if arm.jumps(&q, &next) || movement >= most {
                    return track;
                }
                q = next;
                heading += wrap_angle(arm.heading(&q) - heading);
            }
            track.headings.push(heading);
            (track.end, track.movement) = (q, movement);
        }
        track
    }

    fn heading(&self) -> f64 {
        self.headings[self.headings.len() - 1]
    }
}

fn on_surface(pose: &PlanarPose) -> ToolPose {
    ToolPose {
        surface_from_tool: *pose,
        height: 0.0,
        tilt: 0.0,
    }
}

/// How far the joints move, summed over them [rad].
fn moved(from: &JointPositions, to: &JointPositions) -> f64 {
    let steps = from.iter().zip(to.iter()).map(|(a, b)| (b - a).abs());
    steps.sum()
}
