//! Arguments of `interpret`, and the options that describe a log's format.

use super::values::{action_parser, parse_setting};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use std::path::PathBuf;
use wisch::represent::Action;
use wisch_telemetry::{Axes, Clock, OrientationForm, WrenchSign};

/// Arguments of `interpret`.
#[derive(Debug, Args)]
pub struct InterpretArgs {
    /// The log.
    #[command(flatten)]
    pub source: LoggedArgs,
    /// Output folder; the folder of an earlier call is replaced [default: out/TASK-interpreted]
    #[arg(long, help_heading = "Results", value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Also replace an output folder that holds a run's measurements
    #[arg(long, help_heading = "Results")]
    pub force: bool,
    /// Observation of the dirt after the log: a list of dirt locations (.csv), a bag with /wisch/dirt_after such as the log
    /// itself, or a photo by the task's camera
    #[arg(long, alias = "seen", help_heading = "Observation", value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub observation: Option<PathBuf>,
    /// Print one JSON object instead of the summary
    #[arg(long, help_heading = "Results")]
    pub json: bool,
}

/// A log, and the task that the robot executed meanwhile.
#[derive(Debug, Args)]
pub struct LoggedArgs {
    /// Log: a bag (.mcap, .mcap.zstd), a folder with the parts of a bag, or a table (CSV, Parquet, npz; Arrow or Feather with the feature "arrow")
    #[arg(value_name = "LOG", value_hint = ValueHint::AnyPath)]
    pub log: PathBuf,
    /// Task file that was executed
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// Plan that was executed; its goal area applies if the task has no collect.goal_m
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub plan: Option<PathBuf>,
    /// Wiping action that was executed [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser())]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting)]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
    /// Format of the log.
    #[command(flatten)]
    pub reading: LogArgs,
}

/// Format of a log: topics, columns, frames, signs and units.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Log format")]
pub struct LogArgs {
    /// Topic of the tool's pose, and after a colon the field of its messages. With /tf, the field names a frame, to
    /// which /tf, /tf_static and the joints of --urdf must lead [default: the only pose topic]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub pose_topic: Option<String>,
    /// Topic of the force, and after a colon the field of its messages [default: the only wrench topic]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub wrench_topic: Option<String>,
    /// Columns of a table that are not recognised automatically. NAME is t, x, y, z, fx, fy, fz, or for the orientation
    /// qx, qy, qz, qw or rx, ry, rz or roll, pitch, yaw or a, b, c or m0 to m15
    #[arg(long, value_name = "NAME=COLUMN", value_delimiter = ',', value_parser = parse_setting)]
    pub csv_columns: Vec<(String, String)>,
    /// Frame in whose axes the force is expressed: the task's world, the reference frame of the logged poses (log),
    /// the frame whose pose is logged (tool), or the surface [default: as stated in the log, or tool]
    #[arg(long, value_name = "AXES", value_parser = axes_parser())]
    pub wrench_frame: Option<Axes>,
    /// Sign convention: force acting on the tool, or exerted by the tool [default: as stated in the log, or on-tool]
    #[arg(long, value_name = "SIGN", value_parser = sign_parser())]
    pub wrench_sign: Option<WrenchSign>,
    /// Sensor reading without any contact [N], in the sensor's axes; it is subtracted from the measured force first
    #[arg(long, num_args = 3, value_names = AXIS_NAMES, allow_negative_numbers = true, value_parser = parse_finite)]
    pub force_bias: Vec<f64>,
    /// Factor on the measured force after its bias is subtracted
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, value_parser = parse_positive)]
    pub force_scale: Option<f64>,
    /// Mass of the payload behind the force sensor [kg]; its weight, along the world's -z, and its inertia are subtracted
    /// from the force at each pose
    #[arg(long, value_name = "KG", allow_negative_numbers = true, value_parser = parse_not_negative)]
    pub payload_mass: Option<f64>,
    /// Centre of mass of the payload in the logged frame [m]; it affects only torques, which wisch does not read
    /// [default: 0 0 0]
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true, value_parser = parse_finite, requires = "payload_mass")]
    pub payload_centre: Vec<f64>,
    /// Form of the orientations in a table [default: from the column names]
    #[arg(long, value_name = "FORM", value_parser = orientation_parser())]
    pub orientation: Option<OrientationForm>,
    /// Sampling rate of a table without a time column [Hz]
    #[arg(long, value_name = "HZ", value_parser = parse_unit)]
    pub rate: Option<f64>,
    /// Times of a bag's messages: the stamps in their headers, or the times at which they were recorded
    #[arg(long, value_name = "CLOCK", default_value = Clock::Header.as_str(), value_parser = clock_parser())]
    pub time: Clock,
    /// Longest delay of a message or line against the order of times; a longer delay is an error [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 5.0, value_parser = parse_unit)]
    pub reorder_s: f64,
    /// Orientation of the force sensor in the frame whose pose is logged: roll, pitch, yaw [rad]
    /// [default: from the log's transforms]
    #[arg(long, num_args = 3, value_names = TURN_NAMES, allow_negative_numbers = true, value_parser = parse_finite, conflicts_with = "wrench_frame")]
    pub sensor_frame: Vec<f64>,
    /// Name of the frame whose pose is logged, if the log does not state it
    #[arg(long, value_name = "FRAME")]
    pub pose_frame: Option<String>,
    /// Frame of the log's transforms that is the task's world
    #[arg(
        long,
        value_name = "FRAME",
        default_value = "world",
        conflicts_with = "world_from_log"
    )]
    pub world_frame: String,
    /// URDF of the robot: adds the transforms of its fixed joints, and of joints whose positions the log holds
    /// (/joint_states)
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub urdf: Option<PathBuf>,
    /// Unit of force in the log [N] [default: from the table's units, or 1]
    #[arg(long, value_name = "NEWTONS", value_parser = parse_unit)]
    pub force_unit_n: Option<f64>,
    /// Unit of length in the log [m] [default: from the table's units, or 1]
    #[arg(long, value_name = "METRES", value_parser = parse_unit)]
    pub length_unit_m: Option<f64>,
    /// Unit of time in a table [s] [default: from its units or the magnitude of its times]
    #[arg(long, value_name = "SECONDS", value_parser = parse_unit)]
    pub time_unit_s: Option<f64>,
    /// Pose of the tool frame (contact point) in the logged frame: position [m], roll, pitch, yaw [rad]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = parse_finite)]
    pub pose_offset: Vec<f64>,
    /// Pose of the log's reference frame in the task's world: position [m], roll, pitch, yaw [rad]
    /// [default: from the log's transforms, else identity]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = parse_finite)]
    pub world_from_log: Vec<f64>,
    /// Longest gap between samples to interpolate [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 0.1, value_parser = parse_unit)]
    pub max_gap_s: f64,
}

/// Names of the six numbers of a pose.
const POSE_NAMES: [&str; 6] = ["X", "Y", "Z", "ROLL", "PITCH", "YAW"];
/// Names of the three numbers of a force.
const AXIS_NAMES: [&str; 3] = ["FX", "FY", "FZ"];
/// Names of the three numbers of a rotation.
const TURN_NAMES: [&str; 3] = ["ROLL", "PITCH", "YAW"];

fn axes_parser() -> impl TypedValueParser<Value = Axes> {
    PossibleValuesParser::new(Axes::ALL.map(Axes::as_str)).map(|name| {
        let named = Axes::ALL.into_iter().find(|axes| axes.as_str() == name);
        // The parser accepts only these names.
        named.unwrap_or(Axes::Tool)
    })
}

fn sign_parser() -> impl TypedValueParser<Value = WrenchSign> {
    PossibleValuesParser::new(["on-tool", "by-tool"]).map(|name| match name.as_str() {
        "by-tool" => WrenchSign::ByTool,
        _ => WrenchSign::OnTool,
    })
}

fn orientation_parser() -> impl TypedValueParser<Value = OrientationForm> {
    PossibleValuesParser::new(OrientationForm::ALL.map(OrientationForm::as_str)).map(|name| {
        let named = OrientationForm::ALL
            .into_iter()
            .find(|form| form.as_str() == name);
        // The parser accepts only these names.
        named.unwrap_or(OrientationForm::Quaternion)
    })
}

fn clock_parser() -> impl TypedValueParser<Value = Clock> {
    PossibleValuesParser::new(Clock::ALL.map(Clock::as_str)).map(|name| match name.as_str() {
        "log" => Clock::Log,
        _ => Clock::Header,
    })
}

fn parse_unit(text: &str) -> Result<f64, String> {
    let unit = parse_finite(text)?;
    if (UNIT_LIMITS[0]..=UNIT_LIMITS[1]).contains(&unit) {
        Ok(unit)
    } else {
        let [low, high] = UNIT_LIMITS;
        Err(format!("{unit} is outside {low:e} to {high:e}"))
    }
}

/// Limits of a log's units in SI units: wide enough for nanoseconds and kilometres.
const UNIT_LIMITS: [f64; 2] = [1e-9, 1e9];

fn parse_positive(text: &str) -> Result<f64, String> {
    match parse_finite(text)? {
        number if number > 0.0 => Ok(number),
        number => Err(format!("{number} is not above 0")),
    }
}

fn parse_not_negative(text: &str) -> Result<f64, String> {
    match parse_finite(text)? {
        number if number >= 0.0 => Ok(number),
        number => Err(format!("{number} is below 0")),
    }
}

fn parse_finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number) => Err(format!("{number} is not finite")),
        Err(_) => Err("expected a number".to_owned()),
    }
}
