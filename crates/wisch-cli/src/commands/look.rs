//! `wisch ask --view`: writes the answers of a query, with the recordings that they show, into one page.

use super::prepare;
use crate::args::TaskArgs;
use crate::failure::Failure;
use serde::Deserialize;
use std::path::Path;
use wisch_io::{LoadedTask, OutputFile};
use wisch_memory::ask::Answers;
use wisch_memory::view::{View, answers_json, gather};
use wisch_memory::{Catalogue, Episode, Memory};
use wisch_record::episode_recording;
use wisch_web::answers_page;

/// Maximum size of all recordings of a page together [bytes], compressed.
const MAX_RECORDINGS: usize = 32 << 20;

/// The options of the command line that change the task, as an episode keeps them.
#[derive(Debug, Default, Deserialize)]
struct Options {
    #[serde(default)]
    settings: Vec<(String, String)>,
    strategy: Option<String>,
    seed: Option<u64>,
}

/// Begins the page before the query runs, so that a missing permission is reported at once.
pub(super) fn begin(file: &Path) -> Result<OutputFile, Failure> {
    OutputFile::begin(file).map_err(|error| Failure::from(error).with_help(OTHER_FILE))
}

const OTHER_FILE: &str = "choose another file with --view";

/// Writes the page and returns remarks on data that it does not show.
pub(super) fn draw(
    file: OutputFile,
    query: &str,
    answers: &Answers,
    memory: &Memory,
    catalogue: &Catalogue,
) -> Result<Vec<String>, Failure> {
    let view = gather(&answers.views, &answers.rows, memory, catalogue);
    let mut view = view.map_err(|error| {
        Failure::new(error).with_help("wisch ask --list describes the predicates that draw")
    })?;
    let recordings = recordings(&mut view, memory);
    let answers = answers_json(answers, Ok(&view), catalogue).to_string();
    let page = answers_page(query, &answers, &recordings);
    let written = file.finish(page.as_bytes());
    written.map_err(|error| Failure::from(error).with_help(OTHER_FILE))?;
    Ok(view.remarks)
}

/// Returns name and recording of each shown episode. An episode that cannot be read, or for which the page has no space,
/// becomes a remark.
fn recordings(view: &mut View, memory: &Memory) -> Vec<(String, Vec<u8>)> {
    let mut recordings = Vec::new();
    let mut space = MAX_RECORDINGS;
    for shown in &view.episodes {
        let recording = memory.episode(&shown.id).map_err(Into::into);
        let recording = recording.and_then(|episode| {
            let task = task_of(&episode);
            episode_recording(&episode, shown, task.as_ref())
        });
        match recording {
            Ok(packed) if packed.len() <= space => {
                space -= packed.len();
                recordings.push((shown.id.clone(), packed));
            }
            Ok(packed) => view.remarks.push(format!(
                "episode {} is not drawn: its recording of {} KiB exceeds the page's rest of {} KiB; ask for fewer episodes",
                shown.id,
                packed.len() >> 10,
                space >> 10
            )),
            Err(error) => (view.remarks).push(format!("episode {} is not drawn: {error}", shown.id)),
        }
    }
    recordings
}

/// Returns the task of an episode; `None` if it or one of its files is missing.
fn task_of(episode: &Episode) -> Option<LoadedTask> {
    // Without the settings of the run, another task would be shown. Episodes of imported logs have none.
    let options = match episode.attachment("options.json") {
        Ok(bytes) => serde_json::from_slice(&bytes).ok()?,
        Err(_) => Options::default(),
    };
    let args = TaskArgs {
        task: episode.folder().join("task.toml"),
        strategy: options.strategy.and_then(|name| name.parse().ok()),
        budget: None,
        action: None,
        seed: options.seed,
        settings: options.settings,
        knowledge: None,
    };
    prepare::load(&args).ok()
}
