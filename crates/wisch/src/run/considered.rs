//! Candidate evaluation: each plan as the robot would execute it.

use super::{PlannedRound, RunError};
use crate::plan::{Candidate, Plan, PlanScore, Planner, Portfolio, Prediction, Strategy, predict};
use crate::represent::Task;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Score that a plan may lose to the robot's limited reach, before the planner searches for other
/// strokes, in shares of the dirt [1].
const MAX_REACH_LOSS: f64 = 0.01;
/// Largest number of repeated searches around the places out of the robot's reach.
const MAX_REPLANS: usize = 3;

/// The evaluation of a candidate plan.
#[derive(Debug, Clone)]
pub struct CandidateEvaluation {
    /// The strategy that found its strokes.
    pub strategy: Strategy,
    /// The plan and its score. With a robot, the score counts the strokes within reach and the
    /// duration of the motion. The error is the reason why there is no plan, or no motion.
    pub candidate: Result<Candidate, RunError>,
    /// Predicted effect on the task's dirt; `None` without a plan.
    pub prediction: Option<Prediction>,
    /// The robot's motion; `None` without a robot, or without a motion.
    pub motion: Option<EvaluatedMotion>,
}

/// Key figures of the robot's motion for a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvaluatedMotion {
    /// Duration \[s\].
    pub duration: f64,
    /// Number of abandoned nodes.
    pub abandoned: usize,
}

/// Evaluates each plan of a portfolio by its predicted effect alone.
pub(super) fn evaluate_plans(task: &Task, portfolio: Portfolio) -> Vec<CandidateEvaluation> {
    let considered = portfolio.into_iter().map(|(strategy, candidate)| {
        let plan = candidate.as_ref().ok().map(|candidate| &candidate.plan);
        CandidateEvaluation {
            strategy,
            prediction: plan.map(|plan| predict(task, plan, |_| ())),
            motion: None,
            candidate: candidate.map_err(RunError::from),
        }
    });
    considered.collect()
}

/// Evaluates each plan of a portfolio as the robot executes it; also returns the motion of the plan with the
/// highest score. Plans are followed in parallel: the result is the same for any number of threads.
pub(super) fn evaluate_motions(
    planner: &Planner<'_>,
    portfolio: Portfolio,
    follow: impl Fn(Plan) -> Result<PlannedRound, RunError> + Sync,
) -> (Vec<CandidateEvaluation>, Option<Box<PlannedRound>>) {
    let best: Mutex<Option<Best>> = Mutex::new(None);
    let considered = portfolio.into_par_iter().enumerate();
    let considered = considered.map(|(index, (strategy, candidate))| {
        let (mut prediction, mut motion) = (None, None);
        let candidate = candidate.map_err(RunError::from).and_then(|candidate| {
            let (score, round) = match strategy {
                Strategy::Adaptive => evaluate_within_reach(planner, candidate.plan, &follow)?,
                _ => evaluate_motion(planner, candidate.plan, &follow)?,
            };
            motion = Some(EvaluatedMotion {
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
        CandidateEvaluation {
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

/// The plan with the highest score so far; of equal plans, the first in the portfolio.
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

/// Returns the motion for a plan, and the score of the part that the robot executes.
fn evaluate_motion(
    planner: &Planner<'_>,
    plan: Plan,
    follow: &impl Fn(Plan) -> Result<PlannedRound, RunError>,
) -> Result<(PlanScore, PlannedRound), RunError> {
    let round = follow(plan)?;
    let score = planner.score(&round.executable_plan())?;
    Ok((score.with_motion(round.followed.duration()), round))
}

/// Evaluates a plan of a search strategy as [`evaluate_motion`] does. If the robot does not reach
/// all of it, the search is repeated without the places out of reach, and the best result is kept.
pub(super) fn evaluate_within_reach(
    planner: &Planner<'_>,
    plan: Plan,
    follow: &impl Fn(Plan) -> Result<PlannedRound, RunError>,
) -> Result<(PlanScore, PlannedRound), RunError> {
    let mut best = evaluate_motion(planner, plan, follow)?;
    let mut last = best.1.clone();
    let mut avoid = Vec::new();
    for _ in 0..MAX_REPLANS {
        let wiped = last.executable_plan();
        let planned = planner.score(&last.plan)?.total;
        let lost = planned - planner.score(&wiped)?.total;
        if last.followed.abandoned.is_empty() && lost < MAX_REACH_LOSS {
            break;
        }
        let failed = last.followed.abandoned.iter();
        avoid.extend(failed.map(|abandoned| last.plan.graph.position(abandoned.node)));
        let around = planner.plan_around(&wiped, &avoid)?;
        let next = evaluate_motion(planner, around, follow)?;
        last = next.1.clone();
        if next.0.total > best.0.total {
            best = next;
        }
    }
    Ok(best)
}
