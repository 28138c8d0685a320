//! The summary at the end of a run: task, result, certainty, and what would narrow the interval.

use super::treated::Band;
use super::words;
use crate::draw::format_percent;
use crate::rounds::words::format_estimate;
use serde::Serialize;
use wisch::recover::{Claim, Verdict, assess_goal, find_excess_passes};
use wisch::represent::{Task, describe_weak_reaction};
use wisch::run::{AfterStop, Ending, Round};

/// Largest limit of rounds.
const MOST_ROUNDS: usize = 1000;

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
    /// The task as arguments of a command in a shell: its path, or the name of its scenario, and its settings; `None` if
    /// no file has the task.
    pub task_arguments: Option<&'a str>,
    /// The other options of the run; `None` if they are unknown.
    pub options: Option<&'a CommandOptions>,
    /// What the robot does after a stop that does not continue by itself.
    pub after_stop: AfterStop,
}

/// Options of a run beside its task, as words of a shell, for the commands that a user may give next.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CommandOptions {
    /// Options of `wisch run`, without the limit of rounds.
    pub run: String,
    /// The limit of rounds, as an option of `wisch run`.
    pub rounds: String,
    /// Options that `wisch check` accepts, too.
    pub check: String,
    /// Options that `wisch plan` accepts, too.
    pub plan: String,
}

/// How a session came to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stopping {
    /// The termination policy ended the session, or the limit of rounds is reached.
    Decided,
    /// The observer stopped the session.
    Interrupted,
    /// A stage failed, or the session was left.
    Failed,
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

impl NextStep {
    fn in_words(words: &str) -> Self {
        Self {
            words: words.to_owned(),
            command: None,
        }
    }
}

impl<'a> Ended<'a> {
    pub(super) fn new(
        outcome: &RunOutcome<'a>,
        stopping: Stopping,
        episode: Option<&'a str>,
    ) -> Self {
        let task = words::describe_task(outcome.task, outcome.target);
        let story = match outcome.last {
            Some((last, rounds)) => {
                let end = RunEnd::of(outcome, last, stopping);
                summarise_execution(outcome, task, (last, rounds), end)
            }
            None => summarise_prediction(outcome, task),
        };
        Self {
            piece: "ended",
            met: outcome.is_met,
            verdict: outcome.last.map(|(last, _)| last.verdict.as_str()),
            badge: outcome.last.map(|(last, _)| {
                let goal = assess_goal(
                    last.verdict,
                    &last.motion.task,
                    &last.interpretation,
                    outcome.target,
                );
                RunEnd::of(outcome, last, stopping).badge(goal)
            }),
            story,
            facts: outcome.facts,
            episode,
        }
    }
}

/// Why a run has no further round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum RunEnd {
    /// The termination policy ended the run, with the verdict of the last round.
    Verdict(Verdict),
    /// Too many points have more passes than the task allows.
    TooManyPasses,
    /// The limit of rounds is reached.
    NoRoundsLeft,
    /// A user or the program stopped the motion.
    Stopped,
    /// The robot stopped itself, and waits.
    ProtectiveStop,
    /// The operator interrupted the run before its next round.
    Interrupted,
    /// The run ended before its next round.
    EndedEarly,
}

impl RunEnd {
    fn of(outcome: &RunOutcome<'_>, last: &Round, stopping: Stopping) -> Self {
        let claim = Claim::assess(&last.interpretation.distribution, outcome.target);
        match (last.verdict, &last.execution.ending) {
            (Verdict::Again, Ending::Stopped) if outcome.after_stop == AfterStop::Wait => {
                Self::Stopped
            }
            (Verdict::Again, Ending::ProtectiveStop { cause, .. })
                if !cause.kind().may_continue(outcome.after_stop) =>
            {
                Self::ProtectiveStop
            }
            (Verdict::Again, _) => match stopping {
                Stopping::Decided => Self::NoRoundsLeft,
                Stopping::Interrupted => Self::Interrupted,
                Stopping::Failed => Self::EndedEarly,
            },
            (Verdict::NothingToGain, _)
                if claim.holds()
                    || find_excess_passes(
                        &last.motion.task,
                        &last.interpretation,
                        outcome.target,
                    )
                    .is_some() =>
            {
                Self::TooManyPasses
            }
            (verdict, _) => Self::Verdict(verdict),
        }
    }

    /// States the end in a few words. `goal`: what is known about the goal.
    const fn badge(self, goal: Verdict) -> &'static str {
        match (self, goal) {
            (Self::Stopped, _) => "stopped",
            (Self::ProtectiveStop, _) => "protective stop",
            (Self::Interrupted, _) => "interrupted",
            (Self::EndedEarly, _) => "ended early",
            (_, Verdict::GoalMet) => "goal met",
            (_, Verdict::Undecidable) => "performance unknown",
            (_, Verdict::UnknowableByTouch) => "undecided by touch",
            (Self::NoRoundsLeft, _) => "not met: no rounds left",
            (Self::TooManyPasses, _) => "not met: too many passes",
            (Self::Verdict(Verdict::NoProgress), _) => "not met: no progress",
            (Self::Verdict(Verdict::NothingToGain), _) => "not met: nothing to gain",
            (Self::Verdict(Verdict::NoWay), _) => "not met: no way to wipe again",
            (Self::Verdict(Verdict::UnsafeMotion), _) => "not met: motion refused",
            (Self::Verdict(_), _) => "not met",
        }
    }

    /// States the end in a sentence, after what is known about the goal.
    const fn explain(self) -> &'static str {
        match self {
            Self::Stopped => " The run was stopped.",
            Self::ProtectiveStop => " The robot made a protective stop, and waits.",
            Self::Interrupted => " The operator interrupted the run before its next round.",
            Self::EndedEarly => " The run ended before its next round.",
            Self::NoRoundsLeft => " The limit of rounds is reached.",
            Self::TooManyPasses => " Too many points have more passes than the task allows.",
            Self::Verdict(Verdict::NoProgress) => " The last round did not raise the estimate.",
            Self::Verdict(Verdict::NothingToGain) => " No plan is predicted to improve it.",
            Self::Verdict(Verdict::NoWay) => " No plan or motion for another round was found.",
            Self::Verdict(Verdict::UnsafeMotion) => {
                " The motion of the next round failed its check, and was refused."
            }
            Self::Verdict(_) => "",
        }
    }
}

fn summarise_execution(
    outcome: &RunOutcome<'_>,
    asked: String,
    (last, rounds): (&Round, usize),
    end: RunEnd,
) -> Story {
    let found = &last.interpretation;
    let count = words::format_count(rounds, "round");
    let truth = outcome.truth.map_or_else(String::new, |share| {
        let reaches = if share >= outcome.target {
            "reaches"
        } else {
            "misses"
        };
        format!(
            " Ground truth in the simulated world: {}, which {reaches} the target.",
            format_percent(share)
        )
    });
    let senses = match found.observation {
        Some(_) => "touch and sight",
        None => "touch only",
    };
    let mean = format_percent(found.performance.mean);
    let known = if found.is_conclusive() {
        format!(
            "Estimated performance after {count}: {mean}{}; the target is {}.",
            describe_treatment(outcome.task, last).unwrap_or_default(),
            format_percent(outcome.target)
        )
    } else {
        format!("The log does not show the performance after {count}; {mean} is a guess.")
    };
    let goal = assess_goal(last.verdict, &last.motion.task, found, outcome.target);
    let goal_words = match goal {
        Verdict::GoalMet => "The goal is met.",
        Verdict::Undecidable => "It is unknown whether the goal is met.",
        Verdict::UnknowableByTouch => {
            "It is unknown whether the goal is met, and touch cannot decide it."
        }
        _ => "The goal is not met.",
    };
    Story {
        asked,
        happened: format!("{known} {goal_words}{}", end.explain()),
        sure: format!(
            "Estimated from {senses}: {}.{truth}",
            format_estimate(found.performance)
        ),
        surer: words::suggest_measures(last),
        next: suggest_next(outcome, last, (end, goal), rounds),
    }
}

/// Suggests what to do after a run whose goal is not met, or not known to be met.
fn suggest_next(
    outcome: &RunOutcome<'_>,
    last: &Round,
    (end, goal): (RunEnd, Verdict),
    rounds: usize,
) -> Option<NextStep> {
    const SIGHT: &str = "--set 'perception.senses=[\"touch\", \"sight\"]'";
    let sees = last.interpretation.observation.is_some();
    let known = outcome.options.cloned().unwrap_or_default();
    let again = known.rounds.as_str();
    let more = format!("--rounds {}", (2 * rounds).min(MOST_ROUNDS));
    let is_unknown = matches!(goal, Verdict::Undecidable | Verdict::UnknowableByTouch);
    let (words, command, options) = match end {
        _ if goal == Verdict::GoalMet => return None,
        RunEnd::Stopped | RunEnd::Interrupted | RunEnd::EndedEarly => {
            ("Repeat the run.", "run", [again, ""])
        }
        RunEnd::ProtectiveStop => (
            "Remove the cause of the stop, then repeat the run.",
            "run",
            [again, ""],
        ),
        // A camera sees dirt, but neither polish nor a coat.
        _ if is_unknown && !sees && outcome.task.treatment.is_none() => (
            "Let a camera observe the surface after each round.",
            "run",
            [again, SIGHT],
        ),
        _ if goal == Verdict::Undecidable => (
            "Correct what the doubts about the log name, then repeat the run.",
            "run",
            [again, ""],
        ),
        RunEnd::NoRoundsLeft => ("Allow more rounds.", "run", ["", more.as_str()]),
        RunEnd::TooManyPasses => {
            return Some(NextStep::in_words("Allow more passes, or plan fewer."));
        }
        RunEnd::Verdict(Verdict::NoWay | Verdict::UnsafeMotion) => (
            "See how much of the plan the robot reaches.",
            "check",
            ["", ""],
        ),
        RunEnd::Verdict(Verdict::NoProgress | Verdict::NothingToGain) => (
            "See what every strategy would do, and what it would cost.",
            "plan",
            ["", "--explain"],
        ),
        RunEnd::Verdict(_) => return None,
    };
    let Some(task) = outcome.task_arguments else {
        return Some(NextStep::in_words(words));
    };
    let of_run = match command {
        "check" => &known.check,
        "plan" => &known.plan,
        _ => &known.run,
    };
    let parts = ["wisch", command, task, of_run].into_iter().chain(options);
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    Some(NextStep {
        words: match outcome.options {
            Some(_) => words.to_owned(),
            None => format!("{words} Add the other options of this run, if it had any."),
        },
        command: Some(parts.join(" ")),
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
        Some(share) => format!(
            "{done}, {} have {}",
            format_percent(share),
            band.describe_excess()
        ),
        None => done,
    })
}

fn summarise_prediction(outcome: &RunOutcome<'_>, asked: String) -> Story {
    let weak = describe_weak_reaction(
        outcome.task.interaction.reaction_probability(),
        outcome.target,
    );
    Story {
        asked,
        happened: format!(
            "Nothing was executed. Predicted performance of the plan: {}.",
            format_percent(outcome.predicted)
        ),
        sure: format!(
            "This is a prediction. It assumes that dirt, tool and surface are as the task states{}.",
            weak.map_or_else(String::new, |sentence| format!("; {sentence}"))
        ),
        surer: "Execute the plan with a robot: wisch run.".to_owned(),
        next: None,
    }
}
