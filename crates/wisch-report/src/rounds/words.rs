//! Rounds in words.

use super::input::{RoundView, RoundsInput};
use crate::draw::{metres, percent};
use wisch::interpret::{Diagnosis, Estimate, Event, EventKind, Interpretation};

/// All kinds of events but phases, in the order in which they are shown.
pub(crate) const KINDS: [EventKind; 8] = [
    EventKind::Contact,
    EventKind::ContactLoss,
    EventKind::Collision,
    EventKind::HandGuiding,
    EventKind::Landing,
    EventKind::Overload,
    EventKind::Vibration,
    EventKind::StickSlip,
];

pub(crate) const fn kind(kind: EventKind) -> &'static str {
    match kind {
        EventKind::Contact => "contact",
        EventKind::ContactLoss => "contact loss",
        EventKind::Collision => "collision",
        EventKind::HandGuiding => "hand guiding",
        EventKind::Landing => "landing",
        EventKind::Overload => "overload",
        EventKind::Vibration => "vibration",
        EventKind::StickSlip => "stick–slip",
        EventKind::Approach => "approach",
        EventKind::Stroke => "stroke",
        EventKind::Lift => "lift",
        EventKind::Retreat => "retreat",
    }
}

/// Without a line's end between a number and its per cent sign.
pub(crate) fn unbroken(text: &str) -> String {
    text.replace(" %", "\u{a0}%")
}

/// How far the rounds led, against what was wanted.
pub(crate) fn outcome(input: &RoundsInput) -> String {
    let Some(last) = input.rounds.last() else {
        return "No round was executed.".to_owned();
    };
    let rounds = match input.rounds.len() {
        1 => "one round".to_owned(),
        count => format!("{count} rounds"),
    };
    let performance = last.interpretation.performance;
    let reached = if performance.mean >= input.target {
        "reaches"
    } else {
        "misses"
    };
    let truth = last.truth.map_or_else(String::new, |(_, share)| {
        format!(" In truth it is {}.", percent(share))
    });
    format!(
        "After {rounds} the performance is estimated at {}, which {reached} the target of {}.{truth}",
        interval(performance),
        percent(input.target),
    )
}

/// A mean with its interval.
pub(crate) fn interval(estimate: Estimate) -> String {
    if estimate.low == estimate.high {
        return percent(estimate.mean);
    }
    format!(
        "{} (90 % interval {:.1} to {:.1} %)",
        percent(estimate.mean),
        100.0 * estimate.low,
        100.0 * estimate.high
    )
}

/// What one round told.
pub(crate) fn round(input: &RoundsInput, view: &RoundView) -> String {
    let found = view.interpretation;
    let (all, medium) = (view.believed.len(), &input.task.medium);
    let mut text = format!(
        "Planned on {} of {all} particles of {medium} still believed on the surface. {}",
        view.believed.tally().remaining,
        diagnosis(found)
    );
    if !matches!(found.diagnosis, Diagnosis::NoContact | Diagnosis::Hovering) {
        text += &format!(
            " The tool was in contact for {} of the time near the surface.",
            percent(found.contact_share)
        );
    }
    match count(&found.events, EventKind::Collision) {
        0 => {}
        1 => text += " One collision was felt.",
        many => text += &format!(" {many} collisions were felt."),
    }
    text
}

/// The diagnosis as a sentence.
pub(crate) fn diagnosis(found: &Interpretation) -> String {
    let plane = found.plane.map_or_else(String::new, |plane| {
        format!(
            ": the fitted plane is tilted by {} and lies {} mm {}",
            degrees(plane.tilt),
            metres(1e3 * plane.offset.abs(), 1),
            if plane.offset < 0.0 { "below" } else { "above" }
        )
    });
    match found.diagnosis {
        Diagnosis::Localized => format!("The surface is where it was believed{plane}."),
        Diagnosis::Relocalize { .. } => format!("The surface is elsewhere{plane}."),
        Diagnosis::NoContact => {
            "There were too few confident contacts to tell where the surface is.".to_owned()
        }
        Diagnosis::Hovering => {
            "The tool hovers: nothing is felt, and the estimate goes by where the tool was."
                .to_owned()
        }
    }
}

/// The diagnosis in two or three words.
pub(crate) const fn verdict(diagnosis: Diagnosis) -> &'static str {
    match diagnosis {
        Diagnosis::Localized => "as believed",
        Diagnosis::Relocalize { .. } => "surface elsewhere",
        Diagnosis::NoContact => "no contact found",
        Diagnosis::Hovering => "nothing to feel",
    }
}

pub(crate) fn degrees(angle: f64) -> String {
    format!("{}°", metres(angle.to_degrees(), 2))
}

pub(crate) fn count(events: &[Event], kind: EventKind) -> usize {
    events.iter().filter(|event| event.kind == kind).count()
}

/// How often which kind occurred.
pub(crate) fn tally(events: &[Event]) -> String {
    let kinds = KINDS.into_iter().filter_map(|of| {
        let many = count(events, of);
        let name = match (of, many) {
            (_, 0) => return None,
            (EventKind::ContactLoss, 2..) => "contact losses".to_owned(),
            (EventKind::StickSlip | EventKind::HandGuiding, _) | (_, 1) => kind(of).to_owned(),
            _ => format!("{}s", kind(of)),
        };
        Some(format!("{many} {name}"))
    });
    kinds.collect::<Vec<_>>().join(", ")
}

/// What shows that an event happened.
pub(crate) fn evidence(event: &Event) -> String {
    let samples = match event.samples {
        1 => "1 sample".to_owned(),
        many => format!("{many} samples"),
    };
    format!(
        "{samples}, mean {} N, peak {} N, up to {} mm off the plane",
        metres(event.mean_normal_force, 1),
        metres(event.peak_force, 1),
        metres(1e3 * event.peak_height, 1)
    )
}
