//! What an executor hands over that is not written in Rust: samples, observations and how it ended, checked.

use super::printable::printable;
use serde::Deserialize;
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector3};
use wisch::represent::{MAX_DETECTIONS, Observation};
use wisch::run::{
    Ending, Execution, MotionOrder, SampleSink, StopCause, TelemetrySample, TrajectoryClock, Wrench,
};

/// How far from 1 the norm of a quaternion may be.
const UNIT_TOLERANCE: f64 = 1e-3;
/// A motion that is said to be complete has a sample this long before its end, or later [s].
const LAST_SAMPLE: f64 = 1.0;
/// A motion may be said to last this much longer than its samples [s].
const UNMEASURED: f64 = 60.0;
/// A sample may come this long before the motion [s].
const EARLY: f64 = 1.0;
/// Samples are at least this far apart [s].
const LEAST_STEP: f64 = 1e-6;
/// Most samples per second of a motion, on average [Hz]; the first [`BURST`] may come faster.
const MAX_RATE: f64 = 10_000.0;
const BURST: f64 = 1_000.0;
/// Largest numbers of samples that are taken for measured: of the tool's place [m], of forces and moments [N, Nm], and
/// of joints, their velocities and efforts [rad, m, rad/s, m/s, Nm, N].
const MAX_PLACE: f64 = 1e5;
const MAX_WRENCH: f64 = 1e6;
const MAX_JOINT: f64 = 1e6;
/// Largest coordinate of what is seen, in the frame of the surface [m].
const MAX_SEEN: f64 = 1e3;
/// Most corners of all polygons that cannot be seen.
const MAX_HIDDEN_CORNERS: usize = 1_000;
/// Longest reason of a protective stop that is kept [characters].
const MAX_REASON: usize = 400;

/// What is measured at one instant, as an executor says it. Poses are x, y, z [m] and a unit quaternion x, y, z, w in the
/// world.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SampleRecord {
    /// Time since the motion began [s].
    pub time_s: f64,
    /// Time of the setpoint that the controller is at, on the trajectory as it was ordered [s]; `None` where the executor
    /// does not say so, which is then estimated.
    pub trajectory_time_s: Option<f64>,
    /// Where the tool is.
    pub world_from_tool: [f64; 7],
    /// Force of the surroundings on the tool, in the axes of the world [N].
    pub force_n: [f64; 3],
    /// Its moment about the tool centre point [Nm].
    #[serde(default)]
    pub moment_nm: [f64; 3],
    /// Where the tool was told to be, the press into the surface included; `None` takes where it is.
    pub world_from_commanded: Option<[f64; 7]>,
    /// What the controller asked of the tool [N].
    #[serde(default)]
    pub controller_force_n: [f64; 3],
    /// Its moment [Nm].
    #[serde(default)]
    pub controller_moment_nm: [f64; 3],
    /// All n variables of the robot, or none where they are not measured [rad or m].
    pub positions: Vec<f64>,
    /// Their velocities, or none [rad/s or m/s].
    #[serde(default)]
    pub velocities: Vec<f64>,
    /// Their efforts, or none [Nm or N].
    #[serde(default)]
    pub efforts: Vec<f64>,
}

impl SampleRecord {
    /// That it comes after the one before, and that all in it are numbers of the right count.
    fn check(&self, since: f64, dof: usize) -> Result<(), String> {
        let time = self.time_s;
        if !time.is_finite() {
            return Err(format!("time_s of the sample after {since} s is {time}"));
        }
        if time <= since {
            return Err(format!("the sample of {time} s follows that of {since} s"));
        }
        if time - since < LEAST_STEP {
            return Err(format!(
                "the sample of {time} s follows that of {since} s by less than {LEAST_STEP:e} s"
            ));
        }
        if time < -EARLY {
            return Err(format!(
                "the sample of {time} s is from before the motion, which began at 0 s"
            ));
        }
        let trajectory_time = self.trajectory_time_s.as_ref();
        let told = self.world_from_commanded.as_ref();
        for (key, values, most) in [
            (
                "trajectory_time_s",
                trajectory_time.map_or(&[][..], std::slice::from_ref),
                f64::MAX,
            ),
            ("world_from_tool", &self.world_from_tool[..], MAX_PLACE),
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
                    "at {time} s {key} has {count} numbers, the robot {dof} joints"
                ));
            }
        }
        let poses = [Some(self.world_from_tool), self.world_from_commanded];
        for pose in poses.into_iter().flatten() {
            let norm = pose[3..].iter().map(|x| x * x).sum::<f64>().sqrt();
            if (norm - 1.0).abs() > UNIT_TOLERANCE {
                return Err(format!(
                    "at {time} s a quaternion has norm {norm}, not 1 within {UNIT_TOLERANCE}"
                ));
            }
        }
        Ok(())
    }
}

/// That all numbers of a quantity are finite and not too large to have been measured.
fn check(key: &str, values: &[f64], most: f64) -> Result<(), String> {
    match values
        .iter()
        .enumerate()
        .find(|(_, x)| x.is_nan() || x.abs() > most)
    {
        Some((i, value)) if value.is_finite() => Err(format!(
            "{key}[{i}] is {value:e}, beyond the limit of {most:e}"
        )),
        Some((i, value)) => Err(format!("{key}[{i}] is {value}")),
        None => Ok(()),
    }
}

/// What is seen of the dirt, in the frame of the believed surface [m].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ObservationRecord {
    /// Places where dirt is seen.
    pub detections: Vec<[f64; 2]>,
    /// Polygons that cannot be seen.
    #[serde(default)]
    pub hidden: Vec<Vec<[f64; 2]>>,
}

impl ObservationRecord {
    /// The observation.
    ///
    /// # Errors
    /// A number that is none or farther away than anything can be seen, more than [`MAX_DETECTIONS`] detections, a
    /// polygon without three corners, or polygons with more corners than are looked at.
    pub fn into_observation(self) -> Result<Observation, String> {
        let counts = [
            ("detections", self.detections.len(), MAX_DETECTIONS),
            (
                "corners of hidden polygons",
                self.hidden.iter().map(Vec::len).sum(),
                MAX_HIDDEN_CORNERS,
            ),
        ];
        for (what, count, most) in counts {
            if count > most {
                return Err(format!(
                    "observation: {count} {what} exceed the limit of {most}"
                ));
            }
        }
        let places = self.hidden.iter().flatten().chain(&self.detections);
        for [x, y] in places {
            if !(x.is_finite() && y.is_finite()) {
                return Err(format!("observation: place ({x}, {y}) m is not finite"));
            }
            if x.abs().max(y.abs()) > MAX_SEEN {
                return Err(format!(
                    "observation: place ({x:e}, {y:e}) m is farther than {MAX_SEEN} m from the surface's origin"
                ));
            }
        }
        if let Some((i, ring)) = (self.hidden.iter().enumerate()).find(|(_, ring)| ring.len() < 3) {
            let corners = ring.len();
            return Err(format!(
                "observation: hidden[{i}] has {corners} corners; a polygon has 3 or more"
            ));
        }
        let points = |ring: Vec<[f64; 2]>| ring.into_iter().map(Point2::from).collect();
        let hidden = self
            .hidden
            .into_iter()
            .map(|ring| Polygon::new(points(ring), vec![]));
        Ok(Observation {
            hidden: Region::new(hidden.collect()),
            detections: points(self.detections),
        })
    }
}

/// How an execution went, as an executor says it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DoneRecord {
    /// How long it took [s].
    pub duration_s: f64,
    /// How it ended.
    pub ending: EndingRecord,
    /// All n variables of the robot at the end, or none where they are not measured [rad or m].
    pub positions: Vec<f64>,
}

/// Where the joints stand, as an executor says it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StateRecord {
    /// All n variables of the robot, or none where they are not known [rad or m].
    positions: Vec<f64>,
}

impl StateRecord {
    /// The positions; `None` where they are not known.
    ///
    /// # Errors
    /// A number that is none, or beyond what can be measured.
    pub fn into_positions(self) -> Result<Option<Vec<f64>>, String> {
        check("state: positions", &self.positions, MAX_JOINT)?;
        Ok(Some(self.positions).filter(|positions| !positions.is_empty()))
    }
}

/// How an execution ended, as an executor says it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EndingRecord {
    /// All is done.
    Complete,
    /// It was told to stop.
    Stopped,
    /// The robot stopped itself.
    ProtectiveStop {
        /// When [s].
        time_s: f64,
        /// Why.
        reason: String,
    },
}

/// Takes in what an executor hands over during one motion, checks it, and hands it on.
pub struct Intake<'a> {
    order: &'a MotionOrder<'a>,
    sink: &'a mut SampleSink<'a>,
    clock: TrajectoryClock,
    dof: usize,
    since: f64,
    count: f64,
    /// Where the joints were last measured.
    positions: Vec<f64>,
    is_stopped: bool,
}

impl<'a> Intake<'a> {
    /// Of this motion, into this sink.
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
        }
    }

    /// Whether the motion is to be broken off.
    pub const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// Time of the last sample [s]; before any, minus infinity.
    pub const fn time(&self) -> f64 {
        self.since
    }

    /// How far the robot has come on its trajectory [s].
    pub const fn trajectory_time(&self) -> f64 {
        self.clock.reached()
    }

    /// How long the trajectory is [s].
    pub fn end(&self) -> f64 {
        self.order.followed.duration()
    }

    /// Takes one sample; what comes after the motion was broken off is checked and goes nowhere.
    ///
    /// The motion and phase of the sample are those of its trajectory time: a robot may run slower than planned.
    ///
    /// # Errors
    /// A time that is not after that of the sample before, more samples than can be measured, a number that is none or
    /// beyond what can be measured, an array of another length than the robot has joints, or a quaternion that is not of
    /// unit length: with the time of the sample, the value and the limit.
    pub fn take(&mut self, sample: &SampleRecord) -> Result<(), String> {
        sample.check(self.since, self.dof)?;
        self.since = sample.time_s;
        self.count += 1.0;
        if self.count > BURST + MAX_RATE * (EARLY + self.since) {
            return Err(format!(
                "{} samples until {} s are more than {MAX_RATE} a second",
                self.count, self.since
            ));
        }
        let world_from_tool = pose(&sample.world_from_tool);
        let (reported, positions) = (sample.trajectory_time_s, &sample.positions);
        let at = (self.clock)
            .advance(self.since, reported, positions, &world_from_tool)
            .map_err(|error| format!("at {} s: {error}", self.since))?;
        if !sample.positions.is_empty() {
            self.positions.clone_from(&sample.positions);
        }
        if self.is_stopped {
            return Ok(());
        }
        let Some((motion, phase)) = self.order.motion_at(at) else {
            return Ok(());
        };
        let flow = (self.sink)(&TelemetrySample {
            time: self.since,
            positions: &sample.positions,
            velocities: &sample.velocities,
            efforts: &sample.efforts,
            world_from_commanded: (sample.world_from_commanded.as_ref())
                .map_or(world_from_tool, pose),
            world_from_tool,
            controller: wrench(sample.controller_force_n, sample.controller_moment_nm),
            external: wrench(sample.force_n, sample.moment_nm),
            motion,
            phase,
        });
        self.is_stopped = flow.is_break();
        Ok(())
    }

    /// What the execution gives. Positions that are not measured at the end are those of the last sample that has some.
    ///
    /// # Errors
    /// A number that is none or beyond what can be measured, times that do not fit the samples, or a motion that is said to
    /// be complete without samples up to its end.
    pub fn done(&self, done: DoneRecord) -> Result<Execution, String> {
        check("at the end positions", &done.positions, MAX_JOINT)?;
        let end = self.end();
        let is_complete = done.ending == EndingRecord::Complete && !self.is_stopped;
        if is_complete && self.since < end - LAST_SAMPLE {
            let last = if self.since.is_finite() {
                format!("the last sample is that of {} s", self.since)
            } else {
                "there is no sample".to_owned()
            };
            return Err(format!(
                "the motion of {end:.3} s is said to be complete, but {last}"
            ));
        }
        let most = if is_complete {
            self.since + LAST_SAMPLE
        } else {
            self.since.max(end) + UNMEASURED
        };
        let duration = done.duration_s;
        let stop = match &done.ending {
            EndingRecord::ProtectiveStop { time_s, .. } => {
                Some(("protective_stop.time_s", *time_s))
            }
            EndingRecord::Complete | EndingRecord::Stopped => None,
        };
        for (key, time) in [Some(("duration_s", duration)), stop].into_iter().flatten() {
            if !(0.0..=most).contains(&time) {
                return Err(format!(
                    "at the end {key} is {time:e} s; expected 0 to {most:.3} s"
                ));
            }
        }
        let positions = if !done.positions.is_empty() {
            done.positions
        } else if is_complete && self.positions.is_empty() {
            let last = self.order.followed.sample(end);
            last.map(|sample| sample.q).unwrap_or_default()
        } else {
            self.positions.clone()
        };
        Ok(Execution {
            duration,
            ending: done.ending.into(),
            positions,
        })
    }
}

impl From<EndingRecord> for Ending {
    fn from(ending: EndingRecord) -> Self {
        match ending {
            EndingRecord::Complete => Self::Complete,
            EndingRecord::Stopped => Self::Stopped,
            EndingRecord::ProtectiveStop { time_s, reason } => Self::ProtectiveStop {
                time: time_s,
                cause: StopCause::Reported {
                    reason: printable(&reason, MAX_REASON),
                },
            },
        }
    }
}

fn wrench(force: [f64; 3], moment: [f64; 3]) -> Wrench {
    Wrench {
        force: Vector3::from(force),
        moment: Vector3::from(moment),
    }
}

fn pose(&[x, y, z, i, j, k, w]: &[f64; 7]) -> Pose {
    Pose::from_parts(
        nalgebra::Translation3::new(x, y, z),
        nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, i, j, k)),
    )
}
