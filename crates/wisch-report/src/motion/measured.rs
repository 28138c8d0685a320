//! What was measured of a motion's joints, as much of it as a page shows.

use super::sampled::RATE;
use wisch::follow::TrajectorySample;
use wisch::run::TelemetrySample;

/// Watches an execution and keeps the joints' positions at most 40 times a second. Of who measures none it is empty.
#[derive(Debug, Clone, Default)]
pub struct MeasuredMotion {
    samples: Vec<TrajectorySample>,
}

impl MeasuredMotion {
    /// Takes note of what is measured at one instant; samples come in the order of time.
    pub fn watch(&mut self, sample: &TelemetrySample) {
        // Times of periods add up to a little less.
        const SLACK: f64 = 1e-6;
        let due =
            (self.samples.last()).is_none_or(|last| sample.time >= last.time + 1.0 / RATE - SLACK);
        if due && !sample.positions.is_empty() {
            self.samples.push(TrajectorySample {
                time: sample.time,
                q: sample.positions.to_vec(),
                qd: sample.velocities.to_vec(),
                qdd: Vec::new(),
            });
        }
    }

    /// The samples that were kept.
    pub(crate) fn samples(&self) -> &[TrajectorySample] {
        &self.samples
    }
}
