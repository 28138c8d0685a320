//! Compliant execution of joint motion in a physics world; paper §4.1.

mod telemetry;

pub use telemetry::{TelemetrySample, Wrench};
