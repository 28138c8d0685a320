//! Why a goal cannot be read, or leads to no action.

use crate::represent::{Action, KnowledgeError, Place};

/// Why a goal could not be read or leads to no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalError {
    /// A text that is not PDDL of the kind that is read here, or does not hold together.
    #[error("{at}: {fault}")]
    Text {
        /// Where.
        at: Place,
        /// What was expected, is not supported, is unknown, or fits nothing else.
        fault: String,
    },
    /// More than this planner takes on.
    #[error("{text}: {what}: {value} exceeds the limit of {limit}")]
    TooLarge {
        /// The name of the text.
        text: String,
        /// What there is too much of.
        what: String,
        /// How much there is, or how much there was when counting stopped.
        value: usize,
        /// How much there may be.
        limit: usize,
    },
    /// The goal names something that the knowledge base does not know.
    #[error(transparent)]
    Knowledge(#[from] KnowledgeError),
    /// No tool at all is known to do what the goal asks for.
    #[error(
        "no tool is known that can {action} {medium} on {surface}; known there: {}",
        list(known)
    )]
    NoCapableTool {
        /// The action that would reach the goal.
        action: Action,
        /// The medium of the goal.
        medium: String,
        /// The surface of the goal.
        surface: String,
        /// What else is known for this medium and surface, such as "skim with window_wiper".
        known: Vec<String>,
    },
    /// Tools are known that could do it, but none of them is at hand.
    #[error(
        "none of the tools at hand ({}) can {action} {medium} on {surface}; known to: {}",
        list(available),
        list(capable)
    )]
    CapableToolMissing {
        /// The action that would reach the goal.
        action: Action,
        /// The medium of the goal.
        medium: String,
        /// The surface of the goal.
        surface: String,
        /// The tools at hand.
        available: Vec<String>,
        /// The tools that could do it, the best first.
        capable: Vec<String>,
    },
    /// The goal speaks of a tool that is not at hand.
    #[error(
        "{goal} takes {tool}, which is not at hand; at hand: {}",
        list(available)
    )]
    ToolNotAtHand {
        /// The goal.
        goal: String,
        /// The tool.
        tool: String,
        /// The tools at hand.
        available: Vec<String>,
    },
    /// No sequence of actions reaches the goal.
    #[error("no plan reaches {goal}: {}", reasons(unmet))]
    NoPlan {
        /// The goal.
        goal: String,
        /// Preconditions that nothing can meet, each with the action that has it.
        unmet: Vec<String>,
    },
    /// The goal holds or is reached without any wiping.
    #[error(
        "goal {goal} takes no wiping action; goals that do: {}",
        list(wiping_goals)
    )]
    NoWiping {
        /// The goal.
        goal: String,
        /// The predicates that wiping brings about.
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
