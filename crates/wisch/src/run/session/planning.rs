//! The choice of the next plan in a session.

use super::Session;
use crate::plan::{
    Plan, PlanConfig, PlanError, Planner, Strategy, has_predicted_gain, highest_score,
};
use crate::recover::{PLANNING_DRAWS, Pace, recovery_candidate_count, remaining_dirt};
use crate::represent::{ParticleDistribution, Task};
use crate::run::considered::{evaluate_motions, evaluate_plans, evaluate_within_reach};
use crate::run::{CandidateEvaluation, Observer, PlannedRound, RunError, RunEvent, ignore_events};

/// The plan of the next round.
#[derive(Debug)]
pub(super) enum NextPlan {
    /// A plan for which no motion was computed yet.
    Alone(Plan),
    /// A plan with its motion, and the numbers of nodes that the computation of the motion passed.
    Followed(Box<PlannedRound>, Vec<usize>),
}

impl NextPlan {
    /// Takes a plan that was chosen with its motion.
    fn from_chosen(planned: Box<PlannedRound>) -> Self {
        let strokes = planned.plan.strokes.iter();
        let nodes = strokes.map(|stroke| stroke.nodes.len()).sum();
        Self::Followed(planned, vec![nodes])
    }

    pub(super) fn plan(&self) -> &Plan {
        match self {
            Self::Alone(plan) => plan,
            Self::Followed(planned, _) => &planned.plan,
        }
    }
}

impl Session<'_> {
    /// Plans the rest of the task. In later rounds, returns `None` if no plan has a predicted gain.
    pub(super) fn next_plan(
        &mut self,
        observer: &mut Observer<'_>,
    ) -> Result<Option<NextPlan>, RunError> {
        if let Some(next) = self.take_first_plan(observer) {
            return Ok(Some(next));
        }
        let (task, config) = (&self.task, &self.config);
        if let (Some(own), None) = (&self.own, &self.given) {
            let plan = own.plan(task, config.plan.lift_height)?;
            let is_wanted = self.goal.is_none() || has_predicted_gain(task, &plan);
            return Ok(is_wanted.then_some(NextPlan::Alone(plan)));
        }
        let whole = match (self.given.take(), self.goal.as_ref()) {
            (Some(plan), _) => NextPlan::Alone(plan),
            (None, None) if config.plan.strategy.is_searched() => self.searched_plan(observer)?,
            (None, None) => {
                let variants = if self.first_observation().is_some() {
                    // A plan for observed dirt is chosen among several by its prediction, like a plan for
                    // remaining dirt.
                    let more = recovery_candidate_count(&task.tool.footprint);
                    config.variants.max(more)
                } else {
                    config.variants
                };
                NextPlan::Alone(Planner::new(task, &config.plan).plan_best(variants)?)
            }
            (None, Some(goal)) => {
                let treated = task.treatment.and_then(|_| self.belief.median_passes());
                let is_treated = treated.is_some();
                let particles = match treated {
                    Some(places) => places,
                    None => self.belief.draw_mixture(PLANNING_DRAWS, task.seed)?,
                };
                let members = self.belief.members();
                let of_all: usize = members.iter().map(ParticleDistribution::len).sum();
                let worlds = (particles.len() * members.len()) as f64 / of_all.max(1) as f64;
                let task = &Task {
                    particles,
                    mobility: task.mobility.sample(worlds),
                    ..task.clone()
                };
                let mut open = remaining_dirt(task, goal)?;
                if is_treated {
                    // The round covers only places where the belief predicts missing treatment.
                    if open.is_empty() {
                        return Ok(None);
                    }
                    // Finished places still limit the number of passes.
                    open = task.particles.clone();
                }
                let left = PlanConfig {
                    strategy: Strategy::for_what_is_left(task.action),
                    seed: task.seed,
                    ..config.plan.clone()
                };
                let planner = Planner::new(task, &left).with_remaining(&open);
                let count = recovery_candidate_count(&task.tool.footprint);
                let next = match config.pace {
                    Pace::Whole if config.plan.strategy.is_searched() => {
                        self.searched_plan(observer)?
                    }
                    Pace::Whole => match planner.plan_best(count) {
                        // Every pass over the missing places would give too many passes to finished places.
                        Err(PlanError::NoFreeNode { .. }) if is_treated => return Ok(None),
                        plan => NextPlan::Alone(plan?),
                    },
                    Pace::Greedy => NextPlan::Alone(planner.plan_best_subplan(count)?),
                };
                return Ok(Some(next).filter(|next| has_predicted_gain(task, next.plan())));
            }
        };
        Ok(Some(match config.pace {
            Pace::Whole => whole,
            Pace::Greedy => {
                let planner = Planner::new(task, &config.plan);
                NextPlan::Alone(planner.best_subplan(whole.plan())?)
            }
        }))
    }

    /// Evaluates the plans of all strategies for the believed dirt, including strategies that the
    /// session does not use. With a robot, each plan is evaluated as the robot executes it.
    ///
    /// # Errors
    /// [`RunError::Plan`] for geometry that the libraries refuse.
    pub fn evaluate_candidates(&self) -> Result<Vec<CandidateEvaluation>, RunError> {
        let (considered, _) = self.consider_plans()?;
        Ok(considered)
    }

    /// Evaluates the candidates as [`Self::evaluate_candidates`] does, and also returns the motion
    /// of the plan with the highest score, if the session has a robot.
    fn consider_plans(
        &self,
    ) -> Result<(Vec<CandidateEvaluation>, Option<Box<PlannedRound>>), RunError> {
        let (task, dirt, config) = (&self.task, self.dirt(), &self.config.plan);
        let planner = Planner::new(task, config).with_possible_dirt(&dirt);
        let portfolio = planner.plan_by_every_strategy()?;
        Ok(match self.performer {
            Some(_) => evaluate_motions(&planner, portfolio, |plan| {
                self.compute_motion(plan, &mut ignore_events)
            }),
            None => (evaluate_plans(task, portfolio), None),
        })
    }

    /// The possible distributions of the dirt.
    fn dirt(&self) -> Vec<ParticleDistribution> {
        self.belief.draw_members(PLANNING_DRAWS, self.task.seed)
    }

    /// Returns a plan for all distributions that the belief holds possible. [`Strategy::Best`] takes the plan
    /// with the highest score on the robot.
    fn searched_plan(&self, observer: &mut Observer<'_>) -> Result<NextPlan, RunError> {
        let (task, dirt, config) = (&self.task, self.dirt(), &self.config.plan);
        if config.strategy == Strategy::Best {
            let (considered, best) = self.consider_plans()?;
            let _ = observer(&RunEvent::Evaluated {
                round: self.number(),
                considered: &considered,
            });
            return Ok(match best {
                Some(planned) => NextPlan::from_chosen(planned),
                None => NextPlan::Alone(highest_score(
                    considered.into_iter().map(|one| one.candidate),
                )?),
            });
        }
        let planner = Planner::new(task, config).with_possible_dirt(&dirt);
        let plan = planner.plan()?;
        if self.performer.is_none() {
            return Ok(NextPlan::Alone(plan));
        }
        let follow = |plan| self.compute_motion(plan, &mut ignore_events);
        let (_, round) = evaluate_within_reach(&planner, plan, &follow)?;
        Ok(NextPlan::from_chosen(Box::new(round)))
    }
}
