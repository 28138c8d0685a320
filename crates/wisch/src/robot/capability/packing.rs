//! The rows and values of a map in few bytes.
//!
//! Voxel by voxel: whether it has a row, then the values of the row. A value is guessed from the cells
//! before it, those along x, y and z and those in neighbouring directions; what is coded is how it
//! differs from what usually follows such a guess.

use super::coder::{Decoder, Encoder, Likelihood};
use super::directions::Directions;
use super::{CapabilityMap, FULL, Grid};

/// How many cells differ in spread: see [`Model::guess`].
const SPREADS: usize = 4;
const GUESSES: usize = (FULL as usize + 1) * SPREADS;
/// Bits of a value.
const BITS: u32 = FULL.count_ones();

/// What was learned so far of rows and values.
struct Model {
    /// Whether a voxel has a row, by which of the three before it have.
    filled: [Likelihood; 8],
    /// Per guess: whether the value is not 0, and whether it is not [`FULL`].
    extremes: Vec<[Likelihood; 2]>,
    /// Per guess: the bits of other values, the highest first, by the bits before.
    between: Vec<[Likelihood; 1 << BITS]>,
    /// For each direction up to three neighbours with lower numbers, which are coded before it.
    turned: Vec<[Option<usize>; 3]>,
}

impl Model {
    fn new(directions: &Directions) -> Self {
        let turned = |direction| {
            let neighbours = directions.neighbours(direction).iter().rev();
            let mut lower = neighbours.filter(|&&n| n < direction).copied();
            [lower.next(), lower.next(), lower.next()]
        };
        Self {
            filled: [Likelihood::EVEN; 8],
            extremes: vec![[Likelihood::EVEN; 2]; GUESSES],
            between: vec![[Likelihood::EVEN; 1 << BITS]; GUESSES],
            turned: (0..directions.count()).map(turned).collect(),
        }
    }

    fn filled(&mut self, before: [u32; 3]) -> &mut Likelihood {
        let bit = |row: u32| usize::from(row != 0);
        let [x, y, z] = before.map(bit);
        &mut self.filled[4 * x + 2 * y + z]
    }

    /// What the cells before one say of it: their mean, and how much they differ.
    fn guess(&self, values: &[u8], row: &[u8], before: [usize; 3], direction: usize) -> usize {
        let (mut sum, mut weights) = (0, 0);
        let (mut least, mut most) = (FULL, 0);
        let mut add = |value: u8, weight: usize| {
            sum += usize::from(value) * weight;
            weights += weight;
            (least, most) = (least.min(value), most.max(value));
        };
        for first in before {
            add(values[first + direction], 2);
        }
        for &turned in self.turned[direction].iter().flatten() {
            add(row[turned], 1);
        }
        let mean = (2 * sum + weights) / (2 * weights);
        let spread = match most - least {
            0 => 0,
            1..=5 => 1,
            6..=10 => 2,
            _ => 3,
        };
        mean * SPREADS + spread
    }

    fn encode(&mut self, encoder: &mut Encoder, guess: usize, value: u8) {
        let [not_zero, not_full] = &mut self.extremes[guess];
        encoder.bit(not_zero, value != 0);
        if value == 0 {
            return;
        }
        encoder.bit(not_full, value != FULL);
        if value == FULL {
            return;
        }
        let mut path = 1;
        for shift in (0..BITS).rev() {
            let bit = value >> shift & 1 == 1;
            encoder.bit(&mut self.between[guess][path], bit);
            path = 2 * path + usize::from(bit);
        }
    }

    fn decode(&mut self, decoder: &mut Decoder<'_>, guess: usize) -> u8 {
        let [not_zero, not_full] = &mut self.extremes[guess];
        if !decoder.bit(not_zero) {
            return 0;
        }
        if !decoder.bit(not_full) {
            return FULL;
        }
        let mut path = 1;
        for _ in 0..BITS {
            path = 2 * path + usize::from(decoder.bit(&mut self.between[guess][path]));
        }
        // The highest bit of a path only says where it began.
        (path - (1 << BITS)) as u8
    }
}

impl Grid {
    /// The rows of the voxels before one along x, y and z; 0, the empty one, beyond the grid.
    fn rows_before(&self, voxel: usize, rows: &[u32]) -> [u32; 3] {
        let (place, strides) = (self.place(voxel), self.strides());
        [0, 1, 2].map(|axis| {
            if place[axis] > 0 {
                rows[voxel - strides[axis]]
            } else {
                0
            }
        })
    }
}

pub(super) fn pack(map: &CapabilityMap) -> Vec<u8> {
    let count = map.directions.count();
    let mut encoder = Encoder::new();
    let mut model = Model::new(&map.directions);
    for voxel in 0..map.grid.voxels() {
        let before = map.grid.rows_before(voxel, &map.rows);
        let is_filled = map.rows[voxel] != 0;
        encoder.bit(model.filled(before), is_filled);
        if is_filled {
            let before = before.map(|row| row as usize * count);
            let row = map.row(voxel);
            for (direction, &value) in row.iter().enumerate() {
                let guess = model.guess(&map.values, row, before, direction);
                model.encode(&mut encoder, guess, value);
            }
        }
    }
    encoder.finish()
}

/// Rows of the voxels and values of the rows, of which as many are expected besides the empty one.
pub(super) fn unpack(
    bytes: &[u8],
    grid: &Grid,
    directions: &Directions,
    expected: usize,
) -> Result<(Vec<u32>, Vec<u8>), String> {
    let count = directions.count();
    let mut decoder = Decoder::new(bytes);
    let mut model = Model::new(directions);
    let mut rows = vec![0; grid.voxels()];
    let mut values = vec![0; count];
    values.reserve_exact(expected * count);
    let mut row = vec![0; count];
    let mut found = 0;
    for voxel in 0..grid.voxels() {
        let before = grid.rows_before(voxel, &rows);
        if decoder.bit(model.filled(before)) {
            found += 1;
            if found > expected {
                break;
            }
            rows[voxel] = found as u32;
            let before = before.map(|row| row as usize * count);
            for direction in 0..count {
                let guess = model.guess(&values, &row, before, direction);
                row[direction] = model.decode(&mut decoder, guess);
            }
            values.extend_from_slice(&row);
        }
    }
    if found != expected {
        return Err(format!(
            "{found} or more rows that are not empty, expected {expected}"
        ));
    }
    Ok((rows, values))
}
