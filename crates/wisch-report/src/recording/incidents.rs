//! Incidents of a round: what did not go as planned, with measurements, consequence and advice.

use super::samples::round_to;
use super::words::format_count;
use crate::draw::{format_decimal, format_percent};
use crate::rounds::words::{format_degrees, format_estimate, kind_name};
use serde::Serialize;
use wisch::geometry::{Pose, flatten_pose};
use wisch::interpret::{Diagnosis, Doubt, Event, EventKind};
use wisch::run::{Ending, Round, RunWarning};

/// Shortfall of the estimate against the prediction that is an incident \[1\].
const SHORTFALL: f64 = 0.1;
/// Kinds of events that are incidents.
const KINDS: [EventKind; 4] = [
    EventKind::Push,
    EventKind::HandGuiding,
    EventKind::ContactLoss,
    EventKind::Overload,
];

/// An event or a result that was not planned.
#[derive(Debug, Serialize)]
pub(super) struct Incident {
    /// Time of its first detection, since the round began \[s\]; `None` if it concerns all of the round.
    pub(super) time: Option<f64>,
    /// Name of the incident.
    pub(super) title: String,
    /// The measurements that show it.
    pub(super) evidence: String,
    /// Consequence for the estimate or the next rounds; empty if unknown.
    pub(super) effect: String,
    /// What a user can do about it; empty if nothing.
    pub(super) advice: String,
}

/// Returns the incidents of a round.
pub(super) fn find_incidents(round: &Round) -> Vec<Incident> {
    let mut incidents: Vec<Incident> = (KINDS.iter())
        .filter_map(|&kind| describe_events(round, kind))
        .collect();
    incidents.extend(describe_pose(round));
    // The prediction leaves abandoned nodes out, and not every doubt means less wiping.
    let is_explained = !incidents.is_empty();
    incidents.extend(round.warnings.iter().map(describe_warning));
    incidents.extend(describe_log_problems(round));
    incidents.extend(describe_abandoned(round));
    match &round.execution.ending {
        Ending::Complete => incidents.extend(describe_shortfall(round, is_explained)),
        ending => incidents.extend(describe_ending(round, ending)),
    }
    incidents
}

/// Describes a warning of the memory.
fn describe_warning(warning: &RunWarning) -> Incident {
    Incident {
        time: Some(round_to(warning.time, 1e3)),
        title: format!("The {} differed from earlier episodes", warning.channel),
        evidence: capitalise(&format!("{warning}.")),
        effect: String::new(),
        advice: "Compare surface, tool and sensor with those of the earlier episodes.".to_owned(),
    }
}

/// Describes all events of a kind as one incident.
fn describe_events(round: &Round, kind: EventKind) -> Option<Incident> {
    let events: Vec<&Event> = (round.interpretation.events.iter())
        .filter(|event| event.kind == kind)
        .collect();
    let first = events.first()?;
    let largest = |of: fn(&Event) -> f64| events.iter().map(|event| of(event)).fold(0.0, f64::max);
    let duration: f64 = events.iter().map(|event| event.end - event.start).sum();
    let height = 1e3 * largest(|event| event.peak_height);
    let force = format_decimal(largest(|event| event.peak_force), 1);
    let times: Vec<String> = (events.iter().take(4))
        .map(|event| format!("{} s", format_decimal(event.start, 1)))
        .collect();
    let more = if events.len() > times.len() {
        ", …"
    } else {
        ""
    };
    let [evidence, effect, advice] = match kind {
        EventKind::ContactLoss => [
            format!("no force for {} s in total", format_decimal(duration, 1)),
            "Where contact was lost, no effect is counted.".to_owned(),
            "Compare the pose of the surface and the press force with the real ones.".to_owned(),
        ],
        EventKind::Overload => [
            format!("{force} N at most"),
            String::new(),
            "Look for an obstacle at this place, or for a surface that is higher than the task states.".to_owned(),
        ],
        kind => [
            format!(
                "{force} N at most, tool up to {} mm from the surface, for {} s in total",
                format_decimal(height, 0),
                format_decimal(duration, 1)
            ),
            describe_contact(round, &events, duration),
            if kind == EventKind::HandGuiding {
                "Repeat the round without guiding the tool by hand."
            } else {
                "Keep clear of the robot. Another round would wipe what is left."
            }
            .to_owned(),
        ],
    };
    Some(Incident {
        time: Some(round_to(first.start, 1e3)),
        title: format_title(round, kind, &events),
        evidence: format!("At {}{more}: {evidence}.", times.join(", ")),
        effect,
        advice,
    })
}

/// Names events of a kind, with the strokes in which they began if these are one or two.
fn format_title(round: &Round, kind: EventKind, events: &[&Event]) -> String {
    let mut places: Vec<String> = (events.iter())
        .map(|event| format_place(round, event))
        .collect();
    places.dedup();
    let names = match (kind, events.len()) {
        (kind, 1) => capitalise(kind_name(kind)),
        (EventKind::ContactLoss, many) => format!("{many} contact losses"),
        (EventKind::HandGuiding, many) => format!("Hand guiding, {many} times"),
        (kind, many) => format!("{many} {}s", kind_name(kind)),
    };
    join_places(&names, &places)
}

/// Adds one or two places to a name; more would be too long.
fn join_places(names: &str, places: &[String]) -> String {
    match places {
        [one] if !one.is_empty() => format!("{names} {one}"),
        [one, two] => format!("{names}: {one} and {two}"),
        _ => names.to_owned(),
    }
}

/// States for how much of these events the tool was in contact.
fn describe_contact(round: &Round, events: &[&Event], duration: f64) -> String {
    let all = round.interpretation.events.iter();
    let contacts = all.filter(|event| event.kind == EventKind::Contact);
    let overlaps = contacts.flat_map(|contact| {
        let overlap = |event: &&Event| contact.end.min(event.end) - contact.start.max(event.start);
        events.iter().map(overlap)
    });
    let touching = overlaps.fold(0.0, |sum: f64, overlap| sum + overlap.max(0.0));
    if touching <= 0.0 {
        return "The tool was not in contact at that time, so that no effect is counted."
            .to_owned();
    }
    format!(
        "The tool was in contact for {} of that time; no effect is counted for the rest.",
        format_percent((touching / duration).min(1.0))
    )
}

/// States where the surface is, if it is not where the task says.
fn describe_pose(round: &Round) -> Option<Incident> {
    let found = &round.interpretation;
    let Diagnosis::Relocalize { world_from_surface } = &found.diagnosis else {
        return None;
    };
    let evidence = found.plane.map_or_else(String::new, |plane| {
        let side = if plane.offset < 0.0 { "below" } else { "above" };
        let off = format_decimal(1e3 * plane.offset.abs(), 1);
        format!(
            "The contacts lie {off} mm {side} the believed surface and are tilted by {}.",
            format_degrees(plane.tilt)
        )
    });
    Some(Incident {
        time: None,
        title: "The surface is not at its believed pose".to_owned(),
        evidence,
        effect: "Later rounds use the measured pose.".to_owned(),
        advice: format!(
            "For later runs, correct the poses in the task, also of objects that are displaced with the surface. In the world, the measured surface is at {}.",
            format_pose(world_from_surface)
        ),
    })
}

/// Formats a pose as position and quaternion.
fn format_pose(world_from_surface: &Pose) -> String {
    let [x, y, z, qx, qy, qz, qw] = flatten_pose(world_from_surface);
    format!(
        "({x:.4}, {y:.4}, {z:.4}) m with the orientation ({qx:.5}, {qy:.5}, {qz:.5}, {qw:.5}), a quaternion x, y, z, w"
    )
}

/// Describes each reason to doubt the log, but for hand guiding that is an event.
fn describe_log_problems(round: &Round) -> impl Iterator<Item = Incident> {
    let found = &round.interpretation;
    let is_guided = (found.events.iter()).any(|event| event.kind == EventKind::HandGuiding);
    let doubts = found
        .doubts
        .iter()
        .filter(move |doubt| !(is_guided && matches!(doubt, Doubt::HandGuided { .. })));
    doubts.map(|doubt| Incident {
        time: None,
        title: if doubt.is_decisive() {
            "The log does not show what was wiped"
        } else {
            "The log is unusual"
        }
        .to_owned(),
        evidence: format!("{}.", capitalise(&doubt.describe_for_executor())),
        effect: String::new(),
        advice: String::new(),
    })
}

/// States which part of the plan the robot does not reach.
fn describe_abandoned(round: &Round) -> Option<Incident> {
    let abandoned = &round.motion.followed.abandoned;
    let first = abandoned.first()?;
    let cause = (first.obstruction()).map_or_else(
        || "No base pose reaches the first of them".to_owned(),
        |obstruction| format!("The first fails because of {obstruction}"),
    );
    Some(Incident {
        time: None,
        title: format!("The robot abandons {} of the plan", format_count(abandoned.len(), "node")),
        evidence: format!(
            "{cause}; they cost {} of the predicted performance.",
            format_percent(round.motion.abandoned_share())
        ),
        effect: "The prediction leaves them out.".to_owned(),
        advice: "Place the robot or the surface elsewhere; wisch check states how much the robot reaches."
            .to_owned(),
    })
}

/// States that less was wiped than predicted, and why as far as the measurements show it.
fn describe_shortfall(round: &Round, is_explained: bool) -> Option<Incident> {
    let found = &round.interpretation;
    let predicted = round.motion.prediction.performance.ratio();
    let estimate = found.performance;
    if !found.is_conclusive() || estimate.mean > predicted - SHORTFALL || estimate.high >= predicted
    {
        return None;
    }
    let touch = found.by_touch;
    let is_doubted_by_sight = found.observation.is_some() && touch.low > estimate.high;
    let [effect, advice] = if is_doubted_by_sight && touch.high >= predicted {
        [
            format!("The forces were as planned: from touch only, the estimate is {}.", format_estimate(touch)),
            "Check whether tool and medium are those of the task; wisch learn fits their effect to such rounds.".to_owned(),
        ]
    } else if is_explained {
        let causes = "The other incidents of this round are the causes that the measurements show.";
        [causes.to_owned(), String::new()]
    } else {
        [
            "The forces show no cause.".to_owned(),
            "Check whether tool, medium and surface are those of the task.".to_owned(),
        ]
    };
    Some(Incident {
        time: None,
        title: "Less was wiped than predicted".to_owned(),
        evidence: format!(
            "Predicted {}, estimated {}.",
            format_percent(predicted),
            format_estimate(estimate)
        ),
        effect,
        advice,
    })
}

/// States why the motion did not run to its end.
fn describe_ending(round: &Round, ending: &Ending) -> Option<Incident> {
    let (time, title, cause, advice) = match ending {
        Ending::Complete => return None,
        Ending::Stopped => {
            let title = "Stopped on request, or by an error";
            (round.execution.duration, title, String::new(), "")
        }
        Ending::Early { time, cause } => (*time, "The motion ended early", cause.to_string(), ""),
        Ending::ProtectiveStop { time, cause } => (
            *time,
            "Protective stop",
            cause.to_string(),
            "Check the robot before it moves again.",
        ),
    };
    Some(Incident {
        time: Some(round_to(time, 1e3)),
        title: format!("{title}, at {} s", format_decimal(time, 1)),
        evidence: if cause.is_empty() {
            cause
        } else {
            format!("{}.", capitalise(&cause))
        },
        effect: "No effect is counted for what was not executed.".to_owned(),
        advice: advice.to_owned(),
    })
}

/// Largest difference between the durations of an executed and a planned motion at which both have the same times [s].
const SAME_TIMES: f64 = 0.5;

/// States during which stroke an event began; empty if the motion was not executed at its planned times.
fn format_place(round: &Round, event: &Event) -> String {
    let (execution, planned) = (&round.execution, round.motion.followed.duration());
    if execution.ending != Ending::Complete
        || (execution.duration - planned).abs() > SAME_TIMES
        || !execution.pauses.is_empty()
    {
        return String::new();
    }
    let motion = round.motion.followed.motion_at(event.start);
    match motion.and_then(|motion| motion.phase.stroke()) {
        Some(stroke) => format!("in stroke {}", stroke + 1),
        None => "between strokes".to_owned(),
    }
}

/// Writes the first letter in upper case.
fn capitalise(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::join_places;

    #[test]
    fn one_or_two_places_are_named() {
        let join = |places: &[&str]| {
            let places: Vec<String> = places.iter().map(|&place| place.to_owned()).collect();
            join_places("2 collisions", &places)
        };
        assert_eq!(join(&["in stroke 3"]), "2 collisions in stroke 3");
        assert_eq!(
            join(&["in stroke 3", "between strokes"]),
            "2 collisions: in stroke 3 and between strokes"
        );
        assert_eq!(join(&["a", "b", "c"]), "2 collisions");
        assert_eq!(join(&[""]), "2 collisions");
    }
}
