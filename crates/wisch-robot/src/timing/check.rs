//! Faults of a timed motion, seen from its samples alone.
//!
//! Nothing here knows how motions are timed. Between samples a mean-value theorem stands in for
//! interpolation: if a joint obeys its limits at every time, then so do the divided differences of its
//! recorded positions and velocities, whatever the sample period; those that do not are faults.

use super::{JointLimits, JointPath, TrajectorySample};
use thiserror::Error;

/// Tolerances beyond which a timed motion counts as faulty; see [`trajectory_faults`].
#[derive(Debug, Clone, PartialEq)]
pub struct CheckConfig {
    /// How far a joint may deviate from the path's segments, and from a waypoint when passing it [rad or m].
    pub path_deviation: f64,
    /// How far a velocity or acceleration may exceed its limit, relative to it; for rounding.
    pub relative_tolerance: f64,
    /// How uncertain recorded positions are [rad or m]; for rounding, and for files with few digits.
    pub position_resolution: f64,
}

impl Default for CheckConfig {
    /// 2 mrad from the path; 10⁻⁶ of a limit, 10⁻¹³ rad of rounding.
    fn default() -> Self {
        Self {
            path_deviation: 2e-3,
            relative_tolerance: 1e-6,
            position_resolution: 1e-13,
        }
    }
}

/// The end of a motion at which it should be at rest on a waypoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The first sample.
    Start,
    /// The last sample.
    Finish,
}

/// A way in which a motion is wrong. Samples, waypoints and joints count from 0; values are in rad or m,
/// rad/s or m/s, rad/s² or m/s², as the joint's.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TrajectoryFault {
    /// There is nothing to check.
    #[error("there are no samples")]
    Empty,
    /// A sample does not have one position, velocity and acceleration per joint.
    #[error("sample {sample} does not have {joints} positions, velocities and accelerations")]
    Shape {
        /// The sample.
        sample: usize,
        /// How many joints the path has.
        joints: usize,
    },
    /// A number is not finite.
    #[error("sample {sample} contains a number that is not finite")]
    NotFinite {
        /// The sample.
        sample: usize,
    },
    /// Time does not increase.
    #[error("sample {sample}: time {time} s does not come after {before} s")]
    TimeNotIncreasing {
        /// The later sample.
        sample: usize,
        /// Its time [s].
        time: f64,
        /// The time of the sample before [s].
        before: f64,
    },
    /// A position is outside the joint's range.
    #[error("sample {sample}, joint {joint}: position {value} is outside {lower} to {upper}")]
    Position {
        /// The sample.
        sample: usize,
        /// The joint.
        joint: usize,
        /// Its position.
        value: f64,
        /// The range's lower end.
        lower: f64,
        /// The range's upper end.
        upper: f64,
    },
    /// A joint is faster than its limit.
    #[error("{}", rate.told(*sample, *joint, *value, *limit))]
    TooFast {
        /// In what way.
        rate: Rate,
        /// The sample; the earlier or the middle one of several.
        sample: usize,
        /// The joint.
        joint: usize,
        /// What it does.
        value: f64,
        /// The limit.
        limit: f64,
    },
    /// Reported velocities are not the rate at which positions change.
    #[error(
        "joint {joint}: velocities say {value} from sample {sample} to the next, positions {step}"
    )]
    VelocityMismatch {
        /// The earlier sample.
        sample: usize,
        /// The joint.
        joint: usize,
        /// Way by the trapezoid rule over the velocities.
        value: f64,
        /// Way by the positions.
        step: f64,
    },
    /// A joint moves at an end.
    #[error("joint {joint} is not at rest at the {end:?}: {value}")]
    NotAtRest {
        /// Which end.
        end: End,
        /// The joint.
        joint: usize,
        /// Its velocity.
        value: f64,
    },
    /// The motion does not start at the first or end at the last waypoint.
    #[error("joint {joint} is at {value} at the {end:?} instead of {waypoint}")]
    WrongEnd {
        /// Which end.
        end: End,
        /// The joint.
        joint: usize,
        /// Its position.
        value: f64,
        /// Where the waypoint is.
        waypoint: f64,
    },
    /// A sample is further from the path than allowed.
    #[error("sample {sample} is further than {bound} from the path around waypoint {waypoint}")]
    OffPath {
        /// The sample.
        sample: usize,
        /// The last waypoint passed.
        waypoint: usize,
        /// The deviation allowed.
        bound: f64,
    },
    /// A waypoint is not passed, or not in order.
    #[error("waypoint {waypoint} is never within {bound}")]
    WaypointMissed {
        /// The waypoint.
        waypoint: usize,
        /// The deviation allowed.
        bound: f64,
    },
}

impl TrajectoryFault {
    /// The number of the joint whose fault it is; `None` if it is not one joint's.
    pub const fn joint(&self) -> Option<usize> {
        match self {
            Self::Position { joint, .. }
            | Self::TooFast { joint, .. }
            | Self::VelocityMismatch { joint, .. }
            | Self::NotAtRest { joint, .. }
            | Self::WrongEnd { joint, .. } => Some(*joint),
            Self::Empty
            | Self::Shape { .. }
            | Self::NotFinite { .. }
            | Self::TimeNotIncreasing { .. }
            | Self::OffPath { .. }
            | Self::WaypointMissed { .. } => None,
        }
    }
}

/// In what way a joint is too fast.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rate {
    /// The velocity that a sample reports.
    Velocity,
    /// The acceleration that a sample reports.
    Acceleration,
    /// Positions from one sample to the next: too fast there, or a jump.
    PositionStep,
    /// Velocities from one sample to the next: too fast, or a jump.
    VelocityStep,
    /// Mean acceleration by the positions of three samples.
    PositionBend,
    /// The velocity against the shortest times of the segments that the sample may be on.
    SegmentVelocity,
}

impl Rate {
    fn told(self, sample: usize, joint: usize, value: f64, limit: f64) -> String {
        let exceeds = |what: &str, whose: &str| {
            format!("sample {sample}, joint {joint}: {what} {value} exceeds {limit}{whose}")
        };
        let step = |moves: &str| {
            format!(
                "joint {joint} {moves} at {value} from sample {sample} to the next; the limit is {limit}"
            )
        };
        match self {
            Self::Velocity => exceeds("velocity", ""),
            Self::Acceleration => exceeds("acceleration", ""),
            Self::PositionStep => step("moves"),
            Self::VelocityStep => step("accelerates"),
            Self::PositionBend => format!(
                "joint {joint}: positions around sample {sample} accelerate at {value}; the limit is {limit}"
            ),
            Self::SegmentVelocity => exceeds("velocity", ", the segment's"),
        }
    }
}

/// Everything that is wrong with a motion, in order of the samples; empty if it obeys all limits, starts and
/// ends at rest at the path's ends, and follows the path.
///
/// ```
/// use wisch_robot::timing::{
///     CheckConfig, JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, time_path,
///     trajectory_faults,
/// };
/// let path = JointPath::new(&[[0.0], [1.0]])?;
/// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
/// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
/// let mut samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
/// assert_eq!(trajectory_faults(&samples, &path, &limits, &CheckConfig::default()), []);
/// samples[500].q[0] += 1e-4;
/// assert_ne!(trajectory_faults(&samples, &path, &limits, &CheckConfig::default()), []);
/// # Ok::<(), wisch_robot::timing::TimingError>(())
/// ```
///
/// # Panics
///
/// If path and limits have different numbers of joints.
pub fn trajectory_faults(
    samples: &[TrajectorySample],
    path: &JointPath,
    limits: &JointLimits,
    config: &CheckConfig,
) -> Vec<TrajectoryFault> {
    let joints = path.joint_count();
    assert_eq!(limits.joints().len(), joints, "limits of another robot");
    let faults = shape_faults(samples, joints);
    if !faults.is_empty() {
        return faults;
    }
    let check = Check {
        samples,
        path,
        limits,
        config,
    };
    let mut faults = Vec::new();
    for sample in 0..samples.len() {
        check.limits_at(sample, &mut faults);
        check.limits_after(sample, &mut faults);
    }
    check.ends(&mut faults);
    check.way(&mut faults);
    faults
}

/// Faults that leave nothing to compute with.
fn shape_faults(samples: &[TrajectorySample], joints: usize) -> Vec<TrajectoryFault> {
    let mut faults = Vec::new();
    if samples.is_empty() {
        faults.push(TrajectoryFault::Empty);
    }
    for (sample, state) in samples.iter().enumerate() {
        let rows = [&state.q, &state.qd, &state.qdd];
        if rows.iter().any(|row| row.len() != joints) {
            faults.push(TrajectoryFault::Shape { sample, joints });
        }
        let numbers = rows.into_iter().flatten().chain([&state.time]);
        if numbers.into_iter().any(|number| !number.is_finite()) {
            faults.push(TrajectoryFault::NotFinite { sample });
        }
        if sample > 0 && state.time <= samples[sample - 1].time {
            faults.push(TrajectoryFault::TimeNotIncreasing {
                sample,
                time: state.time,
                before: samples[sample - 1].time,
            });
        }
    }
    faults
}

struct Check<'a> {
    samples: &'a [TrajectorySample],
    path: &'a JointPath,
    limits: &'a JointLimits,
    config: &'a CheckConfig,
}

impl Check<'_> {
    fn exceeds(&self, value: f64, limit: f64, uncertainty: f64) -> bool {
        value.abs() > limit * (1.0 + self.config.relative_tolerance) + uncertainty
    }

    /// The fault of a value that exceeds its limit, the two of `values`.
    fn too_fast(
        &self,
        rate: Rate,
        sample: usize,
        joint: usize,
        [value, limit]: [f64; 2],
        uncertainty: f64,
    ) -> Option<TrajectoryFault> {
        (self.exceeds(value, limit, uncertainty)).then_some(TrajectoryFault::TooFast {
            rate,
            sample,
            joint,
            value,
            limit,
        })
    }

    fn limits_at(&self, sample: usize, faults: &mut Vec<TrajectoryFault>) {
        let state = &self.samples[sample];
        for (joint, limit) in self.limits.joints().iter().enumerate() {
            let (q, qd, qdd) = (state.q[joint], state.qd[joint], state.qdd[joint]);
            let slack = self.config.position_resolution;
            if q < limit.lower - slack || q > limit.upper + slack {
                faults.push(TrajectoryFault::Position {
                    sample,
                    joint,
                    value: q,
                    lower: limit.lower,
                    upper: limit.upper,
                });
            }
            let mut add = |rate, value, limit| {
                faults.extend(self.too_fast(rate, sample, joint, [value, limit], 0.0));
            };
            add(Rate::Velocity, qd, limit.velocity);
            add(Rate::Acceleration, qdd, limit.acceleration);
        }
    }

    /// Between a sample and the next, and over the one after that.
    fn limits_after(&self, sample: usize, faults: &mut Vec<TrajectoryFault>) {
        let Some(next) = self.samples.get(sample + 1) else {
            return;
        };
        let this = &self.samples[sample];
        let step = next.time - this.time;
        for (joint, limit) in self.limits.joints().iter().enumerate() {
            let resolution = 2.0 * self.config.position_resolution * this.q[joint].abs().max(1.0);
            let way = next.q[joint] - this.q[joint];
            let velocity = way / step;
            let values = [velocity, limit.velocity];
            faults.extend(self.too_fast(
                Rate::PositionStep,
                sample,
                joint,
                values,
                resolution / step,
            ));
            let values = [(next.qd[joint] - this.qd[joint]) / step, limit.acceleration];
            faults.extend(self.too_fast(
                Rate::VelocityStep,
                sample,
                joint,
                values,
                resolution / step,
            ));
            // With accelerations of at most a, the trapezoid rule errs by at most a·step²/4.
            let trapezoid = 0.5 * step * (this.qd[joint] + next.qd[joint]);
            let error = 0.25 * limit.acceleration * step * step;
            if self.exceeds(trapezoid - way, error, resolution) {
                faults.push(TrajectoryFault::VelocityMismatch {
                    sample,
                    joint,
                    value: trapezoid,
                    step: way,
                });
            }
            if let Some(after) = self.samples.get(sample + 2) {
                let second_step = after.time - next.time;
                let second = (after.q[joint] - next.q[joint]) / second_step;
                let mean_step = 0.5 * (step + second_step);
                let bend = (second - velocity) / mean_step;
                let uncertainty = 2.0 * resolution / (mean_step * step.min(second_step));
                let values = [bend, limit.acceleration];
                let fault =
                    self.too_fast(Rate::PositionBend, sample + 1, joint, values, uncertainty);
                faults.extend(fault);
            }
        }
    }

    fn ends(&self, faults: &mut Vec<TrajectoryFault>) {
        let last = self.path.waypoint_count() - 1;
        let ends = [
            (End::Start, &self.samples[0], 0),
            (End::Finish, &self.samples[self.samples.len() - 1], last),
        ];
        for (end, state, waypoint) in ends {
            for (joint, &waypoint) in self.path.waypoint(waypoint).iter().enumerate() {
                if state.qd[joint].abs() > self.config.relative_tolerance {
                    faults.push(TrajectoryFault::NotAtRest {
                        end,
                        joint,
                        value: state.qd[joint],
                    });
                }
                let resolution = self.config.position_resolution * waypoint.abs().max(1.0);
                if (state.q[joint] - waypoint).abs() > resolution {
                    faults.push(TrajectoryFault::WrongEnd {
                        end,
                        joint,
                        value: state.q[joint],
                        waypoint,
                    });
                }
            }
        }
    }

    /// Walks along samples and path together.
    fn way(&self, faults: &mut Vec<TrajectoryFault>) {
        let bound = self.config.path_deviation;
        let last = self.path.waypoint_count() - 1;
        // The segments that the motion may be on: from `rear` to the one after waypoint `front`.
        let (mut rear, mut front) = (0, 0);
        let mut before = &self.samples[0];
        for (sample, state) in self.samples.iter().enumerate() {
            // Between samples the motion is off their chord by at most a·step²/8.
            let step = state.time - before.time;
            let joints = self.limits.joints().iter();
            let bow =
                joints.map(|joint| joint.acceleration).fold(0.0, f64::max) * step * step / 8.0;
            let near = bound * (1.0 + self.config.relative_tolerance) + bow;
            while front < last
                && meeting(self.path.waypoint(front + 1), &before.q, &state.q, near).is_some()
            {
                front += 1;
            }
            let on = |segment: usize| {
                let ends = (self.path.waypoint(segment), self.path.waypoint(segment + 1));
                meeting(&state.q, ends.0, ends.1, near).map(|share| (segment, share))
            };
            let foremost = front.min(last - 1);
            match (rear..=foremost).find_map(on) {
                Some(first) => {
                    rear = first.0;
                    let last = (rear..=foremost).rev().find_map(on).unwrap_or(first);
                    self.segment_speeds(sample, self.round_corners(first, last), faults);
                }
                None => faults.push(TrajectoryFault::OffPath {
                    sample,
                    waypoint: front,
                    bound,
                }),
            }
            before = state;
        }
        if front < last {
            faults.push(TrajectoryFault::WaypointMissed {
                waypoint: front + 1,
                bound,
            });
        }
    }

    /// The segments between two places, each a segment and the share of it, and those that a rounded corner at
    /// either place leads to.
    fn round_corners(
        &self,
        first: (usize, f64),
        last: (usize, f64),
    ) -> std::ops::RangeInclusive<usize> {
        let is_short = |segment: usize| {
            let to = self.path.waypoint(segment + 1).iter();
            let mut joints = self.path.waypoint(segment).iter().zip(to);
            joints.all(|(a, b)| (a - b).abs() <= self.config.path_deviation)
        };
        let end = self.path.waypoint_count() - 2;
        let (mut from, mut to) = (first.0, last.0);
        if first.1 <= CORNER_REACH || is_short(first.0) {
            from = (0..from).rev().find(|&s| !is_short(s)).unwrap_or(0);
        }
        if last.1 >= 1.0 - CORNER_REACH || is_short(last.0) {
            to = (to + 1..=end).find(|&s| !is_short(s)).unwrap_or(end);
        }
        from..=to
    }

    /// Velocities against the shortest times of the segments that a sample may lie on.
    fn segment_speeds(
        &self,
        sample: usize,
        segments: impl Iterator<Item = usize>,
        faults: &mut Vec<TrajectoryFault>,
    ) {
        let mut allowed = vec![0.0_f64; self.path.joint_count()];
        for segment in segments {
            let time = self.path.segment_times()[segment];
            if time == 0.0 {
                return;
            }
            let ends = self.path.waypoint(segment).iter();
            let ends = ends.zip(self.path.waypoint(segment + 1));
            let uncertainty = 2.0 * NEAR_SHARE * self.config.path_deviation;
            for (most, (from, to)) in allowed.iter_mut().zip(ends) {
                *most = most.max(((to - from).abs() + uncertainty) / time);
            }
        }
        for (joint, (&value, &limit)) in self.samples[sample].qd.iter().zip(&allowed).enumerate() {
            let slack = self.config.relative_tolerance;
            faults.extend(self.too_fast(
                Rate::SegmentVelocity,
                sample,
                joint,
                [value, limit],
                slack,
            ));
        }
    }
}

/// Where on a chord, as a share of it, no joint is further than `near` from a point; `None` if nowhere.
fn meeting(point: &[f64], from: &[f64], to: &[f64], near: f64) -> Option<f64> {
    let mut joints = from.iter().zip(to).zip(point);
    if joints.any(|((a, b), p)| *p < a.min(*b) - near || *p > a.max(*b) + near) {
        return None;
    }
    let at = |share: f64| {
        let joints = from.iter().zip(to).zip(point);
        joints
            .map(|((a, b), p)| (a + share * (b - a) - p).abs())
            .fold(0.0, f64::max)
    };
    if let Some(end) = [0.0, 1.0].into_iter().find(|&end| at(end) <= near) {
        return Some(end);
    }
    // The difference is convex along the chord: a search by thirds closes in on its least value.
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..CHORD_SEARCH_STEPS {
        let middle = 0.5 * (low + high);
        if at(middle) <= near {
            return Some(middle);
        }
        let third = (high - low) / 3.0;
        if at(low + third) <= at(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    None
}

/// Each step of the search leaves two thirds; 60 of them leave 3·10⁻¹¹ of the chord.
const CHORD_SEARCH_STEPS: usize = 60;

/// Waypoints nearer than this share of the deviation may count as one, which lengthens segments by it at
/// both ends.
const NEAR_SHARE: f64 = 0.1;

/// A rounded corner reaches no further than half a segment, and a little more where near waypoints count as
/// one.
const CORNER_REACH: f64 = 0.6;
