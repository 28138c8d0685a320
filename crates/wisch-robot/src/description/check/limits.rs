//! Checks of a joint's limits of position, velocity, effort and acceleration.

use super::joint;
use crate::description::diagnostics::{Diagnostics, Words, words};
use crate::description::elements::{UrdfJoint, UrdfLimit};
use crate::{ASSUMED_SLIDE_RATES, ASSUMED_TURN_RATES, DiagnosticKind, Severity};

/// Least limit of velocity or acceleration that is not reported [rad/s, m/s, rad/s² or m/s²]: a turn by 1 rad takes a quarter
/// of an hour.
const LEAST_RATE: f64 = 1e-3;

/// Checks the limits of a joint; a follower needs none.
pub(super) fn check_limits(j: &UrdfJoint, follows: bool, report: &mut Diagnostics) {
    let unit = if j.kind == "prismatic" { "m" } else { "rad" };
    if let Some([lower, upper]) = j.soft_limits {
        let w = words(
            format!("its safety controller keeps it within {lower} and {upper} {unit}"),
            "soft limits inside the hard ones",
            "the soft limits are used; remove <safety_controller> to use the hard ones",
        );
        add_of_joint(report, Severity::Note, DiagnosticKind::Limit, j, w);
    }
    let limit = j.limit.unwrap_or_default();
    if j.kind != "continuous" {
        check_position_limits(j, &limit, unit, follows, report);
    }
    if !follows {
        for rate in rate_limits(j, &limit) {
            check_rate_limit(j, &rate, report);
        }
    }
}

/// Checks that a joint has both position limits, and that they differ.
fn check_position_limits(
    j: &UrdfJoint,
    limit: &UrdfLimit,
    unit: &str,
    follows: bool,
    report: &mut Diagnostics,
) {
    if let Some(absent) = j.assumed_limit {
        let w = words(
            format!("it has no {absent} position limit, but the other one"),
            format!("lower and upper [{unit}]"),
            format!("add <limit {absent}>; without it 0 {unit} is assumed, the default of URDF"),
        );
        add_of_joint(report, Severity::Warning, DiagnosticKind::Limit, j, w);
    }
    let only = match (limit.lower, limit.upper) {
        (Some(lower), None) => Some(("lower", lower)),
        (None, Some(upper)) => Some(("upper", upper)),
        _ => None,
    };
    match (limit.lower, limit.upper) {
        (Some(lower), Some(upper)) if lower == upper && !follows => {
            let w = words(
                format!("lower = upper = {lower} {unit}"),
                "lower < upper",
                "widen the limits, or make the joint fixed",
            );
            add_of_joint(report, Severity::Warning, DiagnosticKind::Limit, j, w);
        }
        (Some(_), Some(_)) => {}
        _ if follows => {}
        _ => {
            let value = only.map_or_else(
                || "it has no finite position limits".to_owned(),
                |(stated, limit)| {
                    format!("{stated} = {limit} {unit} is its only finite position limit")
                },
            );
            let w = words(
                value,
                format!("lower and upper [{unit}]"),
                "add <limit lower upper>, or make the joint continuous; until then it moves without position limits",
            );
            add_of_joint(report, Severity::Warning, DiagnosticKind::Limit, j, w);
        }
    }
}

/// A limit of velocity, effort or acceleration.
struct RateLimit {
    /// Name of the attribute.
    what: &'static str,
    value: Option<f64>,
    unit: &'static str,
    /// Severity if it is missing.
    severity: Severity,
    /// Value that is assumed if it is missing.
    assumed: Option<f64>,
}

/// Returns the limits of a joint's velocity, effort and acceleration.
fn rate_limits(j: &UrdfJoint, limit: &UrdfLimit) -> [RateLimit; 3] {
    let (units, [velocity, acceleration]) = match j.kind.as_str() {
        "prismatic" => (["m/s", "N", "m/s2"], ASSUMED_SLIDE_RATES),
        _ => (["rad/s", "Nm", "rad/s2"], ASSUMED_TURN_RATES),
    };
    let rate = |what, value, unit, severity, assumed| RateLimit {
        what,
        value,
        unit,
        severity,
        assumed,
    };
    let [per_s, force, per_s2] = units;
    let (warning, note) = (Severity::Warning, Severity::Note);
    [
        rate("velocity", limit.velocity, per_s, warning, Some(velocity)),
        rate("effort", limit.effort, force, warning, None),
        rate(
            "acceleration",
            limit.acceleration,
            per_s2,
            note,
            Some(acceleration),
        ),
    ]
}

/// Checks that a joint has a limit of velocity, effort or acceleration above 0.
fn check_rate_limit(j: &UrdfJoint, rate: &RateLimit, report: &mut Diagnostics) {
    let RateLimit { what, unit, .. } = rate;
    let otherwise = match rate.assumed {
        Some(assumed) => format!("{assumed} {unit} is assumed"),
        None => "there is none".to_owned(),
    };
    match rate.value {
        None => {
            let w = words(
                format!("it has no finite {what} limit"),
                format!("{what} above 0 {unit}"),
                format!("add <limit {what}>; without it {otherwise}"),
            );
            add_of_joint(report, rate.severity, DiagnosticKind::LimitMissing, j, w);
        }
        Some(value) if value <= 0.0 => {
            let w = words(
                format!("its {what} limit is {value} {unit}"),
                format!("above 0 {unit}"),
                format!("give the limit of the drive; without it {otherwise}"),
            );
            add_of_joint(report, Severity::Warning, DiagnosticKind::Limit, j, w);
        }
        Some(value) if rate.assumed.is_some() && value < LEAST_RATE => {
            let w = words(
                format!("its {what} limit is {value} {unit}"),
                format!("at least {LEAST_RATE} {unit}"),
                "give the limit of the drive; motions that would last too long are refused",
            );
            add_of_joint(report, Severity::Warning, DiagnosticKind::Limit, j, w);
        }
        Some(_) => {}
    }
}

/// Reports a diagnostic of a joint.
fn add_of_joint(
    report: &mut Diagnostics,
    severity: Severity,
    kind: DiagnosticKind,
    j: &UrdfJoint,
    w: Words,
) {
    report.add(severity, kind, joint(&j.name), j.at, w);
}
