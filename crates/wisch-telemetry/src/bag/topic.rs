//! Topics of the bags that this crate writes.

use crate::options::Axes;
use std::collections::BTreeMap;

/// Frame of the world.
pub(crate) const FRAME_WORLD: &str = Axes::World.as_str();
/// Frame of the tool, with its tool centre point as origin.
pub(crate) const FRAME_TOOL: &str = Axes::Tool.as_str();
/// Frame of the target surface.
pub(crate) const FRAME_SURFACE: &str = Axes::Surface.as_str();

/// Topics of the observed dirt before and after a round, and of the area that the camera could not see.
pub(crate) const DIRT: [&str; 2] = ["/wisch/dirt_before", "/wisch/dirt_after"];
pub(crate) const HIDDEN: [&str; 2] = ["/wisch/hidden_before", "/wisch/hidden_after"];

/// Name of the metadata record of a whole bag.
pub(crate) const NOTES: &str = "wisch";
/// Key of the executed task's name.
pub(crate) const TASK_NOTE: &str = "task";
/// Key of the digest of the surface's mesh.
pub(crate) const MESH_NOTE: &str = "surface_mesh";
/// Key of the nominal press force [N].
pub(crate) const FORCE_NOTE: &str = "press_force_n";
/// Key of the executed round's number.
pub(crate) const ROUND_NOTE: &str = "round";

/// Key of a channel's metadata for its role in the interpretation.
pub(crate) const ROLE_KEY: &str = "wisch.role";
/// Role: pose of the tool.
pub(crate) const ROLE_POSE: &str = "tool pose";
/// Role: external wrench on the tool.
pub(crate) const ROLE_WRENCH: &str = "external wrench";
/// Key of a channel's metadata for the log's time at which the samples' time is 0 [ns].
pub(crate) const START_KEY: &str = "wisch.start_ns";
/// Key of a channel's metadata for the axes of a wrench.
pub(crate) const AXES_KEY: &str = "wisch.axes";

/// Topics, in the order of their channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Topic {
    Joints,
    Commanded,
    Measured,
    Controller,
    External,
    Transforms,
    Particles,
    Phase,
    DirtBefore,
    HiddenBefore,
    DirtAfter,
    HiddenAfter,
    Robot,
    StaticTransforms,
    Scene,
    Strokes,
    Tool,
    Force,
    Status,
    Stamp,
}

impl Topic {
    pub const ALL: [Self; 20] = [
        Self::Joints,
        Self::Commanded,
        Self::Measured,
        Self::Controller,
        Self::External,
        Self::Transforms,
        Self::Particles,
        Self::Phase,
        Self::DirtBefore,
        Self::HiddenBefore,
        Self::DirtAfter,
        Self::HiddenAfter,
        Self::Robot,
        Self::StaticTransforms,
        Self::Scene,
        Self::Strokes,
        Self::Tool,
        Self::Force,
        Self::Status,
        Self::Stamp,
    ];

    /// Whether a bag has the topic only if there is a message for it.
    pub fn is_optional(self) -> bool {
        matches!(self, Self::Status | Self::Stamp)
    }

    /// Its name, and the package and name of its type.
    pub fn names(self) -> (&'static str, [&'static str; 2]) {
        match self {
            Self::Joints => ("/joint_states", ["sensor_msgs", "JointState"]),
            Self::Commanded => ("/tcp/commanded", ["geometry_msgs", "PoseStamped"]),
            Self::Measured => ("/tcp/measured", ["geometry_msgs", "PoseStamped"]),
            Self::Controller => ("/wrench/controller", ["geometry_msgs", "WrenchStamped"]),
            Self::External => ("/wrench/external", ["geometry_msgs", "WrenchStamped"]),
            Self::Transforms => ("/tf", ["tf2_msgs", "TFMessage"]),
            Self::Particles => ("/particles", ["visualization_msgs", "Marker"]),
            Self::Phase => ("/phase", ["std_msgs", "String"]),
            Self::DirtBefore => (DIRT[0], ["sensor_msgs", "PointCloud2"]),
            Self::HiddenBefore => (HIDDEN[0], ["geometry_msgs", "PolygonStamped"]),
            Self::DirtAfter => (DIRT[1], ["sensor_msgs", "PointCloud2"]),
            Self::HiddenAfter => (HIDDEN[1], ["geometry_msgs", "PolygonStamped"]),
            Self::Robot => ("/robot_description", ["std_msgs", "String"]),
            Self::StaticTransforms => ("/tf_static", ["tf2_msgs", "TFMessage"]),
            Self::Scene => ("/scene", ["visualization_msgs", "MarkerArray"]),
            Self::Strokes => ("/plan/strokes", ["visualization_msgs", "MarkerArray"]),
            Self::Tool => ("/tool", ["visualization_msgs", "Marker"]),
            Self::Force => ("/force", ["visualization_msgs", "Marker"]),
            Self::Status => ("/wisch/sample_status", ["std_msgs", "String"]),
            Self::Stamp => ("/wisch/stamp", ["sensor_msgs", "TimeReference"]),
        }
    }

    /// Metadata that a reader needs beside the type.
    pub fn metadata(self, start: u64) -> BTreeMap<String, String> {
        let start = start.to_string();
        let says: &[(&str, &str)] = match self {
            Self::Commanded => &[(
                "wisch.meaning",
                "commanded tool centre point, including the press into the surface",
            )],
            Self::Measured => &[
                (ROLE_KEY, ROLE_POSE),
                (START_KEY, &start),
                (
                    "wisch.meaning",
                    "tool centre point from the joint positions",
                ),
            ],
            Self::Controller => &[
                (AXES_KEY, FRAME_WORLD),
                ("wisch.point", "tool centre point"),
                (
                    "wisch.meaning",
                    "wrench that the controller commands, saturated",
                ),
            ],
            Self::External => &[
                (ROLE_KEY, ROLE_WRENCH),
                (AXES_KEY, FRAME_WORLD),
                ("wisch.point", "tool centre point"),
                (
                    "wisch.meaning",
                    "wrench of the surroundings on the tool, estimated from the drives",
                ),
            ],
            Self::Particles => &[("wisch.meaning", "believed particle positions")],
            Self::DirtBefore => &[(
                "wisch.meaning",
                "dirt that the camera detected before the round",
            )],
            Self::DirtAfter => &[(
                "wisch.meaning",
                "dirt that the camera detected after the round",
            )],
            Self::HiddenBefore | Self::HiddenAfter => {
                &[("wisch.meaning", "area that the camera could not see")]
            }
            Self::Strokes => &[("wisch.meaning", "planned strokes")],
            Self::Force => &[(
                "wisch.meaning",
                "the force of /wrench/external, drawn from the tool centre point",
            )],
            Self::Status => &[(
                "wisch.meaning",
                "quality of /wrench/external from this time on (ok, stale, saturated or untared), and whether the motion is paused",
            )],
            Self::Stamp => &[(
                "wisch.meaning",
                "absolute time of the sample, on the clock that the source names (epoch or device)",
            )],
            Self::Joints
            | Self::Transforms
            | Self::Phase
            | Self::Robot
            | Self::StaticTransforms
            | Self::Scene
            | Self::Tool => &[],
        };
        // rosbag2 expects QoS profiles; an empty text stands for the default.
        [("offered_qos_profiles", "")]
            .iter()
            .chain(says)
            .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
            .collect()
    }
}
