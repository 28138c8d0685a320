//! Robots: a URDF as kinematics and dynamics.

use crate::arrays::{self, Matrix, Vector, of_joints, pose_array, vector};
use crate::error::{of_file, of_robot, plain, refused};
use nalgebra::DMatrix;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use wisch::geometry::{Point3, Vector3};
use wisch::robot::Range;
use wisch_io::Robot;

/// Acceleration of free fall in the world [m/s²].
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// A robot: a URDF, with the SRDF and the capability map beside it.
#[pyclass(name = "Robot", module = "wisch", frozen)]
pub struct PyRobot {
    pub robot: Arc<Robot>,
    /// Whether the task names this robot, so that the groups of the task apply.
    is_of_task: bool,
}

impl PyRobot {
    /// Loads the robot that a task names.
    pub fn of_task(robot: Robot) -> Self {
        Self {
            robot: Arc::new(robot),
            is_of_task: true,
        }
    }

    /// Converts a robot, a name or a path to a robot. Also returns whether the task names it.
    pub fn parse(given: &Bound<'_, PyAny>) -> PyResult<(Arc<Robot>, bool)> {
        if let Ok(robot) = given.cast::<Self>() {
            let robot = robot.get();
            return Ok((Arc::clone(&robot.robot), robot.is_of_task));
        }
        let path = given.py().import("os")?.call_method1("fspath", (given,));
        let name = path.and_then(|path| path.extract::<String>());
        let name = name.map_err(|_| {
            refused(
                "robot",
                arrays::kind_of(given),
                "a wisch.Robot, a name or a path",
            )
        })?;
        let robot = given.py().detach(|| Robot::load(&name)).map_err(of_file)?;
        warn_of(given.py(), robot.warnings())?;
        Ok((Arc::new(robot), false))
    }

    fn joints_of(&self, q: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        of_joints("q", q, self.robot.model.dof())
    }
}

/// Issues a Python warning for each sentence.
pub fn warn_of(py: Python<'_>, sentences: Vec<String>) -> PyResult<()> {
    let category = py.get_type::<pyo3::exceptions::PyUserWarning>();
    for warning in sentences {
        let message = std::ffi::CString::new(warning).map_err(plain)?;
        PyErr::warn(py, &category, &message, 2)?;
    }
    Ok(())
}

/// Returns a matrix as an array.
pub fn rows_of<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> Matrix<'py> {
    let numbers = matrix.transpose().as_slice().to_vec();
    arrays::matrix(py, numbers, matrix.ncols())
}

#[pymethods]
impl PyRobot {
    /// Loads a shipped robot by its name, or a URDF by its path.
    #[staticmethod]
    fn load(urdf: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (robot, is_of_task) = Self::parse(urdf)?;
        Ok(Self { robot, is_of_task })
    }

    /// Name of the robot.
    #[getter]
    fn name(&self) -> &str {
        self.robot.model.name()
    }

    /// Number of independent joints, n.
    #[getter]
    fn dof(&self) -> usize {
        self.robot.model.dof()
    }

    /// Names of the independent joints, in the order of positions.
    #[getter]
    fn joints(&self) -> Vec<&str> {
        let model = &self.robot.model;
        (0..model.dof())
            .map(|i| model.variable(i).name.as_str())
            .collect()
    }

    /// Names of the links.
    #[getter]
    fn links(&self) -> Vec<&str> {
        let links = self.robot.model.links().iter();
        links.map(|link| link.name.as_str()).collect()
    }

    /// Text of the URDF.
    #[getter]
    fn urdf(&self) -> &str {
        &self.robot.files.urdf
    }

    /// Text of the SRDF; `None` without one.
    #[getter]
    fn srdf(&self) -> Option<&str> {
        self.robot.files.srdf.as_deref()
    }

    /// For each joint by name: kind, unit, lower, upper, velocity, acceleration and effort; `None` without a limit.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let model = &self.robot.model;
        for i in 0..model.dof() {
            let joint = model.variable(i);
            let one = PyDict::new(py);
            let range: Option<Range> = joint.limits.position;
            one.set_item("unit", joint.kind.unit())?;
            one.set_item("lower", range.map(|range| range.lower))?;
            one.set_item("upper", range.map(|range| range.upper))?;
            one.set_item("velocity", joint.limits.velocity)?;
            one.set_item("acceleration", joint.limits.acceleration)?;
            one.set_item("effort", joint.limits.effort)?;
            all.set_item(&joint.name, one)?;
        }
        Ok(all)
    }

    /// Returns the pose of a link in the frame of the root link at positions q (n), (7).
    fn pose<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        link: &str,
    ) -> PyResult<Vector<'py>> {
        let model = &self.robot.model;
        let link = model.link(link).map_err(of_robot)?;
        let kinematics = model
            .forward_kinematics(&self.joints_of(q)?)
            .map_err(of_robot)?;
        Ok(pose_array(py, &kinematics.world_from_link(link)))
    }

    /// Returns the Jacobian of a link's point, (6, n), linear first, in the axes of the root link.
    #[pyo3(signature = (q, link, point_in_link = None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        link: &str,
        point_in_link: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Matrix<'py>> {
        let model = &self.robot.model;
        let link = model.link(link).map_err(of_robot)?;
        let point = point_in_link.map_or(Ok([0.0; 3]), |p| arrays::to_array("point_in_link", p))?;
        let kinematics = model
            .forward_kinematics(&self.joints_of(q)?)
            .map_err(of_robot)?;
        let jacobian = kinematics.jacobian(link, Point3::from(point));
        let numbers = jacobian.transpose().as_slice().to_vec();
        Ok(arrays::matrix(py, numbers, model.dof()))
    }

    /// Returns the mass matrix at positions q (n), (n, n) [kg m², kg m or kg].
    fn mass_matrix<'py>(&self, py: Python<'py>, q: &Bound<'py, PyAny>) -> PyResult<Matrix<'py>> {
        let dynamics = self.robot.model.dynamics().map_err(of_robot)?;
        let mass = dynamics
            .mass_matrix(&self.joints_of(q)?)
            .map_err(of_robot)?;
        Ok(rows_of(py, &mass))
    }

    /// Returns the efforts that hold the robot against gravity at positions q (n), (n) [Nm or N].
    fn gravity<'py>(&self, py: Python<'py>, q: &Bound<'py, PyAny>) -> PyResult<Vector<'py>> {
        let dynamics = self.robot.model.dynamics().map_err(of_robot)?;
        let efforts = dynamics
            .gravity(&self.joints_of(q)?, GRAVITY)
            .map_err(of_robot)?;
        Ok(vector(py, efforts.as_slice().to_vec()))
    }

    /// Returns the Coriolis, centrifugal and gravity efforts, (n) [Nm or N].
    fn bias<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        qd: &Bound<'py, PyAny>,
    ) -> PyResult<Vector<'py>> {
        let dynamics = self.robot.model.dynamics().map_err(of_robot)?;
        let qd = of_joints("qd", qd, self.robot.model.dof())?;
        let efforts = dynamics
            .bias(&self.joints_of(q)?, &qd, GRAVITY)
            .map_err(of_robot)?;
        Ok(vector(py, efforts.as_slice().to_vec()))
    }

    /// Returns the efforts for accelerations, (n) [Nm or N].
    fn inverse_dynamics<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        qd: &Bound<'py, PyAny>,
        qdd: &Bound<'py, PyAny>,
    ) -> PyResult<Vector<'py>> {
        let dof = self.robot.model.dof();
        let dynamics = self.robot.model.dynamics().map_err(of_robot)?;
        let (qd, qdd) = (of_joints("qd", qd, dof)?, of_joints("qdd", qdd, dof)?);
        let efforts = dynamics
            .inverse_dynamics(&self.joints_of(q)?, &qd, &qdd, GRAVITY)
            .map_err(of_robot)?;
        Ok(vector(py, efforts.as_slice().to_vec()))
    }

    fn __repr__(&self) -> String {
        let model = &self.robot.model;
        format!("<wisch.Robot {:?}: {} joints>", model.name(), model.dof())
    }
}
