//! Findings about the chain that wipes, and about the posture in which its motions begin.

use super::read_srdf;
use crate::failure::Failure;
use wisch::follow::{FollowConfig, PlanningGroup};
use wisch::robot::{
    CollisionModel, Diagnostic, DiagnosticKind, RobotError, RobotModel, Severity, Srdf, Subject,
};
use wisch::source_location::Place;

/// Returns a warning if the chain that wipes by default has more joints than wisch moves. `name`, `text`: the URDF.
pub(super) fn check_chain(
    name: &str,
    text: &str,
    robot: &RobotModel,
    srdf: Option<&str>,
) -> Result<Option<Diagnostic>, Failure> {
    let srdf = match srdf.map(|path| read_srdf(path, robot)).transpose() {
        Ok(srdf) => srdf,
        // The findings name what is wrong with it.
        Err(_) => return Ok(None),
    };
    let group = PlanningGroup::choose(robot, srdf.as_ref(), None).map_err(Failure::new)?;
    let Err(RobotError::ChainTooLong {
        base,
        tip,
        what,
        value,
        limit,
    }) = robot.chain(group.base, group.tip)
    else {
        return Ok(None);
    };
    Ok(Some(Diagnostic {
        severity: Severity::Warning,
        at: Place::from_offset(name, text, text.find("<robot").unwrap_or(0)),
        subject: Subject::Robot,
        kind: DiagnosticKind::Depth,
        value: format!("the chain from {base:?} to {tip:?}, which wipes, has {value} {what}"),
        limit: format!("at most {limit}"),
        advice:
            "name a group with a shorter chain in an SRDF, or make joints that need not move fixed"
                .to_owned(),
    }))
}

/// Returns a warning if links are too close to each other, or a joint is outside its limits, where motions of the default group
/// begin. `name`, `text`: the SRDF.
pub(super) fn check_start(
    name: &str,
    text: &str,
    robot: &RobotModel,
) -> Result<Option<Diagnostic>, Failure> {
    // The findings name what is wrong with a text that cannot be read.
    let Ok(srdf) = Srdf::parse(name, text, robot) else {
        return Ok(None);
    };
    let ready = PlanningGroup::choose(robot, Some(&srdf), None)
        .map_err(Failure::new)?
        .ready;
    let finding = |value: String, limit: String| Diagnostic {
        severity: Severity::Warning,
        at: Place::from_offset(name, text, text.find("<group_state").unwrap_or(0)),
        subject: Subject::Robot,
        kind: DiagnosticKind::Srdf,
        value,
        limit,
        advice: "change the state, or run wisch robot setup, which searches for a free one"
            .to_owned(),
    };
    if let Some(fault) = robot.limit_faults(&ready).map_err(Failure::new)?.first() {
        let value = format!("in the posture in which motions begin, {fault}");
        return Ok(Some(finding(
            value,
            "a position within the limits".to_owned(),
        )));
    }
    let margin = FollowConfig::default().margin;
    let model = CollisionModel::new(robot, Some(&srdf)).map_err(Failure::new)?;
    let contact = model.collision(&ready, margin).map_err(Failure::new)?;
    Ok(contact.map(|contact| {
        let [a, b] = [contact.a, contact.b].map(|body| model.name(body));
        let distance = contact.distance;
        finding(
            format!("in the posture in which motions begin, {a:?} and {b:?} have a clearance of {distance:.4} m"),
            format!("at least {margin} m"),
        )
    }))
}
