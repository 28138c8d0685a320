//! A motion as evenly spaced frames.

use super::input::MotionInput;
use wisch::follow::TrajectorySample;
use wisch::geometry::{Point3, Pose};
use wisch::robot::LinkId;

/// Frames per second, and maximum number of frames of a motion.
pub(crate) const RATE: f64 = 40.0;
pub(crate) const MAX_FRAMES: usize = 4_000;

/// Positions of all variables at 0, p, 2p, … since the first sample.
pub(crate) struct SampledMotion {
    /// Time of the first frame [s].
    pub(crate) start: f64,
    /// Time between frames, p [s].
    pub(crate) period: f64,
    /// The n positions of each frame [rad or m].
    pub(crate) q: Vec<Vec<f64>>,
}

impl SampledMotion {
    /// Samples a motion with linear interpolation.
    pub(crate) fn new(input: &MotionInput) -> Self {
        Self::within(input, MAX_FRAMES)
    }

    /// Returns the motion in at most the given number of frames, and at least two.
    pub(crate) fn within(input: &MotionInput, most: usize) -> Self {
        let samples = select_usable(input);
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            return Self {
                start: 0.0,
                period: 1.0,
                q: Vec::new(),
            };
        };
        let duration = last.time - first.time;
        // The duration is untrusted input and may be huge, so the conversion saturates.
        let intervals = ((duration * RATE).ceil() as usize).clamp(1, most.max(2) - 1);
        let period = duration / intervals as f64;
        let frame = |k: usize| interpolate(&samples, first.time + k as f64 * period);
        let count = if duration > 0.0 { intervals + 1 } else { 1 };
        Self {
            start: first.time,
            period: if duration > 0.0 { period } else { 1.0 },
            q: (0..count).map(frame).collect(),
        }
    }

    /// Returns the time of a frame [s].
    pub(crate) fn time(&self, frame: usize) -> f64 {
        self.start + frame as f64 * self.period
    }

    /// Returns the position of a point of a link in the world, for every frame [m].
    pub(crate) fn path(&self, input: &MotionInput, link: LinkId, in_link: Point3) -> Vec<Point3> {
        let poses = self
            .q
            .iter()
            .filter_map(|q| world_from_link(input, q, link));
        poses
            .map(|world_from_link| world_from_link * in_link)
            .collect()
    }
}

/// Selects the samples with valid positions: one finite value per variable, and later than the sample before.
fn select_usable<'a>(input: &MotionInput<'a>) -> Vec<&'a TrajectorySample> {
    let mut usable: Vec<&TrajectorySample> = Vec::with_capacity(input.samples.len());
    for sample in input.samples {
        let later = usable.last().is_none_or(|before| sample.time > before.time);
        if sample.time.is_finite() && later && has_valid_values(input, &sample.q) {
            usable.push(sample);
        }
    }
    usable
}

/// Selects the samples with valid positions and velocities.
pub(crate) fn with_velocities<'a>(input: &MotionInput<'a>) -> Vec<&'a TrajectorySample> {
    let mut samples = select_usable(input);
    samples.retain(|sample| has_valid_values(input, &sample.qd));
    samples
}

/// Whether `values` has one finite number per variable of the robot.
fn has_valid_values(input: &MotionInput, values: &[f64]) -> bool {
    values.len() == input.robot.dof() && values.iter().all(|value| value.is_finite())
}

/// Interpolates positions at a time; clamps to the first and the last sample.
fn interpolate(samples: &[&TrajectorySample], time: f64) -> Vec<f64> {
    let next = samples.partition_point(|sample| sample.time <= time);
    let (from, to) = (
        samples[next.saturating_sub(1)],
        samples[next.min(samples.len() - 1)],
    );
    let span = to.time - from.time;
    let share = if span > 0.0 {
        ((time - from.time) / span).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let pairs = from.q.iter().zip(&to.q);
    pairs.map(|(a, b)| a + share * (b - a)).collect()
}

/// Returns the pose of a link in the world.
pub(crate) fn world_from_link(input: &MotionInput, q: &[f64], link: LinkId) -> Option<Pose> {
    let kinematics = input.robot.forward_kinematics(q).ok()?;
    Some(input.world_from_root * kinematics.world_from_link(link))
}
