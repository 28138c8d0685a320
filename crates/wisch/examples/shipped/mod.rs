//! The scenarios and the knowledge of the repository, for the examples.

use std::error::Error;
use std::path::{Path, PathBuf};
use wisch::represent::{Action, Intent, KnowledgeBase, Task, TaskFile};

/// What can go wrong in an example.
pub type AnyError = Box<dyn Error + Send + Sync>;

/// The scenarios of the paper's Table 1.
#[allow(dead_code, reason = "not every example goes through all of them")]
pub const SCENARIOS: [&str; 3] = ["chopping-board", "table", "windshield"];

/// A scenario with another action and seed.
pub fn task(
    scenario: &TaskFile,
    action: Action,
    seed: u64,
    knowledge: &KnowledgeBase,
    root: &Path,
) -> Result<Task, AnyError> {
    let Intent::Action { tool, medium, .. } = scenario.intent() else {
        return Err(format!("{} names no tool", scenario.name()).into());
    };
    let read = |folder: PathBuf| {
        move |path: &str| std::fs::read(folder.join(path)).map_err(|error| error.to_string())
    };
    Ok(scenario.resolve(
        action,
        tool,
        medium,
        seed,
        knowledge,
        &mut read(root.join("scenarios")),
        &mut read(root.join("knowledge")),
    )?)
}

/// A task file.
pub fn scenario(path: &Path) -> Result<TaskFile, AnyError> {
    let text = text(path)?;
    Ok(TaskFile::parse(&path.display().to_string(), &text, &[])?)
}

/// The knowledge in a folder.
pub fn knowledge(folder: &Path) -> Result<KnowledgeBase, AnyError> {
    let names = [
        "tools.toml",
        "media.toml",
        "surfaces.toml",
        "interactions.toml",
    ];
    let texts = names
        .iter()
        .map(|name| text(&folder.join(name)))
        .collect::<Result<Vec<String>, _>>()?;
    let files: Vec<(&str, &str)> = names
        .into_iter()
        .zip(texts.iter().map(String::as_str))
        .collect();
    Ok(KnowledgeBase::from_toml(&files)?)
}

/// A file as text.
pub fn text(path: &Path) -> Result<String, AnyError> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()).into())
}
