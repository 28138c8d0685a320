//! The messages between this program and an executor in another process: one JSON object a line.

use super::intake::{DoneRecord, ObservationRecord, SampleRecord, StateRecord};
use serde::{Deserialize, Serialize};
use wisch::geometry::Pose;
use wisch::run::{MotionOrder, Setpoint};

/// A message to the child.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ToChild<'a> {
    Hello {
        protocol: &'static str,
        version: u32,
    },
    /// A motion, followed by the stated number of points.
    Execute(MotionHead),
    Point(TrajectoryPoint),
    /// A request to abort the current motion.
    Stop,
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
}

/// A phase of a motion.
#[derive(Debug, Serialize)]
struct PhaseMessage {
    phase: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    stroke: Option<usize>,
    start_s: f64,
    end_s: f64,
}

/// A setpoint of joints and tool at a time.
#[derive(Debug, Serialize)]
pub(super) struct TrajectoryPoint {
    time_s: f64,
    positions: Vec<f64>,
    velocities: Vec<f64>,
    world_from_tool: [f64; 7],
}

/// A message from the child.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum FromChild {
    Ready {
        version: u32,
        /// Whether it answers requests for its state.
        #[serde(default)]
        reports_state: bool,
    },
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
            Self::Ready { .. } => "\"ready\"",
            Self::Sample(_) => "\"sample\"",
            Self::Done(_) => "\"done\"",
            Self::State(_) => "\"state\"",
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

/// x, y, z, then the quaternion's x, y, z, w.
fn numbers(pose: &Pose) -> [f64; 7] {
    let p = pose.translation.vector;
    let q = pose.rotation.coords;
    [p.x, p.y, p.z, q.x, q.y, q.z, q.w]
}
