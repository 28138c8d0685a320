//! Checks whether lengths, masses and angles of a URDF are in metres, kilograms and radians.

use super::collision::significant;
use super::diagnostics::{Diagnostics, words};
use super::elements::{Urdf, UrdfJoint};
use crate::geometry::LikelyUnits;
use crate::{DiagnosticKind, Severity, Subject};
use std::collections::BTreeMap;

/// Usual range of a robot's reach from its root to its farthest link, along its joints [m], and the largest reach that
/// is accepted: more than any wiping arm or task needs.
const USUAL_REACH: [f64; 2] = [0.02, 20.0];
const MOST_REACH: f64 = 100.0;
/// Largest mass over the cube of the reach [kg/m³] for robots above a least mass [kg]; an industrial arm has 150, a
/// mobile manipulator 1300.
const MOST_MASS_PER_REACH: f64 = 3000.0;
const LIGHT: f64 = 500.0;
/// Largest usual limit of a revolute joint [rad], and the largest usual value of one in degrees.
const MOST_TURN: f64 = 30.0;
const MOST_DEGREES: f64 = 720.0;
/// Largest usual velocity of a joint with position limits, and of one without, such as that of a wheel [rad/s].
const MOST_SPEED: f64 = 20.0;
const MOST_SPEED_OF_WHEEL: f64 = 60.0;
/// Largest usual position limit of a prismatic joint [m], and its usual range.
const MOST_SLIDE: f64 = 20.0;
const USUAL_SLIDE: [f64; 2] = [0.1, 4.0];
/// Largest usual velocity [m/s] and acceleration [m/s2] of a prismatic joint; fast linear motors have 5 and 50.
const MOST_SLIDE_SPEED: f64 = 10.0;
const MOST_SLIDE_ACCELERATION: f64 = 100.0;
/// Largest radius of gyration of a link over the reach of the robot [1], and the least value of that limit [m].
const GYRATION_PER_REACH: f64 = 3.0;
const LEAST_GYRATION: f64 = 1.0;

/// Returns the largest distance of a link from the root along the origins of the joints [m]; 0 for a single link.
pub(super) fn reach(urdf: &Urdf) -> f64 {
    let parents = urdf
        .joints
        .iter()
        .map(|joint| (joint.child.as_str(), joint));
    let parent_of: BTreeMap<&str, &UrdfJoint> = parents.collect();
    let length = |link: &str| {
        let above = std::iter::successors(parent_of.get(link), |joint| {
            parent_of.get(joint.parent.as_str())
        });
        let lengths = above.map(|joint| joint.parent_from_joint.translation.vector.norm());
        // The limit ends walks along cycles of links, which another check reports.
        lengths.take(urdf.links.len()).sum::<f64>()
    };
    let links = urdf.links.iter().map(|link| length(&link.name));
    links.fold(0.0, f64::max)
}

/// Reports values that are probably in other units; `reach` is that of [`reach`] [m].
pub(super) fn check(urdf: &Urdf, reach: f64, report: &mut Diagnostics) {
    let [least, most] = USUAL_REACH;
    let is_arm = urdf
        .joints
        .iter()
        .filter(|joint| joint.kind == "revolute")
        .count()
        > 2;
    if reach > most || is_arm && reach > 0.0 && reach < least {
        let severity = match reach > MOST_REACH {
            true => Severity::Error,
            false => Severity::Warning,
        };
        let usual = [10.0 * least, most / 5.0];
        let advice = match LikelyUnits::guess(reach, usual, usual) {
            Some(units) => format!("{units}, in origins, shapes and limits of sliding joints"),
            None => "give lengths in metres".to_owned(),
        };
        let w = words(
            format!(
                "its joints are {} m from the root to the farthest link",
                significant(reach)
            ),
            format!("{least} m to {most} m"),
            advice,
        );
        report.add(severity, DiagnosticKind::Units, Subject::Robot, 0, w);
    }
    masses(urdf, reach, report);
    for joint in urdf.joints.iter().filter(|joint| joint.kind == "revolute") {
        angles(joint, report);
    }
    for joint in &urdf.joints {
        speed(joint, report);
    }
    for joint in urdf.joints.iter().filter(|joint| joint.kind == "prismatic") {
        slide(urdf, joint, report);
    }
}

fn masses(urdf: &Urdf, reach: f64, report: &mut Diagnostics) {
    let bodies = || {
        let links = urdf.links.iter();
        links.filter_map(|link| Some((link, link.inertial.as_ref()?)))
    };
    let mass: f64 = bodies().map(|(_, body)| body.mass).sum();
    let most = MOST_MASS_PER_REACH * reach.powi(3);
    if reach > 0.0 && mass > LIGHT.max(most) {
        let w = words(
            format!("it weighs {mass:.0} kg and reaches {reach:.2} m"),
            format!("at most {:.0} kg", LIGHT.max(most)),
            "its masses are probably in grams: multiply masses and inertias by 0.001",
        );
        report.add(
            Severity::Warning,
            DiagnosticKind::Units,
            Subject::Robot,
            0,
            w,
        );
    }
    let most = (GYRATION_PER_REACH * reach).max(LEAST_GYRATION);
    for (link, body) in bodies().filter(|(_, body)| body.mass > 0.0) {
        let greatest = body.about_center.symmetric_eigenvalues().max();
        let gyration = (greatest / body.mass).sqrt();
        if gyration > most {
            let w = words(
                format!(
                    "its inertia of {greatest:.3e} kg m2 is that of {} kg that lie {gyration:.1} m from their centre",
                    body.mass
                ),
                format!("at most {most:.1} m"),
                "it is probably in kg mm2, or in g mm2: multiply by 1e-6, or by 1e-9",
            );
            let subject = Subject::Link(link.name.clone());
            report.add(
                Severity::Warning,
                DiagnosticKind::Units,
                subject,
                body.at,
                w,
            );
        }
    }
}

fn angles(joint: &UrdfJoint, report: &mut Diagnostics) {
    let limit = joint.limit.unwrap_or_default();
    let (Some(lower), Some(upper)) = (limit.lower, limit.upper) else {
        return;
    };
    let widest = lower.abs().max(upper.abs());
    if widest > MOST_TURN && widest <= MOST_DEGREES {
        let w = words(
            format!("it turns from {lower} to {upper} rad"),
            format!("within {MOST_TURN} rad"),
            "its limits are probably in degrees: multiply by 0.0174533; a joint that turns without limits is continuous",
        );
        let subject = Subject::Joint(joint.name.clone());
        report.add(
            Severity::Warning,
            DiagnosticKind::Units,
            subject,
            joint.at,
            w,
        );
    }
}

/// Reports a limit of velocity that is probably in degrees per second.
fn speed(joint: &UrdfJoint, report: &mut Diagnostics) {
    let most = match joint.kind.as_str() {
        "revolute" => MOST_SPEED,
        "continuous" => MOST_SPEED_OF_WHEEL,
        _ => return,
    };
    let Some(velocity) = joint.limit.and_then(|limit| limit.velocity) else {
        return;
    };
    if velocity > most {
        let w = words(
            format!("its velocity limit is {velocity} rad/s"),
            format!("at most {most} rad/s"),
            "it is probably in degrees per second: multiply by 0.0174533; motions use this limit",
        );
        let (severity, kind) = (Severity::Warning, DiagnosticKind::Units);
        let subject = Subject::Joint(joint.name.clone());
        report.add(severity, kind, subject, joint.at, w);
    }
}

/// Reports limits of a prismatic joint that are probably not in metres.
fn slide(urdf: &Urdf, joint: &UrdfJoint, report: &mut Diagnostics) {
    let limit = joint.limit.unwrap_or_default();
    let mut warn = |value: String, limit: String, advice: String| {
        let (severity, kind) = (Severity::Warning, DiagnosticKind::Units);
        let subject = Subject::Joint(joint.name.clone());
        report.add(
            severity,
            kind,
            subject,
            joint.at,
            words(value, limit, advice),
        );
    };
    if let (Some(lower), Some(upper)) = (limit.lower, limit.upper) {
        let widest = lower.abs().max(upper.abs());
        let units = LikelyUnits::guess(widest, USUAL_SLIDE, [0.0, MOST_SLIDE]);
        if let Some(units) = units.filter(|_| !is_of_base(urdf, joint)) {
            warn(
                format!("it slides from {lower} to {upper} m"),
                format!("within {MOST_SLIDE} m"),
                units.to_string(),
            );
        }
    }
    for (what, unit, in_words, value, most) in [
        (
            "velocity",
            "m/s",
            "millimetres per second",
            limit.velocity,
            MOST_SLIDE_SPEED,
        ),
        (
            "acceleration",
            "m/s2",
            "millimetres per second squared",
            limit.acceleration,
            MOST_SLIDE_ACCELERATION,
        ),
    ] {
        if let Some(value) = value.filter(|value| *value > most && value.is_finite()) {
            warn(
                format!("its {what} limit is {value} {unit}"),
                format!("at most {most} {unit}"),
                format!("it is probably in {in_words}: multiply by 0.001; motions use this limit"),
            );
        }
    }
}

/// Whether a prismatic joint belongs to a planar base, whose range a URDF states as a large number: two prismatic joints,
/// and a joint that turns on them.
fn is_of_base(urdf: &Urdf, joint: &UrdfJoint) -> bool {
    let above = |joint: &UrdfJoint| {
        let mut joints = urdf.joints.iter();
        joints.find(|above| above.child == joint.parent)
    };
    let below = |joint: &UrdfJoint| {
        let mut joints = urdf.joints.iter();
        joints.find(|below| below.parent == joint.child)
    };
    let slides = |joint: &&UrdfJoint| joint.kind == "prismatic";
    let turns = |joint: &&UrdfJoint| joint.kind == "continuous";
    let second = match below(joint).filter(slides) {
        Some(second) => second,
        None if above(joint).filter(slides).is_some() => joint,
        None => return false,
    };
    below(second).filter(turns).is_some()
}
