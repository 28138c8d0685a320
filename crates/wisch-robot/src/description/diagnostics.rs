//! Diagnostics of a URDF or an SRDF, with place and severity.

use crate::source_location::Place;
use std::fmt;

/// Severity of a diagnostic, the least first; only [`Severity::Error`] prevents a robot model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing, without consequences.
    Note,
    /// The robot can be used with restrictions: limits are not kept, or dynamics cannot be
    /// computed.
    Warning,
    /// No robot model can be made of the text.
    Error,
}

impl Severity {
    /// Name in reports and JSON: "note", "warning" or "error".
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

/// Kind of a diagnostic; reports show it by [`DiagnosticKind::as_str`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum DiagnosticKind {
    /// The text breaks a rule of XML or of its format, but is unambiguous.
    Syntax,
    /// Two links or two joints of the same name.
    DuplicateName,
    /// A joint names a link, or a mimic names a joint, that does not exist.
    UnknownName,
    /// An unsupported joint type.
    JointType,
    /// A link is the child of several joints.
    SeveralParents,
    /// More than one link has no parent.
    SeveralRoots,
    /// A cycle of links.
    Cycle,
    /// A link without a joint.
    UnreferencedLink,
    /// A tree that is too deep.
    Depth,
    /// An axis that is not a unit vector.
    Axis,
    /// A limit of velocity, acceleration or effort is missing or infinite.
    LimitMissing,
    /// An impossible limit, such as lower above upper or a velocity of 0, or a position limit that is missing.
    Limit,
    /// A joint that follows itself, a fixed joint, or no joint.
    Mimic,
    /// A joint that moves no mass or inertia.
    InertiaMissing,
    /// A physically impossible mass or inertia.
    Inertia,
    /// No shape for collision checks.
    CollisionMissing,
    /// A mesh that cannot be read.
    Mesh,
    /// A mesh that is probably in other units.
    MeshScale,
    /// Lengths, masses or angles that are probably in other units.
    Units,
    /// Visual geometry that cannot be read.
    Visual,
    /// An SRDF of another robot, or one that contradicts the URDF.
    Srdf,
}

impl DiagnosticKind {
    /// Name of the kind in reports, such as "mesh-scale".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Syntax => "syntax",
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

/// A finding about the description of a robot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Place in the text.
    pub at: Place,
    /// Part of the robot concerned.
    pub subject: Subject,
    /// Kind of the finding.
    pub kind: DiagnosticKind,
    /// What was found, with its unit.
    pub value: String,
    /// Expected value.
    pub limit: String,
    /// Advice on how to correct it.
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

/// Collector of diagnostics with their places.
pub(crate) struct Diagnostics<'a> {
    pub file: &'a str,
    pub text: &'a str,
    pub diagnostics: Vec<Diagnostic>,
}

/// Finding, expectation and advice of a diagnostic.
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
            at: Place::from_offset(self.file, self.text, offset),
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
