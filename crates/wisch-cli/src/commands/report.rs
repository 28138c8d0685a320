//! `wisch report`: an episode or a folder of results as one page.

use super::packed::read_packed;
use crate::args::{GlobalArgs, ReportArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use std::path::{Path, PathBuf};
use wisch_io::{OutputFile, PLAN_FILE};
use wisch_memory::{Memory, RECORDING_FILE};

/// Writes the page.
pub fn report(args: &ReportArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let (recording, name) = find(args)?;
    let text = read_packed(&recording)?;
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{name}.html")));
    let page = wisch_web::report_page(&title(&text, &name), &text);
    OutputFile::begin(&out)?.finish(page.as_bytes())?;
    if !global.quiet {
        print(&format!("{}\n", out.display()))?;
    }
    Ok(Outcome::Done)
}

/// The recording of what is asked for, and its name.
fn find(args: &ReportArgs) -> Result<(PathBuf, String), Failure> {
    let folder = Path::new(&args.what);
    let is_results = folder.join(PLAN_FILE).is_file() || folder.join(RECORDING_FILE).is_file();
    let folder = if is_results {
        folder.to_path_buf()
    } else {
        Memory::open(&args.memory.memory)
            .and_then(|memory| memory.episode(&args.what))
            .map(|_| args.memory.memory.join(&args.what))
            .map_err(|error| {
                Failure::new(error).with_help(
                    "name an episode of --memory, or a folder of results, as out/chopping-board",
                )
            })?
    };
    let recording = folder.join(RECORDING_FILE);
    if !recording.is_file() {
        return Err(Failure::new(format!(
            "{}: there is no {RECORDING_FILE} in it",
            folder.display()
        ))
        .with_help(
            "it was written before recordings were kept, or from a log: there is nothing to show",
        ));
    }
    let name = folder.file_name().and_then(|name| name.to_str());
    Ok((recording, name.unwrap_or("report").to_owned()))
}

/// What the recording calls itself.
fn title(recording: &str, otherwise: &str) -> String {
    let head = recording.lines().next().unwrap_or_default();
    let head: serde_json::Value = serde_json::from_str(head).unwrap_or_default();
    head["title"].as_str().unwrap_or(otherwise).to_owned()
}
