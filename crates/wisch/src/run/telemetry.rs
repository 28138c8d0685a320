//! What a robot measures while it wipes.

use crate::control::Wrench;
use crate::follow::Phase;
use crate::geometry::Pose;
use crate::interpret::TouchSample;

/// What is measured at one instant; arrays have one entry per variable of the robot, in its order,
/// or none: velocities and efforts where an executor does not measure them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TelemetrySample<'a> {
    /// Time since the start [s].
    pub time: f64,
    /// Positions [rad or m].
    pub positions: &'a [f64],
    /// Velocities [rad/s or m/s].
    pub velocities: &'a [f64],
    /// Efforts of the drives [Nm or N].
    pub efforts: &'a [f64],
    /// Where the tool was told to be, the press into the surface included.
    pub world_from_commanded: Pose,
    /// Where the tool is, by the joints' positions.
    pub world_from_tool: Pose,
    /// f_c: what the controller asks of the tool, saturated (8).
    pub controller: Wrench,
    /// f_ext: what the surroundings do to the tool, as estimated from the drives' efforts.
    pub external: Wrench,
    /// Index of the motion in [`Followed::motions`](crate::follow::Followed).
    pub motion: usize,
    /// What that motion is for.
    pub phase: Phase,
}

impl TelemetrySample<'_> {
    /// A sample of who measures nothing but a tool's pose and the force on it: where the tool was told to be, is where
    /// it is.
    pub fn of_touch(touch: &TouchSample, motion: usize, phase: Phase) -> Self {
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
        }
    }
}

/// A sample that is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedSample {
    /// Time since the start [s].
    pub time: f64,
    /// Positions, velocities and efforts, one list after the other [rad or m, rad/s or m/s, Nm or N].
    pub joints: Vec<f64>,
    /// How many numbers each of these lists has.
    pub counts: [usize; 3],
    /// Where the tool was told to be.
    pub world_from_commanded: Pose,
    /// Where it was.
    pub world_from_tool: Pose,
    /// What the controller asked of it.
    pub controller: Wrench,
    /// What the surroundings did to it.
    pub external: Wrench,
}

impl RecordedSample {
    /// The sample, taken in a motion for a purpose; `None` where the counts are not those of the joints' numbers.
    pub fn during(&self, motion: usize, phase: Phase) -> Option<TelemetrySample<'_>> {
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
        }
    }
}
