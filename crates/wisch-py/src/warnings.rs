//! Warnings of the memory while a session executes.

use crate::mutex::lock;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use wisch::represent::Task;
use wisch::run::{OnWarning, RunConfig, WarningWatch};
use wisch_io::Robot;
use wisch_memory::warnings::{ComparableRun, find_basis, watch_run};
use wisch_memory::{Memory, Origin};

/// Returns the watch that compares a run with the episodes of a memory; `None` if the task does not want it.
///
/// `executor`: class of the executor, known before the first motion. `notes` receives why there are no warnings.
pub fn watch_memory(
    task: &Task,
    robot: &Robot,
    config: &RunConfig,
    memory: PathBuf,
    executor: &Arc<Mutex<Option<String>>>,
    notes: &Arc<Mutex<Vec<String>>>,
) -> Option<WarningWatch<'static>> {
    if config.on_warning == OnWarning::Ignore {
        return None;
    }
    let (task, robot) = (task.clone(), robot.model.name().to_owned());
    let rate = config.false_warning_rate;
    let (executor, notes) = (Arc::clone(executor), Arc::clone(notes));
    let search = move || {
        let origin = lock(&executor)
            .clone()
            .map_or(Origin::Simulated, Origin::Executor);
        let run = ComparableRun {
            task,
            robot,
            origin,
        };
        find_basis(&Memory::open(&memory)?, &run, rate)
    };
    let note = move |text: &str| lock(&notes).push(text.to_owned());
    Some(watch_run(search, config, note))
}
