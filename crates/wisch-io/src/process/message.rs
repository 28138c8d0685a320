//! The messages between this program and an executor in another process: one JSON object a line.

use super::intake::{DoneRecord, ObservationRecord, SampleRecord, StateRecord};
use serde::{Deserialize, Serialize};
use wisch::geometry::Pose;
use wisch::run::{MotionOrder, Setpoint};

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
    /// Where do the joints stand?
    State,
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
    Ready {
        version: u32,
        /// Whether it can be asked for its state.
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
    /// What kind of message it is, for messages.
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
