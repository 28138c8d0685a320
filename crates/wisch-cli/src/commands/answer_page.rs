//! `wisch ask --view`: writes the answers of a query, with the recordings that they show, into one page.

use super::prepare;
use super::replaceable::begin_page;
use crate::failure::Failure;
use std::path::Path;
use wisch_io::OutputFile;
use wisch_memory::ask::Answers;
use wisch_memory::view::{View, answers_json, gather};
use wisch_memory::{Catalogue, Memory};
use wisch_record::episode_recording;
use wisch_web::answers_page;

/// Maximum size of all recordings of a page together [bytes], compressed.
const MAX_RECORDINGS: usize = 32 << 20;

/// Begins the page before the query runs, so that a missing permission is reported at once.
pub(super) fn begin(file: &Path) -> Result<OutputFile, Failure> {
    begin_page(file, "--view")
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
    let recordings = read_recordings(&mut view, memory);
    let answers = answers_json(query, answers, Ok(&view), catalogue).to_string();
    let page = answers_page(query, &answers, &recordings);
    let written = file.finish(page.as_bytes());
    written.map_err(|error| Failure::from(error).with_help(OTHER_FILE))?;
    Ok(view.remarks)
}

/// Returns name and recording of each shown episode. An episode that cannot be read, or for which the page has no space,
/// becomes a remark.
fn read_recordings(view: &mut View, memory: &Memory) -> Vec<(String, Vec<u8>)> {
    let mut recordings = Vec::new();
    let mut space = MAX_RECORDINGS;
    for shown in &view.episodes {
        let recording = memory.episode(&shown.id).map_err(Into::into);
        let recording = recording.and_then(|episode| {
            // Without its task, only the log is drawn.
            let task = prepare::load_kept(&episode, None).ok();
            episode_recording(&episode, shown, task.as_ref())
        });
        match recording {
            Ok(packed) if packed.len() <= space => {
                space -= packed.len();
                recordings.push((shown.id.clone(), packed));
            }
            Ok(packed) => view.remarks.push(format!(
                "episode {} is not drawn: its recording of {} KiB exceeds the {} KiB that are left on the page; ask for fewer episodes",
                shown.id,
                packed.len() >> 10,
                space >> 10
            )),
            Err(error) => (view.remarks).push(format!("episode {} is not drawn: {error}", shown.id)),
        }
    }
    recordings
}
