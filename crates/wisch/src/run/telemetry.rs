//! What a robot measures while it wipes.

use crate::control::Wrench;
use crate::follow::Phase;
use crate::geometry::Pose;
use crate::interpret::TouchSample;

/// What is measured at one instant; arrays have one entry per variable of the robot, in its order,
/// or none: velocities and efforts where an executor does not measure them, all of them in a recording.
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
