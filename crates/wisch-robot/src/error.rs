//! Why a text is no robot, or numbers are no configuration of it.

use super::Diagnostic;
use crate::source_location::{Place, UnknownName};

/// What can be wrong with a robot or with what it is asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RobotError {
    /// The text is not XML, or no URDF.
    #[error("{at}: {problem}")]
    Syntax {
        /// Where.
        at: Place,
        /// What is wrong there.
        problem: String,
    },
    /// An attribute that does not hold what it should.
    #[error("{at}: <{element} {attribute}={text:?}>: expected {expected}")]
    Attribute {
        /// Where its element starts.
        at: Place,
        /// The element.
        element: String,
        /// The attribute.
        attribute: &'static str,
        /// What it holds; empty if it is missing.
        text: String,
        /// What it should hold.
        expected: &'static str,
    },
    /// More than is read.
    #[error("{file}: {what}: {value} exceeds the limit of {limit}")]
    TooLarge {
        /// The name of the text.
        file: String,
        /// What there is too much of.
        what: &'static str,
        /// How much there is.
        value: usize,
        /// How much there may be.
        limit: usize,
    },
    /// The text is a URDF, but describes no tree of links that could move.
    #[error("{file}: {}", first_of(diagnostics))]
    Unusable {
        /// The name of the text.
        file: String,
        /// The faults, at least one, in the order of the text.
        diagnostics: Vec<Diagnostic>,
    },
    /// A link or joint that the robot does not have.
    #[error("robot {robot:?}: {unknown}")]
    Unknown {
        /// The robot.
        robot: String,
        /// The name and those near it.
        unknown: Box<UnknownName>,
    },
    /// A text that names something the robot does not have.
    #[error("{at}: {unknown}")]
    UnknownAt {
        /// Where.
        at: Place,
        /// The name and those near it.
        unknown: Box<UnknownName>,
    },
    /// A name that nothing bears: a body of a collision model, or a group or posture of an SRDF.
    #[error("{0}")]
    NoSuch(Box<UnknownName>),
    /// A link of another robot.
    #[error("link number {link} is none of the robot's {links} links")]
    ForeignLink {
        /// The link's position.
        link: usize,
        /// How many links the robot has.
        links: usize,
    },
    /// A name that a link, body or obstacle already has.
    #[error("body {name:?}: a link, body or obstacle of that name exists")]
    NameTaken {
        /// The name.
        name: String,
    },
    /// A body or obstacle whose geometry cannot be used.
    #[error("body {name:?}: {problem}")]
    Obstacle {
        /// Its name.
        name: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A distance that is negative or no number.
    #[error("{what} is {value} m, expected at least 0 m")]
    Distance {
        /// Which distance.
        what: &'static str,
        /// Its value [m].
        value: f64,
    },
    /// An array of another length than the robot has variables.
    #[error("{what} has {found} values, the robot has {expected} variables")]
    Length {
        /// Which array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length it should have.
        expected: usize,
    },
    /// A value that is infinite or no number.
    #[error("joint {joint:?}: {what} {value} is not finite")]
    NotFinite {
        /// The joint.
        joint: String,
        /// Which array.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// A value that is not what it may be.
    #[error("{what} is {value}: it must be {limit}")]
    Value {
        /// What has the value.
        what: &'static str,
        /// The value.
        value: f64,
        /// What it must be, with its unit.
        limit: &'static str,
    },
    /// The tip is not held by the base.
    #[error("link {tip:?} does not hang on link {base:?}; it hangs on: {}", ancestors.join(", "))]
    NoChain {
        /// Where the chain should begin.
        base: String,
        /// Where it should end.
        tip: String,
        /// The links that hold the tip, the nearest first.
        ancestors: Vec<String>,
    },
    /// A chain of more joints or variables than fit.
    #[error("chain {base:?} to {tip:?}: {value} {what} exceed the limit of {limit}")]
    ChainTooLong {
        /// Where the chain begins.
        base: String,
        /// Where it ends.
        tip: String,
        /// What there is too much of.
        what: &'static str,
        /// How much there is.
        value: usize,
        /// How much there may be.
        limit: usize,
    },
    /// A joint that moves nothing that has inertia.
    #[error(
        "joint {joint:?} moves an inertia of {value:e} (kg or kg m2), below the limit of {limit:e}: give link {link:?} or one it holds an <inertial>"
    )]
    NoInertia {
        /// The joint.
        joint: String,
        /// The link that it moves.
        link: String,
        /// The inertia about, or mass along, the joint's axis [kg m² or kg].
        value: f64,
        /// What it must exceed [kg m² or kg].
        limit: f64,
    },
}

impl RobotError {
    /// Where it is, what was found there, and what was expected, for a diagnostic; `whole` is what the whole should be.
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
