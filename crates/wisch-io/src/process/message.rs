//! The messages between this program and an executor in another process: one JSON object a line.

use super::VERSIONS;
use super::described::DriverRobotRecord;
use super::intake::{DoneRecord, SampleRecord, StateRecord};
use super::observation::ObservationRecord;
use super::status::{PauseRecord, ResumeRecord, StampClockRecord};
use crate::records::ShapeRecord;
use serde::{Deserialize, Serialize};
use wisch::geometry::flatten_pose;
use wisch::run::{ForceRamp, MotionOrder, Setpoint};

/// Range of the silence that an executor permits itself during a motion \[s\].
pub const MAX_SILENCE_S: [f64; 2] = [0.02, 60.0];
/// Range of the error between points [rad or m].
const KNOT_ERROR_RAD: [f64; 2] = [1e-6, 0.1];

/// A message to the child.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ToChild<'a> {
    Hello {
        protocol: &'static str,
        /// The first version, which every child may answer.
        version: u32,
        /// All versions that this program speaks.
        versions: [u32; 2],
        #[serde(skip_serializing_if = "Option::is_none")]
        robot: Option<&'a DriverRobotRecord>,
    },
    /// A request to prepare the robot for motions.
    Prepare,
    /// A request to undo that, after the last motion.
    Finish,
    /// A motion, followed by the stated number of points.
    Execute(Box<MotionHead>),
    Point(TrajectoryPoint),
    /// A request to abort the current motion.
    Stop,
    /// Requests to pause the current motion, and to continue it.
    Pause,
    Resume,
    /// A request for the joint positions.
    State,
    Observe {
        surface: &'a str,
    },
}

/// The head of a motion, before its points.
#[derive(Debug, Serialize)]
pub(super) struct MotionHead {
    round: usize,
    seed: u64,
    robot: String,
    joints: Vec<String>,
    tool: String,
    world_from_surface: [f64; 7],
    /// Shape of a curved surface, for children that accept it.
    #[serde(skip_serializing_if = "Option::is_none")]
    surface_shape: Option<ShapeRecord>,
    press_force_n: f64,
    stiffness_n_per_m: f64,
    damping_ratio: f64,
    compression_depth_m: f64,
    /// Gap of a tool without contact; left out for contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_m: Option<f64>,
    duration_s: f64,
    phases: Vec<PhaseMessage>,
    points: usize,
    /// Since version 2.
    #[serde(flatten)]
    mount: Option<MountMessage>,
}

/// Where the robot and its tool are.
#[derive(Debug, Serialize)]
struct MountMessage {
    /// Name of the link that holds the tool.
    tip: String,
    tip_from_tool: [f64; 7],
    world_from_root: [f64; 7],
}

/// A phase of a motion.
#[derive(Debug, Serialize)]
struct PhaseMessage {
    phase: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    stroke: Option<usize>,
    start_s: f64,
    end_s: f64,
    /// Since version 2; left out where the tool does not touch.
    #[serde(flatten)]
    force: Option<ForceMessage>,
}

/// The force along the normal during a phase.
#[derive(Debug, Serialize)]
struct ForceMessage {
    /// Force at the start and at the end.
    force_n: [f64; 2],
    /// Time over which it changes: the last of a phase in which it rises, the first of one in which it falls.
    force_ramp_s: f64,
    /// Largest speed along the normal in that time.
    approach_speed_m_s: f64,
}

impl From<ForceRamp> for ForceMessage {
    fn from(ramp: ForceRamp) -> Self {
        Self {
            force_n: [ramp.start_force, ramp.end_force],
            force_ramp_s: ramp.duration,
            approach_speed_m_s: ramp.approach_speed,
        }
    }
}

/// A setpoint of joints and tool at a time.
#[derive(Debug, Serialize)]
pub(super) struct TrajectoryPoint {
    time_s: f64,
    positions: Vec<f64>,
    velocities: Vec<f64>,
    /// Since version 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    accelerations: Option<Vec<f64>>,
    world_from_tool: [f64; 7],
}

/// What a child is able to do, in the answer to `hello`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize)]
pub(super) struct ReadyRecord {
    /// The version that it speaks.
    pub version: u32,
    /// Whether it answers requests for its state.
    #[serde(default)]
    pub reports_state: bool,
    /// Since version 2: maximum time between its messages during a motion [s].
    pub max_silence_s: Option<f64>,
    /// Since version 2: deviation of quintic polynomials between the points from the trajectory that it permits [rad or m];
    /// without it, points are 10 ms apart.
    pub knot_error_rad: Option<f64>,
    /// Since version 2: whether it presses along the normal under the tool, also where that differs from place to place.
    #[serde(default)]
    pub accepts_curved: bool,
    /// Since version 2: whether it answers `prepare` and `finish`.
    #[serde(default)]
    pub prepares: bool,
    /// Since version 2: whether it answers `pause` and `resume`.
    #[serde(default)]
    pub pauses: bool,
    /// Since version 2: whether it executes in real time, so that it must never wait for this program.
    #[serde(default)]
    pub real_time: bool,
    /// Since version 2: the clock of `stamp_ns`.
    pub stamp_clock: Option<StampClockRecord>,
}

impl ReadyRecord {
    /// Checks the version and the ranges of all numbers.
    pub fn check(&self) -> Result<(), String> {
        let version = self.version;
        if !VERSIONS.contains(&version) {
            let [first, last] = VERSIONS;
            return Err(format!(
                "it uses protocol version {version}; expected {first} or {last}"
            ));
        }
        for (key, value, [least, most]) in [
            ("max_silence_s", self.max_silence_s, MAX_SILENCE_S),
            ("knot_error_rad", self.knot_error_rad, KNOT_ERROR_RAD),
        ] {
            match value {
                Some(value) if !(least..=most).contains(&value) => {
                    return Err(format!(
                        "ready: {key} is {value}; expected {least} to {most}"
                    ));
                }
                Some(_) if version < 2 => {
                    return Err(format!("ready: {key} needs version 2"));
                }
                _ => {}
            }
        }
        let flags = [
            ("accepts_curved", self.accepts_curved),
            ("prepares", self.prepares),
            ("pauses", self.pauses),
            ("real_time", self.real_time),
            ("stamp_clock", self.stamp_clock.is_some()),
        ];
        if let Some((key, _)) = flags.into_iter().find(|(_, is_set)| *is_set)
            && version < 2
        {
            return Err(format!("ready: {key} needs version 2"));
        }
        Ok(())
    }
}

/// A message from the child.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum FromChild {
    Ready(ReadyRecord),
    Prepared,
    Finished,
    Paused(PauseRecord),
    Resumed(ResumeRecord),
    Sample(Box<SampleRecord>),
    Done(DoneRecord),
    State(StateRecord),
    Observation(Option<ObservationRecord>),
    Error(String),
}

impl FromChild {
    /// The kind of the message, for error messages.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Ready(_) => "\"ready\"",
            Self::Prepared => "\"prepared\"",
            Self::Finished => "\"finished\"",
            Self::Paused(_) => "\"paused\"",
            Self::Resumed(_) => "\"resumed\"",
            Self::Sample(_) => "\"sample\"",
            Self::Done(_) => "\"done\"",
            Self::State(_) => "\"state\"",
            Self::Observation(_) => "\"observation\"",
            Self::Error(_) => "\"error\"",
        }
    }
}

impl MotionHead {
    /// Returns the head of a motion in a version of the protocol.
    pub fn new(order: &MotionOrder<'_>, points: usize, version: u32) -> Self {
        let robot = order.cell.robot();
        let interaction = &order.task.interaction;
        let motions = order.followed.motions.iter().enumerate();
        let phases = motions.map(|(index, motion)| PhaseMessage {
            phase: motion.phase.as_str(),
            stroke: motion.phase.stroke(),
            start_s: motion.start,
            end_s: motion.end(),
            force: (order.force_ramp(index).filter(|_| version >= 2)).map(ForceMessage::from),
        });
        Self {
            round: order.round,
            seed: order.seed,
            robot: robot.name().to_owned(),
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            tool: order.task.tool.name.clone(),
            world_from_surface: flatten_pose(&order.task.surface.world_from_surface),
            surface_shape: ShapeRecord::from_curved(&order.task.surface.shape),
            press_force_n: interaction.contact_force(),
            stiffness_n_per_m: interaction.stiffness_n_per_m,
            damping_ratio: interaction.damping_ratio,
            compression_depth_m: interaction.compression_depth_m,
            gap_m: interaction.hovers().then_some(interaction.gap_m),
            duration_s: order.followed.duration(),
            phases: phases.collect(),
            points,
            mount: (version >= 2).then(|| MountMessage {
                tip: robot.links()[order.cell.tip().index()].name.clone(),
                tip_from_tool: flatten_pose(order.cell.tip_from_tool()),
                world_from_root: flatten_pose(order.cell.world_from_root()),
            }),
        }
    }
}

impl TrajectoryPoint {
    /// Returns a point in a version of the protocol.
    pub fn new(at: Setpoint, version: u32) -> Self {
        Self {
            accelerations: (version >= 2).then_some(at.accelerations),
            time_s: at.time,
            world_from_tool: flatten_pose(&at.world_from_tool),
            positions: at.positions,
            velocities: at.velocities,
        }
    }
}
