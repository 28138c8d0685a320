//! Times of tours through points spread uniformly over a square, from few to many.

use divan::{Bencher, black_box};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wisch::geometry::Point2;
use wisch::plan::{CostMatrix, TourConfig, shortest_path_from, shortest_tour};

const NODE_COUNTS: [usize; 5] = [12, 50, 200, 500, 1000];

fn main() {
    divan::main();
}

fn uniform_costs(node_count: usize) -> CostMatrix {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let points: Vec<Point2> = (0..node_count)
        .map(|_| Point2::new(rng.random(), rng.random()))
        .collect();
    CostMatrix::euclidean(&points).expect("distances in a unit square are finite")
}

#[divan::bench(args = NODE_COUNTS, sample_count = 5)]
fn closed_tour(bencher: Bencher, node_count: usize) {
    let costs = uniform_costs(node_count);
    bencher.bench_local(|| shortest_tour(black_box(&costs), &TourConfig::default()));
}

#[divan::bench(args = NODE_COUNTS, sample_count = 5)]
fn open_path(bencher: Bencher, node_count: usize) {
    let costs = uniform_costs(node_count);
    bencher.bench_local(|| shortest_path_from(black_box(&costs), 0, &TourConfig::default()));
}
