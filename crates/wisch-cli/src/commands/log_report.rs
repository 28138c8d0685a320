//! The page of an interpreted log, for `wisch interpret`, `wisch memory import` and `wisch report LOG`.

use wisch::interpret::Interpretation;
use wisch::represent::GoalState;
use wisch_io::LoadedTask;
use wisch_report::{LogPageInput, RoundView, RoundsInput, log_page};

/// Writes the page of an interpreted log as HTML. `facts`: pairs of name and value for its table.
pub(super) fn page(
    prepared: &LoadedTask,
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
        target: prepared.run.target,
        rounds: &views,
    };
    let mut title = format!("{}: log of {} {}", task.name, task.action, task.medium);
    if !task.surface.shape.is_plane() {
        title.insert_str(0, "unrolled surface, ");
    }
    log_page(&LogPageInput {
        title: &title,
        rounds: &rounds,
        facts,
        notes,
    })
}
