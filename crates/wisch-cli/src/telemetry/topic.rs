//! The topics of the bags that are written.

use super::{AXES_KEY, FRAME_WORLD, ROLE_KEY, ROLE_POSE, ROLE_WRENCH, START_KEY};
use std::collections::BTreeMap;

/// The topics, in the order of their channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Topic {
    Joints,
    Commanded,
    Measured,
    Controller,
    External,
    Transforms,
    Particles,
    Phase,
}

impl Topic {
    pub const ALL: [Self; 8] = [
        Self::Joints,
        Self::Commanded,
        Self::Measured,
        Self::Controller,
        Self::External,
        Self::Transforms,
        Self::Particles,
        Self::Phase,
    ];

    /// Its name, its package and type.
    pub fn named(self) -> (&'static str, [&'static str; 2]) {
        match self {
            Self::Joints => ("/joint_states", ["sensor_msgs", "JointState"]),
            Self::Commanded => ("/tcp/commanded", ["geometry_msgs", "PoseStamped"]),
            Self::Measured => ("/tcp/measured", ["geometry_msgs", "PoseStamped"]),
            Self::Controller => ("/wrench/controller", ["geometry_msgs", "WrenchStamped"]),
            Self::External => ("/wrench/external", ["geometry_msgs", "WrenchStamped"]),
            Self::Transforms => ("/tf", ["tf2_msgs", "TFMessage"]),
            Self::Particles => ("/particles", ["visualization_msgs", "Marker"]),
            Self::Phase => ("/phase", ["std_msgs", "String"]),
        }
    }

    /// What a reader has to know beside the type.
    pub fn metadata(self, start: u64) -> BTreeMap<String, String> {
        let start = start.to_string();
        let says: &[(&str, &str)] = match self {
            Self::Commanded => &[(
                "wisch.meaning",
                "tool centre point as commanded, the press into the surface included",
            )],
            Self::Measured => &[
                (ROLE_KEY, ROLE_POSE),
                (START_KEY, &start),
                (
                    "wisch.meaning",
                    "tool centre point by the joints' positions",
                ),
            ],
            Self::Controller => &[
                (AXES_KEY, FRAME_WORLD),
                ("wisch.point", "tool centre point"),
                (
                    "wisch.meaning",
                    "what the controller asks of the tool, saturated",
                ),
            ],
            Self::External => &[
                (ROLE_KEY, ROLE_WRENCH),
                (AXES_KEY, FRAME_WORLD),
                ("wisch.point", "tool centre point"),
                (
                    "wisch.meaning",
                    "what the surroundings do to the tool, as estimated from the drives",
                ),
            ],
            Self::Particles => &[("wisch.meaning", "particles as they are believed to lie")],
            Self::Joints | Self::Transforms | Self::Phase => &[],
        };
        // rosbag2 looks for profiles; an empty text stands for the usual ones.
        [("offered_qos_profiles", "")]
            .iter()
            .chain(says)
            .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
            .collect()
    }
}
