//! Agreement of the measured joint positions with the measured poses of the tool.

use super::TelemetrySample;
use crate::follow::Workcell;
use crate::interpret::Doubt;

/// Least time between two samples that are compared [s].
const PERIOD: f64 = 0.05;
/// Largest usual distance [m] and angle [rad] between the measured pose of the tool and that of the joint positions: the
/// errors of calibration and of a tool that bends.
const MOST_OFF: [f64; 2] = [0.01, 0.05];

/// A comparison of the tool's pose with that which the joint positions give, during one motion.
pub(super) struct PoseAgreement<'a> {
    cell: &'a Workcell,
    /// Time from which on the next sample is compared [s].
    next: f64,
    /// Distances [m] and angles [rad] between both poses.
    off: Vec<[f64; 2]>,
}

impl<'a> PoseAgreement<'a> {
    /// Returns a comparison without samples.
    pub fn new(cell: &'a Workcell) -> Self {
        Self {
            cell,
            next: f64::NEG_INFINITY,
            off: Vec::new(),
        }
    }

    /// Compares a sample, unless it has no positions or the last compared one is recent.
    pub fn add(&mut self, sample: &TelemetrySample<'_>) {
        if sample.positions.is_empty() || sample.time < self.next {
            return;
        }
        let cell = self.cell;
        let Ok(kinematics) = cell.robot().forward_kinematics(sample.positions) else {
            return;
        };
        self.next = sample.time + PERIOD;
        let world_from_tool =
            cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        let off = world_from_tool.inverse() * sample.world_from_tool;
        self.off
            .push([off.translation.vector.norm(), off.rotation.angle()]);
    }

    /// Returns the doubt that both measurements contradict each other for most of the time, if they do.
    pub fn find_doubt(&self) -> Option<Doubt> {
        let is_off = |off: &[f64; 2]| off[0] > MOST_OFF[0] || off[1] > MOST_OFF[1];
        let count = self.off.iter().filter(|off| is_off(off)).count();
        if 2 * count <= self.off.len() {
            return None;
        }
        let median = |part: usize| {
            let mut values: Vec<f64> = self.off.iter().map(|off| off[part]).collect();
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        Some(Doubt::PositionsContradictPose {
            distance: median(0),
            angle: median(1),
        })
    }
}
