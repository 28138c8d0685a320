//! The planner: one request, and the plan of any strategy that answers it.

use super::adaptive::{Valuation, score, search};
use super::bend::gap_in_hollow;
use super::candidates::{MOST_COMPARED, candidate_plans, reduce_for_comparison, varied_plans};
use super::objective::best_by_objective;
use super::policies::{plan_by_coverage, sample_particles, sample_task};
use super::subplans::{best_of, free_space_of};
use super::{CoverageStrategy, FreeSpace, Plan, PlanConfig, PlanError, PlanScore, Strategy};
use crate::geometry::Point2;
use crate::represent::{ParticleDistribution, Task};

/// Coverage strategies whose plans start the search for strokes, and the number of settings of each.
const START_PLANS: [(CoverageStrategy, usize); 2] =
    [(CoverageStrategy::Kde, 9), (CoverageStrategy::Grid, 1)];

/// Largest number of particles in the search for strokes; of more particles, a random subset is used.
const MAX_PARTICLES: usize = 250;

/// A plan and its predicted score.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The plan; its field `strategy` names the strategy that made it.
    pub plan: Plan,
    /// The plan's score.
    pub score: PlanScore,
}

/// For each strategy its candidate, or the reason why it has none, in the order of [`Strategy::ALL`].
pub type Portfolio = Vec<(Strategy, Result<Candidate, PlanError>)>;

/// Plans the wiping motion of a task for its particles, with [`Planner`].
///
/// ```
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::translation(0.5, 0.0, 0.8));
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(-0.1, 0.05), Point2::new(0.12, 0.1)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// // A task with two crumbs on a tray.
/// let plan = wisch::plan::plan(&task, &PlanConfig::default())?;
/// assert!(plan.contact_distance() > 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The errors of [`Planner::plan`].
pub fn plan(task: &Task, config: &PlanConfig) -> Result<Plan, PlanError> {
    Planner::new(task, config).plan()
}

/// A planner for one task: the task, the settings, and what is known of the dirt.
///
/// ```
/// use wisch::plan::{PlanConfig, Planner};
/// # fn shown(task: &wisch::represent::Task, config: &PlanConfig) -> Result<(), wisch::plan::PlanError> {
/// let planner = Planner::new(task, config);
/// for (strategy, candidate) in planner.plan_by_every_strategy()? {
///     match candidate {
///         Ok(candidate) => println!("{strategy:10} {:.3}", candidate.score.total),
///         Err(error) => println!("{strategy:10} {error}"),
///     }
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Planner<'a> {
    task: &'a Task,
    config: &'a PlanConfig,
    /// Possible distributions of the dirt; empty if the task's own particles are certain.
    dirt: &'a [ParticleDistribution],
    /// The dirt that is not yet where it belongs; `None` means all of the task's dirt.
    remaining: Option<&'a ParticleDistribution>,
}

impl<'a> Planner<'a> {
    /// Returns a planner for which the task's particles are the known dirt.
    pub fn new(task: &'a Task, config: &'a PlanConfig) -> Self {
        Self {
            task,
            config,
            dirt: &[],
            remaining: None,
        }
    }

    /// Returns a planner for dirt of which several distributions are possible. Coverage strategies
    /// plan for the first distribution alone.
    ///
    /// With several distributions, each simulation holds the tool a little differently, gives heaps a depth and
    /// begins contact late. A plan that is right to the millimetre for only one of them then scores less.
    #[must_use]
    pub fn with_possible_dirt(self, dirt: &'a [ParticleDistribution]) -> Self {
        Self { dirt, ..self }
    }

    /// Returns a planner that places the nodes of coverage strategies on the remaining dirt alone.
    ///
    /// `remaining`: the part of the task's dirt that is not yet where it belongs.
    #[must_use]
    pub fn with_remaining(self, remaining: &'a ParticleDistribution) -> Self {
        let remaining = Some(remaining);
        Self { remaining, ..self }
    }

    /// Plans by the configured strategy; [`Strategy::Best`] plans by all and takes the best.
    ///
    /// # Errors
    /// [`PlanError::StrategyDoesNotFit`], [`PlanError::NoFreeNode`], [`PlanError::GoalOffSurface`],
    /// [`PlanError::GoalNotFree`], [`PlanError::NoSkimEdge`], or an error about the geometry, such
    /// as [`PlanError::Scene`].
    pub fn plan(&self) -> Result<Plan, PlanError> {
        let (strategy, config) = (self.config.strategy, self.config);
        check_fits(strategy, self.task)?;
        if strategy == Strategy::Best {
            let candidates = self.plan_by_every_strategy()?;
            return highest_score(candidates.into_iter().map(|(_, candidate)| candidate));
        }
        let prepared = self.prepare()?;
        let plan = plan_by(strategy, &prepared, config)?;
        Ok(finish(plan, self.task, &prepared.space, config))
    }

    /// Plans by the configured strategy with several settings. A coverage strategy tries `count` settings,
    /// which differ in the bandwidth of the density and in the start of the strokes. It keeps the plan with the
    /// best predicted effect; of equal plans the one with the shortest path in contact. Strategies that search
    /// ignore `count`.
    ///
    /// # Errors
    /// The errors of [`Self::plan`], if no setting gives a plan.
    pub fn plan_best(&self, count: usize) -> Result<Plan, PlanError> {
        let (task, config) = (self.task, self.config);
        check_fits(config.strategy, task)?;
        if config.strategy.turns_tool() {
            return self.plan();
        }
        let space = free_space_of(task)?;
        let remaining = self.remaining.unwrap_or(&task.particles);
        let strategy = config.strategy.covering();
        let few = reduce_for_comparison(task);
        let on = Task {
            particles: remaining.clone(),
            ..task.clone()
        };
        let open = reduce_for_comparison(&on);
        let plans = candidate_plans(&few, &open, &space, strategy, config, count)?;
        let plan = best_by_objective(&few, plans)
            .map_or_else(|| plan_by_coverage(&few, &space, strategy, config), Ok)?;
        Ok(finish(plan, &on, &space, config))
    }

    /// Returns the best subplan ([`Self::best_subplan`]) of the plans of a coverage strategy with `count`
    /// settings.
    ///
    /// # Errors
    /// The errors of [`Self::plan`], if no setting gives a plan.
    pub fn plan_best_subplan(&self, count: usize) -> Result<Plan, PlanError> {
        let space = free_space_of(self.task)?;
        let task = &reduce_for_comparison(self.task);
        let remaining = self.remaining.unwrap_or(&self.task.particles);
        let on = Task {
            particles: remaining.clone(),
            ..self.task.clone()
        };
        let open = sample_task(&on, MOST_COMPARED);
        let strategy = self.config.strategy.covering();
        let plans = varied_plans(&open, &space, strategy, self.config, count)?;
        Ok(best_of(task, &plans, &space))
    }

    /// Reduces a plan to the subplan with the largest predicted gain; to no stroke, if no subplan gains
    /// anything.
    ///
    /// A subplan is useful by itself. Of a tree it is the path from any node to the goal, along the tree or
    /// straight, because half of that path would bring nothing to where it belongs. Of a tour it is a piece of
    /// three tool widths. The gain is the predicted number of particles that reach the goal, less several for
    /// each that falls over a wrong edge; of equal subplans the shorter wins. Paper §4.3.
    ///
    /// # Errors
    /// [`PlanError::Scene`], or another error about the geometry.
    pub fn best_subplan(&self, plan: &Plan) -> Result<Plan, PlanError> {
        let plans = std::slice::from_ref(plan);
        Ok(best_of(self.task, plans, &free_space_of(self.task)?))
    }

    /// Plans by every strategy that fits the action, and scores each plan.
    ///
    /// # Errors
    /// [`PlanError::Scene`], or another error about the geometry.
    pub fn plan_by_every_strategy(&self) -> Result<Portfolio, PlanError> {
        let prepared = self.prepare()?;
        let (task, config) = (&prepared.task, self.config);
        let valuation = prepared.valuation(config);
        let strategies = (Strategy::ALL.into_iter())
            .filter(|&strategy| strategy != Strategy::Best && strategy.fits(task.action));
        let candidates = strategies.map(|strategy| {
            let plan = plan_by(strategy, &prepared, config);
            let candidate = plan.map(|plan| {
                let plan = finish(plan, self.task, &prepared.space, config);
                let score = score(&valuation, &plan);
                Candidate { plan, score }
            });
            (strategy, candidate)
        });
        Ok(candidates.collect())
    }

    /// Changes a plan so that the tool avoids some places, for example places out of the robot's reach, and
    /// brings as much dirt as it can without them.
    ///
    /// # Parameters
    /// `avoid`: the places, in the surface frame \[m\].
    ///
    /// # Errors
    /// [`PlanError::Scene`], or another error about the geometry.
    pub fn plan_around(&self, plan: &Plan, avoid: &[Point2]) -> Result<Plan, PlanError> {
        let Prepared {
            of_few, few, space, ..
        } = self.prepare()?;
        let begun_with = std::slice::from_ref(plan);
        let found = search(&of_few, &few, &space, begun_with, Some(avoid), self.config);
        let found = found.unwrap_or_else(|| plan.clone());
        Ok(finish(found, self.task, &space, self.config))
    }

    /// Returns the score of a plan, as the mean over all possible distributions of the dirt.
    ///
    /// # Errors
    /// [`PlanError::Scene`], or another error about the geometry.
    pub fn score(&self, plan: &Plan) -> Result<PlanScore, PlanError> {
        Ok(score(&self.prepare()?.valuation(self.config), plan))
    }

    /// Prepares the planning for all possible distributions.
    fn prepare(&self) -> Result<Prepared, PlanError> {
        let dirt = match self.dirt {
            [] => std::slice::from_ref(&self.task.particles),
            some => some,
        };
        let few = dirt
            .iter()
            .map(|dirt| sample_particles(dirt, MAX_PARTICLES));
        let few: Vec<ParticleDistribution> = few.collect();
        let count = |dirt: &[ParticleDistribution]| -> usize {
            dirt.iter().map(ParticleDistribution::len).sum()
        };
        let share = count(&few) as f64 / count(dirt).max(1) as f64;
        let task = Task {
            particles: dirt[0].clone(),
            ..self.task.clone()
        };
        Ok(Prepared {
            of_few: Task {
                mobility: task.mobility.sample(share),
                ..task.clone()
            },
            task,
            few,
            space: free_space_of(self.task)?,
        })
    }
}

/// The inputs of planning for several possible distributions of the dirt.
struct Prepared {
    /// The task with the first of the distributions.
    task: Task,
    /// The same task, with the mobility that particles of the subsets have.
    of_few: Task,
    /// A subset of each distribution for the search.
    few: Vec<ParticleDistribution>,
    space: FreeSpace,
}

impl Prepared {
    fn valuation(&self, config: &PlanConfig) -> Valuation<'_> {
        let margin = config.search.margin_m;
        Valuation::new(&self.of_few, &self.few, &self.space, margin, None)
    }
}

/// Returns the plan with the highest score among some candidates.
///
/// # Errors
/// The error of the first candidate, if none has a plan.
///
/// # Panics
/// If there is no candidate.
pub(crate) fn highest_score<E>(
    candidates: impl IntoIterator<Item = Result<Candidate, E>>,
) -> Result<Plan, E> {
    let best = candidates
        .into_iter()
        .reduce(|best, next| match (&best, &next) {
            (Err(_), Ok(_)) => next,
            (Ok(a), Ok(b)) if b.score.total > a.score.total => next,
            _ => best,
        });
    let best = best.expect("there is more than one strategy");
    best.map(|candidate| candidate.plan)
}

/// Returns an error for a strategy that does not plan the task's action.
fn check_fits(strategy: Strategy, task: &Task) -> Result<(), PlanError> {
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

/// Plans by one strategy, which must not be [`Strategy::Best`].
fn plan_by(
    strategy: Strategy,
    prepared: &Prepared,
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    let Prepared {
        task,
        of_few,
        few,
        space,
    } = prepared;
    match strategy {
        Strategy::Coverage(_) | Strategy::Lanes => {
            plan_by_coverage(task, space, strategy.covering(), config)
        }
        Strategy::Adaptive | Strategy::Best | Strategy::Own => {
            search_strokes(of_few, few, space, config)
        }
    }
}

/// Cuts a plan to the longest distance allowed, and computes the share of the task's dirt that the
/// tool cannot cover.
fn finish(plan: Plan, task: &Task, space: &FreeSpace, config: &PlanConfig) -> Plan {
    let plan = match config.max_distance {
        Some(most) if plan.contact_distance() > most => plan.truncate(most),
        _ => plan,
    };
    Plan {
        unreachable_share: unreachable_share(task, space),
        ..plan
    }
}

fn unreachable_share(task: &Task, space: &FreeSpace) -> f64 {
    let places: Vec<Point2> = task.particles.remaining().collect();
    space.unreachable_share(&places, &task.tool.footprint, &gap_in_hollow(task))
}

/// Returns the share of a task's dirt that its tool can cover from no free place of the surface,
/// under any plan \[1\].
///
/// # Errors
/// [`PlanError::Scene`], or another error about the geometry, as for [`plan`].
///
/// ```
/// use wisch::plan::find_unreachable_share;
/// use wisch::prelude::*;
///
/// let board = Surface::new("board", Polygon::rectangle(Vector2::new(0.4, 0.3)), Pose::identity());
/// let sponge = Tool::pad("sponge", Vector3::new(0.06, 0.1, 0.05))?;
/// let dirt = ParticleDistribution::new(&[Point2::new(0.1, 0.0)])?;
/// let task = Task::new(Action::Absorb, board, sponge, "crumbs", dirt);
/// assert_eq!(find_unreachable_share(&task)?, 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn find_unreachable_share(task: &Task) -> Result<f64, PlanError> {
    Ok(unreachable_share(task, &free_space_of(task)?))
}

/// Searches for strokes, starting from plans of coverage strategies for the task's dirt.
fn search_strokes(
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
    for (strategy, count) in START_PLANS {
        match candidate_plans(task, task, space, strategy, config, count) {
            Ok(plans) => begun_with.extend(plans),
            Err(error) => {
                failure.get_or_insert(error);
            }
        }
    }
    match search(task, dirt, space, &begun_with, None, config) {
        Some(plan) => Ok(plan),
        None => Err(failure.unwrap_or_else(|| space.explain_no_free_node())),
    }
}
