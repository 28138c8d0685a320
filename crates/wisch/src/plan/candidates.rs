//! Candidate plans for the same dirt; the caller keeps the one with the best predicted effect.

use super::policies::{plan_by_coverage, sample_task};
use super::subplans::compose_subplans;
use super::{CoverageStrategy, FreeSpace, Plan, PlanConfig, PlanError};
use crate::represent::{Action, Task};

/// Bandwidths of the density estimate that are tried beside the configured bandwidth, over half the radius of
/// the collision sphere [1]. The density's peaks, and with them the strokes, differ from bandwidth to
/// bandwidth.
const BANDWIDTHS: [f64; 9] = [0.5, 0.7, 0.85, 1.0, 1.2, 1.4, 1.7, 2.0, 2.6];

/// Number of corners of the surface from which candidate strokes start, at most.
const MAX_CORNERS: usize = 8;

/// Largest number of particles by which candidates are compared; of more particles, a random subset is used.
pub(super) const MOST_COMPARED: usize = 5000;

/// Returns candidate plans of a coverage strategy: at least one, and one for each of the first `count` settings
/// that work.
///
/// `open`: the same task with the dirt on which nodes are placed, for example the dirt that is not
/// yet where it belongs. Candidates differ in the bandwidth of the density estimate, if the
/// strategy uses one, and then in the start of the strokes: the tool's position, or a corner of the
/// surface. The first candidate is the plan as configured, unless that fails. If `count` is at
/// least the number of bandwidths, each of their graphs gives a second plan: its strokes are chosen
/// one by one by their predicted effect, straight strokes among them.
///
/// # Errors
/// The error of the first setting, if no setting gives a plan.
pub(super) fn candidate_plans(
    task: &Task,
    open: &Task,
    space: &FreeSpace,
    strategy: CoverageStrategy,
    config: &PlanConfig,
    count: usize,
) -> Result<Vec<Plan>, PlanError> {
    let mut plans = varied_plans(open, space, strategy, config, count)?;
    let is_rooted = matches!(task.action, Action::Collect | Action::Skim);
    if is_rooted && count >= BANDWIDTHS.len() {
        let graphs = plans.iter().take(BANDWIDTHS.len());
        let composed: Vec<Plan> = graphs
            .map(|plan| compose_subplans(task, plan, space))
            .collect();
        plans.extend(composed);
    }
    Ok(plans)
}

/// Returns up to `count` plans, at least one; the first is the plan as configured, unless that fails.
pub(super) fn varied_plans(
    task: &Task,
    space: &FreeSpace,
    strategy: CoverageStrategy,
    config: &PlanConfig,
    count: usize,
) -> Result<Vec<Plan>, PlanError> {
    let mut open = task.clone();
    let half_radius = task.tool.collision_radius() / 2.0;
    let mut bandwidths = vec![config.bandwidth];
    if strategy.uses_bandwidth() {
        bandwidths.extend(BANDWIDTHS.map(|scale| Some(scale * half_radius)));
    }
    let corners = task.surface.outline.outer().iter().take(MAX_CORNERS);
    let starts = std::iter::once(task.tool_start).chain(corners.copied());
    let settings = starts.flat_map(|start| bandwidths.iter().map(move |&b| (start, b)));
    let mut plans = Vec::new();
    let mut failure = None;
    for (start, bandwidth) in settings.take(count.max(1)) {
        open.tool_start = start;
        let candidate = PlanConfig {
            bandwidth,
            ..config.clone()
        };
        match plan_by_coverage(&open, space, strategy, &candidate) {
            Ok(plan) => plans.push(Plan {
                tool_start: task.tool_start,
                ..plan
            }),
            Err(error) => {
                failure.get_or_insert(error);
            }
        }
    }
    match failure {
        Some(error) if plans.is_empty() => Err(error),
        _ => Ok(plans),
    }
}

/// Returns the task with at most [`MOST_COMPARED`] particles. An action that treats the surface keeps all of
/// them.
pub(super) fn reduce_for_comparison(task: &Task) -> Task {
    let most = match task.action.treats() {
        true => usize::MAX,
        false => MOST_COMPARED,
    };
    sample_task(task, most)
}
