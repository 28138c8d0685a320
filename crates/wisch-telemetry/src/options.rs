//! How a log is to be understood: its topics, frames, signs and units.

use wisch::geometry::Pose;

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
}

impl Axes {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::World, Self::Log, Self::Tool, Self::Surface];

    /// Its name.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::World => "world",
            Self::Log => "log",
            Self::Tool => "tool",
            Self::Surface => "surface",
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
    /// The log's unit of force [N].
    pub force_unit: f64,
    /// The log's unit of length [m].
    pub length_unit: f64,
    /// A table's unit of time [s].
    pub time_unit: f64,
    /// The tool, its tool centre point at the origin, in the frame whose pose the log gives.
    pub logged_from_tool: Pose,
    /// The frame in which the log gives its poses, in the task's world.
    pub world_from_log: Pose,
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
            force_unit: 1.0,
            length_unit: 1.0,
            time_unit: 1.0,
            logged_from_tool: Pose::identity(),
            world_from_log: Pose::identity(),
            world_from_surface: Pose::identity(),
            max_gap: 0.1,
        }
    }
}
