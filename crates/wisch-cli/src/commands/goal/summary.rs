//! The report of a command for a goal of several parts: as JSON, in words, and as a page.

use super::super::patches::performance_of;
use super::super::words::format_count;
use serde::Serialize;
use std::path::Path;
use wisch::goal::{Sequence, Step};
use wisch_io::Summary;

/// The schema of the object.
pub const SCHEMA: u32 = 1;
/// Assumed time to fetch a tool, or to put it back [s].
pub const CHANGE: f64 = 10.0;
/// Assumed time to empty a tool [s].
pub const EMPTY: f64 = 20.0;
/// Assumed speed of ways between surfaces and rack [m/s].
pub const SPEED: f64 = 0.3;

/// A step that a command has taken.
#[derive(Serialize)]
pub struct TakenStep {
    /// The step as a PDDL action, such as `(grasp sponge)`.
    pub step: String,
    /// The part of the goal that the wiping step serves; null for other steps.
    pub part: Option<String>,
    /// The step in words, such as `fetch sponge`.
    pub words: String,
    /// Expected time, with the way to its place [s].
    pub expected_s: f64,
    /// Start of the step, since the start of the first step [s].
    pub began_s: f64,
    /// Actual time [s]: of a wiping step that of its motions and the expected way to its place; of other steps the expected
    /// time.
    pub took_s: f64,
    /// Whether the goal of the wiping step is met; null for other steps.
    pub goal_met: Option<bool>,
    /// How often this wiping step was tried before; 0 for other steps.
    pub earlier_tries: u32,
    /// Summary of the wiping step; null for other steps.
    pub summary: Option<Summary>,
}

/// A part of the goal.
#[derive(Serialize)]
pub struct GoalPart {
    /// The part in PDDL, such as `(absorbed water table)`.
    pub part: String,
    /// Whether it holds after the last step, as far as is known.
    pub holds: bool,
    /// Why it does not hold: no sequence of steps reaches it, or its step missed its target; null otherwise.
    pub left_out: Option<String>,
}

/// The expected time and performance of an action that may serve the goal.
#[derive(Serialize)]
pub struct ExpectedAction {
    /// The action in words, such as `absorb water on table with sponge`.
    pub wiping: String,
    /// Time of a round [s]; null if the action is impossible.
    pub round_s: Option<f64>,
    /// Expected number of rounds; null if the action is impossible.
    pub rounds: Option<f64>,
    /// Predicted performance of a round, in [0, 1]; null if the action is impossible.
    pub predicted: Option<f64>,
    /// Why the action is impossible; null if it is possible.
    pub impossible: Option<String>,
}

/// The results of a command for a goal of several parts; the object of `--json` and of `steps.json`.
#[derive(Serialize)]
pub struct GoalSummary {
    /// Name of the format.
    pub format: &'static str,
    /// Schema of the object.
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// The goal in PDDL.
    pub goal: String,
    /// Whether every part of the goal holds, as far as is known.
    pub goal_met: bool,
    /// Whether the steps were executed; otherwise each step is assumed to reach its goal.
    pub is_executed: bool,
    /// Whether the effect of the wiping steps is at least predicted; otherwise each is assumed to reach its goal.
    pub is_predicted: bool,
    /// Expected time of the sequence that was planned before the first step [s].
    pub expected_s: f64,
    /// Time of all steps [s].
    pub took_s: f64,
    /// Time to compute the order of the steps [s].
    pub ordering_s: f64,
    /// Least time of any order of the steps that reached their goals, with the times that they took [s]; null if none is found.
    pub best_order_s: Option<f64>,
    /// Assumed times and speed.
    pub assumed: AssumedTimes,
    /// The parts of the goal, in its order.
    pub parts: Vec<GoalPart>,
    /// The steps, in the order of their execution.
    pub steps: Vec<TakenStep>,
    /// The actions that may serve the goal.
    pub expected_actions: Vec<ExpectedAction>,
    /// Folder of the results.
    pub out: String,
}

/// Assumed times of steps without a motion, and assumed speed of ways.
#[derive(Serialize)]
pub struct AssumedTimes {
    /// Time to fetch a tool, or to put it back [s].
    pub fetch_or_put_back_s: f64,
    /// Time to empty a tool [s].
    pub empty_s: f64,
    /// Speed of ways between surfaces and rack [m/s].
    pub speed_m_per_s: f64,
}

impl TakenStep {
    /// Whether it is a wiping step, and its estimate leaves open whether its goal is met.
    pub fn is_unknown(&self) -> bool {
        (self.summary.as_ref()).is_some_and(|summary| is_unknown(summary, self.goal_met))
    }

    /// Returns where the step ended: `true` and the name of a surface, or `false` and the name of a tool in the rack.
    pub fn place(&self) -> (bool, String) {
        match &self.summary {
            Some(summary) => (true, summary.surface.clone()),
            None => {
                let mut words = self.step.trim_matches(['(', ')']).split(' ');
                (false, words.next_back().unwrap_or_default().to_owned())
            }
        }
    }
}

/// Returns the time of the motions of a wiping step [s]; `None` if no motion is known.
///
/// `is_executed`: whether steps are executed. The time is then measured, and 0 if nothing moved. Otherwise it is that of the
/// planned motion.
pub fn measure_time(summary: &Summary, is_executed: bool) -> Option<f64> {
    match (&summary.execution, &summary.following) {
        (Some(execution), _) => Some(execution.total(|round| round.execution_time_s)),
        // Nothing was wiped, or the motion was refused.
        (None, _) if is_executed => Some(0.0),
        (None, following) => (following.as_ref()).map(|following| following.execution_time_s),
    }
}

/// Describes a step in words, such as `fetch sponge`.
pub fn describe_step(step: &Step) -> String {
    match (&step.wiping, step.name()) {
        (Some(wiping), _) => wiping.to_string(),
        (None, "grasp") => format!("fetch {}", step.objects().join(" ")),
        (None, "release") => format!("put {} back", step.objects().join(" ")),
        (None, name) => format!("{name} {}", step.objects().join(" ")),
    }
}

/// Describes a sequence in one line: number of steps, expected time, the steps, and the parts that are left out with reasons.
pub fn describe_sequence(sequence: &Sequence) -> String {
    let steps: Vec<String> = sequence.steps.iter().map(describe_step).collect();
    let mut text = match steps.len() {
        0 => "no step is needed".to_owned(),
        count => format!(
            "{}, {:.0} s expected: {}",
            format_count(count, "step"),
            sequence.time(),
            steps.join(", ")
        ),
    };
    for (part, reason) in &sequence.left_out {
        text += &format!("; {part} is left out: {reason}");
    }
    text
}

/// Whether it is unknown if the goal of a wiping step is met.
fn is_unknown(summary: &Summary, is_met: Option<bool>) -> bool {
    is_met != Some(true) && (summary.prediction).is_some_and(|found| found.goal == "unknown")
}

/// Describes the performance of a wiping step, and whether its goal is met.
fn describe_result(summary: &Summary, is_met: Option<bool>) -> String {
    let performance = performance_of(summary);
    match is_met {
        Some(true) => format!("{performance}: met"),
        _ if is_unknown(summary, is_met) => format!("{performance}: unknown whether it is met"),
        Some(false) => format!("{performance}: not met"),
        None => performance,
    }
}

impl GoalSummary {
    /// Whether every part of the goal holds, as far as is known.
    pub const fn is_met(&self) -> bool {
        self.goal_met
    }

    /// Formats the summary for people.
    pub fn in_words(&self) -> String {
        let mut text = format!("{}: {}\n", self.task, self.goal);
        let mut add = |name: &str, value: String| text += &format!("  {name:<18} {value}\n");
        let holding = self.parts.iter().filter(|part| part.holds).count();
        let parts = format_count(self.parts.len(), "part");
        let goal = match (self.is_executed, self.is_predicted) {
            (true, _) => format!("{holding} of {parts} hold, as estimated"),
            (false, true) => format!("{holding} of {parts} hold, as predicted, not executed"),
            (false, false) => format!("steps are planned for {holding} of {parts}, not predicted"),
        };
        add("goal", goal);
        for part in self.parts.iter().filter(|part| !part.holds) {
            let why = part.left_out.as_deref().unwrap_or("not reached");
            add("open", format!("{}: {why}", part.part));
        }
        for (step, number) in self.steps.iter().zip(1..) {
            let TakenStep {
                words,
                took_s,
                expected_s,
                ..
            } = step;
            let times = self.times(*took_s, *expected_s);
            let result = match (&step.summary, step.goal_met) {
                (Some(summary), is_met) => format!(", {}", describe_result(summary, is_met)),
                (None, _) => String::new(),
            };
            add(
                &format!("step {number}"),
                format!("{words}: {times}{result}"),
            );
        }
        add("time", self.times(self.took_s, self.expected_s));
        add(
            "assumed",
            format!(
                "{CHANGE} s to fetch or put back a tool, {EMPTY} s to empty one, {SPEED} m/s between places"
            ),
        );
        add("results", self.out.clone());
        text
    }

    /// Formats the time that was needed and the expected time [s]; without execution, the expected time alone.
    fn times(&self, took: f64, expected: f64) -> String {
        if !self.is_executed && took == expected {
            format!("{expected:.1} s expected")
        } else {
            format!("{took:.1} s ({expected:.1} s expected)")
        }
    }

    /// Returns an HTML page over all steps, which links to the pages of the wiping steps.
    pub fn page(&self) -> String {
        let rows: Vec<wisch_report::StepRow> = (self.steps.iter().zip(1..))
            .map(|(step, number)| wisch_report::StepRow {
                words: step.words.clone(),
                began: step.began_s,
                took: step.took_s,
                expected: step.expected_s,
                result: match (&step.summary, step.goal_met) {
                    (Some(summary), is_met) => describe_result(summary, is_met),
                    (None, _) => String::new(),
                },
                report: (step.summary.as_ref())
                    .filter(|summary| Path::new(&summary.out).join(wisch_io::REPORT_FILE).exists())
                    .map(|_| format!("step-{number}/{}", wisch_io::REPORT_FILE)),
            })
            .collect();
        let parts: Vec<(String, String)> = (self.parts.iter())
            .map(|part| {
                let state = match (&part.left_out, part.holds) {
                    (_, true) => "holds".to_owned(),
                    (Some(why), false) => format!("open: {why}"),
                    (None, false) => "open".to_owned(),
                };
                (part.part.clone(), state)
            })
            .collect();
        let time = self.times(self.took_s, self.expected_s);
        let assumed = format!(
            "{CHANGE} s to fetch or put back a tool, {EMPTY} s to empty one, {SPEED} m/s between places"
        );
        let facts = [("time".to_owned(), time), ("assumed".to_owned(), assumed)];
        wisch_report::steps_page(&self.task, &[&parts[..], &facts[..]].concat(), &rows)
    }
}
