//! Checks the data of executors in other processes or languages: samples and the ending.

use super::printable::printable;
use super::status::{PauseRecord, ResumeRecord, WrenchQualityRecord};
use nalgebra::UnitQuaternion;
use serde::Deserialize;
use wisch::geometry::{Point3, Pose, Vector3, restore_pose};
use wisch::run::{
    Ending, Execution, MotionOrder, Pause, RobotState, SampleSink, SampleStatus, Stamp, StampClock,
    StopCause, StopKind, TelemetrySample, TrajectoryClock, Wrench,
};
use wisch::source_location::UnknownName;

/// Tolerance of a quaternion's norm around 1.
const UNIT_TOLERANCE: f64 = 1e-3;
/// Maximum time between the last sample and the end of a motion that is reported complete [s].
const LAST_SAMPLE: f64 = 1.0;
/// Maximum time by which a motion's reported duration may exceed its samples [s].
const UNMEASURED: f64 = 60.0;
/// Advice for a sample whose time is wrong.
const SINCE_BEGIN: &str = "time_s counts from the start of the motion, not from that of a clock";
/// Maximum time by which a motion's reported duration may be below the time of the last sample [s].
const ROUNDED: f64 = 2.0;
/// Reason of a stop that the executor reports, but that was not requested.
const UNREQUESTED: &str = "the executor reports \"stopped\" without a request to stop";
/// Maximum time of a sample before the motion's start [s].
const EARLY: f64 = 1.0;
/// Minimum time between samples [s].
const LEAST_STEP: f64 = 1e-6;
/// Maximum average sampling rate of a motion [Hz]; the first [`BURST`] samples may come faster.
const MAX_RATE: f64 = 10_000.0;
const BURST: f64 = 1_000.0;
/// Limits of plausible measurements: tool position [m], forces and moments [N, Nm], and joint positions, velocities and
/// efforts [rad, m, rad/s, m/s, Nm, N].
const MAX_PLACE: f64 = 1e5;
const MAX_WRENCH: f64 = 1e6;
const MAX_JOINT: f64 = 1e6;
/// Largest stamp [ns]: messages of ROS 2 hold seconds in 32 bits.
const MAX_STAMP_NS: u64 = i32::MAX as u64 * 1_000_000_000;
/// Largest distance of the tool from the motion [m]: poses in other units are farther away.
const MAX_ASTRAY: f64 = 10.0;
/// Largest number of pauses in a motion.
const MAX_PAUSES: usize = 1_000;
/// Longest time of a motion with its pauses [s].
const MAX_TIME: f64 = 1e7;
/// Maximum length of the reason of a protective stop [characters].
const MAX_REASON: usize = 400;

/// A sample of measurements, as an executor reports it. Poses in the world are x, y, z \[m\] and a unit quaternion x, y, z, w.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SampleRecord {
    /// Time since the start of the motion \[s\].
    pub time_s: f64,
    /// Time of the controller's present setpoint on the commanded trajectory \[s\]; `None` if the executor does not report it,
    /// so that it is estimated.
    pub trajectory_time_s: Option<f64>,
    /// Measured pose of the tool; `None` computes it from the positions.
    pub world_from_tool: Option<[f64; 7]>,
    /// Axes of `force_n` and `moment_nm`.
    #[serde(default)]
    pub wrench_axes: WrenchAxes,
    /// Force of the surroundings on the tool \[N\].
    pub force_n: [f64; 3],
    /// Its moment about the tool centre point \[Nm\].
    #[serde(default)]
    pub moment_nm: [f64; 3],
    /// Commanded pose of the tool, including the press into the surface; `None` takes the measured pose.
    pub world_from_commanded: Option<[f64; 7]>,
    /// Force that the controller exerts with the tool, in the axes of the world \[N\].
    #[serde(default)]
    pub controller_force_n: [f64; 3],
    /// Moment that the controller exerts about the tool centre point, in the axes of the world
    /// \[Nm\].
    #[serde(default)]
    pub controller_moment_nm: [f64; 3],
    /// Positions of all n variables of the robot, or empty if not measured [rad or m].
    pub positions: Vec<f64>,
    /// Their velocities, or empty [rad/s or m/s].
    #[serde(default)]
    pub velocities: Vec<f64>,
    /// Their efforts, or empty [Nm or N].
    #[serde(default)]
    pub efforts: Vec<f64>,
    /// Absolute time of the measurement, on the clock that the executor states \[ns\].
    pub stamp_ns: Option<u64>,
    /// Quality of `force_n` and `moment_nm`.
    #[serde(default)]
    pub wrench_quality: WrenchQualityRecord,
    /// Number of the round whose motion the sample is of; `None` if it is not stated.
    pub round: Option<usize>,
}

/// Axes of a measured force and moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WrenchAxes {
    /// Those of the world.
    #[default]
    World,
    /// Those of the tool.
    Tool,
    /// Those of the link that holds the tool.
    Tip,
}

impl SampleRecord {
    /// Checks that the sample is later than the one before, and that its numbers are valid and complete.
    fn check(&self, since: f64, dof: usize) -> Result<(), String> {
        let time = self.time_s;
        if !time.is_finite() {
            return Err(format!(
                "time_s = {time} of the sample after {since} s is not finite"
            ));
        }
        if time <= since {
            return Err(format!(
                "the sample at {time} s follows the sample at {since} s; times must rise"
            ));
        }
        if time - since < LEAST_STEP {
            return Err(format!(
                "the sample at {time} s follows the sample at {since} s by less than {LEAST_STEP:e} s"
            ));
        }
        if time < -EARLY {
            return Err(format!(
                "the sample at {time} s is before the start of the motion at 0 s"
            ));
        }
        if time > MAX_TIME {
            return Err(format!(
                "time_s = {time} of a sample is beyond the limit of {MAX_TIME} s; {SINCE_BEGIN}"
            ));
        }
        let trajectory_time = self.trajectory_time_s.as_ref();
        let told = self.world_from_commanded.as_ref();
        let measured = self.world_from_tool.as_ref();
        if measured.is_none() && self.positions.is_empty() {
            return Err(format!(
                "the sample at {time} s has neither world_from_tool nor positions; expected one of them"
            ));
        }
        for (key, values, most) in [
            (
                "trajectory_time_s",
                trajectory_time.map_or(&[][..], std::slice::from_ref),
                f64::MAX,
            ),
            (
                "world_from_tool",
                measured.map_or(&[][..], |pose| &pose[..]),
                MAX_PLACE,
            ),
            ("force_n", &self.force_n, MAX_WRENCH),
            ("moment_nm", &self.moment_nm, MAX_WRENCH),
            (
                "world_from_commanded",
                told.map_or(&[], |pose| &pose[..]),
                MAX_PLACE,
            ),
            ("controller_force_n", &self.controller_force_n, MAX_WRENCH),
            (
                "controller_moment_nm",
                &self.controller_moment_nm,
                MAX_WRENCH,
            ),
            ("positions", &self.positions, MAX_JOINT),
            ("velocities", &self.velocities, MAX_JOINT),
            ("efforts", &self.efforts, MAX_JOINT),
        ] {
            check(&format!("at {time} s {key}"), values, most)?;
        }
        for (key, values) in [
            ("positions", &self.positions),
            ("velocities", &self.velocities),
            ("efforts", &self.efforts),
        ] {
            let count = values.len();
            if count != dof && count != 0 {
                return Err(format!(
                    "at {time} s {key} has {count} numbers, but the robot has {dof} joints"
                ));
            }
        }
        if let Some(stamp) = self.stamp_ns.filter(|stamp| *stamp > MAX_STAMP_NS) {
            return Err(format!(
                "at {time} s stamp_ns is {stamp}, beyond the limit of {MAX_STAMP_NS}"
            ));
        }
        let poses = [self.world_from_tool, self.world_from_commanded];
        for pose in poses.into_iter().flatten() {
            let norm = pose[3..].iter().map(|x| x * x).sum::<f64>().sqrt();
            if (norm - 1.0).abs() > UNIT_TOLERANCE {
                return Err(format!(
                    "at {time} s a quaternion has norm {norm}; expected 1 within {UNIT_TOLERANCE}"
                ));
            }
        }
        Ok(())
    }
}

/// Checks that all numbers of a quantity are finite and within the limit of plausible measurements.
fn check(key: &str, values: &[f64], most: f64) -> Result<(), String> {
    match values
        .iter()
        .enumerate()
        .find(|(_, x)| x.is_nan() || x.abs() > most)
    {
        Some((i, value)) if value.is_finite() => Err(format!(
            "{key}[{i}] is {value:e}, beyond the limit of {most:e}"
        )),
        Some((i, value)) => Err(format!("{key}[{i}] is {value}, which is not finite")),
        None => Ok(()),
    }
}

/// The result of an execution, as an executor reports it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DoneRecord {
    /// Duration of the execution \[s\].
    pub duration_s: f64,
    /// The ending.
    pub ending: EndingRecord,
    /// Positions of all n variables of the robot at the end, or empty if not measured [rad or m].
    pub positions: Vec<f64>,
    /// Number of the round whose motion has ended; `None` if it is not stated.
    pub round: Option<usize>,
}

/// The joint positions, as an executor reports them.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StateRecord {
    /// Positions of all n variables of the robot, or empty if unknown [rad or m].
    positions: Vec<f64>,
    /// Their velocities, or empty if not measured [rad/s or m/s].
    #[serde(default)]
    velocities: Vec<f64>,
}

impl StateRecord {
    /// Returns the checked state; `None` if neither positions nor velocities are known.
    ///
    /// # Errors
    /// If a number is not finite or beyond the limit of plausible measurements.
    pub fn into_state(self) -> Result<Option<RobotState>, String> {
        check("state: positions", &self.positions, MAX_JOINT)?;
        check("state: velocities", &self.velocities, MAX_JOINT)?;
        let Self {
            positions,
            velocities,
        } = self;
        let is_known = !(positions.is_empty() && velocities.is_empty());
        Ok(is_known.then_some(RobotState {
            positions,
            velocities,
        }))
    }
}

/// The ending of an execution, as an executor reports it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EndingRecord {
    /// The motion is complete.
    Complete,
    /// A stop request ended it.
    Stopped,
    /// The robot stopped itself.
    ProtectiveStop {
        /// Time \[s\].
        time_s: f64,
        /// Cause.
        reason: String,
    },
    /// The robot was stopped, with the kind of the stop; since version 2 of the protocol.
    Stop {
        /// Kind.
        kind: StopKindRecord,
        /// Time \[s\].
        time_s: f64,
        /// Cause.
        reason: String,
    },
}

/// Kind of a stop, as an executor writes it in a line of the protocol.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct StopKindRecord(pub StopKind);

impl TryFrom<String> for StopKindRecord {
    type Error = UnknownName;

    fn try_from(name: String) -> Result<Self, UnknownName> {
        let found = StopKind::ALL.into_iter().find(|kind| kind.as_str() == name);
        found.map(Self).ok_or_else(|| {
            let known = StopKind::ALL.map(StopKind::as_str);
            UnknownName::new("kind of a stop", &name, known)
        })
    }
}

/// A receiver that checks an executor's samples during one motion and passes them on.
pub struct Intake<'a> {
    order: &'a MotionOrder<'a>,
    sink: &'a mut SampleSink<'a>,
    clock: TrajectoryClock,
    dof: usize,
    since: f64,
    count: f64,
    /// Last measured joint positions.
    positions: Vec<f64>,
    is_stopped: bool,
    /// Whether the executor was asked to stop for another reason than an abort.
    is_stop_requested: bool,
    stamp_clock: Option<StampClock>,
    /// Stamp of the last sample that had one [ns].
    last_stamp: u64,
    pauses: Vec<Pause>,
    dropped: usize,
}

impl<'a> Intake<'a> {
    /// Makes a receiver for a motion; it passes samples to `sink`.
    pub fn new(order: &'a MotionOrder<'a>, sink: &'a mut SampleSink<'a>) -> Self {
        Self {
            order,
            sink,
            clock: TrajectoryClock::new(order),
            dof: order.cell.robot().dof(),
            since: f64::NEG_INFINITY,
            count: 0.0,
            positions: Vec::new(),
            is_stopped: false,
            is_stop_requested: false,
            stamp_clock: None,
            last_stamp: 0,
            pauses: Vec::new(),
            dropped: 0,
        }
    }

    /// Sets the clock of the samples' stamps; without it, a stamp is an error.
    #[must_use]
    pub fn with_stamp_clock(self, clock: Option<StampClock>) -> Self {
        Self {
            stamp_clock: clock,
            ..self
        }
    }

    /// The pauses until now, in the order of time.
    pub fn pauses(&self) -> &[Pause] {
        &self.pauses
    }

    /// Whether the motion is paused.
    pub fn is_paused(&self) -> bool {
        self.pauses.last().is_some_and(|pause| pause.end.is_none())
    }

    /// Begins a pause.
    ///
    /// # Errors
    /// If the motion is paused already, the time is before the last sample or pause, or there are too many pauses.
    pub fn pause(&mut self, record: &PauseRecord) -> Result<(), String> {
        let time = record.time_s;
        if self.is_paused() {
            return Err(format!("paused at {time} s, but it is paused already"));
        }
        self.check_pause("paused", time)?;
        if self.pauses.len() >= MAX_PAUSES {
            return Err(format!("more than {MAX_PAUSES} pauses in one motion"));
        }
        let at = self.clock.time_reached();
        let (_, phase) = self.order.motion_at(at).ok_or("the motion is empty")?;
        self.pauses.push(Pause {
            start: time,
            end: None,
            phase,
            reason: printable(&record.reason, MAX_REASON),
        });
        Ok(())
    }

    /// Ends a pause.
    ///
    /// # Errors
    /// If the motion is not paused, or the time is before the start of the pause or the last sample.
    pub fn resume(&mut self, record: ResumeRecord) -> Result<(), String> {
        let time = record.time_s;
        self.check_pause("resumed", time)?;
        match self.pauses.last_mut() {
            Some(pause) if pause.end.is_none() => pause.end = Some(time),
            _ => return Err(format!("resumed at {time} s, but it is not paused")),
        }
        Ok(())
    }

    fn check_pause(&self, what: &str, time: f64) -> Result<(), String> {
        let least = self.time_reported().max(0.0);
        if (least..=MAX_TIME).contains(&time) {
            return Ok(());
        }
        Err(format!(
            "{what} at {time} s; expected {least} to {MAX_TIME} s"
        ))
    }

    /// Time that the motion has run until the last sample, without its pauses \[s\].
    fn time_run(&self) -> f64 {
        let paused = |pause: &Pause| {
            let end = pause.end.map_or(self.since, |end| end.min(self.since));
            (end - pause.start).max(0.0)
        };
        self.since - self.pauses.iter().map(paused).sum::<f64>()
    }

    /// Time of the last sample or pause \[s\].
    pub(super) fn time_reported(&self) -> f64 {
        let last = self.pauses.last();
        let pause = last.map_or(f64::NEG_INFINITY, |pause| pause.end.unwrap_or(pause.start));
        self.since.max(pause)
    }

    /// Notes the number of samples that were dropped before this receiver.
    pub(super) const fn note_dropped(&mut self, count: usize) {
        self.dropped = count;
    }

    /// Notes that the executor was asked to stop, so that an ending "stopped" is its answer.
    pub(super) const fn note_stop_request(&mut self) {
        self.is_stop_requested = true;
    }

    /// Whether the motion is to be aborted.
    pub const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// Time of the last sample \[s\]; minus infinity before the first sample.
    pub const fn time(&self) -> f64 {
        self.since
    }

    /// Progress of the robot on its trajectory \[s\].
    pub const fn trajectory_time(&self) -> f64 {
        self.clock.time_reached()
    }

    /// Duration of the motion's trajectory \[s\].
    pub fn end(&self) -> f64 {
        self.order.followed.duration()
    }

    /// Receives one sample. Samples after an abort are checked but not passed on.
    ///
    /// The motion and phase of the sample are those of its trajectory time: a robot may run slower than planned.
    ///
    /// # Errors
    /// If the time does not rise, the first sample is long after the motion's begin, the rate of samples is above the
    /// limit, a number is not finite or implausible, an array does not have one number per joint, or a quaternion is not
    /// of unit length. The error states time, value and limit.
    pub fn take(&mut self, sample: &SampleRecord) -> Result<(), String> {
        sample.check(self.since, self.dof)?;
        self.check_round(&format!("the sample at {} s", sample.time_s), sample.round)?;
        self.since = sample.time_s;
        self.check_begin()?;
        self.count += 1.0;
        if self.count > BURST + MAX_RATE * (EARLY + self.since) {
            return Err(format!(
                "{} samples until {} s exceed the limit of {MAX_RATE} samples per second",
                self.count, self.since
            ));
        }
        let world_from_tool = match &sample.world_from_tool {
            Some(measured) => restore_pose(measured),
            None => self.compute_tool_pose(&sample.positions)?,
        };
        let world_from_axes = match sample.wrench_axes {
            WrenchAxes::World => UnitQuaternion::identity(),
            WrenchAxes::Tool => world_from_tool.rotation,
            WrenchAxes::Tip => {
                world_from_tool.rotation * self.order.cell.tip_from_tool().rotation.inverse()
            }
        };
        let measured = wrench(sample.force_n, sample.moment_nm);
        let (reported, positions) = (sample.trajectory_time_s, &sample.positions);
        let time_run = self.time_run();
        let at = (self.clock)
            .advance(time_run, reported, positions, &world_from_tool)
            .map_err(|error| format!("at {} s: {error}", self.since))?;
        self.check_place(at, &world_from_tool)?;
        if !sample.positions.is_empty() {
            self.positions.clone_from(&sample.positions);
        }
        if self.is_stopped {
            return Ok(());
        }
        let Some((motion, phase)) = self.order.motion_at(at) else {
            return Ok(());
        };
        let stamp = match (sample.stamp_ns, self.stamp_clock) {
            (Some(nanoseconds), Some(_)) if nanoseconds < self.last_stamp => {
                return Err(format!(
                    "at {} s stamp_ns is {nanoseconds}, less than {} of an earlier sample",
                    self.since, self.last_stamp
                ));
            }
            (Some(nanoseconds), Some(clock)) => {
                self.last_stamp = nanoseconds;
                Some(Stamp { nanoseconds, clock })
            }
            (Some(_), None) => {
                let time = self.since;
                return Err(format!(
                    "at {time} s there is a stamp_ns, but stamp_clock does not state its clock"
                ));
            }
            (None, _) => None,
        };
        let status = SampleStatus {
            stamp,
            wrench: sample.wrench_quality.0,
            is_paused: self.is_paused(),
        };
        let flow = (self.sink)(&TelemetrySample {
            time: self.since,
            positions: &sample.positions,
            velocities: &sample.velocities,
            efforts: &sample.efforts,
            world_from_commanded: (sample.world_from_commanded.as_ref())
                .map_or(world_from_tool, restore_pose),
            world_from_tool,
            controller: wrench(sample.controller_force_n, sample.controller_moment_nm),
            external: Wrench {
                force: world_from_axes * measured.force,
                moment: world_from_axes * measured.moment,
            },
            motion,
            phase,
            status,
        });
        self.is_stopped = flow.is_break();
        Ok(())
    }

    /// Checks that the first sample is soon after the start of the motion: a time of another clock is later.
    fn check_begin(&self) -> Result<(), String> {
        let most = UNMEASURED.max(self.order.followed.duration());
        if self.count > 0.0 || self.time_run() <= most {
            return Ok(());
        }
        Err(format!(
            "the first sample is at {} s, without pauses more than {most:.0} s after the start of the motion; {SINCE_BEGIN}",
            self.since
        ))
    }

    /// Checks that a message is of this motion, if it states its round.
    fn check_round(&self, what: &str, round: Option<usize>) -> Result<(), String> {
        match round {
            Some(round) if round != self.order.round => Err(format!(
                "{what} is of round {round}; expected round {}",
                self.order.round
            )),
            _ => Ok(()),
        }
    }

    /// Checks that the tool is within [`MAX_ASTRAY`] of its planned position. `time`: trajectory
    /// time [s].
    fn check_place(&self, time: f64, world_from_tool: &Pose) -> Result<(), String> {
        let tool = Point3::from(world_from_tool.translation.vector);
        let planned = self.clock.tool_position(time);
        let distance = planned.map_or(0.0, |planned| (tool - planned).norm());
        if distance <= MAX_ASTRAY {
            return Ok(());
        }
        Err(format!(
            "at {} s the tool is {distance:.1} m from the motion, beyond the limit of {MAX_ASTRAY} m; expected metres, and radians",
            self.since
        ))
    }

    /// Computes the tool's pose from the positions of the joints.
    fn compute_tool_pose(&self, positions: &[f64]) -> Result<Pose, String> {
        let cell = self.order.cell;
        let kinematics = (cell.robot().forward_kinematics(positions))
            .map_err(|error| format!("at {} s positions: {error}", self.since))?;
        Ok(cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool())
    }

    /// Returns the checked execution. Missing positions at the end are taken from the last sample with positions. A
    /// stop that was not requested is a protective stop.
    ///
    /// # Errors
    /// If a number is not finite or implausible, times contradict the samples, or a motion is reported complete without
    /// samples up to its end.
    pub fn done(&self, done: DoneRecord) -> Result<Execution, String> {
        check("at the end positions", &done.positions, MAX_JOINT)?;
        self.check_round("\"done\"", done.round)?;
        let end = self.end();
        let is_complete = done.ending == EndingRecord::Complete && !self.is_stopped;
        if is_complete && self.time_run() < end - LAST_SAMPLE {
            let last = if self.since.is_finite() {
                let paused = self.since - self.time_run();
                let without = format!(", {paused:.3} s of which it was paused");
                let without = if paused > 0.0 { without } else { String::new() };
                format!("the last sample is at {} s{without}", self.since)
            } else {
                "there is no sample".to_owned()
            };
            return Err(format!(
                "the motion of {end:.3} s is reported complete, but {last}"
            ));
        }
        let most = if self.is_paused() {
            MAX_TIME
        } else if is_complete {
            self.since + LAST_SAMPLE
        } else {
            self.time_reported().max(end) + UNMEASURED
        };
        let duration = done.duration_s;
        let stopped_at = match &done.ending {
            EndingRecord::ProtectiveStop { time_s, .. } => {
                Some(("protective_stop.time_s", *time_s))
            }
            EndingRecord::Stop { time_s, .. } => Some(("stop.time_s", *time_s)),
            EndingRecord::Complete | EndingRecord::Stopped => None,
        };
        for (key, time) in [Some(("duration_s", duration)), stopped_at]
            .into_iter()
            .flatten()
        {
            if !(0.0..=most).contains(&time) {
                return Err(format!(
                    "at the end {key} is {time:e} s; expected 0 to {most:.3} s"
                ));
            }
        }
        if duration < self.since - ROUNDED {
            return Err(format!(
                "at the end duration_s is {duration} s, but the last sample is at {} s; expected a duration that includes all samples, within {ROUNDED} s",
                self.since
            ));
        }
        let positions = if !done.positions.is_empty() {
            done.positions
        } else if is_complete && self.positions.is_empty() {
            let last = self.order.followed.sample(end);
            last.map(|sample| sample.q).unwrap_or_default()
        } else {
            self.positions.clone()
        };
        let ending = match done.ending {
            EndingRecord::Stopped if !(self.is_stopped || self.is_stop_requested) => {
                stop(StopKind::ProtectiveStop, duration, UNREQUESTED)
            }
            ending => ending.into(),
        };
        Ok(Execution {
            duration: duration.max(self.since),
            ending,
            positions,
            pauses: self.pauses.clone(),
            dropped_samples: self.dropped,
        })
    }
}

impl From<EndingRecord> for Ending {
    fn from(ending: EndingRecord) -> Self {
        match ending {
            EndingRecord::Complete => Self::Complete,
            EndingRecord::Stopped => Self::Stopped,
            EndingRecord::ProtectiveStop { time_s, reason } => {
                stop(StopKind::ProtectiveStop, time_s, &reason)
            }
            EndingRecord::Stop {
                kind,
                time_s,
                reason,
            } => stop(kind.0, time_s, &reason),
        }
    }
}

fn stop(kind: StopKind, time: f64, reason: &str) -> Ending {
    let reason = printable(reason, MAX_REASON);
    Ending::ProtectiveStop {
        time,
        cause: StopCause::Reported { kind, reason },
    }
}

fn wrench(force: [f64; 3], moment: [f64; 3]) -> Wrench {
    Wrench {
        force: Vector3::from(force),
        moment: Vector3::from(moment),
    }
}
