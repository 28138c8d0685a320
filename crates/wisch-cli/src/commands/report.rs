//! `wisch report`: writes an episode, a folder of results or a log as one HTML page.

use super::interpret::{goal, interpret_read, read_log, task_args};
use super::prepare;
use super::replaceable::begin_page;
use crate::args::{GlobalArgs, LoggedArgs, ReportArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use wisch_io::{INTERPRETATION_FILE, PLAN_FILE, REPORT_FILE};
use wisch_memory::{Memory, RECORDING_FILE};

/// Writes the page.
pub fn report(args: &ReportArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let source = find(args)?;
    let name = match &source {
        Source::Results(folder) => format_name(folder.file_name()),
        Source::Log(log) => format_name(log.log.file_stem()),
    };
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{name}.html")));
    let file = begin_page(&out, "--out")?;
    let page = match source {
        Source::Results(folder) => page_of(&folder)?,
        Source::Log(log) => page_of_log(&log, global)?,
    };
    file.finish(page.as_bytes())?;
    if args.json {
        print_json(&serde_json::json!({ "out": out.display().to_string() }))?;
    } else if !global.quiet {
        print(&format!("{}\n", out.display()))?;
    }
    Ok(Outcome::Done)
}

/// The source of a page.
enum Source {
    /// A folder of results, or of an episode.
    Results(PathBuf),
    /// A log with its task and format.
    Log(Box<LoggedArgs>),
}

/// Finds the source that the arguments name.
fn find(args: &ReportArgs) -> Result<Source, Failure> {
    let path = Path::new(&args.what);
    let holds = |name: &str| path.join(name).is_file();
    if [PLAN_FILE, RECORDING_FILE, INTERPRETATION_FILE]
        .into_iter()
        .any(holds)
    {
        return Ok(Source::Results(path.to_path_buf()));
    }
    if path.exists() {
        let Some(task) = &args.task else {
            return Err(Failure::new(format!(
                "{}: a log does not state the surface, so it needs a task",
                path.display()
            ))
            .with_help("name the executed task file with --task"));
        };
        return Ok(Source::Log(Box::new(LoggedArgs {
            log: path.to_path_buf(),
            task: task.clone(),
            plan: args.plan.clone(),
            action: args.action,
            seed: args.seed,
            settings: args.settings.clone(),
            knowledge: args.knowledge.clone(),
            reading: args.reading.clone(),
        })));
    }
    Memory::open(&args.memory.memory)
        .and_then(|memory| memory.episode(&args.what))
        .map(|episode| Source::Results(episode.folder().to_path_buf()))
        .map_err(|error| {
            Failure::new(error).with_help(
                "name an episode of --memory, a folder of results such as out/chopping-board, or a log with --task",
            )
        })
}

fn format_name(name: Option<&OsStr>) -> String {
    name.and_then(OsStr::to_str).unwrap_or("report").to_owned()
}

/// Returns the page with the recording of an episode or of a folder of results, and the name of that folder.
pub fn recording_page(what: &str, memory: &Path) -> Result<(String, String), Failure> {
    let path = Path::new(what);
    let folder = if path.is_dir() {
        path.to_path_buf()
    } else {
        let found = Memory::open(memory).and_then(|memory| memory.episode(what));
        let found = found.map_err(|error| {
            Failure::new(error).with_help(
                "name an episode of --memory, or a folder of results such as out/chopping-board",
            )
        })?;
        found.folder().to_path_buf()
    };
    let recording = folder.join(RECORDING_FILE);
    if !recording.is_file() {
        return Err(Failure::new(format!(
            "{}: the folder has no {RECORDING_FILE}",
            folder.display()
        ))
        .with_help("only runs with a robot have a scene that moves; wisch run writes it"));
    }
    Ok((page_of(&folder)?, format_name(folder.file_name())))
}

/// Returns the page of a folder: made from its recording, else its report.html.
fn page_of(folder: &Path) -> Result<String, Failure> {
    let recording = folder.join(RECORDING_FILE);
    if recording.is_file() {
        let text = wisch_record::read_recording(&recording)?;
        return Ok(wisch_web::report_page(
            &title(&text, &format_name(folder.file_name())),
            &text,
        ));
    }
    let page = folder.join(REPORT_FILE);
    if page.is_file() {
        return std::fs::read_to_string(&page)
            .map_err(|error| Failure::new(format!("{}: {error}", page.display())));
    }
    Err(Failure::new(format!(
        "{}: the folder has neither {RECORDING_FILE} nor {REPORT_FILE}",
        folder.display()
    ))
    .with_help(
        "wisch run and wisch interpret write them, wisch plan and wisch follow do not; make the page of a log with wisch report LOG --task FILE",
    ))
}

/// Interprets a log and returns its page, without storing the results.
fn page_of_log(source: &LoggedArgs, global: &GlobalArgs) -> Result<String, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let task_args = task_args(source);
    let mut prepared = prepare::read(&task_args)?;
    let goal = goal(source, &task_args, &mut prepared)?;
    progress.say("reading the log");
    let log = read_log(source, &prepared)?;
    let interpreted = interpret_read(source, &prepared, (log, goal), None, &progress)?;
    Ok(interpreted.page(&prepared))
}

/// Returns the title in the head of a recording, else `otherwise`.
fn title(recording: &str, otherwise: &str) -> String {
    let head = recording.lines().next().unwrap_or_default();
    let head: serde_json::Value = serde_json::from_str(head).unwrap_or_default();
    head["title"].as_str().unwrap_or(otherwise).to_owned()
}
