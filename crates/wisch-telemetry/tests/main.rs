//! Tests of telemetry.

mod telemetry;
