//! Telemetry of a round in columns: joints, poses and wrenches at every sample, in one Parquet file.
//!
//! Joints are stored, frames are not: [`Frames`](crate::Frames) computes them on demand.
//!
//! | column | unit | what |
//! |---|---|---|
//! | `time` | ns | since the round began; always there |
//! | `motion`, `stroke` | – | number of the motion, and of the stroke that it wipes or −1; always there |
//! | `phase` | – | place in [`PHASES`]; always there |
//! | `position/J`, `velocity/J`, `effort/J` | rad, m, Nm, N | of the variable `J` of the robot |
//! | `commanded/x` … `qw` | m, – | where the tool was told to be, in the world; the quaternion x, y, z, w |
//! | `measured/x` … `qw` | m, – | where the tool is by the joints' positions |
//! | `controller/fx` … `mz` | N, Nm | what the controller asks, in the world's axes about the tool centre point |
//! | `external/fx` … `mz` | N, Nm | what the surroundings do to the tool, likewise |

mod cache;
mod error;
mod reader;
mod touch;
mod writer;

pub use error::TelemetryError;
pub use reader::{Series, Telemetry};
pub use writer::{Mark, TelemetryHead, TelemetryWriter};

use crate::columns::Kind;

/// Version of the files.
pub const TELEMETRY_SCHEMA: u32 = 1;

/// What the numbers of the column `phase` mean.
pub const PHASES: [&str; 6] = ["drive", "transfer", "lifted", "lower", "wipe", "lift"];

/// Columns that every file has, before those of its own.
const FIXED: [(&str, Kind); 4] = [
    ("time", Kind::Growing),
    ("motion", Kind::Code),
    ("stroke", Kind::Code),
    ("phase", Kind::Code),
];
/// Place of each of [`FIXED`].
const TIME: usize = 0;

/// Parts of a pose.
const POSE: [&str; 7] = ["x", "y", "z", "qx", "qy", "qz", "qw"];
/// Parts of a wrench.
const WRENCH: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];

/// Key under which a file says its version.
const SCHEMA_KEY: &str = "wisch.telemetry";
/// Key under which a file says the names of the robot's variables, as JSON.
const JOINTS_KEY: &str = "wisch.joints";
/// Before the key of a note.
const NOTE_PREFIX: &str = "wisch.note.";

const NANOSECONDS_PER_SECOND: f64 = 1e9;

/// Seconds of a stored time.
fn seconds(nanoseconds: i64) -> f64 {
    nanoseconds as f64 / NANOSECONDS_PER_SECOND
}

/// The columns of a robot with these variables.
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
    columns
}
