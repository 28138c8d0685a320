//! The same SQL on a Ballista scheduler and its executors, all of them this program.
//!
//! A statement goes to the scheduler as a logical plan in which a table is the list of its files, with what the log says of each; nobody
//! but the client reads a log. The scheduler plans and reads nothing; executors open the stores by their URLs, with credentials of their own.

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

/// A message is this long at most [bytes]: the files of a table are named in one, 300 bytes each.
const MESSAGE: u32 = 256 << 20;
