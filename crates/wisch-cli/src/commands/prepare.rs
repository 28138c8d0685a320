//! Reads the task that a command line names.

use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use serde::Deserialize;
use std::path::PathBuf;
use wisch::represent::{SurfaceShape, Task};
use wisch_io::{
    ChangedFile, KeptFiles, LoadOptions, LoadedTask, OutputFolder, load_task_with, read_beside,
    read_task_name,
};
use wisch_memory::Episode;

/// Reads the task file and all files that it names, with the overrides of the command line, and prints its assumptions as
/// notes.
pub(super) fn read(args: &TaskArgs) -> Result<LoadedTask, Failure> {
    read_with(args, &KeptFiles::default())
}

/// Reads the task like [`read`], with kept copies in place of the files that the task file names.
pub(super) fn read_with(args: &TaskArgs, kept: &KeptFiles) -> Result<LoadedTask, Failure> {
    let loaded = load(args, kept)?;
    loaded.assumptions.iter().for_each(|text| remark(text));
    Ok(loaded)
}

/// Returns the files that a killed run has kept. Files that have changed since are noted.
///
/// `out`: returns the folder of results for the name of a task.
pub(super) fn read_kept(
    args: &TaskArgs,
    out: impl FnOnce(&str) -> PathBuf,
) -> Result<KeptFiles, Failure> {
    let name = read_task_name(&args.task, &args.settings)?;
    let kept = match OutputFolder::find_checkpoints(&out(&name)) {
        Some(state) => KeptFiles::read_from(&state)?,
        None => KeptFiles::default(),
    };
    for changed in kept.find_changes(&mut read_beside(&args.task)) {
        let ChangedFile { path, kept, found } = changed;
        let what = match found {
            Ok(found) => format!(
                "{path}: the file has changed since the killed run began: its digest is {found}, and was {kept}"
            ),
            Err(why) => format!("{why}; its digest was {kept} when the killed run began"),
        };
        remark(&format!("{what}; the run continues with the earlier file"));
    }
    Ok(kept)
}

/// Reads the task like [`read_with`], without notes.
pub(super) fn load(args: &TaskArgs, kept: &KeptFiles) -> Result<LoadedTask, Failure> {
    let options = LoadOptions {
        settings: args.settings.clone(),
        knowledge: args.knowledge.clone(),
        action: args.action,
        strategy: args.strategy,
        seed: args.seed,
    };
    Ok(load_task_with(&args.task, kept, &options)?)
}

/// Makes a failure from a later stage's error, with the name of the task file.
pub(super) fn stage_failure(args: &TaskArgs, error: impl std::fmt::Display) -> Failure {
    Failure::new(format!("{}: {error}", args.task.display()))
}

/// The options of the command line that change the task, as an episode keeps them.
#[derive(Debug, Default, Deserialize)]
struct Options {
    #[serde(default)]
    settings: Vec<(String, String)>,
    strategy: Option<String>,
    action: Option<String>,
    seed: Option<u64>,
}

/// Reads the task of an episode, with the files and options that the episode keeps.
pub(super) fn load_kept(
    episode: &Episode,
    knowledge: Option<PathBuf>,
) -> Result<LoadedTask, Failure> {
    // Without the settings of the run, it would be another task. Episodes of imported logs have none.
    let options = match episode.attachment("options.json") {
        Ok(bytes) => serde_json::from_slice(&bytes).map_err(|error| {
            Failure::new(format!("options.json: {error}")).within(episode.folder())
        })?,
        Err(_) => Options::default(),
    };
    let args = TaskArgs {
        task: episode.folder().join("task.toml"),
        strategy: options.strategy.and_then(|name| name.parse().ok()),
        budget: None,
        action: options.action.and_then(|name| name.parse().ok()),
        seed: options.seed,
        settings: options.settings,
        knowledge,
    };
    load(&args, &KeptFiles::read_from(episode.folder())?)
}

/// Checks that a log was recorded on the mesh of the task. `logged`: digest of the log's mesh, if the log states it.
pub(super) fn check_mesh(logged: Option<&str>, task: &Task) -> Result<(), Failure> {
    let Some(logged) = logged else {
        return Ok(());
    };
    let digest = match &task.surface.shape {
        SurfaceShape::Mesh(mesh) => Some(format!("{:032x}", mesh.digest())),
        _ => None,
    };
    if digest.as_deref() == Some(logged) {
        return Ok(());
    }
    let own = digest.map_or_else(
        || "is no mesh".to_owned(),
        |digest| format!("has the digest {digest}"),
    );
    Err(Failure::new(format!(
        "the log was recorded on a mesh with the digest {logged}, but the surface of task {:?} {own}",
        task.name
    ))
    .with_help("give the task with the mesh that was wiped; an episode of a run keeps it in its folder task-files"))
}
