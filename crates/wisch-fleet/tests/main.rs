//! Tests of the fleet with memories of synthetic episodes.

#[cfg(feature = "cluster")]
mod cluster;
mod documentation;
mod health;
mod memories;
mod moves;
#[cfg(feature = "cluster")]
mod processes;
mod program;
mod queries;
#[path = "../../wisch-memory/examples/synthetic/records.rs"]
#[allow(dead_code)]
mod records;
mod s3_server;
mod upkeep;
