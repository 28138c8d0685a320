//! SQL over the episodes of many robots, and transfer of episodes between their memories and a shared store.
//!
//! Rows of [`tables`] are in Parquet files. A [`store`] holds the files, with a log that states which files are valid.
//! [`moves`] copies episodes in and out and maintains the files. [`ask`] runs SQL over one or many stores; with the
//! feature `cluster`, also on a scheduler and executors.

pub mod ask;
#[cfg(feature = "cluster")]
pub mod cluster;
pub mod moves;
pub mod store;
pub mod tables;
