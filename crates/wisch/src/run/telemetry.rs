//! The measurements of a robot while it wipes.

use crate::control::Wrench;
use crate::follow::Phase;
use crate::geometry::Pose;
use crate::interpret::{TouchSample, WrenchQuality};

/// The measurements of one instant. Arrays have one entry per variable of the robot, in its order; velocities
/// and efforts are empty where an executor does not measure them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TelemetrySample<'a> {
    /// Time since the start \[s\].
    pub time: f64,
    /// Positions [rad or m].
    pub positions: &'a [f64],
    /// Velocities [rad/s or m/s].
    pub velocities: &'a [f64],
    /// Efforts of the drives [Nm or N].
    pub efforts: &'a [f64],
    /// Commanded pose of the tool, the press into the surface included.
    pub world_from_commanded: Pose,
    /// Pose of the tool by forward kinematics of the measured joints.
    pub world_from_tool: Pose,
    /// f_c: the controller's wrench on the tool, saturated (8).
    pub controller: Wrench,
    /// f_ext: external wrench on the tool, estimated from the drives' efforts.
    pub external: Wrench,
    /// Index of the motion in [`Followed::motions`](crate::follow::Followed).
    pub motion: usize,
    /// Purpose of that motion.
    pub phase: Phase,
    /// Statements of the driver about the sample.
    pub status: SampleStatus,
}

/// Statements of a driver about a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SampleStatus {
    /// Time of the measurement on the driver's clock \[ns\]; `None` if it is not stated.
    pub stamp: Option<Stamp>,
    /// Quality of the external wrench; only a usable one counts as touch.
    pub wrench: WrenchQuality,
    /// Whether the motion is paused.
    pub is_paused: bool,
}

impl SampleStatus {
    /// Whether the sample shows what the motion does: it is not paused, and the wrench is usable.
    pub fn shows_motion(&self) -> bool {
        !self.is_paused && self.wrench.is_usable()
    }
}

/// Time of a measurement on a named clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stamp {
    /// Nanoseconds since the origin of the clock.
    pub nanoseconds: u64,
    /// The clock.
    pub clock: StampClock,
}

/// The clock that a [`Stamp`] was read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StampClock {
    /// Time since 1970, UTC.
    Epoch,
    /// Time of the robot's or the sensor's own clock.
    Device,
}

impl StampClock {
    /// Both clocks, in the order of the variants.
    pub const ALL: [Self; 2] = [Self::Epoch, Self::Device];

    /// Name of the clock, as files and messages have it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Epoch => "epoch",
            Self::Device => "device",
        }
    }
}

impl TelemetrySample<'_> {
    /// Returns the sample of a device that measures only the tool's pose and the force on it; the commanded
    /// pose is the measured pose.
    ///
    /// ```
    /// use wisch::follow::Phase;
    /// use wisch::geometry::{Pose, Vector3};
    /// use wisch::interpret::TouchSample;
    /// use wisch::run::TelemetrySample;
    /// let touch = TouchSample::new(0.0, Pose::identity(), Vector3::new(0.0, 0.0, 10.0));
    /// let sample = TelemetrySample::from_touch(&touch, 0, Phase::Wipe(0));
    /// assert_eq!(sample.external.force.z, 10.0);
    /// assert!(sample.positions.is_empty());
    /// ```
    pub fn from_touch(touch: &TouchSample, motion: usize, phase: Phase) -> Self {
        Self {
            time: touch.time,
            positions: &[],
            velocities: &[],
            efforts: &[],
            world_from_commanded: touch.world_from_tool,
            world_from_tool: touch.world_from_tool,
            controller: Wrench::default(),
            external: Wrench {
                force: touch.force,
                ..Wrench::default()
            },
            motion,
            phase,
            status: SampleStatus::default(),
        }
    }
}

/// A sample of an execution that owns its data, to store and replay it.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedSample {
    /// Time since the start \[s\].
    pub time: f64,
    /// Positions, velocities and efforts, one list after the other [rad or m, rad/s or m/s, Nm or N].
    pub joints: Vec<f64>,
    /// Number of entries in each of these lists.
    pub counts: [usize; 3],
    /// Commanded pose of the tool.
    pub world_from_commanded: Pose,
    /// Measured pose of the tool.
    pub world_from_tool: Pose,
    /// The controller's wrench.
    pub controller: Wrench,
    /// External wrench.
    pub external: Wrench,
    /// Statements of the driver about the sample.
    pub status: SampleStatus,
}

impl RecordedSample {
    /// Returns the sample with its motion and phase; `None` if `counts` does not match the number of entries in
    /// `joints`.
    pub fn to_sample(&self, motion: usize, phase: Phase) -> Option<TelemetrySample<'_>> {
        let [positions, velocities, efforts] = self.counts;
        let (measured, last) = self.joints.split_at_checked(positions + velocities)?;
        let (positions, velocities) = measured.split_at(positions);
        (last.len() == efforts).then_some(TelemetrySample {
            time: self.time,
            positions,
            velocities,
            efforts: last,
            world_from_commanded: self.world_from_commanded,
            world_from_tool: self.world_from_tool,
            controller: self.controller,
            external: self.external,
            motion,
            phase,
            status: self.status,
        })
    }
}

impl From<&TelemetrySample<'_>> for RecordedSample {
    fn from(sample: &TelemetrySample<'_>) -> Self {
        let lists = [sample.positions, sample.velocities, sample.efforts];
        Self {
            time: sample.time,
            joints: lists.concat(),
            counts: lists.map(<[f64]>::len),
            world_from_commanded: sample.world_from_commanded,
            world_from_tool: sample.world_from_tool,
            controller: sample.controller,
            external: sample.external,
            status: sample.status,
        }
    }
}
