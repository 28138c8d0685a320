//! Arguments of `interpret`, and how a log is to be understood.

use super::{action_parser, setting};
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
    /// Output folder; one of an earlier run is replaced [default: out/NAME-OF-THE-TASK-interpreted]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Replace an output folder that holds what a run measured, too
    #[arg(long)]
    pub force: bool,
    /// What was seen of the dirt after the log: a list of places (.csv), or a photo by the camera of the task's own
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub seen: Option<PathBuf>,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// A log, and what was being done.
#[derive(Debug, Args)]
pub struct LoggedArgs {
    /// Log: a bag (.mcap, .mcap.zstd), a folder with the parts of one, or a table (CSV, Parquet, npz; Arrow or Feather with the feature "arrow")
    #[arg(value_name = "LOG", value_hint = ValueHint::AnyPath)]
    pub log: PathBuf,
    /// Task file of what was executed
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// Plan that was executed; its goal is used if the task names none
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub plan: Option<PathBuf>,
    /// Wiping action that was executed [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser())]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
    /// How the log is to be understood.
    #[command(flatten)]
    pub reading: LogArgs,
}

/// How a log is to be understood.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Log format")]
pub struct LogArgs {
    /// Topic of the tool's pose, and after a colon the field of its messages; of transforms (/tf) any frame that they,
    /// fixed transforms and a URDF's joints lead to [default: the only one]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub pose_topic: Option<String>,
    /// Topic of the force, and after a colon the field [default: the only one]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub wrench_topic: Option<String>,
    /// Column names of a table, where they are not found by themselves: t, x, y, z, fx, fy, fz, and of the orientation
    /// qx, qy, qz, qw or rx, ry, rz or roll, pitch, yaw or a, b, c or m0 to m15
    #[arg(long, value_name = "OURS=THEIRS", value_delimiter = ',', value_parser = setting)]
    pub csv_columns: Vec<(String, String)>,
    /// Frame in whose axes the force is expressed: the task's world, the reference frame of the logged poses (log),
    /// the frame whose pose is logged (tool), or the surface [default: as the log says, or tool]
    #[arg(long, value_name = "AXES", value_parser = axes_parser())]
    pub wrench_frame: Option<Axes>,
    /// Sign convention: force acting on the tool, or exerted by the tool [default: as the log says, or on-tool]
    #[arg(long, value_name = "SIGN", value_parser = sign_parser())]
    pub wrench_sign: Option<WrenchSign>,
    /// What the sensor shows without any force [N]: taken off the measured force before all else, in its own axes
    #[arg(long, num_args = 3, value_names = AXIS_NAMES, allow_negative_numbers = true, value_parser = finite)]
    pub force_bias: Vec<f64>,
    /// Factor on the measured force, its bias taken off
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, value_parser = positive)]
    pub force_scale: Option<f64>,
    /// Mass of what hangs behind the force sensor [kg]: its weight, along the world's -z, is taken off the force as each
    /// pose turns it
    #[arg(long, value_name = "KG", allow_negative_numbers = true, value_parser = not_negative)]
    pub payload_mass: Option<f64>,
    /// Its centre of mass in the logged frame [m]; it matters to torques, which are not read [default: 0 0 0]
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_negative_numbers = true, value_parser = finite, requires = "payload_mass")]
    pub payload_centre: Vec<f64>,
    /// How a table states orientations [default: as its names of columns say]
    #[arg(long, value_name = "FORM", value_parser = orientation_parser())]
    pub orientation: Option<OrientationForm>,
    /// Samples per second of a table without a column of times [Hz]
    #[arg(long, value_name = "HZ", value_parser = unit)]
    pub rate: Option<f64>,
    /// Times of a bag: the stamps in the headers of its messages, or when they were recorded
    #[arg(long, value_name = "CLOCK", default_value = Clock::Header.as_str(), value_parser = clock_parser())]
    pub time: Clock,
    /// By how much messages or lines may come late and still be put into the order of time [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 5.0, value_parser = unit)]
    pub reorder_s: f64,
    /// How the force sensor's axes are turned in the frame whose pose is logged: roll, pitch, yaw [rad]
    /// [default: as the log's transforms say]
    #[arg(long, num_args = 3, value_names = TURN_NAMES, allow_negative_numbers = true, value_parser = finite, conflicts_with = "wrench_frame")]
    pub sensor_frame: Vec<f64>,
    /// Name of the frame whose pose is logged, if the log does not say it
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
    /// URDF of the robot: its joints are transforms, too, if they are fixed or the log tells their positions
    /// (/joint_states)
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub urdf: Option<PathBuf>,
    /// Unit of force in the log [N] [default: as a table's units say, or 1]
    #[arg(long, value_name = "NEWTONS", value_parser = unit)]
    pub force_unit_n: Option<f64>,
    /// Unit of length in the log [m] [default: as a table's units say, or 1]
    #[arg(long, value_name = "METRES", value_parser = unit)]
    pub length_unit_m: Option<f64>,
    /// Unit of time in a table [s] [default: as its units or the size of its times say]
    #[arg(long, value_name = "SECONDS", value_parser = unit)]
    pub time_unit_s: Option<f64>,
    /// Pose of the tool frame (contact point) in the logged frame: position [m], roll, pitch, yaw [rad]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = finite)]
    pub pose_offset: Vec<f64>,
    /// Pose of the frame in which the log gives its poses, in the task's world: position [m], roll, pitch, yaw [rad]
    /// [default: as the log's transforms say, else the world itself]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = finite)]
    pub world_from_log: Vec<f64>,
    /// Longest gap to interpolate [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 0.1, value_parser = unit)]
    pub max_gap_s: f64,
}

/// What six numbers of a pose are.
const POSE_NAMES: [&str; 6] = ["X", "Y", "Z", "ROLL", "PITCH", "YAW"];
/// What three numbers of a force are.
const AXIS_NAMES: [&str; 3] = ["FX", "FY", "FZ"];
/// What three numbers of a turn are.
const TURN_NAMES: [&str; 3] = ["ROLL", "PITCH", "YAW"];

fn axes_parser() -> impl TypedValueParser<Value = Axes> {
    PossibleValuesParser::new(Axes::ALL.map(Axes::as_str)).map(|name| {
        let named = Axes::ALL.into_iter().find(|axes| axes.as_str() == name);
        // The parser lets none but these names pass.
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
        // The parser lets none but these names pass.
        named.unwrap_or(OrientationForm::Quaternion)
    })
}

fn clock_parser() -> impl TypedValueParser<Value = Clock> {
    PossibleValuesParser::new(Clock::ALL.map(Clock::as_str)).map(|name| match name.as_str() {
        "log" => Clock::Log,
        _ => Clock::Header,
    })
}

fn unit(text: &str) -> Result<f64, String> {
    let unit = finite(text)?;
    if (UNIT_LIMITS[0]..=UNIT_LIMITS[1]).contains(&unit) {
        Ok(unit)
    } else {
        let [low, high] = UNIT_LIMITS;
        Err(format!("it is not within {low:e} to {high:e}"))
    }
}

/// From nanoseconds to kilometres: what a unit of a log may be in SI units.
const UNIT_LIMITS: [f64; 2] = [1e-9, 1e9];

fn positive(text: &str) -> Result<f64, String> {
    match finite(text)? {
        number if number > 0.0 => Ok(number),
        _ => Err("it is not above 0".to_owned()),
    }
}

fn not_negative(text: &str) -> Result<f64, String> {
    match finite(text)? {
        number if number >= 0.0 => Ok(number),
        _ => Err("it is below 0".to_owned()),
    }
}

fn finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("it is not finite".to_owned()),
        Err(_) => Err("it is no number".to_owned()),
    }
}
