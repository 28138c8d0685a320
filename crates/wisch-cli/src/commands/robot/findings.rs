//! Findings about a robot as lines of a report; findings that differ only in link, joint or mesh share a line.

use std::fmt;
use std::mem::discriminant;
use wisch::robot::{Diagnostic, Severity, Subject};

/// Number of names that a line lists.
const NAMES_SHOWN: usize = 12;

/// Findings that differ only in line, subject and mesh, with the place of the first.
pub(super) struct FindingGroup<'a> {
    first: &'a Diagnostic,
    /// Names of the links or joints, each once.
    names: Vec<&'a str>,
    /// Files of the meshes in quotes, each once.
    meshes: Vec<&'a str>,
}

impl<'a> FindingGroup<'a> {
    /// Groups findings: errors, then warnings, then notes, each in their order.
    pub fn all(findings: &'a [Diagnostic]) -> Vec<Self> {
        let mut groups: Vec<Self> = Vec::new();
        for severity in [Severity::Error, Severity::Warning, Severity::Note] {
            for finding in findings.iter().filter(|f| f.severity == severity) {
                let place = groups.iter().position(|g| are_alike(g.first, finding));
                let place = place.unwrap_or_else(|| {
                    groups.push(Self {
                        first: finding,
                        names: Vec::new(),
                        meshes: Vec::new(),
                    });
                    groups.len() - 1
                });
                groups[place].add(finding);
            }
        }
        groups
    }

    /// Severity of the findings.
    pub fn severity(&self) -> Severity {
        self.first.severity
    }

    fn add(&mut self, finding: &'a Diagnostic) {
        if let Subject::Link(name) | Subject::Joint(name) = &finding.subject {
            push_once(&mut self.names, name);
        }
        if let (Some(mesh), _) = split_mesh(&finding.value) {
            push_once(&mut self.meshes, mesh);
        }
    }
}

impl fmt::Display for FindingGroup<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.names.len() <= 1 && self.meshes.len() <= 1 {
            return self.first.fmt(f);
        }
        let Diagnostic {
            at,
            subject,
            value,
            limit,
            advice,
            ..
        } = self.first;
        let links_or_joints = match subject {
            Subject::Joint(_) => "joints",
            _ => "links",
        };
        write!(f, "{at}: ")?;
        match self.names.len() {
            0 | 1 => write!(f, "{subject}: ")?,
            count => write!(f, "each of {count} {links_or_joints}: ")?,
        }
        match &self.meshes[..] {
            [] => {}
            [mesh] => write!(f, "mesh {mesh}: ")?,
            meshes => write!(f, "{} meshes: ", meshes.len())?,
        }
        let (_, fault) = split_mesh(value);
        write!(f, "{fault}, expected {limit}; {advice}")?;
        let names = self.names.iter().map(|name| format!("{name:?}"));
        let meshes = self.meshes.iter().map(|mesh| (*mesh).to_owned());
        match self.meshes.len() {
            0 | 1 => write!(f, " ({links_or_joints} {})", join_names(names)),
            _ => write!(f, " (meshes {})", join_names(meshes)),
        }
    }
}

/// Whether two findings differ only in line, subject of the same kind, and mesh.
fn are_alike(a: &Diagnostic, b: &Diagnostic) -> bool {
    a.severity == b.severity
        && a.kind == b.kind
        && a.at.file == b.at.file
        && discriminant(&a.subject) == discriminant(&b.subject)
        && split_mesh(&a.value).1 == split_mesh(&b.value).1
        && (&a.limit, &a.advice) == (&b.limit, &b.advice)
}

/// Splits a fault of a mesh, `mesh "FILE": fault`, into the quoted file and the fault.
fn split_mesh(value: &str) -> (Option<&str>, &str) {
    let split = value
        .strip_prefix("mesh ")
        .and_then(|rest| rest.split_once("\": "));
    match split {
        Some((file, fault)) => (Some(&value["mesh ".len()..][..=file.len()]), fault),
        None => (None, value),
    }
}

fn push_once<'a>(names: &mut Vec<&'a str>, name: &'a str) {
    if !names.contains(&name) {
        names.push(name);
    }
}

fn join_names(names: impl ExactSizeIterator<Item = String>) -> String {
    let more = names.len().saturating_sub(NAMES_SHOWN);
    let mut text = names.take(NAMES_SHOWN).collect::<Vec<_>>().join(", ");
    if more > 0 {
        text += &format!(" and {more} more");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::robot::DiagnosticKind;
    use wisch::source_location::Place;

    fn finding(line: usize, subject: Subject, kind: DiagnosticKind, value: &str) -> Diagnostic {
        let (file, column) = ("arm.urdf".to_owned(), 3);
        Diagnostic {
            severity: Severity::Note,
            at: Place { file, line, column },
            subject,
            kind,
            value: value.to_owned(),
            limit: "this".to_owned(),
            advice: "do that".to_owned(),
        }
    }

    fn shown(findings: &[Diagnostic]) -> Vec<String> {
        let groups = FindingGroup::all(findings);
        groups.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn findings_that_differ_in_the_joint_share_a_line() {
        let of_joint = |line, name: &str, value| {
            let subject = Subject::Joint(name.to_owned());
            finding(line, subject, DiagnosticKind::LimitMissing, value)
        };
        let findings = [
            of_joint(4, "a", "it has no limit"),
            of_joint(6, "b", "it has another fault"),
            of_joint(8, "c", "it has no limit"),
        ];
        assert_eq!(
            shown(&findings),
            [
                "arm.urdf:4:3: each of 2 joints: it has no limit, expected this; do that (joints \"a\", \"c\")",
                "arm.urdf:6:3: joint \"b\": it has another fault, expected this; do that",
            ]
        );
    }

    #[test]
    fn meshes_of_an_unknown_package_share_a_line() {
        let of_link = |line, name: &str, mesh: &str| {
            let subject = Subject::Link(name.to_owned());
            let value = format!("mesh {mesh:?}: the package p is unknown");
            finding(line, subject, DiagnosticKind::Mesh, &value)
        };
        let findings = [
            of_link(4, "a", "package://p/a.stl"),
            of_link(5, "a", "package://p/b.stl"),
        ];
        assert_eq!(
            shown(&findings),
            [
                "arm.urdf:4:3: link \"a\": 2 meshes: the package p is unknown, expected this; do that \
                 (meshes \"package://p/a.stl\", \"package://p/b.stl\")"
            ]
        );
        let findings: Vec<_> = (0..14)
            .map(|i| of_link(i, &format!("l{i}"), "package://p/a.stl"))
            .collect();
        let [line] = &shown(&findings)[..] else {
            panic!("one line");
        };
        let begin = "arm.urdf:0:3: each of 14 links: mesh \"package://p/a.stl\": the package p";
        assert!(line.starts_with(begin), "{line}");
        assert!(line.ends_with("\"l11\" and 2 more)"), "{line}");
    }
}
