//! Settings of the follower: how closely a plan is followed, and how thoroughly a path is searched for.

use super::FollowError;
use std::f64::consts::PI;

/// Effort of the search for a path along an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchScope {
    /// Only step by step along the edge.
    Local,
    /// If that fails, by a search over the discretised null space, complete within its discretisation.
    Global,
}

/// Settings of the follower: margins, tolerances and effort of the search.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowConfig {
    /// Longest step of the tool between two solved poses \[m\].
    pub step: f64,
    /// Largest rotation of the tool between two solved poses \[rad\].
    pub turn: f64,
    /// δ of Algorithm 1: increment of the tool's free rotation and tilt \[rad\].
    pub orientation_increment: f64,
    /// Clearance between all pairs of bodies \[m\].
    pub margin: f64,
    /// Clearance of the arm from obstacles in free motion, where the scene leaves space for it \[m\]: obstacles
    /// may have a localisation error.
    pub free_clearance: f64,
    /// Largest change of a joint over one step; a larger change is a jump [rad or m].
    pub max_joint_step: f64,
    /// Largest distance of the tool centre point from its line \[m\].
    pub line_tolerance: f64,
    /// Largest rotation of the tool away from its line \[rad\].
    pub turn_tolerance: f64,
    /// Largest speed of the tool in contact [m/s].
    pub contact_speed: f64,
    /// Largest speed of the tool on its way down to the surface [m/s].
    pub approach_speed: f64,
    /// Largest speed of the tool between strokes [m/s]; infinite for the speed that the joints permit.
    pub free_speed: f64,
    /// Time over which a change of a joint's acceleration is spread \[s\]. The jerk is at most twice the joint's
    /// largest acceleration over this time; with 0, accelerations jump.
    pub acceleration_ramp: f64,
    /// Whether the robot may choose the tool's yaw so that its joints move little. It does so only if one hand
    /// holds the tool and the predicted effect is as good; else it keeps the planned yaw.
    pub free_yaw: bool,
    /// Whether the robot may visit the nodes of an absorb plan in another order. It does so only if
    /// the yaw is free, its joints move less, and the predicted effect is as good.
    pub free_order: bool,
    /// How thoroughly a path along an edge is searched for.
    pub search: SearchScope,
    /// Number of configurations that are tried at the start of a stroke.
    pub start_configurations: usize,
    /// Number of base poses that are tried for the same piece of the path.
    pub placements: usize,
    /// Seed of the random starts of all searches.
    pub seed: u64,
}

impl Default for FollowConfig {
    /// Poses every 10 mm and 2°, yaw and tilt in steps of 10°. Clearance of 5 mm, and 30 mm in free motion. At most
    /// 1 mm and 0.5° off the line. 0.25 m/s in contact, 0.1 m/s on the way down; accelerations change over 40 ms.
    fn default() -> Self {
        Self {
            step: 0.01,
            turn: 2.0_f64.to_radians(),
            orientation_increment: 10.0_f64.to_radians(),
            margin: 5e-3,
            free_clearance: 0.03,
            max_joint_step: 0.2,
            line_tolerance: 1e-3,
            turn_tolerance: 0.5_f64.to_radians(),
            contact_speed: 0.25,
            approach_speed: 0.1,
            free_speed: f64::INFINITY,
            acceleration_ramp: 0.04,
            free_yaw: true,
            free_order: true,
            search: SearchScope::Global,
            start_configurations: 10,
            placements: 4,
            seed: 0,
        }
    }
}

impl FollowConfig {
    /// Checks that all numbers are in their ranges.
    ///
    /// # Errors
    /// The first field outside its range.
    pub(super) fn check(&self) -> Result<(), FollowError> {
        let steps = "0.0001 to 1 m";
        let speeds = "0.001 to 10 m/s";
        let placements = self.placements as f64;
        let starts = self.start_configurations as f64;
        let fields = [
            ("step", self.step, [1e-4, 1.0], steps),
            ("turn", self.turn, [1e-3, 1.0], "0.001 to 1 rad"),
            (
                "orientation_increment",
                self.orientation_increment,
                [1e-2, PI],
                "0.01 to pi rad",
            ),
            ("margin", self.margin, [1e-4, 1.0], steps),
            (
                "free_clearance",
                self.free_clearance,
                [0.0, 1.0],
                "0 to 1 m",
            ),
            (
                "max_joint_step",
                self.max_joint_step,
                [1e-3, PI],
                "0.001 to pi rad",
            ),
            (
                "line_tolerance",
                self.line_tolerance,
                [1e-5, 0.1],
                "0.00001 to 0.1 m",
            ),
            (
                "turn_tolerance",
                self.turn_tolerance,
                [1e-4, 1.0],
                "0.0001 to 1 rad",
            ),
            ("contact_speed", self.contact_speed, [1e-3, 10.0], speeds),
            ("approach_speed", self.approach_speed, [1e-3, 10.0], speeds),
            (
                "free_speed",
                self.free_speed,
                [1e-3, f64::INFINITY],
                "0.001 m/s or more",
            ),
            (
                "acceleration_ramp",
                self.acceleration_ramp,
                [0.0, 1.0],
                "0 to 1 s",
            ),
            ("start_configurations", starts, [1.0, 1e4], "1 to 10000"),
            ("placements", placements, [1.0, 1e4], "1 to 10000"),
        ];
        for (name, value, [least, most], expected) in fields {
            if !(value >= least && value <= most) {
                return Err(FollowError::Config {
                    name,
                    value,
                    expected,
                });
            }
        }
        Ok(())
    }
}
