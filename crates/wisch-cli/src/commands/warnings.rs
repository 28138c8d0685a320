//! Warnings of the memory during `wisch run`.

use super::job::Job;
use super::words::counted;
use crate::progress::Progress;
use crate::terminal::remark;
use std::thread::{self, JoinHandle};
use wisch::run::{OnWarning, RunEvent, WarningWatch};
use wisch_memory::warnings::{BandError, ComparableRun, MemoryWatch, WarningBasis, find_basis};
use wisch_memory::{Memory, MemoryError, Origin};
use wisch_record::EpisodeTarget;

/// A search for the comparable episodes of the memory, which runs while the first round is planned.
type Search = JoinHandle<Result<WarningBasis, MemoryError>>;

/// Returns the watch that compares the run with the memory of its episode; `None` if the task does not want it.
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
    let mut search: Option<Search> = Some(thread::spawn(move || {
        find_basis(&Memory::open(&folder)?, &run, rate)
    }));
    let (progress, needs_memory) = (job.progress, config.on_warning != OnWarning::Report);
    let mut watch = None;
    let warn = move |event: &RunEvent<'_>| {
        if let RunEvent::Executing(planned) = event
            && let Some(search) = search.take()
        {
            let strategy = planned.plan.strategy.as_str();
            watch = begin_watch(search, (strategy, rate), progress, needs_memory);
        }
        watch
            .as_mut()
            .map_or_else(Vec::new, |watch: &mut MemoryWatch| watch.on_event(event))
    };
    Some(WarningWatch::new(warn).with_replayed_rounds(taken_over))
}

/// Waits for the search and begins the watch; without enough episodes, prints a note.
///
/// `needs_memory`: whether the task asks for a reaction to warnings, so that their absence is stated for an empty memory too.
fn begin_watch(
    search: Search,
    (strategy, rate): (&str, f64),
    progress: &Progress,
    needs_memory: bool,
) -> Option<MemoryWatch> {
    let basis = match search.join() {
        Ok(Ok(basis)) => basis,
        Ok(Err(error)) => {
            progress.aside(|| remark(&format!("no warnings while wiping: {error}")));
            return None;
        }
        Err(panic) => std::panic::resume_unwind(panic),
    };
    if basis.unreadable > 0 {
        let episodes = counted(basis.unreadable, "comparable episode");
        let text = format!("{episodes} cannot be read and are left out of warnings");
        progress.aside(|| remark(&text));
    }
    let text = match basis.fit_bands(strategy, rate) {
        Ok(bands) => return Some(MemoryWatch::new(bands)),
        Err(BandError::TooFew { found: 0, .. }) if !needs_memory => return None,
        Err(BandError::TooFew { found, needed }) => {
            let episodes = counted(found, "comparable episode");
            format!("no warnings while wiping: {episodes}, {needed} are needed")
        }
        Err(error) => format!("no warnings while wiping: {error}"),
    };
    progress.aside(|| remark(&text));
    None
}
