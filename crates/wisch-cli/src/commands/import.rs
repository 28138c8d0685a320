//! `wisch memory import`: a log of some robot as an episode.

use super::episode::{PROGRAM, attach_task, begin, cannot_keep};
use super::interpret::{goal, interpreted, read_log, task_args};
use super::prepare::Prepared;
use super::words::{counted, internal, json, percent};
use crate::args::{GlobalArgs, ImportArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print};
use wisch::follow::Phase;
use wisch_io::PARTICLES_ESTIMATED_FILE;
use wisch_memory::{
    EpisodeHeader, EpisodeWriter, Mark, Memory, MemoryError, RoundObservations, TelemetryHead,
    remember_log,
};
use wisch_telemetry::Log;

/// Columns of a log's telemetry.
const COLUMNS: [&str; 10] = [
    "measured/x",
    "measured/y",
    "measured/z",
    "measured/qx",
    "measured/qy",
    "measured/qz",
    "measured/qw",
    "external/fx",
    "external/fy",
    "external/fz",
];
const NANOSECONDS_PER_SECOND: f64 = 1e9;

/// Reads and interprets the log, and keeps it.
pub fn import(args: &ImportArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let source = &args.source;
    let task_args = task_args(source);
    let mut prepared = Prepared::read(&task_args)?;
    let goal = goal(source, &task_args, &mut prepared)?;
    progress.say("reading the log");
    let log = read_log(source, &prepared)?;
    let samples = counted(log.samples.len(), "sample");
    progress.say(format!("interpreting {samples}"));
    let interpretation = interpreted(source, &prepared, &log, &goal)?;

    progress.say("keeping the episode");
    let start = (args.start_s).unwrap_or(log.start as f64 / NANOSECONDS_PER_SECOND);
    let memory = Memory::create(&args.memory.memory).map_err(|error| cannot_keep(&error))?;
    let writer = begin(&memory, start).map_err(|error| cannot_keep(&error))?;
    write_telemetry(&writer, &log).map_err(|error| cannot_keep(&error))?;
    let believed = prepared.task.surface.world_from_surface;
    let seen = RoundObservations {
        round: log.round,
        world_from_surface: log.world_from_surface.unwrap_or(believed),
        observations: log.observations.clone(),
    };
    (writer.observations(1, &seen)).map_err(|error| cannot_keep(&error))?;
    let attach = |name: &str, contents: &[u8]| {
        let attached = writer.attach(name, contents);
        attached.map_err(|error| cannot_keep(&error))
    };
    attach_task(&task_args, &prepared, &attach)?;
    let estimated = (interpretation.belief.sample(prepared.task.seed)).map_err(internal)?;
    let name = format!("round-1/{PARTICLES_ESTIMATED_FILE}");
    attach(&name, wisch_io::particles_to_csv(&estimated).as_bytes())?;
    let header = EpisodeHeader {
        id: writer.id().to_owned(),
        start,
        target: prepared.file.target_performance(),
        seed: prepared.config.seed,
        program: PROGRAM.to_owned(),
    };
    let duration = log.samples.last().map_or(0.0, |sample| sample.time);
    let name = source.log.file_name().unwrap_or(source.log.as_os_str());
    let name = name.to_string_lossy();
    let record = remember_log(
        &header,
        &name,
        duration,
        &prepared.task,
        &goal,
        &interpretation,
    );
    (writer.commit(&record)).map_err(|error| cannot_keep(&error))?;
    drop(progress);

    let place = args.memory.memory.join(&record.id);
    if args.json {
        print(&json(&record)?)?;
    } else if !global.quiet {
        print(&format!(
            "{}: {samples} in {duration:.1} s, performance {} estimated\n  episode  {}\n",
            record.task,
            percent(interpretation.performance.mean),
            place.display()
        ))?;
    }
    Ok(Outcome::Done)
}

fn write_telemetry(writer: &EpisodeWriter, log: &Log) -> Result<(), MemoryError> {
    let columns = COLUMNS.map(str::to_owned);
    let mut telemetry = writer.telemetry_with_columns(1, TelemetryHead::default(), &columns)?;
    // Of a log nobody knows what the robot was about.
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for sample in &log.samples {
        let p = sample.world_from_tool.translation.vector;
        let q = sample.world_from_tool.rotation.coords;
        let f = sample.force;
        let row = [p.x, p.y, p.z, q.x, q.y, q.z, q.w, f.x, f.y, f.z];
        telemetry.push(sample.time, mark, row)?;
    }
    Ok(telemetry.finish()?)
}
