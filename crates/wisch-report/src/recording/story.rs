//! How it ended.

use super::words;
use crate::draw::percent;
use crate::rounds::words::interval;
use serde::Serialize;
use wisch::recover::Verdict;
use wisch::represent::Task;
use wisch::run::{Ending, Round};

/// How a run ended.
#[derive(Debug, Clone, Copy)]
pub struct RunOutcome<'a> {
    /// What was to be done.
    pub task: &'a Task,
    /// The performance that was wanted, in [0, 1].
    pub target: f64,
    /// Whether the goal is met.
    pub is_met: bool,
    /// What was predicted for the first round, in [0, 1].
    pub predicted: f64,
    /// The last round and how many there were; `None` where nothing was executed.
    pub last: Option<(&'a Round, usize)>,
    /// The true performance in the end, in [0, 1]; `None` where nobody knows.
    pub truth: Option<f64>,
    /// Label and value with unit.
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
        let asked = words::asked(outcome.task, outcome.target);
        let story = match outcome.last {
            Some((last, rounds)) => executed(outcome, asked, last, rounds),
            None => predicted(outcome, asked),
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

fn executed(outcome: &RunOutcome<'_>, asked: String, last: &Round, rounds: usize) -> Story {
    let found = &last.interpretation;
    let rounds = match rounds {
        1 => "one round".to_owned(),
        many => format!("{many} rounds"),
    };
    let truth = outcome.truth.map_or_else(String::new, |share| {
        format!(" In the simulated world it is really {}.", percent(share))
    });
    let senses = match found.observation {
        Some(_) => "touch and sight",
        None => "touch alone",
    };
    Story {
        asked,
        happened: format!(
            "After {rounds} {} is where it belongs, the robot believes: {}.",
            percent(found.performance.mean),
            match (last.verdict, &last.execution.ending) {
                (Verdict::Again, Ending::Stopped) => "it was stopped",
                (Verdict::Again, _) => "no more rounds were allowed",
                (verdict, _) => verdict.as_str(),
            }
        ),
        sure: format!("By {senses}: {}.{truth}", interval(found.performance)),
        surer: words::surer(last),
    }
}

fn predicted(outcome: &RunOutcome<'_>, asked: String) -> Story {
    Story {
        asked,
        happened: format!(
            "Nothing was executed. The plan is predicted to bring {} where it belongs.",
            percent(outcome.predicted)
        ),
        sure: "A prediction: it is as true as what is believed of dirt, tool and surface."
            .to_owned(),
        surer: "It would take executing it: wisch run does, with a robot.".to_owned(),
    }
}
