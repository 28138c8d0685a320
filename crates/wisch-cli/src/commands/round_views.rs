//! What is shown of rounds: to programs, to people, and in the report.

use super::job::Done;
use super::prepare::Prepared;
use super::words::{counted, percent};
use wisch::interpret::EventKind;
use wisch::recover::{Claim, Verdict};
use wisch::run::Ending;
use wisch_io::RoundSummary;
use wisch_report::{RoundView, RoundsInput};

/// What `--json` says of a round.
pub fn summary(done: &Done) -> RoundSummary {
    RoundSummary::new(
        &done.round,
        &done.times,
        done.executed_by,
        done.true_performance,
    )
}

/// What figures show of the rounds.
pub fn views(done: &[Done]) -> Vec<RoundView<'_>> {
    (done.iter())
        .map(|done| RoundView {
            number: done.round.motion.number,
            plan: Some(&done.round.motion.plan),
            believed: &done.round.motion.task.particles,
            predicted: done.round.motion.prediction.performance.ratio(),
            interpretation: &done.round.interpretation,
            truth: done.truth.as_ref().zip(done.true_performance),
            pushes: &done.pushes,
        })
        .collect()
}

/// The report's part about rounds.
pub fn input<'a>(
    done: &'a [Done],
    views: &'a [RoundView<'a>],
    prepared: &'a Prepared,
) -> Option<RoundsInput<'a>> {
    let first = done.first()?;
    Some(RoundsInput {
        task: &prepared.task,
        goal: &first.round.motion.plan.graph.goal,
        target: prepared.file.target_performance(),
        rounds: views,
    })
}

/// The rounds for people: a line each, then one for each doubt about its log.
pub fn rounds_in_words(done: &[Done], target: f64) -> Vec<(&'static str, String)> {
    done.iter()
        .flat_map(|done| {
            let round = &done.round;
            let interpretation = &round.interpretation;
            let estimate = &interpretation.performance;
            let interval = format!("{} to {}", percent(estimate.low), percent(estimate.high));
            let mut text = if interpretation.can_be_told() {
                format!("estimated {} ({interval})", percent(estimate.mean))
            } else {
                format!("what was wiped cannot be told ({interval} is possible)")
            };
            if let Some(truth) = done.true_performance {
                text += &format!(", true {}", percent(truth));
            }
            let collisions = (interpretation.events.iter())
                .filter(|event| event.kind == EventKind::Collision)
                .count();
            if collisions > 0 {
                text += &format!(", {}", counted(collisions, "collision"));
            }
            if let wisch::interpret::Diagnosis::Relocalize { .. } = interpretation.diagnosis
                && let Some(plane) = &interpretation.plane
            {
                text += &format!(
                    ", surface found tilted by {:.1}° and {:.1} mm off",
                    plane.tilt.to_degrees(),
                    1e3 * plane.offset
                );
            }
            if let Ending::Early { time, cause } = &round.execution.ending {
                text += &format!(", ended at {time:.1} s, as {cause}");
            }
            if let Ending::ProtectiveStop { time, cause } = &round.execution.ending {
                text += &format!(", stopped at {time:.1} s: {cause}");
            }
            if !done.missed.is_empty() {
                let ended = round.motion.followed.duration();
                let missed = done.missed.join(" and ");
                text += &format!(", {missed} did not happen: the motion ended at {ended:.1} s");
            }
            text += &format!(": {}", round.verdict.as_str());
            if round.verdict == Verdict::UnknowableByTouch {
                let claim = Claim::of(&round.interpretation.distribution, target);
                text += &format!(" ({claim}; a camera would tell)");
            }
            let number = round.motion.number;
            let name = if number == 1 { "rounds" } else { "" };
            let doubts = interpretation
                .doubts
                .iter()
                .map(|doubt| ("", format!("   {doubt}")));
            std::iter::once((name, format!("{number}: {text}"))).chain(doubts)
        })
        .collect()
}
