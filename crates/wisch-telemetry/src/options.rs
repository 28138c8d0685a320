//! Options for reading a log: its topics, frames, signs and units.

use nalgebra::UnitQuaternion;
use wisch::geometry::{Pose, Vector3};
use wisch::robot::JointTransform;

/// How the topic of a quantity is chosen in a bag.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TopicChoice {
    /// The only topic that holds the quantity.
    Sole,
    /// A named topic; after a colon, the field or child frame in its messages.
    Named(String),
}

/// Axes in which a force is stated.
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
    /// The frame that the log names, and that its transforms connect to the poses.
    Named,
}

impl Axes {
    /// All axes that an option can state; [`Self::Named`] is found in the log only.
    pub const ALL: [Self; 4] = [Self::World, Self::Log, Self::Tool, Self::Surface];

    /// Its name on the command line.
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

/// How the axes of a force are determined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxesChoice {
    /// As the log states; otherwise the axes of the tool, in which wrist sensors measure.
    AsLogged,
    /// The given axes.
    Given(Axes),
}

/// Sign convention of a measured force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WrenchSign {
    /// The force of the surroundings on the tool.
    OnTool,
    /// The force of the tool on the surroundings.
    ByTool,
}

/// Payload behind a force sensor: the tool and its holder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Payload {
    /// Its mass \[kg\].
    pub mass: f64,
    /// Centre of mass in the frame whose pose the log states \[m\]. It affects torques only.
    pub centre: Vector3,
}

/// Source of the times of a bag's messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// The stamps in message headers; the time of recording for messages without a stamp.
    Header,
    /// The time of recording.
    Log,
}

impl Clock {
    /// Both clocks, in the order in which help lists them.
    pub const ALL: [Self; 2] = [Self::Header, Self::Log];

    /// Its name on the command line.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Header => "header",
            Self::Log => "log",
        }
    }
}

/// Numbers by which a table states an orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrientationForm {
    /// Quaternion qx, qy, qz, qw.
    Quaternion,
    /// Rotation vector rx, ry, rz \[rad\]: the axis, with the angle as its length.
    RotationVector,
    /// Angles roll, pitch, yaw about the fixed axes x, y, z, in this order \[rad\].
    RollPitchYaw,
    /// Angles a, b, c about z, then the turned y, then the turned x [°], as KUKA's controllers state them.
    Abc,
    /// Homogeneous matrix m0 to m15, column by column, position in m12 to m14, as libfranka states it.
    Matrix,
}

impl OrientationForm {
    /// All forms, in the order in which help lists them.
    pub const ALL: [Self; 5] = [
        Self::Quaternion,
        Self::RotationVector,
        Self::RollPitchYaw,
        Self::Abc,
        Self::Matrix,
    ];

    /// Its name on the command line.
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

/// Options for reading a log: topics, columns, axes, units and corrections.
///
/// ```
/// use wisch_telemetry::{LogOptions, WrenchSign};
/// // A table with 500 rows per second, whose force is that of the tool on the surface.
/// let options = LogOptions {
///     rate: Some(500.0),
///     sign: Some(WrenchSign::ByTool),
///     ..LogOptions::default()
/// };
/// assert_eq!(options.force_unit, None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LogOptions {
    /// Topic of the poses in a bag.
    pub pose_topic: TopicChoice,
    /// Topic of the forces in a bag.
    pub wrench_topic: TopicChoice,
    /// Names of a table's columns that differ from this crate's names: this crate's name, and the table's.
    pub columns: Vec<(String, String)>,
    /// Axes in which the force is stated.
    pub axes: AxesChoice,
    /// Sign convention of the force. `None`: as the names of a table's columns imply, else the force on the tool.
    pub sign: Option<WrenchSign>,
    /// Reading of the sensor without any force, in its own axes and sign, before every other correction \[N\].
    pub force_bias: Option<Vector3>,
    /// Factor on the measured force without its bias \[1\].
    pub force_scale: Option<f64>,
    /// Payload that the sensor carries; gravity is along the world's −z. `None`: no correction.
    pub payload: Option<Payload>,
    /// Numbers by which a table states orientations. `None`: as the names of its columns imply.
    pub orientation: Option<OrientationForm>,
    /// Source of the times of a bag's messages.
    pub clock: Clock,
    /// Largest delay with which a message or line is still sorted in \[s\].
    pub reorder_window: f64,
    /// Sample rate of a table \[Hz\], which replaces its column of times.
    pub rate: Option<f64>,
    /// Unit of force in the log \[N\]. `None`: as a table states its units, else 1.
    pub force_unit: Option<f64>,
    /// Unit of length in the log \[m\]. `None`: as a table states its units, else 1.
    pub length_unit: Option<f64>,
    /// Unit of time in a table \[s\]. `None`: as it states its units, or as the size of its times implies.
    pub time_unit: Option<f64>,
    /// Pose of the tool, with its tool centre point as origin, in the frame whose pose the log states.
    pub logged_from_tool: Pose,
    /// Rotation of a force sensor in the frame whose pose the log states; it takes precedence over transforms.
    pub logged_from_sensor: Option<UnitQuaternion<f64>>,
    /// Name of the frame whose pose the log states, if the log does not name it.
    pub pose_frame: Option<String>,
    /// Pose of the log's reference frame in the task's world. `None`: as the log's transforms state, else the world
    /// itself.
    pub world_from_log: Option<Pose>,
    /// Frame of the log's transforms that is the task's world.
    pub world_frame: String,
    /// Joints of the robot. Fixed joints, and joints whose positions the log states, connect frames beside the log's
    /// transforms.
    pub joints: Vec<JointTransform>,
    /// Pose of the target surface, for forces in its axes.
    pub world_from_surface: Pose,
    /// Largest gap over which the rarer of pose and force is interpolated \[s\].
    pub max_gap: f64,
}

impl Default for LogOptions {
    /// Options for a self-describing log in SI units and in the task's world.
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
