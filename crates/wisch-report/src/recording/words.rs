//! Sentences of the recording: task, plan, checks, results and advice.

use super::treated::Band;
use crate::draw::{format_decimal, format_percent, group_thousands};
use crate::rounds::words::{count_events, describe_diagnosis, format_estimate};
use wisch::follow::{Audit, Followed};
use wisch::interpret::{Doubt, EventKind};
use wisch::plan::Plan;
use wisch::recover::{Claim, Verdict, find_excess_passes};
use wisch::represent::{Action, Task};
use wisch::run::{Ending, Round};

/// States the task and its target.
pub(super) fn describe_task(task: &Task, target: f64) -> String {
    let (medium, surface) = (format_name(&task.medium), format_name(&task.surface.name));
    let doing = match task.action {
        Action::Absorb => format!("Absorb the {medium} on the {surface}"),
        Action::Collect => format!("Collect the {medium} on the {surface}"),
        Action::Skim => format!("Skim the {medium} off the {surface}"),
        Action::Polish => format!("Polish the {surface}"),
        Action::Dispense => format!("Dispense {medium} onto the {surface}"),
    };
    let tool = format_name(&task.tool.name);
    let count = group_thousands(task.particles.len());
    if let Some(band) = Band::new(task) {
        let wanted = band.describe_target(target, &count);
        return format!("{doing} with the {tool}. Target: {wanted}.");
    }
    let target = format_percent(target);
    let wanted = match task.action {
        Action::Absorb => format!("{target} of the {count} particles absorbed"),
        Action::Collect => format!("{target} of the {count} particles in the goal area"),
        Action::Skim => format!("{target} of the {count} particles over the skim edge"),
        Action::Polish => format!("{target} of {count} surface points polished"),
        Action::Dispense => format!("{target} of {count} surface points coated"),
    };
    format!("{doing} with the {tool}. Target: {wanted}.")
}

/// Formats a name as words.
fn format_name(name: &str) -> String {
    name.replace(['_', '-'], " ")
}

/// Summarises a plan in one line.
pub(super) fn summarise_plan(plan: &Plan) -> String {
    format!(
        "planned by {}: {}, {} m in contact",
        plan.strategy.as_str(),
        format_count(plan.strokes.len(), "stroke"),
        format_decimal(plan.contact_distance(), 2)
    )
}

/// Explains a plan. `wiped`: the plan without the nodes that the robot abandons.
pub(super) fn explain_plan(plan: &Plan, wiped: &Plan, followed: Option<&Followed>) -> Vec<String> {
    let mut sentences = Vec::new();
    if wiped.strokes.len() != plan.strokes.len() {
        sentences.push(format!(
            "The robot executes the {} of the plan as {}, {} m in contact.",
            format_count(plan.strokes.len(), "stroke"),
            format_count(wiped.strokes.len(), "stroke"),
            format_decimal(wiped.contact_distance(), 2)
        ));
    }
    if plan.unreachable_share > 0.0 {
        sentences.push(format!(
            "{} of the dirt is out of reach: no allowed tool pose covers it.",
            format_percent(plan.unreachable_share)
        ));
    }
    if !plan.graph.unreachable.is_empty() {
        sentences.push(format!(
            "No collision-free path leads from {} to the goal.",
            format_count(plan.graph.unreachable.len(), "node")
        ));
    }
    let Some(followed) = followed else {
        return sentences;
    };
    sentences.extend(explain_placement(followed));
    if !followed.abandoned.is_empty() {
        sentences.push(format!(
            "The robot abandons {} that it cannot reach.",
            format_count(followed.abandoned.len(), "node")
        ));
    }
    sentences
}

/// Explains where the base stands; `None` for a robot with a fixed base.
fn explain_placement(followed: &Followed) -> Option<String> {
    let first = followed.placements.first()?;
    let poses = format_count(followed.placements.len(), "base pose");
    let ratings = followed.rated.iter().filter_map(|place| place.rating);
    let standing = ratings.clone().count();
    if standing == 0 {
        return None;
    }
    let best = ratings.fold(0.0, f64::max);
    let chosen = (followed.rated.iter())
        .find(|place| place.world_from_base == first.world_from_base)
        .and_then(|place| place.rating);
    let reach = match chosen {
        Some(share) if share >= best => {
            format!(
                "From the first, {} of the path is in reach, the most of",
                format_percent(share)
            )
        }
        Some(share) => format!(
            "From the first, {} of the path is in reach, and at most {} from",
            format_percent(share),
            format_percent(best)
        ),
        None => format!(
            "At most {} of the path is in reach from",
            format_percent(best)
        ),
    };
    Some(format!(
        "The robot works from {poses}. {reach} the {} places at which it can stand.",
        group_thousands(standing)
    ))
}

/// Summarises the check of a motion.
pub(super) fn describe_audit(audit: &Audit) -> String {
    match audit.faults.as_slice() {
        [] => format!(
            "The motion passes all checks; its clearance is at least {} mm.",
            // A lower bound is rounded down.
            format_decimal((1e4 * audit.min_clearance).floor() / 10.0, 1)
        ),
        faults => {
            let words: Vec<String> = faults.iter().map(ToString::to_string).collect();
            format!("The motion fails its check: {}.", words.join("; "))
        }
    }
}

/// Summarises a round: diagnosis, events, ending, estimate and verdict.
pub(super) fn describe_round(round: &Round, target: f64) -> Vec<String> {
    let found = &round.interpretation;
    let mut sentences = vec![describe_diagnosis(found)];
    let events = count_events(&found.events);
    if !events.is_empty() {
        sentences.push(format!("Detected events: {events}."));
    }
    for doubt in &found.doubts {
        sentences.push(format!("{}.", doubt.describe_for_executor()));
    }
    match &round.execution.ending {
        Ending::Complete => {}
        Ending::Stopped => {
            sentences.push("The round was stopped on request, or by an error.".to_owned());
        }
        Ending::Early { time, cause } => {
            sentences.push(format!("The round ended early at {time:.1} s: {cause}."));
        }
        Ending::ProtectiveStop { time, cause } => {
            sentences.push(format!(
                "The robot made a protective stop at {time:.1} s: {cause}."
            ));
        }
    }
    if found.observation.is_some() {
        let [touch, camera] = [found.by_touch, found.performance].map(format_estimate);
        sentences.push(format!(
            "Estimated performance: {touch} from touch, {camera} with the camera observation."
        ));
    } else {
        let estimate = format_estimate(found.performance);
        sentences.push(if found.is_conclusive() {
            format!("Estimated performance from touch: {estimate}.")
        } else {
            format!("The log does not allow an estimate; possible performance: {estimate}.")
        });
    }
    sentences.push(describe_verdict(round, target));
    sentences
}

/// States the verdict on a round with its reason.
fn describe_verdict(round: &Round, target: f64) -> String {
    let claim = Claim::assess(&round.interpretation.distribution, target);
    let task = &round.motion.task;
    let has_excess = find_excess_passes(task, &round.interpretation, target).is_some();
    match round.verdict {
        Verdict::GoalMet => format!("The goal is met: {claim}."),
        Verdict::Again => format!("The estimate does not reach the target: {claim}."),
        Verdict::NoProgress => {
            format!("The goal is not met ({claim}), and this round did not raise the estimate.")
        }
        Verdict::NothingToGain if has_excess || claim.holds() => format!(
            "The goal is not met: {claim}, but too many points have more passes than the task allows."
        ),
        Verdict::NothingToGain => format!(
            "The goal is not met ({claim}), and no plan is predicted to improve it: the remaining dirt has left the surface, or would leave it."
        ),
        Verdict::NoWay => "The robot found no plan or motion for another round.".to_owned(),
        Verdict::UnsafeMotion => {
            "The motion of the next round fails its check, so the robot does not execute it."
                .to_owned()
        }
        Verdict::Undecidable => {
            "It is unknown whether the goal is met: the log does not allow an estimate.".to_owned()
        }
        Verdict::UnknowableByTouch if task.treatment.is_some() && claim.holds() => format!(
            "It is unknown whether the goal is met: {claim}, but too many points may have more passes than the task allows."
        ),
        Verdict::UnknowableByTouch if task.treatment.is_some() => format!(
            "It is unknown whether the goal is met ({claim}), and another round would not change this."
        ),
        Verdict::UnknowableByTouch => format!(
            "It is unknown whether the goal is met ({claim}). Another round with touch only would not change this; a camera observation would."
        ),
    }
}

/// Lists measures that would narrow the interval of the last round's estimate.
pub(super) fn suggest_measures(last: &Round) -> String {
    let found = &last.interpretation;
    let pushed = found
        .events
        .iter()
        .any(|event| event.kind == EventKind::Push);
    let mut measures = Vec::new();
    match &found.observation {
        // A camera sees dirt, but neither polish nor a coat.
        None if last.motion.task.treatment.is_some() => {}
        None => measures
            .push("a camera that observes the surface after each round ([perception] in the task)"),
        Some(observation) if observation.hidden.area() > 0.0 => {
            measures.push("a view of the area that robot and tool hide from the camera");
        }
        Some(_) => {}
    }
    if pushed {
        measures.push("a round without a push");
    }
    if matches!(found.doubts.as_slice(), [Doubt::HandGuided { .. }, ..]) {
        measures.push("a round without hand guiding");
    }
    if found.plane.is_none_or(|plane| plane.directions < 2) {
        measures.push("strokes in a second direction, which determine the tilt of the surface");
    }
    match measures.as_slice() {
        [] => "Only another observation or another round narrows the interval.".to_owned(),
        measures => format!("To narrow the interval: {}.", measures.join("; ")),
    }
}

pub(super) fn format_count(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", group_thousands(count))
}
