//! Faults of a URDF that other programs accept; each fault is corrected in the robot that was read,
//! with a warning.

use super::{joint, link};
use crate::description::diagnostics::{Diagnostics, words};
use crate::description::elements::{Urdf, UrdfLink};
use crate::source_location::UnknownName;
use crate::{DiagnosticKind, Severity};
use std::collections::BTreeMap;

/// Name of the link that URDFs may leave out.
const WORLD: &str = "world";

/// Corrects the faults that have only one sensible correction.
pub(super) fn tolerate(urdf: &mut Urdf, report: &mut Diagnostics) {
    fix_floating_joints(urdf, report);
    add_world(urdf, report);
    order_limits(urdf, report);
    drop_mimics_without_source(urdf, report);
}

/// Fixes floating joints at their origins.
fn fix_floating_joints(urdf: &mut Urdf, report: &mut Diagnostics) {
    for j in urdf.joints.iter_mut().filter(|j| j.kind == "floating") {
        let w = words(
            "type \"floating\"",
            "fixed, revolute, continuous, prismatic or planar",
            "it is held at its origin, as if it were fixed; make it planar if this is a base that drives",
        );
        let (severity, kind) = (Severity::Warning, DiagnosticKind::JointType);
        report.add(severity, kind, joint(&j.name), j.at, w);
        "fixed".clone_into(&mut j.kind);
    }
}

/// Adds the link "world", which Drake has even if a URDF does not define it.
fn add_world(urdf: &mut Urdf, report: &mut Diagnostics) {
    if urdf.links.iter().any(|known| known.name == WORLD) {
        return;
    }
    let Some(j) = urdf.joints.iter().find(|j| j.parent == WORLD) else {
        return;
    };
    let w = words(
        format!("joint {:?} begins at it, but it is not defined", j.name),
        format!("<link name={WORLD:?}/>"),
        "it is added as the root; define it for other programs",
    );
    let (severity, kind) = (Severity::Warning, DiagnosticKind::UnknownName);
    report.add(severity, kind, link(WORLD), j.at, w);
    urdf.links.push(UrdfLink {
        name: WORLD.to_owned(),
        at: j.at,
        inertial: None,
        shapes: Vec::new(),
    });
}

/// Exchanges position limits of which the lower is above the upper.
fn order_limits(urdf: &mut Urdf, report: &mut Diagnostics) {
    for j in urdf.joints.iter_mut().filter(|j| j.kind != "continuous") {
        let unit = if j.kind == "prismatic" { "m" } else { "rad" };
        let Some(limit) = &mut j.limit else {
            continue;
        };
        let (Some(lower), Some(upper)) = (limit.lower, limit.upper) else {
            continue;
        };
        if lower > upper {
            let w = words(
                format!("lower {lower} {unit} is above upper {upper} {unit}"),
                "lower <= upper",
                format!(
                    "the joint is kept within {upper} and {lower} {unit}; exchange them, or make the joint continuous if it has no limits"
                ),
            );
            let (severity, kind) = (Severity::Warning, DiagnosticKind::Limit);
            report.add(severity, kind, joint(&j.name), j.at, w);
            (limit.lower, limit.upper) = (Some(upper), Some(lower));
        }
    }
}

/// Drops the `<mimic>` of joints that are fixed, and those of a fixed joint or of none.
fn drop_mimics_without_source(urdf: &mut Urdf, report: &mut Diagnostics) {
    let kinds: BTreeMap<&str, &str> = (urdf.joints.iter())
        .map(|j| (j.name.as_str(), j.kind.as_str()))
        .collect();
    let is_fixed = |name: &str| kinds.get(name) == Some(&"fixed");
    urdf.mimics.retain(|m| {
        // Some robots keep the mimic from a version in which the joint moved.
        if is_fixed(&m.joint) {
            let w = words(
                "it is fixed and has a <mimic>, which is ignored",
                "a joint that moves",
                "remove the mimic",
            );
            let (severity, kind) = (Severity::Note, DiagnosticKind::Mimic);
            report.add(severity, kind, joint(&m.joint), m.at, w);
            return false;
        }
        // The extension of several terms is wisch's own, and its faults remain errors.
        let [(source, _)] = &m.terms[..] else {
            return true;
        };
        let (kind, problem) = if is_fixed(source) {
            let problem = format!("it follows joint {source:?}, which is fixed");
            (DiagnosticKind::Mimic, problem)
        } else if kinds.contains_key(source.as_str()) {
            return true;
        } else {
            let unknown = UnknownName::new("joint", source, kinds.keys().copied());
            (DiagnosticKind::UnknownName, format!("it follows {unknown}"))
        };
        let w = words(
            problem,
            "a joint of this robot that moves",
            "the <mimic> is ignored, so the joint moves on its own; correct the name, or remove the mimic",
        );
        report.add(Severity::Warning, kind, joint(&m.joint), m.at, w);
        false
    });
}
