//! `wisch interpret`: estimates the dirt and the surface from a log of tool poses and forces.

use super::log_advice::log_failure;
use super::log_observation::{read_observation, unused_remark};
use super::log_report::page;
use super::out_folder::folder_name;
use super::prepare::{self, stage_failure};
use super::wipe::read_given_plan;
use super::words::{format_count, internal, json, percent};
use crate::args::{GlobalArgs, InterpretArgs, LogArgs, LoggedArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json};
use nalgebra::{Translation3, UnitQuaternion};
use std::path::{Path, PathBuf};
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{
    Belief, Diagnosis, EventKind, InterpretConfig, InterpretError, Interpretation, Interpreter,
    ObservationUpdate,
};
use wisch::represent::{Action, GoalState, ParticleDistribution, SurfaceShape};
use wisch::robot::joint_transforms;
use wisch_io::{
    INTERPRETATION_FILE, OutputFolder, PARTICLES_ESTIMATED_FILE, REPORT_FILE, Replaceable,
};
use wisch_io::{InterpretationRecord, LogRecord, particles_to_csv};
use wisch_io::{Leftover, LoadedTask};
use wisch_telemetry::{AxesChoice, AxesSource, Log, LogOptions, Payload, TopicChoice, read};

/// Largest angle of an option [rad]: a full turn, with the rounding of numbers that people type.
const MAX_ANGLE: f64 = std::f64::consts::TAU + 1e-3;

/// Reads the log, interprets it, and writes the results.
pub fn interpret(args: &InterpretArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let task_args = task_args(&args.source);
    let mut prepared = prepare::read(&task_args)?;
    let out = (args.out.clone()).unwrap_or_else(|| default_out(&prepared));
    check_log_is_kept(&args.source.log, &out)?;
    // The folder comes before the long computation, so that a missing permission is reported at once.
    let replaceable = if args.force {
        Replaceable::All
    } else {
        Replaceable::AllButRuns
    };
    let folder = OutputFolder::begin(&out, Leftover::Remove, replaceable)?;

    let goal = goal(&args.source, &task_args, &mut prepared)?;
    progress.say("reading the log");
    let log = read_log(&args.source, &prepared)?;
    let observation = args.observation.as_deref();
    let interpreted = interpret_read(&args.source, &prepared, (log, goal), observation, &progress)?;
    let record = &interpreted.record;
    let particles = interpreted.draw_estimate(&prepared)?;
    folder.write(INTERPRETATION_FILE, json(record)?)?;
    folder.write(PARTICLES_ESTIMATED_FILE, particles_to_csv(&particles))?;
    folder.write(REPORT_FILE, interpreted.page(&prepared))?;
    folder.finish()?;
    drop(progress);

    if args.json {
        print_json(record)?;
    } else if !global.quiet {
        print(&in_words(record, &out))?;
    }
    Ok(if record.goal_met {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// A log and its interpretation.
pub(super) struct Interpreted {
    /// The log.
    pub log: Log,
    /// The goal of the task.
    pub goal: GoalState,
    /// The interpretation of the log.
    pub interpretation: Interpretation,
    /// The record that is written to `interpretation.json`.
    pub record: InterpretationRecord,
}

impl Interpreted {
    /// Writes the page of the log as HTML.
    pub fn page(&self, prepared: &LoadedTask) -> String {
        let lines = summary_lines(&self.record).into_iter();
        let facts: Vec<(String, String)> = lines
            .filter(|(name, _)| !name.is_empty())
            .map(|(name, value)| (name.to_owned(), value))
            .collect();
        let notes = &self.record.log.remarks;
        page(prepared, &self.goal, &self.interpretation, &facts, notes)
    }

    /// Draws one particle distribution from the estimated belief.
    pub fn draw_estimate(&self, prepared: &LoadedTask) -> Result<ParticleDistribution, Failure> {
        let belief = &self.interpretation.belief;
        belief.sample(prepared.task.seed).map_err(internal)
    }
}

/// Interprets a log that was read. `observation`: file with an observation of the dirt after the log, if there is one.
pub(super) fn interpret_read(
    source: &LoggedArgs,
    prepared: &LoadedTask,
    (log, goal): (Log, GoalState),
    observation: Option<&Path>,
    progress: &Progress,
) -> Result<Interpreted, Failure> {
    prepare::check_mesh(log.surface_mesh.as_deref(), &prepared.task)
        .map_err(|failure| failure.within(&source.log))?;
    let seen = match observation {
        Some(file) => Some(read_observation(file, source, prepared, (&log, &goal))?),
        None => None,
    };
    progress.say(format!(
        "interpreting {}",
        format_count(log.samples.len(), "sample")
    ));
    let mut believed = prepared.belief();
    let sight = prepared.sight(prepared.file.camera.unwrap_or_default());
    let update = |observation, goal| ObservationUpdate {
        observation,
        sight,
        surface: &prepared.task.surface,
        goal,
        seed: prepared.task.seed,
    };
    if let Some(before) = seen.as_ref().and_then(|seen| seen.before.as_ref()) {
        believed = believed.observe(&update(before, &goal));
    }
    let mut interpretation = interpret_samples(source, prepared, (&log, &believed), &goal)?;
    if let Some(seen) = &seen {
        interpretation.observe(&update(&seen.after, &goal));
        (seen.doubts.iter()).for_each(|doubt| interpretation.add_doubt(*doubt));
    }
    let mut remarks = remarks(&log, prepared, &interpretation);
    match seen {
        Some(seen) => remarks.push(seen.remark),
        None => remarks.extend(unused_remark(&log, source)),
    }
    let record = InterpretationRecord::new(
        &prepared.task,
        &interpretation,
        prepared.run.target,
        log_record(&source.log, &log, remarks),
    );
    Ok(Interpreted {
        log,
        goal,
        interpretation,
        record,
    })
}

/// Makes the record of a log that was read from a file.
fn log_record(file: &Path, log: &Log, remarks: Vec<String>) -> LogRecord {
    let times = [log.samples.first(), log.samples.last()]
        .map(|sample| sample.map_or(0.0, |sample| sample.time));
    LogRecord {
        file: file.display().to_string(),
        pose: log.pose_name.clone(),
        wrench: log.wrench_name.clone(),
        wrench_frame: log.axes.as_str(),
        wrench_frame_assumed: log.axes_source == AxesSource::Assumed,
        samples: log.samples.len(),
        duration_s: times[1] - times[0],
        start_ns: log.start,
        repeated: log.repeated,
        unpaired: log.unpaired,
        unfinished: log.is_unfinished,
        skipped: log.skipped.iter().map(|skipped| skipped.count).sum(),
        gaps_s: log.gaps.clone(),
        remarks,
    }
}

/// Describes what users should know about a log: frames used, samples left out, gaps and doubts.
fn remarks(log: &Log, prepared: &LoadedTask, interpretation: &Interpretation) -> Vec<String> {
    let mut remarks = log.describe_reading();
    let name = &prepared.task.name;
    if let Some(task) = log.task.as_ref().filter(|task| *task != name) {
        remarks.push(format!("the log is of the task {task:?}, not of {name:?}"));
    }
    if let Some(logged) = log.world_from_surface {
        let apart = logged.inverse() * prepared.task.surface.world_from_surface;
        let (distance, angle) = (apart.translation.vector.norm(), apart.rotation.angle());
        // A later round of a run may plan on a surface pose that touch has corrected.
        if distance > MAX_OFFSET_M || angle > MAX_OFFSET_RAD {
            remarks.push(format!(
                "the log's surface is {distance:.3} m and {:.1}° away from the task's surface: is --task the task of this log?",
                angle.to_degrees()
            ));
        }
    }
    match &prepared.task.surface.shape {
        SurfaceShape::Plane => {}
        SurfaceShape::Cylinder { radius, .. } => remarks.push(format!(
            "the surface is a cylinder of radius {radius} m: places and maps show it unrolled"
        )),
        SurfaceShape::Cone(cone) => remarks.push(format!(
            "the surface is a cone of radius {} m and half angle {} rad: places and maps show it unrolled",
            cone.radius, cone.half_angle
        )),
        SurfaceShape::Mesh(_) => {
            remarks.push("the surface is a mesh: places and maps show it unrolled".to_owned());
        }
    }
    // Decisive doubts are shown beside the performance, unless an observation decides.
    let is_seen = interpretation.observation.is_some() && interpretation.is_conclusive();
    let assumed = (interpretation.doubts.iter()).filter(|doubt| is_seen || !doubt.is_decisive());
    remarks.extend(assumed.map(ToString::to_string));
    remarks
}

/// Limits up to which a log's surface pose counts as the task's [m] and [rad].
pub(super) const MAX_OFFSET_M: f64 = 0.05;
const MAX_OFFSET_RAD: f64 = 0.18;

/// Returns the arguments that select the task.
pub(super) fn task_args(args: &LoggedArgs) -> TaskArgs {
    TaskArgs {
        task: args.task.clone(),
        strategy: None,
        budget: None,
        action: args.action,
        seed: args.seed,
        settings: args.settings.clone(),
        knowledge: args.knowledge.clone(),
    }
}

/// Returns the goal. If the task leaves the collection area open, only the plan has it.
pub(super) fn goal(
    args: &LoggedArgs,
    task_args: &TaskArgs,
    prepared: &mut LoadedTask,
) -> Result<GoalState, Failure> {
    if let Some(path) = &args.plan {
        return Ok(read_given_plan(path, prepared)?.graph.goal);
    }
    prepared.task.goal().ok_or_else(|| {
        let problem = "the task has no collection area, so the goal is unknown";
        stage_failure(task_args, problem)
            .with_help("give the executed plan with --plan, or set collect.goal_m in the task")
    })
}

fn default_out(prepared: &LoadedTask) -> PathBuf {
    let name = folder_name(&prepared.task.name);
    Path::new("out").join(format!("{name}-interpreted"))
}

/// Refuses an output folder that contains the log, because the results would replace it.
fn check_log_is_kept(log: &Path, out: &Path) -> Result<(), Failure> {
    let (Ok(real_log), Ok(real_out)) = (log.canonicalize(), out.canonicalize()) else {
        return Ok(());
    };
    if !real_log.starts_with(&real_out) {
        return Ok(());
    }
    Err(Failure::new(format!(
        "{}: the results would replace this folder, which contains the log {}",
        out.display(),
        log.display()
    ))
    .with_help("choose another folder with --out"))
}

/// Reads the log with the options of the arguments and the task.
pub(super) fn read_log(args: &LoggedArgs, prepared: &LoadedTask) -> Result<Log, Failure> {
    let options = log_options(&args.reading, prepared)?;
    read(&args.log, &options).map_err(|error| log_failure(error, &args.log))
}

fn log_options(args: &LogArgs, prepared: &LoadedTask) -> Result<LogOptions, Failure> {
    let topic = |name: &Option<String>| match name {
        Some(name) => TopicChoice::Named(name.clone()),
        None => TopicChoice::Sole,
    };
    let joints = match &args.urdf {
        Some(path) => {
            let text = std::fs::read_to_string(path)
                .map_err(|error| Failure::new(format!("{}: {error}", path.display())))?;
            joint_transforms(&path.display().to_string(), &text).map_err(Failure::new)?
        }
        None => Vec::new(),
    };
    let turns = [
        ("--sensor-frame", args.sensor_frame.as_slice()),
        (
            "--pose-offset",
            args.pose_offset.get(3..).unwrap_or_default(),
        ),
        (
            "--world-from-log",
            args.world_from_log.get(3..).unwrap_or_default(),
        ),
    ];
    for (option, angles) in turns {
        check_radians(option, angles)?;
    }
    Ok(LogOptions {
        pose_topic: topic(&args.pose_topic),
        wrench_topic: topic(&args.wrench_topic),
        columns: args.csv_columns.clone(),
        axes: (args.wrench_frame).map_or(AxesChoice::AsLogged, AxesChoice::Given),
        sign: args.wrench_sign,
        force_bias: vector(&args.force_bias),
        force_scale: args.force_scale,
        payload: args.payload_mass.map(|mass| Payload {
            mass,
            centre: vector(&args.payload_centre).unwrap_or_else(Vector3::zeros),
        }),
        orientation: args.orientation,
        clock: args.time,
        reorder_window: args.reorder_s,
        rate: args.rate,
        force_unit: args.force_unit_n,
        length_unit: args.length_unit_m,
        time_unit: args.time_unit_s,
        logged_from_tool: pose(&args.pose_offset).unwrap_or_else(Pose::identity),
        logged_from_sensor: match args.sensor_frame[..] {
            [roll, pitch, yaw] => Some(UnitQuaternion::from_euler_angles(roll, pitch, yaw)),
            _ => None,
        },
        pose_frame: args.pose_frame.clone(),
        world_from_log: pose(&args.world_from_log),
        world_frame: args.world_frame.clone(),
        joints,
        world_from_surface: prepared.task.surface.world_from_surface,
        max_gap: args.max_gap_s,
    })
}

/// Checks that angles may be radians.
fn check_radians(option: &str, angles: &[f64]) -> Result<(), Failure> {
    let Some(angle) = angles.iter().find(|angle| angle.abs() > MAX_ANGLE) else {
        return Ok(());
    };
    let radians = angle.to_radians();
    let problem = format!("{option}: the angle {angle} is more than a full turn, 6.2832 rad");
    Err(Failure::new(problem).with_help(format!(
        "state angles in radians: {angle} degrees are {radians:.4} rad"
    )))
}

/// Returns a vector of three numbers, or `None` if there are none.
fn vector(numbers: &[f64]) -> Option<Vector3> {
    match *numbers {
        [x, y, z] => Some(Vector3::new(x, y, z)),
        _ => None,
    }
}

/// Returns a pose of six numbers (position, roll, pitch, yaw), or `None` if there are none.
fn pose(numbers: &[f64]) -> Option<Pose> {
    let [x, y, z, roll, pitch, yaw] = *numbers else {
        return None;
    };
    Some(Pose::from_parts(
        Translation3::new(x, y, z),
        UnitQuaternion::from_euler_angles(roll, pitch, yaw),
    ))
}

fn interpret_samples(
    args: &LoggedArgs,
    prepared: &LoadedTask,
    (log, believed): (&Log, &Belief),
    goal: &GoalState,
) -> Result<Interpretation, Failure> {
    let task = &prepared.task;
    let config = InterpretConfig {
        // Bags that wisch has written state the round. They hold the samples of an executor.
        has_one_clock: log.round.is_some(),
        moved_mass_kg: args.reading.payload_mass.unwrap_or(0.0),
        ..InterpretConfig::from_task(task)
    };
    let interpreted = || {
        let mut interpreter = Interpreter::new(task, &config)?;
        interpreter.skip(log.unusable);
        for sample in &log.samples {
            interpreter.push(sample)?;
        }
        for (time, world_from_tool) in &log.poses_alone {
            interpreter.note_pose(*time, world_from_tool);
        }
        interpreter.conclude(believed, goal)
    };
    interpreted().map_err(|error| {
        let option = match &error {
            InterpretError::Measurement { field, .. } if field.starts_with("position") => {
                "--length-unit-m"
            }
            InterpretError::Measurement { field, .. } if field.starts_with("force") => {
                "--force-unit-n"
            }
            _ => return Failure::new(error).within(&args.log),
        };
        // What the reader finds implausible names the likely unit.
        let remark = log.remarks.iter().find(|remark| remark.contains(option));
        let help = remark.map_or_else(|| format!("check {option}"), Clone::clone);
        Failure::new(error).within(&args.log).with_help(help)
    })
}

/// The summary for people.
fn in_words(record: &InterpretationRecord, out: &Path) -> String {
    let mut lines = summary_lines(record);
    let results = out.join(INTERPRETATION_FILE).display().to_string();
    lines.push(("results", results));
    lines.push(("report", out.join(REPORT_FILE).display().to_string()));
    let mut text = format!("{}: {}\n", record.task, record.action);
    for (name, value) in lines {
        text += &format!("  {name:<18} {value}\n");
    }
    text
}

/// The summary as lines of name and value; a line without a name continues the line before.
pub(super) fn summary_lines(record: &InterpretationRecord) -> Vec<(&'static str, String)> {
    let log = &record.log;
    let assumed = if log.wrench_frame_assumed {
        ", assumed"
    } else {
        ""
    };
    let mut lines = vec![
        (
            "log",
            format!(
                "{} in {:.1} s: {}, {} (axes of the {}{assumed})",
                format_count(log.samples, "sample"),
                log.duration_s,
                log.pose,
                log.wrench,
                log.wrench_frame
            ),
        ),
        ("performance", performance_in_words(record)),
        (
            "contact",
            match record.contact_share {
                Some(share) => format!(
                    "in contact for {} of the time on or near the surface",
                    percent(share)
                ),
                None => "unknown: the log shows no contact with this side of the surface, or the tool was never near it"
                    .to_owned(),
            },
        ),
        ("surface", surface_in_words(record)),
        ("force", force_in_words(record)),
        ("events", events_in_words(record)),
    ];
    if let Some(stiffness) = &record.tool_stiffness {
        let assumed = if stiffness.assumed {
            ", assumed as declared"
        } else {
            ""
        };
        let line = format!(
            "stiffness {:.0} N/m ± {}{assumed}",
            stiffness.n_per_m,
            percent(stiffness.ln_deviation)
        );
        lines.push(("tool", line));
    }
    if log.unfinished {
        let line = "the log is incomplete: its writer did not finish it".to_owned();
        lines.insert(1, ("", line));
    }
    for remark in log.remarks.iter().rev() {
        lines.insert(1, ("", remark.clone()));
    }
    let left_out = [
        (log.repeated, "with the time of the sample before"),
        (log.unpaired, "without a pose or force near their time"),
    ];
    let left_out: Vec<String> = (left_out.into_iter().filter(|(count, _)| *count > 0))
        .map(|(count, why)| format!("{} {why}", format_count(count, "sample")))
        .collect();
    if !left_out.is_empty() {
        lines.insert(1, ("", format!("left out: {}", left_out.join(", "))));
    }
    lines
}

/// The verdict of records if it is unknown whether the goal is met.
pub(super) const UNKNOWN: &str = "unknown";

fn performance_in_words(record: &InterpretationRecord) -> String {
    let [low, high, target] = [
        record.estimated_low,
        record.estimated_high,
        record.target_performance,
    ]
    .map(percent);
    if !record.is_conclusive {
        return format!(
            "unknown: {} (between {low} and {high}, target {target})",
            record.reason
        );
    }
    // A camera sees dirt, but neither polish nor a coat.
    let is_treated = record.action.parse::<Action>().is_ok_and(Action::treats);
    let advice = match record.verdict {
        UNKNOWN if record.detections.is_none() && !is_treated => {
            "; add a camera observation with --observation"
        }
        _ => "",
    };
    format!(
        "{} estimated, {low} to {high} with 90 % probability (target {target}: {}; {}{advice})",
        percent(record.estimated),
        record.verdict,
        record.reason,
    )
}

fn force_in_words(record: &InterpretationRecord) -> String {
    let pressed = (record.pressed_force_n)
        .map_or_else(String::new, |force| format!("pressed with {force:.1} N; "));
    match record.force_bias_n {
        Some(bias) => {
            // Without the sign of a zero.
            let bias = (100.0 * bias).round() / 100.0 + 0.0;
            format!("{pressed}bias {bias:+.2} N along the surface normal, subtracted")
        }
        None => {
            format!(
                "{pressed}bias unknown, because the log shows no calm free motion on this side of the surface: 0 N assumed"
            )
        }
    }
}

fn surface_in_words(record: &InterpretationRecord) -> String {
    let (Some(plane), Some(tilt), Some(offset)) =
        (&record.plane, record.plane_tilt_rad, record.plane_offset_m)
    else {
        if record.diagnosis == Diagnosis::Unfitted.as_str() {
            return "not found: the contacts fit this side of it at no pose that was tried; its believed pose is kept"
                .to_owned();
        }
        let advice = "check surface.position_m and --world-from-log";
        return format!("not found: no contact ({advice})");
    };
    let tilt = match plane.tilt_directions {
        0 => "tilt unknown, because all contacts are at one point".to_owned(),
        1 => format!(
            "tilted by {:.2}° along the line of the contacts, unknown across it",
            tilt.to_degrees()
        ),
        _ => format!("tilted by {:.2}°", tilt.to_degrees()),
    };
    let verdict = match record.world_from_surface {
        Some(_) => "localisation error",
        None => "at its believed pose",
    };
    let fit = record
        .registration
        .as_ref()
        .map_or_else(String::new, |fit| {
            let [x, y, z, w] = fit.believed_from_real.rotation_xyzw;
            let turned = 2.0 * x.hypot(y).hypot(z).atan2(w.abs());
            format!(
                "; fitted to the shape in {} of 6 degrees of freedom: turned by {:.2}°, {:.2} mm rms",
                fit.determined,
                turned.to_degrees(),
                1e3 * fit.rms_m
            )
        });
    format!(
        "{verdict}: {tilt}, offset {:+.1} mm ({} of {} confident contacts, {:.2} mm rms{fit})",
        1e3 * offset,
        plane.inliers,
        plane.confident,
        1e3 * plane.rms_m
    )
}

fn events_in_words(record: &InterpretationRecord) -> String {
    let kinds = EventKind::ALL.into_iter().filter(|kind| !kind.is_phase());
    let counts = kinds.map(|kind| {
        let those = (record.events.iter()).filter(|event| event.kind == kind.as_str());
        (kind.as_str().replace('_', " "), those.count())
    });
    let mut counts: Vec<String> = counts
        .filter(|(_, count)| *count > 0)
        .map(|(kind, count)| format!("{count} {kind}"))
        .collect();
    if counts.is_empty() {
        counts.push("none".to_owned());
    }
    counts.join(", ")
}
