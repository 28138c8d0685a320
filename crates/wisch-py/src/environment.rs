//! Parallel worlds for learning to wipe: particles, a tool, and the effect model.

use crate::arrays::{self, Matrix, kind_of};
use crate::error::{plain, refused};
use crate::task::PyTask;
use numpy::ndarray::{Array1, Array2, Array3};
use numpy::{AllowTypeChange, IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayLike2};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};
use wisch::geometry::{Bounds2, Mesh, PlanarPose, Point2, Vector2};
use wisch::represent::{
    DirtArea, EffectModel, GoalState, OccupiedArea, ParticleField, Performance, SourceError,
    Surface, Task, ToolMotion, uniform_particles,
};

/// Length of an action: start x, y, end x, y, and yaw, each -1 to 1.
const ACTION: usize = 5;
/// Length of the tool's observation: x, y in the box of the actions, and cosine and sine of its yaw.
const TOOL: usize = 4;
/// Number of worlds below which a further thread does not save time.
const WORLDS_PER_THREAD: usize = 64;
/// Spreads the seeds of a world's episodes.
const NEXT_EPISODE: u64 = 0x9e37_79b9_7f4a_7c15;

/// Settings that all worlds share.
struct Rules {
    task: Task,
    surface: Surface,
    goal: GoalState,
    occupied: OccupiedArea,
    /// Bounds of the surface, the grid of the density.
    bounds: Bounds2,
    /// Box of the strokes' starts and ends: enlarged, so that a tool can move off the surface.
    reach: Bounds2,
    particles: usize,
    rows: usize,
    columns: usize,
    max_strokes: usize,
    target: f64,
    cost_per_m: f64,
}

/// A world.
struct World {
    seed: u64,
    episode: u64,
    field: ParticleField,
    model: EffectModel,
    tool: PlanarPose,
    strokes: usize,
    performance: f64,
    is_over: bool,
}

/// Result of a step in a world.
#[derive(Default, Clone, Copy)]
struct Outcome {
    reward: f64,
    terminated: bool,
    truncated: bool,
    performance: f64,
}

impl Rules {
    fn begin(&self, seed: u64, episode: u64) -> Result<World, SourceError> {
        let area = DirtArea {
            outline: &self.surface.outline,
            occupied: &self.occupied,
        };
        let drawn = seed.wrapping_add(episode.wrapping_mul(NEXT_EPISODE));
        let particles = uniform_particles(area, self.particles, drawn)?;
        let performance = Performance::evaluate(&particles, &self.goal, &self.surface).ratio();
        Ok(World {
            seed,
            episode,
            field: ParticleField::new(&particles),
            model: (self.task).effect_model(&self.task.tool.footprint, self.task.action.effect()),
            tool: PlanarPose::new(self.task.tool_start, 0.0),
            strokes: 0,
            performance,
            is_over: false,
        })
    }

    /// Executes a stroke in a world; if its episode is over, begins the next episode instead.
    fn step(&self, world: &mut World, action: [f64; ACTION]) -> Result<Outcome, SourceError> {
        if world.is_over {
            *world = self.begin(world.seed, world.episode.wrapping_add(1))?;
            return Ok(Outcome {
                performance: world.performance,
                ..Outcome::default()
            });
        }
        let [x0, y0, x1, y1, turn] = action.map(|x| x.clamp(-1.0, 1.0));
        let heading = turn * std::f64::consts::PI;
        let motion = ToolMotion {
            from: PlanarPose::new(self.place(x0, y0), heading),
            to: PlanarPose::new(self.place(x1, y1), heading),
        };
        world.model.apply(&mut world.field, &self.surface, &motion);
        world.model.lift_off(&mut world.field, &self.surface);
        let way = (motion.from.position - world.tool.position).norm() + motion.travel().1;
        world.tool = motion.to;
        world.strokes += 1;
        let particles = world.field.distribution();
        let performance = Performance::evaluate(&particles, &self.goal, &self.surface).ratio();
        let gain = performance - world.performance;
        world.performance = performance;
        let terminated = performance >= self.target;
        let truncated = !terminated && world.strokes >= self.max_strokes;
        world.is_over = terminated || truncated;
        Ok(Outcome {
            reward: gain - self.cost_per_m * way,
            terminated,
            truncated,
            performance,
        })
    }

    fn place(&self, x: f64, y: f64) -> Point2 {
        self.reach.center() + self.reach.size().component_mul(&Vector2::new(x, y)) / 2.0
    }

    /// Writes the share of a world's particles in each cell of the surface, row by row from the smallest y, and the
    /// tool's pose.
    fn observe(&self, world: &World, density: &mut [f32], tool: &mut [f32]) {
        density.fill(0.0);
        let (min, size) = (self.bounds.min, self.bounds.size());
        let share = 1.0 / self.particles as f32;
        let cell = |at: f64, size: f64, cells: usize| {
            // Rounding may put a point just beyond an edge; it counts in the nearest cell.
            ((at / size * cells as f64).max(0.0) as usize).min(cells - 1)
        };
        for place in world.field.distribution().remaining() {
            let row = cell(place.y - min.y, size.y, self.rows);
            let column = cell(place.x - min.x, size.x, self.columns);
            density[row * self.columns + column] += share;
        }
        let offset = world.tool.position - self.reach.center();
        let half = self.reach.size() / 2.0;
        let (sin, cos) = world.tool.heading.sin_cos();
        let numbers = [offset.x / half.x, offset.y / half.y, cos, sin];
        for (put, number) in tool.iter_mut().zip(numbers) {
            *put = number.clamp(-1.0, 1.0) as f32;
        }
    }
}

/// Parallel worlds of one task, each with particles of its own.
#[pyclass(name = "WipingWorlds", module = "wisch", frozen)]
pub struct PyWipingWorlds {
    rules: Rules,
    worlds: Mutex<Vec<World>>,
}

/// Density (n, rows, columns) and tool (n, 4).
type Observations<'py> = (Bound<'py, PyArray3<f32>>, Bound<'py, PyArray2<f32>>);

impl PyWipingWorlds {
    fn with<T>(&self, run: impl FnOnce(&mut Vec<World>) -> T) -> T {
        run(&mut self.worlds.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn to_arrays<'py>(
        &self,
        py: Python<'py>,
        density: Vec<f32>,
        tool: Vec<f32>,
    ) -> Observations<'py> {
        let Rules { rows, columns, .. } = self.rules;
        let count = tool.len() / TOOL;
        let density = Array3::from_shape_vec((count, rows, columns), density);
        let tool = Array2::from_shape_vec((count, TOOL), tool);
        (
            density.unwrap_or_default().into_pyarray(py),
            tool.unwrap_or_default().into_pyarray(py),
        )
    }
}

#[pymethods]
impl PyWipingWorlds {
    #[new]
    #[pyo3(signature = (task, count, *, particles, rows, columns, max_strokes, target, cost_per_m))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        task: &PyTask,
        count: usize,
        particles: usize,
        rows: usize,
        columns: usize,
        max_strokes: usize,
        target: f64,
        cost_per_m: f64,
    ) -> PyResult<Self> {
        for (name, value, most) in [
            ("num_envs", count, 1 << 20),
            ("particles", particles, 100_000),
            ("rows", rows, 1000),
            ("columns", columns, 1000),
            ("max_strokes", max_strokes, 1_000_000),
        ] {
            if !(1..=most).contains(&value) {
                return Err(refused(name, value, format!("1 to {most}")));
            }
        }
        for (name, value) in [("target", target), ("cost_per_m", cost_per_m)] {
            if !(0.0..=1000.0).contains(&value) {
                return Err(refused(name, value, "0 to 1000"));
            }
        }
        let task = task.loaded.task.clone();
        if !task.surface.shape.is_plane() {
            return Err(plain("these worlds have flat surfaces only"));
        }
        let goal = task
            .goal()
            .ok_or_else(|| plain("the task states no goal of the collect; set collect.goal_m"))?;
        let outline = task.surface.outline.outer().iter().copied();
        let bounds =
            Bounds2::from_points(outline).ok_or_else(|| plain("the surface has no outline"))?;
        let margin = Vector2::repeat(task.tool.collision_radius());
        let obstacles: Vec<Mesh> = task.obstacles_in_surface().collect();
        let rules = Rules {
            surface: task.surface.clone(),
            occupied: OccupiedArea::from_scene(&obstacles),
            reach: Bounds2 {
                min: bounds.min - margin,
                max: bounds.max + margin,
            },
            goal,
            bounds,
            particles,
            rows,
            columns,
            max_strokes,
            target,
            cost_per_m,
            task,
        };
        let worlds = (0..count as u64).map(|seed| rules.begin(seed, 0));
        let worlds: Result<Vec<World>, SourceError> = worlds.collect();
        Ok(Self {
            worlds: Mutex::new(worlds.map_err(plain)?),
            rules,
        })
    }

    /// Begins new episodes in all worlds; a seed starts a new sequence of episodes, `None` continues the old one.
    fn reset<'py>(&self, py: Python<'py>, seeds: Vec<Option<u64>>) -> PyResult<Observations<'py>> {
        let cells = self.rules.rows * self.rules.columns;
        let (density, tool) = self.with(|worlds| {
            if seeds.len() != worlds.len() {
                return Err(refused("seeds", seeds.len(), worlds.len()));
            }
            let mut density = vec![0.0; worlds.len() * cells];
            let mut tool = vec![0.0; worlds.len() * TOOL];
            let room = density.chunks_mut(cells).zip(tool.chunks_mut(TOOL));
            for ((world, seed), (density, tool)) in worlds.iter_mut().zip(seeds).zip(room) {
                let (seed, episode) = match seed {
                    Some(seed) => (seed, 0),
                    None => (world.seed, world.episode.wrapping_add(1)),
                };
                *world = self.rules.begin(seed, episode).map_err(plain)?;
                self.rules.observe(world, density, tool);
            }
            Ok((density, tool))
        })?;
        Ok(self.to_arrays(py, density, tool))
    }

    /// Executes a stroke in each world, actions (n, 5); a world whose episode is over begins its next instead. Returns
    /// density, tool, rewards, terminated, truncated and performance.
    #[expect(clippy::type_complexity, reason = "a tuple of arrays, as in Gymnasium")]
    fn step<'py>(
        &self,
        py: Python<'py>,
        actions: &Bound<'py, PyAny>,
    ) -> PyResult<(
        Bound<'py, PyArray3<f32>>,
        Bound<'py, PyArray2<f32>>,
        Bound<'py, PyArray1<f64>>,
        Bound<'py, PyArray1<bool>>,
        Bound<'py, PyArray1<bool>>,
        Bound<'py, PyArray1<f64>>,
    )> {
        let given: PyArrayLike2<'_, f64, AllowTypeChange> = (actions.extract())
            .map_err(|_| refused("actions", kind_of(actions), "an array of shape (n, 5)"))?;
        let given = given.as_array();
        if given.ncols() != ACTION {
            let found = format!("({}, {})", given.nrows(), given.ncols());
            return Err(refused("shape of the actions", found, "(n, 5)"));
        }
        if let Some(((row, column), value)) = given.indexed_iter().find(|(_, x)| !x.is_finite()) {
            let place = format!("actions[{row}, {column}]");
            return Err(refused(&place, value, "a finite number"));
        }
        let actions: Vec<[f64; ACTION]> = (given.rows().into_iter())
            .map(|row| std::array::from_fn(|i| row[i]))
            .collect();
        let rules = &self.rules;
        let cells = rules.rows * rules.columns;
        let (density, tool, outcomes) = py.detach(|| {
            self.with(|worlds| {
                if actions.len() != worlds.len() {
                    return Err(refused("rows of the actions", actions.len(), worlds.len()));
                }
                let mut density = vec![0.0; worlds.len() * cells];
                let mut tool = vec![0.0; worlds.len() * TOOL];
                let outcomes: Result<Vec<Outcome>, SourceError> = (worlds.par_iter_mut())
                    .zip(&actions)
                    .zip(density.par_chunks_mut(cells))
                    .zip(tool.par_chunks_mut(TOOL))
                    .with_min_len(WORLDS_PER_THREAD)
                    .map(|(((world, action), density), tool)| {
                        let outcome = rules.step(world, *action)?;
                        rules.observe(world, density, tool);
                        Ok(outcome)
                    })
                    .collect();
                Ok((density, tool, outcomes.map_err(plain)?))
            })
        })?;
        let (density, tool) = self.to_arrays(py, density, tool);
        let numbers =
            |of: fn(&Outcome) -> f64| Array1::from_iter(outcomes.iter().map(of)).into_pyarray(py);
        let flags =
            |of: fn(&Outcome) -> bool| Array1::from_iter(outcomes.iter().map(of)).into_pyarray(py);
        Ok((
            density,
            tool,
            numbers(|outcome| outcome.reward),
            flags(|outcome| outcome.terminated),
            flags(|outcome| outcome.truncated),
            numbers(|outcome| outcome.performance),
        ))
    }

    /// Positions of the particles on the surface of a world, (k, 2) [m].
    fn particles<'py>(&self, py: Python<'py>, world: usize) -> PyResult<Matrix<'py>> {
        self.with(|worlds| {
            let count = worlds.len();
            let world = worlds
                .get(world)
                .ok_or_else(|| refused("world", world, format!("0 to {}", count - 1)))?;
            Ok(arrays::points(py, world.field.distribution().remaining()))
        })
    }

    /// Performance of each world, (n), 0 to 1.
    #[getter]
    fn performance<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.with(|worlds| {
            arrays::vector(py, worlds.iter().map(|world| world.performance).collect())
        })
    }

    /// Box of the strokes' starts and ends: smallest and largest x, y [m], (2, 2).
    #[getter]
    fn reach<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        let reach = &self.rules.reach;
        arrays::points(py, [reach.min, reach.max].into_iter())
    }
}
