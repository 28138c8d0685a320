//! The page of a log: what `wisch interpret`, `wisch memory import` and `wisch report LOG` make of it.

use super::prepare::Prepared;
use wisch::interpret::Interpretation;
use wisch::represent::GoalState;
use wisch_report::{LogPageInput, RoundView, RoundsInput, log_page};

/// The page of an interpreted log, with what is said of it: name and value, and notes.
pub(super) fn page(
    prepared: &Prepared,
    goal: &GoalState,
    interpretation: &Interpretation,
    facts: &[(String, String)],
    notes: &[String],
) -> String {
    let task = &prepared.task;
    let views = [RoundView {
        number: 1,
        plan: None,
        believed: &task.particles,
        predicted: f64::NAN,
        interpretation,
        truth: None,
        pushes: &[],
    }];
    let rounds = RoundsInput {
        task,
        goal,
        target: prepared.file.target_performance(),
        rounds: &views,
    };
    let title = format!("{}: log of {} {}", task.name, task.action, task.medium);
    log_page(&LogPageInput {
        title: &title,
        rounds: &rounds,
        facts,
        notes,
    })
}
