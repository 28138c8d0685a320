//! A simulated arm that another program commands, period by period.

use crate::period::Simulation;
use crate::{Dirt, SimulationError, SimulationSettings};
use wisch::control::ControlConfig;
use wisch::follow::TrajectorySample;
use wisch::run::{Ending, MotionOrder, SampleSink, StopCause};

/// A simulated arm that follows setpoints from one control period to the next, as a robot's controller does.
///
/// It replaces a robot that other programs command. The same setpoints give the same result, bit
/// for bit.
pub struct LiveArm<'a> {
    simulation: Simulation<'a>,
    period: f64,
    /// Number of completed periods.
    periods: u64,
}

impl<'a> LiveArm<'a> {
    /// Returns the arm at rest at the start of the motion of `order`, or in its ready posture if the motion is empty. The
    /// motion is not executed, and no person pushes.
    ///
    /// # Errors
    /// Those of [`execute`](crate::execute).
    pub fn new(
        order: &MotionOrder<'a>,
        settings: &'a SimulationSettings,
        dirt: &Dirt,
        control: &'a ControlConfig,
    ) -> Result<Self, SimulationError> {
        let mut simulation = Simulation::new(order, settings, dirt, control)?;
        simulation.clear_disturbances();
        Ok(Self {
            simulation,
            period: control.period,
            periods: 0,
        })
    }

    /// Advances the world by one control period. `sink` receives the sample that was measured at the beginning of the
    /// period. Returns the reason if the robot stops itself, instead of advancing the world.
    ///
    /// - `setpoint`: all n variables of the robot.
    /// - `press_share`: share of the full depth to which the tool is commanded into the surface,
    ///   from 0 to 1; at 1, it presses with the task's press force.
    ///
    /// # Errors
    /// If the simulation diverges.
    pub fn step(
        &mut self,
        setpoint: &TrajectorySample,
        press_share: f64,
        sink: &mut SampleSink<'_>,
    ) -> Result<Option<StopCause>, SimulationError> {
        let time = self.periods as f64 * self.period;
        self.periods += 1;
        self.simulation.head_for(setpoint, press_share);
        Ok(match self.simulation.run_period(time, sink)? {
            Some(Ending::ProtectiveStop { cause, .. }) => Some(cause),
            _ => None,
        })
    }
}
