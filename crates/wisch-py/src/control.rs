//! The controller (8) along a motion.

use crate::arrays::{Vector, of_joints, pose_array, vector};
use crate::error::{of_robot, plain, refused};
use crate::motion::{HeldOrder, PyMotion};
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};
use wisch::control::{ControlCommand, ControlConfig, MotionController, Wrench};

/// Default mass of a tool [kg].
const TOOL_MASS: f64 = 0.15;

/// The whole-body impedance controller (8) with the observer of the external force, along a motion.
#[pyclass(name = "ImpedanceController", module = "wisch", frozen)]
pub struct PyImpedanceController {
    order: Arc<HeldOrder>,
    state: Mutex<State>,
}

struct State {
    controller: MotionController,
    command: Option<ControlCommand>,
}

impl PyImpedanceController {
    fn with<T>(&self, run: impl FnOnce(&mut State) -> T) -> T {
        run(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn read_command<T>(&self, read: impl FnOnce(&ControlCommand) -> T) -> PyResult<T> {
        self.with(|state| state.command.as_ref().map(read))
            .ok_or_else(|| plain("the controller has not been commanded yet"))
    }
}

fn force<'py>(py: Python<'py>, wrench: &Wrench) -> Vector<'py> {
    let all = wrench.force.iter().chain(wrench.moment.iter());
    vector(py, all.copied().collect())
}

#[pymethods]
impl PyImpedanceController {
    #[new]
    #[pyo3(signature = (motion, *, period_s = 1e-3, tool_mass_kg = TOOL_MASS, lateral_stiffness_n_per_m = None, rotational_stiffness_nm_per_rad = None, moment_limit_nm = None, press_margin = None, observer_gain_per_s = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        motion: &PyMotion,
        period_s: f64,
        tool_mass_kg: f64,
        lateral_stiffness_n_per_m: Option<f64>,
        rotational_stiffness_nm_per_rad: Option<f64>,
        moment_limit_nm: Option<f64>,
        press_margin: Option<f64>,
        observer_gain_per_s: Option<f64>,
    ) -> PyResult<Self> {
        let usual = ControlConfig::default();
        let config = ControlConfig {
            period: period_s,
            lateral_stiffness: lateral_stiffness_n_per_m.unwrap_or(usual.lateral_stiffness),
            rotational_stiffness: rotational_stiffness_nm_per_rad
                .unwrap_or(usual.rotational_stiffness),
            moment_limit: moment_limit_nm.unwrap_or(usual.moment_limit),
            press_margin: press_margin.unwrap_or(usual.press_margin),
            observer_gain: observer_gain_per_s.unwrap_or(usual.observer_gain),
            ..usual
        };
        for (name, value) in [
            ("period_s", config.period),
            ("tool_mass_kg", tool_mass_kg),
            ("lateral_stiffness_n_per_m", config.lateral_stiffness),
            (
                "rotational_stiffness_nm_per_rad",
                config.rotational_stiffness,
            ),
            ("moment_limit_nm", config.moment_limit),
            ("press_margin", config.press_margin),
            ("observer_gain_per_s", config.observer_gain),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(refused(name, value, "a finite number from 0 up"));
            }
        }
        let order = Arc::clone(&motion.order);
        let controller = MotionController::new(
            &order.task,
            &order.cell,
            &order.followed,
            tool_mass_kg,
            &config,
        );
        let controller = controller.map_err(of_robot)?.ok_or_else(|| {
            let robot = order.cell.robot().name();
            plain(format!("{robot}: no joint of the robot moves the tool"))
        })?;
        Ok(Self {
            order,
            state: Mutex::new(State {
                controller,
                command: None,
            }),
        })
    }

    /// Names of the joints that the controller drives, in the order of its efforts.
    #[getter]
    fn joints(&self) -> Vec<String> {
        let robot = self.order.cell.robot();
        self.with(|state| {
            let compliant = state.controller.compliant_variables();
            compliant.map(|i| robot.variable(i).name.clone()).collect()
        })
    }

    /// Their indices among the robot's joints.
    #[getter]
    fn compliant(&self) -> Vec<usize> {
        self.with(|state| state.controller.compliant_variables().collect())
    }

    /// Computes the efforts of the compliant joints (k) [Nm or N] at a time [s] of the motion, from all n positions and
    /// velocities.
    fn command<'py>(
        &self,
        py: Python<'py>,
        time_s: f64,
        q: &Bound<'py, PyAny>,
        qd: &Bound<'py, PyAny>,
    ) -> PyResult<Vector<'py>> {
        let dof = self.order.cell.robot().dof();
        if !time_s.is_finite() {
            return Err(refused("time_s", time_s, "a finite number"));
        }
        let (q, qd) = (of_joints("q", q, dof)?, of_joints("qd", qd, dof)?);
        let HeldOrder { task, followed, .. } = &*self.order;
        self.with(|state| {
            state.command = state.controller.command(task, followed, time_s, &q, &qd);
            if state.command.is_none() {
                return Err(plain(format!(
                    "at {time_s} s the mass matrix of the robot is not positive definite"
                )));
            }
            Ok(vector(py, state.controller.efforts().to_vec()))
        })
    }

    /// Planned state of all n joints at the last command: positions, velocities and accelerations, (n) each.
    #[getter]
    fn planned<'py>(&self, py: Python<'py>) -> (Vector<'py>, Vector<'py>, Vector<'py>) {
        self.with(|state| {
            let planned = state.controller.planned_sample();
            let array = |numbers: &Vec<f64>| vector(py, numbers.clone());
            (array(&planned.q), array(&planned.qd), array(&planned.qdd))
        })
    }

    /// Pose of the tool by forward kinematics, (7).
    #[getter]
    fn world_from_tool<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.read_command(|command| pose_array(py, &command.world_from_tool))
    }

    /// Commanded pose of the tool, including the press into the surface, (7).
    #[getter]
    fn world_from_commanded<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.read_command(|command| pose_array(py, &command.desired.world_from_tool))
    }

    /// Commanded wrench on the tool: force [N] and moment [Nm] in the axes of the world, (6).
    #[getter]
    fn controller_wrench<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.read_command(|command| force(py, &command.controller))
    }

    /// Observed wrench of the surroundings on the tool: force [N] and moment [Nm] in the axes of the world, (6).
    #[getter]
    fn external_wrench<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.read_command(|command| force(py, &command.external))
    }
}
