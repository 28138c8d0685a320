//! Telemetry files: ROS 2 bags (MCAP) of an execution, and logs of other robots as input for the interpreter. Foxglove,
//! rosbag2 and Rerun open the bags.
//!
//! [`BagWriter`] writes a bag sample by sample. [`read`] reads a bag, a folder with the parts of a bag, or a table:
//! text with a line of names, Parquet, Arrow or npz. [`LogOptions`] state the topics, axes and units of a log.
//!
//! The writer is `bag::writer`. It uses `ros2::messages` (CDR layout) and `ros2::definitions` (schemas); `bag::links`
//! (a robot's frames) and `bag::scene` (markers) add what a viewer shows.
//!
//! The reader of a bag goes through these modules, in this order:
//! - `bag::container`: records, packed or not,
//! - `bag::reader`: topics,
//! - `ros2::schema` and `ros2::walk`: messages of any type,
//! - `bag::locator`: the fields of a message that hold a pose or a force,
//! - `track`: pairing of poses and forces in time,
//! - `frames`: transforms,
//! - `correction`: bias, scale and payload of a force sensor,
//! - `log`: frames, signs and units.
//!
//! A table enters at `track`. [`read_samples`] needs none of these: it reads what [`BagWriter`] wrote.

mod bag;
mod correction;
mod error;
mod frames;
mod frozen;
mod log;
mod log_files;
mod options;
mod plausibility;
mod quantity;
mod ros2;
mod saturated;
mod spikes;
mod table;
mod tool_frame;
mod track;

pub use bag::{BagHead, BagRobot, BagScene, BagWriter, ObservationTime, active_path, read_samples};
pub use error::{ReadError, ReadFault, RecordingKind, WriteError};
pub use log::{AxesSource, Log, Skipped, read};
pub use log_files::is_bag;
pub use options::{
    Axes, AxesChoice, Clock, LogOptions, OrientationForm, Payload, TopicChoice, WrenchSign,
};
pub use quantity::QuantityError;
pub use ros2::{MessageError, SchemaError};
pub use table::catches_panics;
