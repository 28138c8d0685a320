//! Telemetry as columns: an array per quantity, which owns its memory.

use crate::arrays::{self, list, rows, vector};
use crate::error::{plain, refused};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use wisch::follow::{Followed, Phase};
use wisch::geometry::{Pose, Vector3, flatten_pose, restore_pose};
use wisch::interpret::{TouchSample, UnusableWrenches, WrenchQuality};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_telemetry::{
    Axes, AxesChoice, AxesSource, Log, LogOptions, OrientationForm, Payload, TopicChoice,
    WrenchSign,
};

/// Columns that grow sample by sample.
#[derive(Default)]
pub struct Columns {
    time: Vec<f64>,
    stroke: Vec<i64>,
    quality: Vec<u8>,
    world_from_tool: Vec<f64>,
    world_from_commanded: Vec<f64>,
    force: Vec<f64>,
    moment: Vec<f64>,
    controller_force: Vec<f64>,
    controller_moment: Vec<f64>,
    joints: [Vec<f64>; 3],
    /// Number of values of each quantity in a sample, by the first sample.
    counts: [usize; 3],
}

impl Columns {
    /// Adds a sample.
    pub fn push(&mut self, sample: &TelemetrySample<'_>) {
        let lists = [sample.positions, sample.velocities, sample.efforts];
        if self.time.is_empty() {
            self.counts = lists.map(<[f64]>::len);
        }
        self.time.push(sample.time);
        let stroke = sample.phase.stroke().map(i64::try_from);
        self.stroke.push(stroke.and_then(Result::ok).unwrap_or(-1));
        self.quality.push(sample.status.wrench as u8);
        self.world_from_tool
            .extend(flatten_pose(&sample.world_from_tool));
        self.world_from_commanded
            .extend(flatten_pose(&sample.world_from_commanded));
        self.force.extend(sample.external.force.iter());
        self.moment.extend(sample.external.moment.iter());
        self.controller_force.extend(sample.controller.force.iter());
        self.controller_moment
            .extend(sample.controller.moment.iter());
        for ((column, count), list) in self.joints.iter_mut().zip(self.counts).zip(lists) {
            // A sample with fewer values than the first leaves gaps.
            column.extend((0..count).map(|i| list.get(i).copied().unwrap_or(f64::NAN)));
        }
    }
}

/// Telemetry of a round or a log: an array per quantity, with a row per sample.
#[pyclass(name = "Telemetry", module = "wisch", frozen, get_all)]
pub struct PyTelemetry {
    /// Number of the round, from 1; 0 for a log that does not state it.
    round: usize,
    /// Times of the samples since the start of the motion or log, (T) [s].
    time_s: Py<PyArray1<f64>>,
    /// Number of the stroke, -1 outside strokes, (T).
    stroke: Py<PyArray1<i64>>,
    /// Quality of the force and moment: 0 ok, 1 stale, 2 saturated, 3 untared, (T).
    wrench_quality: Py<PyArray1<u8>>,
    /// Poses of the tool, (T, 7).
    world_from_tool: Py<PyArray2<f64>>,
    /// Commanded poses of the tool, (T, 7).
    world_from_commanded: Py<PyArray2<f64>>,
    /// Force of the surroundings on the tool, in the axes of the world, (T, 3) [N].
    force_n: Py<PyArray2<f64>>,
    /// Moment of the surroundings about the tool centre point, in the axes of the world, (T, 3) [Nm].
    moment_nm: Py<PyArray2<f64>>,
    /// Force that the controller commanded, (T, 3) [N].
    controller_force_n: Py<PyArray2<f64>>,
    /// Moment that the controller commanded, about the tool centre point, (T, 3) [Nm].
    controller_moment_nm: Py<PyArray2<f64>>,
    /// Joint positions, (T, n), or (T, 0) if not measured [rad or m].
    positions: Py<PyArray2<f64>>,
    /// Joint velocities, (T, n), or (T, 0) if not measured [rad/s or m/s].
    velocities: Py<PyArray2<f64>>,
    /// Joint efforts, (T, n), or (T, 0) if not measured [Nm or N].
    efforts: Py<PyArray2<f64>>,
    /// How a log was read: assumptions, transforms, samples that were left out, gaps; a sentence each.
    remarks: Vec<String>,
    /// Samples of a log that were left out because their wrench or their pose is not usable.
    /// In turn: stale, saturated, untared, with a frozen pose, without a pose.
    left_out: [usize; 5],
    /// Times [s] and poses of the tool before the first force and after the last; x, y, z [m] and the quaternion x, y, z, w.
    poses_alone: Vec<(f64, [f64; 7])>,
}

/// Input for the interpreter.
#[derive(Debug, Clone, Default)]
pub struct LoggedTouches {
    /// Poses and forces.
    pub samples: Vec<TouchSample>,
    /// Numbers of samples that were left out.
    pub unusable: UnusableWrenches,
    /// Times [s] and poses of the tool in the world without a force, before the first sample and after the last; x, y, z [m] and
    /// the quaternion x, y, z, w.
    pub poses_alone: Vec<(f64, [f64; 7])>,
}

impl PyTelemetry {
    /// Whether it belongs to this round.
    pub const fn is_of(&self, round: usize) -> bool {
        self.round == round
    }

    /// Returns the input for the interpreter, without the samples whose wrench is not usable.
    pub fn touches(&self, py: Python<'_>) -> PyResult<LoggedTouches> {
        let (times, poses, forces) = (&self.time_s, &self.world_from_tool, &self.force_n);
        let samples = touches(times.bind(py), poses.bind(py), forces.bind(py))?;
        let [stale, saturated, untared, frozen_pose, missing_pose] = self.left_out;
        let mut unusable = UnusableWrenches {
            stale,
            saturated,
            untared,
            frozen_pose,
            missing_pose,
        };
        let qualities = self.qualities(py)?;
        let usable = samples.into_iter().zip(qualities).filter(|(_, quality)| {
            unusable.add(*quality);
            quality.is_usable()
        });
        let usable = usable.map(|(sample, _)| sample).collect();
        Ok(LoggedTouches {
            samples: usable,
            unusable,
            poses_alone: self.poses_alone.clone(),
        })
    }

    fn qualities(&self, py: Python<'_>) -> PyResult<Vec<WrenchQuality>> {
        let numbers = self.wrench_quality.bind(py).to_vec().map_err(plain)?;
        let samples = self.time_s.bind(py).len()?;
        if numbers.len() != samples {
            return Err(refused("length of wrench_quality", numbers.len(), samples));
        }
        let last = WrenchQuality::ALL.len() - 1;
        let quality = |(k, number): (usize, u8)| {
            let known = WrenchQuality::ALL.get(usize::from(number)).copied();
            known.ok_or_else(|| {
                refused(
                    &format!("wrench_quality[{k}]"),
                    number,
                    format!("0 to {last}"),
                )
            })
        };
        numbers.into_iter().enumerate().map(quality).collect()
    }

    /// Calls back with the samples of a motion.
    pub fn each<E: std::fmt::Display>(
        &self,
        py: Python<'_>,
        followed: &Followed,
        mut take: impl FnMut(&TelemetrySample<'_>) -> Result<(), E>,
    ) -> PyResult<()> {
        let column = |array: &Py<PyArray2<f64>>| array.bind(py).to_vec().map_err(plain);
        let times = self.time_s.bind(py).to_vec().map_err(plain)?;
        let [tool, commanded] = [&self.world_from_tool, &self.world_from_commanded].map(column);
        let [force, moment] = [&self.force_n, &self.moment_nm].map(column);
        let [controller_force, controller_moment] =
            [&self.controller_force_n, &self.controller_moment_nm].map(column);
        let [q, qd, efforts] = [&self.positions, &self.velocities, &self.efforts].map(column);
        let (tool, commanded, force, moment) = (tool?, commanded?, force?, moment?);
        let (controller_force, controller_moment, q, qd, efforts) =
            (controller_force?, controller_moment?, q?, qd?, efforts?);
        let qualities = self.qualities(py)?;
        let count = times.len();
        let of = |numbers: &[f64], k: usize| -> std::ops::Range<usize> {
            let width = numbers.len().checked_div(count).unwrap_or_default();
            k * width..(k + 1) * width
        };
        let at = |numbers: &[f64], k: usize| -> Vec<f64> { numbers[of(numbers, k)].to_vec() };
        for (k, &time) in times.iter().enumerate() {
            let motion = followed.index_at(time);
            let phase = followed.motions.get(motion).map(|motion| motion.phase);
            let sample = TelemetrySample {
                time,
                positions: &q[of(&q, k)],
                velocities: &qd[of(&qd, k)],
                efforts: &efforts[of(&efforts, k)],
                world_from_commanded: pose_of(&at(&commanded, k)),
                world_from_tool: pose_of(&at(&tool, k)),
                controller: wrench_of(&at(&controller_force, k), &at(&controller_moment, k)),
                external: wrench_of(&at(&force, k), &at(&moment, k)),
                motion,
                phase: phase.unwrap_or(Phase::FreeMotion),
                status: SampleStatus {
                    wrench: qualities[k],
                    ..SampleStatus::default()
                },
            };
            take(&sample).map_err(plain)?;
        }
        Ok(())
    }

    /// Returns the arrays that take over the columns of a round.
    pub fn from_columns(py: Python<'_>, round: usize, columns: Columns) -> PyResult<Py<Self>> {
        Py::new(py, Self::new(py, round, columns))
    }

    /// Returns the samples of a log, with what is to be known about its reading.
    fn of_log(py: Python<'_>, log: &Log) -> PyResult<Py<Self>> {
        let mut columns = Columns::default();
        for touch in &log.samples {
            columns.push(&TelemetrySample::from_touch(touch, 0, Phase::FreeMotion));
        }
        let mut remarks = log.describe_reading();
        if log.axes_source == AxesSource::Assumed {
            remarks.push(format!(
                "the axes of the force are assumed to be those of the {}; state others with wrench_frame",
                log.axes.as_str()
            ));
        }
        let UnusableWrenches {
            stale,
            saturated,
            untared,
            frozen_pose,
            missing_pose,
        } = log.unusable;
        let poses_alone = log.poses_alone.iter();
        let poses_alone = poses_alone.map(|(time, pose)| (*time, flatten_pose(pose)));
        let telemetry = Self {
            remarks,
            left_out: [stale, saturated, untared, frozen_pose, missing_pose],
            poses_alone: poses_alone.collect(),
            ..Self::new(py, log.round.unwrap_or_default(), columns)
        };
        Py::new(py, telemetry)
    }

    fn new(py: Python<'_>, round: usize, columns: Columns) -> Self {
        let samples = columns.time.len();
        let rows = |numbers: Vec<f64>, width: usize| {
            if width == 0 {
                return PyArray2::zeros(py, [samples, 0], false).unbind();
            }
            arrays::matrix(py, numbers, width).unbind()
        };
        let [positions, velocities, efforts] = columns.joints;
        let counts = columns.counts;
        Self {
            round,
            time_s: vector(py, columns.time).unbind(),
            stroke: PyArray1::from_vec(py, columns.stroke).unbind(),
            wrench_quality: PyArray1::from_vec(py, columns.quality).unbind(),
            world_from_tool: rows(columns.world_from_tool, 7),
            world_from_commanded: rows(columns.world_from_commanded, 7),
            force_n: rows(columns.force, 3),
            moment_nm: rows(columns.moment, 3),
            controller_force_n: rows(columns.controller_force, 3),
            controller_moment_nm: rows(columns.controller_moment, 3),
            positions: rows(positions, counts[0]),
            velocities: rows(velocities, counts[1]),
            efforts: rows(efforts, counts[2]),
            remarks: Vec::new(),
            left_out: [0; 5],
            poses_alone: Vec::new(),
        }
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

fn pose_of(numbers: &[f64]) -> Pose {
    numbers.try_into().map_or(Pose::identity(), restore_pose)
}

fn wrench_of(force: &[f64], moment: &[f64]) -> Wrench {
    let vector = |numbers: &[f64]| match numbers {
        &[x, y, z] => Vector3::new(x, y, z),
        _ => Vector3::zeros(),
    };
    Wrench {
        force: vector(force),
        moment: vector(moment),
    }
}

/// Returns samples of touch from arrays of times, poses and forces.
pub fn touches(
    times: &Bound<'_, PyAny>,
    poses: &Bound<'_, PyAny>,
    forces: &Bound<'_, PyAny>,
) -> PyResult<Vec<TouchSample>> {
    let times = list("time_s", times)?;
    let poses = rows::<7>("world_from_tool", poses)?;
    let forces = rows::<3>("force_n", forces)?;
    for (name, count) in [("world_from_tool", poses.len()), ("force_n", forces.len())] {
        if count != times.len() {
            let limit = format!("{}, one per time", times.len());
            return Err(refused(name, format!("{count} rows"), limit));
        }
    }
    let samples = times.into_iter().zip(poses).zip(forces).enumerate();
    let samples = samples.map(|(k, ((time, pose), force))| {
        let norm = pose[3..].iter().map(|x| x * x).sum::<f64>().sqrt();
        let is_unit = (norm - 1.0).abs() <= 1e-3;
        if !is_unit {
            let place = format!("world_from_tool[{k}]");
            let found = format!("a quaternion of norm {norm}");
            return Err(refused(&place, found, "1 within 0.001"));
        }
        let force = Vector3::from(force);
        Ok(TouchSample::new(time, pose_of(&pose), force))
    });
    samples.collect()
}

/// Reads a log: a ROS 2 bag (MCAP), a folder with the parts of a bag, or a table (text with a line of names, Parquet,
/// Arrow or npz). Options are those of `wisch interpret`.
#[pyfunction]
#[pyo3(signature = (path, *, pose_topic = None, wrench_topic = None, columns = None, wrench_frame = None, wrench_sign = None, force_bias_n = None, force_scale = None, payload_mass_kg = None, payload_centre_m = None, orientation = None, rate_hz = None, force_unit_n = None, length_unit_m = None, time_unit_s = None, pose_frame = None, world_from_log = None, world_from_surface = None, pose_offset = None, max_gap_s = 0.1))]
#[expect(clippy::too_many_arguments, reason = "Python names them")]
pub fn read_log(
    py: Python<'_>,
    path: PathBuf,
    pose_topic: Option<String>,
    wrench_topic: Option<String>,
    columns: Option<&Bound<'_, PyDict>>,
    wrench_frame: Option<&str>,
    wrench_sign: Option<&str>,
    force_bias_n: Option<[f64; 3]>,
    force_scale: Option<f64>,
    payload_mass_kg: Option<f64>,
    payload_centre_m: Option<[f64; 3]>,
    orientation: Option<&str>,
    rate_hz: Option<f64>,
    force_unit_n: Option<f64>,
    length_unit_m: Option<f64>,
    time_unit_s: Option<f64>,
    pose_frame: Option<String>,
    world_from_log: Option<&Bound<'_, PyAny>>,
    world_from_surface: Option<&Bound<'_, PyAny>>,
    pose_offset: Option<&Bound<'_, PyAny>>,
    max_gap_s: f64,
) -> PyResult<Py<PyTelemetry>> {
    let mut options = LogOptions {
        pose_topic: pose_topic.map_or(TopicChoice::Sole, TopicChoice::Named),
        wrench_topic: wrench_topic.map_or(TopicChoice::Sole, TopicChoice::Named),
        force_unit: force_unit_n,
        length_unit: length_unit_m,
        time_unit: time_unit_s,
        rate: rate_hz,
        pose_frame,
        max_gap: max_gap_s,
        force_bias: force_bias_n.map(Vector3::from),
        force_scale,
        payload: payload_mass_kg.map(|mass| Payload {
            mass,
            centre: payload_centre_m.map_or_else(Vector3::zeros, Vector3::from),
        }),
        ..LogOptions::default()
    };
    for (ours, theirs) in columns.into_iter().flatten() {
        options.columns.push((ours.extract()?, theirs.extract()?));
    }
    if let Some(name) = wrench_frame {
        let named = Axes::ALL.into_iter().find(|axes| axes.as_str() == name);
        let known = || Axes::ALL.map(Axes::as_str).join(", ");
        let axes = named.ok_or_else(|| refused("wrench_frame", name, known()))?;
        options.axes = AxesChoice::Given(axes);
    }
    options.sign = match wrench_sign {
        None => None,
        Some("on-tool") => Some(WrenchSign::OnTool),
        Some("by-tool") => Some(WrenchSign::ByTool),
        Some(other) => return Err(refused("wrench_sign", other, "\"on-tool\" or \"by-tool\"")),
    };
    if let Some(name) = orientation {
        let named = OrientationForm::ALL
            .into_iter()
            .find(|form| form.as_str() == name);
        let known = || OrientationForm::ALL.map(OrientationForm::as_str).join(", ");
        options.orientation = Some(named.ok_or_else(|| refused("orientation", name, known()))?);
    }
    check_positive([
        ("rate_hz", rate_hz),
        ("force_unit_n", force_unit_n),
        ("length_unit_m", length_unit_m),
        ("time_unit_s", time_unit_s),
        ("max_gap_s", Some(max_gap_s)),
    ])?;
    let parse_pose = |name, given: Option<&Bound<'_, PyAny>>| -> PyResult<Option<Pose>> {
        given.map(|given| arrays::pose(name, given)).transpose()
    };
    options.world_from_log = parse_pose("world_from_log", world_from_log)?;
    if let Some(pose) = parse_pose("world_from_surface", world_from_surface)? {
        options.world_from_surface = pose;
    }
    if let Some(pose) = parse_pose("pose_offset", pose_offset)? {
        options.logged_from_tool = pose;
    }
    let log = py.detach(|| wisch_telemetry::read(&path, &options));
    let log = log.map_err(|error| {
        let file = Some(path.display().to_string());
        let details = crate::error::Details {
            file,
            ..Default::default()
        };
        crate::error::failed(error, details)
    })?;
    PyTelemetry::of_log(py, &log)
}

/// Checks that a number is above 0, if given.
fn check_positive<const N: usize>(numbers: [(&str, Option<f64>); N]) -> PyResult<()> {
    for (name, number) in numbers {
        if let Some(number) = number
            && !(number.is_finite() && number > 0.0)
        {
            return Err(refused(name, number, "a finite number above 0"));
        }
    }
    Ok(())
}
