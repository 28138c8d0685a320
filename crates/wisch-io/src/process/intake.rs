//! What an executor hands over that is not written in Rust: samples, observations and how it ended, checked.

use serde::Deserialize;
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector3};
use wisch::represent::{MAX_PARTICLES, Observation};
use wisch::run::{Ending, Execution, MotionOrder, SampleSink, StopCause, TelemetrySample, Wrench};

/// How far from 1 the norm of a quaternion may be.
const UNIT_TOLERANCE: f64 = 1e-3;
/// A motion that is said to be complete has a sample this long before its end, or later [s].
const LAST_SAMPLE: f64 = 1.0;

/// What is measured at one instant, as an executor says it. Poses are x, y, z [m] and a unit quaternion x, y, z, w in the
/// world.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SampleRecord {
    /// Time since the motion began [s].
    pub time_s: f64,
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
        let told = self.world_from_commanded.as_ref();
        for (key, values) in [
            ("world_from_tool", &self.world_from_tool[..]),
            ("force_n", &self.force_n),
            ("moment_nm", &self.moment_nm),
            ("world_from_commanded", told.map_or(&[], |pose| &pose[..])),
            ("controller_force_n", &self.controller_force_n),
            ("controller_moment_nm", &self.controller_moment_nm),
            ("positions", &self.positions),
            ("velocities", &self.velocities),
            ("efforts", &self.efforts),
        ] {
            if let Some((i, value)) = values.iter().enumerate().find(|(_, x)| !x.is_finite()) {
                return Err(format!("at {time} s {key}[{i}] is {value}"));
            }
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
    /// A number that is none, or more detections than there may be particles.
    pub fn into_observation(self) -> Result<Observation, String> {
        let places = self.hidden.iter().flatten().chain(&self.detections);
        if let Some([x, y]) = places
            .into_iter()
            .find(|[x, y]| !(x.is_finite() && y.is_finite()))
        {
            return Err(format!("observation: place ({x}, {y}) m is not finite"));
        }
        if self.detections.len() > MAX_PARTICLES {
            let count = self.detections.len();
            return Err(format!(
                "observation: {count} detections exceed the limit of {MAX_PARTICLES}"
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
    /// All n variables of the robot at the end [rad or m].
    pub positions: Vec<f64>,
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
    dof: usize,
    since: f64,
    is_stopped: bool,
}

impl<'a> Intake<'a> {
    /// Of this motion, into this sink.
    pub fn new(order: &'a MotionOrder<'a>, sink: &'a mut SampleSink<'a>) -> Self {
        Self {
            order,
            sink,
            dof: order.cell.robot().dof(),
            since: f64::NEG_INFINITY,
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

    /// Takes one sample; what comes after the motion was broken off is checked and goes nowhere.
    ///
    /// # Errors
    /// A time that is not after that of the sample before, a number that is none, an array of another length than the robot
    /// has joints, or a quaternion that is not of unit length: with the time of the sample and the value.
    pub fn take(&mut self, sample: &SampleRecord) -> Result<(), String> {
        sample.check(self.since, self.dof)?;
        self.since = sample.time_s;
        if self.is_stopped {
            return Ok(());
        }
        let Some((motion, phase)) = self.order.motion_at(self.since) else {
            return Ok(());
        };
        let world_from_tool = pose(&sample.world_from_tool);
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

    /// What the execution gives.
    ///
    /// # Errors
    /// A number that is none, or a motion that is said to be complete without samples up to its end.
    pub fn done(&self, done: DoneRecord) -> Result<Execution, String> {
        let numbers = done.positions.iter().chain([&done.duration_s]);
        if let Some(value) = numbers.into_iter().find(|value| !value.is_finite()) {
            return Err(format!("at the end a number is {value}"));
        }
        let end = self.order.followed.duration();
        if done.ending == EndingRecord::Complete
            && !self.is_stopped
            && self.since < end - LAST_SAMPLE
        {
            let last = if self.since.is_finite() {
                format!("the last sample is that of {} s", self.since)
            } else {
                "there is no sample".to_owned()
            };
            return Err(format!(
                "the motion of {end:.3} s is said to be complete, but {last}"
            ));
        }
        Ok(Execution {
            duration: done.duration_s,
            ending: done.ending.into(),
            positions: done.positions,
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
                cause: StopCause::Reported { reason },
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
