//! Tasks: from a file, or from Python objects by way of the same file's keys.

use crate::arrays::{self, Matrix, Vector, pose_array, rows};
use crate::error::{of_file, plain, refused};
use crate::plan::PyPlan;
use crate::robot::PyRobot;
use crate::session::PySession;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::Arc;
use wisch::represent::{ParticleDistribution, ScenePart};
use wisch_io::{LoadOptions, LoadedTask, PlanRecord, beside, particles_to_csv};

/// Under this name a task that is made of objects finds the particles that came as an array.
const GIVEN_PARTICLES: &str = "particles given as an array.csv";
/// What a task is called that lies in no file.
const NO_FILE: &str = "task.toml";

/// What is to be wiped, where, with what, and to what end.
#[pyclass(name = "Task", module = "wisch", frozen)]
pub struct PyTask {
    pub loaded: Arc<LoadedTask>,
}

/// Reads a task file, or a shipped scenario by its name.
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
    let options = options(set, seed, action, strategy, knowledge)?;
    let loaded = py.detach(|| wisch_io::load_task(&path, &options));
    PyTask::of(loaded.map_err(of_file)?)
}

/// The task of the keys of a task file as JSON; `particles` (N, 2) are its particles, if they are given.
#[pyfunction]
#[pyo3(signature = (json, particles = None, *, path = None, set = None, seed = None, action = None, strategy = None, knowledge = None))]
#[expect(clippy::too_many_arguments, reason = "Python names them")]
pub fn task_of_json(
    py: Python<'_>,
    json: &str,
    particles: Option<&Bound<'_, PyAny>>,
    path: Option<PathBuf>,
    set: Option<&Bound<'_, PyDict>>,
    seed: Option<u64>,
    action: Option<&str>,
    strategy: Option<&str>,
    knowledge: Option<PathBuf>,
) -> PyResult<PyTask> {
    let options = options(set, seed, action, strategy, knowledge)?;
    let mut table: toml::Table = serde_json::from_str(json).map_err(plain)?;
    let csv = particles.map(csv_of).transpose()?;
    if csv.is_some() {
        let source = [("source", "csv"), ("file", GIVEN_PARTICLES)];
        let source = source.map(|(key, value)| (key.to_owned(), value.into()));
        let source = toml::Table::from_iter(source);
        table.insert("particles".to_owned(), source.into());
    }
    let text = toml::to_string(&table).map_err(plain)?;
    let path = path.unwrap_or_else(|| PathBuf::from(NO_FILE));
    let mut files = beside(&path);
    let loaded = py.detach(|| {
        let mut read = |file: &str| match &csv {
            Some(csv) if file == GIVEN_PARTICLES => Ok(csv.clone().into_bytes()),
            _ => files(file),
        };
        wisch_io::task_of_text(&path, text, &mut read, &options)
    });
    PyTask::of(loaded.map_err(of_file)?)
}

fn csv_of(particles: &Bound<'_, PyAny>) -> PyResult<String> {
    let points = rows::<2>("particles", particles)?;
    let points: Vec<_> = points.into_iter().map(Into::into).collect();
    let particles = ParticleDistribution::new(&points).map_err(plain)?;
    Ok(particles_to_csv(&particles))
}

fn options(
    set: Option<&Bound<'_, PyDict>>,
    seed: Option<u64>,
    action: Option<&str>,
    strategy: Option<&str>,
    knowledge: Option<PathBuf>,
) -> PyResult<LoadOptions> {
    let mut settings = Vec::new();
    for (key, value) in set.into_iter().flatten() {
        settings.push((key.extract()?, value.str()?.extract()?));
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
    fn of(loaded: LoadedTask) -> PyResult<Self> {
        Ok(Self {
            loaded: Arc::new(loaded),
        })
    }

    /// Its name, for messages.
    pub fn shown(&self) -> String {
        self.loaded.path.display().to_string()
    }
}

#[pymethods]
impl PyTask {
    #[getter]
    fn name(&self) -> &str {
        &self.loaded.task.name
    }

    #[getter]
    fn path(&self) -> PathBuf {
        self.loaded.path.clone()
    }

    /// The task file, as TOML.
    #[getter]
    fn toml(&self) -> &str {
        &self.loaded.text
    }

    #[getter]
    fn assumptions(&self) -> Vec<String> {
        self.loaded.assumptions.clone()
    }

    #[getter]
    fn action(&self) -> &'static str {
        self.loaded.task.action.as_str()
    }

    #[getter]
    fn medium(&self) -> &str {
        &self.loaded.task.medium
    }

    #[getter]
    fn seed(&self) -> u64 {
        self.loaded.task.seed
    }

    #[getter]
    fn strategy(&self) -> &'static str {
        self.loaded.config.strategy.as_str()
    }

    #[getter]
    fn target_performance(&self) -> f64 {
        self.loaded.file.target_performance()
    }

    #[getter]
    fn tool(&self) -> &str {
        &self.loaded.task.tool.name
    }

    #[getter]
    fn tool_footprint<'py>(&self, py: Python<'py>) -> Vec<Matrix<'py>> {
        arrays::rings(py, &self.loaded.task.tool.footprint)
    }

    #[getter]
    fn tool_mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (vertices, triangles) = arrays::mesh(py, &self.loaded.task.tool.mesh);
        Ok((vertices, triangles).into_pyobject(py)?.into_any())
    }

    #[getter]
    fn area_of_effect_m(&self) -> [f64; 2] {
        self.loaded.task.tool.area_of_effect.into()
    }

    #[getter]
    fn collision_radius_m(&self) -> f64 {
        self.loaded.task.tool.collision_radius()
    }

    #[getter]
    fn surface(&self) -> &str {
        &self.loaded.task.surface.name
    }

    #[getter]
    fn surface_outline<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        let outline = self.loaded.task.surface.outline.outer();
        arrays::points(py, outline.iter().copied())
    }

    #[getter]
    fn world_from_surface<'py>(&self, py: Python<'py>) -> Vector<'py> {
        pose_array(py, &self.loaded.task.surface.world_from_surface)
    }

    #[getter]
    fn particles<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        arrays::places(py, &self.loaded.task.particles)
    }

    #[getter]
    fn collect_goal<'py>(&self, py: Python<'py>) -> Option<Vector<'py>> {
        let goal = self.loaded.task.collect_goal?;
        Some(arrays::vector(py, vec![goal.x, goal.y]))
    }

    #[getter]
    fn tool_start<'py>(&self, py: Python<'py>) -> Vector<'py> {
        let start = self.loaded.task.tool_start;
        arrays::vector(py, vec![start.x, start.y])
    }

    #[getter]
    fn press_force_n(&self) -> f64 {
        self.loaded.task.interaction.contact_force()
    }

    #[getter]
    fn stiffness_n_per_m(&self) -> f64 {
        self.loaded.task.interaction.stiffness_n_per_m
    }

    #[getter]
    fn damping_ratio(&self) -> f64 {
        self.loaded.task.interaction.damping_ratio
    }

    #[getter]
    fn compression_depth_m(&self) -> f64 {
        self.loaded.task.interaction.compression_depth_m
    }

    #[getter]
    fn contact_speed_m_per_s(&self) -> f64 {
        self.loaded.file.contact_speed_m_per_s()
    }

    /// Force of the surface on a tool that is pressed as the task asks for, in the axes of the world (3) [N].
    #[getter]
    fn surface_reaction<'py>(&self, py: Python<'py>) -> Vector<'py> {
        let force = self.loaded.task.surface_reaction();
        arrays::vector(py, force.iter().copied().collect())
    }

    /// What stands round the surface: name, role, vertices (V, 3) [m], triangles (T, 3) and `world_from_object`.
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

    /// The robot that the task names, read with what lies beside it; `None` where it names none.
    fn robot(&self, py: Python<'_>) -> PyResult<Option<PyRobot>> {
        let robot = py.detach(|| self.loaded.robot()).map_err(of_file)?;
        Ok(robot.map(PyRobot::of_task))
    }

    #[pyo3(signature = (robot = None, *, world_from_robot = None, group = None, rounds = None, target = None, pace = None, end_strokes_early = None))]
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
    ) -> PyResult<PySession> {
        let robot = robot.map(PyRobot::given).transpose()?;
        let mut config = self.loaded.run_config();
        if let Some(pose) = world_from_robot {
            let pose = arrays::pose("world_from_robot", pose)?;
            config.workcell.world_from_robot = Some(pose);
        }
        let (robot, is_of_task) = robot.unzip();
        if group.is_some() || is_of_task == Some(false) {
            // A group of the task's own robot is none of another.
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
        PySession::new(self, robot, config)
    }

    /// The plan of a `plan.json`.
    fn plan_of_json(&self, json: &str) -> PyResult<PyPlan> {
        let record = PlanRecord::parse(json).map_err(plain)?;
        let plan = record.to_plan(&self.loaded.task).map_err(plain)?;
        Ok(PyPlan::of(&self.loaded.task, plan))
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
