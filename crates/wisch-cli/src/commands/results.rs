//! The files with the results of the stages.

use super::job::Results;
use super::packed::packed;
use super::prepare::Prepared;
use super::round_views::{input, summary as summary_of_round, views};
use super::words::{internal, json, percent};
use crate::args::ResultArgs;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use wisch::follow::{Followed, MotionFault, Workcell};
use wisch::plan::{Plan, Prediction};
use wisch::run::PlannedRound;
use wisch_io::RoundSummary;
use wisch_io::{
    FOLLOWING_FILE, OutputFolder, PARTICLES_AFTER_FILE, PARTICLES_BEFORE_FILE,
    PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE, RECORDING_FILE, REPORT_FILE,
    ROUNDS_FILE, TCP_PATH_FILE, TRAJECTORY_FILE, of_round,
};
use wisch_io::{
    FollowedRecord, PlanRecord, RobotTrajectory, particles_to_csv, planned_path_csv, tcp_path_csv,
};
use wisch_report::{self as report, EffectFrames, ReportInput, ShownMotion};
use wisch_web::report_page;

/// Pixels per unit of a picture's own size.
#[cfg(feature = "png")]
const PNG_SCALE: f32 = 2.0;

/// Longest name of a folder that is derived from a task's [characters]; file systems take 255 bytes.
const MAX_NAME_LEN: usize = 60;

/// Where the results go: those of a run into a folder of the task's name, those of less beside it, under that name and
/// what was done.
pub(super) fn out_folder(results: &ResultArgs, prepared: &Prepared, done: &str) -> PathBuf {
    results.out.clone().unwrap_or_else(|| {
        let name = folder_name(&prepared.task.name);
        Path::new("out").join(format!("{name}{done}"))
    })
}

/// A task's name as that of a folder: a name may be anything, a path may not.
pub(super) fn folder_name(task: &str) -> String {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '-'
        }
    };
    let name: String = task.chars().map(plain).take(MAX_NAME_LEN).collect();
    match name.trim_start_matches('.') {
        "" => "task".to_owned(),
        name => name.to_owned(),
    }
}

/// Writes all of them.
pub(super) fn write(
    folder: &OutputFolder,
    prepared: &Prepared,
    results: &Results,
) -> Result<(), Failure> {
    let record = PlanRecord::new(&results.task, &results.plan, prepared.config.seed);
    folder.write(PLAN_FILE, json(&record)?)?;
    folder.write(
        PARTICLES_BEFORE_FILE,
        particles_to_csv(&results.task.particles),
    )?;
    if let Some(following) = &results.following {
        let (followed, cell) = (&following.followed, &following.cell);
        let faults = &following.audit.faults;
        write_motion(folder, prepared, 1, (followed, cell, faults))?;
        for done in results.rounds.iter().skip(1) {
            let PlannedRound {
                number,
                task,
                plan,
                cell,
                followed,
                ..
            } = &done.round.motion;
            let record = PlanRecord::new(task, plan, task.seed);
            folder.write(&of_round(PLAN_FILE, *number), json(&record)?)?;
            let faults = &done.round.audit.faults;
            write_motion(folder, prepared, *number, (followed, cell, faults))?;
        }
    } else if results.rounds.is_empty() {
        let config = prepared.follow_config();
        let path = planned_path_csv(&results.task, &results.plan, &config);
        folder.write(TCP_PATH_FILE, path)?;
    }
    if let Some((prediction, frames)) = &results.predicted {
        folder.write(
            PARTICLES_AFTER_FILE,
            particles_to_csv(&prediction.particles),
        )?;
        write_figures(folder, prepared, results, prediction, frames)?;
        write_report(folder, prepared, &results.recording)?;
    }
    if let Some(last) = results.rounds.last() {
        let interpretation = &last.round.interpretation;
        let estimated = interpretation
            .belief
            .sample(prepared.task.seed)
            .map_err(internal)?;
        folder.write(PARTICLES_ESTIMATED_FILE, particles_to_csv(&estimated))?;
        if let Some(truth) = &last.truth {
            folder.write(PARTICLES_TRUE_FILE, particles_to_csv(truth))?;
        }
        let summaries = results.rounds.iter().map(summary_of_round);
        let rounds: Vec<_> = summaries.map(RoundSummary::without_timing).collect();
        folder.write(ROUNDS_FILE, json(&rounds)?)?;
    }
    Ok(())
}

/// Writes the motion of a round: how the plan is followed, its trajectory, and the tool's path.
fn write_motion(
    folder: &OutputFolder,
    prepared: &Prepared,
    round: usize,
    (followed, cell, faults): (&Followed, &Workcell, &[MotionFault]),
) -> Result<(), Failure> {
    let name = |file: &str| of_round(file, round);
    let faults = faults.iter().map(ToString::to_string);
    let record = FollowedRecord::new(cell.robot().name(), followed, faults.collect());
    folder.write(&name(FOLLOWING_FILE), json(&record)?)?;
    let trajectory = RobotTrajectory::new(followed, cell);
    let message = trajectory.to_json().map_err(internal)?;
    folder.write(&name(TRAJECTORY_FILE), message)?;
    let path = tcp_path_csv(followed, cell, &prepared.task.interaction);
    folder.write(&name(TCP_PATH_FILE), path)?;
    Ok(())
}

fn write_figures(
    folder: &OutputFolder,
    prepared: &Prepared,
    results: &Results,
    prediction: &Prediction,
    frames: &EffectFrames,
) -> Result<(), Failure> {
    let following = results.following.as_ref();
    let wiped = following.map_or_else(|| results.plan.clone(), |f| f.plan(&results.plan));
    let shown = following.map(|f| ShownMotion::of(&f.cell, &f.followed, frames));
    let motion = shown.as_ref().map(|shown| shown.input(&results.task));
    let views = views(&results.rounds);
    let rounds = input(&results.rounds, &views, prepared);
    let input = ReportInput {
        title: &title(prepared),
        task: &results.task,
        plan: &wiped,
        motion: motion.as_ref(),
        rounds: rounds.as_ref(),
        prediction,
        frames,
        bandwidth: prepared.config.bandwidth,
    };
    for (name, svg) in report::pictures(&input) {
        folder.write(&format!("{name}.svg"), &svg)?;
        #[cfg(feature = "png")]
        folder.write(
            &format!("{name}.png"),
            report::rasterize(&svg, PNG_SCALE).map_err(internal)?,
        )?;
    }
    Ok(())
}

fn write_report(
    folder: &OutputFolder,
    prepared: &Prepared,
    recording: &[u8],
) -> Result<(), Failure> {
    let text = std::str::from_utf8(recording).map_err(internal)?;
    folder.write(RECORDING_FILE, packed(recording)?)?;
    folder.write(REPORT_FILE, report_page(&title(prepared), text))?;
    Ok(())
}

/// What the report says beside its pictures.
pub(super) fn facts_of(prepared: &Prepared, results: &Results) -> Vec<(String, String)> {
    let Some((prediction, _)) = &results.predicted else {
        return Vec::new();
    };
    let following = results.following.as_ref();
    let wiped = following.map_or_else(|| results.plan.clone(), |f| f.plan(&results.plan));
    let distance = match (following, results.rounds.is_empty()) {
        (Some(following), false) => following.total.distance,
        _ => [wiped.contact_distance(), wiped.total_distance()],
    };
    let mut facts = facts(prepared, &wiped, prediction, distance);
    facts.extend(following.iter().flat_map(|following| following.facts()));
    facts
}

pub(super) fn title(prepared: &Prepared) -> String {
    let task = &prepared.task;
    format!(
        "{}: {} {} with {} on {}",
        task.name, task.action, task.medium, task.tool.name, task.surface.name
    )
}

/// What the report says beside its numbers.
///
/// `distance`: of the tool in contact and in all, in all rounds [m].
fn facts(
    prepared: &Prepared,
    plan: &Plan,
    prediction: &Prediction,
    distance: [f64; 2],
) -> Vec<(String, String)> {
    let tally = prediction.particles.tally();
    let performance = &prediction.performance;
    let mut facts: Vec<(String, String)> = [
        ("Predicted performance", percent(performance.ratio())),
        (
            "Target performance",
            percent(prepared.file.target_performance()),
        ),
        ("Particles", tally.initial.to_string()),
        ("Still on the surface", tally.remaining.to_string()),
        ("Absorbed", tally.absorbed.to_string()),
        ("Off the surface", tally.off_surface.to_string()),
        ("Lost over a wrong edge", performance.lost.to_string()),
        ("Out of reach", percent(plan.unreachable_share)),
        ("Distance in contact", format!("{:.2} m", distance[0])),
        ("Distance in all", format!("{:.2} m", distance[1])),
        (
            "Graph",
            format!(
                "{} nodes, {} edges",
                plan.graph.nodes.len(),
                plan.graph.edges.len()
            ),
        ),
        ("Strokes", plan.strokes.len().to_string()),
        (
            "Collision sphere",
            format!("r_s = {:.4} m", plan.collision_radius),
        ),
        ("Strategy", prepared.strategy().to_string()),
        ("Seed", prepared.config.seed.to_string()),
    ]
    .map(|(label, value)| (label.to_owned(), value))
    .to_vec();
    if let Some(longest) = plan.graph.max_edge_length {
        facts.push(("Longest edge allowed".to_owned(), format!("{longest:.3} m")));
    }
    if let Some(derived) = &prepared.derived {
        facts.push(("Goal".to_owned(), derived.goal.clone()));
        facts.push(("Steps".to_owned(), derived.steps.join(" ")));
    }
    facts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_lead_out_of_the_folder() {
        assert_eq!(folder_name("chopping-board"), "chopping-board");
        assert_eq!(folder_name("../../etc"), "-..-etc");
        assert_eq!(folder_name(".."), "task");
        assert_eq!(folder_name("my board/2"), "my-board-2");
    }
}
