//! What is considered before a plan is chosen: each candidate as a robot would do it.

use super::{PlannedRound, RunError};
use crate::plan::{Candidate, Plan, PlanScore, Planner, Portfolio, Prediction, Strategy, predict};
use crate::represent::Task;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};

/// What a robot may lose of a plan before other strokes are searched for, in shares of the dirt [1].
const LOST: f64 = 0.01;
/// How often strokes are searched for anew around the places where the robot failed.
const REPLANNED: usize = 3;

/// A plan that may be chosen, and what is expected of it.
#[derive(Debug, Clone)]
pub struct Considered {
    /// How its strokes were found.
    pub strategy: Strategy,
    /// The plan and its score; if a robot is to follow it, that of what it wipes, with the duration of its motion. Or why there is
    /// none, or no motion.
    pub candidate: Result<Candidate, RunError>,
    /// Its predicted effect on the task's dirt; `None` without a plan.
    pub prediction: Option<Prediction>,
    /// The robot's motion; `None` without a robot, or without a motion.
    pub motion: Option<ConsideredMotion>,
}

/// The motion of a robot that follows a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConsideredMotion {
    /// How long it takes [s].
    pub duration: f64,
    /// Nodes that it does not reach.
    pub abandoned: usize,
}

/// Each plan of a portfolio with what it is expected to do on its own.
pub(super) fn unfollowed(task: &Task, portfolio: Portfolio) -> Vec<Considered> {
    let considered = portfolio.into_iter().map(|(strategy, candidate)| {
        let plan = candidate.as_ref().ok().map(|candidate| &candidate.plan);
        Considered {
            strategy,
            prediction: plan.map(|plan| predict(task, plan, |_| ())),
            motion: None,
            candidate: candidate.map_err(RunError::from),
        }
    });
    considered.collect()
}

/// Each plan of a portfolio as the robot does it, and the motion of the one with the highest score. Plans are followed side by
/// side: the result is the same on any number of threads.
pub(super) fn followed(
    planner: &Planner<'_>,
    portfolio: Portfolio,
    follow: impl Fn(Plan) -> Result<PlannedRound, RunError> + Sync,
) -> (Vec<Considered>, Option<Box<PlannedRound>>) {
    let best: Mutex<Option<Best>> = Mutex::new(None);
    let considered = portfolio.into_par_iter().enumerate();
    let considered = considered.map(|(index, (strategy, candidate))| {
        let (mut prediction, mut motion) = (None, None);
        let candidate = candidate.map_err(RunError::from).and_then(|candidate| {
            let (score, round) = match strategy {
                Strategy::Adaptive => within_reach(planner, candidate.plan, &follow)?,
                _ => as_done(planner, candidate.plan, &follow)?,
            };
            motion = Some(ConsideredMotion {
                duration: round.followed.duration(),
                abandoned: round.followed.abandoned.len(),
            });
            prediction = Some(round.prediction.clone());
            let plan = round.plan.clone();
            let mut best = best.lock().unwrap_or_else(PoisonError::into_inner);
            if best
                .as_ref()
                .is_none_or(|best| best.is_surpassed(&score, index))
            {
                let round = Box::new(round);
                *best = Some(Best {
                    score,
                    index,
                    round,
                });
            }
            Ok(Candidate { plan, score })
        });
        Considered {
            strategy,
            candidate,
            prediction,
            motion,
        }
    });
    let considered = considered.collect();
    let best = best.into_inner().unwrap_or_else(PoisonError::into_inner);
    (considered, best.map(|best| best.round))
}

/// The plan with the highest score so far: of several the first in the portfolio.
struct Best {
    score: PlanScore,
    index: usize,
    round: Box<PlannedRound>,
}

impl Best {
    fn is_surpassed(&self, score: &PlanScore, index: usize) -> bool {
        let (next, best) = (score.total, self.score.total);
        next > best || (next == best && index < self.index)
    }
}

/// The score of a plan as the robot does it, and that.
fn as_done(
    planner: &Planner<'_>,
    plan: Plan,
    follow: &impl Fn(Plan) -> Result<PlannedRound, RunError>,
) -> Result<(PlanScore, PlannedRound), RunError> {
    let round = follow(plan)?;
    let score = planner.score(&round.wiped())?;
    Ok((score.with_motion(round.followed.duration()), round))
}

/// The same of a plan that is searched for: where the robot does not reach all of it, strokes are searched for that do
/// without the places where it failed.
pub(super) fn within_reach(
    planner: &Planner<'_>,
    plan: Plan,
    follow: &impl Fn(Plan) -> Result<PlannedRound, RunError>,
) -> Result<(PlanScore, PlannedRound), RunError> {
    let mut best = as_done(planner, plan, follow)?;
    let mut last = best.1.clone();
    let mut avoid = Vec::new();
    for _ in 0..REPLANNED {
        let wiped = last.wiped();
        let planned = planner.score(&last.plan)?.total;
        let lost = planned - planner.score(&wiped)?.total;
        if last.followed.abandoned.is_empty() && lost < LOST {
            break;
        }
        let failed = last.followed.abandoned.iter();
        avoid.extend(failed.map(|abandoned| last.plan.graph.position(abandoned.node)));
        let around = planner.plan_around(&wiped, &avoid)?;
        let next = as_done(planner, around, follow)?;
        last = next.1.clone();
        if next.0.total > best.0.total {
            best = next;
        }
    }
    Ok(best)
}
