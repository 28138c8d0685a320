//! Executors that are Python objects, and the samples that they pass.

use crate::arrays::{kind_of, list, rows};
use crate::error::{plain, refused};
use crate::motion::PyMotion;
use crate::watchdog::Watchdog;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use scoped_tls_hkt::scoped_thread_local;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use wisch::follow::Workcell;
use wisch::represent::{Observation, Surface, Task};
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, RobotState, SampleSink, StampClock,
};
use wisch::source_location::UnknownName;
use wisch_io::{
    DoneRecord, DriverRobotRecord, EndingRecord, Intake, MAX_SILENCE_S, ObservationRecord,
    PauseRecord, ResumeRecord, Robot, SampleRecord, StampClockRecord, StopKindRecord, WrenchAxes,
    WrenchQualityRecord,
};

scoped_thread_local!(
    /// Receiver of the samples of the motion that this thread executes.
    static mut TAKING: for<'a> &'a mut (dyn Taking + 'a)
);

/// Receiver of samples.
trait Taking {
    /// Number of its motion.
    fn number(&self) -> u64;

    /// Receives a sample. Returns whether the motion continues.
    fn take(&mut self, sample: SampleRecord) -> Result<bool, String>;

    /// Receives the start of a pause.
    fn pause(&mut self, pause: &PauseRecord) -> Result<(), String>;

    /// Receives the end of a pause.
    fn resume(&mut self, resumed: ResumeRecord) -> Result<(), String>;
}

/// An executor in Python: any object with `execute(motion, sink)`; optionally with `state()`, `prepare(robot)` and `finish()`,
/// and with a camera, `observe()`.
pub struct PyExecutor<'py> {
    pub object: Bound<'py, PyAny>,
    /// Longest wait for a sample or an observation.
    pub timeout: Option<Duration>,
    /// Exception that it raised.
    pub raised: Option<PyErr>,
    /// The robot and the tool's name, which `prepare` describes.
    pub robot: Option<(Arc<Robot>, String)>,
    /// What is prepared and has to finish; the session keeps this between calls.
    pub prepared: PreparedExecutor,
}

/// The executor that is prepared for motions, with its timeout.
pub type PreparedExecutor = Arc<Mutex<Option<(Py<PyAny>, Option<Duration>)>>>;

/// Calls `finish()` of the prepared executor, once, if there is one.
pub fn finish_prepared(py: Python<'_>, prepared: &PreparedExecutor) -> PyResult<()> {
    let taken = prepared
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .take();
    let Some((object, timeout)) = taken else {
        return Ok(());
    };
    let Ok(finish) = object.bind(py).getattr("finish") else {
        return Ok(());
    };
    let watchdog = Watchdog::begin(py, timeout)?;
    let returned = finish.call0();
    match watchdog {
        Some(watchdog) => watchdog.end(py, returned, "did not return from finish()"),
        None => returned,
    }?;
    Ok(())
}

/// Samples of one motion.
struct Round<'a> {
    number: u64,
    intake: Intake<'a>,
    last: Option<SampleRecord>,
    fault: Option<String>,
    watchdog: Option<&'a Watchdog>,
}

impl Taking for Round<'_> {
    fn number(&self) -> u64 {
        self.number
    }

    fn take(&mut self, sample: SampleRecord) -> Result<bool, String> {
        if let Some(fault) = &self.fault {
            return Err(fault.clone());
        }
        if let Err(fault) = self.intake.take(&sample) {
            self.fault = Some(fault.clone());
            return Err(fault);
        }
        if let Some(watchdog) = self.watchdog.filter(|_| !self.intake.is_paused()) {
            watchdog.touch();
        }
        self.last = Some(sample);
        Ok(!self.intake.is_stopped())
    }

    fn pause(&mut self, pause: &PauseRecord) -> Result<(), String> {
        self.intake.pause(pause)?;
        if let Some(watchdog) = self.watchdog {
            watchdog.suspend();
        }
        Ok(())
    }

    fn resume(&mut self, resumed: ResumeRecord) -> Result<(), String> {
        self.intake.resume(resumed)?;
        if let Some(watchdog) = self.watchdog {
            watchdog.touch();
        }
        Ok(())
    }
}

impl PyExecutor<'_> {
    fn raise<T>(&mut self, error: PyErr) -> Result<T, ExecutorError> {
        let message = ExecutorError::new(&error);
        self.raised = Some(error);
        Err(message)
    }

    /// Calls `prepare(robot)`, if there is one.
    fn call_prepare(&self, cell: &Workcell) -> PyResult<()> {
        let Ok(prepare) = self.object.getattr("prepare") else {
            return Ok(());
        };
        let py = self.object.py();
        let robot = match &self.robot {
            Some((robot, tool)) => {
                let record = DriverRobotRecord::new(robot, cell, tool);
                let text = serde_json::to_string(&record).map_err(plain)?;
                let described = py.import("json")?.call_method1("loads", (text,))?;
                let module = py.import("wisch.executor")?;
                Some(module.call_method1("_Robot", (described,))?)
            }
            None => None,
        };
        let watchdog = Watchdog::begin(py, self.timeout)?;
        let returned = prepare.call1((robot,));
        match watchdog {
            Some(watchdog) => watchdog.end(py, returned, "did not return from prepare()"),
            None => returned,
        }?;
        Ok(())
    }

    /// Returns its observation, if it arrives in time; `None` without a camera.
    pub fn call_observe(&self) -> PyResult<Option<Observation>> {
        let py = self.object.py();
        let watchdog = Watchdog::begin(py, self.timeout)?;
        let observation = observe(&self.object);
        match watchdog {
            Some(watchdog) => watchdog.end(py, observation, "returned no observation"),
            None => observation,
        }
    }
}

impl Executor for PyExecutor<'_> {
    fn prepare(&mut self, cell: &Workcell) -> Result<(), ExecutorError> {
        if let Err(error) = max_silence(&self.object).and_then(|_| self.call_prepare(cell)) {
            return self.raise(error);
        }
        let object = self.object.clone().unbind();
        let mut prepared = self.prepared.lock().unwrap_or_else(PoisonError::into_inner);
        *prepared = Some((object, self.timeout));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), ExecutorError> {
        // The session's own error is raised; this one is a warning.
        finish_prepared(self.object.py(), &self.prepared).map_err(ExecutorError::new)
    }

    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        static MOTIONS: AtomicU64 = AtomicU64::new(1);
        let py = self.object.py();
        if let Err(error) = check_shape(&self.object, &order.task.surface) {
            return self.raise(error);
        }
        let number = MOTIONS.fetch_add(1, Ordering::Relaxed);
        let motion = match Py::new(py, PyMotion::from_order(order)) {
            Ok(motion) => motion,
            Err(error) => return self.raise(error),
        };
        let silence = match max_silence(&self.object) {
            Ok(silence) => silence,
            Err(error) => return self.raise(error),
        };
        let limit = self.timeout.into_iter().chain(silence).min();
        let watchdog = match Watchdog::begin(py, limit) {
            Ok(watchdog) => watchdog,
            Err(error) => return self.raise(error),
        };
        let clock = match stamp_clock(&self.object) {
            Ok(clock) => clock,
            Err(error) => return self.raise(error),
        };
        let mut round = Round {
            number,
            intake: Intake::new(order, sink).with_stamp_clock(clock),
            last: None,
            fault: None,
            watchdog: watchdog.as_ref(),
        };
        let taker = PySink {
            number,
            joints: motion
                .get()
                .joints()
                .into_iter()
                .map(str::to_owned)
                .collect(),
        };
        let returned = TAKING.set(&mut round, || {
            self.object.call_method1("execute", (motion, taker))
        });
        let returned = match &watchdog {
            Some(watchdog) => watchdog.end(py, returned, "passed no sample"),
            None => returned,
        };
        let since = round.intake.time();
        let result = returned.and_then(|returned| match &round.fault {
            // An executor may have caught its sink's exception.
            Some(fault) => Err(plain(fault)),
            None => round.done(&returned),
        });
        result.or_else(|error| {
            if error.is_instance_of::<PyKeyboardInterrupt>(py) && since.is_finite() {
                // The samples until then are still interpreted.
                let execution = round.stopped();
                self.raised = Some(error);
                return Ok(execution);
            }
            let at = if since.is_finite() {
                format!("after the sample of {since} s")
            } else {
                "before its first sample".to_owned()
            };
            let note = format!("in round {}, {at}", order.round);
            let _ = error.value(py).call_method1("add_note", (note,));
            let pauses = round.intake.pauses().to_vec();
            self.raise(error)
                .map_err(|error| error.with_execution(pauses, 0))
        })
    }

    fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
        robot_state(&self.object).or_else(|error| self.raise(error))
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        check_shape(&self.object, &task.surface).or_else(|error| self.raise(error))?;
        self.call_observe().or_else(|error| self.raise(error))
    }
}

/// Returns the clock of an executor's stamps, if it states one.
fn stamp_clock(object: &Bound<'_, PyAny>) -> PyResult<Option<StampClock>> {
    let Some(stated) = object.getattr_opt("stamp_clock")? else {
        return Ok(None);
    };
    let name: Option<String> = stated.extract()?;
    let record = name.map(StampClockRecord::try_from).transpose();
    Ok(record.map_err(plain)?.map(|record| record.0))
}

/// Returns the longest silence of an executor in a motion, if it states one.
fn max_silence(object: &Bound<'_, PyAny>) -> PyResult<Option<Duration>> {
    let stated = object.getattr_opt("max_silence_s")?;
    let Some(stated) = stated.filter(|stated| !stated.is_none()) else {
        return Ok(None);
    };
    let [least, most] = MAX_SILENCE_S;
    match stated.extract::<f64>() {
        Ok(seconds) if (least..=most).contains(&seconds) => {
            Ok(Some(Duration::from_secs_f64(seconds)))
        }
        _ => {
            let wanted = format!("a time of {least} to {most} s");
            Err(refused("max_silence_s", stated.str()?, wanted))
        }
    }
}

/// Refuses a curved surface for an executor that does not state that it knows them: it would press along one normal.
fn check_shape(object: &Bound<'_, PyAny>, surface: &Surface) -> PyResult<()> {
    let knows = || {
        object
            .getattr("accepts_curved")
            .and_then(|stated| stated.is_truthy())
    };
    let name = &surface.name;
    if surface.shape.is_plane() || knows().unwrap_or(false) {
        return Ok(());
    }
    Err(plain(format!(
        "surface {name:?} is curved, so that its normal differs from place to place; an executor that reads motion.surface_shape states accepts_curved = True"
    )))
}

/// Returns an executor's state: positions, or a dict with velocities too; `None` if it is unknown.
fn robot_state(object: &Bound<'_, PyAny>) -> PyResult<Option<RobotState>> {
    let Ok(state) = object.getattr("state") else {
        return Ok(None);
    };
    let returned = state.call0()?;
    if returned.is_none() {
        return Ok(None);
    }
    let Ok(by_key) = returned.cast::<PyMapping>() else {
        return Ok(Some(list("state()", &returned)?.into()));
    };
    let mut state = RobotState::default();
    for key in by_key.keys()?.iter() {
        let value = by_key.get_item(&key)?;
        match key.extract::<String>()?.as_str() {
            "positions" => state.positions = list("positions", &value)?,
            "velocities" => state.velocities = list("velocities", &value)?,
            other => return Err(unknown(other, ["positions", "velocities"])),
        }
    }
    Ok(Some(state))
}

/// Returns an executor's observation; `None` without a camera.
fn observe(object: &Bound<'_, PyAny>) -> PyResult<Option<Observation>> {
    let Ok(method) = object.getattr("observe") else {
        return Ok(None);
    };
    let observation = method.call0()?;
    if observation.is_none() {
        return Ok(None);
    }
    let mut record = ObservationRecord::default();
    match observation.cast::<PyMapping>() {
        Err(_) => record.detections = rows("observe()", &observation)?,
        Ok(observation) => {
            for key in observation.keys()?.iter() {
                let value = observation.get_item(&key)?;
                match key.extract::<String>()?.as_str() {
                    "detections" => record.detections = rows("detections", &value)?,
                    "hidden" => {
                        for ring in value.try_iter()? {
                            record.hidden.push(rows("hidden", &ring?)?);
                        }
                    }
                    other => return Err(unknown(other, ["detections", "hidden"])),
                }
            }
        }
    }
    record.into_observation().map(Some).map_err(plain)
}

fn unknown<'a>(key: &str, known: impl IntoIterator<Item = &'a str>) -> PyErr {
    plain(UnknownName::new("key", key, known))
}

impl Round<'_> {
    /// Returns an execution that was stopped at the last sample.
    fn stopped(&self) -> Execution {
        let last = self.last.as_ref();
        Execution {
            duration: last.map_or(0.0, |last| last.time_s),
            ending: Ending::Stopped,
            pauses: self.intake.pauses().to_vec(),
            // Empty if they are not measured.
            ..Execution::from_positions(last.map_or(&[], |last| &last.positions))
        }
    }

    /// Parses the ending of an execution from the return value of `execute`: None, or a dict like the protocol's
    /// `done`.
    fn done(&self, returned: &Bound<'_, PyAny>) -> PyResult<Execution> {
        let Execution {
            duration,
            positions,
            ..
        } = self.stopped();
        let mut done = DoneRecord {
            round: None,
            duration_s: duration,
            ending: if self.intake.is_stopped() {
                EndingRecord::Stopped
            } else {
                EndingRecord::Complete
            },
            positions,
        };
        if !returned.is_none() {
            let entries = returned.cast::<PyMapping>().map_err(|_| {
                let wanted = "nothing, or a dict with ending, duration_s, positions";
                refused("execute() returned", kind_of(returned), wanted)
            })?;
            for key in entries.keys()?.iter() {
                let value = entries.get_item(&key)?;
                match key.extract::<String>()?.as_str() {
                    "duration_s" => done.duration_s = value.extract()?,
                    "ending" => done.ending = ending(&value)?,
                    "positions" => done.positions = list("positions", &value)?,
                    other => {
                        return Err(unknown(other, ["duration_s", "ending", "positions"]));
                    }
                }
            }
        }
        self.intake.done(done).map_err(plain)
    }
}

fn ending(given: &Bound<'_, PyAny>) -> PyResult<EndingRecord> {
    if let Ok(word) = given.extract::<String>() {
        return match word.as_str() {
            "complete" => Ok(EndingRecord::Complete),
            "stopped" => Ok(EndingRecord::Stopped),
            other => Err(plain(UnknownName::new(
                "ending",
                other,
                ["complete", "stopped", "protective_stop", "stop"],
            ))),
        };
    }
    if let Ok(stop) = given.get_item("stop") {
        let kind: String = stop.get_item("kind")?.extract()?;
        return Ok(EndingRecord::Stop {
            kind: StopKindRecord::try_from(kind).map_err(plain)?,
            time_s: stop.get_item("time_s")?.extract()?,
            reason: stop.get_item("reason")?.extract()?,
        });
    }
    let stop = given.get_item("protective_stop")?;
    Ok(EndingRecord::ProtectiveStop {
        time_s: stop.get_item("time_s")?.extract()?,
        reason: stop.get_item("reason")?.extract()?,
    })
}

/// Receives samples during the execution of a motion; returns `False` if the motion must stop.
#[pyclass(name = "Sink", module = "wisch", frozen)]
pub struct PySink {
    number: u64,
    joints: Vec<String>,
}

const KEYS: [&str; 14] = [
    "time_s",
    "trajectory_time_s",
    "world_from_tool",
    "wrench_axes",
    "force_n",
    "moment_nm",
    "world_from_commanded",
    "controller_force_n",
    "controller_moment_nm",
    "positions",
    "velocities",
    "efforts",
    "stamp_ns",
    "wrench_quality",
];

/// Parses the axes of a force and moment.
fn wrench_axes(value: &Bound<'_, PyAny>) -> PyResult<WrenchAxes> {
    match value.extract::<String>()?.as_str() {
        "world" => Ok(WrenchAxes::World),
        "tool" => Ok(WrenchAxes::Tool),
        "tip" => Ok(WrenchAxes::Tip),
        other => Err(plain(UnknownName::new(
            "axes",
            other,
            ["world", "tool", "tip"],
        ))),
    }
}

/// Parses the quality of a force and moment.
fn wrench_quality(value: &Bound<'_, PyAny>) -> PyResult<WrenchQualityRecord> {
    WrenchQualityRecord::try_from(value.extract::<String>()?).map_err(plain)
}

/// Parses a quantity of `N` numbers in a sample.
fn array<const N: usize>(key: &str, value: &Bound<'_, PyAny>, time: f64) -> PyResult<[f64; N]> {
    let numbers = list(key, value)?;
    let count = numbers.len();
    (numbers.try_into())
        .map_err(|_| plain(format!("at {time} s {key} has {count} numbers, not {N}")))
}

impl PySink {
    fn pass(&self, sample: SampleRecord) -> PyResult<bool> {
        self.with_taking(|taking| taking.take(sample))
    }

    /// Calls the receiver of the motion that this thread executes.
    fn with_taking<T>(
        &self,
        call: impl FnOnce(&mut dyn Taking) -> Result<T, String>,
    ) -> PyResult<T> {
        let refuse = || {
            plain(
                "the sink belongs to a motion that has ended or to another thread, and takes no samples",
            )
        };
        if !TAKING.is_set() {
            return Err(refuse());
        }
        TAKING.with(|taking| {
            if taking.number() != self.number {
                return Err(refuse());
            }
            call(taking).map_err(plain)
        })
    }

    /// Parses numbers of joints: in their order, or by their names.
    fn joints(&self, key: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let Ok(by_name) = value.cast::<PyMapping>() else {
            return list(key, value);
        };
        let mut numbers = vec![f64::NAN; self.joints.len()];
        for name in by_name.keys()?.iter() {
            let given: String = name.extract()?;
            let at = self.joints.iter().position(|joint| *joint == given);
            let at = at.ok_or_else(|| {
                let known = self.joints.iter().map(String::as_str);
                plain(format!(
                    "{key}: {}",
                    UnknownName::new("joint", &given, known)
                ))
            })?;
            numbers[at] = by_name.get_item(&name)?.extract()?;
        }
        match self.joints.iter().zip(&numbers).find(|(_, x)| x.is_nan()) {
            Some((joint, _)) if by_name.len()? < numbers.len() => {
                Err(plain(format!("{key}: joint {joint:?} is missing")))
            }
            _ => Ok(numbers),
        }
    }

    fn record(&self, sample: &Bound<'_, PyDict>) -> PyResult<SampleRecord> {
        let mut record = SampleRecord::default();
        let time = sample.get_item("time_s")?;
        let time = time.ok_or_else(|| plain("a sample: key \"time_s\" is missing"))?;
        let time: f64 =
            (time.extract()).map_err(|_| refused("time_s", kind_of(&time), "a number"))?;
        record.time_s = time;
        let mut has_force = false;
        for (key, value) in sample {
            let key = key.extract::<std::borrow::Cow<'_, str>>()?;
            has_force |= key == "force_n";
            match key.as_ref() {
                "time_s" => {}
                "trajectory_time_s" => record.trajectory_time_s = value.extract()?,
                "world_from_tool" => record.world_from_tool = Some(array(&key, &value, time)?),
                "wrench_axes" => record.wrench_axes = wrench_axes(&value)?,
                "force_n" => record.force_n = array(&key, &value, time)?,
                "moment_nm" => record.moment_nm = array(&key, &value, time)?,
                "world_from_commanded" => {
                    record.world_from_commanded = Some(array(&key, &value, time)?);
                }
                "controller_force_n" => record.controller_force_n = array(&key, &value, time)?,
                "controller_moment_nm" => record.controller_moment_nm = array(&key, &value, time)?,
                "positions" => record.positions = self.joints(&key, &value)?,
                "velocities" => record.velocities = self.joints(&key, &value)?,
                "efforts" => record.efforts = self.joints(&key, &value)?,
                "stamp_ns" => record.stamp_ns = Some(value.extract()?),
                "wrench_quality" => record.wrench_quality = wrench_quality(&value)?,
                other => return Err(unknown(other, KEYS)),
            }
        }
        if has_force {
            Ok(record)
        } else {
            Err(plain(format!("at {time} s key \"force_n\" is missing")))
        }
    }
}

#[pymethods]
impl PySink {
    /// Passes a sample: a dict with the keys of the executor protocol's `sample`, or these keys as arguments.
    #[pyo3(signature = (sample = None, /, **keys))]
    fn __call__(
        &self,
        sample: Option<&Bound<'_, PyDict>>,
        keys: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<bool> {
        let given = sample
            .or(keys)
            .ok_or_else(|| plain("a sample: key \"time_s\" is missing"))?;
        self.pass(self.record(given)?)
    }

    /// Whether the operator wants the motion to pause; never in a session of this package.
    #[getter]
    fn wants_pause(&self) -> bool {
        false
    }

    /// Tells that the motion is paused since a time [s].
    #[pyo3(signature = (time_s, reason = String::new()))]
    fn pause(&self, time_s: f64, reason: String) -> PyResult<()> {
        let pause = PauseRecord { time_s, reason };
        self.with_taking(|taking| taking.pause(&pause))
    }

    /// Tells that the motion continues since a time [s].
    fn resume(&self, time_s: f64) -> PyResult<()> {
        self.with_taking(|taking| taking.resume(ResumeRecord { time_s }))
    }

    /// Passes many samples: the same keys, each an array with a row per sample. Ends after the sample at which the
    /// motion must stop.
    #[pyo3(signature = (samples = None, /, **keys))]
    fn many(
        &self,
        samples: Option<&Bound<'_, PyDict>>,
        keys: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<bool> {
        let given = samples
            .or(keys)
            .ok_or_else(|| plain("samples: key \"time_s\" is missing"))?;
        let time = given.get_item("time_s")?;
        let time = time.ok_or_else(|| plain("samples: key \"time_s\" is missing"))?;
        let times = list("time_s", &time)?;
        let mut samples: Vec<SampleRecord> = (times.iter())
            .map(|&time_s| SampleRecord {
                time_s,
                ..SampleRecord::default()
            })
            .collect();
        if !given.contains("force_n")? {
            return Err(plain("samples: key \"force_n\" is missing"));
        }
        for (key, value) in given {
            let key = key.extract::<std::borrow::Cow<'_, str>>()?;
            match key.as_ref() {
                "time_s" => {}
                "trajectory_time_s" => {
                    let times = list(&key, &value)?;
                    check_count(&key, times.len(), samples.len())?;
                    for (sample, time) in samples.iter_mut().zip(times) {
                        sample.trajectory_time_s = Some(time);
                    }
                }
                "world_from_tool" => fill(&mut samples, &key, &value, |s| {
                    s.world_from_tool.insert([0.0; 7])
                })?,
                "wrench_axes" => {
                    let axes = wrench_axes(&value)?;
                    samples
                        .iter_mut()
                        .for_each(|sample| sample.wrench_axes = axes);
                }
                "force_n" => fill(&mut samples, &key, &value, |s| &mut s.force_n)?,
                "moment_nm" => fill(&mut samples, &key, &value, |s| &mut s.moment_nm)?,
                "world_from_commanded" => fill(&mut samples, &key, &value, |s| {
                    s.world_from_commanded.insert([0.0; 7])
                })?,
                "controller_force_n" => {
                    fill(&mut samples, &key, &value, |s| &mut s.controller_force_n)?;
                }
                "controller_moment_nm" => {
                    fill(&mut samples, &key, &value, |s| &mut s.controller_moment_nm)?;
                }
                "positions" => spread(&mut samples, &key, &value, |s| &mut s.positions)?,
                "velocities" => spread(&mut samples, &key, &value, |s| &mut s.velocities)?,
                "efforts" => spread(&mut samples, &key, &value, |s| &mut s.efforts)?,
                "stamp_ns" => each(&mut samples, &key, &value, |sample, stamp| {
                    sample.stamp_ns = Some(stamp.extract()?);
                    Ok(())
                })?,
                "wrench_quality" => each(&mut samples, &key, &value, |sample, quality| {
                    sample.wrench_quality = wrench_quality(quality)?;
                    Ok(())
                })?,
                other => return Err(unknown(other, KEYS)),
            }
        }
        for sample in samples {
            if !self.pass(sample)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Sets a quantity of each sample by its entry of a sequence.
fn each(
    samples: &mut [SampleRecord],
    key: &str,
    value: &Bound<'_, PyAny>,
    set: impl Fn(&mut SampleRecord, &Bound<'_, PyAny>) -> PyResult<()>,
) -> PyResult<()> {
    check_count(key, value.len()?, samples.len())?;
    for (sample, entry) in samples.iter_mut().zip(value.try_iter()?) {
        set(sample, &entry?)?;
    }
    Ok(())
}

fn fill<const N: usize>(
    samples: &mut [SampleRecord],
    key: &str,
    value: &Bound<'_, PyAny>,
    field: impl Fn(&mut SampleRecord) -> &mut [f64; N],
) -> PyResult<()> {
    let rows = rows::<N>(key, value)?;
    check_count(key, rows.len(), samples.len())?;
    for (sample, row) in samples.iter_mut().zip(rows) {
        *field(sample) = row;
    }
    Ok(())
}

fn spread(
    samples: &mut [SampleRecord],
    key: &str,
    value: &Bound<'_, PyAny>,
    field: impl Fn(&mut SampleRecord) -> &mut Vec<f64>,
) -> PyResult<()> {
    let array: numpy::PyArrayLike2<'_, f64, numpy::AllowTypeChange> = (value.extract())
        .map_err(|_| refused(key, kind_of(value), "an array of shape (samples, joints)"))?;
    let array = array.as_array();
    check_count(key, array.nrows(), samples.len())?;
    for (sample, row) in samples.iter_mut().zip(array.rows()) {
        *field(sample) = row.to_vec();
    }
    Ok(())
}

fn check_count(key: &str, found: usize, wanted: usize) -> PyResult<()> {
    if found == wanted {
        return Ok(());
    }
    Err(plain(format!(
        "{key} has {found} rows, time_s has {wanted} numbers"
    )))
}
