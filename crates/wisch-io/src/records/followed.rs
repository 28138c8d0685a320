//! following.json: how the robot follows the plan, and what it had to give up.

use serde::Serialize;
use wisch::follow::{AbandonedNode, Followed, Motion, Obstruction};

/// What `format` says in every following.json.
const FORMAT: &str = "wisch-following";
/// The schema of following.json.
const SCHEMA: u32 = 1;

/// following.json.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FollowedRecord {
    /// Always "wisch-following".
    pub format: &'static str,
    /// Always 1.
    pub schema: u32,
    /// Name of the robot.
    pub robot: String,
    /// Where the base stands, in order.
    pub placements: Vec<PlacementRecord>,
    /// The motions, one after the other.
    pub motions: Vec<MotionRecord>,
    /// The strokes as they are wiped: nodes of the plan, and the tool in the surface frame.
    pub strokes: Vec<WipedRecord>,
    /// How amply each node of the plan is in reach by the capability map, from that of the placements that suits it best,
    /// 0 to 1; left out without a map.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub node_reachability: Vec<f64>,
    /// Nodes that are not passed.
    pub abandoned: Vec<AbandonedRecord>,
    /// What an independent check found wrong.
    pub faults: Vec<String>,
}

/// Where the base stands.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlacementRecord {
    /// x, y in the world.
    pub position_m: [f64; 2],
    /// Heading about the world's z.
    pub heading_rad: f64,
    /// How amply the path was expected to be in reach, 0 to 1.
    pub rating: f64,
}

/// One motion from rest to rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionRecord {
    /// drive, transfer, lifted, lower, wipe or lift.
    pub phase: &'static str,
    /// For wipe the index of the stroke.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stroke: Option<usize>,
    /// When it begins.
    pub start_s: f64,
    /// When it ends.
    pub end_s: f64,
}

/// A stroke as it is wiped.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WipedRecord {
    /// Nodes of the plan's graph.
    pub nodes: Vec<usize>,
    /// x [m], y [m], heading [rad] of the tool in the surface frame.
    pub in_surface: Vec<[f64; 3]>,
}

/// A node that was given up.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AbandonedRecord {
    /// The node.
    pub node: usize,
    /// The plan's stroke.
    pub stroke: usize,
    /// What was tried.
    pub attempts: Vec<AttemptRecord>,
}

/// One way that was tried.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AttemptRecord {
    /// Rotation of the tool against the planned one.
    pub rotation_rad: f64,
    /// Its lean.
    pub tilt_rad: f64,
    /// Share of the way that worked.
    pub progress: f64,
    /// out_of_reach, joint_limit, self_collision, scene_collision or jump.
    pub reason: &'static str,
    /// The same for people, with names and numbers.
    pub detail: String,
}

impl FollowedRecord {
    /// The record of a motion and of what was found wrong with it.
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

/// One word for what was in the way.
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
