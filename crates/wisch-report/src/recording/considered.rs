//! The candidate plans of a round.

use super::particles::line;
use super::reasons::find_lost_share;
use super::samples::{round_share, round_to};
use serde::Serialize;
use wisch::plan::{Plan, Stroke};
use wisch::run::CandidateEvaluation;

/// A candidate plan; missing figures are null.
#[derive(Debug, Serialize)]
pub(super) struct ConsideredRecord {
    pub(super) strategy: &'static str,
    /// Whether it was chosen.
    pub(super) chosen: bool,
    score: Option<f64>,
    predicted: Option<f64>,
    /// Predicted share of lost dirt [1].
    lost: Option<f64>,
    strokes: Option<usize>,
    /// [m]
    in_contact: Option<f64>,
    /// Duration of the robot's motion [s].
    duration: Option<f64>,
    /// Its strokes, corners in turn; only of a candidate that was not chosen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) lines: Vec<Vec<i64>>,
    /// Reason for a missing plan.
    error: Option<String>,
}

impl ConsideredRecord {
    /// Makes a candidate, not yet marked as chosen.
    pub(super) fn new(one: &CandidateEvaluation) -> Self {
        let found = one.candidate.as_ref();
        let plan = found.ok().map(|found| &found.plan);
        let performance = one.prediction.as_ref().map(|found| found.performance);
        Self {
            strategy: one.strategy.as_str(),
            chosen: false,
            score: found.ok().map(|found| round_to(found.score.total, 1e4)),
            predicted: performance.map(|found| round_share(found.ratio())),
            lost: performance.as_ref().map(find_lost_share),
            strokes: plan.map(|plan| plan.strokes.len()),
            in_contact: plan.map(|plan| round_to(Plan::contact_distance(plan), 1e3)),
            duration: one.motion.map(|motion| round_to(motion.duration, 1e2)),
            lines: plan.map_or_else(Vec::new, |plan| {
                let corners =
                    |stroke: &Stroke| line(stroke.poses.iter().map(|pose| &pose.position));
                plan.strokes.iter().map(corners).collect()
            }),
            error: found.err().map(ToString::to_string),
        }
    }
}
