//! Task files whose goal has several parts.

use crate::assets::{KnowledgeSource, read_task_text};
use crate::error::Error;
use crate::load::LoadOptions;
use crate::task_file::{Parts, RackTool, TaskFile};
use std::path::Path;
use wisch::goal::{CompoundGoal, Domain, GoalError, MediumOnSurface, Situation};
use wisch::represent::KnowledgeBase;

/// A task file with a goal of several parts, such as `(and (collected breadcrumbs board) (absorbed water table))`. Each
/// part is a task of the same file, which [`load_task`](crate::load_task) reads with the part as the setting `goal`.
#[derive(Debug, Clone)]
pub struct GoalFile {
    /// Name of the task.
    pub name: String,
    /// The goal.
    pub goal: CompoundGoal,
    /// The media, each with its surface.
    pub media: Vec<MediumOnSurface>,
    /// Tool in the hand before the first step.
    pub tool_in_hand: Option<String>,
    /// Tools that the robot can fetch.
    pub tools: Vec<RackTool>,
    /// The domain of actions.
    pub domain: Domain,
    /// The knowledge base, with what the file adds to it.
    pub knowledge: KnowledgeBase,
}

impl GoalFile {
    /// Reads a task file, or a shipped scenario by its name; `None` if its goal is a single fact, or if it has an action.
    ///
    /// # Errors
    /// If the file cannot be read, or a table of any of its parts is invalid.
    pub fn read(path: &Path, options: &LoadOptions) -> Result<Option<Self>, Error> {
        // A named pipe can be read only once.
        if options.action.is_some() || std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Ok(None);
        }
        let (shown, text) = (path.display().to_string(), read_task_text(path)?);
        let Some(parts) = TaskFile::parse_parts(&shown, &text, &options.settings)? else {
            return Ok(None);
        };
        let source = KnowledgeSource::new(options.knowledge.as_deref());
        let mut knowledge = source.base()?;
        for on in &parts.media {
            let part = (
                "goal".to_owned(),
                format!("(on {} {})", on.medium, on.surface),
            );
            // Any tool serves to read the tables of the medium.
            let tool = parts.tools.iter().map(|tool| &tool.name);
            let tool = tool.chain(&parts.tool_in_hand).next();
            let tool = tool.map(|name| {
                (
                    "tool.name".to_owned(),
                    serde_json::Value::from(name.as_str()).to_string(),
                )
            });
            let settings = options.settings.iter().cloned().chain([part]).chain(tool);
            let settings: Vec<_> = settings.collect();
            TaskFile::parse(&shown, &text, &settings)?.extend(&mut knowledge)?;
        }
        let Parts {
            name,
            goal,
            media,
            tool_in_hand,
            tools,
        } = parts;
        Ok(Some(Self {
            name,
            goal,
            media,
            tool_in_hand,
            tools,
            domain: source.domain()?,
            knowledge,
        }))
    }

    /// Returns the symbolic state before the first step.
    ///
    /// # Errors
    /// Those of [`Situation::new`].
    pub fn situation(&self) -> Result<Situation<'_>, GoalError> {
        let tools: Vec<&str> = self.tools.iter().map(|tool| tool.name.as_str()).collect();
        Situation::new(
            &self.domain,
            &self.knowledge,
            &self.goal,
            &self.media,
            self.tool_in_hand.as_deref(),
            &tools,
        )
    }
}
