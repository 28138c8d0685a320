//! How a log is to be understood: its topics, frames, signs and units.

use nalgebra::UnitQuaternion;
use wisch::geometry::Pose;
use wisch::robot::JointTransform;

/// Which topic of a bag is meant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TopicChoice {
    /// The only one that holds what is looked for.
    Sole,
    /// A topic; after a colon, the field or child frame in its messages.
    Named(String),
}

/// In whose axes a force is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axes {
    /// The task's world.
    World,
    /// The frame in which the log gives its poses.
    Log,
    /// The frame whose pose the log gives.
    Tool,
    /// The target surface.
    Surface,
    /// The frame that the log names, which its transforms lead to.
    Named,
}

impl Axes {
    /// All that can be given; a frame that the log names is found, not given.
    pub const ALL: [Self; 4] = [Self::World, Self::Log, Self::Tool, Self::Surface];

    /// Its name.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::World => "world",
            Self::Log => "log",
            Self::Tool => "tool",
            Self::Surface => "surface",
            Self::Named => "named",
        }
    }
}

/// How the axes of a force are found out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxesChoice {
    /// As the log says; where it says nothing, those of the tool, as sensors at wrists measure.
    AsLogged,
    /// These.
    Given(Axes),
}

/// Who does the force to whom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WrenchSign {
    /// The surroundings to the tool.
    OnTool,
    /// The tool to the surroundings.
    ByTool,
}

/// How a log is to be understood.
#[derive(Debug, Clone, PartialEq)]
pub struct LogOptions {
    /// Where the pose stands in a bag.
    pub pose_topic: TopicChoice,
    /// Where the force stands in a bag.
    pub wrench_topic: TopicChoice,
    /// What the columns of a table are called that are not called as we do: our name, and the table's.
    pub columns: Vec<(String, String)>,
    /// In whose axes the force is given.
    pub axes: AxesChoice,
    /// Who does it to whom.
    pub sign: WrenchSign,
    /// The log's unit of force [N]; `None` as a table's line of units says, or 1.
    pub force_unit: Option<f64>,
    /// The log's unit of length [m]; `None` as a table's line of units says, or 1.
    pub length_unit: Option<f64>,
    /// A table's unit of time [s]; `None` as its line of units says, or 1.
    pub time_unit: Option<f64>,
    /// The tool, its tool centre point at the origin, in the frame whose pose the log gives.
    pub logged_from_tool: Pose,
    /// How the axes of a force sensor are turned in the frame whose pose the log gives; it stands for the transforms.
    pub logged_from_sensor: Option<UnitQuaternion<f64>>,
    /// Name of the frame whose pose the log gives, where the log does not say it.
    pub pose_frame: Option<String>,
    /// The frame in which the log gives its poses, in the task's world; `None` as the log's transforms say, else the
    /// world itself.
    pub world_from_log: Option<Pose>,
    /// The frame of the log's transforms that is the task's world.
    pub world_frame: String,
    /// The robot's joints: where they are fixed, or the log tells their positions, they lead from frame to frame beside
    /// the log's transforms.
    pub joints: Vec<JointTransform>,
    /// The target surface, for forces in its axes.
    pub world_from_surface: Pose,
    /// Between which times the rarer of pose and force may be interpolated [s].
    pub max_gap: f64,
}

impl Default for LogOptions {
    /// A log in SI units and in the task's world that says what it holds.
    fn default() -> Self {
        Self {
            pose_topic: TopicChoice::Sole,
            wrench_topic: TopicChoice::Sole,
            columns: Vec::new(),
            axes: AxesChoice::AsLogged,
            sign: WrenchSign::OnTool,
            force_unit: None,
            length_unit: None,
            time_unit: None,
            logged_from_tool: Pose::identity(),
            logged_from_sensor: None,
            pose_frame: None,
            world_from_log: None,
            world_frame: Axes::World.as_str().to_owned(),
            joints: Vec::new(),
            world_from_surface: Pose::identity(),
            max_gap: 0.1,
        }
    }
}
