//! How a log is to be understood: its topics, frames, signs and units.

use nalgebra::UnitQuaternion;
use wisch::geometry::{Pose, Vector3};
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

/// What hangs behind a force sensor: the tool and what holds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Payload {
    /// Its mass [kg].
    pub mass: f64,
    /// Its centre of mass in the frame whose pose the log gives [m]. It matters to torques alone.
    pub centre: Vector3,
}

/// Which time of a bag's messages counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// The stamps of their headers; the time of recording where they have none.
    Header,
    /// The time at which they were recorded.
    Log,
}

impl Clock {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Header, Self::Log];

    /// Its name.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Header => "header",
            Self::Log => "log",
        }
    }
}

/// The numbers by which a table states an orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrientationForm {
    /// Quaternion qx, qy, qz, qw.
    Quaternion,
    /// Rotation vector rx, ry, rz [rad]: the axis, as long as the angle.
    RotationVector,
    /// Angles roll, pitch, yaw about the fixed axes x, y, z, in this order [rad].
    RollPitchYaw,
    /// Angles a, b, c about z, then the turned y, then the turned x [°], as KUKA's controllers state them.
    Abc,
    /// Homogeneous matrix m0 to m15, column by column, position in m12 to m14, as libfranka states it.
    Matrix,
}

impl OrientationForm {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Quaternion,
        Self::RotationVector,
        Self::RollPitchYaw,
        Self::Abc,
        Self::Matrix,
    ];

    /// Its name.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Quaternion => "quaternion",
            Self::RotationVector => "rotation-vector",
            Self::RollPitchYaw => "rpy",
            Self::Abc => "abc",
            Self::Matrix => "matrix",
        }
    }
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
    /// Who does it to whom; `None` as the names of a table's columns say, or the surroundings to the tool.
    pub sign: Option<WrenchSign>,
    /// What the sensor shows without any force, in the axes, with the sign and before all else that is done to the force
    /// [N].
    pub force_bias: Option<Vector3>,
    /// Factor on the measured force without its bias [1].
    pub force_scale: Option<f64>,
    /// What the sensor weighs along with the force; gravity is along the world's −z. `None` takes nothing off.
    pub payload: Option<Payload>,
    /// The numbers by which a table states orientations; `None` as the names of its columns say.
    pub orientation: Option<OrientationForm>,
    /// Which time of a bag's messages counts.
    pub clock: Clock,
    /// By how much a message or line may come late and still be put into the order of time [s].
    pub reorder_window: f64,
    /// Samples per second of a table without times [Hz]; it stands for its column of times.
    pub rate: Option<f64>,
    /// The log's unit of force [N]; `None` as a table's units say, or 1.
    pub force_unit: Option<f64>,
    /// The log's unit of length [m]; `None` as a table's units say, or 1.
    pub length_unit: Option<f64>,
    /// A table's unit of time [s]; `None` as its units or the size of its times say.
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
            sign: None,
            force_bias: None,
            force_scale: None,
            payload: None,
            orientation: None,
            clock: Clock::Header,
            reorder_window: 5.0,
            rate: None,
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
