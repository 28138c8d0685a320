//! Interpretation of poses and forces.

use crate::arrays::{self, Matrix, Vector, pose_array};
use crate::error::plain;
use crate::plan::PyPlan;
use crate::telemetry::LoggedTouches;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use wisch::geometry::restore_pose;
use wisch::interpret::{
    Belief, Diagnosis, InterpretConfig, InterpretError, Interpretation, Interpreter,
};
use wisch::plan::{PlanConfig, plan};
use wisch::recover::next_task;
use wisch::represent::{GoalState, Task};
use wisch_io::LoadedTask;

/// Estimates of contact, surface and dirt from poses and forces.
#[pyclass(name = "Interpretation", module = "wisch", frozen)]
pub struct PyInterpretation {
    /// The task.
    pub task: Arc<Task>,
    /// The goal.
    pub goal: GoalState,
    /// The interpretation of the library.
    pub estimate: Arc<Interpretation>,
    config: PlanConfig,
}

impl PyInterpretation {
    /// Returns the interpretation of a round.
    pub fn new(
        task: &Task,
        goal: GoalState,
        config: &PlanConfig,
        estimate: Interpretation,
    ) -> Self {
        Self {
            task: Arc::new(task.clone()),
            goal,
            estimate: Arc::new(estimate),
            config: config.clone(),
        }
    }

    /// Interprets samples of a task. The belief is that of the task's dirt, or its particles as certain positions.
    pub fn of_log(
        py: Python<'_>,
        loaded: &LoadedTask,
        log: &LoggedTouches,
        is_certain: bool,
    ) -> PyResult<Self> {
        let task = &loaded.task;
        let goal = task
            .goal()
            .ok_or_else(|| plain("the task states no goal of the collect; set collect.goal_m"))?;
        let estimate: Result<_, InterpretError> = py.detach(|| {
            let believed = if is_certain {
                Belief::from_particles(task.particles.clone())
            } else {
                loaded.belief()
            };
            let mut interpreter = Interpreter::new(task, &InterpretConfig::from_task(task))?;
            interpreter.skip(log.unusable);
            for sample in &log.samples {
                interpreter.push(sample)?;
            }
            for (time, pose) in &log.poses_alone {
                interpreter.note_pose(*time, &restore_pose(pose));
            }
            interpreter.conclude(&believed, &goal)
        });
        Ok(Self::new(
            task,
            goal,
            &loaded.run.plan,
            estimate.map_err(plain)?,
        ))
    }
}

#[pymethods]
impl PyInterpretation {
    /// Expected performance, 0 to 1.
    #[getter]
    fn performance(&self) -> f64 {
        self.estimate.performance.mean
    }

    /// 90 % interval of the performance; wider if the log may lack a part of the wiping.
    #[getter]
    fn interval(&self) -> (f64, f64) {
        self.estimate.range(self.task.action).into()
    }

    /// Performance by touch alone, without camera observations.
    #[getter]
    fn performance_by_touch(&self) -> f64 {
        self.estimate.by_touch.mean
    }

    /// localized, relocalize, no contact or hovering.
    #[getter]
    fn diagnosis(&self) -> &'static str {
        self.estimate.diagnosis.as_str()
    }

    /// Estimated pose of the surface, (7): by touch, if that differs from the believed pose.
    #[getter]
    fn world_from_surface<'py>(&self, py: Python<'py>) -> Vector<'py> {
        match &self.estimate.diagnosis {
            Diagnosis::Relocalize { world_from_surface } => pose_array(py, world_from_surface),
            _ => pose_array(py, &self.task.surface.world_from_surface),
        }
    }

    /// Time in contact divided by the time on or near the surface, 0 to 1; None if the tool never was there.
    #[getter]
    fn contact_share(&self) -> Option<f64> {
        self.estimate.contact_share
    }

    /// Reasons why the log may not show wiping of this surface.
    #[getter]
    fn doubts(&self) -> Vec<String> {
        self.estimate
            .doubts
            .iter()
            .map(ToString::to_string)
            .collect()
    }

    /// Events, each with kind, `start_s`, `end_s`, `peak_force_n`.
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let events = self.estimate.events.iter().map(|event| {
            let entry = PyDict::new(py);
            entry.set_item("kind", event.kind.as_str())?;
            entry.set_item("start_s", event.start)?;
            entry.set_item("end_s", event.end)?;
            entry.set_item("peak_force_n", event.peak_force)?;
            Ok(entry)
        });
        events.collect()
    }

    /// Draws the present positions of the dirt from the belief, (N, 2) in the frame of the surface [m].
    #[pyo3(signature = (seed = 0))]
    fn particles<'py>(&self, py: Python<'py>, seed: u64) -> PyResult<Matrix<'py>> {
        let drawn = self.estimate.belief.sample(seed).map_err(plain)?;
        Ok(arrays::points(py, drawn.remaining()))
    }

    /// Plans for the remaining dirt, by the present belief.
    fn next_plan(&self, py: Python<'_>) -> PyResult<PyPlan> {
        let seed = self.task.seed.wrapping_add(1);
        py.detach(|| {
            let next = next_task(&self.task, &self.goal, &self.estimate, seed).map_err(plain)?;
            let plan = plan(&next, &self.config).map_err(plain)?;
            Ok(PyPlan::new(&next, plan))
        })
    }

    /// Probability of each member of the belief, (members).
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.estimate.belief.weights().to_vec())
    }

    fn __repr__(&self) -> String {
        let (low, high) = self.interval();
        format!(
            "<wisch.Interpretation: {:.0} % ({:.0} to {:.0} %), {}>",
            100.0 * self.performance(),
            100.0 * low,
            100.0 * high,
            self.diagnosis()
        )
    }
}
