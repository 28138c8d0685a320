//! The executor against the fake robot, over DDS on loopback, in real time.
//!
//! `WISCH_ROS2_FAULTS=N` injects each fault N times, at random times; the default is once. Tests run one after the other,
//! because they share the computer's time.

mod fake;
mod faults;
mod limits;
mod loop_closed;
mod pauses;
mod refusals;
