//! The file plan.json.
//!
//! Units are SI and radians; keys end in their unit, and poses state their frames. A plan does not depend on the clock or
//! the machine, so equal tasks and seeds give equal bytes.

use super::shape::{BendContactRecord, ShapeRecord};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;
use wisch::geometry::{PlanarPose, Point2, Pose};
use wisch::plan::{
    Node, NodeRole, Plan, PlanError, SemanticDirectedGraph, Stroke, TcpWaypoint, check_strokes,
    find_unreachable_share,
};
use wisch::represent::{Action, GoalState, Task, UnknownName};

/// Value of the key `format` in `plan.json`.
pub const PLAN_FORMAT: &str = "wisch-plan";
/// Schema number of the file `plan.json`.
pub const PLAN_SCHEMA: u32 = 1;

/// The contents of `plan.json`: strokes with the graph that they come from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanRecord {
    /// Always [`PLAN_FORMAT`].
    pub format: String,
    /// Always [`PLAN_SCHEMA`].
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// absorb, collect, skim, polish or dispense.
    pub action: String,
    /// Name of the surface, whose frame all positions are in.
    pub surface: String,
    /// Name of the tool, whose frame's origin is the tool centre point.
    pub tool: String,
    /// Name of the medium.
    pub medium: String,
    /// Strategy of the plan.
    pub strategy: String,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Pose of the surface in the world.
    pub world_from_surface: PoseRecord,
    /// Shape of the surface; left out for a plane. Positions are in the chart, which is rolled onto it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface_shape: Option<ShapeRecord>,
    /// Contact of the tool with the bend; left out for a plane, and for a tool that hovers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bend_contact: Option<BendContactRecord>,
    /// Start position of the tool, in the surface frame.
    pub tool_start_in_surface_m: [f64; 2],
    /// Radius r_s of the collision sphere.
    pub collision_radius_m: f64,
    /// Lift height between strokes.
    pub lift_height_m: f64,
    /// Maximum length of an edge; null without a limit.
    pub max_edge_length_m: Option<f64>,
    /// The goal state.
    pub goal: GoalRecord,
    /// The graph's nodes.
    pub nodes: Vec<NodeRecord>,
    /// The graph's directed edges, each as the indices of two nodes: from, to.
    pub edges: Vec<[usize; 2]>,
    /// Indices of the nodes that no valid edge connects to the goal.
    pub unreachable_nodes: Vec<usize>,
    /// Share of the particles that the tool covers at no free position and yaw. The value in a file
    /// is ignored.
    #[serde(default)]
    pub unreachable_share: f64,
    /// The strokes in their order.
    pub strokes: Vec<StrokeRecord>,
    /// The corners of the tool centre point's whole path, lifted moves included. They follow from
    /// the strokes: the values in a file are ignored.
    #[serde(default)]
    pub tcp_path: Vec<WaypointRecord>,
}

/// A pose in space: position \[m\] and orientation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoseRecord {
    /// x, y, z.
    pub translation_m: [f64; 3],
    /// Unit quaternion: x, y, z, w.
    pub rotation_xyzw: [f64; 4],
}

impl From<&Pose> for PoseRecord {
    fn from(pose: &Pose) -> Self {
        Self {
            translation_m: pose.translation.vector.into(),
            rotation_xyzw: pose.rotation.coords.into(),
        }
    }
}

/// The goal state that the plan serves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case", deny_unknown_fields)]
pub enum GoalRecord {
    /// All particles absorbed.
    Absorbed,
    /// All particles in the goal area.
    Collected {
        /// Centre in the surface frame.
        center_in_surface_m: [f64; 2],
        /// Radius.
        radius_m: f64,
    },
    /// All particles pushed over a skim edge.
    Skimmed,
    /// All points passed a number of times.
    Polished {
        /// Number of passes.
        passes: u32,
    },
    /// All points coated; "emitted" in files of earlier versions.
    #[serde(alias = "emitted")]
    Dispensed {
        /// Thickness of the coat.
        thickness_m: f64,
        /// Thickness per pass.
        per_pass_m: f64,
    },
}

impl From<GoalState> for GoalRecord {
    fn from(goal: GoalState) -> Self {
        match goal {
            GoalState::Absorbed => Self::Absorbed,
            GoalState::Collected { center, radius } => Self::Collected {
                center_in_surface_m: center.into(),
                radius_m: radius,
            },
            GoalState::Skimmed => Self::Skimmed,
            GoalState::Polished { passes } => Self::Polished { passes },
            GoalState::Dispensed {
                thickness,
                per_pass,
            } => Self::Dispensed {
                thickness_m: thickness,
                per_pass_m: per_pass,
            },
        }
    }
}

impl From<GoalRecord> for GoalState {
    fn from(goal: GoalRecord) -> Self {
        match goal {
            GoalRecord::Absorbed => Self::Absorbed,
            GoalRecord::Collected {
                center_in_surface_m,
                radius_m,
            } => Self::Collected {
                center: center_in_surface_m.into(),
                radius: radius_m,
            },
            GoalRecord::Skimmed => Self::Skimmed,
            GoalRecord::Polished { passes } => Self::Polished { passes },
            GoalRecord::Dispensed {
                thickness_m,
                per_pass_m,
            } => Self::Dispensed {
                thickness: thickness_m,
                per_pass: per_pass_m,
            },
        }
    }
}

/// A node of the plan's graph.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NodeRecord {
    /// Role of the node.
    pub role: RoleRecord,
    /// Position.
    pub in_surface_m: [f64; 2],
}

/// The role of a node in the graph.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RoleRecord {
    /// Covers a part of the surface.
    Coverage,
    /// Destination of the particles.
    Goal,
}

/// A stroke: a motion in contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrokeRecord {
    /// Indices of its nodes.
    pub nodes: Vec<usize>,
    /// The tool's pose at each of them.
    pub surface_from_tool: Vec<PlanarPoseRecord>,
}

/// A pose in the plane of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanarPoseRecord {
    /// x of the tool centre point.
    pub x_m: f64,
    /// y of the tool centre point.
    pub y_m: f64,
    /// Angle from the surface's x axis to the tool's; continuous beyond ±π within a stroke.
    pub heading_rad: f64,
}

/// A corner of the tool centre point's path, in the surface frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WaypointRecord {
    /// x of the tool centre point.
    pub x_m: f64,
    /// y of the tool centre point.
    pub y_m: f64,
    /// Height above the surface; 0 in contact.
    pub height_m: f64,
    /// Angle from the surface's x axis to the tool's.
    pub heading_rad: f64,
}

/// An error of a plan file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanRecordError {
    /// The text is not JSON, or its keys are not those of a plan.
    #[error("line {line}, column {column}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Message of the JSON parser.
        message: String,
    },
    /// Another kind of file.
    #[error("format {found:?} is not {PLAN_FORMAT:?}: this is not a plan of wisch")]
    Format {
        /// The value in the file.
        found: String,
    },
    /// A schema of another version.
    #[error("schema {found} is not supported; this version reads schema {PLAN_SCHEMA}")]
    Schema {
        /// The value in the file.
        found: u32,
    },
    /// The plan was made for another task.
    #[error("the plan's {what} is {found:?}, the task's is {expected:?}")]
    OtherTask {
        /// The quantity that differs.
        what: &'static str,
        /// Value in the plan.
        found: String,
        /// Value in the task.
        expected: String,
    },
    /// A node that does not exist.
    #[error("{place} names node {index}, but there are {nodes} nodes (counted from 0)")]
    NoSuchNode {
        /// Path of the faulty entry in the file.
        place: String,
        /// The index.
        index: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// A number outside its limits.
    #[error("{place} = {value} is outside its limits: {limits}")]
    OutOfRange {
        /// Path of the faulty entry in the file.
        place: String,
        /// The value.
        value: f64,
        /// The limits.
        limits: &'static str,
    },
    /// A stroke whose numbers of nodes and poses differ.
    #[error("strokes[{stroke}] has {nodes} nodes but {poses} poses")]
    PosesPerNode {
        /// Index of the stroke.
        stroke: usize,
        /// Number of nodes.
        nodes: usize,
        /// Number of poses.
        poses: usize,
    },
    /// A strategy that does not exist.
    #[error(transparent)]
    Strategy(#[from] UnknownName),
    /// A stroke that the tool cannot execute.
    #[error(transparent)]
    Stroke(#[from] PlanError),
}

/// Largest coordinate in a plan file, either sign [m].
const MAX_COORDINATE: f64 = wisch::geometry::MAX_COORDINATE;
/// Largest heading in a plan file, either sign [rad]: beyond it, a turn is lost in rounding.
const MAX_HEADING: f64 = 1e6;

impl PlanRecord {
    /// Makes the record of a plan.
    pub fn new(task: &Task, plan: &Plan, seed: u64) -> Self {
        Self {
            format: PLAN_FORMAT.to_owned(),
            schema: PLAN_SCHEMA,
            task: task.name.clone(),
            action: task.action.to_string(),
            surface: task.surface.name.clone(),
            tool: task.tool.name.clone(),
            medium: task.medium.clone(),
            strategy: plan.strategy.to_string(),
            seed,
            world_from_surface: (&task.surface.world_from_surface).into(),
            surface_shape: ShapeRecord::from_curved(&task.surface.shape),
            bend_contact: BendContactRecord::new(task),
            tool_start_in_surface_m: plan.tool_start.into(),
            collision_radius_m: plan.collision_radius,
            lift_height_m: plan.lift_height,
            max_edge_length_m: plan.graph.max_edge_length,
            goal: plan.graph.goal.into(),
            nodes: plan.graph.nodes.iter().map(node_record).collect(),
            edges: plan
                .graph
                .edges
                .iter()
                .map(|&(from, to)| [from, to])
                .collect(),
            unreachable_nodes: plan.graph.unreachable.clone(),
            unreachable_share: plan.unreachable_share,
            strokes: plan
                .strokes
                .iter()
                .map(|stroke| StrokeRecord {
                    nodes: stroke.nodes.clone(),
                    surface_from_tool: stroke.poses.iter().map(planar_pose_record).collect(),
                })
                .collect(),
            tcp_path: plan.tcp_path().iter().map(waypoint_record).collect(),
        }
    }

    /// Reads the text of a plan file.
    ///
    /// # Errors
    /// If the text is not a plan of this version. [`Self::to_plan`] checks whether it fits a task.
    pub fn parse(text: &str) -> Result<Self, PlanRecordError> {
        /// The keys that all formats and versions have.
        #[derive(Deserialize)]
        struct Marker {
            format: String,
            schema: u32,
        }
        // Editors of Windows write a byte-order mark.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let syntax = |error: serde_json::Error| PlanRecordError::Syntax {
            line: error.line(),
            column: error.column(),
            message: without_place(&error.to_string()).to_owned(),
        };
        let marker: Marker = serde_json::from_str(text).map_err(syntax)?;
        if marker.format != PLAN_FORMAT {
            return Err(PlanRecordError::Format {
                found: marker.format,
            });
        }
        if marker.schema != PLAN_SCHEMA {
            return Err(PlanRecordError::Schema {
                found: marker.schema,
            });
        }
        serde_json::from_str(text).map_err(syntax)
    }

    /// Converts the record to a plan for a task.
    ///
    /// # Errors
    /// If the plan was made for another action, surface, tool or medium, is inconsistent, or has a stroke that the tool cannot
    /// execute: through an object of the scene, over a hole, or off the surface.
    pub fn to_plan(&self, task: &Task) -> Result<Plan, PlanRecordError> {
        self.check_task(task)?;
        self.check_indices()?;
        self.check_numbers()?;
        let plan = Plan {
            strategy: self.strategy.parse()?,
            graph: SemanticDirectedGraph {
                nodes: self.nodes.iter().map(node).collect(),
                edges: self.edges.iter().map(|&[from, to]| (from, to)).collect(),
                // A goal that the task states is what results are compared with.
                goal: task.goal().unwrap_or(self.goal.into()),
                max_edge_length: self.max_edge_length_m,
                unreachable: self.unreachable_nodes.clone(),
            },
            strokes: self
                .strokes
                .iter()
                .map(|stroke| Stroke {
                    nodes: stroke.nodes.clone(),
                    poses: stroke.surface_from_tool.iter().map(planar_pose).collect(),
                })
                .collect(),
            collision_radius: self.collision_radius_m,
            // Of the particles of this task, which may be others than those that the plan was made for.
            unreachable_share: find_unreachable_share(task)?,
            tool_start: self.tool_start_in_surface_m.into(),
            lift_height: self.lift_height_m,
        };
        check_strokes(task, &plan.strokes)?;
        Ok(plan)
    }

    fn check_task(&self, task: &Task) -> Result<(), PlanRecordError> {
        // Files of earlier versions may have another name for it.
        let known = self.action.parse::<Action>();
        let action = known
            .as_ref()
            .map_or(self.action.as_str(), |action| action.as_str());
        let goal = match self.goal {
            GoalRecord::Absorbed => "absorb",
            GoalRecord::Collected { .. } => "collect",
            GoalRecord::Skimmed => "skim",
            GoalRecord::Polished { .. } => "polish",
            GoalRecord::Dispensed { .. } => "dispense",
        };
        for (what, found, expected) in [
            ("action", action, task.action.as_str()),
            ("goal state", goal, task.action.as_str()),
            ("surface", &self.surface, &task.surface.name),
            ("tool", &self.tool, &task.tool.name),
            ("medium", &self.medium, &task.medium),
        ] {
            if found != expected {
                return Err(PlanRecordError::OtherTask {
                    what,
                    found: found.to_owned(),
                    expected: expected.to_owned(),
                });
            }
        }
        let shape = ShapeRecord::from_curved(&task.surface.shape);
        let is_same = match (&self.surface_shape, &shape) {
            (Some(found), Some(expected)) => found.is_same_as(expected),
            (found, expected) => found == expected,
        };
        if !is_same {
            return Err(PlanRecordError::OtherTask {
                what: "surface shape",
                found: self.surface_shape.unwrap_or(ShapeRecord::Plane).to_string(),
                expected: ShapeRecord::from(&task.surface.shape).to_string(),
            });
        }
        Ok(())
    }

    fn check_indices(&self) -> Result<(), PlanRecordError> {
        let nodes = self.nodes.len();
        let check = |place: String, index: usize| {
            if index < nodes {
                return Ok(());
            }
            Err(PlanRecordError::NoSuchNode {
                place,
                index,
                nodes,
            })
        };
        for (i, edge) in self.edges.iter().enumerate() {
            for &index in edge {
                check(format!("edges[{i}]"), index)?;
            }
        }
        for (i, &index) in self.unreachable_nodes.iter().enumerate() {
            check(format!("unreachable_nodes[{i}]"), index)?;
        }
        for (i, stroke) in self.strokes.iter().enumerate() {
            for &index in &stroke.nodes {
                check(format!("strokes[{i}].nodes"), index)?;
            }
            if stroke.nodes.len() != stroke.surface_from_tool.len() {
                return Err(PlanRecordError::PosesPerNode {
                    stroke: i,
                    nodes: stroke.nodes.len(),
                    poses: stroke.surface_from_tool.len(),
                });
            }
        }
        Ok(())
    }

    fn check_numbers(&self) -> Result<(), PlanRecordError> {
        let length =
            |place: &str, value| within(place, value, 0.0..=MAX_COORDINATE, "0 to 10000 m");
        let point = |place: &str, point: [f64; 2]| {
            ["x", "y"]
                .into_iter()
                .zip(point)
                .try_for_each(|(axis, value)| {
                    let limits = -MAX_COORDINATE..=MAX_COORDINATE;
                    within(
                        &format!("{place}: {axis}"),
                        value,
                        limits,
                        "-10000 to 10000 m",
                    )
                })
        };
        length("collision_radius_m", self.collision_radius_m)?;
        length("lift_height_m", self.lift_height_m)?;
        point("tool_start_in_surface_m", self.tool_start_in_surface_m)?;
        if let GoalRecord::Collected {
            center_in_surface_m,
            radius_m,
        } = self.goal
        {
            point("goal.center_in_surface_m", center_in_surface_m)?;
            length("goal.radius_m", radius_m)?;
        }
        for (i, node) in self.nodes.iter().enumerate() {
            point(&format!("nodes[{i}].in_surface_m"), node.in_surface_m)?;
        }
        for (i, stroke) in self.strokes.iter().enumerate() {
            for (j, pose) in stroke.surface_from_tool.iter().enumerate() {
                let place = format!("strokes[{i}].surface_from_tool[{j}]");
                point(&place, [pose.x_m, pose.y_m])?;
                let (place, turns) = (format!("{place}.heading_rad"), -MAX_HEADING..=MAX_HEADING);
                within(&place, pose.heading_rad, turns, "-1e6 to 1e6 rad")?;
            }
        }
        Ok(())
    }
}

fn within(
    place: &str,
    value: f64,
    range: RangeInclusive<f64>,
    limits: &'static str,
) -> Result<(), PlanRecordError> {
    // NaN is not within anything.
    if range.contains(&value) {
        return Ok(());
    }
    Err(PlanRecordError::OutOfRange {
        place: place.to_owned(),
        value,
        limits,
    })
}

/// Splits a message of serde_json from the location at its end.
fn without_place(message: &str) -> &str {
    message
        .rfind(" at line ")
        .map_or(message, |end| &message[..end])
}

fn node_record(node: &Node) -> NodeRecord {
    NodeRecord {
        role: match node.role {
            NodeRole::Coverage => RoleRecord::Coverage,
            NodeRole::Goal => RoleRecord::Goal,
        },
        in_surface_m: node.position.into(),
    }
}

fn node(record: &NodeRecord) -> Node {
    Node {
        position: record.in_surface_m.into(),
        role: match record.role {
            RoleRecord::Coverage => NodeRole::Coverage,
            RoleRecord::Goal => NodeRole::Goal,
        },
    }
}

fn planar_pose_record(pose: &PlanarPose) -> PlanarPoseRecord {
    PlanarPoseRecord {
        x_m: pose.position.x,
        y_m: pose.position.y,
        heading_rad: pose.heading,
    }
}

fn planar_pose(record: &PlanarPoseRecord) -> PlanarPose {
    PlanarPose::new(Point2::new(record.x_m, record.y_m), record.heading_rad)
}

fn waypoint_record(waypoint: &TcpWaypoint) -> WaypointRecord {
    let pose = &waypoint.surface_from_tool;
    WaypointRecord {
        x_m: pose.position.x,
        y_m: pose.position.y,
        height_m: waypoint.height,
        heading_rad: pose.heading,
    }
}
