//! `wisch run`, `wisch plan`, `wisch predict` and `wisch follow`: the stages, and the folder with their results.

use super::follow::{Chosen, Following, follow_plan};
use super::prepare::Prepared;
use super::rounds::{
    Done, first_following, goal_met, input, rounds_in_words, summary as summary_of_round, views,
    wipe,
};
use super::words::{counted, percent};
use crate::args::{
    FollowArgs, GlobalArgs, LoopArgs, PredictArgs, ResultArgs, RobotArgs, RunArgs, TaskArgs,
    WipeArgs,
};
use crate::assets::read_text;
use crate::failure::Failure;
use crate::output::{
    FOLLOWING_FILE, OutputFolder, PARTICLES_AFTER_FILE, PARTICLES_BEFORE_FILE,
    PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE, PLAN_FILE, REPORT_FILE, ROUNDS_FILE,
    TCP_PATH_FILE, TRAJECTORY_JSON_FILE, TRAJECTORY_YAML_FILE,
};
use crate::progress::Progress;
use crate::records::{
    FollowedRecord, FollowingSummary, LoopSummary, PlanRecord, PredictionSummary, RobotTrajectory,
    RoundSummary, SUMMARY_SCHEMA, Summary, tcp_path_csv,
};
use crate::report::{self, Frames, ReportInput};
use crate::terminal::{Outcome, print};
use std::path::{Path, PathBuf};
use std::time::Instant;
use wisch::plan::{Plan, Prediction, plan, predict};

/// Pixels per unit of a picture's own size.
const PNG_SCALE: f32 = 2.0;

/// Longest name of a folder that is derived from a task's [characters]; file systems take 255 bytes.
const MAX_NAME_LEN: usize = 60;

/// How far to go.
#[derive(Debug, Clone, Copy)]
enum Extent<'a> {
    Plan,
    Predict,
    /// With the robot of the task, if there is one, round by round.
    Run(&'a RobotArgs, &'a LoopArgs),
    /// With the robot of the task, which has to have one.
    Follow(&'a RobotArgs),
}

/// `wisch run`: the closed loop with the task's robot; without one, plan and predict.
pub fn run(args: &WipeArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let follow = &args.follow;
    let extent = Extent::Run(&follow.robot, &args.rounds);
    work(
        &follow.task,
        &follow.results,
        follow.plan.as_deref(),
        extent,
        global,
    )
}

/// `wisch follow`: plan, follow and predict; without a robot there is nothing to do.
pub fn follow_only(args: &FollowArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    let extent = Extent::Follow(&args.robot);
    work(&args.task, &args.results, plan, extent, global)
}

/// `wisch plan`.
pub fn plan_only(args: &RunArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    work(&args.task, &args.results, None, Extent::Plan, global)
}

/// `wisch predict`: plan only where no plan is given.
pub fn predict_only(args: &PredictArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let plan = args.plan.as_deref();
    work(&args.task, &args.results, plan, Extent::Predict, global)
}

/// The outcome of the stages.
struct Results {
    plan: Plan,
    /// `None` where a plan was given.
    planning_time_s: Option<f64>,
    following: Option<Following>,
    /// Share of the particles that abandoned nodes cost.
    abandoned_share: f64,
    predicted: Option<(Prediction, Frames)>,
    /// What was executed.
    rounds: Vec<Done>,
}

fn work(
    task_args: &TaskArgs,
    results: &ResultArgs,
    plan_file: Option<&Path>,
    extent: Extent<'_>,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let mut prepared = Prepared::read(task_args)?;
    let robot = match extent {
        Extent::Plan | Extent::Predict => None,
        Extent::Run(args, _) => Chosen::new(args, &prepared)?,
        Extent::Follow(args) => Some(Chosen::new(args, &prepared)?.ok_or_else(|| {
            prepared
                .failure(task_args, "there is no robot to follow the plan")
                .with_help("add a [robot] table to the task, or name a robot with --robot")
        })?),
    };
    let given = plan_file
        .map(|path| given_plan(path, &mut prepared))
        .transpose()?;
    let out = out_folder(results, &prepared);
    // Before the long part: nobody likes to wait for "permission denied".
    let folder = OutputFolder::begin(&out)?;

    let mut episode = None;
    let results_of = match (extent, &robot) {
        (Extent::Run(_, rounds), Some(robot)) => {
            let (done, kept) = wipe(
                robot, rounds, task_args, &prepared, given, &folder, &progress,
            )?;
            episode = kept;
            progress.say("checking the motion");
            executed(done, task_args, &prepared)?
        }
        _ => stages(
            task_args,
            &prepared,
            given,
            extent,
            robot.as_ref(),
            &progress,
        )?,
    };
    progress.say("writing the results");
    write(&folder, &prepared, &results_of)?;
    folder.finish()?;
    drop(progress);

    let summary = summary(&prepared, &results_of, &out);
    if results.json {
        print(&format!(
            "{}\n",
            serde_json::to_string(&summary).map_err(internal)?
        ))?;
    } else if !global.quiet {
        print(&in_words(&summary, &results_of.rounds, &out))?;
        if let Some(place) = episode {
            print(&format!("  {:<18} {}\n", "episode", place.display()))?;
        }
    }
    Ok(match summary.prediction {
        Some(PredictionSummary {
            goal_met: false, ..
        }) => Outcome::GoalNotMet,
        _ => Outcome::Done,
    })
}

/// Plan, follow, predict what is followed.
fn stages(
    task_args: &TaskArgs,
    prepared: &Prepared,
    given: Option<Plan>,
    extent: Extent<'_>,
    robot: Option<&Chosen<'_>>,
    progress: &Progress,
) -> Result<Results, Failure> {
    let task = &prepared.task;
    let (plan, planning_time_s) = match given {
        Some(plan) => (plan, None),
        None => {
            progress.say(format!("planning ({})", prepared.strategy()));
            let start = Instant::now();
            let plan =
                plan(task, &prepared.config).map_err(|error| prepared.failure(task_args, error))?;
            (plan, Some(start.elapsed().as_secs_f64()))
        }
    };
    let following = robot
        .map(|robot| follow_plan(robot, task_args, prepared, &plan, progress))
        .transpose()?;
    let mut abandoned_share = 0.0;
    let predicted = match extent {
        Extent::Plan => None,
        Extent::Predict | Extent::Run(..) | Extent::Follow(_) => {
            let wiped = (following.as_ref()).map_or_else(|| plan.clone(), |f| f.plan(&plan));
            progress.say(format!(
                "predicting {}",
                counted(wiped.strokes.len(), "stroke")
            ));
            let mut frames = Frames::new(task, &wiped);
            let prediction = predict(task, &wiped, |p| frames.watch(p));
            if following
                .as_ref()
                .is_some_and(|f| !f.followed.abandoned.is_empty())
            {
                let hoped = predict(task, &plan, |_| ()).performance.ratio();
                abandoned_share = (hoped - prediction.performance.ratio()).max(0.0);
            }
            Some((prediction, frames))
        }
    };
    Ok(Results {
        plan,
        planning_time_s,
        following,
        abandoned_share,
        predicted,
        rounds: Vec::new(),
    })
}

/// The outcome of rounds: plan, motion and prediction are those of the first.
fn executed(
    rounds: Vec<Done>,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Result<Results, Failure> {
    let first = rounds.first().ok_or_else(|| internal("no round was run"))?;
    let following = first_following(first, task_args, prepared)?;
    let plan = first.round.motion.plan.clone();
    let task = &prepared.task;
    let wiped = following.plan(&plan);
    let mut frames = Frames::new(task, &wiped);
    let prediction = predict(task, &wiped, |p| frames.watch(p));
    let hoped = predict(task, &plan, |_| ()).performance.ratio();
    Ok(Results {
        planning_time_s: Some(first.times.planning_s),
        abandoned_share: (hoped - prediction.performance.ratio()).max(0.0),
        following: Some(following),
        predicted: Some((prediction, frames)),
        plan,
        rounds,
    })
}

fn write(folder: &OutputFolder, prepared: &Prepared, results: &Results) -> Result<(), Failure> {
    let record = PlanRecord::new(&prepared.task, &results.plan, prepared.config.seed);
    folder.write(PLAN_FILE, json(&record)?)?;
    folder.write(PARTICLES_BEFORE_FILE, prepared.task.particles.to_csv())?;
    if let Some(following) = &results.following {
        write_motion(folder, prepared, following)?;
    }
    if let Some((prediction, frames)) = &results.predicted {
        folder.write(PARTICLES_AFTER_FILE, prediction.particles.to_csv())?;
        write_report(folder, prepared, results, prediction, frames)?;
    }
    if let Some(last) = results.rounds.last() {
        let told = &last.round.interpretation;
        let estimated = told.belief.sample(prepared.task.seed).map_err(internal)?;
        folder.write(PARTICLES_ESTIMATED_FILE, estimated.to_csv())?;
        if let Some(truth) = &last.truth {
            folder.write(PARTICLES_TRUE_FILE, truth.to_csv())?;
        }
        let summaries = results.rounds.iter().map(summary_of_round);
        let rounds: Vec<_> = summaries.map(RoundSummary::without_timing).collect();
        folder.write(ROUNDS_FILE, json(&rounds)?)?;
    }
    Ok(())
}

fn write_motion(
    folder: &OutputFolder,
    prepared: &Prepared,
    following: &Following,
) -> Result<(), Failure> {
    let (followed, cell) = (&following.followed, &following.cell);
    let faults = following.audit.faults.iter().map(ToString::to_string);
    let record = FollowedRecord::new(&following.robot, followed, faults.collect());
    folder.write(FOLLOWING_FILE, json(&record)?)?;
    let trajectory = RobotTrajectory::new(followed, cell);
    let line = serde_json::to_string(&trajectory).map_err(internal)?;
    folder.write(TRAJECTORY_JSON_FILE, line + "\n")?;
    folder.write(
        TRAJECTORY_YAML_FILE,
        trajectory.to_yaml().map_err(internal)?,
    )?;
    let interaction = &prepared.task.interaction;
    folder.write(TCP_PATH_FILE, tcp_path_csv(followed, cell, interaction))
}

/// Reads a plan, and takes over what it was made with.
pub(super) fn given_plan(path: &Path, prepared: &mut Prepared) -> Result<Plan, Failure> {
    let text = read_text(path)?;
    let in_file = |error| Failure::new(format!("{}: {error}", path.display()));
    let record = PlanRecord::parse(&text).map_err(in_file)?;
    let plan = record.to_plan(&prepared.task).map_err(in_file)?;
    prepared.config.strategy = plan.strategy;
    Ok(plan)
}

fn out_folder(results: &ResultArgs, prepared: &Prepared) -> PathBuf {
    results
        .out
        .clone()
        .unwrap_or_else(|| Path::new("out").join(folder_name(&prepared.task.name)))
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

fn write_report(
    folder: &OutputFolder,
    prepared: &Prepared,
    results: &Results,
    prediction: &Prediction,
    frames: &Frames,
) -> Result<(), Failure> {
    let title = title(prepared);
    let following = results.following.as_ref();
    let wiped = following.map_or_else(|| results.plan.clone(), |f| f.plan(&results.plan));
    let mut facts = facts(prepared, &wiped, prediction);
    facts.extend(
        following
            .iter()
            .flat_map(|f| f.facts(results.abandoned_share)),
    );
    let shown = following.map(|following| (following, following.shown(frames)));
    let motion = (shown.as_ref()).map(|(following, shown)| shown.input(following, &prepared.task));
    let views = views(&results.rounds);
    let rounds = input(&results.rounds, &views, prepared);
    let input = ReportInput {
        title: &title,
        task: &prepared.task,
        plan: &wiped,
        motion: motion.as_ref(),
        rounds: rounds.as_ref(),
        prediction,
        frames,
        bandwidth: prepared.config.bandwidth,
        facts: &facts,
    };
    for (name, svg) in report::pictures(&input) {
        folder.write(&format!("{name}.svg"), &svg)?;
        let png = report::rasterize(&svg, PNG_SCALE).map_err(internal)?;
        folder.write(&format!("{name}.png"), png)?;
    }
    folder.write(REPORT_FILE, report::page(&input))
}

fn title(prepared: &Prepared) -> String {
    let task = &prepared.task;
    format!(
        "{}: {} {} with {} on {}",
        task.name, task.action, task.medium, task.tool.name, task.surface.name
    )
}

/// What the report says beside its numbers.
fn facts(prepared: &Prepared, plan: &Plan, prediction: &Prediction) -> Vec<(String, String)> {
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
        (
            "Distance in contact",
            format!("{:.2} m", plan.contact_distance()),
        ),
        ("Distance in all", format!("{:.2} m", plan.total_distance())),
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

fn summary(prepared: &Prepared, results: &Results, out: &Path) -> Summary {
    let task = &prepared.task;
    let plan = &results.plan;
    let prediction = results.predicted.as_ref().map(|(prediction, _)| prediction);
    let target_performance = prepared.file.target_performance();
    Summary {
        schema: SUMMARY_SCHEMA,
        task: task.name.clone(),
        action: task.action.to_string(),
        surface: task.surface.name.clone(),
        tool: task.tool.name.clone(),
        medium: task.medium.clone(),
        strategy: prepared.strategy().to_string(),
        seed: prepared.config.seed,
        particles: task.particles.len(),
        nodes: plan.graph.nodes.len(),
        edges: plan.graph.edges.len(),
        strokes: plan.strokes.len(),
        unreachable_share: plan.unreachable_share,
        distance_in_contact_m: plan.contact_distance(),
        distance_total_m: plan.total_distance(),
        planning_time_s: results.planning_time_s,
        following: (results.following.as_ref())
            .map(|following| following.summary(results.abandoned_share)),
        prediction: prediction.map(|prediction| {
            let performance = prediction.performance;
            let predicted_performance = performance.ratio();
            PredictionSummary {
                predicted_performance,
                target_performance,
                goal_met: match results.rounds.is_empty() {
                    true => predicted_performance >= target_performance,
                    false => goal_met(&results.rounds),
                },
                lost_share: performance.lost as f64 / performance.initial.max(1) as f64,
            }
        }),
        execution: LoopSummary::new(results.rounds.iter().map(summary_of_round).collect()),
        out: out.display().to_string(),
    }
}

/// The summary for people.
fn in_words(summary: &Summary, rounds: &[Done], out: &Path) -> String {
    let mut lines = vec![];
    if let Some(prediction) = &summary.prediction {
        let verdict = if prediction.goal_met {
            "met"
        } else {
            "not met"
        };
        let (word, performance) = match &summary.execution {
            Some(execution) => ("estimated", execution.final_estimated),
            None => ("predicted", prediction.predicted_performance),
        };
        lines.push((
            "performance",
            format!(
                "{word} {} of {} particles (target {}: {verdict})",
                percent(performance),
                summary.particles,
                percent(prediction.target_performance),
            ),
        ));
        lines.extend(rounds_in_words(rounds));
        if summary.execution.is_some() {
            let predicted = percent(prediction.predicted_performance);
            lines.push(("predicted", format!("{predicted} for the first round")));
        }
        lines.push(("lost over an edge", percent(prediction.lost_share)));
    } else {
        lines.push(("particles", summary.particles.to_string()));
    }
    lines.push(("out of reach", percent(summary.unreachable_share)));
    lines.push((
        "graph",
        format!(
            "{}, {}, {}",
            counted(summary.nodes, "node"),
            counted(summary.edges, "edge"),
            counted(summary.strokes, "stroke")
        ),
    ));
    lines.push((
        "distance",
        format!(
            "{:.2} m in contact, {:.2} m in all",
            summary.distance_in_contact_m, summary.distance_total_m
        ),
    ));
    if let Some(time) = summary.planning_time_s {
        lines.push(("planning time", format!("{time:.3} s")));
    }
    if let Some(following) = &summary.following {
        lines.extend(robot_in_words(following));
    }
    if let Some(execution) = &summary.execution {
        let factor = execution.realtime_factor;
        lines.push(("simulation", format!("{factor:.1} times real time")));
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
    text
}

/// The robot's part of the summary for people.
fn robot_in_words(following: &FollowingSummary) -> Vec<(&'static str, String)> {
    let places = match following.placements.len() {
        0 => String::new(),
        count => format!(", {}", counted(count, "placement")),
    };
    let mut lines = vec![
        (
            "robot",
            format!(
                "{}: {} abandoned{places}",
                following.robot,
                counted(following.abandoned_nodes, "node")
            ),
        ),
        (
            "execution time",
            format!(
                "{:.1} s, {:.1} s of it in contact",
                following.execution_time_s, following.contact_time_s
            ),
        ),
        (
            "motion",
            format!(
                "{:.2} mm off its line at most, {:.1} mm clear at least",
                1e3 * following.max_path_deviation_m,
                1e3 * following.min_clearance_m
            ),
        ),
        (
            "following time",
            format!("{:.3} s", following.following_time_s),
        ),
    ];
    if let Some(obstruction) = &following.first_obstruction {
        lines.push((
            "abandoned first",
            format!("{obstruction}; all of them in {FOLLOWING_FILE}"),
        ));
    }
    if following.faults > 0 {
        let faults = counted(following.faults, "fault");
        lines.push(("faults", format!("{faults}, see {FOLLOWING_FILE}")));
    }
    lines
}

pub(super) fn json(record: &impl serde::Serialize) -> Result<String, Failure> {
    let mut text = serde_json::to_string_pretty(record).map_err(internal)?;
    text.push('\n');
    Ok(text)
}

/// A failure that no input should bring about.
pub(super) fn internal(error: impl std::fmt::Display) -> Failure {
    Failure::new(format!("internal error: {error}"))
        .with_help("this is a fault of wisch, not of your files; please report it")
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
