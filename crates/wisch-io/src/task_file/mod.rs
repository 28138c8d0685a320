//! The task file: its keys and their checks, and its conversion to a [`Task`].

mod carrier;
mod checked;
mod clusters;
mod definitions;
mod deserialize;
mod error;
mod execution;
mod execution_tables;
mod extent;
mod mobility;
mod mount;
mod outline;
mod parts;
mod remarks;
mod resolve;
mod tables;
#[cfg(test)]
mod tests;
mod tree;
mod values;

pub use error::TaskError;
pub use extent::check_tool_extent;
pub(crate) use parts::Parts;
pub use parts::RackTool;
pub use remarks::find_underside_offset;
pub(crate) use remarks::task_remarks;
pub use resolve::ReadFile;

use crate::particles::ParticleSource;
use definitions::Definitions;
use execution_tables::ExecutionTable;
use wisch::follow::WorkcellConfig;
use wisch::geometry::{PartChoice, Point2, Pose, Vector3};
use wisch::represent::{
    Action, KnowledgeError, Mount, ScenePart, SensorModel, Surface, Task, Treatment,
};
use wisch::run::RunConfig;
use wisch::source_location::Place;

/// The schema number that this version supports.
const SCHEMA: u64 = 1;

/// The action or goal of a task file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Intent {
    /// An action.
    Action {
        /// The action.
        action: Action,
        /// Name of the tool.
        tool: String,
        /// Name of the medium.
        medium: String,
    },
    /// A goal, from which action, tool and medium are derived.
    Goal {
        /// A PDDL literal such as `(collected breadcrumbs chopping_board)`.
        literal: String,
        /// Name of the tool in the hand.
        tool_in_hand: Option<String>,
        /// Names of the tools that the robot can fetch.
        available_tools: Vec<String>,
    },
}

/// The source of a robot's description.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RobotDescription {
    /// A shipped robot, by name.
    Named(String),
    /// Files, as paths relative to the task file.
    Files {
        /// The URDF.
        urdf: String,
        /// The SRDF; `None` looks for one beside the URDF.
        srdf: Option<String>,
        /// Folders of ROS packages by name, paths relative to the task file.
        packages: Vec<(String, String)>,
    },
}

/// The robot of a task, as the table `[robot]` states it.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotRecord {
    /// The source of its description.
    pub description: RobotDescription,
    /// SRDF planning group that wipes; `None` takes the first group.
    pub group: Option<String>,
    /// SRDF planning group of a second hand on the tool; `None` for one hand.
    pub second_group: Option<String>,
    /// Pose of its root in the world; of a mobile base, its start pose. `None` if the file states
    /// none.
    pub world_from_robot: Option<Pose>,
}

impl RobotRecord {
    /// Returns the planning groups and the pose of the robot: the file's pose, else that of the scene's robot, facing the
    /// surface.
    pub fn workcell_config(&self, task: &Task) -> WorkcellConfig {
        WorkcellConfig {
            group: self.group.clone(),
            second_group: self.second_group.clone(),
            world_from_robot: (self.world_from_robot).or_else(|| task.robot_before_surface()),
            ..WorkcellConfig::default()
        }
    }
}

/// A checked task file: every key is known, every number within its limits, and all values are consistent.
///
/// [`TaskFile::resolve`] looks up its knowledge entries and reads its files.
#[derive(Debug, Clone)]
pub struct TaskFile {
    /// Name of the task, key `name`.
    pub name: String,
    /// The action or the goal that the file states.
    pub intent: Intent,
    /// Name of the strategy, as typed; `None` uses the program's default.
    pub strategy: Option<String>,
    /// Settings of the stages, without what [`LoadedTask::run`](crate::LoadedTask::run) adds: strategy, robot and camera.
    pub run: RunConfig,
    /// The robot, if the file names one.
    pub robot: Option<RobotRecord>,
    /// Believed model of the robot's camera; `None` for touch only.
    pub camera: Option<SensorModel>,
    /// Source of the believed particles, table `[particles]`.
    pub particles: ParticleSource,
    particles_at: Place,
    tool_at: Place,
    tool_start: Option<Point2>,
    mount: Option<Mount>,
    medium_at: Place,
    surface: SurfaceRecord,
    collect_goal: Option<Point2>,
    polish: Option<Treatment>,
    dispense: Option<Treatment>,
    scene: Vec<ObjectRecord>,
    execution: ExecutionTable,
    definitions: Definitions,
    /// A sentence for each key and value that has another name today, and for edges that have other numbers.
    pub(crate) remarks: Vec<String>,
}

#[derive(Debug, Clone, PartialEq)]
struct SurfaceRecord {
    at: Place,
    /// How the edges are numbered, if not as typed.
    edge_numbers: Option<String>,
    /// The surface; of a mesh, without outline and shape, in the frame of the file.
    surface: Surface,
    mesh: Option<SurfaceMesh>,
    /// Index of the scene object that carries the surface.
    carried_by: Option<usize>,
}

/// The mesh of a surface.
#[derive(Debug, Clone, PartialEq)]
struct SurfaceMesh {
    at: Place,
    file: String,
    scale: f64,
    choice: PartChoice,
    patch: Option<(SurfacePatch, Place)>,
}

/// Why a mesh is not skimmed, and what to do instead.
const NO_SKIM_OF_MESH: &str = "a mesh cannot be skimmed, because its border has no edges that skim_edges could name; choose absorb or collect, or describe the surface with size_m or outline_m";

/// A patch of a divided surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SurfacePatch {
    /// All patches, one after another.
    All,
    /// A patch by its index.
    Indexed(usize),
}

#[derive(Debug, Clone, PartialEq)]
struct ObjectRecord {
    at: Place,
    name: String,
    shape: Shape,
    frame: Frame,
    frame_from_object: Pose,
    part: ScenePart,
}

/// The frame of an object's pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Frame {
    World,
    Surface,
}

/// The form of an object about its own origin [m].
#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Box(Vector3),
    Cylinder { radius: f64, height: f64 },
    Sphere { radius: f64 },
    Capsule { radius: f64, height: f64 },
    Mesh { at: Place, file: String, scale: f64 },
}

impl TaskFile {
    /// Makes the error of a missing knowledge entry, with the location where the file names it. `otherwise`: the location
    /// for kinds of entries without their own.
    fn unknown(&self, error: KnowledgeError, otherwise: &Place) -> TaskError {
        let kind = match &error {
            KnowledgeError::Unknown(unknown) => unknown.kind,
            _ => "",
        };
        let at = match kind {
            "tool" => &self.tool_at,
            "medium" => &self.medium_at,
            "surface" => &self.surface.at,
            _ => otherwise,
        };
        TaskError::Knowledge {
            at: at.clone(),
            error: Box::new(error),
        }
    }
}

impl TaskFile {
    /// An example with every key, its unit, default and range.
    pub const TEMPLATE: &'static str = include_str!("template.toml");

    /// Reads a task file's text. `name`: the file's name in error messages.
    ///
    /// `settings` override the text, in order: a dotted key, with an index from 0 into an array, and
    /// a TOML value or a bare string, such as `("surface.size_m", "[0.5, 0.3]")`,
    /// `("scene.0.position_m", "[0, 0, 0]")` or `("action", "skim")`. A key that excludes another,
    /// such as `action` and `goal`, replaces it.
    ///
    /// # Errors
    /// If the text is not TOML, a key is unknown, or a value is missing, of the wrong type, outside its limits or
    /// inconsistent with another. The error states file, line and column.
    ///
    /// ```
    /// use wisch_io::TaskFile;
    /// let setting = ("seed".to_owned(), "7".to_owned());
    /// let task = TaskFile::parse("template.toml", TaskFile::TEMPLATE, &[setting])?;
    /// assert_eq!(task.run.plan.seed, 7);
    ///
    /// let error = TaskFile::parse("task.toml", "schema = 1\ncolour = 3\n", &[]).unwrap_err();
    /// assert!(error.to_string().starts_with("task.toml:2:1: unknown key \"colour\""));
    /// # Ok::<(), wisch_io::TaskError>(())
    /// ```
    pub fn parse(name: &str, text: &str, settings: &[(String, String)]) -> Result<Self, TaskError> {
        checked::read(&tree::Source::new(name, text, settings))
    }

    /// Reads what a file states beside the tables of the parts of its goal; `None` if the goal has a single part.
    pub(crate) fn parse_parts(
        name: &str,
        text: &str,
        settings: &[(String, String)],
    ) -> Result<Option<Parts>, TaskError> {
        parts::read(&tree::Source::new(name, text, settings))
    }

    /// Returns the JSON Schema of task files: every key with its meaning, limits and default. Editors use it to complete and
    /// check keys.
    ///
    /// ```
    /// let schema: serde_json::Value = serde_json::from_str(&wisch_io::TaskFile::json_schema())?;
    /// assert_eq!(schema["properties"]["seed"]["minimum"], 0);
    /// # Ok::<(), serde_json::Error>(())
    /// ```
    pub fn json_schema() -> String {
        let schema = schemars::schema_for!(tables::TaskTable);
        format!("{:#}\n", schema.as_value())
    }
}
