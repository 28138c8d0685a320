//! Rapidly exploring random trees (LaValle) over the free surface.

use super::grid::free_cells;
use crate::geometry::Point2;
use crate::plan::FreeSpace;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// How a rapidly exploring random tree grows, see [`rrt`]: its seed, and when it gives up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RrtConfig {
    /// Seed of the random samples.
    pub seed: u64,
    /// Samples per cell to cover before the tree gives up on what is left.
    pub samples_per_cell: usize,
}

impl Default for RrtConfig {
    fn default() -> Self {
        Self {
            seed: 0,
            samples_per_cell: 100,
        }
    }
}

/// Nodes of a tree that grows from the free place nearest `start` by at most r_s at a time.
///
/// Samples are drawn in cells of pitch r_s / 2 that no node covers yet, which biases the tree towards
/// unexplored regions; a node covers the cells whose centre is within r_s / √2 of it, about as far as
/// a footprint reaches on average. Growth ends when every free cell is covered or the budget of samples
/// is spent.
pub fn rrt(space: &FreeSpace, start: Point2, config: &RrtConfig) -> Vec<Point2> {
    let step = space.radius();
    let pitch = step / 2.0;
    let mut uncovered = free_cells(space, pitch);
    let Some(root) = uncovered
        .iter()
        .copied()
        .min_by(|a, b| (a - start).norm().total_cmp(&(b - start).norm()))
    else {
        return Vec::new();
    };
    let covers = step * std::f64::consts::FRAC_1_SQRT_2;
    let budget = config.samples_per_cell * uncovered.len();
    let mut random = ChaCha8Rng::seed_from_u64(config.seed);
    let mut nodes = vec![root];
    uncovered.retain(|cell| (cell - root).norm() > covers);
    for _ in 0..budget {
        if uncovered.is_empty() {
            break;
        }
        let cell = uncovered[random.random_range(0..uncovered.len())];
        let sample = cell
            + nalgebra::Vector2::new(
                (random.random::<f64>() - 0.5) * pitch,
                (random.random::<f64>() - 0.5) * pitch,
            );
        let Some(near) = nodes
            .iter()
            .copied()
            .min_by(|a, b| (a - sample).norm().total_cmp(&(b - sample).norm()))
        else {
            break;
        };
        let towards = sample - near;
        let node = near + towards * (step / towards.norm()).min(1.0);
        let useful = uncovered.iter().any(|cell| (cell - node).norm() <= covers);
        if useful && space.is_free(node) && space.is_clear_between(near, node) {
            uncovered.retain(|cell| (cell - node).norm() > covers);
            nodes.push(node);
        }
    }
    nodes
}
