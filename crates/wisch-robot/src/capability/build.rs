//! Building of a capability map: sample, spread, refine.

use super::arm::{Arm, Positions, ToolGoal};
use super::cells::{Cell, Cells};
use super::directions::Directions;
use super::{
    CapabilityMap, FULL, Grid, MapConfig, MapError, MapOrigin, MapRequest, MapStage, RobotHash,
};
use crate::LinkId;
use crate::geometry::Vector3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Largest number of cells in the bounding box of the reachable space.
pub(super) const MAX_CELLS: usize = 1 << 30;

/// Number of samples per random stream; threads take streams in any order.
const CHUNK: u64 = 4096;
/// Number of chunks between two updates of the cells.
const BATCH: u64 = 64;
/// Number of cells between two progress reports.
const CELLS_PER_REPORT: usize = 4096;

impl CapabilityMap {
    /// Builds the capability map of a tool.
    ///
    /// `is_free` returns whether the positions of all variables of the robot (n) are free of collisions. `progress` is
    /// called occasionally, from several threads and not always in order, with a stage, the work done and the work
    /// known so far. The map does not depend on the number of threads.
    ///
    /// ```
    /// # use wisch_robot::{CapabilityMap, MapConfig, MapRequest, RobotModel};
    /// # let joint = |name: &str, parent: &str, child: &str, axis: &str, range: &str| format!(
    /// #     r#"<joint name="{name}" type="{}"><parent link="{parent}"/><child link="{child}"/>
    /// #        <axis xyz="{axis}"/>{range}</joint><link name="{child}"/>"#,
    /// #     if name == "slide" { "prismatic" } else { "continuous" });
    /// # let text = format!(r#"<robot name="telescope"><link name="floor"/>{}{}{}{}{}</robot>"#,
    /// #     joint("yaw", "floor", "turret", "0 0 1", ""), joint("pitch", "turret", "tube", "0 1 0", ""),
    /// #     joint("slide", "tube", "rod", "1 0 0", r#"<limit lower="0.3" upper="0.6"/>"#),
    /// #     joint("roll", "rod", "wrist", "1 0 0", ""), joint("bend", "wrist", "tool", "0 1 0", ""));
    /// # let robot = RobotModel::from_urdf("telescope", &text, &mut |_| Err(String::new()))?;
    /// use wisch_robot::geometry::{Point3, Pose};
    /// // A telescope from 0.3 m to 0.6 m that points in any direction, as does the tool at its end.
    /// let tool = MapRequest {
    ///     robot: &robot,
    ///     base: robot.root(),
    ///     tip: robot.link("tool")?,
    ///     tip_from_tool: Pose::identity(),
    ///     posture: &[0.0; 5],
    /// };
    /// let config = MapConfig { voxel: 0.1, frequency: 2, samples: 20_000, ..MapConfig::default() };
    /// let map = CapabilityMap::build(&tool, |_| true, &config, |_, _, _| {})?;
    /// assert!(map.is_reachable(&Pose::translation(0.3, 0.2, 0.2)));
    /// assert!(!map.is_reachable(&Pose::translation(0.5, 0.5, 0.2)));
    /// assert!(map.index(&Point3::new(0.0, 0.45, 0.0)) > 0.95);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a setting is out of range, the posture does not fit the robot, the tip is no descendant
    /// of the base, a sliding joint has no limits, there are too many cells, or nothing can be
    /// reached. An arm that cannot tilt its tool, such as a SCARA, reaches nothing, because its
    /// tool's axis is in none of the map's directions.
    ///
    /// # Panics
    /// If a link belongs to another, larger robot.
    pub fn build(
        tool: &MapRequest<'_>,
        is_free: impl Fn(&[f64]) -> bool + Sync,
        config: &MapConfig,
        progress: impl Fn(MapStage, u64, u64) + Sync,
    ) -> Result<Self, MapError> {
        config.check()?;
        tool.robot.check_values("posture", tool.posture)?;
        let arm = Arm::new(tool)?;
        let grid = grid(&arm, config)?;
        let directions = Directions::new(config.frequency as usize);
        let mut builder = Builder {
            cells: Cells::new(grid, directions, arm.variables().len()),
            arm: &arm,
            posture: tool.posture,
            is_free: &is_free,
            config,
            progress: &progress,
        };
        let seeds = builder.sample();
        if seeds.is_empty() {
            return Err(MapError::NothingReached {
                samples: config.samples,
            });
        }
        builder.spread(&seeds);
        if !builder
            .cells
            .all()
            .any(|cell| builder.cells.is_reached(cell))
        {
            return Err(MapError::NoCenterReached { cells: seeds.len() });
        }
        let values = builder.refine();
        let name = |link: LinkId| tool.robot.links()[link.index()].name.clone();
        let about = MapOrigin {
            robot: RobotHash::from_robot(tool.robot),
            base: name(tool.base),
            tip: name(tool.tip),
            tip_from_tool: tool.tip_from_tool,
            config: *config,
        };
        Ok(builder.cells.into_map(&values, about))
    }
}

/// Returns voxels up to the reach of the arm plus two, so that every reached voxel has neighbours.
fn grid(arm: &Arm, config: &MapConfig) -> Result<Grid, MapError> {
    let half = (arm.reach / config.voxel).ceil() + 2.0;
    let voxels = (2.0 * half + 1.0).powi(3);
    if voxels * config.directions() as f64 > MAX_CELLS as f64 {
        return Err(MapError::TooFine {
            voxels,
            directions: config.directions(),
            reach: arm.reach,
            voxel: config.voxel,
            limit: MAX_CELLS,
        });
    }
    Ok(Grid {
        voxel: config.voxel,
        lowest: [-(half as i32); 3],
        counts: [2 * half as usize + 1; 3],
    })
}

struct Builder<'a, F, P> {
    arm: &'a Arm,
    posture: &'a [f64],
    is_free: &'a F,
    config: &'a MapConfig,
    progress: &'a P,
    cells: Cells,
}

/// A cell, and positions of the chain: those that reach its centre, or of a sample somewhere in the cell.
type Reached = (Cell, Positions);

/// Progress of a stage.
struct Stage {
    stage: MapStage,
    done: AtomicU64,
    total: AtomicU64,
}

impl Stage {
    const fn new(stage: MapStage, total: u64) -> Self {
        Self {
            stage,
            done: AtomicU64::new(0),
            total: AtomicU64::new(total),
        }
    }
}

impl<F: Fn(&[f64]) -> bool + Sync, P: Fn(MapStage, u64, u64) + Sync> Builder<'_, F, P> {
    /// Tries random positions, and returns the first that falls into each cell.
    fn sample(&mut self) -> Vec<Reached> {
        let mut seeds = Vec::new();
        let chunks = self.config.samples.div_ceil(CHUNK);
        let stage = Stage::new(MapStage::Sampling, self.config.samples);
        for batch in (0..chunks).step_by(BATCH as usize) {
            let batch = batch..chunks.min(batch + BATCH);
            let of_chunk = |chunk| {
                let size = CHUNK.min(self.config.samples - chunk * CHUNK);
                let found = self.sample_chunk(chunk, size);
                self.report(&stage, size);
                found
            };
            let found: Vec<_> = batch.into_par_iter().map(of_chunk).collect();
            for (voxel, direction, q) in found.into_iter().flatten() {
                let cell = self.cells.cell(voxel, direction);
                if !self.cells.is_reached(cell) {
                    self.cells.reach(cell, &q);
                    seeds.push((cell, q));
                }
            }
        }
        // A sample reaches its own pose, and not the centre of the cell.
        self.cells.forget();
        seeds
    }

    /// Returns samples in cells that had none before this batch, with their voxels and directions.
    fn sample_chunk(&self, chunk: u64, size: u64) -> Vec<(usize, usize, Positions)> {
        let mut random = ChaCha8Rng::seed_from_u64(self.config.seed);
        random.set_stream(chunk);
        let mut all = self.posture.to_vec();
        let mut found = Vec::new();
        for _ in 0..size {
            let q = self.arm.sample(&mut random);
            let place = self.arm.tool(&q).and_then(|tool| self.cells.at(&tool));
            if let Some((voxel, direction)) = place
                && !self.cells.is_known(voxel, direction)
                && self.is_allowed(&q, &mut all)
            {
                found.push((voxel, direction, q));
            }
        }
        found
    }

    /// Reaches the centres of cells: first those with samples, then the neighbours of reached cells.
    fn spread(&mut self, seeds: &[Reached]) {
        let stage = Stage::new(MapStage::Spreading, seeds.len() as u64);
        let mut fresh: Vec<Reached> = self.each(&stage, seeds, |(cell, q), all| {
            let q = self.reach(&self.cells.center(*cell), q, all)?;
            Some((*cell, q))
        });
        while !fresh.is_empty() {
            for (cell, q) in &fresh {
                self.cells.reach(*cell, q);
            }
            let pairs = self.pair_with_neighbours(&fresh);
            let groups: Vec<&[(Cell, Cell)]> = pairs.chunk_by(|a, b| a.0 == b.0).collect();
            stage
                .total
                .fetch_add(groups.len() as u64, Ordering::Relaxed);
            let tried = self.each(&stage, &groups, |group, all| {
                Some(self.try_group(group, all))
            });
            fresh.clear();
            for (cell, failures, found) in tried {
                self.cells.fail(cell, failures);
                fresh.extend(found.map(|q| (cell, q)));
            }
        }
    }

    /// Returns pairs of an unreached cell and a newly reached neighbour, in order.
    fn pair_with_neighbours(&mut self, fresh: &[Reached]) -> Vec<(Cell, Cell)> {
        let mut pairs = Vec::new();
        for &(from, _) in fresh {
            self.cells.surround(from);
            let neighbours = self.cells.neighbours(from);
            let open = neighbours.filter(|&cell| {
                !self.cells.is_reached(cell) && self.cells.failures(cell) < self.config.starts
            });
            pairs.extend(open.map(|cell| (cell, from)));
        }
        pairs.sort_unstable();
        pairs
    }

    /// Tries to reach a cell from its paired neighbours; returns the number of failures, and positions if it was
    /// reached.
    fn try_group(&self, group: &[(Cell, Cell)], all: &mut [f64]) -> (Cell, u32, Option<Positions>) {
        let cell = group[0].0;
        let center = self.cells.center(cell);
        let left = self.config.starts - self.cells.failures(cell);
        let mut failures = 0;
        for &(_, from) in group.iter().take(left as usize) {
            let found = self.reach(&center, &self.cells.positions(from), all);
            if found.is_some() {
                return (cell, failures, found);
            }
            failures += 1;
        }
        (cell, failures, None)
    }

    /// Returns the value of every cell.
    fn refine(&self) -> Vec<u8> {
        let cells = self.cells.all().into_par_iter();
        let boundary: Vec<Cell> = cells.filter(|&cell| self.cells.is_boundary(cell)).collect();
        let stage = Stage::new(MapStage::Refining, boundary.len() as u64);
        let shares = self.each(&stage, &boundary, |&cell, all| Some(self.share(cell, all)));
        let value = |cell| if self.cells.is_reached(cell) { FULL } else { 0 };
        let mut values: Vec<u8> = self.cells.all().map(value).collect();
        for (cell, share) in boundary.into_iter().zip(shares) {
            values[cell as usize] = (share * f64::from(FULL)).round() as u8;
        }
        values
    }

    /// Returns the share of a cell's poses that can be reached.
    fn share(&self, cell: Cell, all: &mut [f64]) -> f64 {
        let center = self.cells.center(cell);
        let itself_and_beside = std::iter::once(cell).chain(self.cells.neighbours(cell));
        let starts: Vec<Positions> = itself_and_beside
            .filter(|&cell| self.cells.is_reached(cell))
            .take(self.config.starts as usize)
            .map(|cell| self.cells.positions(cell))
            .collect();
        let count = u64::from(self.config.refinements);
        let mut hits = u64::from(self.cells.is_reached(cell));
        for i in 0..count {
            let goal = self.goal_in_cell(&center, spread_evenly(u64::from(cell) * count + i));
            let is_hit = |start| self.reach(&goal, start, all).is_some();
            hits += u64::from(starts.iter().any(is_hit));
        }
        hits as f64 / (count + 1) as f64
    }

    /// Returns a goal in the cell of `center`, given five numbers in [0, 1].
    fn goal_in_cell(&self, center: &ToolGoal, [x, y, z, out, round]: [f64; 5]) -> ToolGoal {
        let shift = self.config.voxel * (Vector3::new(x, y, z) - Vector3::repeat(0.5));
        // A disc of the solid angle of one direction: π r² = 4 π / count.
        let radius = 2.0 / (self.cells.directions.count() as f64).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * round).sin_cos();
        let across = Vector3::ith(center.axis.iamin(), 1.0);
        let right = center.axis.cross(&across).normalize();
        let up = center.axis.cross(&right);
        let tilt = radius * out.sqrt() * (cos * right + sin * up);
        ToolGoal {
            point: center.point + shift,
            axis: (center.axis + tilt).normalize(),
        }
    }

    /// Returns permitted positions that put the tool at a goal, by a descent from `start`.
    fn reach(&self, goal: &ToolGoal, start: &Positions, all: &mut [f64]) -> Option<Positions> {
        let q = self.arm.approach(goal, start)?;
        self.is_allowed(&q, all).then_some(q)
    }

    /// Whether the chain may be at these positions; `all` is scratch memory for the positions of the robot.
    fn is_allowed(&self, q: &Positions, all: &mut [f64]) -> bool {
        for (&variable, &q) in self.arm.variables().iter().zip(q) {
            all[variable] = q;
        }
        self.arm.is_within_limits(all) && (self.is_free)(all)
    }

    /// Applies `work` to the items on all threads, and returns the results in their order. Each call gets scratch
    /// memory for the positions of the robot.
    fn each<T: Sync, R: Send>(
        &self,
        stage: &Stage,
        items: &[T],
        work: impl Fn(&T, &mut [f64]) -> Option<R> + Sync,
    ) -> Vec<R> {
        let of_chunk = |chunk: &[T]| {
            let mut all = self.posture.to_vec();
            let found: Vec<R> = chunk
                .iter()
                .filter_map(|item| work(item, &mut all))
                .collect();
            self.report(stage, chunk.len() as u64);
            found
        };
        let chunks: Vec<Vec<R>> = items.par_chunks(CELLS_PER_REPORT).map(of_chunk).collect();
        chunks.into_iter().flatten().collect()
    }

    fn report(&self, stage: &Stage, more: u64) {
        let done = stage.done.fetch_add(more, Ordering::Relaxed) + more;
        (self.progress)(stage.stage, done, stage.total.load(Ordering::Relaxed));
    }
}

/// Returns a point of a low-discrepancy sequence in the five-dimensional unit cube: multiples of the powers of 1/x, x⁶
/// = x + 1 (Roberts 2018, *The unreasonable effectiveness of quasirandom sequences*).
fn spread_evenly(number: u64) -> [f64; 5] {
    const ROOT: f64 = 1.134_724_138_401_519_4;
    let mut power = 1.0;
    [(); 5].map(|()| {
        power /= ROOT;
        (0.5 + number as f64 * power).fract()
    })
}
