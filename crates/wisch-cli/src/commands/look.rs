//! `wisch ask --view`: draws the plots of a query into one page.

use super::prepare::Prepared;
use crate::args::TaskArgs;
use crate::failure::Failure;
use serde::Deserialize;
use std::path::Path;
use wisch::represent::{ScenePart, Task};
use wisch_io::OutputFile;
use wisch_memory::ask::Answers;
use wisch_memory::view::{Surroundings, gather};
use wisch_memory::{Catalogue, Episode, Memory};
use wisch_report::{AnswersInput, answers_page};

/// The options of the command line that change the task, as an episode keeps them.
#[derive(Debug, Default, Deserialize)]
struct Options {
    #[serde(default)]
    settings: Vec<(String, String)>,
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
    let view = gather(
        &answers.views,
        &answers.rows,
        memory,
        catalogue,
        &mut surroundings,
    );
    let view = view.map_err(|error| {
        Failure::new(error).with_help("wisch ask --list describes the predicates that draw")
    })?;
    let input = AnswersInput {
        query,
        answers,
        view: &view,
    };
    let page = answers_page(&input);
    let written = file.finish(page.as_bytes());
    written.map_err(|error| Failure::from(error).with_help(OTHER_FILE))?;
    Ok(view.remarks)
}

/// Returns the scene around the robot from the episode's task. If the task or one of its files is missing, the picture
/// shows no scene.
fn surroundings(episode: &Episode) -> Surroundings {
    let options = episode.attachment("options.json").ok();
    let options = options.and_then(|bytes| serde_json::from_slice::<Options>(&bytes).ok());
    let args = TaskArgs {
        task: episode.folder().join("task.toml"),
        strategy: None,
        budget: None,
        action: None,
        seed: None,
        settings: options.unwrap_or_default().settings,
        knowledge: None,
    };
    Prepared::read(&args).map_or_else(|_| Surroundings::default(), |read| around(read.loaded.task))
}

fn around(task: Task) -> Surroundings {
    let stands = |part: &ScenePart| matches!(part, ScenePart::Obstacle | ScenePart::Carrier);
    let objects = task.scene.into_iter().filter(|object| stands(&object.part));
    Surroundings {
        tool: Some(task.tool.mesh),
        outline: Some(task.surface.outline),
        objects: objects
            .map(|object| (object.world_from_object, object.mesh))
            .collect(),
    }
}
