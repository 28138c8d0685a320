//! Costs of a second of telemetry: 1000 samples of a robot with 13 variables.

use divan::Bencher;
use std::path::Path;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_telemetry::{BagHead, BagWriter, LogOptions, read};

const SAMPLES: usize = 1000;
const VARIABLES: usize = 13;

fn main() {
    divan::main();
}

fn write_second(path: &Path) {
    let head = BagHead {
        joints: (0..VARIABLES).map(|i| format!("right_arm_{i}")).collect(),
        world_from_surface: Pose::translation(0.6, 0.0, 0.75),
        start: 0,
        notes: [].into(),
    };
    let mut bag = BagWriter::create(path, head).expect("a bag");
    for index in 0..SAMPLES {
        let time = index as f64 * 1e-3;
        let wave = |i: usize| (time * (i + 1) as f64).sin();
        let values: [f64; VARIABLES] = std::array::from_fn(wave);
        let force = Vector3::new(wave(0), wave(1), 10.0 + wave(2));
        let wrench = Wrench {
            force,
            moment: 0.1 * force,
        };
        let world_from_tool =
            Pose::new(Vector3::new(wave(3), wave(4), 0.75), Vector3::z() * wave(5));
        bag.write(&TelemetrySample {
            time,
            positions: &values,
            velocities: &values,
            efforts: &values,
            world_from_commanded: world_from_tool,
            world_from_tool,
            controller: wrench,
            external: wrench,
            motion: 0,
            phase: Phase::Wipe(0),
            status: SampleStatus::default(),
        })
        .expect("a sample");
    }
    bag.finish().expect("the end");
}

#[divan::bench]
fn written(bencher: Bencher) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bench.mcap");
    bencher
        .counter(divan::counter::ItemsCount::new(SAMPLES))
        .bench_local(|| write_second(&path));
}

#[divan::bench]
fn read_back(bencher: Bencher) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bench.mcap");
    write_second(&path);
    bencher
        .counter(divan::counter::ItemsCount::new(SAMPLES))
        .bench_local(|| {
            read(&path, &LogOptions::default())
                .expect("a log")
                .samples
                .len()
        });
}
