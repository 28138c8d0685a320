//! Store of a fleet: objects by name, in a folder or bucket, and the log that states which of them are valid.
//!
//! ```text
//! log/00000000000000000012.json                             additions and removals of commit 12
//! checkpoint/00000000000000000016.json                      state after all commits before 16
//! checkpoint/latest                                         number of the latest checkpoint; a hint
//! tables/strokes/robot=arm/day=2026-11-22/SHA256.parquet    rows
//! tables/strokes/merged/SHA256.parquet                      rows of several robots or days
//! episodes/20261122-005612-3f2a.tar.zst                     an episode without its telemetry
//! episodes/20261122-005612-3f2a.telemetry.tar.zst           its telemetry
//! ```
//!
//! No object is ever overwritten, except the hint. Readers ignore objects that no commit lists.

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
pub use log::{Commit, Committed, FileEntry, Removed, Snapshot, read_clock};
pub use place::{Created, StorePlace};
