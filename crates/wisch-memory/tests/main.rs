//! The tests of the memory, one module for each of its parts.

mod frames;
mod store;
mod telemetry;
mod view;
