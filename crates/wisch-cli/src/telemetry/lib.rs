//! Telemetry files: ROS 2 bags (MCAP) that Foxglove, rosbag2 and Rerun open, written while a robot wipes; and
//! logs of whatever robot, read as what the interpretation takes.
//!
//! A bag that is written goes from `writer` through `messages` (as CDR lays them out) and `definitions` (their
//! schemas). One that is read goes through `container` (records, packed or not), `bag` (topics), `schema` and `walk` (messages of any type),
//! `source` (where in them a pose or force stands), `track` (pairing in time) and `log` (frames, signs, units);
//! a table joins at `track`.

mod bag;
mod container;
mod definitions;
mod error;
mod log;
mod messages;
mod quantity;
mod schema;
mod source;
mod table;
mod topic;
mod track;
mod unpack;
mod walk;
mod writer;

pub use error::{ReadError, ReadFault, WriteError};
pub use log::{Axes, AxesChoice, AxesSource, Log, LogOptions, TopicChoice, WrenchSign, read};
pub use quantity::QuantityError;
pub use schema::SchemaError;
pub use walk::MessageError;
pub use writer::{BagHead, BagWriter};

use std::path::{Path, PathBuf};

/// Frame of the world.
const FRAME_WORLD: &str = "world";
/// Frame of the tool, its tool centre point at the origin.
const FRAME_TOOL: &str = "tool";
/// Frame of the target surface.
const SURFACE_FRAME: &str = "surface";

/// Key of a channel's metadata that says what the channel is to the interpretation.
const ROLE_KEY: &str = "wisch.role";
/// The channel says where the tool is.
const ROLE_POSE: &str = "tool pose";
/// The channel says what the tool feels.
const ROLE_WRENCH: &str = "external wrench";
/// Key of a channel's metadata that says the log's time when the samples' time is 0 [ns].
const START_KEY: &str = "wisch.start_ns";
/// Key of a channel's metadata that says in whose axes a wrench is given.
const AXES_KEY: &str = "wisch.axes";

/// The name of a bag that is being written.
pub fn active_path(bag: &Path) -> PathBuf {
    let mut name = bag.as_os_str().to_owned();
    name.push(".active");
    PathBuf::from(name)
}
