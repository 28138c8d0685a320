//! One wipe as many robots would log it: force, bias, sign, frame, noise, clock, rate, pose of the surface and length drawn
//! at random.
//!
//! `WISCH_LOGS=2000 cargo test --workspace --test main interpret::random` reads as many logs.

use super::log::{BOARD, STEEP, Script, task};
use super::{interpreted, interpreted_with};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::interpret::{InterpretConfig, TouchSample};
use wisch::represent::Task;

/// Number of logs unless `WISCH_LOGS` sets it, and the seed of the first.
const COUNT: u64 = 100;
const FIRST_SEED: u64 = 1000;

/// Largest distance of the true share from the interval [1].
const MOST_MISSED: f64 = 0.1;

/// Least share of the logs that allow an estimate [1].
const LEAST_ANSWERED: f64 = 0.8;

/// The differences from the log that the task expects.
#[derive(Debug)]
struct Difference {
    scale: f64,
    /// Bias of the force in the axes of the sensor [N].
    bias: Vector3,
    is_turned: bool,
    /// Axis of the sensor along the surface's normal: 0 for its z, 1 for its −z, 2 for its x.
    frame: u8,
    noise: f64,
    /// Delay of the forces [s].
    late: f64,
    rate: f64,
    /// Height of the real surface above the believed one [m], its lean [rad], and the direction of
    /// the axis of the lean [rad].
    height: f64,
    lean: f64,
    about: f64,
    /// The part of the log that is kept: shares of its length at which it begins and ends [1].
    part: [f64; 2],
    /// Number of executed strokes.
    strokes: usize,
}

impl Difference {
    fn draw(random: &mut ChaCha8Rng) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        Self {
            scale: between(0.3_f64.ln(), 3.0_f64.ln()).exp(),
            bias: Vector3::from_fn(|_, _| between(-40.0, 40.0)),
            is_turned: between(0.0, 1.0) < 0.5,
            frame: between(0.0, 3.0) as u8,
            noise: between(0.0, 2.0),
            late: (between(-1.0, 1.0) * 0.5 * between(0.0, 2.0).floor()).clamp(-0.5, 0.5),
            rate: between(10.0_f64.ln(), 1000.0_f64.ln()).exp(),
            height: between(-0.015, 0.015),
            lean: between(0.0, 3.0_f64.to_radians()),
            about: between(0.0, std::f64::consts::TAU),
            part: [[0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 0.5], [0.5, 1.0]]
                [between(0.0, 5.0) as usize],
            strokes: 1 + between(0.0, 5.0) as usize,
        }
    }

    fn script(&self) -> Script {
        let rows: Vec<f64> = (0..5).map(|row| 0.05 * (f64::from(row) - 2.0)).collect();
        let along = 0.5 * BOARD[0] - 0.04;
        let strokes = (rows.iter().enumerate().take(self.strokes)).map(|(row, &y)| {
            let way = if row % 2 == 0 { along } else { -along };
            [Point2::new(-way, y), Point2::new(way, y)]
        });
        Script {
            strokes: strokes.collect(),
            rate: self.rate,
            force_noise: 0.0,
            ..Script::default()
        }
    }

    /// Returns the share that was wiped, by the same law. A log that is cut while the tool is in
    /// the air counts as a whole log of fewer strokes, because it shows no others.
    fn wiped(&self, task: &Task, config: &InterpretConfig) -> f64 {
        let plain = Script {
            rate: 1000.0,
            ..self.script()
        };
        let samples = plain.samples(task);
        let [begin, end] = self.part.map(|at| (at * samples.len() as f64) as usize);
        let is_pressed = |index: usize| {
            let sample = samples.get(index.saturating_sub(1));
            sample.is_some_and(|sample| sample.force.norm() > 0.0)
        };
        if is_pressed(begin) || is_pressed(end) {
            return interpreted(&plain).performance.mean;
        }
        interpreted_with(&samples[begin..end], task, config)
            .performance
            .mean
    }

    fn samples(&self, task: &Task, random: &mut ChaCha8Rng) -> Vec<TouchSample> {
        let plain = self.script().samples(task);
        let surface = task.surface.world_from_surface;
        let axis = Vector3::new(self.about.cos(), self.about.sin(), 0.0) * self.lean;
        let lean = Pose::new(Vector3::z() * self.height, axis);
        let count = plain.len() as f64;
        let shift = (self.late * self.rate).round() as i64;
        let mut samples = Vec::new();
        for (index, sample) in plain.iter().enumerate() {
            let at = index as f64 / count;
            // The noise is drawn for all, so that a part of a log is a part of the same log.
            let noise = Vector3::from_fn(|_, _| {
                ((0..6).map(|_| random.random::<f64>()).sum::<f64>() - 3.0) * 2.0_f64.sqrt()
            });
            if at < self.part[0] || at >= self.part[1] {
                continue;
            }
            let felt = (index as i64 - shift).clamp(0, plain.len() as i64 - 1);
            let force = surface.rotation.inverse() * plain[felt as usize].force;
            let force = lean.rotation * force * self.scale;
            let force = if self.is_turned { -force } else { force } + noise * self.noise;
            let force = match self.frame {
                0 => force,
                1 => Vector3::new(force.x, -force.y, -force.z),
                _ => Vector3::new(force.z, force.y, -force.x),
            };
            samples.push(TouchSample {
                world_from_tool: surface * lean * surface.inverse() * sample.world_from_tool,
                force: surface.rotation * (force + self.bias),
                ..*sample
            });
        }
        samples
    }
}

#[test]
fn no_log_of_another_robot_is_read_wrongly_without_a_word() {
    let count = std::env::var("WISCH_LOGS").map_or(COUNT, |count| count.parse().unwrap());
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let (mut wrong, mut answered) = (Vec::new(), 0);
    for seed in FIRST_SEED..FIRST_SEED + count {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let difference = Difference::draw(&mut random);
        let truth = difference.wiped(&task, &config);
        let found = interpreted_with(&difference.samples(&task, &mut random), &task, &config);
        let estimate = found.performance;
        let missed = (estimate.low - truth).max(truth - estimate.high);
        answered += u64::from(found.is_conclusive());
        if missed > MOST_MISSED && found.doubts.is_empty() {
            wrong.push((seed, truth, estimate, difference));
        }
    }
    let share = answered as f64 / count as f64;
    println!(
        "{count} logs: {} wrong without a word, {:.1} % answered",
        wrong.len(),
        100.0 * share
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(share >= LEAST_ANSWERED, "{share}");
}
