//! The order to an executor: a motion, with all data that a robot's driver needs.

use super::knots::knot_times;
use super::{Ending, Execution, SampleSink, TelemetrySample};
use crate::follow::{Followed, Phase, Workcell};
use crate::geometry::Pose;
use crate::interpret::TouchSample;
use crate::represent::Task;

/// Rounding error of a number of periods [1].
const ROUNDING: f64 = 1e-9;

/// A motion to execute, with all data that a robot's driver needs.
///
/// ```
/// use wisch::interpret::TouchSample;
/// use wisch::run::{Execution, MotionOrder, SampleSink};
///
/// /// Reports a motion as executed exactly, every 10 ms.
/// fn echo(order: &MotionOrder<'_>, sink: &mut SampleSink<'_>) -> Execution {
///     order.play(0.01, sink, |at| {
///         let force = order.task.surface_reaction() * f64::from(at.phase.is_contact());
///         TouchSample::new(at.time, at.world_from_tool, force)
///     })
/// }
/// ```
#[derive(Debug, Clone, Copy)]
pub struct MotionOrder<'a> {
    /// The round, from 1.
    pub round: usize,
    /// Seed for the random numbers of a simulated world; a real robot ignores it.
    pub seed: u64,
    /// Estimated surface, scene and tool. `task.interaction` holds the press force \[N\], the stiffness along the
    /// normal [N/m] and the damping ratio for the controller.
    pub task: &'a Task,
    /// The robot with the tool in its hand.
    pub cell: &'a Workcell,
    /// Joint trajectories, the tool's path and the phases, one motion after the other.
    pub followed: &'a Followed,
}

/// Desired state of joints and tool at one instant, without the press into the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Setpoint {
    /// Time since the start \[s\].
    pub time: f64,
    /// All n variables of the robot [rad or m].
    pub positions: Vec<f64>,
    /// Their velocities [rad/s or m/s].
    pub velocities: Vec<f64>,
    /// Their accelerations [rad/s² or m/s²].
    pub accelerations: Vec<f64>,
    /// Desired pose of the tool.
    pub world_from_tool: Pose,
    /// Index of the motion in [`Followed::motions`].
    pub motion: usize,
    /// Purpose of that motion.
    pub phase: Phase,
}

impl MotionOrder<'_> {
    /// Returns the index and the phase of the motion at a time \[s\]; `None` for an empty motion.
    pub fn motion_at(&self, time: f64) -> Option<(usize, Phase)> {
        let index = self.followed.index_at(time);
        Some((index, self.followed.motions.get(index)?.phase))
    }

    /// Returns the desired state at a time \[s\]; `None` for an empty motion.
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
            accelerations: sample.qdd,
            motion,
            phase,
        })
    }

    /// Returns the setpoints at this period \[s\], from the start to the end of the motion, both
    /// included; none for an empty motion.
    pub fn setpoints(&self, period: f64) -> impl Iterator<Item = Setpoint> {
        period_times(self.followed.duration(), period).filter_map(|time| self.setpoint(time))
    }

    /// Returns setpoints between which a quintic polynomial of each variable, through the positions, velocities and
    /// accelerations at both ends, deviates from the trajectory by at most `error` [rad or m]; none for an empty motion.
    ///
    /// The start of every motion and the end of the last are included. Robot controllers
    /// interpolate in this way (`joint_trajectory_controller` of ros2_control).
    pub fn knots(&self, error: f64) -> Vec<Setpoint> {
        let times = knot_times(self.followed, error);
        times
            .into_iter()
            .filter_map(|time| self.setpoint(time))
            .collect()
    }

    /// Visits the setpoints at this period \[s\], passes the sample measured at each to the sink, and stops when
    /// the sink returns `Break`.
    pub fn play(
        &self,
        period: f64,
        sink: &mut SampleSink<'_>,
        mut measure: impl FnMut(&Setpoint) -> TouchSample,
    ) -> Execution {
        let mut execution = Execution::from_positions(self.cell.ready_posture());
        for at in self.setpoints(period) {
            let sample = TelemetrySample::from_touch(&measure(&at), at.motion, at.phase);
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

/// Returns the times at this period from 0 to the duration, both included \[s\]. They increase
/// strictly.
fn period_times(duration: f64, period: f64) -> impl Iterator<Item = f64> {
    // Rounding of a whole number of periods must not repeat the end.
    let steps = (duration / period - ROUNDING).ceil().max(0.0) as usize;
    (0..=steps).map(move |k| {
        if k == steps {
            duration
        } else {
            k as f64 * period
        }
    })
}

#[cfg(test)]
mod tests {
    use super::period_times;

    #[test]
    fn times_increase_strictly_up_to_the_end() {
        // 0.07 / 0.01 is more than 7.
        for duration in [0.0, 0.004, 0.01, 0.07, 0.075, 0.29, 1.1, 1199.99] {
            let times: Vec<f64> = period_times(duration, 0.01).collect();
            assert!(times.is_sorted_by(|one, next| one < next), "{duration}");
            assert_eq!((times[0], times[times.len() - 1]), (0.0, duration));
            let gaps = times.windows(2).map(|pair| pair[1] - pair[0]);
            assert!(gaps.fold(0.0, f64::max) < 0.010_001, "{duration}");
        }
    }
}
