//! One push stroke of 0.4 m: cost by the number of particles, and by the number near the stroke.

use divan::{Bencher, black_box};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{PlanarPose, Point2, Polygon, Region, Vector2};
use wisch::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, ToolMotion};
use wisch_testkit::surface;

fn main() {
    divan::main();
}

/// Particles spread evenly over a square of side `side` [m].
fn field(count: usize, side: f64) -> ParticleField {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let points: Vec<Point2> = (0..count)
        .map(|_| Point2::new(random.random::<f64>() - 0.5, random.random::<f64>() - 0.5) * side)
        .collect();
    ParticleField::new(&ParticleDistribution::new(&points).unwrap())
}

fn stroke(bencher: Bencher, count: usize, side: f64, turn: f64) {
    let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    let surface = surface([side; 2]);
    let motion = ToolMotion {
        from: PlanarPose::new(Point2::new(-0.2, 0.0), 0.0),
        to: PlanarPose::new(Point2::new(0.2, 0.0), turn),
    };
    let before = field(count, side);
    let mut model = EffectModel::new(&sponge, Effect::Push);
    bencher
        .with_inputs(|| before.clone())
        .bench_local_refs(|field| black_box(model.apply(field, &surface, &motion)));
}

/// The area stays 1 m²: the number of particles near the stroke grows with the total number.
#[divan::bench(args = [400, 10_000, 100_000, 1_000_000])]
fn push_on_one_square_metre(bencher: Bencher, count: usize) {
    stroke(bencher, count, 1.0, 0.0);
}

/// The density stays 1000 particles per m²: only the number far from the stroke grows.
#[divan::bench(args = [1_000, 10_000, 100_000, 1_000_000])]
fn push_at_constant_density(bencher: Bencher, count: usize) {
    stroke(bencher, count, (count as f64 / 1000.0).sqrt(), 0.0);
}

/// The tool turns by a right angle on the way.
#[divan::bench(args = [400, 10_000])]
fn push_and_turn(bencher: Bencher, count: usize) {
    stroke(bencher, count, 1.0, std::f64::consts::FRAC_PI_2);
}
