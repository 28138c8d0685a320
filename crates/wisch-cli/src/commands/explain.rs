//! `wisch plan --explain`: the plans of all strategies side by side.

use super::swept::predict_covered_share;
use super::words::percent;
use wisch::plan::Plan;
use wisch::represent::Task;
use wisch::run::CandidateEvaluation;
use wisch_io::CandidateSummary;

/// The definition of a plan's score, for people.
const SCORE: &str = "score = share of the dirt that reaches the goal, averaged over random draws of the belief, \
                     minus three times the lost share, minus a penalty for heaps near an edge, minus costs of \
                     remaining dirt by its distance, of path length and of time";

/// Returns a summary of every evaluated candidate and marks the chosen plan.
pub(super) fn summarise_candidates(
    considered: &[CandidateEvaluation],
    chosen: &Plan,
    task: &Task,
) -> Vec<CandidateSummary> {
    let candidates = considered.iter().map(|one| {
        let (found, error) = match &one.candidate {
            Ok(candidate) => (Some(candidate), None),
            Err(error) => (None, Some(error.to_string())),
        };
        let plan = found.map(|found| &found.plan);
        let performance = found
            .and(one.prediction.as_ref())
            .map(|predicted| predicted.performance);
        CandidateSummary {
            strategy: one.strategy.to_string(),
            chosen: one.strategy == chosen.strategy,
            score: found.map(|found| found.score.total),
            predicted_performance: performance.map(|performance| performance.ratio()),
            lost_share: performance.map(|p| p.lost as f64 / p.initial.max(1) as f64),
            covered_share: plan.map(|plan| predict_covered_share(plan, task)),
            distance_in_contact_m: plan.map(Plan::contact_distance),
            distance_total_m: plan.map(Plan::total_distance),
            strokes: plan.map(|plan| plan.strokes.len()),
            execution_time_s: one.motion.map(|motion| motion.duration),
            abandoned_nodes: one.motion.map(|motion| motion.abandoned),
            error,
        }
    });
    candidates.collect()
}

/// Formats the candidates as a table with the chosen plan marked, and adds the reason for the choice.
pub(super) fn format_table(candidates: &[CandidateSummary]) -> String {
    let has_motion = candidates.iter().any(|one| one.execution_time_s.is_some());
    let mut text = format!(
        "\n    {:<9} {:>6} {:>9} {:>7} {:>7} {:>11} {:>7} {:>7}",
        "strategy", "score", "predicted", "lost", "covered", "in contact", "total", "strokes"
    );
    if has_motion {
        text += &format!(" {:>7} {:>9}", "time", "abandoned");
    }
    text += "\n";
    for one in candidates {
        let mark = if one.chosen { '*' } else { ' ' };
        text += &format!("  {mark} {:<9}", one.strategy);
        if let Some(error) = &one.error {
            text += &format!(" no plan: {error}\n");
            continue;
        }
        let share = |share: Option<f64>| share.map_or_else(|| "–".to_owned(), percent);
        let metres = |way: Option<f64>| way.map_or_else(|| "–".to_owned(), |m| format!("{m:.2} m"));
        text += &format!(
            " {:>6} {:>9} {:>7} {:>7} {:>11} {:>7} {:>7}",
            one.score
                .map_or_else(|| "–".to_owned(), |w| format!("{w:.3}")),
            share(one.predicted_performance),
            share(one.lost_share),
            share(one.covered_share),
            metres(one.distance_in_contact_m),
            metres(one.distance_total_m),
            one.strokes.unwrap_or(0),
        );
        if let (Some(time), Some(abandoned)) = (one.execution_time_s, one.abandoned_nodes) {
            text += &format!(" {:>7} {abandoned:>9}", format!("{time:.1} s"));
        }
        text += "\n";
    }
    text + &explain_choice(candidates)
}

/// Formats the reason why the marked candidate was chosen.
fn explain_choice(candidates: &[CandidateSummary]) -> String {
    let mut by_score: Vec<(&str, f64)> = (candidates.iter())
        .filter_map(|one| Some((one.strategy.as_str(), one.score?)))
        .collect();
    by_score.sort_by(|a, b| b.1.total_cmp(&a.1));
    let Some(chosen) = candidates.iter().find(|one| one.chosen) else {
        return String::new();
    };
    let name = &chosen.strategy;
    match by_score[..] {
        [(best, score), (next, less), ..] if best == name.as_str() => {
            format!(
                "\n    {name} has the highest score, {score:.3}; {next} follows with {less:.3}\n    {SCORE}\n"
            )
        }
        [(best, _), _, ..] => format!(
            "\n    {name} was requested; --strategy best would choose {best}, which has the highest score\n    {SCORE}\n"
        ),
        _ => format!("\n    only {name} found a plan\n"),
    }
}
