//! Arguments of `interpret`, and how a log is to be understood.

use super::{action_parser, setting};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use std::path::PathBuf;
use wisch::represent::Action;
use wisch_telemetry::{Axes, WrenchSign};

/// Arguments of `interpret`.
#[derive(Debug, Args)]
pub struct InterpretArgs {
    /// The log.
    #[command(flatten)]
    pub source: LoggedArgs,
    /// Folder for the results; one of an earlier run is replaced [default: out/NAME-OF-THE-TASK-interpreted]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Print one JSON object in place of the summary
    #[arg(long)]
    pub json: bool,
}

/// A log, and what was being done.
#[derive(Debug, Args)]
pub struct LoggedArgs {
    /// The log: a bag (.mcap), a folder with one, or a table
    #[arg(value_name = "LOG", value_hint = ValueHint::AnyPath)]
    pub log: PathBuf,
    /// The task that was being done
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// The plan that was followed; says where to collect, if the task does not
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub plan: Option<PathBuf>,
    /// What was done to the dirt [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser())]
    pub action: Option<Action>,
    /// Seed of everything random [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Change a value of the task file; may be given more than once
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Folder with tools, media, surfaces, interactions and the domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
    /// How the log is to be understood.
    #[command(flatten)]
    pub reading: LogArgs,
}

/// How a log is to be understood.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the log is to be understood")]
pub struct LogArgs {
    /// Topic with the tool's pose, after a colon the field or child frame in it [default: the only one]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub pose_topic: Option<String>,
    /// Topic with the force, after a colon the field in it [default: the only one]
    #[arg(long, value_name = "TOPIC[:FIELD]")]
    pub wrench_topic: Option<String>,
    /// A table's names of columns, where they are not t, x, y, z, qx, qy, qz, qw, fx, fy and fz
    #[arg(long, value_name = "OURS=THEIRS", value_delimiter = ',', value_parser = setting)]
    pub csv_columns: Vec<(String, String)>,
    /// In whose axes the force is given: the task's world, the frame of the logged poses (log), the frame whose
    /// pose is logged (tool), or the surface [default: as the log says, or tool]
    #[arg(long, value_name = "AXES", value_parser = axes_parser())]
    pub wrench_frame: Option<Axes>,
    /// Whether the force is that on the tool or that by the tool
    #[arg(long, value_name = "SIGN", default_value = "on-tool", value_parser = sign_parser())]
    pub wrench_sign: WrenchSign,
    /// The log's unit of force [N]
    #[arg(long, value_name = "NEWTONS", default_value_t = 1.0, value_parser = unit)]
    pub force_unit_n: f64,
    /// The log's unit of length [m]
    #[arg(long, value_name = "METRES", default_value_t = 1.0, value_parser = unit)]
    pub length_unit_m: f64,
    /// A table's unit of time [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 1.0, value_parser = unit)]
    pub time_unit_s: f64,
    /// The task's tool in the frame whose pose is logged: position [m], roll, pitch and yaw [rad]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = finite)]
    pub pose_offset: Vec<f64>,
    /// The frame of the logged poses in the task's world: position [m], roll, pitch and yaw [rad]
    #[arg(long, num_args = 6, value_names = POSE_NAMES, allow_negative_numbers = true, value_parser = finite)]
    pub world_from_log: Vec<f64>,
    /// How long the rarer of pose and force may be unknown and is interpolated [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 0.1, value_parser = unit)]
    pub max_gap_s: f64,
}

/// What six numbers of a pose are.
const POSE_NAMES: [&str; 6] = ["X", "Y", "Z", "ROLL", "PITCH", "YAW"];

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

fn finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("it is not finite".to_owned()),
        Err(_) => Err("it is no number".to_owned()),
    }
}
