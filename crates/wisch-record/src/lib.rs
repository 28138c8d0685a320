//! Records of robotic wiping runs: bags, episodes, the recordings of the pages, and folders of results.
//!
//! A run reports its progress as [`RunEvent`](wisch::run::RunEvent)s. A [`RunSink`] receives them:
//!
//! | sink | output | after a failure |
//! |---|---|---|
//! | [`BagSink`] | a bag of each round (MCAP), written during execution | the run stops cleanly, or continues if it has an episode |
//! | [`EpisodeSink`] | an episode in a memory, with telemetry from the bags if there are bags | the run continues; the episode states the missing telemetry |
//! | [`PageSink`] | the recording for the page | the run stops cleanly |
//! | [`EventSink`] | events as JSON lines | the run stops cleanly |
//! | [`StageSink`] | the duration of each stage | it cannot fail |
//! | a custom sink, in a [`SinkSet`] or by [`RunRecord::add`] | | as its [`SinkError`] states |
//!
//! [`RunRecord`] combines them. A clean stop begins no further motion; the executed part is interpreted and kept.

mod bag;
mod bag_copy;
mod clock;
mod episode;
mod error;
mod events;
mod folder;
mod following;
mod logged;
mod packed;
mod page;
mod record;
mod results;
mod sink;
mod stages;
mod words;

pub use bag::{BagSink, bag_name};
pub use clock::{RunClock, unix_time};
pub use episode::{EpisodeSink, EpisodeTarget, KeptEpisode, attach_task, begin_episode};
pub use error::RecordError;
pub use events::EventSink;
pub use folder::write_results;
pub use following::{FollowedPlan, MotionTotal, NO_SHAPES, joint_movement_in_words};
pub use logged::episode_recording;
pub use packed::read_recording;
pub use page::PageSink;
pub use record::{KeptRun, RecordOptions, RunRecord};
pub use results::{FinishedRound, RoundGroundTruth, RunResults};
pub use sink::{AfterFailure, RunSink, SinkError, SinkSet};
pub use stages::StageSink;
