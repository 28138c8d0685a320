//! Finished rounds, and results of the independent check of motions.

use crate::interpret::PyInterpretation;
use crate::motion::PyMotion;
use crate::pictures;
use crate::plan::{PyPlan, PyPrediction};
use crate::telemetry::PyTelemetry;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use wisch::follow::Audit;
use wisch::plan::PlanConfig;
use wisch::run::{Ending, Pause, PlannedRound, Round};

/// Result of the independent check of a motion.
#[pyclass(name = "Audit", module = "wisch", frozen)]
pub struct PyAudit(Audit);

impl PyAudit {
    /// Returns the check of a motion.
    pub fn new(audit: &Audit) -> Self {
        Self(audit.clone())
    }
}

#[pymethods]
impl PyAudit {
    /// Descriptions of the faults; empty for a sound motion.
    #[getter]
    fn faults(&self) -> Vec<String> {
        self.0.faults.iter().map(ToString::to_string).collect()
    }

    /// Smallest distance between bodies that must not touch, at most 0.5 m.
    #[getter]
    fn min_clearance_m(&self) -> f64 {
        self.0.min_clearance
    }

    /// Largest deviation of the tool from its lines.
    #[getter]
    fn line_deviation_m(&self) -> f64 {
        self.0.line.position
    }

    /// Largest rotation of the tool away from its lines.
    #[getter]
    fn line_deviation_rad(&self) -> f64 {
        self.0.line.rotation
    }

    fn __bool__(&self) -> bool {
        self.0.faults.is_empty()
    }

    fn __repr__(&self) -> String {
        format!(
            "<wisch.Audit: {} faults, clearance {:.0} mm>",
            self.0.faults.len(),
            1e3 * self.0.min_clearance
        )
    }
}

/// A finished round.
#[pyclass(name = "Round", module = "wisch", frozen)]
pub struct PyRound {
    pub round: Arc<Round>,
    pub telemetry: Option<Py<PyTelemetry>>,
    config: PlanConfig,
}

impl PyRound {
    /// Converts a round of a session with this configuration.
    pub fn new(round: &Round, telemetry: Option<Py<PyTelemetry>>, config: &PlanConfig) -> Self {
        Self {
            round: Arc::new(round.clone()),
            telemetry,
            config: config.clone(),
        }
    }
}

#[pymethods]
impl PyRound {
    /// Number of the round, from 1.
    #[getter]
    fn number(&self) -> usize {
        self.round.motion.number
    }

    /// Plan of the round.
    #[getter]
    fn plan(&self) -> PyPlan {
        PyPlan::new(&self.round.motion.task, self.round.motion.plan.clone())
    }

    /// Predicted effect of the motion.
    #[getter]
    fn prediction(&self) -> PyPrediction {
        let motion = &self.round.motion;
        PyPrediction {
            task: Arc::new(motion.task.clone()),
            plan: Arc::new(motion.executable_plan()),
            prediction: motion.prediction.clone(),
        }
    }

    /// Planned motion.
    #[getter]
    fn motion(&self) -> PyMotion {
        PyMotion::from_round(&self.round.motion)
    }

    /// Result of the independent check of the motion.
    #[getter]
    fn audit(&self) -> PyAudit {
        PyAudit(self.round.audit.clone())
    }

    /// Telemetry of the motion; `None` if it was not recorded.
    #[getter]
    fn telemetry(&self, py: Python<'_>) -> Option<Py<PyTelemetry>> {
        self.telemetry.as_ref().map(|one| one.clone_ref(py))
    }

    /// Interpretation of the measurements.
    #[getter]
    fn interpretation(&self) -> PyInterpretation {
        let PlannedRound { task, plan, .. } = &self.round.motion;
        let interpretation = self.round.interpretation.clone();
        PyInterpretation::new(task, plan.graph.goal, &self.config, interpretation)
    }

    /// Expected performance, 0 to 1.
    #[getter]
    fn performance(&self) -> f64 {
        self.round.interpretation.performance.mean
    }

    /// 90 % interval of the performance; wider if the log may lack a part of the wiping.
    #[getter]
    fn interval(&self) -> (f64, f64) {
        let action = self.round.motion.task.action;
        self.round.interpretation.range(action).into()
    }

    /// Duration of the executed motion.
    #[getter]
    fn duration_s(&self) -> f64 {
        self.round.execution.duration
    }

    /// How the motion ended: complete, stopped, ended early, or protective stop.
    #[getter]
    fn ending(&self) -> &'static str {
        self.round.execution.ending.as_str()
    }

    /// Reason of an early end or a protective stop.
    #[getter]
    fn ending_cause(&self) -> Option<String> {
        match &self.round.execution.ending {
            Ending::Complete | Ending::Stopped => None,
            Ending::Early { cause, .. } => Some(cause.to_string()),
            Ending::ProtectiveStop { cause, .. } => Some(cause.to_string()),
        }
    }

    /// Pauses of the motion, each with `start_s`, `end_s` (`None` if the motion ended in it), phase and reason.
    #[getter]
    fn pauses<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let record = |pause: &Pause| {
            let dict = PyDict::new(py);
            dict.set_item("start_s", pause.start)?;
            dict.set_item("end_s", pause.end)?;
            dict.set_item("phase", pause.phase.as_str())?;
            dict.set_item("reason", &pause.reason)?;
            Ok(dict)
        };
        self.round.execution.pauses.iter().map(record).collect()
    }

    /// Verdict after the round.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.round.verdict.as_str()
    }

    /// Picture of the prediction, for notebooks.
    fn _repr_svg_(&self) -> String {
        let motion = &self.round.motion;
        pictures::draw(
            "before-after",
            &motion.task,
            &motion.executable_plan(),
            None,
        )
    }

    fn __repr__(&self) -> String {
        format!(
            "<wisch.Round {}: {:.0} %, {}>",
            self.round.motion.number,
            100.0 * self.performance(),
            self.round.verdict.as_str()
        )
    }
}
