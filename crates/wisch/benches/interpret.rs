//! Cost of taking the samples of a log, of interpreting it, and of fitting the plane of its
//! contacts.

#[allow(dead_code, reason = "the tests use all of it")]
#[path = "../tests/interpret/log.rs"]
mod log;

use divan::{Bencher, black_box};
use log::{STEEP, Script, task};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Point2, Point3};
use wisch::interpret::{Belief, InterpretConfig, Interpreter, PlaneConfig, TouchSample, fit_plane};
use wisch::represent::GoalState;

fn main() {
    divan::main();
}

/// Strokes to and fro over the board for about `seconds` at 1 kHz.
fn script(seconds: usize) -> Script {
    // A stroke takes 5.2 s with approach and lift, the way to the next one 0.4 s.
    let strokes = (0..(seconds * 10).div_ceil(56)).map(|i| {
        let y = (i % 5) as f64 * 0.05 - 0.1;
        let x = if i % 2 == 0 { 0.16 } else { -0.16 };
        [Point2::new(-x, y), Point2::new(x, y)]
    });
    Script {
        strokes: strokes.collect(),
        ..Script::default()
    }
}

fn interpreter(samples: &[TouchSample]) -> Interpreter {
    let task = task(80, STEEP);
    let mut interpreter = Interpreter::new(&task, &InterpretConfig::from_task(&task)).unwrap();
    for sample in samples {
        interpreter.push(sample).unwrap();
    }
    interpreter
}

/// 64 replays of 80 particles.
#[divan::bench(args = [60, 3600], sample_count = 5)]
fn log_of_seconds(bencher: Bencher, seconds: usize) {
    let task = task(80, STEEP);
    let samples = script(seconds).samples(&task);
    let believed = Belief::from_particles(task.particles.clone());
    bencher.bench(|| interpreter(black_box(&samples)).conclude(&believed, &GoalState::Absorbed));
}

/// The same log with a heap that is pushed to the middle.
#[divan::bench(args = [60], sample_count = 5)]
fn pushing_log_of_seconds(bencher: Bencher, seconds: usize) {
    let task = task(80, STEEP);
    let samples = script(seconds).samples(&task);
    let believed = Belief::from_particles(task.particles.clone());
    let goal = GoalState::Collected {
        center: Point2::origin(),
        radius: 0.065,
    };
    bencher.bench(|| interpreter(black_box(&samples)).conclude(&believed, &goal));
}

/// Only the samples of a minute, without interpretation.
#[divan::bench(sample_count = 10)]
fn push_60_000_samples(bencher: Bencher) {
    let samples = script(60).samples(&task(80, STEEP));
    bencher.bench(|| interpreter(black_box(&samples)));
}

/// Three in ten points are not on the plane.
#[divan::bench]
fn plane_of_5000_points(bencher: Bencher) {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let points: Vec<Point3> = (0..5000)
        .map(|i| {
            let mut even = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
            let (x, y) = (even(-0.2, 0.2), even(-0.14, 0.14));
            let off = if i % 10 < 3 {
                even(-0.05, 0.05)
            } else {
                even(-4e-4, 4e-4)
            };
            Point3::new(x, y, 0.03 * x - 0.02 * y + off)
        })
        .collect();
    bencher.bench(|| fit_plane(black_box(&points), &PlaneConfig::default(), 1));
}
