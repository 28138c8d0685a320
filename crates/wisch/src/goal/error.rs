//! Errors of goals and domains.

use crate::represent::{Action, KnowledgeError, Place};

/// A reason why a goal cannot be read or leads to no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalError {
    /// A text that is not in the supported part of PDDL, or that contradicts itself.
    #[error("{at}: {fault}")]
    Text {
        /// Place of the fault.
        at: Place,
        /// The fault: what was expected, is not supported, is unknown or is inconsistent.
        fault: String,
    },
    /// A text or search exceeds a limit.
    #[error("{text}: {what}: {value} exceeds the limit of {limit}")]
    TooLarge {
        /// Name of the text.
        text: String,
        /// The quantity that is too large.
        what: String,
        /// Its value, or its value when counting stopped.
        value: usize,
        /// Its limit.
        limit: usize,
    },
    /// The goal names something that is not in the knowledge base.
    #[error(transparent)]
    Knowledge(#[from] KnowledgeError),
    /// The knowledge base has no tool for the goal.
    #[error(
        "no known tool can {action} {medium} on {surface}; known for {medium} on {surface}: {}",
        list(known)
    )]
    NoCapableTool {
        /// Action that would reach the goal.
        action: Action,
        /// Medium of the goal.
        medium: String,
        /// Surface of the goal.
        surface: String,
        /// Known actions for this medium and surface, such as "skim with window_wiper".
        known: Vec<String>,
    },
    /// Known tools could reach the goal, but none of them is available.
    #[error(
        "none of the available tools ({}) can {action} {medium} on {surface}; tools that can: {}",
        list(available),
        list(capable)
    )]
    CapableToolNotAvailable {
        /// Action that would reach the goal.
        action: Action,
        /// Medium of the goal.
        medium: String,
        /// Surface of the goal.
        surface: String,
        /// Available tools.
        available: Vec<String>,
        /// Tools that can do it, the best first.
        capable: Vec<String>,
    },
    /// The goal names a tool that is not available.
    #[error(
        "{goal} needs {tool}, which is not available; available: {}",
        list(available)
    )]
    ToolNotAvailable {
        /// Goal as written.
        goal: String,
        /// The tool.
        tool: String,
        /// Available tools.
        available: Vec<String>,
    },
    /// No sequence of actions reaches the goal.
    #[error("no plan reaches {goal}: {}", reasons(unmet))]
    NoPlan {
        /// Goal as written.
        goal: String,
        /// Preconditions that cannot be met, each with its action.
        unmet: Vec<String>,
    },
    /// The goal holds already or needs no wiping.
    #[error(
        "goal {goal} needs no wiping action; goals that do: {}",
        list(wiping_goals)
    )]
    NoWiping {
        /// Goal as written.
        goal: String,
        /// Predicates that wiping actions bring about.
        wiping_goals: Vec<String>,
    },
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

fn reasons(unmet: &[String]) -> String {
    if unmet.is_empty() {
        "each precondition can be met, but not all together".to_owned()
    } else {
        unmet.join("; ")
    }
}
