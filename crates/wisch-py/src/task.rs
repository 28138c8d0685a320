//! Tasks from files, or from Python objects with the keys of a task file.

use crate::arrays::{self, Matrix, Vector, pose_array, rows};
use crate::error::{of_file, of_record, plain, refused};
use crate::interpret::PyInterpretation;
use crate::motion::shape_dict;
use crate::plan::PyPlan;
use crate::robot::{PyRobot, warn_of};
use crate::session::{Given, PROGRAM, PySession};
use crate::task_text::{GivenFiles, TaskText};
use crate::telemetry::{LoggedTouches, PyTelemetry, touches};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use wisch::geometry::{PlanarPose, Point2};
use wisch::plan::plan_from_strokes;
use wisch::represent::{ScenePart, Task};
use wisch::run::OwnStrategy;
use wisch_io::{LoadOptions, LoadedTask, PlanRecord, read_beside};
use wisch_record::{EpisodeTarget, RecordOptions, RunRecord};

/// Name of a task without a file.
const NO_FILE: &str = "task.toml";

/// A wiping task: surface, dirt, tool, action and goal.
#[pyclass(name = "Task", module = "wisch", frozen)]
pub struct PyTask {
    pub loaded: Arc<LoadedTask>,
    options: LoadOptions,
    /// Contents of the files that stand for objects of Python.
    given: Arc<GivenFiles>,
}

/// Reads a task file, or a shipped scenario by its name, with all files that it refers to.
///
/// `set` overrides values of the file by dotted keys such as `{"particles.count": 80, "tool.name": "brush"}`, including
/// lists and dicts. `action`, `strategy` and `seed` are as on the command line; `knowledge` is a folder with tools,
/// media, surfaces and interactions that replaces the shipped one.
///
/// Raises WischError with line, column, value and limit if a file cannot be read or is invalid.
#[pyfunction]
#[pyo3(signature = (path, *, set = None, seed = None, action = None, strategy = None, knowledge = None))]
pub fn load_task(
    py: Python<'_>,
    path: PathBuf,
    set: Option<&Bound<'_, PyDict>>,
    seed: Option<u64>,
    action: Option<&str>,
    strategy: Option<&str>,
    knowledge: Option<PathBuf>,
) -> PyResult<PyTask> {
    let mut writer = TaskText::default();
    let options = options_of(&mut writer, set, seed, action, strategy, knowledge)?;
    if !writer.files.is_empty() {
        return Err(plain(
            "a mesh given as arrays in set is only possible in build_task; write it to a file and name that",
        ));
    }
    let loaded = py.detach(|| wisch_io::load_task(&path, &options));
    Ok(PyTask {
        loaded: Arc::new(loaded.map_err(of_file)?),
        options,
        given: Arc::default(),
    })
}

/// Loads the task of a file's text. `given`: contents of the files that stand for objects of Python.
fn load(path: &Path, text: String, given: GivenFiles, options: LoadOptions) -> PyResult<PyTask> {
    let mut files = read_beside(path);
    let mut read = |file: &str| match given.get(file) {
        Some(contents) => Ok(contents.clone()),
        None => files(file),
    };
    let loaded = wisch_io::parse_task(path, text, &mut read, &options).map_err(of_file)?;
    Ok(PyTask {
        loaded: Arc::new(loaded),
        options,
        given: Arc::new(given),
    })
}

/// Builds a task from the keys of a task file; `particles` (N, 2) replace the file's, if given.
#[pyfunction]
#[pyo3(signature = (keys, particles = None, *, path = None, set = None, seed = None, action = None, strategy = None, knowledge = None))]
#[expect(clippy::too_many_arguments, reason = "Python names them")]
pub fn task_of_keys(
    py: Python<'_>,
    keys: &Bound<'_, PyDict>,
    particles: Option<&Bound<'_, PyAny>>,
    path: Option<PathBuf>,
    set: Option<&Bound<'_, PyDict>>,
    seed: Option<u64>,
    action: Option<&str>,
    strategy: Option<&str>,
    knowledge: Option<PathBuf>,
) -> PyResult<PyTask> {
    let mut writer = TaskText::default();
    let options = options_of(&mut writer, set, seed, action, strategy, knowledge)?;
    let mut text = writer.keys(keys)?;
    if let Some(particles) = particles {
        let source = writer.particles(particles)?;
        text += &format!("\n[particles]\n{}\n", source.join("\n"));
    }
    let path = path.unwrap_or_else(|| PathBuf::from(NO_FILE));
    py.detach(|| load(&path, text, writer.files, options))
}

fn options_of(
    writer: &mut TaskText,
    set: Option<&Bound<'_, PyDict>>,
    seed: Option<u64>,
    action: Option<&str>,
    strategy: Option<&str>,
    knowledge: Option<PathBuf>,
) -> PyResult<LoadOptions> {
    let mut settings = Vec::new();
    for (key, value) in set.into_iter().flatten() {
        let key: String = key.extract()?;
        let value = match value.extract() {
            // As on the command line: TOML, or a plain word.
            Ok(text) => text,
            Err(_) => writer.value(&key, &value)?,
        };
        settings.push((key, value));
    }
    let named = |name: &str, known: &dyn std::fmt::Display| refused(name, known, "a known name");
    Ok(LoadOptions {
        settings,
        knowledge,
        seed,
        action: (action.map(str::parse).transpose()).map_err(|error| named("action", &error))?,
        strategy: (strategy.map(str::parse).transpose())
            .map_err(|error| named("strategy", &error))?,
    })
}

impl PyTask {
    /// Converts a plan, strokes, or a function that returns strokes for a task.
    fn parse_plan(&self, given: &Bound<'_, PyAny>) -> PyResult<Given> {
        if let Ok(plan) = given.cast::<PyPlan>() {
            return Ok(Given::Plan((*plan.get().plan).clone()));
        }
        if !given.is_callable() {
            let plan = self.plan_of_strokes(given)?;
            return Ok(Given::Plan((*plan.plan).clone()));
        }
        let function = given.clone().unbind();
        let (loaded, options) = (Arc::clone(&self.loaded), self.options.clone());
        let files = Arc::clone(&self.given);
        Ok(Given::Strategy(OwnStrategy::new(move |task: &Task| {
            Python::attach(|py| {
                let task = Self {
                    loaded: Arc::new(LoadedTask {
                        task: task.clone(),
                        ..(*loaded).clone()
                    }),
                    options: options.clone(),
                    given: Arc::clone(&files),
                };
                strokes_of(&function.bind(py).call1((Py::new(py, task)?,))?)
            })
            .map_err(|error: PyErr| error.to_string())
        })))
    }
}

/// Parses strokes from arrays (k, 3) of x, y [m] and yaw [rad].
fn strokes_of(given: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<PlanarPose>>> {
    let strokes = given.try_iter()?;
    strokes
        .map(|stroke| {
            let poses = rows::<3>("strokes", &stroke?)?.into_iter();
            Ok(poses
                .map(|[x, y, heading]| PlanarPose::new(Point2::new(x, y), heading))
                .collect())
        })
        .collect()
}

#[pymethods]
impl PyTask {
    /// Name of the task.
    #[getter]
    fn name(&self) -> &str {
        &self.loaded.task.name
    }

    /// Path of its file.
    #[getter]
    fn path(&self) -> PathBuf {
        self.loaded.path.clone()
    }

    /// Text of the task file, as TOML.
    #[getter]
    fn toml(&self) -> &str {
        &self.loaded.text
    }

    /// Assumptions about a tool, medium or interaction that the file defines, a sentence each.
    #[getter]
    fn assumptions(&self) -> Vec<String> {
        self.loaded.assumptions.clone()
    }

    /// The wiping action.
    #[getter]
    fn action(&self) -> &'static str {
        self.loaded.task.action.as_str()
    }

    /// Name of the medium.
    #[getter]
    fn medium(&self) -> &str {
        &self.loaded.task.medium
    }

    /// Random seed.
    #[getter]
    fn seed(&self) -> u64 {
        self.loaded.task.seed
    }

    /// Name of its planning strategy.
    #[getter]
    fn strategy(&self) -> &'static str {
        self.loaded.run.plan.strategy.as_str()
    }

    /// Performance at which its goal is met, 0 to 1.
    #[getter]
    fn target_performance(&self) -> f64 {
        self.loaded.run.target
    }

    /// Name of the tool.
    #[getter]
    fn tool(&self) -> &str {
        &self.loaded.task.tool.name
    }

    /// Footprint of the tool: outer rings (corners, 2) in its own frame [m].
    #[getter]
    fn tool_footprint<'py>(&self, py: Python<'py>) -> Vec<Matrix<'py>> {
        arrays::rings(py, &self.loaded.task.tool.footprint)
    }

    /// Vertices (V, 3) in the tool's frame [m], whose origin is in the contact plane with z out of the surface; triangles (T, 3).
    #[getter]
    fn tool_mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (vertices, triangles) = arrays::mesh(py, &self.loaded.task.tool.mesh);
        Ok((vertices, triangles).into_pyobject(py)?.into_any())
    }

    /// Depth along and width across the tool's motion [m].
    #[getter]
    fn area_of_effect_m(&self) -> [f64; 2] {
        self.loaded.task.tool.area_of_effect.into()
    }

    /// Radius of the collision sphere around the tool.
    #[getter]
    fn collision_radius_m(&self) -> f64 {
        self.loaded.task.tool.collision_radius()
    }

    /// Name of the surface.
    #[getter]
    fn surface(&self) -> &str {
        &self.loaded.task.surface.name
    }

    /// Outline of the surface, (corners, 2) in its frame [m].
    #[getter]
    fn surface_outline<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        let outline = self.loaded.task.surface.outline.outer();
        arrays::points(py, outline.iter().copied())
    }

    /// Believed pose of the surface, (7).
    #[getter]
    fn world_from_surface<'py>(&self, py: Python<'py>) -> Vector<'py> {
        pose_array(py, &self.loaded.task.surface.world_from_surface)
    }

    /// Shape of a curved surface; `None` for a plane.
    #[getter]
    fn surface_shape<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        shape_dict(py, &self.loaded.task.surface.shape)
    }

    /// Believed positions of the dirt, (N, 2) in the frame of the surface [m].
    #[getter]
    fn particles<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        arrays::places(py, &self.loaded.task.particles)
    }

    /// Goal of a collect, (2) in the frame of the surface [m]; `None` if the planner chooses it.
    #[getter]
    fn collect_goal<'py>(&self, py: Python<'py>) -> Option<Vector<'py>> {
        let goal = self.loaded.task.collect_goal?;
        Some(arrays::vector(py, vec![goal.x, goal.y]))
    }

    /// Start of the tool, (2) in the frame of the surface [m].
    #[getter]
    fn tool_start<'py>(&self, py: Python<'py>) -> Vector<'py> {
        let start = self.loaded.task.tool_start;
        arrays::vector(py, vec![start.x, start.y])
    }

    /// Force with which the tool is to press; 0 for a tool that hovers.
    #[getter]
    fn press_force_n(&self) -> f64 {
        self.loaded.task.interaction.contact_force()
    }

    /// Stiffness of the controller along the surface's normal.
    #[getter]
    fn stiffness_n_per_m(&self) -> f64 {
        self.loaded.task.interaction.stiffness_n_per_m
    }

    /// Damping ratio of the controller.
    #[getter]
    fn damping_ratio(&self) -> f64 {
        self.loaded.task.interaction.damping_ratio
    }

    /// Compression of the tool under the press force.
    #[getter]
    fn compression_depth_m(&self) -> f64 {
        self.loaded.task.interaction.compression_depth_m
    }

    /// Largest speed of the tool in contact.
    #[getter]
    fn contact_speed_m_per_s(&self) -> f64 {
        self.loaded.run.follow.contact_speed
    }

    /// Force of the surface on a tool with the nominal press force, in the axes of the world (3) [N].
    #[getter]
    fn surface_reaction<'py>(&self, py: Python<'py>) -> Vector<'py> {
        let force = self.loaded.task.surface_reaction();
        arrays::vector(py, force.iter().copied().collect())
    }

    /// Objects around the surface: name, role, vertices (V, 3) [m], triangles (T, 3) and `world_from_object`.
    #[getter]
    fn scene<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let objects = self.loaded.task.scene.iter().map(|object| {
            let entry = PyDict::new(py);
            let (vertices, triangles) = arrays::mesh(py, &object.mesh);
            entry.set_item("name", &object.name)?;
            entry.set_item(
                "role",
                match object.part {
                    ScenePart::Obstacle => "obstacle",
                    ScenePart::Carrier => "carrier",
                    ScenePart::Robot => "robot",
                    ScenePart::Tool => "tool",
                },
            )?;
            entry.set_item("vertices", vertices)?;
            entry.set_item("triangles", triangles)?;
            entry.set_item(
                "world_from_object",
                pose_array(py, &object.world_from_object),
            )?;
            Ok(entry)
        });
        objects.collect()
    }

    /// Loads the robot that the task names, with its SRDF and capability map; `None` if the task names no robot.
    fn robot(&self, py: Python<'_>) -> PyResult<Option<PyRobot>> {
        let robot = py.detach(|| self.loaded.robot()).map_err(of_file)?;
        Ok(robot.map(PyRobot::of_task))
    }

    #[pyo3(signature = (robot = None, *, world_from_robot = None, group = None, rounds = None, target = None, pace = None, end_strokes_early = None, plan = None, out = None, memory = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn session(
        &self,
        robot: Option<&Bound<'_, PyAny>>,
        world_from_robot: Option<&Bound<'_, PyAny>>,
        group: Option<String>,
        rounds: Option<usize>,
        target: Option<f64>,
        pace: Option<&str>,
        end_strokes_early: Option<bool>,
        plan: Option<&Bound<'_, PyAny>>,
        out: Option<PathBuf>,
        memory: Option<PathBuf>,
    ) -> PyResult<PySession> {
        let given = plan.map_or(Ok(Given::Nothing), |plan| self.parse_plan(plan))?;
        let robot = robot.map(PyRobot::parse).transpose()?;
        let mut config = self.loaded.run.clone();
        if let Some(pose) = world_from_robot {
            let pose = arrays::pose("world_from_robot", pose)?;
            config.workcell.world_from_robot = Some(pose);
        }
        let (robot, is_of_task) = robot.unzip();
        if group.is_some() || is_of_task == Some(false) {
            // A group of the task's own robot does not apply to another robot.
            config.workcell.group = group;
            config.workcell.second_group = None;
        }
        if let Some(rounds) = rounds {
            config.max_rounds = rounds;
        }
        if let Some(target) = target {
            if !(0.0..=1.0).contains(&target) {
                return Err(refused("target", target, "0 to 1"));
            }
            config.target = target;
        }
        if let Some(early) = end_strokes_early {
            config.end_strokes_early = early;
        }
        match pace {
            None => {}
            Some("whole") => config.pace = wisch::run::Pace::Whole,
            Some("greedy") => config.pace = wisch::run::Pace::Greedy,
            Some(other) => return Err(refused("pace", other, "\"whole\" or \"greedy\"")),
        }
        let watched = memory.clone();
        let record = (out.is_some() || memory.is_some()).then(|| RecordOptions {
            program: PROGRAM.to_owned(),
            out,
            episode: memory.map(|memory| EpisodeTarget {
                memory,
                ..EpisodeTarget::default()
            }),
            workcell: Some(config.workcell.clone()),
            ..RecordOptions::default()
        });
        let record = record
            .map(|options| RunRecord::begin(&self.loaded, robot.as_deref(), options))
            .transpose()
            .map_err(of_record)?;
        Ok(PySession::new(
            Arc::clone(&self.loaded),
            robot,
            config,
            given,
            record,
            watched,
        ))
    }

    /// Returns the same task with other particles (N, 2) [m]; options as in `load_task`.
    #[pyo3(signature = (particles, *, set = None, seed = None, action = None, strategy = None))]
    fn with_particles(
        &self,
        py: Python<'_>,
        particles: &Bound<'_, PyAny>,
        set: Option<&Bound<'_, PyDict>>,
        seed: Option<u64>,
        action: Option<&str>,
        strategy: Option<&str>,
    ) -> PyResult<Self> {
        // The meshes that were given for the first task are those of the second, too.
        let mut writer = TaskText {
            files: (*self.given).clone(),
        };
        let mut options = self.options.clone();
        let laid_over = options_of(&mut writer, set, seed, action, strategy, None)?;
        let source = format!("{{ {} }}", writer.particles(particles)?.join(", "));
        options.settings.push(("particles".to_owned(), source));
        options.settings.extend(laid_over.settings);
        options.seed = laid_over.seed.or(options.seed);
        options.action = laid_over.action.or(options.action);
        options.strategy = laid_over.strategy.or(options.strategy);
        let (path, text) = (&self.loaded.path, self.loaded.text.clone());
        py.detach(|| load(path, text, writer.files, options))
    }

    /// Interprets poses and forces: a `Telemetry`, or arrays of times (T) [s], poses (T, 7) and forces of the
    /// surroundings on the tool (T, 3) [N] in the axes of the world. The belief about the dirt before is that of the
    /// task; if `certain`, the dirt lies exactly at the task's particles.
    #[pyo3(signature = (log = None, *, time_s = None, world_from_tool = None, force_n = None, certain = false))]
    fn interpret(
        &self,
        py: Python<'_>,
        log: Option<&Bound<'_, PyTelemetry>>,
        time_s: Option<&Bound<'_, PyAny>>,
        world_from_tool: Option<&Bound<'_, PyAny>>,
        force_n: Option<&Bound<'_, PyAny>>,
        certain: bool,
    ) -> PyResult<PyInterpretation> {
        let log = match (log, time_s, world_from_tool, force_n) {
            (Some(log), None, None, None) => log.get().touches(py)?,
            (None, Some(times), Some(poses), Some(forces)) => {
                let samples = touches(times, poses, forces)?;
                LoggedTouches {
                    samples,
                    ..LoggedTouches::default()
                }
            }
            _ => {
                let wanted = "a log, or time_s, world_from_tool and force_n";
                return Err(refused("interpret", "something else", wanted));
            }
        };
        PyInterpretation::of_log(py, &self.loaded, &log, certain)
    }

    /// Plans for the task's particles as if their positions were certain, as `wisch eval table1` does. A session plans
    /// for the whole belief about the dirt instead.
    fn plan_known_dirt(&self, py: Python<'_>) -> PyResult<PyPlan> {
        let plan = py.detach(|| self.loaded.plan_for_known_dirt());
        Ok(PyPlan::new(&self.loaded.task, plan.map_err(plain)?))
    }

    /// Returns the plan of given strokes, each an array (k, 3) of x, y [m] and yaw [rad] of the tool in the frame of
    /// the surface.
    fn plan_of_strokes(&self, strokes: &Bound<'_, PyAny>) -> PyResult<PyPlan> {
        let strokes = strokes_of(strokes)?;
        let (task, lift) = (&self.loaded.task, self.loaded.run.plan.lift_height);
        let plan = plan_from_strokes(task, &strokes, lift).map_err(plain)?;
        Ok(PyPlan::new(task, plan))
    }

    /// Returns the plan of a `plan.json`. Warns if it was made for another pose of the surface, tool or goal.
    fn plan_of_json(&self, py: Python<'_>, json: &str) -> PyResult<PyPlan> {
        let record = PlanRecord::parse(json).map_err(plain)?;
        let plan = record.to_plan(&self.loaded.task).map_err(plain)?;
        warn_of(py, record.describe_differences(&plan, &self.loaded.task))?;
        Ok(PyPlan::new(&self.loaded.task, plan))
    }

    fn __repr__(&self) -> String {
        let task = &self.loaded.task;
        format!(
            "<wisch.Task {:?}: {} {} on {} with a {}, {} particles>",
            task.name,
            task.action,
            task.medium,
            task.surface.name,
            task.tool.name,
            task.particles.len()
        )
    }
}
