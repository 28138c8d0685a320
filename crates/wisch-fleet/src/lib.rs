//! SQL over the episodes of many robots, and the way of episodes between their memories and a shared store.
//!
//! Rows of [`tables`] stand in Parquet files, in a [`store`] whose log says which of them count; [`moves`] brings episodes in and out
//! and keeps the files in order; [`ask`] runs SQL over one or many such stores, where the feature `cluster` is on also on
//! a scheduler and executors.

pub mod ask;
#[cfg(feature = "cluster")]
pub mod cluster;
pub mod moves;
pub mod store;
pub mod tables;
