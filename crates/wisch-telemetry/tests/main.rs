//! The tests of telemetry.

mod telemetry;
