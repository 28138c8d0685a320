//! Random disturbances.

use nalgebra::{Translation3, UnitQuaternion};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};
use wisch::geometry::{Pose, Vector3};
use wisch_io::{Moment, Push};
use wisch_sim::SimulationSettings;

/// Tilt of the real surface about its x and y, at most [rad].
const TILT: f64 = 3.0 * PI / 180.0;
/// How far it is above or below where it is believed, at most [m].
const HEIGHT: f64 = 0.010;
/// Number of pushes, at most.
const PUSHES: u32 = 2;
/// Force of a push [N], its start and how long it lasts [s], speed of the hand [m/s].
const PUSH_FORCE: [f64; 2] = [10.0, 40.0];
const PUSH_START: [f64; 2] = [2.0, 50.0];
const PUSH_DURATION: [f64; 2] = [0.5, 2.5];
const HAND_SPEED: [f64; 2] = [0.05, 0.5];
/// Coulomb coefficient between tool and surface [1].
const FRICTION: [f64; 2] = [0.2, 0.9];
/// Bias of the force sensor per axis, at most, and standard deviation of its noise [N].
const BIAS: f64 = 1.0;
const NOISE: [f64; 2] = [0.0, 0.5];
/// Stream of random numbers, apart from those of the task.
const STREAM: u64 = 0x6469_7374;

/// A reality with the disturbances of an episode.
pub fn disturbed(reality: &SimulationSettings, seed: u64) -> SimulationSettings {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(STREAM);
    let mut between =
        |[low, high]: [f64; 2]| -> f64 { low + (high - low) * random.random::<f64>() };
    let tilt = Vector3::new(between([-TILT, TILT]), between([-TILT, TILT]), 0.0);
    let height = between([-HEIGHT, HEIGHT]);
    let friction = between(FRICTION);
    let force_bias = Vector3::from_fn(|_, _| between([-BIAS, BIAS]));
    let force_noise = between(NOISE);
    let count = between([0.0, f64::from(PUSHES + 1)]) as u32;
    let pushes = (0..count).map(|_| {
        // Uniform over all directions: so are the height on a sphere and the angle about its axis.
        let (up, angle) = (between([-1.0, 1.0]), between([0.0, TAU]));
        let across = (1.0 - up * up).sqrt();
        let direction = Vector3::new(across * angle.cos(), across * angle.sin(), up);
        Push {
            round: 1,
            start: Moment::Seconds(between(PUSH_START)),
            duration: between(PUSH_DURATION),
            force: between(PUSH_FORCE) * direction,
            hand_speed: between(HAND_SPEED),
        }
    });
    SimulationSettings {
        pushes: pushes.collect(),
        believed_from_real: Pose::from_parts(
            Translation3::new(0.0, 0.0, height),
            UnitQuaternion::from_scaled_axis(tilt),
        ),
        friction,
        force_bias,
        force_noise,
        ..reality.clone()
    }
}
