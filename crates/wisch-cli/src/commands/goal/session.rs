//! Executes the steps of a goal in the order of least expected time, and plans anew when a step fails.

use super::super::interrupt::say_which_part;
use super::super::swept::SweptSurface;
use super::super::wipe::SurfaceOutcome;
use super::super::words::{internal, percent};
use super::summary::{
    AssumedTimes, CHANGE, EMPTY, GoalPart, GoalSummary, SCHEMA, SPEED, TakenStep,
};
use super::summary::{describe_sequence, describe_step, measure_time};
use super::task::{Expected, GoalTask, KeptPlan};
use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use wisch::geometry::Point2;
use wisch::goal::{GoalLiteral, Sequence, Situation, Step, StepPlace, StepTimes, Wiping};
use wisch::represent::Action;
use wisch_io::{PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, path_in_results};

/// Number of tries of a wiping action before it is ruled out.
const TRIES: u32 = 2;

/// A run of the steps of a goal.
pub struct GoalRun<'a> {
    task: &'a GoalTask<'a>,
    situation: Situation<'a>,
    /// The plans of the possible actions that no step has tried.
    plans: BTreeMap<Wiping, KeptPlan<'a>>,
    is_executed: bool,
    out: PathBuf,
    steps: Vec<TakenStep>,
    tries: BTreeMap<Wiping, u32>,
    /// Wiping actions whose goals were not met when they were last tried or predicted.
    unmet: BTreeSet<Wiping>,
    /// Folder of the last attempt at a medium on a surface, relative to the folder of results.
    last: BTreeMap<[String; 2], PathBuf>,
    /// Times of the motions of wiping actions that reached their goals, with all their tries [s].
    taken: BTreeMap<Wiping, f64>,
    /// The collected dirt: action, number of the step, and particle positions in the frame of the surface [m].
    heaps: Vec<(Wiping, usize, Vec<Point2>)>,
    /// Collected media that were wiped over, on their surfaces, with the reason.
    spoiled: BTreeMap<[String; 2], String>,
    /// Time of the steps so far [s].
    clock: f64,
    /// Computation time of the sequences.
    ordering: Duration,
}

/// Actual times of the wiping actions; an action that was not executed, or missed its goal, has none.
struct TakenTimes<'a> {
    task: &'a GoalTask<'a>,
    wipings: &'a BTreeMap<Wiping, f64>,
}

impl StepTimes for TakenTimes<'_> {
    fn wiping(&self, wiping: &Wiping) -> Option<f64> {
        self.wipings.get(wiping).copied()
    }

    fn handling(&self, name: &str) -> f64 {
        self.task.handling(name)
    }

    fn moving(&self, from: StepPlace<'_>, to: StepPlace<'_>) -> f64 {
        self.task.moving(from, to)
    }
}

/// Executes a wiping step, with its arguments, the folder of its results, and its plan if one is kept.
type WipeStep<'w, 'a> =
    dyn FnMut(&TaskArgs, &Path, Option<KeptPlan<'a>>) -> Result<SurfaceOutcome, Failure> + 'w;

impl<'a> GoalRun<'a> {
    /// Creates the run before its first step.
    ///
    /// `plans`: plans of the actions, for their steps. `is_executed`: whether steps are executed; otherwise each is assumed to
    /// succeed. `out`: folder of results.
    ///
    /// # Errors
    /// If the task does not fit the knowledge base.
    pub fn begin(
        task: &'a GoalTask<'a>,
        plans: BTreeMap<Wiping, KeptPlan<'a>>,
        is_executed: bool,
        out: PathBuf,
    ) -> Result<Self, Failure> {
        Ok(Self {
            task,
            plans,
            situation: task.situation()?,
            is_executed,
            out,
            steps: Vec::new(),
            tries: BTreeMap::new(),
            unmet: BTreeSet::new(),
            last: BTreeMap::new(),
            taken: BTreeMap::new(),
            heaps: Vec::new(),
            spoiled: BTreeMap::new(),
            clock: 0.0,
            ordering: Duration::ZERO,
        })
    }

    /// Executes the steps, and plans anew after a step that missed its goal.
    ///
    /// `wipe`: executes a wiping step. Returns the summary, and the failure of a step that ended the run.
    ///
    /// # Errors
    /// If planning fails, or if `wipe` fails before any wiping step is finished.
    pub fn run(
        mut self,
        wipe: &mut WipeStep<'_, 'a>,
    ) -> Result<(GoalSummary, Option<Failure>), Failure> {
        let mut sequence = self.plan_remaining_steps()?;
        let expected_s = sequence.time();
        remark(&describe_sequence(&sequence));
        let mut broken = None;
        while let Some(step) = sequence.steps.first().cloned() {
            let Some(wiping) = step.wiping.clone() else {
                self.situation.apply(&step);
                self.note(&step, step.time, None, 0);
                sequence.steps.remove(0);
                continue;
            };
            let (number, tries) = (self.steps.len() + 1, *self.tries.get(&wiping).unwrap_or(&0));
            let name = format!("step-{number}");
            let is_first = self.steps.iter().all(|step| step.summary.is_none());
            let folder = self.out.join(&name);
            say_which_part(format!("step {number}"), &self.out, &folder, !is_first);
            let args = self.task.build_part_arguments(
                &self.situation,
                &wiping,
                &self.list_dirt_settings(&wiping),
            )?;
            let plan = self.take_plan(&wiping);
            let wiped = match wipe(&args, &folder, plan) {
                Ok(wiped) => wiped,
                Err(failure) => {
                    let failure = failure.after(&format!("step {number}, {wiping}"));
                    if is_first {
                        return Err(failure);
                    }
                    let place = self.out.display();
                    remark(&format!(
                        "the steps before step {number} are finished, and their results are in {place}"
                    ));
                    broken = Some(failure);
                    break;
                }
            };
            let is_stopped = wiped.is_stopped;
            let is_reached = wiped.is_met || !self.is_executed;
            let has_moved = !self.is_executed || wiped.summary.execution.is_some();
            self.check_heaps(&wiping, number, &wiped.swept)?;
            if !wiped.is_met {
                self.unmet.insert(wiping.clone());
            } else {
                self.unmet.remove(&wiping);
            }
            // The way to the surface is not part of the motions.
            let way = step.time - self.task.wiping(&wiping).unwrap_or(step.time);
            let time = measure_time(&wiped.summary, self.is_executed);
            let took = time.map_or(step.time, |time| way + time);
            *self.taken.entry(wiping.clone()).or_default() += took - way;
            let fact = self.situation.find_effect_of(&wiping);
            self.note(&step, took, Some(wiped), tries);
            if let (Some(taken), Some(fact)) = (self.steps.last_mut(), fact) {
                taken.part = Some(fact.to_string());
            }
            let on = [wiping.medium.clone(), wiping.surface.clone()];
            self.last.insert(on, PathBuf::from(name));
            if is_reached {
                self.situation.apply(&step);
                sequence.steps.remove(0);
            } else {
                if has_moved {
                    self.situation.apply_missed(&step);
                }
                self.note_failure(&wiping, has_moved);
            }
            if is_stopped {
                remark(&format!(
                    "stopped at step {number}: the steps after it are not carried out"
                ));
                break;
            }
            if !is_reached {
                sequence = self.plan_remaining_steps()?;
            }
        }
        Ok((self.finish(expected_s), broken))
    }

    /// Takes the plan for the first try of a wiping action. The plans of other tools for its medium on its surface are for the
    /// dirt before this try, so they are dropped.
    fn take_plan(&mut self, wiping: &Wiping) -> Option<KeptPlan<'a>> {
        let plan = self.plans.remove(wiping);
        self.plans.retain(|other, _| {
            (&other.medium, &other.surface) != (&wiping.medium, &wiping.surface)
        });
        plan
    }

    /// Counts a try whose goal was not met, and rules out the actions that shall not be tried again.
    ///
    /// `has_moved`: whether the robot executed a motion in this try.
    fn note_failure(&mut self, wiping: &Wiping, has_moved: bool) {
        let is_unknown = self.steps.last().is_some_and(TakenStep::is_unknown);
        let tried = self.tries.entry(wiping.clone()).or_default();
        *tried += 1;
        let tried = *tried;
        // A new session knows where dirt is left only if it sees it.
        let is_retried =
            has_moved && self.task.observed.contains(wiping) && !wiping.action.treats();
        if is_retried && tried < TRIES {
            return;
        }
        let of_dirt = self.task.expected.keys().filter(|other| {
            *other == wiping
                || (!is_retried
                    && has_moved
                    && (&other.medium, &other.surface) == (&wiping.medium, &wiping.surface))
        });
        for other in of_dirt {
            self.situation.rule_out(other);
        }
        self.taken.remove(wiping);
        let why = if is_retried {
            "it is ruled out"
        } else if !has_moved {
            "it is ruled out, because another try would plan the same motion"
        } else {
            "it is ruled out, with all tools, because a new step would not know what is left to wipe"
        };
        let tries = if tried == 1 { "try" } else { "tries" };
        let missed = if is_unknown {
            "is not known to have reached its goal"
        } else {
            "has not reached its goal"
        };
        remark(&format!(
            "{wiping} {missed} after {tried} {tries}: {why}; the other steps are planned anew"
        ));
    }

    /// Notes the dirt that a step has collected, and checks whether its strokes passed over dirt that earlier steps collected on
    /// this surface.
    fn check_heaps(
        &mut self,
        wiping: &Wiping,
        number: usize,
        swept: &SweptSurface,
    ) -> Result<(), Failure> {
        for (collecting, step, heap) in &self.heaps {
            let is_beside =
                collecting.surface == wiping.surface && collecting.medium != wiping.medium;
            if !is_beside || !self.task.is_spoiled(collecting, heap, swept)? {
                continue;
            }
            let share = percent(swept.share_covered(heap).map_err(internal)?);
            let on = [&collecting.medium, &collecting.surface];
            let why = format!(
                "step {number}, {wiping}, passes over {share} of the {} that step {step} has collected",
                on[0]
            );
            remark(&why);
            self.situation.note_spoiled(on[0], on[1]);
            self.spoiled.insert(on.map(String::clone), why);
        }
        if wiping.action == Action::Collect {
            self.heaps.retain(|(other, _, _)| {
                (&other.medium, &other.surface) != (&wiping.medium, &wiping.surface)
            });
            self.heaps
                .push((wiping.clone(), number, swept.collected.clone()));
        }
        Ok(())
    }

    /// Plans the remaining steps from the present situation and place.
    fn plan_remaining_steps(&mut self) -> Result<Sequence, Failure> {
        let last = self.steps.last().map(|step| step.place());
        let place = match &last {
            Some((true, name)) => StepPlace::Surface(name),
            Some((false, name)) => StepPlace::Rack(name),
            None => StepPlace::Start,
        };
        let began = Instant::now();
        let sequence = self.task.plan(&self.situation, place);
        self.ordering += began.elapsed();
        sequence
    }

    /// Returns settings of the task for the dirt that an earlier attempt has left; none without an earlier attempt.
    fn list_dirt_settings(&self, wiping: &Wiping) -> Vec<(&'static str, String)> {
        let on = [wiping.medium.clone(), wiping.surface.clone()];
        let Some(earlier) = self.last.get(&on) else {
            return Vec::new();
        };
        let file = |name: &str| {
            let path = self.out.join(earlier).join(path_in_results(name));
            let path = std::path::absolute(&path).unwrap_or(path);
            path.exists().then(|| {
                let path = serde_json::Value::from(path.display().to_string());
                format!("{{ source = \"csv\", file = {path} }}")
            })
        };
        let mut settings = Vec::new();
        if let Some(believed) = file(PARTICLES_ESTIMATED_FILE) {
            settings.push(("particles", believed));
        }
        if let Some(real) = file(PARTICLES_TRUE_FILE) {
            settings.push(("execution.dirt", real));
        }
        settings
    }

    /// Adds a step to those that were taken. `took`: its time [s].
    fn note(&mut self, step: &Step, took: f64, wiped: Option<SurfaceOutcome>, earlier_tries: u32) {
        self.steps.push(TakenStep {
            step: step.to_string(),
            part: None,
            words: describe_step(step),
            expected_s: step.time,
            began_s: self.clock,
            took_s: took,
            goal_met: (wiped.as_ref())
                .filter(|wiped| wiped.summary.prediction.is_some())
                .map(|wiped| wiped.is_met),
            earlier_tries,
            summary: wiped.map(|wiped| wiped.summary),
        });
        self.clock += took;
    }

    /// Returns the summary. `expected_s`: expected time of the first sequence [s].
    fn finish(self, expected_s: f64) -> GoalSummary {
        let file = self.task.file;
        let best_order = self.find_best_order();
        let open = self.task.plan(&self.situation, StepPlace::Start);
        let left_out = open.map(|sequence| sequence.left_out).unwrap_or_default();
        let parts: Vec<GoalPart> = (file.goal.parts())
            .map(|(holds, fact)| {
                let part = if holds {
                    fact.to_string()
                } else {
                    format!("(not {fact})")
                };
                let spoiled = self
                    .spoiled
                    .iter()
                    .find(|(on, _)| fact.arguments() == &on[..]);
                let spoiled = spoiled.map(|(_, why)| why.clone());
                let reason = left_out.iter().find(|(left, _)| *left == part);
                let reason = reason.map(|(_, reason)| self.explain(fact, reason));
                // Without an execution, a step is assumed to succeed; its prediction may say otherwise.
                let unmet = self.unmet.iter().find(|wiping| {
                    self.situation.find_effect_of(wiping).as_ref() == Some(fact)
                        || (!holds && fact.arguments() == [wiping.surface.clone()])
                });
                let unmet =
                    unmet.map(|wiping| format!("{wiping}: its goal is not predicted to be met"));
                GoalPart {
                    holds: self.situation.holds(fact) == holds && unmet.is_none(),
                    left_out: spoiled.or(reason).or(unmet),
                    part,
                }
            })
            .collect();
        GoalSummary {
            format: "wisch-steps",
            schema: SCHEMA,
            task: file.name.clone(),
            goal: file.goal.to_string(),
            goal_met: parts.iter().all(|part| part.holds),
            is_executed: self.is_executed,
            is_predicted: (self.steps.iter().filter_map(|step| step.summary.as_ref()))
                .all(|summary| summary.prediction.is_some()),
            expected_s,
            took_s: self.clock,
            ordering_s: self.ordering.as_secs_f64(),
            best_order_s: best_order,
            assumed: AssumedTimes {
                fetch_or_put_back_s: CHANGE,
                empty_s: EMPTY,
                speed_m_per_s: SPEED,
            },
            parts,
            steps: self.steps,
            expected_actions: self.task.expected_actions(),
            out: self.out.display().to_string(),
        }
    }

    /// Returns the least time of any order of the steps that reached their goals, with the times that they took [s].
    fn find_best_order(&self) -> Option<f64> {
        let taken = TakenTimes {
            task: self.task,
            wipings: &self.taken,
        };
        let situation = self.task.file.situation().ok()?;
        let sequence = situation.plan(&self.task.file.goal, StepPlace::Start, &taken);
        sequence.ok().map(|sequence| sequence.time())
    }

    /// Explains why no step reaches a fact: by the actions that could reach it and are impossible or failed, otherwise by
    /// `reason`.
    fn explain(&self, fact: &GoalLiteral, reason: &str) -> String {
        let names = fact.arguments();
        let of_fact = self.task.expected.iter().filter_map(|(wiping, expected)| {
            let serves = self.situation.find_effect_of(wiping).as_ref() == Some(fact)
                || (names == [wiping.surface.clone()]);
            match expected {
                Expected::Impossible(why) if serves => Some(format!("{wiping}: {why}")),
                _ if serves && self.tries.contains_key(wiping) => {
                    let is_it = |step: &&TakenStep| step.words == wiping.to_string();
                    let last = self.steps.iter().rfind(is_it);
                    Some(if last.is_some_and(TakenStep::is_unknown) {
                        format!("{wiping}: it is unknown whether its goal was reached")
                    } else {
                        format!("{wiping}: its goal was not reached")
                    })
                }
                _ => None,
            }
        });
        let why: Vec<String> = of_fact.collect();
        if why.is_empty() {
            reason.to_owned()
        } else {
            why.join("; ")
        }
    }
}
