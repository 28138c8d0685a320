//! SQL on a Ballista scheduler and its executors, which are this same program.
//!
//! A statement goes to the scheduler as a logical plan in which a table is the list of its files, with their entries in
//! the log; only the client reads a log. The scheduler plans and reads nothing. Executors open the stores by their
//! URLs, with their own credentials.

mod address;
mod codec;
mod engine;
mod executor;
mod journal;
mod scheduler;
mod session;
mod stores;

pub use address::Address;
pub use executor::{ExecutorOptions, execute};
pub use scheduler::{SchedulerOptions, schedule};
pub(crate) use session::{cluster_error, on_cluster};

/// Largest message [bytes]: one message names the files of a table, with 300 bytes each.
const MESSAGE: u32 = 256 << 20;
