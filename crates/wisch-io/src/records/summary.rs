//! What `--json` prints.

use serde::Serialize;

/// The schema of the object that `--json` prints.
pub const SUMMARY_SCHEMA: u32 = 1;

/// What `--json` prints.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Always [`SUMMARY_SCHEMA`].
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// absorb, collect, skim, polish or emit.
    pub action: String,
    /// Name of the surface.
    pub surface: String,
    /// Name of the tool.
    pub tool: String,
    /// Name of the medium.
    pub medium: String,
    /// How the strokes were found.
    pub strategy: String,
    /// Seed of everything random.
    pub seed: u64,
    /// Particles at the beginning.
    pub particles: usize,
    /// Nodes of the graph.
    pub nodes: usize,
    /// Edges of the graph.
    pub edges: usize,
    /// Strokes.
    pub strokes: usize,
    /// Share of the particles that no allowed pose of the tool covers.
    pub unreachable_share: f64,
    /// Way in contact: of all rounds that were executed, or else of the plan.
    pub distance_in_contact_m: f64,
    /// Whole way, of the same.
    pub distance_total_m: f64,
    /// How long planning took, of the first round; null where a plan was given.
    pub planning_time_s: Option<f64>,
    /// What the prediction says; its keys are missing where nothing was predicted.
    #[serde(flatten)]
    pub prediction: Option<PredictionSummary>,
    /// What was done to each place of a surface that is treated; its keys are missing for what moves dirt.
    #[serde(flatten)]
    pub treatment: Option<TreatmentSummary>,
    /// What the robot makes of the plan; its keys are missing where no robot followed it.
    #[serde(flatten)]
    pub following: Option<FollowingSummary>,
    /// What came of executing it; its keys are missing where nothing was executed.
    #[serde(flatten)]
    pub execution: Option<super::LoopSummary>,
    /// The plans of all strategies; its key is missing where nobody asked for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub candidates: Option<Vec<CandidateSummary>>,
    /// The folder with the results.
    pub out: String,
}

/// The part of a summary about a surface that is treated: as estimated after the last round, or else as predicted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TreatmentSummary {
    /// Mean over the places of how often the tool slid over each by its own length.
    pub mean_passes: f64,
    /// Standard deviation of that over the places.
    pub passes_deviation: f64,
    /// Mean thickness that is removed, or left; null where no coefficient of Preston's law is given.
    pub mean_depth_m: Option<f64>,
}

/// One of the plans that there were to choose from. Values are null where there is no plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CandidateSummary {
    /// grid, rrt, kde or adaptive.
    pub strategy: String,
    /// Whether this is the plan.
    pub chosen: bool,
    /// What it is worth: the dirt that it is expected to bring where it belongs, less losses, way and time, in
    /// shares of the dirt.
    pub worth: Option<f64>,
    /// Share of the particles where the action wants them.
    pub predicted_performance: Option<f64>,
    /// Share pushed over an edge where that is not wanted.
    pub lost_share: Option<f64>,
    /// Share of the particles that the tool passes over where they lie.
    pub covered_share: Option<f64>,
    /// Way in contact.
    pub distance_in_contact_m: Option<f64>,
    /// Whole way.
    pub distance_total_m: Option<f64>,
    /// Strokes.
    pub strokes: Option<usize>,
    /// How long the robot takes; null without a robot.
    pub execution_time_s: Option<f64>,
    /// Nodes that the robot does not reach; null without a robot.
    pub abandoned_nodes: Option<usize>,
    /// Why there is no plan, or no motion; null where there is.
    pub error: Option<String>,
}

/// The part of a summary that takes a prediction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PredictionSummary {
    /// Share of the particles where the action wants them.
    pub predicted_performance: f64,
    /// Share from which on the goal is met.
    pub target_performance: f64,
    /// Whether the target is reached: by the estimate of the last round, or where nothing was executed by
    /// the prediction.
    pub goal_met: bool,
    /// Share pushed over an edge where that is not wanted.
    pub lost_share: f64,
}

/// The part of a summary that takes a robot. Times and movement are those of all rounds that were executed, or else of the
/// motion that was found; nodes and placements those of the first round.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FollowingSummary {
    /// Name of the robot.
    pub robot: String,
    /// Nodes on the plan's strokes that no way of the robot leads to; a node on two strokes counts twice.
    pub abandoned_nodes: usize,
    /// What was in the way of the first of them; null where there is none.
    pub first_obstruction: Option<String>,
    /// Share of the particles that this loses: predicted for the plan less predicted for the motion.
    pub abandoned_share: f64,
    /// Where the base stands, one after the other: x [m], y [m], heading [rad] in the world.
    pub placements: Vec<[f64; 3]>,
    /// How long the whole motion takes, driving and free motion included.
    pub execution_time_s: f64,
    /// How long of it the tool wipes.
    pub contact_time_s: f64,
    /// The length of the way of the arm's joints in joint space while the tool wipes.
    pub joint_movement_in_contact_rad: f64,
    /// The length of their whole way.
    pub joint_movement_rad: f64,
    /// How long finding the motion took, placements and timing included.
    pub following_time_s: f64,
    /// How far the tool centre point leaves its line at most, in all rounds.
    pub max_path_deviation_m: f64,
    /// How far the tool turns away from its line at most.
    pub max_turn_deviation_rad: f64,
    /// How near bodies that must not touch come at least, in all rounds, at most 0.5.
    pub min_clearance_m: f64,
    /// What an independent check of the whole motion found wrong: nothing, in a sound motion.
    pub faults: usize,
}
