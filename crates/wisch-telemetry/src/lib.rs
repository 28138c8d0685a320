//! Telemetry files: ROS 2 bags (MCAP) that Foxglove, rosbag2 and Rerun open, written while a robot wipes; and
//! logs of whatever robot, read as what the interpretation takes.
//!
//! [`BagWriter`] writes a bag sample by sample. [`read`] reads a bag, a folder with the parts of one, or a table
//! (text with a line of names, Parquet, Arrow or npz), and [`LogOptions`] say how it is to be understood: which topics, in whose axes, in which
//! units.
//!
//! A bag that is written goes from `bag::writer` through `ros2::messages` (as CDR lays them out) and
//! `ros2::definitions` (their schemas); what it shows beside what is measured is in `bag::links` (a robot's frames) and
//! `bag::scene` (markers). One that is read goes through `bag::container` (records, packed or not),
//! `bag::reader` (topics), `ros2::schema` and `ros2::walk` (messages of any type), `bag::locator` (where in them a
//! pose or force stands), `track` (pairing in time), `frames` (transforms), `measured` (what a sensor
//! shows besides) and `log` (frames, signs, units); a table joins at `track`.

mod bag;
mod doubtful;
mod error;
mod frames;
mod log;
mod measured;
mod options;
mod quantity;
mod ros2;
mod table;
mod tool_frame;
mod track;

pub use bag::{BagHead, BagWriter, LookTime, RobotShown, SceneShown, active_path};
pub use error::{ReadError, ReadFault, RecordingKind, WriteError};
pub use log::{AxesSource, Log, Skipped, read};
pub use options::{
    Axes, AxesChoice, Clock, LogOptions, OrientationForm, Payload, TopicChoice, WrenchSign,
};
pub use quantity::QuantityError;
pub use ros2::{MessageError, SchemaError};
pub use table::catches_panics;
