//! Density map and peaks of particles on one square metre.

use divan::{Bencher, black_box};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Bounds2, Point2};
use wisch::plan::{CoverageDensity, FreeSpace, KdeConfig, kde};
use wisch_testkit::surface;

fn main() {
    divan::main();
}

const BANDWIDTH: f64 = 0.05;
/// r_s of the sponge [m].
const RADIUS: f64 = 0.0652;

fn points(count: usize) -> Vec<Point2> {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    (0..count)
        .map(|_| Point2::new(random.random::<f64>() - 0.5, random.random::<f64>() - 0.5))
        .collect()
}

#[divan::bench(args = [1_000, 100_000, 1_000_000])]
fn density_map(bencher: Bencher, count: usize) {
    let points = points(count);
    let bounds = Bounds2::from_points(points.iter().copied()).unwrap();
    bencher.bench(|| CoverageDensity::new(black_box(&points), bounds, BANDWIDTH));
}

#[divan::bench(args = [1_000, 100_000, 1_000_000])]
fn peaks(bencher: Bencher, count: usize) {
    let points = points(count);
    let surface = surface([1.0; 2]);
    let space = FreeSpace::new(&surface, [], RADIUS).unwrap();
    let config = KdeConfig {
        bandwidth: Some(BANDWIDTH),
        reach: 0.035,
    };
    bencher.bench(|| kde(&space, black_box(&points), &config));
}
