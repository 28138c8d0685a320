//! The file following.json: how the robot follows the plan, and the nodes that it abandons.

use serde::Serialize;
use wisch::follow::{AbandonedNode, Followed, Motion, Obstruction};

/// Value of `format` in following.json.
const FORMAT: &str = "wisch-following";
/// Schema number of following.json.
const SCHEMA: u32 = 1;

/// The contents of `following.json`: how a robot follows a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FollowedRecord {
    /// Always "wisch-following".
    pub format: &'static str,
    /// Always 1.
    pub schema: u32,
    /// Name of the robot.
    pub robot: String,
    /// Base poses, in order of time.
    pub placements: Vec<PlacementRecord>,
    /// Motions, in order of time.
    pub motions: Vec<MotionRecord>,
    /// Executable strokes: nodes of the plan, and tool poses in the surface frame.
    pub strokes: Vec<WipedRecord>,
    /// Rating of the reach of each node by the capability map, from the best base pose for it, 0 to 1; left out without a
    /// map.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub node_reachability: Vec<f64>,
    /// Abandoned nodes.
    pub abandoned: Vec<AbandonedRecord>,
    /// Faults that an independent check has found.
    pub faults: Vec<String>,
}

/// A base pose with the rating of its reach.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlacementRecord {
    /// x, y in the world.
    pub position_m: [f64; 2],
    /// Heading about the world's z.
    pub heading_rad: f64,
    /// Rating of the reach of its path, 0 to 1.
    pub rating: f64,
}

/// One motion from rest to rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionRecord {
    /// drive, transfer, lifted, lower, wipe or lift.
    pub phase: &'static str,
    /// Index of the stroke, for the phase wipe only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stroke: Option<usize>,
    /// Start time.
    pub start_s: f64,
    /// End time.
    pub end_s: f64,
}

/// A stroke that the robot can execute.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WipedRecord {
    /// Nodes of the plan's graph.
    pub nodes: Vec<usize>,
    /// x \[m\], y \[m\], heading \[rad\] of the tool in the surface frame.
    pub in_surface: Vec<[f64; 3]>,
}

/// A node that the robot cannot reach.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AbandonedRecord {
    /// The node.
    pub node: usize,
    /// The plan's stroke.
    pub stroke: usize,
    /// Attempts to reach it.
    pub attempts: Vec<AttemptRecord>,
}

/// An attempt to reach a node.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AttemptRecord {
    /// Yaw of the tool relative to the planned yaw.
    pub rotation_rad: f64,
    /// Tilt of the tool.
    pub tilt_rad: f64,
    /// Share of the path that the robot could follow.
    pub progress: f64,
    /// out_of_reach, joint_limit, self_collision, scene_collision or jump.
    pub reason: &'static str,
    /// Description of the obstruction with names and numbers.
    pub detail: String,
}

impl FollowedRecord {
    /// Makes the record of a motion and its faults.
    pub fn new(robot: &str, followed: &Followed, faults: Vec<String>) -> Self {
        Self {
            format: FORMAT,
            schema: SCHEMA,
            robot: robot.to_owned(),
            placements: (followed.placements.iter())
                .map(|placement| {
                    let at = placement.world_from_base;
                    PlacementRecord {
                        position_m: [at.position.x, at.position.y],
                        heading_rad: at.heading,
                        rating: placement.rating,
                    }
                })
                .collect(),
            motions: followed.motions.iter().map(motion).collect(),
            strokes: (followed.strokes.iter())
                .map(|stroke| WipedRecord {
                    nodes: stroke.nodes.clone(),
                    in_surface: (stroke.poses.iter())
                        .map(|pose| [pose.position.x, pose.position.y, pose.heading])
                        .collect(),
                })
                .collect(),
            node_reachability: followed.node_reachability.clone(),
            abandoned: followed.abandoned.iter().map(abandoned).collect(),
            faults,
        }
    }
}

fn motion(motion: &Motion) -> MotionRecord {
    MotionRecord {
        phase: motion.phase.as_str(),
        stroke: motion.phase.stroke(),
        start_s: motion.start,
        end_s: motion.end(),
    }
}

fn abandoned(node: &AbandonedNode) -> AbandonedRecord {
    AbandonedRecord {
        node: node.node,
        stroke: node.stroke,
        attempts: (node.attempts.iter())
            .map(|attempt| AttemptRecord {
                rotation_rad: attempt.rotation,
                tilt_rad: attempt.tilt,
                progress: attempt.progress,
                reason: reason(&attempt.obstruction),
                detail: attempt.obstruction.to_string(),
            })
            .collect(),
    }
}

/// Returns the name of an obstruction for files.
const fn reason(obstruction: &Obstruction) -> &'static str {
    match obstruction {
        Obstruction::OutOfReach { .. } => "out_of_reach",
        Obstruction::JointLimit { .. } => "joint_limit",
        Obstruction::SelfCollision { .. } => "self_collision",
        Obstruction::SceneCollision { .. } => "scene_collision",
        Obstruction::SecondHand { .. } => "second_hand",
        Obstruction::Jump { .. } => "jump",
    }
}
