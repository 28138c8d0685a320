//! Telemetry as columns: what was measured, one array per quantity, each owning its memory.

use crate::arrays::{self, numbers, vector};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use wisch::run::TelemetrySample;

/// Columns that grow sample by sample.
#[derive(Default)]
pub struct Columns {
    time: Vec<f64>,
    stroke: Vec<i64>,
    world_from_tool: Vec<f64>,
    world_from_commanded: Vec<f64>,
    force: Vec<f64>,
    moment: Vec<f64>,
    controller_force: Vec<f64>,
    controller_moment: Vec<f64>,
    joints: [Vec<f64>; 3],
    /// How many numbers of each kind a sample has, as the first had them.
    counts: [usize; 3],
}

impl Columns {
    /// Takes one sample.
    pub fn push(&mut self, sample: &TelemetrySample<'_>) {
        let lists = [sample.positions, sample.velocities, sample.efforts];
        if self.time.is_empty() {
            self.counts = lists.map(<[f64]>::len);
        }
        self.time.push(sample.time);
        let stroke = sample.phase.stroke().map(i64::try_from);
        self.stroke.push(stroke.and_then(Result::ok).unwrap_or(-1));
        self.world_from_tool
            .extend(numbers(&sample.world_from_tool));
        self.world_from_commanded
            .extend(numbers(&sample.world_from_commanded));
        self.force.extend(sample.external.force.iter());
        self.moment.extend(sample.external.moment.iter());
        self.controller_force.extend(sample.controller.force.iter());
        self.controller_moment
            .extend(sample.controller.moment.iter());
        for ((column, count), list) in self.joints.iter_mut().zip(self.counts).zip(lists) {
            // A sample that measured less than the first leaves gaps.
            column.extend((0..count).map(|i| list.get(i).copied().unwrap_or(f64::NAN)));
        }
    }
}

/// What was measured in a round, or is in a log: one array per quantity, row by row one per sample.
#[pyclass(name = "Telemetry", module = "wisch", frozen, get_all)]
pub struct PyTelemetry {
    /// The round, from 1; 0 of a log.
    round: usize,
    /// (T) [s].
    time_s: Py<PyArray1<f64>>,
    /// The stroke that was wiped, -1 where none was, (T).
    stroke: Py<PyArray1<i64>>,
    /// (T, 7).
    world_from_tool: Py<PyArray2<f64>>,
    /// (T, 7).
    world_from_commanded: Py<PyArray2<f64>>,
    /// Of the surroundings on the tool, in the axes of the world, (T, 3) [N].
    force_n: Py<PyArray2<f64>>,
    /// (T, 3) [Nm].
    moment_nm: Py<PyArray2<f64>>,
    /// What the controller asked of the tool, (T, 3) [N].
    controller_force_n: Py<PyArray2<f64>>,
    /// (T, 3) [Nm].
    controller_moment_nm: Py<PyArray2<f64>>,
    /// (T, n) [rad or m].
    positions: Py<PyArray2<f64>>,
    /// (T, n), or (T, 0) where they were not measured [rad/s or m/s].
    velocities: Py<PyArray2<f64>>,
    /// (T, n), or (T, 0) [Nm or N].
    efforts: Py<PyArray2<f64>>,
}

impl PyTelemetry {
    /// Whether it is of this round.
    pub const fn is_of(&self, round: usize) -> bool {
        self.round == round
    }

    /// The arrays of the columns, which they take over.
    pub fn of(py: Python<'_>, round: usize, columns: Columns) -> PyResult<Py<Self>> {
        let samples = columns.time.len();
        let rows = |numbers: Vec<f64>, width: usize| {
            if width == 0 {
                return PyArray2::zeros(py, [samples, 0], false).unbind();
            }
            arrays::matrix(py, numbers, width).unbind()
        };
        let [positions, velocities, efforts] = columns.joints;
        let counts = columns.counts;
        let telemetry = Self {
            round,
            time_s: vector(py, columns.time).unbind(),
            stroke: PyArray1::from_vec(py, columns.stroke).unbind(),
            world_from_tool: rows(columns.world_from_tool, 7),
            world_from_commanded: rows(columns.world_from_commanded, 7),
            force_n: rows(columns.force, 3),
            moment_nm: rows(columns.moment, 3),
            controller_force_n: rows(columns.controller_force, 3),
            controller_moment_nm: rows(columns.controller_moment, 3),
            positions: rows(positions, counts[0]),
            velocities: rows(velocities, counts[1]),
            efforts: rows(efforts, counts[2]),
        };
        Py::new(py, telemetry)
    }
}

#[pymethods]
impl PyTelemetry {
    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.time_s.bind(py).len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let count = self.__len__(py)?;
        Ok(format!(
            "<wisch.Telemetry of round {}: {count} samples>",
            self.round
        ))
    }
}
