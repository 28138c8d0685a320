//! Maps of the expected dirt.

use crate::geometry::{Bounds2, Point2, Vector2};
use crate::interpret::error::InterpretError;
use crate::represent::{ParticleDistribution, Surface};

/// Largest number of cells of a map; a square metre has a million square millimetres.
const MAX_CELLS: usize = 1 << 22;
/// Share of a cell by which rounding may make a surface exceed whole cells.
const ROUNDING: f64 = 1e-9;

/// Expected number of remaining particles per cell, with its standard deviation over the members of a belief. Square
/// cells cover the bounds of the surface, row by row from the least x and y.
#[derive(Debug, Clone, PartialEq)]
pub struct DensityMap {
    origin: Point2,
    cell_size: f64,
    columns: usize,
    rows: usize,
    mean: Vec<f64>,
    deviation: Vec<f64>,
}

impl DensityMap {
    pub(super) fn of(
        members: &[ParticleDistribution],
        weights: &[f64],
        surface: &Surface,
        cell_size: f64,
    ) -> Result<Self, InterpretError> {
        let bounds =
            Bounds2::from_points(surface.outline.outer().iter().copied()).unwrap_or(Bounds2 {
                min: Point2::origin(),
                max: Point2::origin(),
            });
        let cells_along = |side: f64| (side / cell_size - ROUNDING).ceil().max(1.0);
        let shape = bounds.size().map(cells_along);
        let cells = shape.x * shape.y;
        if !(cell_size > 0.0 && cells <= MAX_CELLS as f64) {
            return Err(InterpretError::Cells {
                cell_size,
                cells,
                limit: MAX_CELLS,
            });
        }
        let mut map = Self {
            origin: bounds.min,
            cell_size,
            columns: shape.x as usize,
            rows: shape.y as usize,
            mean: Vec::new(),
            deviation: Vec::new(),
        };
        map.fill(members, weights);
        Ok(map)
    }

    fn fill(&mut self, members: &[ParticleDistribution], weights: &[f64]) {
        let cells = self.columns * self.rows;
        let mut sums = vec![0.0; cells];
        let mut squares = vec![0.0; cells];
        let mut counts = vec![0.0; cells];
        for (member, weight) in members.iter().zip(weights) {
            counts.fill(0.0);
            for cell in member.remaining().filter_map(|place| self.cell(place)) {
                counts[cell] += 1.0;
            }
            for ((sum, square), count) in sums.iter_mut().zip(&mut squares).zip(&counts) {
                *sum += weight * count;
                *square += weight * count * count;
            }
        }
        let spread = |(mean, square): (&f64, &f64)| (square - mean * mean).max(0.0).sqrt();
        self.deviation = sums.iter().zip(&squares).map(spread).collect();
        self.mean = sums;
    }

    /// Returns the index of the cell at a place; `None` off the map.
    fn cell(&self, place: Point2) -> Option<usize> {
        let offset = place - self.origin;
        let inside = |value: f64, cells: usize| {
            // The upper border belongs to the last cell.
            let whole = (value / self.cell_size).floor();
            (whole >= 0.0 && value <= cells as f64 * self.cell_size)
                .then(|| (whole as usize).min(cells - 1))
        };
        Some(inside(offset.y, self.rows)? * self.columns + inside(offset.x, self.columns)?)
    }

    /// Number of columns (along x) and of rows (along y).
    pub fn shape(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Side of a cell \[m\], the same along x and y of the surface.
    pub fn cell_size(&self) -> f64 {
        self.cell_size
    }

    /// Returns the middle of a cell in the surface frame \[m\].
    pub fn center(&self, column: usize, row: usize) -> Point2 {
        self.origin + Vector2::new(column as f64 + 0.5, row as f64 + 0.5) * self.cell_size
    }

    /// Mean number of particles that remain in a cell.
    ///
    /// # Panics
    /// If the cell is not on the map.
    pub fn mean(&self, column: usize, row: usize) -> f64 {
        self.mean[self.index(column, row)]
    }

    /// Standard deviation over the members of the number of particles that remain in a cell.
    ///
    /// # Panics
    /// If the cell is not on the map.
    pub fn standard_deviation(&self, column: usize, row: usize) -> f64 {
        self.deviation[self.index(column, row)]
    }

    fn index(&self, column: usize, row: usize) -> usize {
        assert!(
            column < self.columns && row < self.rows,
            "cell ({column}, {row}) of {} x {}",
            self.columns,
            self.rows
        );
        row * self.columns + column
    }
}
