//! Sentences beside what is shown.

use crate::draw::{grouped, metres, percent};
use crate::rounds::words::{diagnosis, interval, tally};
use wisch::follow::{Audit, Followed};
use wisch::interpret::{Doubt, EventKind};
use wisch::plan::Plan;
use wisch::recover::{Claim, Verdict};
use wisch::represent::{Action, Task};
use wisch::run::{Ending, Round};

/// What was asked.
pub(super) fn asked(task: &Task, target: f64) -> String {
    let (medium, surface) = (spaced(&task.medium), spaced(&task.surface.name));
    let doing = match task.action {
        Action::Absorb => format!("Take up the {medium} on the {surface}"),
        Action::Collect => format!("Push the {medium} on the {surface} together"),
        Action::Skim => format!("Push the {medium} off the {surface}"),
        Action::Polish => format!("Polish the {surface}"),
        Action::Emit => format!("Spread {medium} on the {surface}"),
    };
    format!(
        "{doing} with the {}: {} of {} are wanted where they belong.",
        spaced(&task.tool.name),
        percent(target),
        grouped(task.particles.len())
    )
}

/// A name as words.
fn spaced(name: &str) -> String {
    name.replace(['_', '-'], " ")
}

/// A plan in short.
pub(super) fn planned(plan: &Plan) -> String {
    format!(
        "planned: {}, {} m in contact, nodes placed by {}",
        counted(plan.strokes.len(), "stroke"),
        metres(plan.contact_distance(), 2),
        plan.strategy.as_str()
    )
}

/// Why this plan, as it was planned and as it is wiped.
pub(super) fn why(plan: &Plan, wiped: &Plan, followed: Option<&Followed>) -> Vec<String> {
    let mut sentences = vec![format!(
        "The {} of the {} plan were placed by {}: {}, {} m in contact.",
        counted(plan.graph.nodes.len(), "node"),
        plan.graph.goal.action().as_str(),
        plan.strategy.as_str(),
        counted(wiped.strokes.len(), "stroke"),
        metres(wiped.contact_distance(), 2)
    )];
    if plan.unreachable_share > 0.0 {
        sentences.push(format!(
            "No allowed pose of the tool covers {} of the dirt.",
            percent(plan.unreachable_share)
        ));
    }
    if !plan.graph.unreachable.is_empty() {
        sentences.push(format!(
            "No clear way leads from {} to the goal.",
            counted(plan.graph.unreachable.len(), "node")
        ));
    }
    let Some(followed) = followed else {
        return sentences;
    };
    if !followed.placements.is_empty() {
        let places = counted(followed.placements.len(), "place");
        sentences.push(format!("The base stands at {places} for it."));
    }
    if !followed.abandoned.is_empty() {
        sentences.push(format!(
            "The robot cannot pass {}, which it leaves out.",
            counted(followed.abandoned.len(), "node")
        ));
    }
    sentences
}

/// What the check of a motion says.
pub(super) fn audited(audit: &Audit) -> String {
    match audit.faults.as_slice() {
        [] => format!(
            "The motion was checked: no fault, nothing nearer than {} mm to what it must not touch.",
            metres(1e3 * audit.min_clearance, 0)
        ),
        faults => {
            let words: Vec<String> = faults.iter().map(ToString::to_string).collect();
            format!("The motion has faults: {}.", words.join("; "))
        }
    }
}

/// What touch, and sight, told of a round, and what follows.
pub(super) fn judged(round: &Round, target: f64) -> Vec<String> {
    let found = &round.interpretation;
    let mut sentences = vec![diagnosis(found)];
    let felt = tally(&found.events);
    if !felt.is_empty() {
        sentences.push(format!("Felt: {felt}."));
    }
    for doubt in &found.doubts {
        sentences.push(format!("{doubt}."));
    }
    match &round.execution.ending {
        Ending::Complete => {}
        Ending::Stopped => sentences.push("It was stopped from outside.".to_owned()),
        Ending::Early { time, cause } => {
            sentences.push(format!("It was ended at {time:.1} s, as {cause}."));
        }
        Ending::ProtectiveStop { time, cause } => {
            sentences.push(format!("The robot stopped itself at {time:.1} s: {cause}."));
        }
    }
    if found.observation.is_some() {
        let [felt, seen] = [found.felt, found.performance].map(interval);
        sentences.push(format!(
            "By touch alone {felt} would be where it belongs; with what was seen, {seen}."
        ));
    } else {
        let felt = interval(found.performance);
        sentences.push(if found.can_be_told() {
            format!("By touch, {felt} is where it belongs.")
        } else {
            format!("What was wiped cannot be told from this log: {felt} is possible.")
        });
    }
    sentences.push(follows(round, target));
    sentences
}

/// What follows, and why.
fn follows(round: &Round, target: f64) -> String {
    let claim = Claim::of(&round.interpretation.distribution, target);
    match round.verdict {
        Verdict::GoalMet => format!("The goal is met: {claim}."),
        Verdict::Again => format!("The goal is not met yet: {claim}."),
        Verdict::NoProgress => {
            format!("The goal is not met ({claim}), and this round has not raised the estimate.")
        }
        Verdict::NothingToGain => format!(
            "The goal is not met ({claim}), and no plan is expected to do any better: what is missing has left the surface, or would."
        ),
        Verdict::NoWay => "The robot finds no plan or motion to wipe again.".to_owned(),
        Verdict::UnsafeMotion => {
            "The motion that would wipe again fails its check, and is not executed.".to_owned()
        }
        Verdict::CannotBeTold => {
            "Whether the goal is met cannot be told: the log does not say what was wiped."
                .to_owned()
        }
        Verdict::UnknowableByTouch => format!(
            "Whether the goal is met, touch cannot tell ({claim}), and wiping again would not change that."
        ),
    }
}

/// What it would take to be surer of the last round.
pub(super) fn surer(last: &Round) -> String {
    let found = &last.interpretation;
    let pushed = found
        .events
        .iter()
        .any(|event| event.kind == EventKind::Collision);
    let mut ways = Vec::new();
    match &found.observation {
        None => ways.push(
            "a look at the surface: with a camera ([perception] in the task) each round is seen as well as felt",
        ),
        Some(observation) if observation.hidden.area() > 0.0 => {
            ways.push("a look at what robot and tool hide from the camera");
        }
        Some(_) => {}
    }
    if pushed {
        ways.push("a round in which nobody pushes");
    }
    if matches!(found.doubts.as_slice(), [Doubt::LedByHand { .. }, ..]) {
        ways.push("a round that nobody leads by hand");
    }
    if found.plane.is_none_or(|plane| plane.directions < 2) {
        ways.push("strokes in a second direction, which tell how the surface lies");
    }
    match ways.as_slice() {
        [] => "Another look, or another round: nothing else narrows the interval.".to_owned(),
        ways => format!("It would take {}.", ways.join(", and ")),
    }
}

fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", grouped(count))
}
