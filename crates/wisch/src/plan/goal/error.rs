//! What can be wrong with a goal, a domain or a problem.

use crate::represent::{Action, KnowledgeError, Place, UnknownName};

/// Why a goal could not be read or leads to no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalError {
    /// The text is not PDDL of the kind that is read here.
    #[error("{at}: expected {expected}, found {found}")]
    Syntax {
        /// Where.
        at: Place,
        /// What should have stood there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// A construct of PDDL beyond typed STRIPS.
    #[error("{at}: {construct} is not supported; typed STRIPS with positive preconditions is")]
    NotSupported {
        /// Where.
        at: Place,
        /// The construct, as it is written.
        construct: String,
    },
    /// A name that nothing known bears.
    #[error("{at}: {unknown}")]
    Unknown {
        /// Where.
        at: Place,
        /// The name and those near it.
        unknown: Box<UnknownName>,
    },
    /// A predicate with too many or too few arguments.
    #[error("{at}: predicate {predicate} takes {expected} arguments, found {found}")]
    Arity {
        /// Where.
        at: Place,
        /// The predicate.
        predicate: String,
        /// How many arguments it takes.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// An argument of a type that the predicate does not take.
    #[error("{at}: {argument} is of type {found}, which is no {expected}")]
    TypeMismatch {
        /// Where.
        at: Place,
        /// The argument.
        argument: String,
        /// Its type.
        found: String,
        /// The type that the predicate takes.
        expected: String,
    },
    /// A type that is its own ancestor.
    #[error("{at}: type {name} is its own ancestor")]
    CyclicType {
        /// Where.
        at: Place,
        /// The type.
        name: String,
    },
    /// A name given twice.
    #[error("{at}: {what} is already defined at {first}")]
    Duplicate {
        /// The later of the two.
        at: Place,
        /// The earlier of the two.
        first: Place,
        /// What they define.
        what: String,
    },
    /// A problem that was written for another domain.
    #[error("{at}: the problem is one of domain {found:?}, not of {expected:?}")]
    OtherDomain {
        /// Where.
        at: Place,
        /// The domain that the problem names.
        found: String,
        /// The domain that was given.
        expected: String,
    },
    /// More than this planner takes on.
    #[error("{text}: {what}: {value} exceeds the limit of {limit}")]
    TooLarge {
        /// The name of the text.
        text: String,
        /// What there is too much of.
        what: &'static str,
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
