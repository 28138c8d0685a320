//! Rapidly exploring random trees (LaValle) over the free surface.

use super::grid::free_cells;
use crate::geometry::{Point2, PointGrid};
use crate::plan::FreeSpace;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Smallest number of consecutive samples without a new node after which the tree stops growing.
const FRUITLESS: usize = 100_000;

/// Seed and effort of a rapidly exploring random tree, see [`rrt`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RrtConfig {
    /// Seed of the random samples.
    pub seed: u64,
    /// Samples per cell after which the tree stops growing towards uncovered cells.
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

/// Grows a tree from the free place nearest to `start`, by at most r_s at a time, and returns its
/// nodes. All places are in the surface frame \[m\].
///
/// Samples are drawn in cells of pitch r_s / 2 that no node covers yet, which biases the tree towards
/// unexplored regions. A node covers the cells whose centre is within r_s / √2 of it, about as far as a
/// footprint reaches on average. Growth ends when every free cell is covered, when the budget of samples is
/// spent, or when the last `samples_per_cell` samples per uncovered cell gave no node. Time is about
/// proportional to the number of cells.
pub fn rrt(space: &FreeSpace, start: Point2, config: &RrtConfig) -> Vec<Point2> {
    let step = space.radius();
    let pitch = step / 2.0;
    let cells = free_cells(space, pitch);
    let Some(root) = cells
        .iter()
        .copied()
        .min_by(|a, b| (a - start).norm().total_cmp(&(b - start).norm()))
    else {
        return Vec::new();
    };
    let covers = step * std::f64::consts::FRAC_1_SQRT_2;
    let budget = config.samples_per_cell * cells.len();
    let mut random = ChaCha8Rng::seed_from_u64(config.seed);
    let mut nodes = vec![root];
    let mut tree = PointGrid::from_points(&nodes, step);
    let mut uncovered = Uncovered::of(&cells, covers);
    uncovered.cover(root, covers);
    let mut fruitless = 0;
    for _ in 0..budget {
        if uncovered.count() == 0
            || fruitless > FRUITLESS.max(config.samples_per_cell * uncovered.count())
        {
            break;
        }
        fruitless += 1;
        let cell = cells[uncovered.number(random.random_range(0..uncovered.count()))];
        let sample = cell
            + nalgebra::Vector2::new(
                (random.random::<f64>() - 0.5) * pitch,
                (random.random::<f64>() - 0.5) * pitch,
            );
        let Some(near) = tree.nearest(sample).map(|number| nodes[number]) else {
            break;
        };
        let towards = sample - near;
        let node = near + towards * (step / towards.norm()).min(1.0);
        let useful = uncovered.grid.has_within(node, covers, |_, _| true);
        if useful && space.is_free(node) && space.is_clear_between(near, node) {
            uncovered.cover(node, covers);
            tree.insert(nodes.len(), node);
            nodes.push(node);
            fruitless = 0;
        }
    }
    nodes
}

/// The cells that no node covers yet, in order: finding a cell by rank and removing it take logarithmic time.
struct Uncovered {
    grid: PointGrid,
    /// Sums of a Fenwick tree (Fenwick, 1994) over the cells; each uncovered cell counts 1.
    sums: Vec<usize>,
}

impl Uncovered {
    fn of(cells: &[Point2], reach: f64) -> Self {
        Self {
            grid: PointGrid::from_points(cells, reach),
            // The sum at i is over the last i & -i cells up to the i-th.
            sums: (0..=cells.len()).map(|i| i & i.wrapping_neg()).collect(),
        }
    }

    fn count(&self) -> usize {
        self.grid.len()
    }

    /// Number of the cell with this rank.
    fn number(&self, rank: usize) -> usize {
        let (mut at, mut left) = (0, rank);
        let mut step = self.sums.len().next_power_of_two();
        while step > 0 {
            if at + step < self.sums.len() && self.sums[at + step] <= left {
                at += step;
                left -= self.sums[at];
            }
            step /= 2;
        }
        at
    }

    /// Removes the cells that a node covers.
    fn cover(&mut self, node: Point2, reach: f64) {
        for number in self.grid.remove_within(node, reach) {
            let mut at = number + 1;
            while at < self.sums.len() {
                self.sums[at] -= 1;
                at += at & at.wrapping_neg();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_keep_their_order_when_others_are_covered() {
        let cells: Vec<Point2> = (0..11).map(|i| Point2::new(f64::from(i), 0.0)).collect();
        let mut uncovered = Uncovered::of(&cells, 0.5);
        let mut left: Vec<usize> = (0..cells.len()).collect();
        for covered in [4, 0, 10, 7] {
            uncovered.cover(cells[covered], 0.5);
            left.retain(|&number| number != covered);
            let found: Vec<usize> = (0..uncovered.count())
                .map(|rank| uncovered.number(rank))
                .collect();
            assert_eq!(found, left);
        }
    }
}
