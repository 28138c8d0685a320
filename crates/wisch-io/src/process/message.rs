//! The messages between this program and an executor in another process: one JSON object a line.

use serde::{Deserialize, Serialize};
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector3};
use wisch::represent::{MAX_PARTICLES, Observation};
use wisch::run::{MotionOrder, Setpoint, Wrench};

/// How far from 1 the norm of a quaternion may be.
const UNIT_TOLERANCE: f64 = 1e-3;

/// What is said to the child.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ToChild<'a> {
    Hello {
        protocol: &'static str,
        version: u32,
    },
    /// A motion; as many points as it says follow.
    Execute(MotionHead),
    Point(TrajectoryPoint),
    /// The motion at hand is to be broken off.
    Stop,
    Observe {
        surface: &'a str,
    },
}

/// What is said of a motion before its points.
#[derive(Debug, Serialize)]
pub(super) struct MotionHead {
    round: usize,
    seed: u64,
    robot: String,
    joints: Vec<String>,
    tool: String,
    world_from_surface: [f64; 7],
    press_force_n: f64,
    stiffness_n_per_m: f64,
    damping_ratio: f64,
    compression_depth_m: f64,
    /// How high a tool hovers; left out where it touches.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_m: Option<f64>,
    duration_s: f64,
    phases: Vec<PhaseMessage>,
    points: usize,
}

/// One part of a motion.
#[derive(Debug, Serialize)]
struct PhaseMessage {
    phase: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    stroke: Option<usize>,
    start_s: f64,
    end_s: f64,
}

/// Where the joints and the tool shall be at a time.
#[derive(Debug, Serialize)]
pub(super) struct TrajectoryPoint {
    time_s: f64,
    positions: Vec<f64>,
    velocities: Vec<f64>,
    world_from_tool: [f64; 7],
}

/// What the child says.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum FromChild {
    Ready { version: u32 },
    Sample(Box<SampleMessage>),
    Done(Ended),
    Observation(Option<ObservationMessage>),
    Error(String),
}

/// What is seen of the dirt, in the frame of the believed surface.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObservationMessage {
    detections: Vec<[f64; 2]>,
    #[serde(default)]
    hidden: Vec<Vec<[f64; 2]>>,
}

impl ObservationMessage {
    /// The observation, if its numbers are some.
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

/// What is measured at one instant.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SampleMessage {
    pub time_s: f64,
    world_from_tool: [f64; 7],
    force_n: [f64; 3],
    #[serde(default)]
    moment_nm: [f64; 3],
    world_from_commanded: Option<[f64; 7]>,
    #[serde(default)]
    controller_force_n: [f64; 3],
    #[serde(default)]
    controller_moment_nm: [f64; 3],
    pub positions: Vec<f64>,
    #[serde(default)]
    pub velocities: Vec<f64>,
    #[serde(default)]
    pub efforts: Vec<f64>,
}

/// How an execution went.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Ended {
    pub duration_s: f64,
    pub ending: EndingMessage,
    pub positions: Vec<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum EndingMessage {
    Complete,
    Stopped,
    ProtectiveStop { time_s: f64, reason: String },
}

impl FromChild {
    /// What kind of message it is, for messages.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Ready { .. } => "\"ready\"",
            Self::Sample(_) => "\"sample\"",
            Self::Done(_) => "\"done\"",
            Self::Observation(_) => "\"observation\"",
            Self::Error(_) => "\"error\"",
        }
    }
}

impl MotionHead {
    pub fn new(order: &MotionOrder<'_>, points: usize) -> Self {
        let robot = order.cell.robot();
        let interaction = &order.task.interaction;
        let phases = order.followed.motions.iter().map(|motion| PhaseMessage {
            phase: motion.phase.as_str(),
            stroke: motion.phase.stroke(),
            start_s: motion.start,
            end_s: motion.end(),
        });
        Self {
            round: order.round,
            seed: order.seed,
            robot: robot.name().to_owned(),
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            tool: order.task.tool.name.clone(),
            world_from_surface: numbers(&order.task.surface.world_from_surface),
            press_force_n: interaction.contact_force(),
            stiffness_n_per_m: interaction.stiffness_n_per_m,
            damping_ratio: interaction.damping_ratio,
            compression_depth_m: interaction.compression_depth_m,
            gap_m: interaction.hovers().then_some(interaction.gap_m),
            duration_s: order.followed.duration(),
            phases: phases.collect(),
            points,
        }
    }
}

impl From<Setpoint> for TrajectoryPoint {
    fn from(at: Setpoint) -> Self {
        Self {
            time_s: at.time,
            world_from_tool: numbers(&at.world_from_tool),
            positions: at.positions,
            velocities: at.velocities,
        }
    }
}

impl SampleMessage {
    /// That it comes after the one before, and that all in it are numbers of the right count.
    pub fn check(&self, since: f64, dof: usize) -> Result<(), String> {
        let time = self.time_s;
        if time <= since {
            return Err(format!("the sample of {time} s follows that of {since} s"));
        }
        for (key, values, is_optional) in [
            ("positions", &self.positions, false),
            ("velocities", &self.velocities, true),
            ("efforts", &self.efforts, true),
        ] {
            let count = values.len();
            if count != dof && !(is_optional && count == 0) {
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

    /// Where the tool is.
    pub fn world_from_tool(&self) -> Pose {
        pose(&self.world_from_tool)
    }

    /// Where it was told to be, if that is said.
    pub fn world_from_commanded(&self) -> Option<Pose> {
        self.world_from_commanded.as_ref().map(pose)
    }

    /// f_c.
    pub fn controller(&self) -> Wrench {
        wrench(self.controller_force_n, self.controller_moment_nm)
    }

    /// f_ext.
    pub fn external(&self) -> Wrench {
        wrench(self.force_n, self.moment_nm)
    }
}

fn wrench(force: [f64; 3], moment: [f64; 3]) -> Wrench {
    Wrench {
        force: Vector3::from(force),
        moment: Vector3::from(moment),
    }
}

/// x, y, z, then the quaternion's x, y, z, w.
fn numbers(pose: &Pose) -> [f64; 7] {
    let p = pose.translation.vector;
    let q = pose.rotation.coords;
    [p.x, p.y, p.z, q.x, q.y, q.z, q.w]
}

fn pose(&[x, y, z, i, j, k, w]: &[f64; 7]) -> Pose {
    Pose::from_parts(
        nalgebra::Translation3::new(x, y, z),
        nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, i, j, k)),
    )
}
