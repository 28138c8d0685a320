//! Telemetry of a round in columns: joints, poses and wrenches of every sample, in one Parquet file.
//!
//! Telemetry stores joints, not frames: [`Frames`](crate::Frames) computes frames on demand.
//!
//! | column | unit | what |
//! |---|---|---|
//! | `time` | ns | time since the round began; always present |
//! | `motion`, `stroke` | – | number of the motion, and of its stroke or −1; always present |
//! | `phase` | – | index in [`PHASES`]; always present |
//! | `position/J`, `velocity/J`, `effort/J` | rad, m, Nm, N | of the variable `J` of the robot |
//! | `commanded/x` … `qw` | m, – | commanded pose of the tool in the world; quaternion x, y, z, w |
//! | `measured/x` … `qw` | m, – | pose of the tool from the joint positions |
//! | `controller/fx` … `mz` | N, Nm | wrench that the controller commands, in the world's axes about the tool centre point |
//! | `external/fx` … `mz` | N, Nm | wrench of the surroundings on the tool, likewise |
//! | `wrench_quality` | – | quality of that wrench, as an index in [`WrenchQuality::ALL`](wisch::interpret::WrenchQuality) |
//! | `paused` | – | 1 while the motion is paused, otherwise 0 |
//! | `stamp` | ns | absolute time of the measurement on the driver's clock, which the note `stamp_clock` names; −1 if it is not stated |
//!
//! Logs, and episodes of earlier versions, lack the last three columns.

mod cache;
mod error;
mod reader;
mod status;
mod touch;
mod writer;

pub use error::TelemetryError;
pub use reader::{Series, Telemetry};
pub use writer::{Mark, TelemetryHead, TelemetryWriter};

use crate::columns::Kind;

/// Version of the schema of telemetry files.
pub const TELEMETRY_SCHEMA: u32 = 1;

/// Meaning of the numbers in the column `phase`.
pub const PHASES: [&str; 6] = ["drive", "transfer", "lifted", "lower", "wipe", "lift"];

/// Columns that every file has, before its own ones.
const FIXED: [(&str, Kind); 4] = [
    ("time", Kind::Growing),
    ("motion", Kind::Code),
    ("stroke", Kind::Code),
    ("phase", Kind::Code),
];
/// Index of each of [`FIXED`].
const TIME: usize = 0;

/// Column of absolute stamps, the last one.
const STAMP: &str = "stamp";
/// Stands for a stamp that is not stated.
const NO_STAMP: i64 = -1;
/// Column of the quality of the external wrench.
const WRENCH_QUALITY: &str = "wrench_quality";
/// Column that is 1 during a pause.
const PAUSED: &str = "paused";
/// Note that names the clock of the stamps.
const STAMP_CLOCK_NOTE: &str = "stamp_clock";

/// Parts of a pose.
pub(crate) const POSE: [&str; 7] = ["x", "y", "z", "qx", "qy", "qz", "qw"];
/// Parts of a wrench.
const WRENCH: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];

/// Key of a file's schema version.
const SCHEMA_KEY: &str = "wisch.telemetry";
/// Key of the names of the robot's variables, as JSON.
const JOINTS_KEY: &str = "wisch.joints";
/// Prefix of a note's key.
const NOTE_PREFIX: &str = "wisch.note.";

const NANOSECONDS_PER_SECOND: f64 = 1e9;

/// Converts a stored time to seconds.
fn seconds(nanoseconds: i64) -> f64 {
    nanoseconds as f64 / NANOSECONDS_PER_SECOND
}

/// Returns the columns of a robot with these variables.
fn robot_columns(joints: &[String]) -> Vec<String> {
    let mut columns = Vec::new();
    for what in ["position", "velocity", "effort"] {
        columns.extend(joints.iter().map(|joint| format!("{what}/{joint}")));
    }
    for (what, parts) in [
        ("commanded", POSE.as_slice()),
        ("measured", &POSE),
        ("controller", &WRENCH),
        ("external", &WRENCH),
    ] {
        columns.extend(parts.iter().map(|part| format!("{what}/{part}")));
    }
    columns.extend([WRENCH_QUALITY, PAUSED].map(str::to_owned));
    columns
}
