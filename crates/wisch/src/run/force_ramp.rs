//! The rise of the force while the tool comes down, and its fall while the tool lifts off.

use super::MotionOrder;
use crate::control::ControlConfig;
use crate::follow::Phase;

/// Period at which the height of the tool is computed [s].
const PERIOD: f64 = 0.01;

/// The force of the tool along the surface's normal during one motion of an order.
///
/// The impedance controller of this library presses the tool into the surface while its height is
/// within [`ControlConfig::approach_height`], in proportion to its nearness. With this ramp, a
/// driver that has a force controller does the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceRamp {
    /// Force at the start of the motion \[N\].
    pub start_force: f64,
    /// Force at the end of the motion \[N\].
    pub end_force: f64,
    /// Time over which the force changes \[s\]: the last part of a motion that lowers the tool, or
    /// the first part of a motion that lifts it; 0 if the force is constant.
    pub duration: f64,
    /// Largest planned speed of the tool along the normal during that time \[m/s\].
    pub approach_speed: f64,
}

impl MotionOrder<'_> {
    /// Returns the force during a motion; `None` where the tool does not touch, or if there is no such motion.
    ///
    /// `motion`: index in [`Followed::motions`](crate::follow::Followed).
    pub fn force_ramp(&self, motion: usize) -> Option<ForceRamp> {
        let planned = self.followed.motions.get(motion)?;
        let force = self.task.interaction.contact_force();
        if force == 0.0 {
            return None;
        }
        let (start, end) = (planned.start, planned.end());
        let ramp = |start_force, end_force, [duration, approach_speed]: [f64; 2]| {
            Some(ForceRamp {
                start_force,
                end_force,
                duration,
                approach_speed,
            })
        };
        match planned.phase {
            Phase::Lower => ramp(0.0, force, self.measure_approach(end, start)),
            Phase::Wipe(_) => ramp(force, force, [0.0; 2]),
            Phase::Lift => ramp(force, 0.0, self.measure_approach(start, end)),
            Phase::Drive | Phase::FreeMotion | Phase::Lifted => None,
        }
    }

    /// Returns the time between `contact` and `clear` during which the tool is within the approach height [s], and its
    /// largest speed along the normal in that time [m/s].
    fn measure_approach(&self, contact: f64, clear: f64) -> [f64; 2] {
        let limit = ControlConfig::default().approach_height;
        let count = ((clear - contact).abs() / PERIOD).ceil().max(1.0) as usize;
        let time = |k: usize| contact + (clear - contact) * (k as f64 / count as f64);
        let height = |time: f64| {
            let at = self.setpoint(time)?;
            let chart_from_tool = self.task.surface.chart_from_tool(&at.world_from_tool);
            Some(chart_from_tool.translation.z)
        };
        let (mut before, mut speed) = (height(contact), 0.0_f64);
        for k in 1..=count {
            let (Some(last), Some(now)) = (before, height(time(k))) else {
                break;
            };
            let step = (time(k) - time(k - 1)).abs();
            speed = speed.max((now - last).abs() / step);
            if now >= limit {
                return [(time(k) - contact).abs(), speed];
            }
            before = Some(now);
        }
        [(clear - contact).abs(), speed]
    }
}
