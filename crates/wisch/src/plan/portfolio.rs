//! Plans by any strategy, and the choice among them.

use super::adaptive::{Judge, searched, worth as worth_to};
use super::candidates::{MOST_COMPARED, candidate_plans, some_to_compare};
use super::objective::best_by_objective;
use super::planner::{covering, some_of};
use super::subplans::space_of;
use super::{CoverageStrategy, FreeSpace, Plan, PlanConfig, PlanError, SearchConfig, Strategy};
use crate::geometry::Point2;
use crate::represent::{ParticleDistribution, Task};

/// Plans of the other strategies from which strokes are searched for: so many settings of each.
const BEGUN_WITH: [(CoverageStrategy, usize); 2] =
    [(CoverageStrategy::Kde, 9), (CoverageStrategy::Grid, 1)];

/// Strokes are searched for with no more particles than this: a random choice of more.
const MAX_PARTICLES: usize = 250;

/// A plan, and what it is predicted to be worth.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The plan; its strategy says where it comes from.
    pub plan: Plan,
    /// The share of the dirt that it brings where it belongs, less three times what it loses, less what comes near an
    /// edge, and less its way, lifts and turns: wiping all of the surface once costs 0.01 [1].
    pub worth: f64,
}

/// A candidate by each strategy, or why it has none, in the order of [`Strategy::ALL`].
pub type Portfolio = Vec<(Strategy, Result<Candidate, PlanError>)>;

/// Plans the wiping motion of a task.
///
/// # Errors
/// No free place on the surface, a goal node that is not free, a skim without an edge to push over,
/// or geometry and costs that the libraries refuse.
pub fn plan(task: &Task, config: &PlanConfig) -> Result<Plan, PlanError> {
    plan_for_any(task, std::slice::from_ref(&task.particles), config)
}

/// The plan for dirt that may lie like any of these; coverage strategies take the first for certain.
///
/// With several, the tool is held a little differently in each, heaps need room and contact begins late: what is right to
/// the millimetre for one is not for the next.
///
/// # Errors
/// As [`plan`].
pub fn plan_for_any(
    task: &Task,
    dirt: &[ParticleDistribution],
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    fitting(config.strategy, task)?;
    if config.strategy == Strategy::Best {
        let candidates = portfolio(task, dirt, config)?;
        return most_worth(candidates.into_iter().map(|(_, candidate)| candidate));
    }
    let (task, few, space) = prepared(task, dirt)?;
    let plan = one_by(config.strategy, &task, &few, &space, config)?;
    Ok(finished(plan, &task, &space, config))
}

/// The plans of all strategies for dirt that may lie like any of these, each with what it is predicted to be worth.
///
/// ```
/// use wisch::plan::{PlanConfig, portfolio};
/// # fn shown(task: &wisch::represent::Task, config: &PlanConfig) -> Result<(), wisch::plan::PlanError> {
/// for (strategy, candidate) in portfolio(task, std::slice::from_ref(&task.particles), config)? {
///     match candidate {
///         Ok(candidate) => println!("{strategy:10} {:.3}", candidate.worth),
///         Err(error) => println!("{strategy:10} {error}"),
///     }
/// }
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Geometry that the libraries refuse.
pub fn portfolio(
    task: &Task,
    dirt: &[ParticleDistribution],
    config: &PlanConfig,
) -> Result<Portfolio, PlanError> {
    let (task, few, space) = prepared(task, dirt)?;
    let task = &task;
    let judge = Judge::new(task, &few, &space, config.search.margin_m, None);
    let strategies = (Strategy::ALL.into_iter())
        .filter(|&strategy| strategy != Strategy::Best && strategy.fits(task.action));
    let candidates = strategies.map(|strategy| {
        let plan = one_by(strategy, task, &few, &space, config);
        let candidate = plan.map(|plan| {
            let plan = finished(plan, task, &space, config);
            Candidate {
                worth: worth_to(&judge, &plan),
                plan,
            }
        });
        (strategy, candidate)
    });
    Ok(candidates.collect())
}

/// Of some candidates the plan that is worth most.
///
/// # Errors
/// That of the first candidate, if none has a plan.
///
/// # Panics
/// Without any candidate.
pub(crate) fn most_worth<E>(
    candidates: impl IntoIterator<Item = Result<Candidate, E>>,
) -> Result<Plan, E> {
    let best = candidates
        .into_iter()
        .reduce(|best, next| match (&best, &next) {
            (Err(_), Ok(_)) => next,
            (Ok(a), Ok(b)) if b.worth > a.worth => next,
            _ => best,
        });
    let best = best.expect("there is more than one strategy");
    best.map(|candidate| candidate.plan)
}

/// A plan that is changed so that the tool comes to none of some places [m], such as those to which a robot does not lead it,
/// and brings as much as it can without.
///
/// # Errors
/// Geometry that the libraries refuse.
pub fn plan_around(
    task: &Task,
    dirt: &[ParticleDistribution],
    plan: &Plan,
    avoid: &[Point2],
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    let (task, few, space) = prepared(task, dirt)?;
    let begun_with = std::slice::from_ref(plan);
    let found = searched(&task, &few, &space, begun_with, Some(avoid), config);
    let found = found.unwrap_or_else(|| plan.clone());
    Ok(finished(found, &task, &space, config))
}

/// What a plan is predicted to be worth where dirt may lie like any of these, as [`Candidate::worth`] [1].
///
/// # Errors
/// Geometry that the libraries refuse.
pub fn worth(
    task: &Task,
    dirt: &[ParticleDistribution],
    plan: &Plan,
    search: &SearchConfig,
) -> Result<f64, PlanError> {
    let (task, few, space) = prepared(task, dirt)?;
    let judge = Judge::new(&task, &few, &space, search.margin_m, None);
    Ok(worth_to(&judge, plan))
}

/// The best plan for dirt of which `to_plan_on` is not yet where it belongs.
///
/// By a coverage strategy it is the one with the best predicted effect among `count` candidates, which differ in the
/// bandwidth of the density and in where strokes begin, and of equal ones that with the shortest way in contact; with a
/// count of 1 this is [`plan`]. By the others it is what the search finds.
///
/// # Errors
/// Those of [`plan`], if no candidate gives a plan.
pub fn best_plan(
    task: &Task,
    to_plan_on: &ParticleDistribution,
    config: &PlanConfig,
    count: usize,
) -> Result<Plan, PlanError> {
    fitting(config.strategy, task)?;
    let space = space_of(task)?;
    match config.strategy {
        Strategy::Coverage(_) | Strategy::Lanes => {
            let strategy = config.strategy.covering();
            let few = some_to_compare(task);
            let some = match task.action.treats() {
                true => to_plan_on.clone(),
                false => some_of(to_plan_on, MOST_COMPARED),
            };
            let plans = candidate_plans(&few, &some, &space, strategy, config, count)?;
            let plan = best_by_objective(&few, plans)
                .map_or_else(|| covering(&few, &space, strategy, config), Ok)?;
            let on = Task {
                particles: to_plan_on.clone(),
                ..task.clone()
            };
            Ok(finished(plan, &on, &space, config))
        }
        Strategy::Adaptive | Strategy::Best | Strategy::Own => {
            plan_for_any(task, std::slice::from_ref(&task.particles), config)
        }
    }
}

/// Whether a strategy plans the task's action.
fn fitting(strategy: Strategy, task: &Task) -> Result<(), PlanError> {
    let action = task.action;
    if strategy.fits(action) {
        Ok(())
    } else {
        Err(PlanError::StrategyDoesNotFit {
            strategy: strategy.as_str(),
            fitting: Strategy::names_for(action),
            action,
        })
    }
}

/// The plan of one strategy; none is [`Strategy::Best`] by itself.
fn one_by(
    strategy: Strategy,
    task: &Task,
    dirt: &[ParticleDistribution],
    space: &FreeSpace,
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    match strategy {
        Strategy::Coverage(_) | Strategy::Lanes => {
            covering(task, space, strategy.covering(), config)
        }
        Strategy::Adaptive | Strategy::Best | Strategy::Own => adaptive(task, dirt, space, config),
    }
}

/// The task with the first of these for its dirt, as much of each as strokes are searched for with, and the free space.
fn prepared(
    task: &Task,
    dirt: &[ParticleDistribution],
) -> Result<(Task, Vec<ParticleDistribution>, FreeSpace), PlanError> {
    let dirt = match dirt {
        [] => std::slice::from_ref(&task.particles),
        some => some,
    };
    let of_first = Task {
        particles: dirt[0].clone(),
        ..task.clone()
    };
    Ok((
        of_first,
        dirt.iter()
            .map(|dirt| some_of(dirt, MAX_PARTICLES))
            .collect(),
        space_of(task)?,
    ))
}

/// The plan no longer than it may be, with what share of the task's dirt no pose of the tool covers.
fn finished(plan: Plan, task: &Task, space: &FreeSpace, config: &PlanConfig) -> Plan {
    let places: Vec<Point2> = task.particles.remaining().collect();
    let plan = match config.max_distance {
        Some(most) if plan.contact_distance() > most => plan.cut_off(most),
        _ => plan,
    };
    Plan {
        unreachable_share: space.out_of_reach(&places, &task.tool.footprint),
        ..plan
    }
}

/// Strokes that are searched for, begun with those of coverage strategies for the task's dirt.
fn adaptive(
    task: &Task,
    dirt: &[ParticleDistribution],
    space: &FreeSpace,
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    let first = dirt.first().unwrap_or(&task.particles);
    let task = &Task {
        particles: first.clone(),
        ..task.clone()
    };
    let mut begun_with = Vec::new();
    let mut failure = None;
    for (strategy, count) in BEGUN_WITH {
        match candidate_plans(task, first, space, strategy, config, count) {
            Ok(plans) => begun_with.extend(plans),
            Err(error) => {
                failure.get_or_insert(error);
            }
        }
    }
    match searched(task, dirt, space, &begun_with, None, config) {
        Some(plan) => Ok(plan),
        None => Err(failure.unwrap_or_else(|| PlanError::NoFreeNode {
            surface: task.surface.name.clone(),
            diameter: 2.0 * space.radius(),
        })),
    }
}
