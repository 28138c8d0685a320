//! The summary at the end of a run: task, result, certainty, and what would narrow the interval.

use super::treated::Band;
use super::words;
use crate::draw::percent;
use crate::rounds::words::format_estimate;
use serde::Serialize;
use wisch::recover::Verdict;
use wisch::represent::Task;
use wisch::run::{Ending, Round};

/// A fact about a run: label, value with unit, and the round that it is about; `None` for the whole run.
pub type RunFact = (String, String, Option<usize>);

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
    /// Facts for the page: label, value with unit, and the round that it is about; `None` for the whole run.
    pub facts: &'a [RunFact],
    /// The task as arguments of a command in a shell: its path, or the name of its scenario, and its settings.
    pub task_arguments: &'a str,
}

#[derive(Serialize)]
pub(super) struct Ended<'a> {
    piece: &'static str,
    met: bool,
    verdict: Option<&'static str>,
    badge: Option<&'static str>,
    story: Story,
    facts: &'a [RunFact],
    episode: Option<&'a str>,
}

#[derive(Serialize)]
struct Story {
    asked: String,
    happened: String,
    sure: String,
    surer: String,
    next: Option<NextStep>,
}

/// What a user can do next.
#[derive(Serialize)]
struct NextStep {
    words: String,
    /// The command that does it; `None` if it takes more than a command.
    command: Option<String>,
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
            badge: outcome.last.map(|(last, _)| describe_end(last)),
            story,
            facts: outcome.facts,
            episode,
        }
    }
}

/// States in a few words how a run ended.
const fn describe_end(last: &Round) -> &'static str {
    match (last.verdict, &last.execution.ending) {
        (Verdict::GoalMet, _) => "goal met",
        (_, Ending::Stopped) => "stopped",
        (_, Ending::ProtectiveStop { .. }) => "protective stop",
        (Verdict::Again, _) => "not met: no rounds left",
        (Verdict::NoProgress, _) => "not met: no progress",
        (Verdict::NothingToGain, _) => "not met: nothing to gain",
        (Verdict::NoWay, _) => "not met: no way to wipe again",
        (Verdict::UnsafeMotion, _) => "not met: motion refused",
        (Verdict::Undecidable, _) => "performance unknown",
        (Verdict::UnknowableByTouch, _) => "undecided by touch",
    }
}

fn summarise_execution(
    outcome: &RunOutcome<'_>,
    asked: String,
    last: &Round,
    rounds: usize,
) -> Story {
    let found = &last.interpretation;
    let count = words::format_count(rounds, "round");
    let truth = outcome.truth.map_or_else(String::new, |share| {
        format!(" Ground truth in the simulated world: {}.", percent(share))
    });
    let senses = match found.observation {
        Some(_) => "touch and sight",
        None => "touch only",
    };
    let mean = percent(found.performance.mean);
    let known = if found.is_conclusive() {
        format!(
            "Estimated performance after {count}: {mean}{}; the target is {}.",
            describe_treatment(outcome.task, last).unwrap_or_default(),
            percent(outcome.target)
        )
    } else {
        format!("The log does not show the performance after {count}; {mean} is a guess.")
    };
    Story {
        asked,
        happened: format!("{known} {}", explain_end(last)),
        sure: format!(
            "Estimated from {senses}: {}.{truth}",
            format_estimate(found.performance)
        ),
        surer: words::suggest_measures(last),
        next: suggest_next(outcome, last, rounds),
    }
}

/// States why a run ended.
const fn explain_end(last: &Round) -> &'static str {
    match (last.verdict, &last.execution.ending) {
        (Verdict::GoalMet, _) => "The goal is met.",
        (_, Ending::Stopped) => "The run was stopped.",
        (_, Ending::ProtectiveStop { .. }) => "The robot made a protective stop and waits.",
        (Verdict::Again, _) => "The goal is not met, and the limit of rounds is reached.",
        (Verdict::NoProgress, _) => {
            "The goal is not met, and the last round did not raise the estimate."
        }
        (Verdict::NothingToGain, _) => {
            "The goal is not met, and no plan is predicted to improve it."
        }
        (Verdict::NoWay, _) => {
            "The goal is not met: no plan or motion for another round was found."
        }
        (Verdict::UnsafeMotion, _) => {
            "The goal is not met: the motion of the next round fails its check and was refused."
        }
        (Verdict::Undecidable, _) => "It is unknown whether the goal is met.",
        (Verdict::UnknowableByTouch, _) => {
            "Touch cannot decide whether the goal is met, and wiping again would not change that."
        }
    }
}

/// Suggests what to do after a run whose goal is not met, or not known to be met.
fn suggest_next(outcome: &RunOutcome<'_>, last: &Round, rounds: usize) -> Option<NextStep> {
    let task = outcome.task_arguments;
    let sees = last.interpretation.observation.is_some();
    let [words, command] = match (last.verdict, &last.execution.ending) {
        (Verdict::GoalMet, _) => return None,
        (_, Ending::Stopped) => ["Repeat the run.", &format!("wisch run {task}")],
        (_, Ending::ProtectiveStop { .. }) => [
            "Remove the cause of the stop, then repeat the run.",
            &format!("wisch run {task}"),
        ],
        (Verdict::Again, _) => [
            "Allow more rounds.",
            &format!("wisch run {task} --rounds {}", 2 * rounds),
        ],
        (Verdict::UnknowableByTouch | Verdict::Undecidable, _) if !sees => [
            "Let a camera observe the surface after each round.",
            &format!("wisch run {task} --set 'perception.senses=[\"touch\", \"sight\"]'"),
        ],
        (Verdict::NoWay | Verdict::UnsafeMotion, _) => [
            "See what the robot reaches from where it stands.",
            &format!("wisch check {task}"),
        ],
        (Verdict::NoProgress | Verdict::NothingToGain, _) => [
            "See what every strategy would do, and what it would cost.",
            &format!("wisch plan {task} --explain"),
        ],
        (Verdict::Undecidable | Verdict::UnknowableByTouch, _) => {
            ["Correct what the doubts name, then repeat the run.", ""]
        }
    };
    Some(NextStep {
        words: words.to_owned(),
        command: (!command.is_empty()).then(|| command.to_owned()),
    })
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
        surer: String::new(),
        next: Some(NextStep {
            words: "Execute the plan.".to_owned(),
            command: Some(format!("wisch run {}", outcome.task_arguments)),
        }),
    }
}
