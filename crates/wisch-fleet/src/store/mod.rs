//! Where a fleet's memory stands: objects by name, in a folder or in a bucket, and the log that says which of them count.
//!
//! ```text
//! log/00000000000000000012.json                             what commit 12 adds and removes
//! checkpoint/00000000000000000016.json                      all that the commits up to 16 come to
//! checkpoint/latest                                         where to begin; a hint
//! tables/strokes/robot=arm/day=2026-11-22/SHA256.parquet    rows
//! tables/strokes/merged/SHA256.parquet                      rows of several robots or days
//! episodes/20261122-005612-3f2a.tar.zst                     an episode whole, but its telemetry
//! episodes/20261122-005612-3f2a.telemetry.tar.zst           its telemetry
//! ```
//!
//! No object is ever overwritten but the hint. What no commit names is not there for who reads.

mod archive;
mod credentials;
mod error;
mod log;
mod place;

pub use archive::{Archive, identity_of};
pub(crate) use archive::{is_telemetry, sha256};
#[cfg(feature = "cluster")]
pub(crate) use credentials::secrets;
pub use error::FleetError;
#[cfg(feature = "cluster")]
pub(crate) use error::without_echo;
pub use log::{Commit, Committed, FileEntry, Removed, Snapshot, now};
pub use place::{Created, StorePlace};
