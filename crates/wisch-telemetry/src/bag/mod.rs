//! ROS 2 bags: MCAP files with CDR messages.

mod clocks;
mod container;
mod joint_states;
mod links;
mod locator;
mod observation;
mod reader;
mod samples;
mod scene;
mod search;
mod status;
mod topic;
mod unpack;
mod writer;

pub use links::BagRobot;
pub use observation::ObservationTime;
pub(crate) use reader::BagReader;
pub use samples::read_samples;
pub use scene::BagScene;
pub(crate) use topic::{FRAME_SURFACE, FRAME_WORLD};
pub use writer::{BagHead, BagWriter, active_path};
