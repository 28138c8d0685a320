//! What an executor is given: a motion, with all that a robot's driver needs of it.

use super::{Ending, Execution, SampleSink, TelemetrySample};
use crate::follow::{Followed, Phase, Workcell};
use crate::geometry::Pose;
use crate::interpret::TouchSample;
use crate::represent::Task;

/// A motion that is to be executed, with all that a robot's driver needs of it.
#[derive(Debug, Clone, Copy)]
pub struct MotionOrder<'a> {
    /// The round, from 1.
    pub round: usize,
    /// Seed for what is random in a simulated world; a real one has no use for it.
    pub seed: u64,
    /// Surface, scene and tool as they are believed to be; its interaction has the press force [N], the stiffness
    /// along the normal [N/m] and the damping ratio that the controller is to keep.
    pub task: &'a Task,
    /// The robot with the tool in its hand.
    pub cell: &'a Workcell,
    /// Joint trajectories, the tool's path and the phases, one motion after the other.
    pub followed: &'a Followed,
}

/// Where joints and tool shall be at one instant, without the press into the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Setpoint {
    /// Time since the start [s].
    pub time: f64,
    /// All n variables of the robot [rad or m].
    pub positions: Vec<f64>,
    /// Their velocities [rad/s or m/s].
    pub velocities: Vec<f64>,
    /// Where the tool shall be.
    pub world_from_tool: Pose,
    /// Index of the motion in [`Followed::motions`].
    pub motion: usize,
    /// What that motion is for.
    pub phase: Phase,
}

impl MotionOrder<'_> {
    /// The motion that runs at a time [s], by its index, and what it is for; `None` if nothing moves.
    pub fn motion_at(&self, time: f64) -> Option<(usize, Phase)> {
        let motions = &self.followed.motions;
        let next = motions.partition_point(|motion| motion.start <= time);
        let index = next.saturating_sub(1);
        Some((index, motions.get(index)?.phase))
    }

    /// Where joints and tool shall be at a time [s]; `None` if nothing moves.
    pub fn setpoint(&self, time: f64) -> Option<Setpoint> {
        let (motion, phase) = self.motion_at(time)?;
        let sample = self.followed.sample(time)?;
        let kinematics = self.cell.robot().forward_kinematics(&sample.q).ok()?;
        let root_from_tip = kinematics.world_from_link(self.cell.tip());
        Some(Setpoint {
            time,
            world_from_tool: self.cell.world_from_root()
                * root_from_tip
                * self.cell.tip_from_tool(),
            positions: sample.q,
            velocities: sample.qd,
            motion,
            phase,
        })
    }

    /// Setpoints at this period [s], from the start to the end, which is the last; none if nothing moves.
    pub fn setpoints(&self, period: f64) -> impl Iterator<Item = Setpoint> {
        let duration = self.followed.duration();
        let count = (duration / period).ceil() as usize + 1;
        (0..count).filter_map(move |k| self.setpoint((k as f64 * period).min(duration)))
    }

    /// Goes through the setpoints at this period [s], hands on what is measured at each, and stops when the sink
    /// says so.
    pub fn play(
        &self,
        period: f64,
        sink: &mut SampleSink<'_>,
        mut measure: impl FnMut(&Setpoint) -> TouchSample,
    ) -> Execution {
        let mut execution = Execution::at_rest(self.cell.ready());
        for at in self.setpoints(period) {
            let sample = TelemetrySample::of_touch(&measure(&at), at.motion, at.phase);
            let flow = sink(&sample);
            (execution.duration, execution.positions) = (at.time, at.positions);
            if flow.is_break() {
                execution.ending = Ending::Stopped;
                break;
            }
        }
        execution
    }
}
