//! How closely a plan is followed, and how hard a way is looked for.

use super::FollowError;
use std::f64::consts::PI;

/// How hard a way along an edge is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchScope {
    /// Step by step only.
    Local,
    /// Where that fails, by a search over the discretised null space, complete within its discretisation.
    Global,
}

/// How closely a plan is followed, and how hard a way is looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowConfig {
    /// Longest step of the tool between two poses that are solved [m].
    pub step: f64,
    /// Largest turn between two poses that are solved [rad].
    pub turn: f64,
    /// δ of Algorithm 1: increment of the tool's free rotation and tilt [rad].
    pub orientation_increment: f64,
    /// Clearance that every pair of bodies keeps [m].
    pub margin: f64,
    /// Clearance that the arm keeps from obstacles in free motion where there is room for it [m]: they may not be where they
    /// are believed to be.
    pub free_clearance: f64,
    /// Largest change of a joint over one step; more is a jump [rad or m].
    pub max_joint_step: f64,
    /// How far the tool centre point may leave its line [m].
    pub line_tolerance: f64,
    /// How far the tool may turn away from its line [rad].
    pub turn_tolerance: f64,
    /// Fastest the tool moves in contact [m/s].
    pub contact_speed: f64,
    /// Fastest the tool comes down to the surface [m/s].
    pub approach_speed: f64,
    /// Over which a change of a joint's acceleration is spread [s]: its jerk is at most twice its largest acceleration over
    /// this; 0 lets accelerations jump.
    pub acceleration_ramp: f64,
    /// Whether the robot turns the tool so that its joints move little, where one hand holds it and its predicted effect is
    /// as good; else it is turned as planned.
    pub free_yaw: bool,
    /// Whether, where its yaw is free so, the robot passes the nodes of a plan to absorb in another order if its joints move
    /// less in it and its predicted effect is as good; else strokes go as planned.
    pub free_order: bool,
    /// How hard a way along an edge is looked for.
    pub search: SearchScope,
    /// How many configurations are tried at the begin of a stroke.
    pub start_configurations: usize,
    /// How many placements of the base are tried for the same piece of the path.
    pub placements: usize,
    /// Seed of the random starts of searches.
    pub seed: u64,
}

impl Default for FollowConfig {
    /// Poses each 10 mm and 2°, the tool turned by 10°, 5 mm of clearance, 30 mm in free motion, 1 mm and 0.5° off the line,
    /// 0.25 m/s in contact, 0.1 m/s down to it, accelerations that change over 40 ms.
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
    /// Whether the numbers make sense.
    ///
    /// # Errors
    /// The first field that does not.
    pub(super) fn checked(&self) -> Result<(), FollowError> {
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
