//! The files of a folder of results.

use crate::error::{RecordError, internal};
use crate::results::{FinishedRound, RunResults};
use crate::words::{json, percent};
use wisch::follow::{Followed, MotionFault, Workcell};
use wisch::plan::{Plan, Prediction};
use wisch::run::PlannedRound;
use wisch_io::{
    FOLLOWING_FILE, FollowedRecord, LoadedTask, OutputFolder, PARTICLES_AFTER_FILE,
    PARTICLES_BEFORE_FILE, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE, PlanRecord,
    RECORDING_FILE, REPORT_FILE, ROUNDS_FILE, RobotTrajectory, RoundSummary, TCP_PATH_FILE,
    TRAJECTORY_FILE, particles_to_csv, planned_path_csv, round_file_name, tcp_path_csv,
};
use wisch_report::{
    self as report, EffectFrames, ReportInput, RoundView, RoundsInput, RunFact, ShownMotion,
};
use wisch_web::report_page;

/// Pixels per unit of length in a picture.
#[cfg(feature = "png")]
const PNG_SCALE: f32 = 2.0;

/// Writes the results of a run into an unfinished folder: plan, particles, motions, rounds, figures, recording and report.
/// A [`BagSink`](crate::BagSink) writes the bags.
///
/// # Errors
/// If a file cannot be written.
pub fn write_results(
    folder: &OutputFolder,
    loaded: &LoadedTask,
    results: &RunResults,
) -> Result<(), RecordError> {
    let record = PlanRecord::new(&results.task, &results.plan, loaded.run.plan.seed);
    folder.write(PLAN_FILE, json(&record)?)?;
    folder.write(
        PARTICLES_BEFORE_FILE,
        particles_to_csv(&results.task.particles),
    )?;
    if let Some(following) = &results.following {
        let (followed, cell) = (&following.followed, &following.cell);
        let faults = &following.audit.faults;
        write_motion(folder, loaded, 1, (followed, cell, faults))?;
        for finished in results.rounds.iter().skip(1) {
            let PlannedRound {
                number,
                task,
                plan,
                cell,
                followed,
                ..
            } = &finished.round.motion;
            let record = PlanRecord::new(task, plan, task.seed);
            folder.write(&round_file_name(PLAN_FILE, *number), json(&record)?)?;
            let faults = &finished.round.audit.faults;
            write_motion(folder, loaded, *number, (followed, cell, faults))?;
        }
    } else if results.rounds.is_empty() {
        let config = loaded.run.follow.clone();
        let path = planned_path_csv(&results.task, &results.plan, &config);
        folder.write(TCP_PATH_FILE, path)?;
    }
    if let Some((prediction, frames)) = &results.predicted {
        folder.write(
            PARTICLES_AFTER_FILE,
            particles_to_csv(&prediction.particles),
        )?;
        write_figures(folder, loaded, results, prediction, frames)?;
        write_report(folder, loaded, results)?;
    }
    if let Some(last) = results.rounds.last() {
        let interpretation = &last.round.interpretation;
        let estimated = interpretation
            .belief
            .sample(loaded.task.seed)
            .map_err(internal)?;
        folder.write(PARTICLES_ESTIMATED_FILE, particles_to_csv(&estimated))?;
        if let Some(truth) = (last.truth.as_ref()).and_then(|known| known.particles.as_ref()) {
            folder.write(PARTICLES_TRUE_FILE, particles_to_csv(truth))?;
        }
        let summaries = results.rounds.iter().map(FinishedRound::summary);
        let rounds: Vec<_> = summaries.map(RoundSummary::without_timing).collect();
        folder.write(ROUNDS_FILE, json(&rounds)?)?;
    }
    Ok(())
}

/// Writes the motion of a round: following record, trajectory, and path of the tool.
fn write_motion(
    folder: &OutputFolder,
    loaded: &LoadedTask,
    round: usize,
    (followed, cell, faults): (&Followed, &Workcell, &[MotionFault]),
) -> Result<(), RecordError> {
    let name = |file: &str| round_file_name(file, round);
    let faults = faults.iter().map(ToString::to_string);
    let record = FollowedRecord::new(cell.robot().name(), followed, faults.collect());
    folder.write(&name(FOLLOWING_FILE), json(&record)?)?;
    let trajectory = RobotTrajectory::new(followed, cell);
    let message = trajectory.to_json().map_err(internal)?;
    folder.write(&name(TRAJECTORY_FILE), message)?;
    let path = tcp_path_csv(followed, cell, &loaded.task.interaction);
    folder.write(&name(TCP_PATH_FILE), path)?;
    Ok(())
}

fn write_figures(
    folder: &OutputFolder,
    loaded: &LoadedTask,
    results: &RunResults,
    prediction: &Prediction,
    frames: &EffectFrames,
) -> Result<(), RecordError> {
    let following = results.following.as_ref();
    let wiped = results.executable_plan();
    let shown = following.map(|f| ShownMotion::sample(&f.cell, &f.followed));
    let motion = shown.as_ref().map(|shown| shown.input(&results.task));
    let views = views(&results.rounds);
    let rounds = results.rounds.first().map(|first| RoundsInput {
        task: &loaded.task,
        goal: &first.round.motion.plan.graph.goal,
        target: loaded.run.target,
        rounds: &views,
    });
    let mut title = title(loaded);
    if !loaded.task.surface.shape.is_plane() {
        title.insert_str(0, "unrolled surface, ");
    }
    let input = ReportInput {
        title: &title,
        task: &results.task,
        plan: &wiped,
        motion: motion.as_ref(),
        rounds: rounds.as_ref(),
        prediction,
        frames,
        bandwidth: loaded.run.plan.bandwidth,
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

/// Returns the views of the rounds for the figures.
fn views(finished: &[FinishedRound]) -> Vec<RoundView<'_>> {
    (finished.iter())
        .map(|finished| {
            let FinishedRound { round, truth, .. } = finished;
            let known = truth.as_ref();
            RoundView {
                number: round.motion.number,
                plan: Some(&round.motion.plan),
                believed: &round.motion.task.particles,
                predicted: round.motion.prediction.performance.ratio(),
                interpretation: &round.interpretation,
                truth: known.and_then(|known| known.particles.as_ref().zip(known.performance)),
                pushes: known.map_or(&[], |known| &known.pushes),
            }
        })
        .collect()
}

fn write_report(
    folder: &OutputFolder,
    loaded: &LoadedTask,
    results: &RunResults,
) -> Result<(), RecordError> {
    let text = std::str::from_utf8(&results.recording).map_err(internal)?;
    folder.write(RECORDING_FILE, &results.packed)?;
    folder.write(REPORT_FILE, report_page(&title(loaded), text))?;
    Ok(())
}

/// Returns the facts of the report. The plan, its prediction and its motion are those of the first round.
pub(crate) fn facts_of(loaded: &LoadedTask, results: &RunResults) -> Vec<RunFact> {
    let Some((prediction, _)) = &results.predicted else {
        return Vec::new();
    };
    let following = results.following.as_ref();
    let wiped = results.executable_plan();
    let distance = match following {
        Some(following) => following.total.distance,
        None => [wiped.contact_distance(), wiped.total_distance()],
    };
    let mut facts = find_facts(loaded, &wiped, prediction, distance);
    facts.extend(following.iter().flat_map(|following| following.facts()));
    facts
}

pub(crate) fn title(loaded: &LoadedTask) -> String {
    let task = &loaded.task;
    format!(
        "{}: {} {} with {} on {}",
        task.name, task.action, task.medium, task.tool.name, task.surface.name
    )
}

/// Returns the facts about the task, the plan and its prediction.
///
/// `distance`: path length of the tool in contact and in total, over all rounds [m].
fn find_facts(
    loaded: &LoadedTask,
    plan: &Plan,
    prediction: &Prediction,
    distance: [f64; 2],
) -> Vec<RunFact> {
    let tally = prediction.particles.tally();
    let performance = &prediction.performance;
    let first = [
        ("Predicted performance", percent(performance.ratio())),
        ("Particles", tally.initial.to_string()),
        ("On the surface", tally.remaining.to_string()),
        ("Absorbed", tally.absorbed.to_string()),
        ("Off the surface", tally.off_surface.to_string()),
        ("Lost over another edge", performance.lost.to_string()),
        ("Out of reach", percent(plan.unreachable_share)),
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
    ];
    let longest = (plan.graph.max_edge_length)
        .map(|longest| ("Maximum edge length", format!("{longest:.3} m")));
    let whole = [
        ("Target performance", percent(loaded.run.target)),
        ("Distance in contact", format!("{:.2} m", distance[0])),
        ("Distance in total", format!("{:.2} m", distance[1])),
        ("Strategy", loaded.run.plan.strategy.to_string()),
        ("Seed", loaded.run.plan.seed.to_string()),
    ];
    let derived = loaded.derived.iter().flat_map(|derived| {
        [
            ("Goal", derived.goal.clone()),
            ("Steps", derived.steps.join(" ")),
        ]
    });
    let first = first.into_iter().chain(longest);
    let first = first.map(|(label, value)| (label.to_owned(), value, Some(1)));
    let whole = whole.into_iter().chain(derived);
    first
        .chain(whole.map(|(label, value)| (label.to_owned(), value, None)))
        .collect()
}
