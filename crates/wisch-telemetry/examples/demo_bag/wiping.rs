//! A synthetic log of a tool that wipes a surface in rows.

use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_telemetry::{BagWriter, WriteError};

/// Parameters of the synthetic tool's motion.
#[derive(Debug, Clone, Copy)]
pub struct Wiping {
    /// True pose of the surface.
    pub world_from_surface: Pose,
    /// Extent that the tool centre point covers, along x and y of the surface [m].
    pub extent: [f64; 2],
    /// Number of rows along x.
    pub rows: usize,
    /// Speed of the tool centre point [m/s].
    pub speed: f64,
    /// Normal force [N].
    pub press: f64,
    /// Samples per second.
    pub rate: f64,
}

/// Height of the tool before and after wiping [m].
const LIFTED: f64 = 0.05;
/// Coefficient of friction.
const FRICTION: f64 = 0.3;
/// Number of joints of the synthetic robot.
pub const JOINTS: [&str; 3] = ["shoulder", "elbow", "wrist"];

impl Wiping {
    /// Writes all samples; returns their number.
    ///
    /// # Errors
    /// If writing fails.
    pub fn write(&self, bag: &mut BagWriter) -> Result<usize, WriteError> {
        let way = self.way();
        let length: f64 = way.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
        let count = (length / self.speed * self.rate) as usize;
        for index in 0..count {
            let time = index as f64 / self.rate;
            let (tip, along) = at(&way, time * self.speed);
            self.sample(time, tip, along, |sample| bag.write(sample))?;
        }
        Ok(count)
    }

    /// Returns the corners of the tool centre point's path in the surface frame [m].
    fn way(&self) -> Vec<Vector3> {
        let [x, y] = self.extent.map(|side| side / 2.0);
        let mut way = vec![Vector3::new(-x, -y, LIFTED)];
        for row in 0..self.rows {
            let y = -y + 2.0 * y * row as f64 / (self.rows - 1).max(1) as f64;
            let x = if row % 2 == 0 { x } else { -x };
            way.extend([Vector3::new(-x, y, 0.0), Vector3::new(x, y, 0.0)]);
        }
        let last = way[way.len() - 1];
        way.push(Vector3::new(last.x, last.y, LIFTED));
        way
    }

    fn sample<T>(
        &self,
        time: f64,
        tip: Vector3,
        along: Vector3,
        then: impl FnOnce(&TelemetrySample<'_>) -> T,
    ) -> T {
        let contact = tip.z < 1e-9;
        let force_in_surface = if contact {
            Vector3::new(-FRICTION * along.x, -FRICTION * along.y, 1.0) * self.press
        } else {
            Vector3::zeros()
        };
        let force = self.world_from_surface.rotation * force_in_surface;
        let press = if contact {
            Vector3::new(0.0, 0.0, -0.004)
        } else {
            Vector3::zeros()
        };
        let world_from =
            |tip: Vector3| self.world_from_surface * Pose::translation(tip.x, tip.y, tip.z);
        let wave = (0.5 * time).sin();
        then(&TelemetrySample {
            time,
            positions: &[wave, 0.5 * wave, -wave],
            velocities: &[0.1, 0.05, -0.1],
            efforts: &[12.0, 6.0, 1.0],
            world_from_commanded: world_from(tip + press),
            world_from_tool: world_from(tip),
            controller: Wrench {
                force: -force,
                moment: Vector3::zeros(),
            },
            external: Wrench {
                force,
                moment: Vector3::zeros(),
            },
            motion: 0,
            phase: match (contact, along.z) {
                (true, _) => Phase::Wipe(0),
                (_, z) if z < 0.0 => Phase::Lower,
                _ => Phase::Lift,
            },
            status: SampleStatus::default(),
        })
    }
}

/// Returns the point at a distance along a path, and the direction of the path there.
fn at(way: &[Vector3], mut distance: f64) -> (Vector3, Vector3) {
    for corners in way.windows(2) {
        let step = corners[1] - corners[0];
        let length = step.norm();
        if distance <= length && length > 0.0 {
            return (corners[0] + step * (distance / length), step / length);
        }
        distance -= length;
    }
    (way[way.len() - 1], Vector3::zeros())
}
