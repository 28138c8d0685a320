//! The summary that `--json` prints.

use serde::Serialize;

/// Schema number of the summary that `--json` prints.
pub const SUMMARY_SCHEMA: u32 = 1;

/// The summary of a command that `--json` prints.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Always [`SUMMARY_SCHEMA`].
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// absorb, collect, skim, polish or dispense.
    pub action: String,
    /// Name of the surface.
    pub surface: String,
    /// Name of the tool.
    pub tool: String,
    /// Name of the medium.
    pub medium: String,
    /// Strategy of the plan.
    pub strategy: String,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Initial number of particles.
    pub particles: usize,
    /// Nodes of the graph.
    pub nodes: usize,
    /// Edges of the graph.
    pub edges: usize,
    /// Strokes.
    pub strokes: usize,
    /// Share of the particles that no allowed tool pose covers.
    pub unreachable_share: f64,
    /// Contact of the tool with the bend of the surface; its key is missing on a plane, and for a tool that hovers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bend_contact: Option<super::BendContactRecord>,
    /// Path length of the tool in contact: along the strokes that the robot follows, in all executed rounds or else in the
    /// motion; without a robot, along the strokes of the plan.
    pub distance_in_contact_m: f64,
    /// Total path length of the tool: with a robot, in the world from its ready posture and back; without one, of the strokes
    /// and the lifted moves between them.
    pub distance_total_m: f64,
    /// Planning time of the first round; null if the user gave the plan.
    pub planning_time_s: Option<f64>,
    /// Prediction; its keys are missing without a prediction.
    #[serde(flatten)]
    pub prediction: Option<PredictionSummary>,
    /// Passes over a treated surface; its keys are missing for actions that move dirt.
    #[serde(flatten)]
    pub treatment: Option<TreatmentSummary>,
    /// The robot's motion; its keys are missing without a robot.
    #[serde(flatten)]
    pub following: Option<FollowingSummary>,
    /// The execution; its keys are missing without an execution.
    #[serde(flatten)]
    pub execution: Option<super::LoopSummary>,
    /// The plans of all strategies; its key is missing if they were not requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub candidates: Option<Vec<CandidateSummary>>,
    /// The folder with the results.
    pub out: String,
}

/// The part of a summary about a treated surface: estimated after the last round, else predicted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TreatmentSummary {
    /// Mean number of passes over the points of the surface; one pass is a slide by the tool's own length.
    pub mean_passes: f64,
    /// Standard deviation of the passes over the points.
    pub passes_deviation: f64,
    /// Maximum number of passes over any point; null without a limit.
    pub max_passes: Option<u32>,
    /// Share of the points polished more often than that; null without a limit.
    pub share_above_max_passes: Option<f64>,
    /// Its 90 % interval; null without a limit, and for a prediction.
    pub share_above_max_passes_interval: Option<[f64; 2]>,
    /// Mean removed or dispensed thickness; null without a coefficient of Preston's law.
    pub mean_depth_m: Option<f64>,
}

/// A candidate plan. Values are null if the strategy found no plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CandidateSummary {
    /// grid, rrt, kde or adaptive.
    pub strategy: String,
    /// Whether this plan was chosen.
    pub chosen: bool,
    /// Score: expected share of the dirt that reaches the goal, minus costs of lost dirt, path length and time, in shares of
    /// the dirt.
    pub score: Option<f64>,
    /// Predicted share of the particles that reach the goal.
    pub predicted_performance: Option<f64>,
    /// Predicted share lost over an edge that is not a skim edge.
    pub lost_share: Option<f64>,
    /// Share of the particles that the tool passes over if they do not move.
    pub covered_share: Option<f64>,
    /// Path length in contact.
    pub distance_in_contact_m: Option<f64>,
    /// Total path length.
    pub distance_total_m: Option<f64>,
    /// Strokes.
    pub strokes: Option<usize>,
    /// Execution time of the robot; null without a robot.
    pub execution_time_s: Option<f64>,
    /// Number of abandoned nodes; null without a robot.
    pub abandoned_nodes: Option<usize>,
    /// Reason for a missing plan or motion; null if there is none missing.
    pub error: Option<String>,
}

/// The part of a summary about the prediction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PredictionSummary {
    /// Predicted share of the particles that reach the goal.
    pub predicted_performance: f64,
    /// Share that meets the goal.
    pub target_performance: f64,
    /// Whether the target is reached: by the last round's estimate, or without execution by the prediction.
    pub goal_met: bool,
    /// met, not met, or unknown: the last round allows no estimate, touch cannot decide, or without an executed round fewer
    /// particles than the target react to the press force, or the camera detects no dirt where some is expected.
    pub goal: &'static str,
    /// Probability that a particle reacts when the tool first touches it at the press force; the prediction assumes 1.
    pub reaction_probability: f64,
    /// Predicted share lost over an edge that is not a skim edge.
    pub lost_share: f64,
    /// Range of the number of detections that were expected before the first round; the key is missing unless the camera
    /// detects none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub undetected: Option<[f64; 2]>,
}

/// The part of a summary about the robot. Times and movements are those of all executed rounds, else of the planned motion;
/// nodes and placements are those of the first round.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FollowingSummary {
    /// Name of the robot.
    pub robot: String,
    /// How the robot holds the tool, in words, and whether that is assumed.
    pub mount: String,
    /// Names of the joints that carry the arm and stay at their positions of the ready posture, such as a lift.
    pub held_joints: Vec<String>,
    /// Number of abandoned nodes on the plan's strokes; a node on two strokes counts twice.
    pub abandoned_nodes: usize,
    /// Obstruction of the first abandoned node; null without abandoned nodes.
    pub first_obstruction: Option<String>,
    /// First fault that the audit found in a motion, which is then not executed; null without a fault.
    pub first_fault: Option<String>,
    /// Round of a run whose motion has faults; null without a fault.
    pub refused_round: Option<usize>,
    /// Performance lost to abandoned nodes: prediction of the plan minus prediction of the motion.
    pub abandoned_share: f64,
    /// Base poses in order of time: x \[m\], y \[m\], heading \[rad\] in the world.
    pub placements: Vec<[f64; 3]>,
    /// Duration of the whole motion, including driving and free motion.
    pub execution_time_s: f64,
    /// Duration of contact.
    pub contact_time_s: f64,
    /// Path length of the arm's revolute joints in joint space during contact.
    pub joint_movement_in_contact_rad: f64,
    /// Total path length of the arm's revolute joints.
    pub joint_movement_rad: f64,
    /// Path length of the arm's prismatic joints during contact; its key is missing for an arm without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_movement_in_contact_m: Option<f64>,
    /// Total path length of the arm's prismatic joints; its key is missing for an arm without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_movement_m: Option<f64>,
    /// Whether any link of the robot has a collision shape; not written.
    #[serde(skip)]
    pub has_shapes: bool,
    /// Computation time of the motion, including placements and timing.
    pub following_time_s: f64,
    /// Maximum position error of the tool centre point, in all rounds.
    pub max_path_deviation_m: f64,
    /// Maximum rotation error of the tool.
    pub max_turn_deviation_rad: f64,
    /// Minimum clearance between bodies that must not touch, in all rounds; at most 0.5.
    pub min_clearance_m: f64,
    /// Number of faults that an independent check has found in the motion with faults; 0 if every motion is valid.
    pub faults: usize,
}
