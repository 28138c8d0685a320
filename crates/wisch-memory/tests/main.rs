//! Tests of the memory, one module per part.

mod frames;
mod health;
mod rates;
mod store;
mod telemetry;
mod view;
mod warnings;
