//! Diagnostics of a robot's descriptions, URDF and SRDF: what a check reports, where and how severe.

use crate::source_location::Place;
use std::fmt;

/// How much a diagnostic matters, the least first: [`Severity::Error`] alone keeps a robot from being made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing; the robot works.
    Note,
    /// Something will go wrong: limits that do not hold, dynamics that cannot be computed.
    Warning,
    /// No robot can be made of this.
    Error,
}

impl Severity {
    /// The word in reports and JSON: "note", "warning" or "error".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// The part of a robot that a diagnostic is about, by its name in the URDF.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Subject {
    /// The robot as a whole.
    Robot,
    /// The link of this name.
    Link(String),
    /// The joint of this name.
    Joint(String),
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Robot => f.write_str("robot"),
            Self::Link(name) => write!(f, "link {name:?}"),
            Self::Joint(name) => write!(f, "joint {name:?}"),
        }
    }
}

/// What is missing or inconsistent in a URDF or an SRDF; reports name it by [`DiagnosticKind::as_str`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum DiagnosticKind {
    /// Two links or two joints of one name.
    DuplicateName,
    /// A joint names a link, or a mimic a joint, that does not exist.
    UnknownName,
    /// A joint type that is not read.
    JointType,
    /// A link is the child of several joints.
    SeveralParents,
    /// More than one link has no parent.
    SeveralRoots,
    /// Links hold each other in a circle.
    Cycle,
    /// No joint names the link.
    UnreferencedLink,
    /// The tree is deeper than is read.
    Depth,
    /// The axis of a joint is not of length one.
    Axis,
    /// A limit is missing or infinite.
    LimitMissing,
    /// A limit that nothing can obey, such as lower above upper or a velocity of zero.
    Limit,
    /// A joint follows itself, a fixed joint, or nothing.
    Mimic,
    /// A joint moves what has no mass or inertia.
    InertiaMissing,
    /// A mass or inertia that no body has.
    Inertia,
    /// No shape to check collisions with.
    CollisionMissing,
    /// A mesh cannot be read.
    Mesh,
    /// A mesh that was most likely drawn in other units.
    MeshScale,
    /// Lengths, masses or angles that were most likely given in other units.
    Units,
    /// Visual geometry that cannot be read.
    Visual,
    /// An SRDF that is none of this robot's, or says what cannot be.
    Srdf,
}

impl DiagnosticKind {
    /// The kind as reports write it, such as "mesh-scale".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::DuplicateName => "duplicate-name",
            Self::UnknownName => "unknown-name",
            Self::JointType => "joint-type",
            Self::SeveralParents => "several-parents",
            Self::SeveralRoots => "several-roots",
            Self::Cycle => "cycle",
            Self::UnreferencedLink => "unreferenced-link",
            Self::Depth => "depth",
            Self::Axis => "axis",
            Self::LimitMissing => "limit-missing",
            Self::Limit => "limit",
            Self::Mimic => "mimic",
            Self::InertiaMissing => "inertia-missing",
            Self::Inertia => "inertia",
            Self::CollisionMissing => "collision-missing",
            Self::Mesh => "mesh",
            Self::MeshScale => "mesh-scale",
            Self::Units => "units",
            Self::Visual => "visual",
            Self::Srdf => "srdf",
        }
    }
}

/// One thing that is missing or odd in the description of a robot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// Where the text says it.
    pub at: Place,
    /// Whom it concerns.
    pub subject: Subject,
    /// What kind of thing it is.
    pub kind: DiagnosticKind,
    /// What was found, with its unit.
    pub value: String,
    /// What it should be.
    pub limit: String,
    /// What to do about it.
    pub advice: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}: {}: {}, expected {}; {}",
            self.at, self.subject, self.value, self.limit, self.advice
        )
    }
}

/// Collects diagnostics with their places.
pub(crate) struct Diagnostics<'a> {
    pub file: &'a str,
    pub text: &'a str,
    pub diagnostics: Vec<Diagnostic>,
}

/// What was found, what was expected, and what to do.
pub(crate) struct Words {
    pub value: String,
    pub limit: String,
    pub advice: String,
}

pub(crate) fn words(
    value: impl Into<String>,
    limit: impl Into<String>,
    advice: impl Into<String>,
) -> Words {
    Words {
        value: value.into(),
        limit: limit.into(),
        advice: advice.into(),
    }
}

impl Diagnostics<'_> {
    pub fn add(
        &mut self,
        severity: Severity,
        kind: DiagnosticKind,
        subject: Subject,
        offset: usize,
        words: Words,
    ) {
        self.diagnostics.push(Diagnostic {
            severity,
            at: Place::at_offset(self.file, self.text, offset),
            subject,
            kind,
            value: words.value,
            limit: words.limit,
            advice: words.advice,
        });
    }

    pub fn error(&mut self, kind: DiagnosticKind, subject: Subject, offset: usize, words: Words) {
        self.add(Severity::Error, kind, subject, offset, words);
    }
}
