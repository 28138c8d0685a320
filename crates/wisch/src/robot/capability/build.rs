//! Making a map: sample, spread, refine.

use super::arm::{Arm, Positions};
use super::directions::{Directions, FREQUENCIES};
use super::{CapabilityMap, FULL, Grid, MapError, MapOrigin, RobotHash};
use crate::geometry::{Point3, Pose, Vector3};
use crate::robot::{LinkId, MAX_CHAIN, RobotModel};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// How finely and how carefully a map is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapConfig {
    /// Edge of a voxel [m].
    pub voxel: f64,
    /// Fineness of the grid of directions: it has 10 frequency² + 2.
    pub frequency: u32,
    /// How many random positions of the joints are tried.
    pub samples: u64,
    /// Seed of the random positions.
    pub seed: u64,
    /// From how many poses reached nearby inverse kinematics starts at most, before a pose counts as
    /// out of reach.
    pub starts: u32,
    /// How many poses are tried of a cell at the boundary, besides its centre.
    pub refinements: u32,
}

impl Default for MapConfig {
    fn default() -> Self {
        Self {
            voxel: 0.05,
            frequency: 4,
            samples: 1_000_000,
            seed: 0,
            starts: 4,
            refinements: 4,
        }
    }
}

/// What building a map is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MapStage {
    /// Random positions: done of all samples.
    Sampling,
    /// Inverse kinematics from cell to cell: cells tried, of those known to be worth it so far.
    Spreading,
    /// The cells at the boundary: done of all.
    Refining,
}

/// Most voxels in the box of everything that might be reached.
const MAX_VOXELS: usize = 1 << 24;

/// Samples per seed: threads take them as they come.
const CHUNK: u64 = 4096;
/// Chunks before their results are written down.
const BATCH: u64 = 64;
/// Cells after which progress is reported.
const CELLS_PER_REPORT: usize = 4096;

impl MapConfig {
    /// Whether every setting is in its range.
    ///
    /// # Errors
    /// The first that is not.
    pub(super) fn check(&self) -> Result<(), MapError> {
        let (coarsest, finest) = (*FREQUENCIES.start() as f64, *FREQUENCIES.end() as f64);
        for (field, value, lower, upper) in [
            ("voxel", self.voxel, 1e-3, 10.0),
            ("frequency", f64::from(self.frequency), coarsest, finest),
            ("samples", self.samples as f64, 1.0, 1e12),
            ("starts", f64::from(self.starts), 1.0, 100.0),
            ("refinements", f64::from(self.refinements), 0.0, 100.0),
        ] {
            if !(lower..=upper).contains(&value) {
                return Err(MapError::Setting {
                    field,
                    value,
                    lower,
                    upper,
                });
            }
        }
        Ok(())
    }
}

impl CapabilityMap {
    /// Makes the map of the chain from `base` to `tip`, which carries a tool.
    ///
    /// The other joints of the robot stay at the `posture` (n variables) [rad or m]. `is_free` says of
    /// positions of the whole robot (n) whether nothing collides. `progress` is called from time to
    /// time, from several threads, with what is done of what is to do. The result is the same on any
    /// number of threads.
    ///
    /// # Errors
    /// If a setting is out of range, the posture does not fit the robot, the tip does not hang on the
    /// base, a sliding joint has no limits, or nothing can be reached.
    pub fn build(
        robot: &RobotModel,
        (base, tip, tip_from_tool): (LinkId, LinkId, Pose),
        posture: &[f64],
        is_free: impl Fn(&[f64]) -> bool + Sync,
        config: &MapConfig,
        progress: impl Fn(MapStage, u64, u64) + Sync,
    ) -> Result<Self, MapError> {
        config.check()?;
        robot.checked("posture", posture)?;
        let arm = Arm::new(robot, base, tip, tip_from_tool)?;
        let name = |link: LinkId| robot.links()[link.index()].name.clone();
        let about = MapOrigin {
            robot: RobotHash::of(robot),
            base: name(base),
            tip: name(tip),
            tip_from_tool,
            config: *config,
        };
        let half = (arm.reach / config.voxel).ceil() + 2.0;
        let voxels = (2.0 * half + 1.0).powi(3);
        if voxels > MAX_VOXELS as f64 {
            return Err(MapError::TooFine {
                value: voxels,
                reach: arm.reach,
                voxel: config.voxel,
                limit: MAX_VOXELS,
            });
        }
        let grid = Grid {
            voxel: config.voxel,
            lowest: [-(half as i32); 3],
            counts: [2 * half as usize + 1; 3],
        };
        let mut builder = Builder {
            arm: &arm,
            posture,
            is_free: &is_free,
            config,
            progress: &progress,
            cells: Cells::new(
                grid,
                Directions::new(config.frequency as usize),
                arm.chain.dof(),
            ),
        };
        let seeds = builder.sample();
        if seeds.is_empty() {
            return Err(MapError::NothingReached {
                samples: config.samples,
            });
        }
        builder.spread(seeds);
        let values = builder.refine();
        Ok(builder.cells.into_map(values, about))
    }
}

/// A voxel with a direction.
type Cell = u32;

const NONE: u32 = u32::MAX;

/// What is known of cells while the map is made. Voxels have rows only once something is near.
struct Cells {
    grid: Grid,
    directions: Directions,
    /// Row of each voxel, or [`NONE`].
    row_of: Vec<u32>,
    /// Voxel of each row.
    voxel_of: Vec<u32>,
    /// Per cell: number of the positions that reach its centre, or [`NONE`].
    reached: Vec<u32>,
    /// Per cell: how many starts have failed.
    failures: Vec<u8>,
    /// Positions of n variables each.
    positions: Vec<f32>,
    dof: usize,
}

impl Cells {
    fn new(grid: Grid, directions: Directions, dof: usize) -> Self {
        Self {
            row_of: vec![NONE; grid.voxels()],
            grid,
            directions,
            voxel_of: Vec::new(),
            reached: Vec::new(),
            failures: Vec::new(),
            positions: Vec::new(),
            dof,
        }
    }

    /// The cell of a voxel and a direction; from now on it has a row.
    fn cell(&mut self, voxel: usize, direction: usize) -> Cell {
        let count = self.directions.count();
        if self.row_of[voxel] == NONE {
            self.row_of[voxel] = self.voxel_of.len() as u32;
            self.voxel_of.push(voxel as u32);
            self.reached.resize(self.reached.len() + count, NONE);
            self.failures.resize(self.failures.len() + count, 0);
        }
        self.row_of[voxel] * count as u32 + direction as u32
    }

    fn voxel_and_direction(&self, cell: Cell) -> (usize, usize) {
        let count = self.directions.count();
        let (row, direction) = (cell as usize / count, cell as usize % count);
        (self.voxel_of[row] as usize, direction)
    }

    /// The tool at the centre of a cell: its place and its z axis in the base.
    fn center(&self, cell: Cell) -> (Point3, Vector3) {
        let (voxel, direction) = self.voxel_and_direction(cell);
        (self.grid.center(voxel), self.directions.nodes()[direction])
    }

    fn is_reached(&self, cell: Cell) -> bool {
        self.reached[cell as usize] != NONE
    }

    /// Positions that reach a cell.
    fn positions(&self, cell: Cell) -> Positions {
        let first = self.reached[cell as usize] as usize * self.dof;
        let mut q = [0.0; MAX_CHAIN];
        let stored = &self.positions[first..first + self.dof];
        q.iter_mut()
            .zip(stored)
            .for_each(|(q, &s)| *q = f64::from(s));
        q
    }

    fn reach(&mut self, cell: Cell, q: &Positions) {
        self.reached[cell as usize] = (self.positions.len() / self.dof) as u32;
        let stored = q[..self.dof].iter().map(|&q| q as f32);
        self.positions.extend(stored);
    }

    /// The voxels beside a voxel. None beyond the box: it is wider than the reach.
    fn beside(&self, voxel: usize) -> impl Iterator<Item = usize> + use<> {
        let (place, strides, counts) = (
            self.grid.place(voxel),
            self.grid.strides(),
            self.grid.counts,
        );
        (0..3).flat_map(move |axis| {
            let lower = (place[axis] > 0).then(|| voxel - strides[axis]);
            let upper = (place[axis] + 1 < counts[axis]).then(|| voxel + strides[axis]);
            [lower, upper].into_iter().flatten()
        })
    }

    /// The known cells beside a cell.
    fn neighbours(&self, cell: Cell) -> impl Iterator<Item = Cell> {
        let (voxel, direction) = self.voxel_and_direction(cell);
        let count = self.directions.count() as u32;
        let in_row = move |row: u32, direction: usize| row * count + direction as u32;
        let rows = self.beside(voxel).map(|v| self.row_of[v]);
        let moved = rows
            .filter(|&row| row != NONE)
            .map(move |row| in_row(row, direction));
        let row = cell / count;
        let turned = self.directions.neighbours(direction).iter();
        moved.chain(turned.map(move |&other| in_row(row, other)))
    }

    fn into_map(self, values: Vec<u8>, about: MapOrigin) -> CapabilityMap {
        let count = self.directions.count();
        let row_of = |voxel: usize| {
            let row = self.row_of[voxel];
            let values = (row != NONE).then(|| &values[row as usize * count..][..count])?;
            values.iter().any(|&v| v > 0).then_some(values)
        };
        let filled = (0..self.grid.voxels()).filter(|&v| row_of(v).is_some());
        let mut least = self.grid.counts;
        let mut most = [0; 3];
        for voxel in filled {
            let place = self.grid.place(voxel);
            for axis in 0..3 {
                least[axis] = least[axis].min(place[axis]);
                most[axis] = most[axis].max(place[axis]);
            }
        }
        // One empty voxel all round, so that everything outside the box is out of reach.
        let first = least.map(|l| l.saturating_sub(1));
        let mut grid = self.grid;
        for axis in 0..3 {
            grid.lowest[axis] += first[axis] as i32;
            grid.counts[axis] = (most[axis] + 2).min(self.grid.counts[axis]) - first[axis];
        }
        let strides = self.grid.strides();
        let mut rows = Vec::with_capacity(grid.voxels());
        let mut kept = vec![0; count];
        for voxel in 0..grid.voxels() {
            let place = grid.place(voxel);
            let whole = (0..3).map(|a| (place[a] + first[a]) * strides[a]).sum();
            match row_of(whole) {
                None => rows.push(0),
                Some(values) => {
                    rows.push((kept.len() / count) as u32);
                    kept.extend_from_slice(values);
                }
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

struct Builder<'a, F, P> {
    arm: &'a Arm,
    posture: &'a [f64],
    is_free: &'a F,
    config: &'a MapConfig,
    progress: &'a P,
    cells: Cells,
}

impl<F: Fn(&[f64]) -> bool + Sync, P: Fn(MapStage, u64, u64) + Sync> Builder<'_, F, P> {
    /// Whether the chain may be at these positions; `all` are those of the robot.
    fn is_allowed(&self, q: &Positions, all: &mut [f64]) -> bool {
        for (&variable, &q) in self.arm.chain.variables().iter().zip(q) {
            all[variable] = q;
        }
        self.arm.within(all) && (self.is_free)(all)
    }

    /// Tries random positions; returns cells that a sample falls into, with its positions.
    fn sample(&mut self) -> Vec<(Cell, Positions)> {
        let mut seeds = Vec::new();
        let chunks = self.config.samples.div_ceil(CHUNK);
        let done = AtomicU64::new(0);
        for batch in (0..chunks).step_by(BATCH as usize) {
            let of_chunk = |chunk: u64| {
                let found = self.sample_chunk(chunk);
                let size = CHUNK.min(self.config.samples - chunk * CHUNK);
                let done = done.fetch_add(size, Ordering::Relaxed) + size;
                (self.progress)(MapStage::Sampling, done, self.config.samples);
                found
            };
            let found: Vec<Vec<(usize, usize, Positions)>> = (batch..(batch + BATCH).min(chunks))
                .into_par_iter()
                .map(of_chunk)
                .collect();
            for (voxel, direction, q) in found.into_iter().flatten() {
                let cell = self.cells.cell(voxel, direction);
                if !self.cells.is_reached(cell) {
                    self.cells.reach(cell, &q);
                    seeds.push((cell, q));
                }
            }
        }
        // A sample reaches its own pose, not the centre of the cell.
        self.cells.reached.fill(NONE);
        self.cells.positions.clear();
        seeds
    }

    /// Positions in cells that had none before this batch.
    fn sample_chunk(&self, chunk: u64) -> Vec<(usize, usize, Positions)> {
        let mut random = ChaCha8Rng::seed_from_u64(self.config.seed);
        random.set_stream(chunk);
        let mut all = self.posture.to_vec();
        let mut found = Vec::new();
        for _ in 0..CHUNK.min(self.config.samples - chunk * CHUNK) {
            let q = self.arm.sample(&mut random);
            let Some(base_from_tool) = self.arm.base_from_tool(&q) else {
                continue;
            };
            let point = Point3::from(base_from_tool.translation.vector);
            let Some(voxel) = self.cells.grid.at(&point) else {
                continue;
            };
            let axis = base_from_tool.rotation * Vector3::z();
            let direction = self.cells.directions.nearest(&axis);
            let row = self.cells.row_of[voxel];
            let count = self.cells.directions.count();
            let is_known =
                row != NONE && self.cells.reached[row as usize * count + direction] != NONE;
            if !is_known && self.is_allowed(&q, &mut all) {
                found.push((voxel, direction, q));
            }
        }
        found
    }

    /// Reaches the centres of cells: those of the samples, then those beside cells reached.
    fn spread(&mut self, seeds: Vec<(Cell, Positions)>) {
        let total = AtomicU64::new(seeds.len() as u64);
        let done = AtomicU64::new(0);
        let mut fresh: Vec<(Cell, Positions)> =
            self.each(&seeds, &done, &total, |(cell, q), all| {
                let (point, axis) = self.cells.center(*cell);
                self.reach(&point, &axis, q, all).map(|q| (*cell, q))
            });
        while !fresh.is_empty() {
            for (cell, q) in &fresh {
                self.cells.reach(*cell, q);
            }
            let waiting = self.beside(&fresh);
            let groups: Vec<&[(Cell, Cell)]> = waiting.chunk_by(|a, b| a.0 == b.0).collect();
            total.fetch_add(groups.len() as u64, Ordering::Relaxed);
            let tried: Vec<(Cell, usize, Option<Positions>)> =
                self.each(&groups, &done, &total, |group, all| {
                    Some(self.try_group(group, all))
                });
            fresh.clear();
            for (cell, failures, found) in tried {
                let known = &mut self.cells.failures[cell as usize];
                *known = known.saturating_add(failures as u8);
                fresh.extend(found.map(|q| (cell, q)));
            }
        }
    }

    /// Pairs of a cell that is not reached yet and one beside it that just was.
    fn beside(&mut self, fresh: &[(Cell, Positions)]) -> Vec<(Cell, Cell)> {
        let mut waiting = Vec::new();
        for &(from, _) in fresh {
            let (voxel, direction) = self.cells.voxel_and_direction(from);
            for beside in self.cells.beside(voxel) {
                self.cells.cell(beside, direction);
            }
            let starts = self.config.starts as u8;
            let open = |&cell: &Cell| {
                !self.cells.is_reached(cell) && self.cells.failures[cell as usize] < starts
            };
            waiting.extend(
                self.cells
                    .neighbours(from)
                    .filter(open)
                    .map(|cell| (cell, from)),
            );
        }
        waiting.sort_unstable();
        waiting
    }

    /// Tries to reach a cell from those beside it; how many starts failed, and positions.
    fn try_group(
        &self,
        group: &[(Cell, Cell)],
        all: &mut [f64],
    ) -> (Cell, usize, Option<Positions>) {
        let cell = group[0].0;
        let (point, axis) = self.cells.center(cell);
        let left = self.config.starts as usize - usize::from(self.cells.failures[cell as usize]);
        for (failures, &(_, from)) in group.iter().take(left).enumerate() {
            let start = self.cells.positions(from);
            if let Some(q) = self.reach(&point, &axis, &start, all) {
                return (cell, failures, Some(q));
            }
        }
        (cell, group.len().min(left), None)
    }

    /// Positions that put the tool to a point with its axis, near those to start from.
    fn reach(
        &self,
        point: &Point3,
        axis: &Vector3,
        start: &Positions,
        all: &mut [f64],
    ) -> Option<Positions> {
        let q = self.arm.approach(point, axis, start)?;
        self.is_allowed(&q, all).then_some(q)
    }

    /// The values of all cells that have rows.
    fn refine(&self) -> Vec<u8> {
        let is_boundary = |&cell: &Cell| {
            let reached = self.cells.is_reached(cell);
            self.cells
                .neighbours(cell)
                .any(|n| self.cells.is_reached(n) != reached)
        };
        let cells = 0..self.cells.reached.len() as u32;
        let boundary: Vec<Cell> = cells.into_par_iter().filter(is_boundary).collect();
        let (done, total) = (AtomicU64::new(0), AtomicU64::new(boundary.len() as u64));
        let shares = self.each_of(
            MapStage::Refining,
            &boundary,
            &done,
            &total,
            |&cell, all| Some((cell, self.share(cell, all))),
        );
        let plain = |&reached: &u32| if reached == NONE { 0 } else { FULL };
        let mut values: Vec<u8> = self.cells.reached.iter().map(plain).collect();
        for (cell, share) in shares {
            values[cell as usize] = share;
        }
        values
    }

    /// The share of poses of a cell that can be reached, in parts of [`FULL`].
    fn share(&self, cell: Cell, all: &mut [f64]) -> u8 {
        let (point, axis) = self.cells.center(cell);
        let own = self.cells.is_reached(cell).then_some(cell);
        let beside = self
            .cells
            .neighbours(cell)
            .filter(|&n| self.cells.is_reached(n));
        let starts: Vec<Positions> = own
            .into_iter()
            .chain(beside)
            .take(self.config.starts as usize)
            .map(|start| self.cells.positions(start))
            .collect();
        let mut hits = u32::from(own.is_some());
        for i in 0..self.config.refinements {
            let number = u64::from(cell) * u64::from(self.config.refinements) + u64::from(i);
            let offset = spread_evenly(number);
            let (point, axis) = self.pose_nearby(&point, &axis, &offset);
            let is_reached = |start: &Positions| self.reach(&point, &axis, start, all).is_some();
            hits += u32::from(starts.iter().any(is_reached));
        }
        let share = f64::from(hits) / f64::from(self.config.refinements + 1);
        (share * f64::from(FULL)).round() as u8
    }

    /// A pose of the cell round a pose, by five numbers from 0 to 1.
    fn pose_nearby(&self, point: &Point3, axis: &Vector3, offset: &[f64; 5]) -> (Point3, Vector3) {
        let [x, y, z, out, round] = *offset;
        let moved = point + self.config.voxel * (Vector3::new(x, y, z) - Vector3::repeat(0.5));
        // A disc as large as the share of the sphere that a direction has: π r² = 4 π / count.
        let radius = 2.0 / (self.cells.directions.count() as f64).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * round).sin_cos();
        let side = if axis.x.abs() < 0.6 {
            Vector3::x()
        } else {
            Vector3::y()
        };
        let right = axis.cross(&side).normalize();
        let up = axis.cross(&right);
        let turned = axis + radius * out.sqrt() * (cos * right + sin * up);
        (moved, turned.normalize())
    }

    fn each<T: Sync, R: Send>(
        &self,
        items: &[T],
        done: &AtomicU64,
        total: &AtomicU64,
        work: impl Fn(&T, &mut [f64]) -> Option<R> + Sync,
    ) -> Vec<R> {
        self.each_of(MapStage::Spreading, items, done, total, work)
    }

    /// The results of `work` on all items, in their order, on all threads.
    fn each_of<T: Sync, R: Send>(
        &self,
        stage: MapStage,
        items: &[T],
        done: &AtomicU64,
        total: &AtomicU64,
        work: impl Fn(&T, &mut [f64]) -> Option<R> + Sync,
    ) -> Vec<R> {
        let of_chunk = |chunk: &[T]| {
            let mut all = self.posture.to_vec();
            let results: Vec<R> = chunk
                .iter()
                .filter_map(|item| work(item, &mut all))
                .collect();
            let size = chunk.len() as u64;
            let done = done.fetch_add(size, Ordering::Relaxed) + size;
            (self.progress)(stage, done, total.load(Ordering::Relaxed));
            results
        };
        let chunks: Vec<Vec<R>> = items.par_chunks(CELLS_PER_REPORT).map(of_chunk).collect();
        chunks.into_iter().flatten().collect()
    }
}

/// Points of the unit cube of five dimensions that any run of numbers spreads evenly: multiples of the
/// powers of the root of x⁶ = x + 1 (Roberts 2018, *The unreasonable effectiveness of quasirandom
/// sequences*).
fn spread_evenly(number: u64) -> [f64; 5] {
    const ROOT: f64 = 1.134_724_138_401_519_4;
    let mut power = 1.0;
    [(); 5].map(|()| {
        power /= ROOT;
        (0.5 + number as f64 * power).fract()
    })
}
