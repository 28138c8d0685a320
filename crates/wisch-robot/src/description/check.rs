//! Checks of a URDF.

mod limits;
mod tolerated;

use super::collision::{Collision, load_shapes};
use super::diagnostics::{Diagnostics, words};
use super::elements::{Urdf, UrdfInertial, UrdfJoint};
use super::units;
use crate::source_location::UnknownName;
use crate::{Diagnostic, DiagnosticKind, RobotError, Severity, Subject};
use limits::check_limits;
use std::collections::{BTreeMap, BTreeSet};
use tolerated::tolerate;

/// Largest number of links between the root and a tip; a deeper URDF is rejected.
pub const MAX_DEPTH: usize = 200;

/// Tolerance of the length of an axis, for six printed digits.
const AXIS_TOLERANCE: f64 = 1e-5;

/// Tolerance of the triangle inequality of principal inertias, as a share of the largest, for four printed digits.
const TRIANGLE_TOLERANCE: f64 = 1e-4;

/// Checks a URDF, and returns all findings. `name` identifies the text in messages. `meshes` returns the bytes of a
/// collision mesh, given its file name in the URDF, or an error text.
///
/// If a finding is a [`Severity::Error`], [`RobotModel::from_urdf`](crate::RobotModel::from_urdf)
/// rejects the text.
///
/// ```
/// use wisch_robot::{DiagnosticKind, check};
/// let text = r#"<robot name="r"><link name="a"/><link name="b"/>
///   <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 2"/></joint>
/// </robot>"#;
/// let diagnostics = check("r.urdf", text, &mut |_| Err("no meshes here".into()))?;
/// assert!(diagnostics.iter().any(|f| f.kind == DiagnosticKind::Axis && f.at.line == 2));
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
///
/// # Errors
/// If the text is no XML or no URDF, or exceeds a limit.
pub fn check(
    name: &str,
    text: &str,
    meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<Diagnostic>, RobotError> {
    Ok(Checked::new(name, text, meshes)?.diagnostics)
}

/// A URDF with its diagnostics, and its collision shapes by link.
pub(crate) struct Checked {
    pub urdf: Urdf,
    pub diagnostics: Vec<Diagnostic>,
    pub collision: Vec<Vec<Collision>>,
}

impl Checked {
    pub fn new(
        name: &str,
        text: &str,
        meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, RobotError> {
        let mut urdf = Urdf::read(name, text)?;
        let mut report = Diagnostics {
            file: name,
            text,
            diagnostics: std::mem::take(&mut urdf.findings),
        };
        tolerate(&mut urdf, &mut report);
        names(&urdf, &mut report);
        tree(&urdf, &mut report);
        for joint in &urdf.joints {
            check_joint(joint, &urdf, &mut report);
        }
        mimics(&urdf, &mut report);
        inertias(&urdf, &mut report);
        let reach = units::reach(&urdf);
        units::check(&urdf, reach, &mut report);
        let collision = load_shapes(&urdf, reach, meshes, &mut report);
        let mut diagnostics = report.diagnostics;
        diagnostics.sort_by_key(|f| (f.at.line, f.at.column));
        Ok(Self {
            urdf,
            diagnostics,
            collision,
        })
    }
}

fn link(name: &str) -> Subject {
    Subject::Link(name.to_owned())
}

fn joint(name: &str) -> Subject {
    Subject::Joint(name.to_owned())
}

/// Checks for duplicate and unknown names.
fn names(urdf: &Urdf, report: &mut Diagnostics) {
    let unique = "a unique name";
    let mut seen = BTreeSet::new();
    for l in &urdf.links {
        if !seen.insert(&l.name) {
            let w = words(
                "an earlier link has the same name",
                unique,
                "rename one of them",
            );
            report.error(DiagnosticKind::DuplicateName, link(&l.name), l.at, w);
        }
    }
    let mut joints = BTreeSet::new();
    for j in &urdf.joints {
        if !joints.insert(&j.name) {
            let w = words(
                "an earlier joint has the same name",
                unique,
                "rename one of them",
            );
            report.error(DiagnosticKind::DuplicateName, joint(&j.name), j.at, w);
        }
        for (role, end) in [("parent", &j.parent), ("child", &j.child)] {
            if !seen.contains(end) {
                let unknown = UnknownName::new("link", end, seen.iter().map(|name| name.as_str()));
                let w = words(
                    format!("its {role} is {unknown}"),
                    "a link of this robot",
                    "correct the name or add the link",
                );
                report.error(DiagnosticKind::UnknownName, joint(&j.name), j.at, w);
            }
        }
    }
}

/// Checks for a single root, one parent per link, no cycles and limited depth.
fn tree(urdf: &Urdf, report: &mut Diagnostics) {
    let mut parent_of: BTreeMap<&str, &UrdfJoint> = BTreeMap::new();
    for j in &urdf.joints {
        if let Some(first) = parent_of.get(j.child.as_str()) {
            let w = words(
                format!(
                    "link {:?} is already the child of joint {:?}",
                    j.child, first.name
                ),
                "one parent per link",
                "remove one of the joints; closed loops are not supported",
            );
            report.error(DiagnosticKind::SeveralParents, joint(&j.name), j.at, w);
        } else {
            parent_of.insert(&j.child, j);
        }
    }
    let referenced: BTreeSet<&str> = urdf
        .joints
        .iter()
        .flat_map(|j| [j.parent.as_str(), j.child.as_str()])
        .collect();
    let is_root = |name: &str| !parent_of.contains_key(name);
    let mut roots = urdf.links.iter().filter(|l| is_root(&l.name));
    let first_root = roots.find(|l| urdf.links.len() == 1 || referenced.contains(l.name.as_str()));
    for l in urdf.links.iter().filter(|l| is_root(&l.name)) {
        if first_root.is_some_and(|first| std::ptr::eq(first, l)) {
            continue;
        }
        if !referenced.contains(l.name.as_str()) && urdf.links.len() > 1 {
            let w = words(
                "it belongs to no joint",
                "a parent or a child of some joint",
                "attach it by a joint (type fixed) or remove it",
            );
            report.error(DiagnosticKind::UnreferencedLink, link(&l.name), l.at, w);
        } else {
            let root = first_root.map_or("", |first| first.name.as_str());
            let w = words(
                format!("it has no parent, and link {root:?} has none either"),
                "one root",
                "attach it by a joint",
            );
            report.error(DiagnosticKind::SeveralRoots, link(&l.name), l.at, w);
        }
    }
    depth(urdf, &parent_of, report);
}

/// Walks from each link to its root, and stops where an earlier walk has been.
fn depth(urdf: &Urdf, parent_of: &BTreeMap<&str, &UrdfJoint>, report: &mut Diagnostics) {
    let mut depth_of: BTreeMap<&str, usize> = BTreeMap::new();
    for l in &urdf.links {
        let mut path: Vec<&str> = Vec::new();
        let mut on_path = BTreeSet::new();
        let mut at = l.name.as_str();
        let base = loop {
            if let Some(&known) = depth_of.get(at) {
                break known;
            }
            if !on_path.insert(at) {
                let w = words(
                    "it is its own ancestor",
                    "a tree",
                    "remove a joint of the cycle",
                );
                report.error(DiagnosticKind::Cycle, link(at), l.at, w);
                break 0;
            }
            path.push(at);
            match parent_of.get(at) {
                Some(j) => at = &j.parent,
                None => break 0,
            }
        };
        for (i, name) in path.iter().rev().enumerate() {
            depth_of.insert(name, base + i + 1);
        }
        if base + path.len() > MAX_DEPTH + 1 {
            let w = words(
                format!("there are {} joints above it", base + path.len() - 1),
                format!("at most {MAX_DEPTH}"),
                "merge links that do not move against each other",
            );
            report.error(DiagnosticKind::Depth, link(&l.name), l.at, w);
        }
    }
}

/// Checks type, axis and limits of a joint.
fn check_joint(j: &UrdfJoint, urdf: &Urdf, report: &mut Diagnostics) {
    let subject = || joint(&j.name);
    match j.kind.as_str() {
        "fixed" => return,
        // A planar joint that could not be split has no axis.
        "revolute" | "continuous" | "prismatic" | "planar" => {}
        other => {
            let known = ["fixed", "revolute", "continuous", "prismatic", "planar"];
            let unknown = UnknownName::new("joint type", other, known);
            let w = words(unknown.to_string(), known.join(", "), "correct the type");
            return report.error(DiagnosticKind::JointType, subject(), j.at, w);
        }
    }
    let length = j.axis.norm();
    let how = "make the axis a unit vector";
    if length < AXIS_TOLERANCE {
        let w = words(format!("its axis has length {length}"), "length 1", how);
        report.error(DiagnosticKind::Axis, subject(), j.at, w);
    } else if (length - 1.0).abs() > AXIS_TOLERANCE {
        let w = words(
            format!("its axis has length {length}"),
            "length 1",
            format!("{how}; it is normalised here"),
        );
        report.add(Severity::Warning, DiagnosticKind::Axis, subject(), j.at, w);
    }
    let follows = urdf.mimics.iter().any(|m| m.joint == j.name);
    check_limits(j, follows, report);
}

/// Checks joints that follow others: those must exist, move, and not follow back.
fn mimics(urdf: &Urdf, report: &mut Diagnostics) {
    let by_name: BTreeMap<&str, &UrdfJoint> =
        urdf.joints.iter().map(|j| (j.name.as_str(), j)).collect();
    let mut seen = BTreeSet::new();
    for m in &urdf.mimics {
        let subject = || joint(&m.joint);
        let mut names = vec![&m.joint];
        names.extend(m.terms.iter().map(|(name, _)| name));
        for name in names {
            match by_name.get(name.as_str()) {
                None => {
                    let unknown = UnknownName::new("joint", name, by_name.keys().copied());
                    let w = words(
                        unknown.to_string(),
                        "a joint of this robot",
                        "correct the name",
                    );
                    report.error(DiagnosticKind::UnknownName, subject(), m.at, w);
                }
                Some(j) if j.kind == "fixed" => {
                    let w = words(
                        format!("joint {name:?} is fixed"),
                        "joints that move",
                        "remove the mimic",
                    );
                    report.error(DiagnosticKind::Mimic, subject(), m.at, w);
                }
                Some(_) => {}
            }
        }
        if !seen.insert(&m.joint) {
            let w = words(
                "it has more than one <mimic>",
                "one <mimic>",
                "keep one of them",
            );
            report.error(DiagnosticKind::Mimic, subject(), m.at, w);
        }
        if m.terms.is_empty() {
            let w = words("its mimic has no term", "a <term>", "add one");
            report.error(DiagnosticKind::Mimic, subject(), m.at, w);
        }
    }
    // A joint that cannot be reduced to independent joints is part of a cycle.
    let mut waiting: Vec<_> = urdf.mimics.iter().collect();
    loop {
        let names: BTreeSet<&str> = waiting.iter().map(|m| m.joint.as_str()).collect();
        let before = waiting.len();
        waiting.retain(|m| {
            m.terms
                .iter()
                .any(|(name, _)| names.contains(name.as_str()))
        });
        if waiting.len() == before {
            break;
        }
    }
    for m in waiting {
        let w = words(
            "it follows itself, directly or through other joints",
            "joints that lead to independent ones",
            "remove a mimic of the cycle",
        );
        report.error(DiagnosticKind::Mimic, joint(&m.joint), m.at, w);
    }
}

/// Checks for physically impossible bodies, and joints that move no inertia.
fn inertias(urdf: &Urdf, report: &mut Diagnostics) {
    for l in &urdf.links {
        if let Some(inertial) = &l.inertial {
            impossible_inertia(&l.name, inertial, report);
        }
    }
    // A joint moves its child and everything fixed to it, up to the next moving joints.
    let mut children: BTreeMap<&str, Vec<&UrdfJoint>> = BTreeMap::new();
    for j in &urdf.joints {
        children.entry(j.parent.as_str()).or_default().push(j);
    }
    let mass: BTreeMap<&str, f64> = urdf
        .links
        .iter()
        .map(|l| (l.name.as_str(), l.inertial.as_ref().map_or(0.0, |i| i.mass)))
        .collect();
    for j in urdf.joints.iter().filter(|j| j.kind != "fixed") {
        let mut group = vec![j.child.as_str()];
        let mut visited = BTreeSet::new();
        let mut total = 0.0;
        let mut holds_others = false;
        while let Some(name) = group.pop() {
            if !visited.insert(name) {
                continue;
            }
            total += mass.get(name).copied().unwrap_or(0.0);
            for below in children.get(name).into_iter().flatten() {
                match below.kind.as_str() {
                    "fixed" => group.push(&below.child),
                    _ => holds_others = true,
                }
            }
        }
        if total <= 0.0 {
            let severity = match holds_others {
                true => Severity::Note,
                false => Severity::Warning,
            };
            let w = words(
                "it has no mass, and neither have the links fixed to it",
                "above 0 kg",
                match holds_others {
                    true => "fine for an auxiliary link, as its children have their own",
                    false => {
                        "add <inertial> with mass and inertia; without it 500 kg/m3 in the box around its shapes is assumed"
                    }
                },
            );
            report.add(
                severity,
                DiagnosticKind::InertiaMissing,
                link(&j.child),
                j.at,
                w,
            );
        }
    }
}

fn impossible_inertia(name: &str, inertial: &UrdfInertial, report: &mut Diagnostics) {
    let mut warn = |value: String, limit: &str, advice: &str| {
        let w = words(value, limit, advice);
        report.add(
            Severity::Warning,
            DiagnosticKind::Inertia,
            link(name),
            inertial.at,
            w,
        );
    };
    if inertial.mass < 0.0 {
        warn(
            format!("its mass is {} kg", inertial.mass),
            "above 0 kg",
            "correct it",
        );
        return;
    }
    let mut principal: Vec<f64> = inertial
        .about_center
        .symmetric_eigenvalues()
        .iter()
        .copied()
        .collect();
    principal.sort_by(f64::total_cmp);
    let [least, middle, greatest] = principal[..] else {
        return;
    };
    let shown =
        format!("its principal inertias are {least:.3e}, {middle:.3e}, {greatest:.3e} kg m2");
    if inertial.mass == 0.0 && greatest == 0.0 {
        return;
    }
    if inertial.mass == 0.0 {
        warn(
            format!("{shown}, but its mass is 0 kg"),
            "mass above 0 kg",
            "add the mass",
        );
    } else if least <= 0.0 {
        warn(
            shown,
            "above 0 kg m2",
            "compute them from the shape and the mass",
        );
    } else if greatest - least - middle > TRIANGLE_TOLERANCE * greatest {
        warn(
            shown,
            "none greater than the sum of the others (triangle inequality)",
            "they are physically impossible: compute them from the shape and the mass",
        );
    }
}
