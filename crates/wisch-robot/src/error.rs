//! Errors of robot models.

use super::Diagnostic;
use crate::source_location::{Place, UnknownName};

/// A reason why a robot description or an argument of a robot function is rejected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RobotError {
    /// The text is no XML or no URDF.
    #[error("{at}: {problem}")]
    Syntax {
        /// Place of the fault.
        at: Place,
        /// What is wrong there.
        problem: String,
    },
    /// An attribute has an invalid value.
    #[error("{at}: <{element} {attribute}={text:?}>: expected {expected}")]
    Attribute {
        /// Place at which the element starts.
        at: Place,
        /// Name of the element.
        element: String,
        /// Name of the attribute.
        attribute: &'static str,
        /// Its text; empty if it is missing.
        text: String,
        /// What was expected.
        expected: &'static str,
    },
    /// A text exceeds a limit.
    #[error("{file}: {what}: {value} exceeds the limit of {limit}")]
    TooLarge {
        /// Name of the text.
        file: String,
        /// The quantity that is too large.
        what: &'static str,
        /// Its value.
        value: usize,
        /// Its limit.
        limit: usize,
    },
    /// The text is a URDF, but does not describe a tree of links that can move.
    #[error("{file}: {}", first_of(diagnostics))]
    Unusable {
        /// Name of the text.
        file: String,
        /// Its errors, at least one, in the order of the text.
        diagnostics: Vec<Diagnostic>,
    },
    /// The robot has no such link or joint.
    #[error("robot {robot:?}: {unknown}")]
    Unknown {
        /// Name of the robot.
        robot: String,
        /// The unknown name, with the nearest known ones.
        unknown: Box<UnknownName>,
    },
    /// A text names something that the robot does not have.
    #[error("{at}: {unknown}")]
    UnknownAt {
        /// Place of the name.
        at: Place,
        /// The unknown name, with the nearest known ones.
        unknown: Box<UnknownName>,
    },
    /// No body of a collision model, or no group or posture of an SRDF, has this name.
    #[error("{0}")]
    NoSuch(Box<UnknownName>),
    /// A link belongs to another robot.
    #[error("link number {link} does not exist: the robot has {links} links")]
    ForeignLink {
        /// Index of the link.
        link: usize,
        /// Number of links of the robot.
        links: usize,
    },
    /// A link, body or obstacle already has this name.
    #[error("body {name:?}: a link, body or obstacle of this name already exists")]
    NameTaken {
        /// The name.
        name: String,
    },
    /// The geometry of a body or obstacle cannot be used.
    #[error("body {name:?}: {problem}")]
    Obstacle {
        /// Its name.
        name: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A distance is negative or NaN.
    #[error("{what} is {value} m, expected at least 0 m")]
    Distance {
        /// Name of the distance.
        what: &'static str,
        /// Its value \[m\].
        value: f64,
    },
    /// An array does not have one value per variable.
    #[error("{what} has {found} values, the robot has {expected} variables")]
    Length {
        /// Name of the array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length it should have.
        expected: usize,
    },
    /// A value is infinite or NaN.
    #[error("joint {joint:?}: {what} {value} is not finite")]
    NotFinite {
        /// Name of the joint.
        joint: String,
        /// Name of the array.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// A value is outside its range.
    #[error("{what} is {value}: it must be {limit}")]
    Value {
        /// Name of the value.
        what: &'static str,
        /// The value.
        value: f64,
        /// Its range, with its unit.
        limit: &'static str,
    },
    /// The tip is no descendant of the base.
    #[error("link {tip:?} is no descendant of link {base:?}; its ancestors: {}", ancestors.join(", "))]
    NoChain {
        /// Base of the chain.
        base: String,
        /// Tip of the chain.
        tip: String,
        /// Ancestors of the tip, the nearest first.
        ancestors: Vec<String>,
    },
    /// A chain has too many joints or variables.
    #[error("chain {base:?} to {tip:?}: {value} {what} exceed the limit of {limit}")]
    ChainTooLong {
        /// Base of the chain.
        base: String,
        /// Tip of the chain.
        tip: String,
        /// The quantity that is too large.
        what: &'static str,
        /// Its value.
        value: usize,
        /// Its limit.
        limit: usize,
    },
    /// A joint moves no inertia.
    #[error(
        "joint {joint:?} moves an inertia of {value:e} (kg or kg m2), below the limit of {limit:e}: give link {link:?} or one of its children an <inertial>"
    )]
    NoInertia {
        /// Name of the joint.
        joint: String,
        /// Child link of the joint.
        link: String,
        /// The inertia about, or mass along, the joint's axis [kg m² or kg].
        value: f64,
        /// Least inertia [kg m² or kg].
        limit: f64,
    },
}

impl RobotError {
    /// Returns place, finding and expectation for a diagnostic; `whole` describes what the whole text should be.
    pub(super) fn parts(&self, whole: &str) -> (Option<&Place>, String, String) {
        match self {
            Self::Syntax { at, problem } => (Some(at), problem.clone(), whole.to_owned()),
            Self::UnknownAt { at, unknown } => (Some(at), unknown.to_string(), whole.to_owned()),
            Self::Attribute {
                at,
                element,
                attribute,
                text,
                expected,
            } => (
                Some(at),
                format!("<{element} {attribute}={text:?}>"),
                (*expected).to_owned(),
            ),
            other => (None, other.to_string(), whole.to_owned()),
        }
    }
}

fn first_of(diagnostics: &[Diagnostic]) -> String {
    let first = diagnostics
        .first()
        .map_or_else(String::new, Diagnostic::to_string);
    match diagnostics.len() {
        0 | 1 => first,
        n => format!("{first} (and {} more)", n - 1),
    }
}
