//! From a path on the command line to a task that can be planned.

use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use wisch_io::{LoadOptions, LoadedTask, load_task};

/// Reads the task file and all files that it names, with the overrides of the command line, and prints its assumptions as
/// notes.
pub(super) fn read(args: &TaskArgs) -> Result<LoadedTask, Failure> {
    let loaded = load(args)?;
    loaded.assumptions.iter().for_each(|text| remark(text));
    Ok(loaded)
}

/// Reads the task file like [`read`], without notes.
pub(super) fn load(args: &TaskArgs) -> Result<LoadedTask, Failure> {
    let options = LoadOptions {
        settings: args.settings.clone(),
        knowledge: args.knowledge.clone(),
        action: args.action,
        strategy: args.strategy,
        seed: args.seed,
    };
    Ok(load_task(&args.task, &options)?)
}

/// Makes a failure from a later stage's error, with the name of the task file.
pub(super) fn stage_failure(args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
    Failure::new(format!("{}: {error}", args.task.display()))
}
