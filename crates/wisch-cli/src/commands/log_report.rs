//! The page of a log: what `wisch interpret`, `wisch memory import` and `wisch report LOG` make of it.

use super::interpret::{Interpreted, summary_lines};
use super::prepare::Prepared;
use crate::failure::Failure;
use wisch_report::{LogPageInput, RoundView, RoundsInput, log_page};

/// The page.
pub(super) fn page(prepared: &Prepared, interpreted: &Interpreted) -> Result<String, Failure> {
    let task = &prepared.task;
    let views = [RoundView {
        number: 1,
        plan: None,
        believed: &task.particles,
        predicted: f64::NAN,
        interpretation: &interpreted.interpretation,
        truth: None,
        pushes: &[],
    }];
    let rounds = RoundsInput {
        task,
        goal: &interpreted.goal,
        target: prepared.file.target_performance(),
        rounds: &views,
    };
    let record = &interpreted.record;
    let title = format!("{}: log of {} {}", task.name, task.action, task.medium);
    let lines = summary_lines(record).into_iter();
    let facts: Vec<(String, String)> = lines
        .filter(|(name, _)| !name.is_empty())
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    Ok(log_page(&LogPageInput {
        title: &title,
        rounds: &rounds,
        facts: &facts,
        notes: &record.log.remarks,
    }))
}
