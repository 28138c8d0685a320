//! An hour of synthetic telemetry at 1 kHz of an arm that wipes back and forth.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};

/// Number of samples.
pub const SAMPLES: usize = 3_600_000;
/// Number of joints of the arm; with poses and wrenches, the telemetry has 65 columns, 39 of them for joints.
pub const JOINTS: usize = 13;
/// Sample period [s].
const PERIOD: f64 = 1e-3;
/// Resolution of an encoder with 17 bits per turn [rad].
const ENCODER: f64 = TAU / 131_072.0;
/// Resolution of the force sensor [N]; its noise is a few times larger.
const FORCE_STEP: f64 = 0.02;
/// Duration of a stroke, and of the return motion [s].
const STROKE: f64 = 4.0;

/// Returns the names of the arm's joints.
pub fn joints() -> Vec<String> {
    (0..JOINTS).map(|joint| format!("joint_{joint}")).collect()
}

/// Returns the arm as URDF: links of 10 cm, with joint axes x, y and z in turn.
pub fn urdf() -> String {
    let mut text = String::from("<robot name=\"arm\"><link name=\"link_0\"/>");
    let axes = ["1 0 0", "0 1 0", "0 0 1"];
    for joint in 0..JOINTS {
        let child = match joint + 1 {
            JOINTS => "tip".to_owned(),
            child => format!("link_{child}"),
        };
        // Writing to a text cannot fail.
        let _ = write!(
            text,
            "<link name=\"{child}\"/><joint name=\"joint_{joint}\" type=\"revolute\">\
             <parent link=\"link_{joint}\"/><child link=\"{child}\"/>\
             <origin xyz=\"0 0 0.1\"/><axis xyz=\"{}\"/>\
             <limit lower=\"-3\" upper=\"3\" effort=\"100\" velocity=\"3\"/></joint>",
            axes[joint % axes.len()]
        );
    }
    text + "</robot>"
}

/// Generates samples one by one, and passes each on.
///
/// # Errors
/// Errors of the receiver.
pub fn write<E>(
    seed: u64,
    samples: usize,
    take: &mut dyn FnMut(&TelemetrySample<'_>) -> Result<(), E>,
) -> Result<(), E> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let [mut positions, mut velocities, mut efforts] = [[0.0; JOINTS]; 3];
    for k in 0..samples {
        let time = k as f64 * PERIOD;
        for joint in 0..JOINTS {
            let rate = TAU / (2.0 * STROKE) / (1.0 + 0.1 * joint as f64);
            let amplitude = 0.3 / (1.0 + joint as f64);
            let angle = amplitude * (rate * time).sin();
            positions[joint] = (angle / ENCODER).round() * ENCODER;
            // Velocities have the noise of a smoothed encoder.
            let velocity = amplitude * rate * (rate * time).cos() + rng.random_range(-2e-3..2e-3);
            velocities[joint] = (velocity / ENCODER).round() * ENCODER;
            let effort = 20.0 * amplitude * (rate * time + 1.0).cos() + rng.random_range(-0.1..0.1);
            efforts[joint] = (effort / FORCE_STEP).round() * FORCE_STEP;
        }
        let stroke = (time / (2.0 * STROKE)) as usize;
        let wipes = time % (2.0 * STROKE) < STROKE;
        let x = 0.6 + 0.15 * (TAU / (2.0 * STROKE) * time).sin();
        let y = 0.001 * (stroke % 300) as f64;
        let mut wrench = |press: f64| {
            let mut part = |mean: f64| {
                let force = mean + rng.random_range(-0.1..0.1);
                (force / FORCE_STEP).round() * FORCE_STEP
            };
            Wrench {
                force: Vector3::new(part(1.0), part(0.0), part(press)),
                moment: Vector3::new(part(0.1), part(0.2), part(0.0)),
            }
        };
        let press = if wipes { 9.5 } else { 0.0 };
        let (controller, external) = (wrench(-press), wrench(press));
        take(&TelemetrySample {
            time,
            positions: &positions,
            velocities: &velocities,
            efforts: &efforts,
            world_from_commanded: Pose::translation(x, y, 0.745),
            world_from_tool: Pose::translation(x + 1e-4, y, 0.75),
            controller,
            external,
            motion: 2 * stroke + usize::from(!wipes),
            phase: if wipes {
                Phase::Wipe(stroke)
            } else {
                Phase::Lifted
            },
            status: SampleStatus::default(),
        })?;
    }
    Ok(())
}
