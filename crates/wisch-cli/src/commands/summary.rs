//! The summary of a command: a record for `--json`, and a text for people.

use super::explain::{format_table, summarise_candidates};
use super::round_views::rounds_in_words;
use super::words::{format_count, percent};
use std::path::Path;
use wisch::interpret::PerformanceDistribution;
use wisch::recover::{Verdict, assess_goal};
use wisch::represent::{Action, ParticleDistribution, Treatment, describe_weak_reaction};
use wisch_io::{
    BendContactRecord, FollowingSummary, LoopSummary, PredictionSummary, SUMMARY_SCHEMA, Summary,
    TreatmentSummary,
};
use wisch_io::{FOLLOWING_FILE, LoadedTask, PLAN_FILE, REPORT_FILE, path_in_results};
use wisch_record::{FinishedRound, FollowedPlan, NO_SHAPES, RunResults, joint_movement_in_words};

/// Members of a belief over which a treatment is averaged.
const SUMMARISED: usize = 64;

/// Makes the record.
pub(super) fn summary(prepared: &LoadedTask, results: &RunResults, out: &Path) -> Summary {
    let task = &prepared.task;
    let plan = &results.plan;
    let prediction = results.predicted.as_ref().map(|(prediction, _)| prediction);
    let execution = LoopSummary::new(results.rounds.iter().map(FinishedRound::summary).collect());
    let [in_contact, in_all] = match (&execution, &results.following) {
        (Some(rounds), _) => [
            rounds.total(|round| round.distance_in_contact_m) + 0.0,
            rounds.total(|round| round.distance_total_m) + 0.0,
        ],
        (None, Some(following)) => following.total.distance,
        (None, None) => [plan.contact_distance(), plan.total_distance()],
    };
    let target_performance = prepared.run.target;
    Summary {
        schema: SUMMARY_SCHEMA,
        task: task.name.clone(),
        action: task.action.to_string(),
        surface: task.surface.name.clone(),
        tool: task.tool.name.clone(),
        medium: task.medium.clone(),
        strategy: plan.strategy.to_string(),
        seed: prepared.run.plan.seed,
        particles: task.particles.len(),
        nodes: plan.graph.nodes.len(),
        edges: plan.graph.edges.len(),
        strokes: plan.strokes.len(),
        unreachable_share: plan.unreachable_share,
        bend_contact: BendContactRecord::new(task),
        distance_in_contact_m: in_contact,
        distance_total_m: in_all,
        planning_time_s: results.planning_time_s,
        treatment: summarise_treatment(prepared, results),
        following: (results.following.as_ref()).map(FollowedPlan::summary),
        prediction: prediction.map(|prediction| {
            let performance = prediction.performance;
            let predicted_performance = performance.ratio();
            PredictionSummary {
                predicted_performance,
                target_performance,
                goal_met: results.is_goal_met(target_performance),
                goal: goal_in_words(results, target_performance),
                reaction_probability: task.interaction.reaction_probability(),
                lost_share: performance.lost as f64 / performance.initial.max(1) as f64,
                undetected: results.unseen.filter(|_| results.rounds.is_empty()),
            }
        }),
        execution,
        candidates: (results.considered.as_ref()).map(|all| summarise_candidates(all, plan, task)),
        out: out.display().to_string(),
    }
}

/// Returns what is known about the goal after the last round; `None` without an executed round.
fn decide_goal(rounds: &[FinishedRound], target: f64) -> Option<Verdict> {
    let last = &rounds.last()?.round;
    Some(assess_goal(
        last.verdict,
        &last.motion.task,
        &last.interpretation,
        target,
    ))
}

/// Returns whether the goal is met, not met or unknown.
fn goal_in_words(results: &RunResults, target: f64) -> &'static str {
    match decide_goal(&results.rounds, target) {
        _ if results.is_goal_met(target) => "met",
        Some(Verdict::UnknowableByTouch | Verdict::Undecidable) => "unknown",
        None if results.unseen.is_some() || results.is_only_predicted(target) => "unknown",
        None if results.depends_on_reaction(target) => "unknown",
        _ => "not met",
    }
}

/// Averages the passes over the points of a treated surface: as estimated after the last round, else as predicted.
fn summarise_treatment(prepared: &LoadedTask, results: &RunResults) -> Option<TreatmentSummary> {
    let task = &prepared.task;
    let treatment = task.treatment?;
    let places: Vec<ParticleDistribution> = match results.rounds.last() {
        Some(last) => {
            let belief = &last.round.interpretation.belief;
            belief.draw_members(SUMMARISED, prepared.run.plan.seed)
        }
        None => vec![results.predicted.as_ref()?.0.particles.clone()],
    };
    let count = places.len() as f64;
    let spreads = places.iter().map(Treatment::spread);
    let [mean_passes, passes_deviation] = spreads.fold([0.0; 2], |[mean, deviation], of_one| {
        [mean + of_one[0] / count, deviation + of_one[1] / count]
    });
    let above = places
        .iter()
        .map(|places| treatment.share_above_limit(places));
    let above: Option<f64> = above.sum();
    let interval = results.rounds.last().and_then(|last| {
        let belief = &last.round.interpretation.belief;
        let members = belief.members().iter().zip(belief.weights());
        let shares =
            members.map(|(places, weight)| Some((treatment.share_above_limit(places)?, *weight)));
        let shares: Option<Vec<(f64, f64)>> = shares.collect();
        Some(PerformanceDistribution::from_shares(shares?, 0.0).interval(0.9))
    });
    let per_pass = task.depth_per_pass();
    Some(TreatmentSummary {
        mean_passes,
        passes_deviation,
        max_passes: match treatment {
            Treatment::Polish { max_passes, .. } => Some(max_passes),
            Treatment::Dispense { .. } => None,
        },
        share_above_max_passes: above.map(|above| above / count),
        share_above_max_passes_interval: interval,
        mean_depth_m: per_pass.map(|per_pass| per_pass * mean_passes),
    })
}

/// What the tool reaches, and how it touches a surface that bends.
fn reach_in_words(summary: &Summary) -> impl Iterator<Item = (&'static str, String)> {
    let contact = summary.bend_contact.map(|record| record.contact());
    let contact = contact.map(|contact| ("contact", contact.to_string()));
    std::iter::once(("out of reach", percent(summary.unreachable_share))).chain(contact)
}

/// The estimated or predicted performance, and whether the goal is met.
fn performance_in_words(
    summary: &Summary,
    prediction: &PredictionSummary,
    rounds: &[FinishedRound],
) -> String {
    let target = prediction.target_performance;
    let above = (summary.treatment).and_then(|treatment| treatment.share_above_max_passes);
    let (word, performance) = match &summary.execution {
        Some(execution) if !execution.is_conclusive => {
            ("unknown; guessed", execution.final_estimated)
        }
        Some(execution) => ("estimated", execution.final_estimated),
        None => ("predicted", prediction.predicted_performance),
    };
    let verdict = match decide_goal(rounds, target) {
        // A camera sees dirt, but neither polish nor a coat.
        Some(Verdict::UnknowableByTouch) if summary.treatment.is_none() => {
            "unknown, needs a camera"
        }
        _ if prediction.goal == "not met"
            && (performance >= target || decide_goal(rounds, target).is_some())
            && above.is_some_and(|above| above > 1.0 - target) =>
        {
            "not met: too many points above max_passes"
        }
        None if prediction.undetected.is_some() => "unknown, no dirt is detected",
        None if prediction.goal == "unknown" && prediction.reaction_probability < target => {
            "unknown, see reaction"
        }
        None if prediction.goal == "unknown" => "unknown, nothing was wiped",
        _ => prediction.goal,
    };
    let what = if summary.treatment.is_some() {
        "points"
    } else {
        "particles"
    };
    format!(
        "{word} {} of {} {what} (target {}: {verdict})",
        percent(performance),
        summary.particles,
        percent(target),
    )
}

/// The summary for people. `executor`: name of what executed the motions, if it was not the simulated world.
pub(super) fn in_words(
    summary: &Summary,
    (rounds, out): (&[FinishedRound], &Path),
    executor: &str,
) -> String {
    let mut lines = vec![];
    if let Some(prediction) = &summary.prediction {
        lines.push((
            "performance",
            performance_in_words(summary, prediction, rounds),
        ));
        if rounds.is_empty() {
            let weak = describe_weak_reaction(
                prediction.reaction_probability,
                prediction.target_performance,
            );
            lines.extend(weak.map(|sentence| ("reaction", sentence)));
        }
        if let Some(following) = &summary.following {
            lines.extend(faults_in_words(
                following.faults,
                following.first_fault.as_deref(),
                following.refused_round,
            ));
        }
        lines.extend(rounds_in_words(rounds, prediction.target_performance));
        if summary.execution.is_some() {
            let predicted = percent(prediction.predicted_performance);
            lines.push(("predicted", format!("{predicted} for the first round")));
        }
        match &summary.treatment {
            Some(treatment) => lines.extend(treatment_in_words(treatment, &summary.action)),
            None => lines.push(("lost over an edge", percent(prediction.lost_share))),
        }
    } else {
        let treats = summary.action.parse().is_ok_and(Action::treats);
        let what = if treats { "points" } else { "particles" };
        lines.push((what, summary.particles.to_string()));
    }
    lines.extend(reach_in_words(summary));
    lines.push((
        "graph",
        format!(
            "{}, {}, {}",
            format_count(summary.nodes, "node"),
            format_count(summary.edges, "edge"),
            format_count(summary.strokes, "stroke")
        ),
    ));
    let in_rounds = match rounds.len() {
        0 | 1 => String::new(),
        count => format!(", in {count} rounds"),
    };
    lines.push((
        "distance",
        format!(
            "{:.2} m in contact, {:.2} m total{in_rounds}",
            summary.distance_in_contact_m, summary.distance_total_m
        ),
    ));
    if let Some(time) = summary.planning_time_s {
        lines.push(("planning time", format!("{time:.3} s")));
    }
    if let Some(following) = &summary.following {
        lines.extend(robot_in_words(following, &in_rounds));
    }
    if let Some(execution) = &summary.execution {
        match execution.realtime_factor {
            Some(factor) => lines.push(("simulation", format!("{factor:.1} times real time"))),
            None => lines.push(("executed by", executor.to_owned())),
        }
    }
    let result = match summary.prediction {
        Some(_) => ("report", REPORT_FILE),
        None => ("plan", PLAN_FILE),
    };
    lines.push((result.0, out.join(result.1).display().to_string()));

    let mut text = format!(
        "{}: {} {} with {} on {} ({}, seed {})\n",
        summary.task,
        summary.action,
        summary.medium,
        summary.tool,
        summary.surface,
        summary.strategy,
        summary.seed
    );
    for (name, value) in lines {
        text += &format!("  {name:<18} {value}\n");
    }
    if let Some(candidates) = &summary.candidates {
        text += &format_table(candidates);
    }
    text
}

/// The lines about a treated surface, for people.
fn treatment_in_words(treatment: &TreatmentSummary, action: &str) -> Vec<(&'static str, String)> {
    let TreatmentSummary {
        mean_passes,
        passes_deviation,
        max_passes,
        share_above_max_passes,
        share_above_max_passes_interval,
        mean_depth_m,
    } = treatment;
    let mut passes =
        format!("mean {mean_passes:.2}, standard deviation {passes_deviation:.2} over the points");
    if let (Some(most), Some(above)) = (max_passes, share_above_max_passes)
        && *above > 0.0
    {
        let above = percent(*above);
        passes += &format!("; more than the maximum of {most} on {above} of the points");
        if let Some([low, high]) = share_above_max_passes_interval {
            passes += &format!(" ({} to {})", percent(*low), percent(*high));
        }
    }
    let mut lines = vec![("passes", passes)];
    if let Some(depth) = mean_depth_m {
        let name = if action == "dispense" {
            "thickness"
        } else {
            "removed"
        };
        let off = depth * passes_deviation / mean_passes.max(f64::MIN_POSITIVE);
        let (scale, unit) = if *depth < 1e-6 {
            (1e9, "nm")
        } else {
            (1e6, "µm")
        };
        let (depth, off) = (scale * depth, scale * off);
        lines.push((
            name,
            format!("mean {depth:.1} {unit}, standard deviation {off:.1} {unit}"),
        ));
    }
    lines
}

/// The lines about the robot, for people.
fn robot_in_words(following: &FollowingSummary, in_rounds: &str) -> Vec<(&'static str, String)> {
    let places = match following.placements.len() {
        0 => String::new(),
        count => format!(", {}", format_count(count, "placement")),
    };
    let in_rounds_if_any = match following.abandoned_nodes {
        0 => "",
        _ => in_rounds,
    };
    let abandoned = format_count(following.abandoned_nodes, "node");
    let mut lines = vec![(
        "robot",
        format!(
            "{}: {abandoned} abandoned{in_rounds_if_any}{places}",
            following.robot
        ),
    )];
    lines.push(("tool held", following.mount.clone()));
    if !following.held_joints.is_empty() {
        let joints = following.held_joints.join(", ");
        lines.push(("joints held", format!("{joints}, at their ready positions")));
    }
    if !following.has_shapes {
        lines.push(("links", NO_SHAPES.to_owned()));
    }
    if following.contact_time_s <= 0.0 && following.execution_time_s > 0.0 {
        lines.push((
            "sliding",
            "none: the tool touches down and lifts off at single points, so its effect may not be measurable"
                .to_owned(),
        ));
        lines.extend(motion_in_words(following, in_rounds));
    } else if following.contact_time_s <= 0.0 {
        let reason = match following.abandoned_nodes {
            0 => "the plan has no stroke",
            _ => "the robot reaches no stroke of the plan",
        };
        lines.push(("motion", format!("none in contact: {reason}")));
    } else {
        lines.extend(motion_in_words(following, in_rounds));
    }
    lines.push((
        "following time",
        format!("{:.3} s", following.following_time_s),
    ));
    if let Some(obstruction) = &following.first_obstruction {
        lines.push((
            "abandoned first",
            format!(
                "{obstruction}; all abandoned nodes are in {}",
                path_in_results(FOLLOWING_FILE).display()
            ),
        ));
    }
    lines
}

/// The verdict on a motion with faults, and the first of them; nothing for a motion without a fault. `round`: its round in a run.
fn faults_in_words(
    count: usize,
    first: Option<&str>,
    round: Option<usize>,
) -> Vec<(&'static str, String)> {
    let Some(first) = first else {
        return Vec::new();
    };
    let verdict = Verdict::UnsafeMotion.as_str();
    let faults = format_count(count, "fault");
    let motion = match round {
        Some(round @ 2..) => format!("the motion of round {round}"),
        _ => "the motion".to_owned(),
    };
    // The file is about the first round.
    let rest = match round {
        Some(2..) => String::new(),
        _ => format!(
            "; all faults are in {}",
            path_in_results(FOLLOWING_FILE).display()
        ),
    };
    vec![
        (
            "verdict",
            format!("{verdict}: the audit found {faults}, so {motion} is not executed"),
        ),
        ("first fault", format!("{first}{rest}")),
    ]
}

/// The motion of the robot in the summary for people.
fn motion_in_words(following: &FollowingSummary, in_rounds: &str) -> [(&'static str, String); 3] {
    [
        (
            "execution time",
            format!(
                "{:.1} s, {:.1} s in contact{in_rounds}",
                following.execution_time_s, following.contact_time_s
            ),
        ),
        (
            "joint movement",
            joint_movement_in_words(
                [
                    following.joint_movement_in_contact_rad,
                    following.joint_movement_rad,
                ],
                (following.joint_movement_in_contact_m)
                    .zip(following.joint_movement_m)
                    .map(<[f64; 2]>::from),
            ) + in_rounds,
        ),
        (
            "motion",
            format!(
                "path error at most {:.2} mm, clearance at least {:.1} mm",
                // Bounds are rounded to the safe side.
                (1e5 * following.max_path_deviation_m).ceil() / 100.0,
                (1e4 * following.min_clearance_m).floor() / 10.0
            ),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::faults_in_words;

    #[test]
    fn a_motion_with_faults_has_a_verdict_and_names_the_first() {
        assert!(faults_in_words(0, None, None).is_empty());
        let lines = faults_in_words(2, Some("at 1.000 s: the tool leans"), None);
        let expected = "unsafe motion: the audit found 2 faults, so the motion is not executed";
        assert_eq!(lines[0], ("verdict", expected.to_owned()));
        let (name, fault) = &lines[1];
        assert_eq!(*name, "first fault");
        assert!(
            fault.starts_with("at 1.000 s: the tool leans; all faults are in "),
            "{fault}"
        );
        let lines = faults_in_words(1, Some("at 1.000 s: the tool leans"), Some(3));
        let expected =
            "unsafe motion: the audit found 1 fault, so the motion of round 3 is not executed";
        assert_eq!(lines[0], ("verdict", expected.to_owned()));
        assert_eq!(lines[1].1, "at 1.000 s: the tool leans");
    }
}
