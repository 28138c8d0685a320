//! Candidate plans for the same dirt, of which the predicted effect chooses one.

use super::policies::{covering, some_of};
use super::subplans::composed;
use super::{CoverageStrategy, FreeSpace, Plan, PlanConfig, PlanError};
use crate::represent::{Action, ParticleDistribution, Task};

/// Bandwidths of the density estimate that are tried beside the configured one, over half the radius of the
/// collision sphere. The density's peaks, and with them the strokes, differ from one to the next.
const BANDWIDTHS: [f64; 9] = [0.5, 0.7, 0.85, 1.0, 1.2, 1.4, 1.7, 2.0, 2.6];

/// Corners of the surface at which strokes are begun.
const MAX_CORNERS: usize = 8;

/// Candidates are compared by their effect on no more particles than this: a random choice of more.
pub(super) const MOST_COMPARED: usize = 5000;

/// Candidate plans of a coverage strategy, at least one: the first `count` settings.
///
/// Nodes are placed on `to_plan_on`, such as the dirt that is not yet where it belongs. Candidates differ in the
/// bandwidth of the density estimate, if the strategy uses one, and then in where the strokes begin: at the tool, or at a
/// corner of the surface. The first is the plan as configured, unless that fails. Where as many as there are bandwidths
/// are asked for, each of their graphs also gives a plan whose strokes are chosen one by one by their predicted effect,
/// among them straight ones.
///
/// # Errors
/// Those of the first, if no candidate gives a plan.
pub(super) fn candidate_plans(
    task: &Task,
    to_plan_on: &ParticleDistribution,
    space: &FreeSpace,
    strategy: CoverageStrategy,
    config: &PlanConfig,
    count: usize,
) -> Result<Vec<Plan>, PlanError> {
    let mut plans = varied_plans(task, to_plan_on, space, strategy, config, count)?;
    let is_rooted = matches!(task.action, Action::Collect | Action::Skim);
    if is_rooted && count >= BANDWIDTHS.len() {
        let graphs = plans.iter().take(BANDWIDTHS.len());
        let composed: Vec<Plan> = graphs.map(|plan| composed(task, plan, space)).collect();
        plans.extend(composed);
    }
    Ok(plans)
}

/// Up to `count` plans, at least one; the first is the plan as configured, unless that fails.
pub(super) fn varied_plans(
    task: &Task,
    to_plan_on: &ParticleDistribution,
    space: &FreeSpace,
    strategy: CoverageStrategy,
    config: &PlanConfig,
    count: usize,
) -> Result<Vec<Plan>, PlanError> {
    let mut open = task.clone();
    open.particles = to_plan_on.clone();
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
        match covering(&open, space, strategy, &candidate) {
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

/// The task with as much of its dirt as candidates are compared by; all of a surface that is treated.
pub(super) fn some_to_compare(task: &Task) -> Task {
    let most = match task.action.treats() {
        true => usize::MAX,
        false => MOST_COMPARED,
    };
    Task {
        particles: some_of(&task.particles, most),
        ..task.clone()
    }
}
