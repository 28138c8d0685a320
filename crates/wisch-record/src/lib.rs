//! What a run of robotic wiping leaves: bags, an episode, the recording of which its page is made, and a folder with the results.
//!
//! A run tells what happens as [`RunEvent`](wisch::run::RunEvent)s. A [`RunSink`] takes them in:
//!
//! | sink | keeps | when it fails |
//! |---|---|---|
//! | [`BagSink`] | a bag of each round (MCAP), written while it is executed | the run ends in order; with an episode it goes on |
//! | [`EpisodeSink`] | an episode in a memory | that telemetry is left out, and the episode says so |
//! | [`PageSink`] | the recording of which the page is made | the run ends in order |
//! | [`EventSink`] | events as JSON lines | the run ends in order |
//! | [`StageSink`] | how long each stage took | it does not |
//! | one's own, in a [`SinkSet`] or [`RunRecord::add`] | | as its [`SinkError`] says |
//!
//! [`RunRecord`] is all of them together.

mod bag;
mod clock;
mod episode;
mod error;
mod events;
mod folder;
mod following;
mod packed;
mod page;
mod record;
mod results;
mod sink;
mod stages;
mod words;

pub use bag::{BagSink, bag_name};
pub use clock::now;
pub use episode::{EpisodeSink, EpisodeTarget, KeptEpisode, attach_task, begin_episode};
pub use error::RecordError;
pub use events::EventSink;
pub use folder::write_results;
pub use following::{Following, MotionTotal};
pub use packed::read_recording;
pub use page::PageSink;
pub use record::{KeptRun, RecordOptions, RunRecord};
pub use results::{FinishedRound, KnownTruth, RunResults};
pub use sink::{AfterFailure, RunSink, SinkError, SinkSet};
pub use stages::{RoundStages, StageSink};
