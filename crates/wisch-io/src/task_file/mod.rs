//! The task file: what the user writes, as typed and checked, and how it becomes a [`Task`].

mod checked;
mod clusters;
mod definitions;
mod deserialize;
mod disturbance;
mod error;
mod execution;
mod execution_tables;
mod outline;
mod resolve;
mod tables;
#[cfg(test)]
mod tests;
mod tree;
mod values;

pub use disturbance::{FrictionChange, Moment, Push};
pub use error::TaskError;
pub use execution::{CameraRecord, DirtRecord, ExecutionRecord, Perception, RealDirt};
pub use resolve::ReadFile;
pub(crate) use resolve::unit_remarks;

use crate::particles::ParticleSource;
use definitions::Definitions;
use wisch::follow::WorkcellConfig;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::plan::HeadingRule;
use wisch::represent::{Action, KnowledgeError, ScenePart, Surface, Task, Treatment};
use wisch::run::{AfterStop, Pace};
use wisch::source_location::Place;

/// The schema that this version reads.
const SCHEMA: u64 = 1;

/// What a task file asks for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Intent {
    /// A certain action.
    Action {
        /// What to do.
        action: Action,
        /// Name of the tool to do it with.
        tool: String,
        /// Name of the medium to do it to.
        medium: String,
    },
    /// A goal, for which action, tool and medium are yet to be found.
    Goal {
        /// A PDDL literal such as `(collected breadcrumbs chopping_board)`.
        literal: String,
        /// Name of the tool that the hand holds already.
        tool_in_hand: Option<String>,
        /// Names of the tools that can be fetched.
        available_tools: Vec<String>,
    },
}

/// Where a robot's description is found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RobotDescription {
    /// One that the program ships.
    Named(String),
    /// Files, as paths relative to the task file.
    Files {
        /// The URDF.
        urdf: String,
        /// The SRDF; `None` looks for one beside the URDF.
        srdf: Option<String>,
    },
}

/// The robot that is to do the task.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotRecord {
    /// Which robot.
    pub description: RobotDescription,
    /// The group of its SRDF that wipes; `None` takes the first.
    pub group: Option<String>,
    /// The group of its SRDF whose hand holds the tool as well; `None` leaves it to one hand.
    pub second_group: Option<String>,
    /// Where it stands, or starts; `None` if the file does not say.
    pub world_from_robot: Option<Pose>,
}

impl RobotRecord {
    /// Which part of the robot wipes, and where the robot stands: where the file says, or else where the task's
    /// scene shows it, facing the surface.
    pub fn workcell_config(&self, task: &Task) -> WorkcellConfig {
        WorkcellConfig {
            group: self.group.clone(),
            second_group: self.second_group.clone(),
            world_from_robot: (self.world_from_robot).or_else(|| task.robot_before_surface()),
            ..WorkcellConfig::default()
        }
    }
}

/// A task file as typed: every key known, every number within its range, every value consistent.
/// What it refers to, knowledge and other files, is looked up by [`TaskFile::resolve`].
#[derive(Debug, Clone, PartialEq)]
pub struct TaskFile {
    name: String,
    seed: u64,
    intent: Intent,
    strategy: Option<String>,
    target_performance: f64,
    tool_at: Place,
    tool_start: Option<Point2>,
    medium_at: Place,
    surface: SurfaceRecord,
    robot: Option<RobotRecord>,
    perception: Perception,
    execution: ExecutionRecord,
    max_rounds: usize,
    end_strokes_early: bool,
    pace: Pace,
    after_stop: AfterStop,
    start_rad: f64,
    collect_goal: Option<Point2>,
    polish: Option<Treatment>,
    emit: Option<Treatment>,
    scene: Vec<ObjectRecord>,
    particles: ParticleSource,
    particles_at: Place,
    bandwidth: Option<f64>,
    heading: HeadingRule,
    lift_height: f64,
    evaluations: usize,
    margin: f64,
    max_distance: Option<f64>,
    contact_speed: f64,
    variants: usize,
    min_score: f64,
    definitions: Definitions,
}

#[derive(Debug, Clone, PartialEq)]
struct SurfaceRecord {
    at: Place,
    surface: Surface,
    /// Index of the scene object whose face the surface is.
    carried_by: Option<usize>,
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

/// In which frame an object's pose is given.
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
    /// What the knowledge base does not have, at the place where the file names it; `elsewhere` is the place of what has none
    /// of its own.
    fn unknown(&self, error: KnowledgeError, elsewhere: &Place) -> TaskError {
        let kind = match &error {
            KnowledgeError::Unknown(unknown) => unknown.kind,
            _ => "",
        };
        let at = match kind {
            "tool" => &self.tool_at,
            "medium" => &self.medium_at,
            "surface" => &self.surface.at,
            _ => elsewhere,
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

    /// Reads a task file's text. `name` is the name under which errors speak of it.
    ///
    /// `settings` override the text, in order: a dotted key, with an index from 0 into an array, and
    /// a TOML value or a bare string, such as `("surface.size_m", "[0.5, 0.3]")`,
    /// `("scene.0.position_m", "[0, 0, 0]")` or `("action", "skim")`. A key that excludes another,
    /// such as `action` and `goal`, replaces it.
    ///
    /// # Errors
    /// A text that is not TOML, an unknown key, or a value that is missing, of the wrong type, out of
    /// range or at odds with another: with file, line and column.
    ///
    /// ```
    /// use wisch_io::TaskFile;
    /// let setting = ("seed".to_owned(), "7".to_owned());
    /// let task = TaskFile::parse("template.toml", TaskFile::TEMPLATE, &[setting])?;
    /// assert_eq!(task.seed(), 7);
    ///
    /// let error = TaskFile::parse("task.toml", "schema = 1\ncolour = 3\n", &[]).unwrap_err();
    /// assert!(error.to_string().starts_with("task.toml:2:1: unknown key \"colour\""));
    /// # Ok::<(), wisch_io::TaskError>(())
    /// ```
    pub fn parse(name: &str, text: &str, settings: &[(String, String)]) -> Result<Self, TaskError> {
        checked::read(&tree::Source::new(name, text, settings))
    }

    /// The JSON Schema of task files, by which editors complete and check keys: every key with its meaning, range
    /// and default.
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

    /// What is asked for.
    pub fn intent(&self) -> &Intent {
        &self.intent
    }

    /// The robot that is to do it, if the file names one.
    pub fn robot(&self) -> Option<&RobotRecord> {
        self.robot.as_ref()
    }

    /// Name of the task.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Seed of everything random in the task; 0 unless given.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Name of the strategy that finds strokes, as typed; `None` leaves it to the program.
    pub fn strategy(&self) -> Option<&str> {
        self.strategy.as_deref()
    }

    /// Name of the target surface in the knowledge base.
    pub fn surface(&self) -> &str {
        &self.surface.surface.name
    }

    /// Bandwidth h of the density estimate [m]; `None` takes it from the particles.
    pub fn bandwidth_m(&self) -> Option<f64> {
        self.bandwidth
    }

    /// How the tool is turned along the strokes of a coverage strategy.
    pub fn heading(&self) -> HeadingRule {
        self.heading
    }

    /// How many plans the strategies adaptive and best try.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// By how much the tool may be off its way and still do what these strategies plan [m].
    pub fn margin_m(&self) -> f64 {
        self.margin
    }

    /// How far the tool may go in contact in a round [m]; `None` as far as it takes.
    pub fn max_distance_m(&self) -> Option<f64> {
        self.max_distance
    }

    /// Fastest the tool moves in contact [m/s].
    pub fn contact_speed_m_per_s(&self) -> f64 {
        self.contact_speed
    }

    /// How high the tool is lifted between strokes [m].
    pub fn lift_height_m(&self) -> f64 {
        self.lift_height
    }

    /// What the robot perceives the dirt by.
    pub fn perception(&self) -> &Perception {
        &self.perception
    }

    /// What a simulated execution is to take for real.
    pub fn execution(&self) -> &ExecutionRecord {
        &self.execution
    }

    /// How the particles are made.
    pub fn particle_source(&self) -> &ParticleSource {
        &self.particles
    }

    /// Whether a round ends amid a stroke that brings nothing any more, `execution.end_strokes_early`.
    pub fn end_strokes_early(&self) -> bool {
        self.end_strokes_early
    }

    /// How far a round goes, `execution.pace`.
    pub fn pace(&self) -> Pace {
        self.pace
    }

    /// What follows where a person or a safety system stopped the robot, `execution.after_stop`.
    pub fn after_stop(&self) -> AfterStop {
        self.after_stop
    }

    /// How far a joint may stand from where a motion begins, `execution.start_rad` [rad or m].
    pub fn start_rad(&self) -> f64 {
        self.start_rad
    }

    /// How many rounds there may be, `execution.max_rounds`.
    pub fn max_rounds(&self) -> usize {
        self.max_rounds
    }

    /// How many plans the prediction chooses from.
    pub fn plan_variants(&self) -> usize {
        self.variants
    }

    /// Least score of a plan that is executed [1].
    pub fn min_score(&self) -> f64 {
        self.min_score
    }

    /// The performance at which the task counts as done, in [0, 1].
    pub fn target_performance(&self) -> f64 {
        self.target_performance
    }
}
