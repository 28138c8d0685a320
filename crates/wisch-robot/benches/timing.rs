//! Timing of smooth paths of 500 waypoints.

use divan::{Bencher, black_box};
use wisch_robot::timing::{
    JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, time_path,
};

fn main() {
    divan::main();
}

const WAYPOINTS: usize = 500;

fn path(joints: usize) -> JointPath {
    let rows: Vec<Vec<f64>> = (0..WAYPOINTS)
        .map(|i| {
            let along = i as f64 * 0.02;
            (0..joints)
                .map(|j| (along * (1.0 + 0.1 * j as f64) + j as f64).sin())
                .collect()
        })
        .collect();
    JointPath::new(&rows).unwrap()
}

fn limits(joints: usize) -> JointLimits {
    let joint = |j| JointLimit::arm(&format!("joint {j}"), -2.0, 2.0);
    JointLimits::new((0..joints).map(joint).collect()).unwrap()
}

#[divan::bench(args = [7, 13])]
fn time_500_waypoints(bencher: Bencher, joints: usize) {
    let (path, limits) = (path(joints), limits(joints));
    let config = TimingConfig::default();
    bencher.bench(|| time_path(black_box(&path), &limits, &config));
}

#[divan::bench(args = [7, 13])]
fn sample_every_millisecond(bencher: Bencher, joints: usize) {
    let trajectory = time_path(&path(joints), &limits(joints), &TimingConfig::default()).unwrap();
    bencher.bench(|| black_box(&trajectory).samples(SAMPLE_PERIOD).count());
}
