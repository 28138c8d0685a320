//! Columns of all tables. A test compares docs/fleet.md with them, and `wisch-fleet columns` prints them.

use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use std::sync::Arc;

/// Type of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// A text.
    Text,
    /// A number of double precision.
    Number,
    /// A number of single precision, as in telemetry.
    Single,
    /// A whole number of 32 bits.
    Whole,
    /// A whole number of 64 bits.
    Long,
    /// Yes or no.
    Truth,
    /// A day (UTC).
    Day,
}

impl ColumnKind {
    /// Its name in SQL.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Number => "double",
            Self::Single => "float",
            Self::Whole => "int",
            Self::Long => "bigint",
            Self::Truth => "boolean",
            Self::Day => "date",
        }
    }

    /// Its Arrow type in files.
    pub const fn data_type(self) -> DataType {
        match self {
            Self::Text => DataType::Utf8,
            Self::Number => DataType::Float64,
            Self::Single => DataType::Float32,
            Self::Whole => DataType::Int32,
            Self::Long => DataType::Int64,
            Self::Truth => DataType::Boolean,
            Self::Day => DataType::Date32,
        }
    }
}

/// A column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Its name, with the unit where it has one.
    pub name: &'static str,
    /// Type of its values.
    pub kind: ColumnKind,
    /// Its unit; `–` where there is none.
    pub unit: &'static str,
    /// Its meaning, and its frame.
    pub about: &'static str,
}

/// A table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Table {
    /// Its name.
    pub name: &'static str,
    /// Meaning of a row.
    pub about: &'static str,
    /// Its columns, in the order of the files.
    pub columns: &'static [Column],
}

impl Table {
    /// Returns its schema in files. Every column may be null, because older files lack newer columns.
    pub fn schema(&self) -> SchemaRef {
        let fields = self.columns.iter();
        let fields = fields.map(|column| Field::new(column.name, column.kind.data_type(), true));
        Arc::new(Schema::new(fields.collect::<Vec<_>>()))
    }

    /// Returns the index of a column.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }
}

/// Returns the table with this name.
pub fn table(name: &str) -> Option<&'static Table> {
    TABLES.iter().find(|table| table.name == name)
}

pub(super) const fn column(
    name: &'static str,
    kind: ColumnKind,
    unit: &'static str,
    about: &'static str,
) -> Column {
    Column {
        name,
        kind,
        unit,
        about,
    }
}

pub(super) const ROBOT: Column = column(
    "robot",
    ColumnKind::Text,
    "–",
    "name of the robot; `unknown` for logs that do not state it",
);
const DAY: Column = column(
    "day",
    ColumnKind::Day,
    "–",
    "day on which the episode began, UTC",
);
const EPISODE: Column = column("episode", ColumnKind::Text, "–", "name of the episode");
const ROUND: Column = column(
    "round",
    ColumnKind::Whole,
    "–",
    "number of the round, from 1",
);
const PLACE: Column = column(
    "place",
    ColumnKind::Whole,
    "–",
    "index in the episode's graph; its name in `wisch ask` is `CLASS_EPISODE-INDEX`",
);
const CLASS: Column = column(
    "class",
    ColumnKind::Text,
    "–",
    "class in the ontology, without prefix",
);
const START: Column = column("start_s", ColumnKind::Number, "s", "start, since 1970 UTC");
const END: Column = column("end_s", ColumnKind::Number, "s", "end, since 1970 UTC");
pub(super) const TOOL: Column = column("tool", ColumnKind::Text, "–", "tool that was used");
pub(super) const MEDIUM: Column = column(
    "medium",
    ColumnKind::Text,
    "–",
    "medium to be removed or dispensed",
);
pub(super) const SURFACE: Column =
    column("surface", ColumnKind::Text, "–", "surface that was wiped");
const PREDICTED: Column = column(
    "predicted_performance",
    ColumnKind::Number,
    "1",
    "performance that the plan predicted, 0 to 1",
);
const PERFORMANCE: Column = column(
    "performance",
    ColumnKind::Number,
    "1",
    "estimated performance, 0 to 1; null if it is unknown, or only known from below",
);
const PERFORMANCE_LOW: Column = column(
    "performance_low",
    ColumnKind::Number,
    "1",
    "lower end of the estimate's interval",
);
const PERFORMANCE_HIGH: Column = column(
    "performance_high",
    ColumnKind::Number,
    "1",
    "upper end of the estimate's interval",
);
const TRUE_PERFORMANCE: Column = column(
    "true_performance",
    ColumnKind::Number,
    "1",
    "performance by the ground truth of a simulation; null for a real robot",
);
const SUCCEEDED: Column = column(
    "succeeded",
    ColumnKind::Truth,
    "–",
    "whether the goal counted as met",
);
const fn contact_share(about: &'static str) -> Column {
    column("contact_share", ColumnKind::Number, "1", about)
}
const MEAN_FORCE: Column = column(
    "mean_normal_force_n",
    ColumnKind::Number,
    "N",
    "mean force along the outward normal of the surface during contact, weighted by time; negative where the tool presses",
);
pub(super) const PRESS_FORCE: Column = column(
    "press_force_n",
    ColumnKind::Number,
    "N",
    "force with which the tool was to press",
);
const PEAK_FORCE: Column = column(
    "peak_force_n",
    ColumnKind::Number,
    "N",
    "largest norm of the external force on the tool",
);

/// Stored tables. Columns are added at the end only; the meaning of a column changes only with a new major version.
pub const TABLES: [Table; 7] = [
    Table {
        name: "episodes",
        about: "one row per episode, which is one task from its first round to its last",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            START,
            END,
            column("task", ColumnKind::Text, "–", "name of the task"),
            column(
                "origin",
                ColumnKind::Text,
                "–",
                "`simulated`, `executor`, or the name of the imported log",
            ),
            column(
                "program",
                ColumnKind::Text,
                "–",
                "program and version that wrote it",
            ),
            column("seed", ColumnKind::Long, "–", "seed of the run"),
            column(
                "action",
                ColumnKind::Text,
                "–",
                "class of the task, such as `Absorbing`",
            ),
            TOOL,
            MEDIUM,
            SURFACE,
            column(
                "strategy",
                ColumnKind::Text,
                "–",
                "coverage strategy of the first plan",
            ),
            column("goal", ColumnKind::Text, "–", "the goal in PDDL"),
            column(
                "target",
                ColumnKind::Number,
                "1",
                "performance at which the goal counted as met",
            ),
            column("rounds", ColumnKind::Whole, "–", "number of rounds"),
            column(
                "collisions",
                ColumnKind::Whole,
                "–",
                "number of collisions with a human",
            ),
            PREDICTED,
            PERFORMANCE,
            PERFORMANCE_LOW,
            PERFORMANCE_HIGH,
            TRUE_PERFORMANCE,
            SUCCEEDED,
            column(
                "identity",
                ColumnKind::Text,
                "–",
                "SHA-256 of the episode's `checksums.json`",
            ),
            column(
                "archive_sha256",
                ColumnKind::Text,
                "–",
                "SHA-256 of the archive; null for a local memory",
            ),
            column(
                "archive_bytes",
                ColumnKind::Long,
                "byte",
                "length of the archive",
            ),
            column(
                "telemetry_sha256",
                ColumnKind::Text,
                "–",
                "SHA-256 of the archive of its telemetry, if it has any",
            ),
            column(
                "telemetry_bytes",
                ColumnKind::Long,
                "byte",
                "length of that archive",
            ),
        ],
    },
    Table {
        name: "rounds",
        about: "one row per round, which is planned, executed and interpreted",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            ROUND,
            PLACE,
            START,
            END,
            TOOL,
            MEDIUM,
            SURFACE,
            column(
                "strokes",
                ColumnKind::Whole,
                "–",
                "number of planned strokes",
            ),
            PREDICTED,
            PERFORMANCE,
            PERFORMANCE_LOW,
            PERFORMANCE_HIGH,
            TRUE_PERFORMANCE,
            contact_share("time in contact over the time on or near the surface"),
            MEAN_FORCE,
            column(
                "force_bias_n",
                ColumnKind::Number,
                "N",
                "estimated bias of the sensor's normal force",
            ),
            column(
                "plane_tilt_rad",
                ColumnKind::Number,
                "rad",
                "angle between the estimated and the believed surface plane",
            ),
            column(
                "plane_offset_m",
                ColumnKind::Number,
                "m",
                "height of the estimated plane above the believed one, along its normal",
            ),
            column(
                "verdict",
                ColumnKind::Text,
                "–",
                "verdict on the round, such as `goal met`",
            ),
            column(
                "diagnosis",
                ColumnKind::Text,
                "–",
                "result of the localisation by touch, such as `localized`",
            ),
            column("ending", ColumnKind::Text, "–", "how its execution ended"),
            SUCCEEDED,
            PRESS_FORCE,
            column(
                "tool_stiffness_n_per_m",
                ColumnKind::Number,
                "N/m",
                "estimated stiffness of the tool",
            ),
        ],
    },
    Table {
        name: "strokes",
        about: "one row per stroke of the tool along the surface",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            ROUND,
            PLACE,
            column(
                "stroke",
                ColumnKind::Whole,
                "–",
                "number of the stroke in its round, from 0",
            ),
            START,
            END,
            TOOL,
            SURFACE,
            contact_share("share of the stroke's duration in contact"),
            MEAN_FORCE,
            PEAK_FORCE,
        ],
    },
    Table {
        name: "motions",
        about: "one row per motion of a round: a stroke, or a motion between strokes",
        columns: &[ROBOT, DAY, EPISODE, ROUND, PLACE, CLASS, START, END],
    },
    Table {
        name: "events",
        about: "one row per detected event, such as contact, contact loss, collision or overload",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            ROUND,
            PLACE,
            CLASS,
            START,
            END,
            column(
                "during",
                ColumnKind::Whole,
                "–",
                "index of the motion during which it occurred; null between motions",
            ),
            column(
                "during_class",
                ColumnKind::Text,
                "–",
                "class of that motion",
            ),
            TOOL,
            column("samples", ColumnKind::Whole, "–", "number of samples"),
            MEAN_FORCE,
            PEAK_FORCE,
            column(
                "peak_height_m",
                ColumnKind::Number,
                "m",
                "largest distance of the tool from the fitted plane of the surface",
            ),
            column(
                "edge_distance_m",
                ColumnKind::Number,
                "m",
                "distance from the surface's edge at its start",
            ),
            column(
                "channel",
                ColumnKind::Text,
                "–",
                "of a memory warning: quantity that deviates, such as `contact force`; null for other events",
            ),
            column(
                "value",
                ColumnKind::Number,
                "N, m or 1",
                "of a memory warning: value of the channel",
            ),
            column(
                "band_low",
                ColumnKind::Number,
                "N, m or 1",
                "lower end of the band that earlier episodes predict",
            ),
            column(
                "band_high",
                ColumnKind::Number,
                "N, m or 1",
                "upper end of that band",
            ),
            column(
                "p_value",
                ColumnKind::Number,
                "1",
                "share of episodes, this one included, that deviate at least as much",
            ),
            column(
                "alike_episodes",
                ColumnKind::Text,
                "–",
                "names of the most similar earlier episodes, separated by spaces",
            ),
        ],
    },
    Table {
        name: "participants",
        about: "one row per participant of an action, a round or an event",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            PLACE,
            CLASS,
            column(
                "role",
                ColumnKind::Text,
                "–",
                "relation in the ontology, such as `usesTool`",
            ),
            column(
                "participant",
                ColumnKind::Text,
                "–",
                "name of the participant, without prefix",
            ),
        ],
    },
    Table {
        name: "telemetry",
        about: "one row per sample of a round; joints are only in the episode",
        columns: &[
            ROBOT,
            DAY,
            EPISODE,
            ROUND,
            column("time_s", ColumnKind::Number, "s", "time since 1970 UTC"),
            column(
                "round_time_s",
                ColumnKind::Number,
                "s",
                "time since the round began",
            ),
            column("motion", ColumnKind::Whole, "–", "number of the motion"),
            column(
                "stroke",
                ColumnKind::Whole,
                "–",
                "number of the stroke, or −1",
            ),
            column(
                "phase",
                ColumnKind::Text,
                "–",
                "phase of the motion, such as `wipe`",
            ),
            column(
                "commanded_x_m",
                ColumnKind::Single,
                "m",
                "commanded position of the tool, in the world",
            ),
            column("commanded_y_m", ColumnKind::Single, "m", "likewise"),
            column("commanded_z_m", ColumnKind::Single, "m", "likewise"),
            column(
                "measured_x_m",
                ColumnKind::Single,
                "m",
                "measured position of the tool by the joints, in the world",
            ),
            column("measured_y_m", ColumnKind::Single, "m", "likewise"),
            column("measured_z_m", ColumnKind::Single, "m", "likewise"),
            column(
                "measured_qx",
                ColumnKind::Single,
                "1",
                "measured orientation of the tool, as a quaternion x, y, z, w",
            ),
            column("measured_qy", ColumnKind::Single, "1", "likewise"),
            column("measured_qz", ColumnKind::Single, "1", "likewise"),
            column("measured_qw", ColumnKind::Single, "1", "likewise"),
            column(
                "external_fx_n",
                ColumnKind::Single,
                "N",
                "force of the surroundings on the tool, in the world's axes",
            ),
            column("external_fy_n", ColumnKind::Single, "N", "likewise"),
            column("external_fz_n", ColumnKind::Single, "N", "likewise"),
            column(
                "external_mx_nm",
                ColumnKind::Single,
                "Nm",
                "moment about the tool centre point, in the world's axes",
            ),
            column("external_my_nm", ColumnKind::Single, "Nm", "likewise"),
            column("external_mz_nm", ColumnKind::Single, "Nm", "likewise"),
        ],
    },
];
