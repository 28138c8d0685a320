//! A motion of wisch as goals of a trajectory controller.
//!
//! A motion is sent in parts, each from rest to rest: the robot presses in the parts that wipe, and in no other.

use crate::messages::{JointTolerance, PointMessage, Stamp, TrajectoryGoal, TrajectoryMessage};
use crate::pace::GoalPace;
use crate::protocol::{MotionHead, PointRecord};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};
use wisch::geometry::Pose;

/// Time over which the distance between robot and start of a part fades [s].
const FADE_TIME: f64 = 0.5;
/// Largest velocity at the ends of a part [rad/s or m/s].
const REST_VELOCITY: f64 = 1e-3;
/// Steps between two knots at which the tool's speed is evaluated.
const SPEED_STEPS: usize = 4;
/// Step of the search for the time at which a trajectory is nearest to the robot [s].
const SEARCH_STEP: f64 = 5e-3;
/// Bytes of a goal without its points and names.
const GOAL_BYTES: usize = 128;

/// A state of all joints on a trajectory.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Knot {
    /// Time since the start of the motion, as planned [s].
    pub time: f64,
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    pub accelerations: Vec<f64>,
    pub world_from_tool: Pose,
}

/// A motion with its knots.
#[derive(Debug, Clone)]
pub(crate) struct WipingMotion {
    pub head: MotionHead,
    pub knots: Vec<Knot>,
    pub world_from_root: Pose,
    pub world_from_surface: Pose,
    pub tip_from_tool: Pose,
}

/// A part of a motion, from rest to rest, which one goal executes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Part {
    /// First and last knot.
    pub knots: [usize; 2],
    /// Whether the tool wipes.
    pub is_wipe: bool,
    /// Start of a phase that lowers the tool, at the end of the part [s].
    pub lowers_from: Option<f64>,
    /// Whether the force is tared before the part.
    pub is_tared: bool,
}

/// Reads x, y, z and a quaternion x, y, z, w; `None` if a number is not finite or the quaternion is not of unit length.
fn pose(numbers: [f64; 7]) -> Option<Pose> {
    let [x, y, z, qx, qy, qz, qw] = numbers;
    let quaternion = Quaternion::new(qw, qx, qy, qz);
    let is_valid = numbers.iter().all(|n| n.is_finite()) && (quaternion.norm() - 1.0).abs() < 1e-3;
    is_valid.then(|| {
        Pose::from_parts(
            Translation3::new(x, y, z),
            UnitQuaternion::new_normalize(quaternion),
        )
    })
}

impl Knot {
    fn read(record: PointRecord, joints: usize) -> Result<Self, String> {
        let time = record.time_s;
        let lists = [
            ("positions", &record.positions),
            ("velocities", &record.velocities),
            ("accelerations", &record.accelerations),
        ];
        for (key, list) in lists {
            if list.len() != joints || list.iter().any(|value| !value.is_finite()) {
                return Err(format!(
                    "the point at {time} s has {} {key}; expected {joints} finite numbers",
                    list.len()
                ));
            }
        }
        let world_from_tool = pose(record.world_from_tool).filter(|_| time.is_finite());
        Ok(Self {
            time,
            world_from_tool: world_from_tool
                .ok_or_else(|| format!("the point at {time} s has no valid pose of the tool"))?,
            positions: record.positions,
            velocities: record.velocities,
            accelerations: record.accelerations,
        })
    }
}

impl WipingMotion {
    /// Makes a motion from its messages.
    ///
    /// # Errors
    /// If lists have the wrong length, numbers are not finite, or times do not increase.
    pub fn new(head: MotionHead, points: Vec<PointRecord>) -> Result<Self, String> {
        let joints = head.joints.len();
        let knots: Result<Vec<Knot>, String> = (points.into_iter())
            .map(|point| Knot::read(point, joints))
            .collect();
        let knots = knots?;
        if knots.len() < 2 {
            return Err(format!(
                "the motion has {} points; expected 2 or more",
                knots.len()
            ));
        }
        if let Some(pair) = knots.windows(2).find(|pair| pair[1].time <= pair[0].time) {
            let [before, time] = [pair[0].time, pair[1].time];
            return Err(format!(
                "the point at {time} s follows the point at {before} s"
            ));
        }
        let read = |numbers, name| pose(numbers).ok_or_else(|| format!("{name} is no valid pose"));
        Ok(Self {
            world_from_root: read(head.world_from_root, "world_from_root")?,
            world_from_surface: read(head.world_from_surface, "world_from_surface")?,
            tip_from_tool: read(head.tip_from_tool, "tip_from_tool")?,
            head,
            knots,
        })
    }

    /// Outward normal of the believed surface, in the world.
    pub fn normal(&self) -> Vector3<f64> {
        self.world_from_surface * Vector3::z()
    }

    /// Duration, as planned [s].
    pub fn duration(&self) -> f64 {
        self.knots.last().map_or(0.0, |knot| knot.time)
    }

    fn knot_at(&self, time: f64) -> usize {
        let next = self.knots.partition_point(|knot| knot.time < time - 1e-6);
        next.min(self.knots.len() - 1)
    }

    /// Cuts the motion into parts.
    ///
    /// # Errors
    /// If a joint moves where a part begins or ends.
    pub fn parts(&self) -> Result<Vec<Part>, String> {
        let mut cuts: Vec<(f64, bool)> = Vec::new();
        let phases = &self.head.phases;
        let mut is_tared = false;
        for (i, phase) in phases.iter().enumerate() {
            let is_wipe = phase.phase == "wipe";
            let after_wipe = i > 0 && phases[i - 1].phase == "wipe";
            let tares = phase.phase == "lower" && !is_tared;
            is_tared |= tares;
            if i == 0 || is_wipe || after_wipe || tares {
                cuts.push((phase.start_s, tares));
            }
        }
        let mut parts = Vec::new();
        for (k, &(start, is_tared)) in cuts.iter().enumerate() {
            let end = cuts.get(k + 1).map_or(self.duration(), |(next, _)| *next);
            let within = |time: f64| (start - 1e-6..end - 1e-6).contains(&time);
            let inside: Vec<_> = (phases.iter())
                .filter(|phase| within(phase.start_s))
                .collect();
            let knots = [self.knot_at(start), self.knot_at(end)];
            if knots[1] <= knots[0] {
                continue;
            }
            for knot in knots.map(|index| &self.knots[index]) {
                let speed = knot
                    .velocities
                    .iter()
                    .fold(0.0_f64, |most, v| most.max(v.abs()));
                if speed > REST_VELOCITY {
                    return Err(format!(
                        "the motion has {speed:.3} rad/s at {:.3} s, where a part begins or ends; expected rest",
                        knot.time
                    ));
                }
            }
            let last = inside.last();
            parts.push(Part {
                knots,
                is_wipe: inside.iter().any(|phase| phase.phase == "wipe"),
                lowers_from: last
                    .filter(|phase| phase.phase == "lower")
                    .map(|phase| phase.start_s),
                is_tared,
            });
        }
        Ok(parts)
    }

    /// The trajectory's positions at a time since its start, as planned [s].
    pub fn positions_at(&self, time: f64) -> Vec<f64> {
        let next = self.knots.partition_point(|knot| knot.time <= time);
        let from = &self.knots[next.saturating_sub(1)];
        let Some(to) = self.knots.get(next.max(1)) else {
            return from.positions.clone();
        };
        let span = to.time - from.time;
        let share = ((time - from.time) / span).clamp(0.0, 1.0);
        (0..from.positions.len())
            .map(|i| quintic(&ends(from, to, i, span), share)[0])
            .collect()
    }

    /// Largest speed of the tool along the trajectory, as planned [m/s], and its time [s]. `tool_at`: the tool's
    /// position for joint positions.
    pub fn greatest_tool_speed(
        &self,
        tool_at: impl Fn(&[f64]) -> Option<Vector3<f64>>,
    ) -> [f64; 2] {
        let mut greatest = [0.0, 0.0];
        let mut before: Option<(f64, Vector3<f64>)> = None;
        for pair in self.knots.windows(2) {
            let span = pair[1].time - pair[0].time;
            let steps = SPEED_STEPS.max((span / 0.01).ceil() as usize);
            for step in 0..steps {
                let time = pair[0].time + span * step as f64 / steps as f64;
                let Some(tool) = tool_at(&self.positions_at(time)) else {
                    continue;
                };
                if let Some((earlier, from)) = before {
                    let speed = (tool - from).norm() / (time - earlier);
                    if speed > greatest[0] {
                        greatest = [speed, time];
                    }
                }
                before = Some((time, tool));
            }
        }
        greatest
    }

    /// Makes the goal of a part, or of its rest. It begins at the robot's measured `positions`, whose distance from the
    /// trajectory fades within half a second.
    ///
    /// - `pace`: where on the trajectory it begins, and how fast it goes.
    /// - `names`: names of the joints, in the order of the positions.
    /// - `path_tolerance`: largest deviation of a joint [rad]; 0 leaves the choice to the controller.
    pub fn goal(
        &self,
        part: &Part,
        pace: &GoalPace,
        positions: &[f64],
        names: &[String],
        path_tolerance: f64,
    ) -> TrajectoryGoal {
        let begin = self.positions_at(pace.from);
        let offset: Vec<f64> = (positions.iter().zip(&begin))
            .map(|(measured, planned)| measured - planned)
            .collect();
        let mut states = self.states(part, pace);
        let duration = states.last().map_or(0.0, |(since, _)| *since);
        let fade = FADE_TIME.min(duration);
        if !(states.iter()).any(|(since, _)| (since - fade).abs() < 1e-6) {
            let at = states.partition_point(|(since, _)| *since < fade);
            states.insert(at, (fade, self.interpolated(pace.evaluate(fade)[0])));
        }
        let points = states.iter().map(|(since, knot)| {
            let [_, speed, gain] = pace.evaluate(*since);
            let [share, rate, curve] = fading(*since, fade);
            let sum = |i: usize, planned: f64, factor: f64| planned + offset[i] * factor;
            let each = 0..offset.len();
            PointMessage {
                positions: (each.clone())
                    .map(|i| sum(i, knot.positions[i], share))
                    .collect(),
                velocities: (each.clone())
                    .map(|i| sum(i, knot.velocities[i] * speed, rate))
                    .collect(),
                accelerations: each
                    .map(|i| {
                        let along = knot.velocities[i] * gain;
                        sum(i, knot.accelerations[i] * (speed * speed) + along, curve)
                    })
                    .collect(),
                effort: Vec::new(),
                time_from_start: Stamp::from_seconds(*since),
            }
        });
        let tolerances = names.iter().filter(|_| path_tolerance > 0.0);
        TrajectoryGoal {
            trajectory: TrajectoryMessage {
                joint_names: names.to_vec(),
                points: points.collect(),
                ..TrajectoryMessage::default()
            },
            path_tolerance: tolerances
                .map(|name| JointTolerance {
                    name: name.clone(),
                    position: path_tolerance,
                    ..JointTolerance::default()
                })
                .collect(),
            ..TrajectoryGoal::default()
        }
    }

    /// The states of a part at the points of a goal, each with its time since the goal began [s].
    fn states(&self, part: &Part, pace: &GoalPace) -> Vec<(f64, Knot)> {
        let ramp = pace.ramp_times().into_iter();
        let mut states: Vec<(f64, Knot)> = ramp
            .map(|since| (since, self.interpolated(pace.evaluate(since)[0])))
            .collect();
        let [ramp_end, ..] = pace.evaluate(pace.ramp);
        let later = self.knots[..=part.knots[1]].iter();
        let later = later.filter(|knot| knot.time > ramp_end + 1e-6);
        states.extend(later.map(|knot| (pace.since(knot.time), knot.clone())));
        states
    }

    /// Positions that the controller should have at a time on the trajectory [s], with what is left of the offset.
    ///
    /// - `since`: time since the goal began [s].
    /// - `end`: end of the part, as planned [s].
    pub fn faded_positions(
        &self,
        time: f64,
        since: f64,
        (pace, end): (&GoalPace, f64),
        offset: &[f64],
    ) -> Vec<f64> {
        let fade = FADE_TIME.min(pace.since(end));
        let [share, ..] = fading(since, fade);
        let planned = self.positions_at(time);
        let both = planned.iter().zip(offset);
        both.map(|(planned, offset)| planned + share * offset)
            .collect()
    }

    /// The time within a span of the trajectory [s] at which its positions are nearest to those measured; the first of
    /// several.
    pub fn nearest_time(&self, measured: &[f64], [from, to]: [f64; 2]) -> f64 {
        let steps = ((to - from).max(0.0) / SEARCH_STEP).ceil() as usize;
        let mut nearest = (f64::INFINITY, from);
        for step in 0..=steps {
            let time = (from + step as f64 * SEARCH_STEP).min(to.max(from));
            let planned = self.positions_at(time);
            let apart = planned.iter().zip(measured);
            let apart: f64 = apart.map(|(p, m)| (p - m) * (p - m)).sum();
            if apart < nearest.0 {
                nearest = (apart, time);
            }
        }
        nearest.1
    }

    /// The state of the trajectory at a time between two knots [s].
    fn interpolated(&self, time: f64) -> Knot {
        let next = self.knots.partition_point(|knot| knot.time <= time);
        let from = &self.knots[next.saturating_sub(1)];
        let to = self.knots.get(next).unwrap_or(from);
        let span = (to.time - from.time).max(1e-9);
        let share = ((time - from.time) / span).clamp(0.0, 1.0);
        let states: Vec<[f64; 3]> = (0..from.positions.len())
            .map(|i| quintic(&ends(from, to, i, span), share))
            .collect();
        let list = |k: usize, scale: f64| states.iter().map(|state| state[k] / scale).collect();
        Knot {
            time,
            positions: list(0, 1.0),
            velocities: list(1, span),
            accelerations: list(2, span * span),
            world_from_tool: from.world_from_tool,
        }
    }
}

/// Returns the size of a goal as it is sent [bytes], with a few bytes to spare.
pub(crate) fn goal_bytes(goal: &TrajectoryGoal) -> usize {
    let names: usize = (goal.trajectory.joint_names.iter())
        .map(|name| name.len() + 9)
        .sum();
    let joints = goal.trajectory.joint_names.len();
    // Three lists with their lengths, an empty list, and a time.
    let point = 3 * (8 * joints + 8) + 4 + 8;
    let tolerances: usize = (goal.path_tolerance.iter())
        .map(|tolerance| tolerance.name.len() + 9 + 24 + 7)
        .sum();
    GOAL_BYTES + names + goal.trajectory.points.len() * point + tolerances
}

/// Position, velocity and acceleration of joint `i` at both ends of a span [s], for a span of length 1.
fn ends(from: &Knot, to: &Knot, i: usize, span: f64) -> [[f64; 3]; 2] {
    [from, to].map(|knot| {
        [
            knot.positions[i],
            knot.velocities[i] * span,
            knot.accelerations[i] * span * span,
        ]
    })
}

/// Value, first and second derivative at `s` in [0, 1] of the polynomial of fifth degree with these values at 0 and 1.
pub(crate) fn quintic(&[[p, v, a], [q, w, b]]: &[[f64; 3]; 2], s: f64) -> [f64; 3] {
    let d = q - p;
    let [c2, c3, c4, c5] = [
        0.5 * a,
        10.0 * d - 6.0 * v - 4.0 * w - 1.5 * a + 0.5 * b,
        -15.0 * d + 8.0 * v + 7.0 * w + 1.5 * a - b,
        6.0 * d - 3.0 * v - 3.0 * w - 0.5 * a + 0.5 * b,
    ];
    [
        p + s * (v + s * (c2 + s * (c3 + s * (c4 + s * c5)))),
        v + s * (2.0 * c2 + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5))),
        2.0 * c2 + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5)),
    ]
}

/// Share of an offset that is left after a time [s], with its first and second derivative.
fn fading(time: f64, fade: f64) -> [f64; 3] {
    if time >= fade || fade <= 0.0 {
        return [0.0; 3];
    }
    let [share, rate, curve] = quintic(&[[1.0, 0.0, 0.0], [0.0; 3]], time / fade);
    [share, rate / fade, curve / (fade * fade)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::PhaseRecord;

    fn phase(name: &str, start_s: f64, end_s: f64) -> PhaseRecord {
        PhaseRecord {
            phase: name.to_owned(),
            start_s,
            end_s,
        }
    }

    /// One joint that moves by minimum-jerk steps of 1 rad and 1 s.
    pub(crate) fn steps(phases: &[&str]) -> WipingMotion {
        let identity = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        let head = MotionHead {
            round: 1,
            joints: vec!["a".to_owned()],
            world_from_surface: identity,
            press_force_n: 5.0,
            gap_m: None,
            duration_s: phases.len() as f64,
            phases: (phases.iter().enumerate())
                .map(|(i, name)| phase(name, i as f64, i as f64 + 1.0))
                .collect(),
            points: phases.len() + 1,
            tip: "tip".to_owned(),
            tip_from_tool: identity,
            world_from_root: identity,
        };
        let points = (0..=phases.len()).map(|i| PointRecord {
            time_s: i as f64,
            positions: vec![i as f64],
            velocities: vec![0.0],
            accelerations: vec![0.0],
            world_from_tool: identity,
        });
        WipingMotion::new(head, points.collect()).unwrap()
    }

    #[test]
    fn a_motion_is_cut_where_it_begins_to_wipe_ends_to_wipe_and_tares() {
        let motion = steps(&["transfer", "lower", "wipe", "lift", "lower", "wipe", "lift"]);
        let parts = motion.parts().unwrap();
        let knots: Vec<[usize; 2]> = parts.iter().map(|part| part.knots).collect();
        assert_eq!(knots, [[0, 1], [1, 2], [2, 3], [3, 5], [5, 6], [6, 7]]);
        let wipes: Vec<bool> = parts.iter().map(|part| part.is_wipe).collect();
        assert_eq!(wipes, [false, false, true, false, true, false]);
        let tared: Vec<bool> = parts.iter().map(|part| part.is_tared).collect();
        assert_eq!(tared, [false, true, false, false, false, false]);
        assert_eq!(parts[1].lowers_from, Some(1.0));
        assert_eq!(parts[3].lowers_from, Some(4.0));
    }

    #[test]
    fn a_motion_that_moves_where_it_is_cut_is_refused() {
        let mut motion = steps(&["lower", "wipe"]);
        motion.knots[1].velocities[0] = 0.3;
        let error = motion.parts().unwrap_err();
        assert!(error.contains("0.300 rad/s at 1.000 s"), "{error}");
    }

    #[test]
    fn a_goal_begins_at_the_measured_positions_after_time_0_and_ends_on_the_trajectory() {
        let motion = steps(&["transfer"]);
        let part = &motion.parts().unwrap()[0];
        let pace = GoalPace::from_rest(0.0, 0.5);
        let goal = motion.goal(part, &pace, &[0.01], &motion.head.joints, 0.05);
        let points = &goal.trajectory.points;
        let times: Vec<f64> = points.iter().map(|p| p.time_from_start.seconds()).collect();
        assert_eq!(times, [0.5, 2.0]);
        assert_eq!(goal.trajectory.header.stamp, Stamp::default());
        assert!((points[1].positions[0] - 1.0).abs() < 1e-12);
        // At the end of the fade, the state is that of the trajectory at half speed.
        let on_path = motion.interpolated(0.25);
        assert!((points[0].positions[0] - on_path.positions[0]).abs() < 1e-12);
        assert!((points[0].velocities[0] - 0.5 * on_path.velocities[0]).abs() < 1e-12);
        assert!((points[0].accelerations[0] - 0.25 * on_path.accelerations[0]).abs() < 1e-12);
        // Between the measured start and the first point, the motion is smooth and stays close to the trajectory plus offset.
        let start = [
            [0.01, 0.0, 0.0],
            [
                points[0].positions[0],
                points[0].velocities[0] * 0.5,
                points[0].accelerations[0] * 0.25,
            ],
        ];
        for share in [0.2, 0.5, 0.8] {
            let sent = quintic(&start, share)[0];
            let planned = motion.positions_at(0.25 * share)[0];
            assert!((sent - planned).abs() <= 0.0101, "{sent} and {planned}");
        }
    }

    /// The goal of a part from a time on, as its controller interpolates it: the state at a time [s].
    fn followed(goal: &TrajectoryGoal, begin: f64, time: f64) -> [f64; 3] {
        let points = &goal.trajectory.points;
        let since = |i: usize| points[i].time_from_start.seconds();
        let next = (0..points.len()).find(|i| since(*i) >= time).unwrap();
        let (from, start) = match next {
            0 => (0.0, [begin, 0.0, 0.0]),
            _ => {
                let p = &points[next - 1];
                let state = [p.positions[0], p.velocities[0], p.accelerations[0]];
                (since(next - 1), state)
            }
        };
        let p = &points[next];
        let end = [p.positions[0], p.velocities[0], p.accelerations[0]];
        let span = since(next) - from;
        let scaled = [start, end].map(|[q, v, a]| [q, v * span, a * span * span]);
        let [q, v, a] = quintic(&scaled, (time - from) / span);
        [q, v / span, a / (span * span)]
    }

    #[test]
    fn the_rest_of_a_goal_begins_at_rest_where_the_robot_stands_and_ends_on_the_trajectory() {
        let motion = steps(&["transfer"]);
        let part = &motion.parts().unwrap()[0];
        for (from, offset) in [(0.4, 0.0), (0.4, 0.01), (0.97, 0.002), (1.0, 0.0)] {
            let pace = GoalPace::resume(from, 1.0, 0.7);
            let begin = motion.positions_at(from)[0] + offset;
            let goal = motion.goal(part, &pace, &[begin], &motion.head.joints, 0.0);
            let points = &goal.trajectory.points;
            assert!(points.len() <= 12, "{}", points.len());
            let last = points.last().unwrap();
            assert!((last.positions[0] - 1.0).abs() < 1e-9, "{last:?}");
            assert!(last.velocities[0].abs() < 1e-9);
            let duration = last.time_from_start.seconds();
            assert!(duration >= 0.5 - 1e-9);
            let step = 1e-3;
            let mut before = [begin, 0.0, 0.0];
            for i in 1..(duration / step) as usize {
                let time = i as f64 * step;
                let now = followed(&goal, begin, time);
                // The speed is continuous and no greater than planned, but for the offset that fades.
                let fading = 1.875 * offset / 0.5;
                assert!((now[1] - before[1]).abs() < 0.03, "{time}: {now:?}");
                assert!(now[1] <= 0.7 * 1.875 + fading + 1e-3, "{time}: {now:?}");
                let on_path = motion.positions_at(pace.evaluate(time)[0])[0];
                assert!(now[0] - on_path <= offset + 1e-4, "{time}: {now:?}");
                assert!(now[0] - on_path >= -1e-4, "{time}: {now:?}");
                before = now;
            }
        }
    }

    #[test]
    fn the_time_on_the_trajectory_is_found_from_the_positions_but_never_before_the_span() {
        let motion = steps(&["transfer"]);
        let at = |time: f64| motion.positions_at(time);
        assert!((motion.nearest_time(&at(0.5), [0.3, 0.9]) - 0.5).abs() < 5e-3);
        assert_eq!(motion.nearest_time(&at(0.2), [0.3, 0.9]), 0.3);
        assert_eq!(motion.nearest_time(&at(0.95), [0.3, 0.9]), 0.9);
        assert_eq!(motion.nearest_time(&at(0.95), [0.9, 0.9]), 0.9);
    }

    #[test]
    fn the_greatest_tool_speed_is_that_of_the_minimum_jerk_step() {
        let motion = steps(&["transfer"]);
        let [speed, time] =
            motion.greatest_tool_speed(|q| Some(Vector3::new(0.5 * q[0], 0.0, 0.0)));
        // 15/8 of the mean speed, in the middle.
        assert!((speed - 0.5 * 1.875).abs() < 0.01, "{speed}");
        assert!((time - 0.5).abs() < 0.05, "{time}");
    }

    #[test]
    fn times_that_do_not_increase_and_numbers_that_are_not_finite_are_refused() {
        let motion = steps(&["transfer"]);
        let point = |time_s: f64, position: f64| PointRecord {
            time_s,
            positions: vec![position],
            velocities: vec![0.0],
            accelerations: vec![0.0],
            world_from_tool: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        };
        let make = |points| WipingMotion::new(motion.head.clone(), points).unwrap_err();
        assert!(make(vec![point(0.0, 0.0), point(0.0, 1.0)]).contains("follows"));
        assert!(make(vec![point(0.0, f64::NAN), point(1.0, 1.0)]).contains("finite"));
        assert!(make(vec![point(0.0, 0.0)]).contains("2 or more"));
    }
}
