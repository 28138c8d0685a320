//! Names and sentences about rounds and their events.

use crate::draw::{format_decimal, format_percent};
use wisch::interpret::{Diagnosis, Estimate, Event, EventKind, Interpretation};

/// All kinds of events but phases, in the order in which they are shown.
pub(crate) const KINDS: [EventKind; 8] = [
    EventKind::Contact,
    EventKind::ContactLoss,
    EventKind::Push,
    EventKind::HandGuiding,
    EventKind::Landing,
    EventKind::Overload,
    EventKind::Vibration,
    EventKind::StickSlip,
];

pub(crate) const fn kind_name(kind: EventKind) -> &'static str {
    match kind {
        EventKind::Contact => "contact",
        EventKind::ContactLoss => "contact loss",
        EventKind::Push => "collision",
        EventKind::HandGuiding => "hand guiding",
        EventKind::Landing => "landing",
        EventKind::Overload => "overload",
        EventKind::Vibration => "vibration",
        EventKind::StickSlip => "stick-slip",
        EventKind::Approach => "approach",
        EventKind::Stroke => "stroke",
        EventKind::Lift => "lift",
        EventKind::Retreat => "retreat",
    }
}

/// Formats a mean with its 90 % interval.
pub(crate) fn format_estimate(estimate: Estimate) -> String {
    if estimate.low == estimate.high {
        return format_percent(estimate.mean);
    }
    format!(
        "{} (90 % interval {:.1} to {:.1} %)",
        format_percent(estimate.mean),
        100.0 * estimate.low,
        100.0 * estimate.high
    )
}

/// Formats the diagnosis as a sentence.
pub(crate) fn describe_diagnosis(found: &Interpretation) -> String {
    let plane = found.plane.map_or_else(String::new, |plane| {
        format!(
            ": the fitted surface is tilted by {} and {} mm {} it",
            format_degrees(plane.tilt),
            format_decimal(1e3 * plane.offset.abs(), 1),
            if plane.offset < 0.0 { "below" } else { "above" }
        )
    });
    match found.diagnosis {
        Diagnosis::Localized => format!("The surface is at its believed pose{plane}."),
        Diagnosis::Relocalize { .. } => {
            format!("The surface is not at its believed pose{plane}.")
        }
        Diagnosis::NoContact => {
            "The pose of the surface is unknown, because too few contacts are confident.".to_owned()
        }
        Diagnosis::Unfitted => {
            "The pose of the surface is unknown, because the contacts fit this side of it at no pose that was tried.".to_owned()
        }
        Diagnosis::Hovering => {
            "The tool works without contact, so the estimate is from tool poses only.".to_owned()
        }
    }
}

pub(crate) fn format_degrees(angle: f64) -> String {
    format!("{}°", format_decimal(angle.to_degrees(), 2))
}

pub(crate) fn count(events: &[Event], kind: EventKind) -> usize {
    events.iter().filter(|event| event.kind == kind).count()
}

/// Counts the events of each kind, as text.
pub(crate) fn count_events(events: &[Event]) -> String {
    let kinds = KINDS.into_iter().filter_map(|of| {
        let many = count(events, of);
        let name = match (of, many) {
            (_, 0) => return None,
            (EventKind::ContactLoss, 2..) => "contact losses".to_owned(),
            (EventKind::StickSlip | EventKind::HandGuiding, _) | (_, 1) => kind_name(of).to_owned(),
            _ => format!("{}s", kind_name(of)),
        };
        Some(format!("{many} {name}"))
    });
    kinds.collect::<Vec<_>>().join(", ")
}

/// Describes the measurements that show an event.
pub(crate) fn describe_evidence(event: &Event) -> String {
    let does = if event.mean_normal_force > 0.0 {
        "pulls"
    } else {
        "presses"
    };
    format!(
        "for {} s; the tool {does} with {} N on average, {} N at most, up to {} mm from the fitted surface",
        format_decimal(event.end - event.start, 1),
        format_decimal(event.mean_normal_force.abs(), 1),
        format_decimal(event.peak_force, 1),
        format_decimal(1e3 * event.peak_height, 1)
    )
}
