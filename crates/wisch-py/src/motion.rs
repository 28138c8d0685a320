//! Motions for executors.

use crate::arrays::{self, Matrix, Vector, pose_array, vector};
use crate::error::refused;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use std::sync::Arc;
use wisch::follow::{Followed, Workcell};
use wisch::geometry::flatten_pose;
use wisch::represent::{SurfaceShape, Task};
use wisch::run::{MotionOrder, PlannedRound, Setpoint};

/// Sampling period of a motion [s], as in the executor protocol.
const PERIOD: f64 = 0.01;

/// Data of a motion, which Python may keep.
pub struct HeldOrder {
    /// Number of the round, from 1.
    pub round: usize,
    /// Seed of a simulated world.
    pub seed: u64,
    /// The task as it is believed.
    pub task: Task,
    /// The robot with tool and scene.
    pub cell: Workcell,
    /// The motion that follows the plan.
    pub followed: Followed,
}

impl HeldOrder {
    /// Returns the motion in the form for the library's executors.
    pub fn borrowed(&self) -> MotionOrder<'_> {
        MotionOrder {
            round: self.round,
            seed: self.seed,
            task: &self.task,
            cell: &self.cell,
            followed: &self.followed,
        }
    }
}

/// Setpoints, by column.
struct Columns {
    time_s: Py<PyArray1<f64>>,
    positions: Py<PyArray2<f64>>,
    velocities: Py<PyArray2<f64>>,
    accelerations: Py<PyArray2<f64>>,
    world_from_tool: Py<PyArray2<f64>>,
    stroke: Py<PyArray1<i64>>,
}

/// A joint motion for an executor, with all data that a robot's driver needs.
#[pyclass(name = "Motion", module = "wisch", frozen)]
pub struct PyMotion {
    pub order: Arc<HeldOrder>,
    columns: PyOnceLock<Columns>,
}

impl PyMotion {
    pub fn from_order(order: &MotionOrder<'_>) -> Self {
        Self::hold(HeldOrder {
            round: order.round,
            seed: order.seed,
            task: order.task.clone(),
            cell: order.cell.clone(),
            followed: order.followed.clone(),
        })
    }

    pub fn from_round(planned: &PlannedRound) -> Self {
        Self::from_order(&MotionOrder {
            round: planned.number,
            seed: planned.task.seed,
            task: &planned.task,
            cell: &planned.cell,
            followed: &planned.followed,
        })
    }

    fn hold(order: HeldOrder) -> Self {
        Self {
            order: Arc::new(order),
            columns: PyOnceLock::new(),
        }
    }

    fn columns(&self, py: Python<'_>) -> &Columns {
        self.columns
            .get_or_init(py, || self.sample_columns(py, PERIOD))
    }

    fn sample_columns(&self, py: Python<'_>, period: f64) -> Columns {
        let points: Vec<Setpoint> = py.detach(|| self.order.borrowed().setpoints(period).collect());
        let dof = self.order.cell.robot().dof();
        let strokes = points.iter().map(|point| {
            let stroke = point.phase.stroke();
            stroke.map_or(-1, |stroke| i64::try_from(stroke).unwrap_or(-1))
        });
        let joined = |of: fn(&Setpoint) -> &[f64]| -> Vec<f64> {
            points.iter().flat_map(of).copied().collect()
        };
        let poses = points.iter().flat_map(|p| flatten_pose(&p.world_from_tool));
        Columns {
            time_s: vector(py, points.iter().map(|p| p.time).collect()).unbind(),
            positions: arrays::matrix(py, joined(|p| &p.positions), dof).unbind(),
            velocities: arrays::matrix(py, joined(|p| &p.velocities), dof).unbind(),
            accelerations: arrays::matrix(py, joined(|p| &p.accelerations), dof).unbind(),
            world_from_tool: arrays::matrix(py, poses.collect(), 7).unbind(),
            stroke: PyArray1::from_vec(py, strokes.collect()).unbind(),
        }
    }
}

#[pymethods]
impl PyMotion {
    /// Number of the round, from 1.
    #[getter]
    fn round(&self) -> usize {
        self.order.round
    }

    /// Seed of a simulated world.
    #[getter]
    fn seed(&self) -> u64 {
        self.order.seed
    }

    /// Name of the robot.
    #[getter]
    fn robot(&self) -> &str {
        self.order.cell.robot().name()
    }

    /// Names of the robot's joints, in the order of all positions.
    #[getter]
    pub fn joints(&self) -> Vec<&str> {
        let robot = self.order.cell.robot();
        (0..robot.dof())
            .map(|i| robot.variable(i).name.as_str())
            .collect()
    }

    /// Name of the tool.
    #[getter]
    fn tool(&self) -> &str {
        &self.order.task.tool.name
    }

    /// Believed pose of the surface, (7).
    #[getter]
    fn world_from_surface<'py>(&self, py: Python<'py>) -> Vector<'py> {
        pose_array(py, &self.order.task.surface.world_from_surface)
    }

    /// Shape of a curved surface; `None` for a plane.
    #[getter]
    fn surface_shape<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        shape_dict(py, &self.order.task.surface.shape)
    }

    /// Pose of the robot's root link, (7).
    #[getter]
    fn world_from_root<'py>(&self, py: Python<'py>) -> Vector<'py> {
        pose_array(py, self.order.cell.world_from_root())
    }

    /// Name of the link that holds the tool.
    #[getter]
    fn tip(&self) -> &str {
        let robot = self.order.cell.robot();
        &robot.links()[self.order.cell.tip().index()].name
    }

    /// Pose of the tool in the frame of the link `tip`, (7).
    #[getter]
    fn tip_from_tool<'py>(&self, py: Python<'py>) -> Vector<'py> {
        pose_array(py, self.order.cell.tip_from_tool())
    }

    /// Force with which the tool is to press, and which the controller does not exceed; 0 for a tool that hovers.
    #[getter]
    fn press_force_n(&self) -> f64 {
        self.order.task.interaction.contact_force()
    }

    /// Stiffness of the controller along the surface's normal.
    #[getter]
    fn stiffness_n_per_m(&self) -> f64 {
        self.order.task.interaction.stiffness_n_per_m
    }

    /// Damping ratio of the controller.
    #[getter]
    fn damping_ratio(&self) -> f64 {
        self.order.task.interaction.damping_ratio
    }

    /// Compression of the tool under the press force.
    #[getter]
    fn compression_depth_m(&self) -> f64 {
        self.order.task.interaction.compression_depth_m
    }

    /// Height at which a tool hovers over the surface; `None` for a tool that touches.
    #[getter]
    fn gap_m(&self) -> Option<f64> {
        let interaction = &self.order.task.interaction;
        interaction.hovers().then_some(interaction.gap_m)
    }

    /// Duration of the motion.
    #[getter]
    fn duration_s(&self) -> f64 {
        self.order.followed.duration()
    }

    /// Time during which the tool is to touch the surface.
    #[getter]
    fn contact_time_s(&self) -> f64 {
        self.order.followed.contact_time()
    }

    /// Nodes of the plan that the robot cannot reach, by number.
    #[getter]
    fn abandoned(&self) -> Vec<usize> {
        let abandoned = self.order.followed.abandoned.iter();
        abandoned.map(|node| node.node).collect()
    }

    /// Strokes that the robot executes, each (k, 3): x, y [m] and yaw [rad] in the frame of the surface.
    #[getter]
    fn strokes<'py>(&self, py: Python<'py>) -> Vec<Matrix<'py>> {
        let strokes = self.order.followed.strokes.iter();
        strokes
            .map(|stroke| crate::plan::poses(py, stroke))
            .collect()
    }

    /// Believed positions of the dirt, (N, 2) in the frame of the surface [m].
    #[getter]
    fn particles<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        arrays::points(py, self.order.task.particles.remaining())
    }

    /// Phases of the motion: phase, stroke, `start_s` and `end_s`.
    #[getter]
    fn phases<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let order = self.order.borrowed();
        let motions = order.followed.motions.iter().enumerate();
        let motions = motions.map(|(index, motion)| {
            let phase = PyDict::new(py);
            phase.set_item("phase", motion.phase.as_str())?;
            if let Some(stroke) = motion.phase.stroke() {
                phase.set_item("stroke", stroke)?;
            }
            phase.set_item("start_s", motion.start)?;
            phase.set_item("end_s", motion.end())?;
            if let Some(ramp) = order.force_ramp(index) {
                phase.set_item("force_n", [ramp.start_force, ramp.end_force])?;
                phase.set_item("force_ramp_s", ramp.duration)?;
                phase.set_item("approach_speed_m_s", ramp.approach_speed)?;
            }
            Ok(phase)
        });
        motions.collect()
    }

    /// Times of the setpoints, (T).
    #[getter]
    fn time_s(&self, py: Python<'_>) -> Py<PyArray1<f64>> {
        self.columns(py).time_s.clone_ref(py)
    }

    /// Joint positions, (T, n) [rad or m].
    #[getter]
    fn positions(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.columns(py).positions.clone_ref(py)
    }

    /// Joint velocities, (T, n) [rad/s or m/s].
    #[getter]
    fn velocities(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.columns(py).velocities.clone_ref(py)
    }

    /// Joint accelerations, (T, n) [rad/s² or m/s²].
    #[getter]
    fn accelerations(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.columns(py).accelerations.clone_ref(py)
    }

    /// Poses of the tool, (T, 7).
    #[getter]
    fn world_from_tool(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.columns(py).world_from_tool.clone_ref(py)
    }

    /// Number of the stroke at each time, -1 where the tool does not touch, (T).
    #[getter]
    fn stroke(&self, py: Python<'_>) -> Py<PyArray1<i64>> {
        self.columns(py).stroke.clone_ref(py)
    }

    /// Returns the motion sampled at another period [s].
    fn setpoints<'py>(&self, py: Python<'py>, period_s: f64) -> PyResult<Bound<'py, PyDict>> {
        if !(1e-5..=100.0).contains(&period_s) {
            return Err(refused("period_s", period_s, "0.00001 to 100"));
        }
        let columns = self.sample_columns(py, period_s);
        let all = PyDict::new(py);
        all.set_item("time_s", columns.time_s)?;
        all.set_item("positions", columns.positions)?;
        all.set_item("velocities", columns.velocities)?;
        all.set_item("accelerations", columns.accelerations)?;
        all.set_item("world_from_tool", columns.world_from_tool)?;
        all.set_item("stroke", columns.stroke)?;
        Ok(all)
    }

    fn __repr__(&self) -> String {
        format!(
            "<wisch.Motion of round {}: {} for {:.1} s>",
            self.order.round,
            self.order.cell.robot().name(),
            self.order.followed.duration()
        )
    }
}

/// Returns the shape of a curved surface; `None` for a plane.
pub(crate) fn shape_dict<'py>(
    py: Python<'py>,
    shape: &SurfaceShape,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let stated = PyDict::new(py);
    match shape {
        SurfaceShape::Plane => return Ok(None),
        SurfaceShape::Cylinder { radius, axis } => {
            stated.set_item("kind", "cylinder")?;
            stated.set_item("radius_m", radius)?;
            stated.set_item("axis_rad", axis)?;
        }
        SurfaceShape::Cone(cone) => {
            stated.set_item("kind", "cone")?;
            stated.set_item("radius_m", cone.radius)?;
            stated.set_item("half_angle_rad", cone.half_angle)?;
            stated.set_item("axis_rad", cone.axis)?;
        }
        SurfaceShape::Mesh(mesh) => {
            let sheet = mesh.sheet();
            stated.set_item("kind", "mesh")?;
            let places = sheet.vertices().map(|vertex| vertex.place);
            stated.set_item("places_m", arrays::points(py, places))?;
            let points: Vec<[f64; 3]> = (sheet.vertices())
                .map(|vertex| vertex.point.coords.into())
                .collect();
            stated.set_item("points_m", points)?;
            let triangles: Vec<[u32; 3]> = sheet.triangles().map(|(corners, _)| corners).collect();
            stated.set_item("triangles", triangles)?;
        }
    }
    Ok(Some(stated))
}
