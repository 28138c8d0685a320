//! Executes the motions of wisch on robots that speak ROS 2, and stands in for such a robot.
//!
//! The program `wisch-ros2` is an executor of `docs/executor-protocol.md`. It speaks DDS itself, so no ROS 2 is installed on
//! this computer. `wisch run --on` and the `wisch robot` commands start it.

pub mod args;
mod commissioning;
mod connection;
mod controllers;
mod doctor;
mod drive;
mod fake;
mod frames;
mod goals;
mod guard;
mod jumps;
mod link;
mod messages;
mod motion;
mod pace;
mod ping;
mod protocol;
mod push_test;
mod readings;
mod robot_file;
mod service;
mod wrench_quality;

pub use args::{ProgramLine, run};
