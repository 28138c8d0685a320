//! Plans and predictions.

use crate::arrays::{self, Matrix, Vector, rows};
use crate::error::plain;
use crate::pictures;
use numpy::PyArray1;
use pyo3::prelude::*;
use std::sync::Arc;
use wisch::geometry::PlanarPose;
use wisch::plan::{Plan, Prediction, Stroke, predict};
use wisch::represent::{GoalState, ParticleDistribution, Task};
use wisch::source_location::UnknownName;
use wisch_io::PlanRecord;

/// Strokes in the order of their execution.
#[pyclass(name = "Plan", module = "wisch", frozen)]
pub struct PyPlan {
    pub task: Arc<Task>,
    pub plan: Arc<Plan>,
}

impl PyPlan {
    pub fn new(task: &Task, plan: Plan) -> Self {
        Self {
            task: Arc::new(task.clone()),
            plan: Arc::new(plan),
        }
    }
}

/// Returns x, y [m] and yaw [rad] of each pose, (n, 3).
pub fn poses<'py>(py: Python<'py>, stroke: &Stroke) -> Matrix<'py> {
    let numbers = |pose: &PlanarPose| [pose.position.x, pose.position.y, pose.heading];
    arrays::matrix(py, stroke.poses.iter().flat_map(numbers).collect(), 3)
}

#[pymethods]
impl PyPlan {
    /// Name of the strategy that planned it.
    #[getter]
    fn strategy(&self) -> &'static str {
        self.plan.strategy.as_str()
    }

    /// Strokes, each (k, 3): x, y [m] and yaw [rad] of the tool in the frame of the surface, between which it moves straight.
    #[getter]
    fn strokes<'py>(&self, py: Python<'py>) -> Vec<Matrix<'py>> {
        let strokes = self.plan.strokes.iter();
        strokes.map(|stroke| poses(py, stroke)).collect()
    }

    /// Positions of the nodes, (nodes, 2) in the frame of the surface [m].
    #[getter]
    fn nodes<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        let nodes = self.plan.graph.nodes.iter();
        arrays::points(py, nodes.map(|node| node.position))
    }

    /// Directed edges between nodes, as pairs of their numbers from 0.
    #[getter]
    fn edges(&self) -> Vec<(usize, usize)> {
        self.plan.graph.edges.clone()
    }

    /// Length of the path in contact.
    #[getter]
    fn contact_distance_m(&self) -> f64 {
        self.plan.contact_distance()
    }

    /// Length of the tool's whole path, including free motions.
    #[getter]
    fn total_distance_m(&self) -> f64 {
        self.plan.total_distance()
    }

    /// Share of the particles that no allowed pose of the tool covers, 0 to 1.
    #[getter]
    fn unreachable_share(&self) -> f64 {
        self.plan.unreachable_share
    }

    /// Goal of the collected dirt (2) [m]; `None` for a plan that does not collect.
    #[getter]
    fn collect_goal<'py>(&self, py: Python<'py>) -> Option<Vector<'py>> {
        match self.plan.graph.goal {
            GoalState::Collected { center, .. } => {
                Some(arrays::vector(py, vec![center.x, center.y]))
            }
            _ => None,
        }
    }

    /// Corners of the tool's whole path, including free motions: x, y [m], yaw [rad] and height [m], (n, 4).
    #[getter]
    fn tcp_path<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        let path = self.plan.tcp_path();
        let numbers = path.iter().flat_map(|point| {
            let PlanarPose { position, heading } = point.surface_from_tool;
            [position.x, position.y, heading, point.height]
        });
        arrays::matrix(py, numbers.collect(), 4)
    }

    /// Predicts the plan's effect on the task's particles, or on given ones (N, 2) [m].
    #[pyo3(signature = (particles = None))]
    fn predict(
        &self,
        py: Python<'_>,
        particles: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<PyPrediction> {
        let mut task = Arc::clone(&self.task);
        if let Some(given) = particles {
            let points = rows::<2>("particles", given)?;
            let points: Vec<_> = points.into_iter().map(Into::into).collect();
            Arc::make_mut(&mut task).particles =
                ParticleDistribution::new(&points).map_err(plain)?;
        }
        let prediction = py.detach(|| predict(&task, &self.plan, |_| ()));
        Ok(PyPrediction {
            task,
            plan: Arc::clone(&self.plan),
            prediction,
        })
    }

    /// Returns the text of the file `plan.json`.
    fn to_json(&self) -> PyResult<String> {
        let record = PlanRecord::new(&self.task, &self.plan, self.task.seed);
        serde_json::to_string_pretty(&record)
            .map(|json| json + "\n")
            .map_err(plain)
    }

    /// Returns a picture as SVG: before-after, graph, density or effect-over-time.
    #[pyo3(signature = (name = "graph"))]
    fn picture(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        if !pictures::NAMES.contains(&name) {
            return Err(plain(UnknownName::new("picture", name, pictures::NAMES)));
        }
        Ok(py.detach(|| pictures::draw(name, &self.task, &self.plan, None)))
    }

    /// Graph and strokes, for notebooks.
    fn _repr_svg_(&self, py: Python<'_>) -> PyResult<String> {
        self.picture(py, "graph")
    }

    fn __repr__(&self) -> String {
        format!(
            "<wisch.Plan by {}: {} strokes, {:.2} m in contact>",
            self.plan.strategy,
            self.plan.strokes.len(),
            self.plan.contact_distance()
        )
    }
}

/// Predicted effect of a plan on the dirt.
#[pyclass(name = "Prediction", module = "wisch", frozen)]
pub struct PyPrediction {
    pub task: Arc<Task>,
    pub plan: Arc<Plan>,
    pub prediction: Prediction,
}

#[pymethods]
impl PyPrediction {
    /// Share of the particles that meet the goal, 0 to 1.
    #[getter]
    fn performance(&self) -> f64 {
        self.prediction.performance.ratio()
    }

    /// Number of particles.
    #[getter]
    fn initial(&self) -> usize {
        self.prediction.performance.initial
    }

    /// Number of particles that meet the goal.
    #[getter]
    fn achieved(&self) -> usize {
        self.prediction.performance.achieved
    }

    /// Number of particles that left the surface over a wrong edge, or whose coat is too thick.
    #[getter]
    fn lost(&self) -> usize {
        self.prediction.performance.lost
    }

    /// Positions of the particles, or where they left the surface, (N, 2) in the frame of the surface [m].
    #[getter]
    fn particles<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        arrays::places(py, &self.prediction.particles)
    }

    /// Fates of the particles: 0 on the surface, 1 absorbed, 2 off the surface, (N).
    #[getter]
    fn fates<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i8>> {
        arrays::fates(py, &self.prediction.particles)
    }

    /// Particles before and after, for notebooks.
    fn _repr_svg_(&self, py: Python<'_>) -> String {
        py.detach(|| pictures::draw("before-after", &self.task, &self.plan, None))
    }

    fn __repr__(&self) -> String {
        let performance = self.prediction.performance;
        format!(
            "<wisch.Prediction: {} of {} particles at the goal, {} lost>",
            performance.achieved, performance.initial, performance.lost
        )
    }
}
