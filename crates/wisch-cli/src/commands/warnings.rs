//! Warnings of the memory during `wisch run`.

use super::job::Job;
use crate::terminal::remark;
use std::thread;
use wisch::run::{OnWarning, WarningWatch};
use wisch_memory::warnings::{ComparableRun, find_basis, watch_run};
use wisch_memory::{Memory, Origin};
use wisch_record::EpisodeTarget;

/// Returns the watch that compares the run with the memory of its episode; `None` if the task does not want it. Comparable
/// episodes are searched while the first round is planned.
///
/// `taken_over`: number of rounds that a killed run has executed.
pub(super) fn watch_for_warnings<'a>(
    job: &Job<'a>,
    memory: &EpisodeTarget,
    taken_over: usize,
) -> Option<WarningWatch<'a>> {
    let config = &job.prepared.run;
    if config.on_warning == OnWarning::Ignore {
        return None;
    }
    let (_, robot) = job.robot?;
    let run = ComparableRun {
        task: job.prepared.task.clone(),
        robot: robot.model.name().to_owned(),
        origin: (memory.executor.clone()).map_or(Origin::Simulated, Origin::Executor),
    };
    let (folder, rate) = (memory.memory.clone(), config.false_warning_rate);
    let search = thread::spawn(move || find_basis(&Memory::open(&folder)?, &run, rate));
    let search = move || {
        search
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    };
    let progress = job.progress;
    let watch = watch_run(search, config, |text| progress.aside(|| remark(text)));
    Some(watch.with_replayed_rounds(taken_over))
}
