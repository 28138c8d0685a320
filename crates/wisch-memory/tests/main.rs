//! Tests of the memory, one module per part.

mod frames;
mod store;
mod telemetry;
mod view;
