//! `--budget`: the number of plans that a search tries, also computed from a time.

use super::prepare::{self, stage_failure};
use super::words::format_count;
use crate::args::{Budget, TaskArgs};
use crate::failure::Failure;
use crate::terminal::remark;
use std::time::Instant;
use wisch::plan::Strategy;
use wisch::run::{NoExecutor, RunError, Session, Stage, ignore_events};
use wisch_io::{KeptFiles, LoadedTask};

/// Numbers of plans in the trial searches that measure this machine's speed.
const TRIED: [usize; 4] = [250, 1_000, 4_000, 16_000];
/// Share of the time at which a trial search is long enough to measure by [1].
const TRIAL_SHARE: f64 = 0.2;
/// Inverse of the relative step to which numbers of plans are rounded.
const STEPS: f64 = 20.0;

/// Returns the arguments with the budget as a setting `plan.evaluations`, so that a run's record states it.
///
/// `kept`: copies in place of the files that the task file names.
pub(super) fn in_evaluations(args: &TaskArgs, kept: &KeptFiles) -> Result<TaskArgs, Failure> {
    let Some(budget) = args.budget else {
        return Ok(args.clone());
    };
    let mut args = TaskArgs {
        budget: None,
        ..args.clone()
    };
    let prepared = prepare::load(&args, kept)?;
    let strategy = prepared.run.plan.strategy;
    if !matches!(strategy, Strategy::Adaptive | Strategy::Best) {
        let problem = format!("--budget has no effect: the strategy {strategy} does not search");
        let failure = Failure::new(problem).within(&args.task);
        return Err(failure.with_help("choose --strategy adaptive or best, or leave out --budget"));
    }
    let evaluations = match budget {
        Budget::Evaluations(evaluations) => evaluations,
        Budget::Time(time) => {
            let seconds = time.as_secs_f64();
            let pace =
                Pace::measured(&prepared, seconds).map_err(|error| stage_failure(&args, error))?;
            let evaluations = pace.count_affordable(seconds);
            let begun = pace.begun;
            remark(&if begun < seconds {
                format!(
                    "in {seconds} s this machine tries about {} after {begun:.1} s for the initial plans; \
                     --budget {evaluations} reproduces the plan",
                    format_count(evaluations as usize, "plan"),
                )
            } else {
                format!(
                    "--budget {seconds}s is too short on this machine: the initial plans alone take {begun:.1} s; \
                     --budget {evaluations} reproduces the plan"
                )
            });
            evaluations
        }
    };
    let setting = ("plan.evaluations".to_owned(), evaluations.to_string());
    args.settings.push(setting);
    Ok(args)
}

/// Duration of a search on this machine.
struct Pace {
    /// Time for the initial plans [s].
    begun: f64,
    /// Time for each further plan [s].
    each: f64,
}

impl Pace {
    /// Measures searches without a robot: one without further plans, and others until one takes a fifth of `seconds`. Time is linear
    /// in plans: `begun + each * plans`.
    fn measured(prepared: &LoadedTask, seconds: f64) -> Result<Self, RunError> {
        let belief = prepared.belief();
        let time = |evaluations: usize| {
            let mut config = prepared.run.clone();
            config.plan.strategy = Strategy::Adaptive;
            config.plan.search.evaluations = evaluations;
            let mut session = Session::new(&prepared.task, config).with_belief(belief.clone());
            let begin = Instant::now();
            session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events)?;
            Ok::<_, RunError>(begin.elapsed().as_secs_f64())
        };
        let begun = time(1)?;
        let mut each = f64::EPSILON;
        if begun >= seconds {
            return Ok(Self { begun, each });
        }
        for tried in TRIED {
            let searching = time(tried)? - begun;
            each = (searching / (tried - 1) as f64).max(f64::EPSILON);
            if searching >= TRIAL_SHARE * seconds {
                break;
            }
        }
        Ok(Self { begun, each })
    }

    /// Returns the number of plans that fit into a time [s].
    fn count_affordable(&self, seconds: f64) -> u64 {
        round((seconds - self.begun) / self.each)
    }
}

/// Rounds a number of plans to about two digits, and clamps it to the limits of a task.
fn round(plans: f64) -> u64 {
    let plans = plans.clamp(1.0, 1e7);
    let step = 10_f64.powf((plans / STEPS).log10().floor()).max(1.0);
    ((plans / step).round() * step) as u64
}

#[cfg(test)]
mod tests {
    use super::{Pace, round};

    #[test]
    fn numbers_of_plans_are_round_and_within_what_a_task_takes() {
        let plans = [-5.0, 7.4, 123.0, 48_211.0, 3e9].map(round);
        assert_eq!(plans, [1, 7, 123, 48_000, 10_000_000]);
    }

    #[test]
    fn what_a_search_begins_with_takes_its_part_of_the_time() {
        let pace = Pace {
            begun: 0.5,
            each: 1e-5,
        };
        assert_eq!(pace.count_affordable(1.0), 50_000);
        assert_eq!(pace.count_affordable(0.4), 1);
    }
}
