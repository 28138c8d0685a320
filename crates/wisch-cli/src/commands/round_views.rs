//! The rounds of a run in words.

use super::words::{format_count, percent};
use wisch::interpret::EventKind;
use wisch::recover::{Claim, Verdict};
use wisch::run::{Ending, Pause};
use wisch_record::FinishedRound;

/// Describes each round in one line, followed by a line for each doubt about its log.
pub fn rounds_in_words(finished: &[FinishedRound], target: f64) -> Vec<(&'static str, String)> {
    (finished.iter())
        .flat_map(|finished| {
            let round = &finished.round;
            let interpretation = &round.interpretation;
            let estimate = &interpretation.performance;
            let [least, most] = interpretation.range(round.motion.task.action);
            let interval = format!("{} to {}", percent(least), percent(most));
            let mut text = if interpretation.is_conclusive() {
                format!("estimated {} ({interval})", percent(estimate.mean))
            } else {
                format!("no estimate possible ({interval})")
            };
            if let Some(truth) = finished.true_performance() {
                text += &format!(", true {}", percent(truth));
            }
            let collisions = (interpretation.events.iter())
                .filter(|event| event.kind == EventKind::Push)
                .count();
            if collisions > 0 {
                text += &format!(", {}", format_count(collisions, "collision"));
            }
            if let wisch::interpret::Diagnosis::Relocalize { .. } = interpretation.diagnosis
                && let Some(plane) = &interpretation.plane
            {
                text += &format!(
                    ", surface tilted by {:.1}° and offset by {:.1} mm",
                    plane.tilt.to_degrees(),
                    1e3 * plane.offset
                );
            }
            if let Ending::Early { time, cause } = &round.execution.ending {
                text += &format!(", ended early at {time:.1} s: {cause}");
            }
            if let Ending::ProtectiveStop { time, cause } = &round.execution.ending {
                text += &format!(", stopped at {time:.1} s: {cause}");
            }
            text += &pauses_in_words(&round.execution.pauses);
            if let dropped @ 1.. = round.execution.dropped_samples {
                let dropped = format_count(dropped, "sample");
                text += &format!(", {dropped} dropped because the run's records were too slow");
            }
            let known = finished.truth.as_ref();
            if let Some(known) = known.filter(|known| !known.missed.is_empty()) {
                let ended = round.motion.followed.duration();
                let missed = known.missed.join(" and ");
                text += &format!(", {missed} did not happen: the motion ended at {ended:.1} s");
            }
            text += &format!(": {}", round.verdict.as_str());
            if round.verdict == Verdict::UnknowableByTouch {
                let claim = Claim::assess(&round.interpretation.distribution, target);
                // A camera sees dirt, but neither polish nor a coat.
                let more = match round.motion.task.treatment {
                    Some(_) if claim.holds() => {
                        "; too many points may have more passes than polish.max_passes"
                    }
                    Some(_) => "",
                    None => "; needs a camera",
                };
                text += &format!(" ({claim}{more})");
            }
            let number = round.motion.number;
            let name = if number == 1 { "rounds" } else { "" };
            let doubts = interpretation
                .doubts
                .iter()
                .map(|doubt| ("", format!("   {}", doubt.describe_for_executor())));
            std::iter::once((name, format!("{number}: {text}"))).chain(doubts)
        })
        .collect()
}

/// Describes the pauses of a motion, as a part of a sentence; empty without one.
fn pauses_in_words(pauses: &[Pause]) -> String {
    let parts = pauses.iter().map(|pause| {
        let during = match pause.phase.stroke() {
            Some(stroke) => format!("in stroke {}", stroke + 1),
            None => format!("in phase {}", pause.phase.as_str()),
        };
        let end = match pause.end {
            Some(end) => format!("for {:.1} s", end - pause.start),
            None => "until the end".to_owned(),
        };
        let reason = match pause.reason.as_str() {
            "" => String::new(),
            reason => format!(" ({reason})"),
        };
        format!(", paused at {:.1} s {during} {end}{reason}", pause.start)
    });
    parts.collect()
}
