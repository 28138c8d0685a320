//! Errors of the setup.

use crate::RobotError;

/// A reason why no SRDF can be proposed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SetupError {
    /// The robot or its positions cannot be used.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// A setting is outside its range.
    #[error("setup.{field}: {value} is outside {lower} to {upper}")]
    Setting {
        /// Name of the setting.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Its least value.
        lower: f64,
        /// Its largest value.
        upper: f64,
    },
    /// No chain is long enough for an arm.
    #[error(
        "robot {robot:?}: no arm found: the longest chain that is no leg, head or hand has {}{}, expected at least {limit}",
        counted_joints(*joints),
        ending(tip.as_deref())
    )]
    NoArm {
        /// Name of the robot.
        robot: String,
        /// Most independent joints of a chain.
        joints: usize,
        /// Link at its end; `None` if no joint moves.
        tip: Option<String>,
        /// Least number of joints of an arm.
        limit: usize,
    },
    /// The joints of an arm have no range.
    #[error(
        "robot {robot:?}: no arm found: none of the {joints} joints that move link {tip:?} has a range, as the lower and the upper position limit of each are equal"
    )]
    NoRange {
        /// Name of the robot.
        robot: String,
        /// Number of joints.
        joints: usize,
        /// Link that they move.
        tip: String,
    },
    /// No joint moves the named tip.
    #[error("link {tip:?}: no joint moves it, but the tip of an arm moves")]
    FixedTip {
        /// Name of the link.
        tip: String,
    },
    /// No posture was within limits and free of collision.
    #[error(
        "group {group:?}: no ready posture found from {samples} random postures: {}",
        in_contact(*reached, contact.as_deref())
    )]
    NoReadyPosture {
        /// Name of the group.
        group: String,
        /// Number of random postures.
        samples: usize,
        /// Number of postures with the tool over the surface.
        reached: usize,
        /// The pair that collides most often, in words.
        contact: Option<String>,
    },
}

fn counted_joints(count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} independent joint{plural}")
}

fn ending(tip: Option<&str>) -> String {
    tip.map_or_else(String::new, |tip| format!(" (it ends in {tip:?})"))
}

fn in_contact(reached: usize, contact: Option<&str>) -> String {
    match contact {
        None => "none puts the tool over the surface".to_owned(),
        Some(contact) => format!(
            "{reached} put the tool over the surface, and all of these collide or come too close, most often {contact}"
        ),
    }
}
