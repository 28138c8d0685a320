//! The scenarios and the knowledge of the repository, for the examples.

use std::error::Error;
use std::path::Path;
use wisch::represent::{Action, KnowledgeBase, Task};
use wisch_io::{Intent, KnowledgeSource, TaskFile, beside};

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
    let path = root.join("scenarios/any.toml");
    let source = KnowledgeSource::BuiltIn;
    Ok(scenario.resolve(
        action,
        tool,
        medium,
        seed,
        knowledge,
        &mut beside(&path),
        &mut |path| source.asset(path),
    )?)
}

/// A task file.
pub fn scenario(path: &Path) -> Result<TaskFile, AnyError> {
    let text = text(path)?;
    Ok(TaskFile::parse(&path.display().to_string(), &text, &[])?)
}

/// The knowledge in a folder.
pub fn knowledge(folder: &Path) -> Result<KnowledgeBase, AnyError> {
    Ok(KnowledgeSource::new(Some(folder)).base()?)
}

/// A file as text.
pub fn text(path: &Path) -> Result<String, AnyError> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()).into())
}
