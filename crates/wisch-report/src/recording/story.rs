//! The summary at the end of a run: task, result, certainty, and what would narrow the interval.

use super::treated::Band;
use super::words;
use crate::draw::percent;
use crate::rounds::words::format_estimate;
use serde::Serialize;
use wisch::recover::Verdict;
use wisch::represent::Task;
use wisch::run::{Ending, Round};

/// How a run ended, for the last piece of a recording.
#[derive(Debug, Clone, Copy)]
pub struct RunOutcome<'a> {
    /// The task.
    pub task: &'a Task,
    /// Target performance, in [0, 1].
    pub target: f64,
    /// Whether the goal is met.
    pub is_met: bool,
    /// Predicted performance of the first round, in [0, 1].
    pub predicted: f64,
    /// The last round and the number of rounds; `None` if nothing was executed.
    pub last: Option<(&'a Round, usize)>,
    /// True performance after the last round, in [0, 1]; `None` without ground truth.
    pub truth: Option<f64>,
    /// Facts for the page: label, and value with unit.
    pub facts: &'a [(String, String)],
}

#[derive(Serialize)]
pub(super) struct Ended<'a> {
    piece: &'static str,
    met: bool,
    verdict: Option<&'static str>,
    story: Story,
    facts: &'a [(String, String)],
    episode: Option<&'a str>,
}

#[derive(Serialize)]
struct Story {
    asked: String,
    happened: String,
    sure: String,
    surer: String,
}

impl<'a> Ended<'a> {
    pub(super) fn new(outcome: &RunOutcome<'a>, episode: Option<&'a str>) -> Self {
        let task = words::describe_task(outcome.task, outcome.target);
        let story = match outcome.last {
            Some((last, rounds)) => summarise_execution(outcome, task, last, rounds),
            None => summarise_prediction(outcome, task),
        };
        Self {
            piece: "ended",
            met: outcome.is_met,
            verdict: outcome.last.map(|(last, _)| last.verdict.as_str()),
            story,
            facts: outcome.facts,
            episode,
        }
    }
}

fn summarise_execution(
    outcome: &RunOutcome<'_>,
    asked: String,
    last: &Round,
    rounds: usize,
) -> Story {
    let found = &last.interpretation;
    let rounds = match rounds {
        1 => "one round".to_owned(),
        many => format!("{many} rounds"),
    };
    let truth = outcome.truth.map_or_else(String::new, |share| {
        format!(" Ground truth in the simulated world: {}.", percent(share))
    });
    let senses = match found.observation {
        Some(_) => "touch and sight",
        None => "touch only",
    };
    Story {
        asked,
        happened: format!(
            "Estimated performance after {rounds}: {}{} ({}).",
            percent(found.performance.mean),
            describe_treatment(outcome.task, last).unwrap_or_default(),
            match (last.verdict, &last.execution.ending) {
                (Verdict::Again, Ending::Stopped) => "the run was stopped",
                (Verdict::Again, _) => "the limit of rounds is reached",
                (verdict, _) => verdict.as_str(),
            }
        ),
        sure: format!(
            "Estimated from {senses}: {}.{truth}",
            format_estimate(found.performance)
        ),
        surer: words::suggest_measures(last),
    }
}

/// States what the estimate counts on a treated surface; `None` for dirt.
fn describe_treatment(task: &Task, last: &Round) -> Option<String> {
    let band = Band::new(task)?;
    let belief = &last.interpretation.belief;
    let treatment = task.treatment?;
    let above = (belief.members().iter().zip(belief.weights()))
        .map(|(places, weight)| Some(weight * treatment.share_above_limit(places)?))
        .sum::<Option<f64>>();
    let done = format!(" of the surface points have {}", band.describe_done());
    Some(match above {
        Some(share) => format!("{done}, {} have {}", percent(share), band.describe_excess()),
        None => done,
    })
}

fn summarise_prediction(outcome: &RunOutcome<'_>, asked: String) -> Story {
    Story {
        asked,
        happened: format!(
            "Nothing was executed. Predicted performance of the plan: {}.",
            percent(outcome.predicted)
        ),
        sure:
            "This is a prediction. It assumes that dirt, tool and surface are as the task states."
                .to_owned(),
        surer: "Execute the plan with a robot: wisch run.".to_owned(),
    }
}
