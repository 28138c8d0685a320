//! Cells of position and direction while a map is built.

use super::arm::{Positions, ToolGoal};
use super::directions::Directions;
use super::{CapabilityMap, Grid, MapOrigin};
use crate::MAX_CHAIN;
use std::ops::Range;

/// Index of a voxel with a direction: row times the number of directions, plus the direction.
pub(super) type Cell = u32;

const NONE: u32 = u32::MAX;

/// State of the cells while a map is built. A voxel gets a row when something near it is reached.
pub(super) struct Cells {
    grid: Grid,
    pub(super) directions: Directions,
    /// Row of each voxel, or [`NONE`].
    row_of: Vec<u32>,
    /// Voxel of each row.
    voxel_of: Vec<u32>,
    /// For each cell, the index of positions that reach its centre, or [`NONE`].
    reached: Vec<u32>,
    /// For each cell, the number of failed attempts to reach its centre.
    failures: Vec<u8>,
    /// Positions with `width` variables each; single precision halves the memory.
    positions: Vec<f32>,
    /// Number of variables of the chain, at least 1.
    width: usize,
}

impl Cells {
    pub(super) fn new(grid: Grid, directions: Directions, dof: usize) -> Self {
        Self {
            row_of: vec![NONE; grid.voxels()],
            grid,
            directions,
            voxel_of: Vec::new(),
            reached: Vec::new(),
            failures: Vec::new(),
            positions: Vec::new(),
            width: dof.max(1),
        }
    }

    /// All cells that have rows.
    pub(super) fn all(&self) -> Range<Cell> {
        0..self.reached.len() as Cell
    }

    /// Returns voxel and direction of a tool.
    pub(super) fn at(&self, tool: &ToolGoal) -> Option<(usize, usize)> {
        let voxel = self.grid.at(&tool.point)?;
        Some((voxel, self.directions.nearest(&tool.axis)))
    }

    /// Whether the cell has a row and is reached.
    pub(super) fn is_known(&self, voxel: usize, direction: usize) -> bool {
        let row = self.row_of[voxel];
        row != NONE && self.is_reached(self.in_row(row, direction))
    }

    /// Returns the cell of a voxel and a direction; the voxel gets a row if it has none.
    pub(super) fn cell(&mut self, voxel: usize, direction: usize) -> Cell {
        if self.row_of[voxel] == NONE {
            self.row_of[voxel] = self.voxel_of.len() as u32;
            self.voxel_of.push(voxel as u32);
            let cells = self.voxel_of.len() * self.directions.count();
            self.reached.resize(cells, NONE);
            self.failures.resize(cells, 0);
        }
        self.in_row(self.row_of[voxel], direction)
    }

    fn in_row(&self, row: u32, direction: usize) -> Cell {
        row * self.directions.count() as u32 + direction as u32
    }

    fn voxel_and_direction(&self, cell: Cell) -> (usize, usize) {
        let count = self.directions.count();
        let (row, direction) = (cell as usize / count, cell as usize % count);
        (self.voxel_of[row] as usize, direction)
    }

    /// Returns the tool at the centre of a cell.
    pub(super) fn center(&self, cell: Cell) -> ToolGoal {
        let (voxel, direction) = self.voxel_and_direction(cell);
        ToolGoal {
            point: self.grid.center(voxel),
            axis: self.directions.nodes()[direction],
        }
    }

    pub(super) fn is_reached(&self, cell: Cell) -> bool {
        self.reached[cell as usize] != NONE
    }

    /// Returns the positions that reach a reached cell.
    pub(super) fn positions(&self, cell: Cell) -> Positions {
        let first = self.reached[cell as usize] as usize * self.width;
        let stored = &self.positions[first..first + self.width];
        let mut q = [0.0; MAX_CHAIN];
        for (q, &stored) in q.iter_mut().zip(stored) {
            *q = f64::from(stored);
        }
        q
    }

    pub(super) fn reach(&mut self, cell: Cell, q: &Positions) {
        self.reached[cell as usize] = (self.positions.len() / self.width) as u32;
        let stored = q[..self.width].iter().map(|&q| q as f32);
        self.positions.extend(stored);
    }

    /// Marks all cells as not reached.
    pub(super) fn forget(&mut self) {
        self.reached.fill(NONE);
        self.positions.clear();
    }

    pub(super) fn failures(&self, cell: Cell) -> u32 {
        u32::from(self.failures[cell as usize])
    }

    pub(super) fn fail(&mut self, cell: Cell, times: u32) {
        let failures = &mut self.failures[cell as usize];
        *failures = failures.saturating_add(times as u8);
    }

    /// Gives rows to the voxels beside a cell.
    pub(super) fn surround(&mut self, cell: Cell) {
        let (voxel, direction) = self.voxel_and_direction(cell);
        for beside in self.grid.beside(voxel) {
            self.cell(beside, direction);
        }
    }

    /// Iterates over the neighbours of a cell that have rows: one voxel further along an axis, or in an adjacent
    /// direction.
    pub(super) fn neighbours(&self, cell: Cell) -> impl Iterator<Item = Cell> {
        let (voxel, direction) = self.voxel_and_direction(cell);
        let rows = self.grid.beside(voxel).map(|beside| self.row_of[beside]);
        let moved = rows
            .filter(|&row| row != NONE)
            .map(move |row| self.in_row(row, direction));
        let row = self.row_of[voxel];
        let turned = self.directions.neighbours(direction).iter();
        moved.chain(turned.map(move |&other| self.in_row(row, other)))
    }

    /// Whether a cell and its neighbours are partly reached.
    pub(super) fn is_boundary(&self, cell: Cell) -> bool {
        let is_reached = self.is_reached(cell);
        self.neighbours(cell)
            .any(|beside| self.is_reached(beside) != is_reached)
    }

    /// Returns the map of the values of all cells, cropped to the reached voxels.
    pub(super) fn into_map(self, values: &[u8], about: MapOrigin) -> CapabilityMap {
        let count = self.directions.count();
        let is_empty = |row: u32| {
            row == NONE
                || values[row as usize * count..][..count]
                    .iter()
                    .all(|&v| v == 0)
        };
        let filled = (0..self.grid.voxels()).filter(|&voxel| !is_empty(self.row_of[voxel]));
        let (grid, shift) = self.grid.crop(filled);
        let strides = self.grid.strides();
        let mut rows = Vec::with_capacity(grid.voxels());
        let mut kept = vec![0; count];
        for voxel in 0..grid.voxels() {
            let place = grid.place(voxel);
            let whole: usize = (0..3).map(|i| (place[i] + shift[i]) * strides[i]).sum();
            let row = self.row_of[whole];
            if is_empty(row) {
                rows.push(0);
            } else {
                rows.push((kept.len() / count) as u32);
                kept.extend_from_slice(&values[row as usize * count..][..count]);
            }
        }
        CapabilityMap {
            about,
            grid,
            directions: self.directions,
            rows,
            values: kept,
        }
    }
}

impl Grid {
    /// Iterates over the neighbours of a voxel along each axis.
    fn beside(&self, voxel: usize) -> impl Iterator<Item = usize> + use<> {
        let (place, strides, counts) = (self.place(voxel), self.strides(), self.counts);
        (0..3).flat_map(move |axis| {
            let lower = (place[axis] > 0).then(|| voxel - strides[axis]);
            let upper = (place[axis] + 1 < counts[axis]).then(|| voxel + strides[axis]);
            [lower, upper].into_iter().flatten()
        })
    }

    /// Returns the part of this grid around the given voxels, with a margin of one voxel where the grid has it, and its
    /// offset along each axis in voxels.
    fn crop(&self, voxels: impl Iterator<Item = usize>) -> (Self, [usize; 3]) {
        let (mut least, mut most) = (self.counts, [0; 3]);
        for voxel in voxels {
            let place = self.place(voxel);
            for axis in 0..3 {
                least[axis] = least[axis].min(place[axis]);
                most[axis] = most[axis].max(place[axis]);
            }
        }
        let first = least.map(|place| place.saturating_sub(1));
        let mut part = *self;
        for axis in 0..3 {
            part.lowest[axis] += first[axis] as i32;
            let end = self.counts[axis].min(most[axis] + 2);
            part.counts[axis] = end.saturating_sub(first[axis]).max(1);
        }
        (part, first)
    }
}
