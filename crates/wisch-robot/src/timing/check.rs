//! Faults of a timed motion, found from its samples alone.
//!
//! The check does not depend on how motions are timed. Between samples it uses a mean-value theorem
//! instead of interpolation. If a joint keeps its limits at every time, so do the divided
//! differences of its recorded positions and velocities, for any sample period; differences that
//! exceed the limits are faults.

use super::{JointLimits, JointPath, TrajectorySample};
use thiserror::Error;

/// Tolerances beyond which a timed motion counts as faulty; see [`trajectory_faults`].
#[derive(Debug, Clone, PartialEq)]
pub struct TrajectoryCheckConfig {
    /// Largest deviation of a joint from the path's segments, and from a waypoint when passing it [rad or m].
    pub path_deviation: f64,
    /// Relative excess of a velocity or acceleration over its limit that is allowed for rounding \[1\].
    pub relative_tolerance: f64,
    /// Uncertainty of recorded positions [rad or m]; for rounding, and for files with few digits.
    pub position_resolution: f64,
}

impl Default for TrajectoryCheckConfig {
    /// 2 mrad from the path; 10⁻⁶ of a limit, 10⁻¹³ rad of rounding.
    fn default() -> Self {
        Self {
            path_deviation: 2e-3,
            relative_tolerance: 1e-6,
            position_resolution: 1e-13,
        }
    }
}

/// The end of a motion, where it should be at rest on a waypoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionEnd {
    /// The first sample.
    Start,
    /// The last sample.
    Finish,
}

/// A fault of a motion. Samples, waypoints and joints count from 0; values are in rad or m, rad/s or m/s,
/// rad/s² or m/s², by the kind of the joint.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TrajectoryFault {
    /// There are no samples.
    #[error("there are no samples")]
    Empty,
    /// A sample does not have one position, velocity and acceleration per joint.
    #[error("sample {sample} does not have {joints} positions, velocities and accelerations")]
    Shape {
        /// Index of the sample.
        sample: usize,
        /// Number of joints of the path.
        joints: usize,
    },
    /// A number is not finite.
    #[error("sample {sample} contains a number that is not finite")]
    NotFinite {
        /// Index of the sample.
        sample: usize,
    },
    /// Time does not increase.
    #[error("sample {sample}: time {time} s does not come after {before} s")]
    TimeNotIncreasing {
        /// Index of the later sample.
        sample: usize,
        /// Its time \[s\].
        time: f64,
        /// Time of the sample before \[s\].
        before: f64,
    },
    /// A position is outside the joint's range.
    #[error("sample {sample}, joint {joint}: position {value} is outside {lower} to {upper}")]
    Position {
        /// Index of the sample.
        sample: usize,
        /// Index of the joint.
        joint: usize,
        /// Position.
        value: f64,
        /// Lower end of the range.
        lower: f64,
        /// Upper end of the range.
        upper: f64,
    },
    /// A joint exceeds its velocity or acceleration limit.
    #[error("{}", rate.describe(*sample, *joint, *value, *limit))]
    TooFast {
        /// The quantity that exceeds the limit.
        rate: RateKind,
        /// Index of the sample; the earlier or the middle one of several.
        sample: usize,
        /// Index of the joint.
        joint: usize,
        /// Value.
        value: f64,
        /// Limit.
        limit: f64,
    },
    /// Reported velocities do not match the change of positions.
    #[error(
        "joint {joint}: from sample {sample} to the next, the velocities give a step of {value}, the positions a step of {step}"
    )]
    VelocityMismatch {
        /// Index of the earlier sample.
        sample: usize,
        /// Index of the joint.
        joint: usize,
        /// Step by the trapezoid rule over the velocities.
        value: f64,
        /// Step of the positions.
        step: f64,
    },
    /// A joint is not at rest at an end of the motion.
    #[error("joint {joint} is not at rest at the {end:?}: {value}")]
    NotAtRest {
        /// The end.
        end: MotionEnd,
        /// Index of the joint.
        joint: usize,
        /// Velocity.
        value: f64,
    },
    /// The motion does not start at the first or end at the last waypoint.
    #[error("joint {joint} is at {value} at the {end:?} instead of {waypoint}")]
    WrongEnd {
        /// The end.
        end: MotionEnd,
        /// Index of the joint.
        joint: usize,
        /// Position.
        value: f64,
        /// Position of the waypoint.
        waypoint: f64,
    },
    /// A sample is farther from the path than allowed.
    #[error("sample {sample} is farther than {bound} from the path around waypoint {waypoint}")]
    OffPath {
        /// Index of the sample.
        sample: usize,
        /// Last waypoint passed.
        waypoint: usize,
        /// Deviation allowed.
        bound: f64,
    },
    /// A waypoint is not passed, or not in its order.
    #[error("waypoint {waypoint} is never passed within {bound}")]
    WaypointMissed {
        /// Index of the waypoint.
        waypoint: usize,
        /// Deviation allowed.
        bound: f64,
    },
}

impl TrajectoryFault {
    /// Index of the joint of the fault; `None` if it concerns no single joint.
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

/// The quantity by which a joint exceeds its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum RateKind {
    /// The velocity that a sample reports.
    Velocity,
    /// The acceleration that a sample reports.
    Acceleration,
    /// Step of the positions from one sample to the next: too fast, or a jump.
    PositionStep,
    /// Step of the velocities from one sample to the next: too fast, or a jump.
    VelocityStep,
    /// Mean acceleration from the positions of three samples.
    PositionBend,
    /// Velocity against the shortest times of the segments that contain the sample.
    SegmentVelocity,
}

impl RateKind {
    fn describe(self, sample: usize, joint: usize, value: f64, limit: f64) -> String {
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

/// Returns all faults of a motion, in the order of the samples. It is empty if the motion obeys all limits,
/// starts and ends at rest at the path's ends, and follows the path.
///
/// ```
/// use wisch_robot::timing::{
///     TrajectoryCheckConfig, JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, time_path,
///     trajectory_faults,
/// };
/// let path = JointPath::new(&[[0.0], [1.0]])?;
/// let limits = JointLimits::new(vec![JointLimit::arm("elbow", -2.0, 2.0)])?;
/// let trajectory = time_path(&path, &limits, &TimingConfig::default())?;
/// let mut samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
/// assert_eq!(trajectory_faults(&samples, &path, &limits, &TrajectoryCheckConfig::default()), []);
/// samples[500].q[0] += 1e-4;
/// assert_ne!(trajectory_faults(&samples, &path, &limits, &TrajectoryCheckConfig::default()), []);
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
    config: &TrajectoryCheckConfig,
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
        check.check_limits_at(sample, &mut faults);
        check.check_limits_after(sample, &mut faults);
    }
    check.check_ends(&mut faults);
    check.check_path(&mut faults);
    faults
}

/// Returns the faults that prevent any further check.
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
    config: &'a TrajectoryCheckConfig,
}

impl Check<'_> {
    fn exceeds(&self, value: f64, limit: f64, uncertainty: f64) -> bool {
        value.abs() > limit * (1.0 + self.config.relative_tolerance) + uncertainty
    }

    /// Returns the fault of a value beyond its limit; `values` holds both.
    fn too_fast(
        &self,
        rate: RateKind,
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

    /// Checks the limits at a sample.
    fn check_limits_at(&self, sample: usize, faults: &mut Vec<TrajectoryFault>) {
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
            add(RateKind::Velocity, qd, limit.velocity);
            add(RateKind::Acceleration, qdd, limit.acceleration);
        }
    }

    /// Checks the steps from a sample to the next, and to the one after that.
    fn check_limits_after(&self, sample: usize, faults: &mut Vec<TrajectoryFault>) {
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
                RateKind::PositionStep,
                sample,
                joint,
                values,
                resolution / step,
            ));
            let values = [(next.qd[joint] - this.qd[joint]) / step, limit.acceleration];
            faults.extend(self.too_fast(
                RateKind::VelocityStep,
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
                let fault = self.too_fast(
                    RateKind::PositionBend,
                    sample + 1,
                    joint,
                    values,
                    uncertainty,
                );
                faults.extend(fault);
            }
        }
    }

    /// Checks that the motion starts and ends at rest on the ends of the path.
    fn check_ends(&self, faults: &mut Vec<TrajectoryFault>) {
        let last = self.path.waypoint_count() - 1;
        let ends = [
            (MotionEnd::Start, &self.samples[0], 0),
            (
                MotionEnd::Finish,
                &self.samples[self.samples.len() - 1],
                last,
            ),
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

    /// Compares samples and path step by step.
    fn check_path(&self, faults: &mut Vec<TrajectoryFault>) {
        let bound = self.config.path_deviation;
        let last = self.path.waypoint_count() - 1;
        // The motion may be on the segments from `rear` to the one after waypoint `front`.
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
                    self.check_segment_speeds(sample, self.round_corners(first, last), faults);
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

    /// Returns the segments between two places, each as a segment and the share of it, with the segments that a
    /// rounded corner at either place reaches.
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

    /// Checks velocities against the shortest times of the segments that may contain a sample.
    fn check_segment_speeds(
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
                RateKind::SegmentVelocity,
                sample,
                joint,
                [value, limit],
                slack,
            ));
        }
    }
}

/// Returns the share of a chord at which no joint is farther than `near` from a point; `None` if there is none.
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
    // The distance is convex along the chord: a ternary search converges to its minimum.
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

/// Number of steps of the ternary search. Each leaves two thirds; 60 steps leave 3·10⁻¹¹ of the chord.
const CHORD_SEARCH_STEPS: usize = 60;

/// Waypoints nearer than this share of the deviation may count as one, which lengthens segments by it at both
/// ends.
const NEAR_SHARE: f64 = 0.1;

/// A rounded corner reaches at most half a segment, and a little more where near waypoints count as one.
const CORNER_REACH: f64 = 0.6;
