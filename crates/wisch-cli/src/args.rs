//! What the user may type.

mod ask;

pub use ask::{AskArgs, EngineArgs, EngineChoice};

use crate::terminal::color_asked_for;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;
use wisch::plan::CoverageStrategy;
use wisch::represent::Action;
use wisch::robot::MapConfig;
use wisch_memory::neem::NeemConfig;
use wisch_telemetry::{Axes, WrenchSign};

/// Plan robotic wiping, predict what it does to the dirt, and follow the plan with a robot.
///
/// A task file says what is to be wiped, where and with what. wisch places the tool's waypoints on
/// the surface, joins them to strokes, and plays the strokes through its model of what a tool does
/// to particles. A robot then follows the strokes: its base is placed, its joints are moved along the
/// tool's line without touching anything, and everything is timed within their limits.
#[derive(Debug, Parser)]
#[command(
    name = "wisch",
    version,
    max_term_width = 100,
    arg_required_else_help = true,
    subcommand_required = true,
    after_help = "\
Examples:
  wisch new board.toml          write a task file with comments to start from
  wisch check board.toml        say in words what it asks for
  wisch run board.toml          wipe until the goal is met, and write out/<task>/report.html

Exit codes: 0 the goal is met, 1 the goal is not met, 2 an error."
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// How to do it.
    #[command(flatten)]
    pub global: GlobalArgs,
}

impl Cli {
    /// Reads the command line; ends the program where it is help that was asked for, or wrong.
    pub fn read() -> Self {
        let command = Self::command().color(match color_asked_for(std::env::args_os()) {
            ColorChoice::Auto => clap::ColorChoice::Auto,
            ColorChoice::Always => clap::ColorChoice::Always,
            ColorChoice::Never => clap::ColorChoice::Never,
        });
        Self::from_arg_matches(&command.get_matches()).unwrap_or_else(|error| error.exit())
    }
}

/// Options of every command.
#[derive(Debug, Args)]
#[command(next_help_heading = "Options of every command")]
pub struct GlobalArgs {
    /// Print nothing but errors, and the object that --json asks for
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// How many threads to work with; the results are the same for any number
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Whether to use colours; NO_COLOR in the environment turns them off as well
    #[arg(
        long,
        global = true,
        value_name = "WHEN",
        default_value = "auto",
        hide_possible_values = false
    )]
    pub color: ColorChoice,
}

/// When to use colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ColorChoice {
    /// On a terminal.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Wipe: plan, predict, follow with the task's robot, execute in a physics world, infer by touch what
    /// was wiped, and wipe again until the goal is met
    #[command(after_help = "\
Examples:
  wisch run board.toml
  wisch run board.toml --robot my_arm.urdf --rounds 2
  wisch run board.toml --set 'execution.surface_tilt_rad=[0.05, 0]' --seed 7
  wisch run board.toml --robot none         without a robot: plan and predict
  wisch run board.toml --json | jq '.rounds[] | {predicted, estimated, true_performance}'

Writes a report with every round, a bag of telemetry per round (round-1.mcap, for Foxglove, Rerun and
ROS 2), rounds.json, and the particles as estimated and as they really are.

Exit codes: 0 the estimated performance reaches the task's target (without a robot: the predicted one),
1 it does not, 2 an error.")]
    Run(WipeArgs),
    /// Follow a plan with a robot: joint trajectories that ROS 2 executes
    #[command(after_help = "\
Examples:
  wisch follow board.toml
  wisch follow board.toml --plan out/board/plan.json --robot my_arm.urdf --group manipulator
  wisch follow board.toml --json | jq '.execution_time_s, .abandoned_nodes'

Writes trajectory.yaml and trajectory.json (moveit_msgs/RobotTrajectory: a JointTrajectory, and a
MultiDOFJointTrajectory for a base that moves), tcp-path.csv and following.json.

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not, 2 an error.")]
    Follow(FollowArgs),
    /// Ask the memory of what was wiped, in Prolog
    #[command(after_help = "\
Examples:
  wisch ask 'low_performance(Action, P)'
  wisch ask \"owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])\"
  wisch ask 'has_data_value(A, performance =< 0.8)' --json
  wisch ask                     line by line, with history and completion
  wisch ask --list              what queries may use

Exit codes: 0 there is an answer, 1 there is none, 2 an error.")]
    Ask(AskArgs),
    /// The Prolog engine of `ask`, begun by it.
    #[command(hide = true)]
    PrologEngine(EngineArgs),
    /// Plan a task, without predicting what the plan does
    #[command(after_help = "\
Examples:
  wisch plan board.toml
  wisch plan board.toml --strategy grid --out plans/board-grid
  wisch plan board.toml --json | jq .distance_in_contact_m")]
    Plan(RunArgs),
    /// Predict what a plan does; without --plan, plan first
    #[command(after_help = "\
Examples:
  wisch predict board.toml
  wisch predict board.toml --plan out/board/plan.json --out out/board-again
  wisch predict board.toml --plan plan.json --json | jq .lost_share

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not, 2 an error.")]
    Predict(PredictArgs),
    /// Say from a log of the tool's pose and force what was wiped, and where the surface really is
    #[command(after_help = "\
Examples:
  wisch interpret wipe.mcap --task board.toml
  wisch interpret wipe.mcap --task board.toml --json | jq '.estimated, .diagnosis'
  wisch interpret bag/ --task board.toml --pose-topic /tf:flange --wrench-topic /ft
  wisch interpret log.csv --task board.toml --csv-columns t=time,x=px --wrench-sign by-tool

A log is a ROS 2 bag (MCAP), a folder with the parts of one, or a table of numbers under a line of
names. A bag that is being written, or whose writer was killed (NAME.mcap.active), is read as far as
it goes. Writes interpretation.json and particles-estimated.csv.

Exit codes: 0 the estimated performance reaches the task's target, 1 it does not, 2 an error.")]
    Interpret(Box<InterpretArgs>),
    /// Show where a tool touches the surface
    #[command(after_help = "\
Examples:
  wisch footprint sponge
  wisch footprint brush --svg brush.svg
  wisch footprint scraper.stl --compression-depth-m 0.002")]
    Footprint(FootprintArgs),
    /// Write a task file with comments to start from
    #[command(after_help = "\
Examples:
  wisch new                     print it
  wisch new board.toml          write it
  wisch new board.toml --force  write over what is there")]
    New(NewArgs),
    /// Check a task and say in words what it asks for
    #[command(after_help = "\
Examples:
  wisch check board.toml
  wisch check board.toml --strategy kde --set plan.bandwidth_m=0.04
  wisch check board.toml --robot arm7 --set 'robot.position_m=[0, -0.45, 0.75]'")]
    Check(CheckArgs),
    /// Look at robots
    #[command(subcommand, arg_required_else_help = true)]
    Robot(RobotCommand),
    /// Look at the memory of episodes: what was wiped, when, and how well it went
    #[command(subcommand, arg_required_else_help = true)]
    Memory(MemoryCommand),
}

/// What to do with a robot.
#[derive(Debug, Subcommand)]
pub enum RobotCommand {
    /// Report what is missing or odd in a robot's URDF
    #[command(after_help = "\
Examples:
  wisch robot check robots/humanoid.urdf
  wisch robot check arm.urdf --package arm_description=../arm_description
  wisch robot check arm.urdf --json | jq '.findings[] | select(.severity == \"warning\")'

Exit codes: 0 fine (notes at most), 1 warnings that matter, 2 no robot can be made of it.")]
    Check(RobotCheckArgs),
    /// Build the capability map of a robot: what its arm can reach, in voxels and directions
    #[command(after_help = "\
Examples:
  wisch robot map humanoid
  wisch robot map my_robot.urdf --group manipulator --out my_robot.reach

The map is used to find where a mobile base should stand. Beside the URDF, with its name and the
ending .reach, it is found by itself; elsewhere, --map names it. It belongs to this very robot: change
the robot, and build it anew.")]
    Map(RobotMapArgs),
}

/// Arguments of `robot map`.
#[derive(Debug, Args)]
pub struct RobotMapArgs {
    /// A robot that is shipped, or a URDF
    #[arg(value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: String,
    /// The group of the robot's SRDF that reaches [default: the first]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Edge of a voxel [m], 0.001 to 10
    #[arg(long, value_name = "METRES", default_value_t = MapConfig::default().voxel, allow_negative_numbers = true)]
    pub voxel_m: f64,
    /// Random postures that are looked at
    #[arg(long, value_name = "N", default_value_t = MapConfig::default().samples)]
    pub samples: u64,
    /// Where to write it, a file that ends in .reach [default: beside the URDF; of a robot that is
    /// shipped, here]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// Where the files of package://NAME are; may be given more than once
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `robot check`.
#[derive(Debug, Args)]
pub struct RobotCheckArgs {
    /// The robot's URDF; xacro files are to be expanded first
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Where the files of package://NAME are; may be given more than once
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Which task, and what to change about it.
#[derive(Debug, Args)]
pub struct TaskArgs {
    /// The task file
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// How to place the waypoints [default: the task's]
    #[arg(long, value_name = "STRATEGY", value_parser = strategy_parser())]
    pub strategy: Option<CoverageStrategy>,
    /// What to do to the dirt [default: the task's]
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
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct WipeArgs {
    /// What is followed.
    #[command(flatten)]
    pub follow: FollowArgs,
    /// The rounds.
    #[command(flatten)]
    pub rounds: LoopArgs,
}

/// How the closed loop runs.
#[derive(Debug, Args)]
#[command(next_help_heading = "Rounds")]
pub struct LoopArgs {
    /// Most rounds of wiping, looking at the estimate, and wiping again [default: the task's, with
    /// --greedy ten times as many]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: Option<u16>,
    /// Interpret after every stroke; the next is the one that is predicted to gain most
    #[arg(long)]
    pub greedy: bool,
    /// Go on after the last finished round of a run of the same task into the same folder that was killed
    #[arg(long)]
    pub resume: bool,
    /// Execute no faster than in reality
    #[arg(long)]
    pub realtime: bool,
    /// Where the episode is kept.
    #[command(flatten)]
    pub memory: KeepArgs,
}

/// Where a run is kept as an episode.
#[derive(Debug, Args)]
pub struct KeepArgs {
    /// Folder of the memory to which the run is added as an episode, with telemetry and all that was felt
    #[arg(long, value_name = "DIR", default_value = DEFAULT_MEMORY, value_hint = ValueHint::DirPath)]
    pub memory: PathBuf,
    /// Do not keep the run as an episode
    #[arg(long, conflicts_with = "memory")]
    pub no_memory: bool,
}

/// Which memory is looked into.
#[derive(Debug, Args)]
pub struct MemoryArgs {
    /// Folder of the memory
    #[arg(long, value_name = "DIR", default_value = DEFAULT_MEMORY, value_hint = ValueHint::DirPath)]
    pub memory: PathBuf,
}

/// Where episodes are kept if nothing else is said.
const DEFAULT_MEMORY: &str = "episodes";

/// What to do with a memory of episodes.
#[derive(Debug, Subcommand)]
pub enum MemoryCommand {
    /// List the episodes, oldest first
    #[command(after_help = "\
Examples:
  wisch memory list
  wisch memory list --json | jq 'select(.performance < 0.8) | .id'

With --json, one object per line.")]
    List(MemoryListArgs),
    /// Say what happened in an episode
    #[command(after_help = "\
Examples:
  wisch memory show 20261122-005612-3f2a
  wisch memory show 20261122-005612-3f2a --json | jq '.individuals[] | .class' | sort | uniq -c")]
    Show(EpisodeArgs),
    /// Interpret a log of the tool's pose and force, and add it to the memory as an episode
    #[command(after_help = "\
Examples:
  wisch memory import wipe.mcap --task board.toml
  wisch memory import log.csv --task board.toml --csv-columns t=time,x=px --start-s 1795308972

The log is read as wisch interpret reads it. Tables and simulated bags often count time from 0: then
--start-s says when it was.")]
    Import(Box<ImportArgs>),
    /// Hold every file of every episode against its check sum, and read it
    #[command(after_help = "\
Exit codes: 0 all is well, 1 something is broken, 2 an error.")]
    Verify(MemoryVerifyArgs),
    /// Forget an episode for good
    Forget(EpisodeArgs),
    /// Write episodes for other programs, as a narrative-enabled episodic memory (NEEM)
    #[command(after_help = "\
Examples:
  wisch memory export --neem neem
  wisch memory export --neem neem 20261122-005612-3f2a --tf-rate-hz 50

The folder has one subfolder for each collection, each a dump that mongorestore and KnowRob read: triples,
annotations, inferred, tf, and wrench, which is our own. Beside them are meta.json and semco.owl.")]
    Export(ExportArgs),
}

/// Arguments of `memory export`.
#[derive(Debug, Args)]
pub struct ExportArgs {
    /// The episodes' names, as `wisch memory list` says them [default: all]
    #[arg(value_name = "ID")]
    pub ids: Vec<String>,
    /// Folder for the NEEM; it must not be there yet
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub neem: PathBuf,
    /// How often the pose of each frame is written [Hz]
    #[arg(long, value_name = "HZ", default_value_t = NeemConfig::default().tf_rate_hz, allow_negative_numbers = true)]
    pub tf_rate_hz: f64,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory list`.
#[derive(Debug, Args)]
pub struct MemoryListArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object per episode in place of the table
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory verify`.
#[derive(Debug, Args)]
pub struct MemoryVerifyArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Which episode.
#[derive(Debug, Args)]
pub struct EpisodeArgs {
    /// The episode's name, as `wisch memory list` says it
    #[arg(value_name = "ID")]
    pub id: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Print one JSON object in place of the report
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `follow`, and of `run` in part.
#[derive(Debug, Args)]
pub struct FollowArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// The plan to follow, a plan.json of an earlier run [default: plan anew]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["strategy"])]
    pub plan: Option<PathBuf>,
    /// The robot.
    #[command(flatten)]
    pub robot: RobotArgs,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Which robot, and what is known of it.
#[derive(Debug, Args)]
#[command(next_help_heading = "Robot")]
pub struct RobotArgs {
    /// A robot that is shipped (humanoid, arm7, arm6), a URDF, or "none" [default: the task's]
    #[arg(long, value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: Option<String>,
    /// The group of the robot's SRDF that wipes [default: the task's, or the first]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// The robot's capability map [default: beside the URDF; without one, places are rated slowly]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub map: Option<PathBuf>,
    /// Where the files of package://NAME are; may be given more than once
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
}

/// Where the results go.
#[derive(Debug, Args)]
pub struct ResultArgs {
    /// Folder for the results; one of an earlier run is replaced [default: out/NAME-OF-THE-TASK]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Print one JSON object in place of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `predict`.
#[derive(Debug, Args)]
pub struct PredictArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// The plan to predict, a plan.json of an earlier run [default: plan anew]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["strategy"])]
    pub plan: Option<PathBuf>,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

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

/// Arguments of `memory import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The log.
    #[command(flatten)]
    pub source: LoggedArgs,
    /// When the log's first sample was taken, in seconds since 1970 (UTC) [default: as the log says]
    #[arg(long, value_name = "SECONDS", value_parser = start_s)]
    pub start_s: Option<f64>,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
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

/// Arguments of `footprint`.
#[derive(Debug, Args)]
pub struct FootprintArgs {
    /// A tool of the knowledge base, or a mesh file (.stl, .obj or .dae)
    #[arg(value_name = "TOOL")]
    pub tool: String,
    /// How deep the tool gives way [m]; needed for a mesh file [default: the tool's]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub compression_depth_m: Option<f64>,
    /// Draw it into this .svg file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub svg: Option<PathBuf>,
    /// Folder with the tools [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub struct NewArgs {
    /// Where to write it [default: standard output]
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: Option<PathBuf>,
    /// Write over a file that is there
    #[arg(long, requires = "file")]
    pub force: bool,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// The robot.
    #[command(flatten)]
    pub robot: RobotArgs,
}

fn strategy_parser() -> impl TypedValueParser<Value = CoverageStrategy> {
    PossibleValuesParser::new(CoverageStrategy::ALL.map(CoverageStrategy::as_str))
        .try_map(|name| name.parse())
}

fn action_parser() -> impl TypedValueParser<Value = Action> {
    PossibleValuesParser::new(Action::ALL.map(Action::as_str)).try_map(|name| name.parse())
}

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

fn start_s(text: &str) -> Result<f64, String> {
    let seconds: f64 = text.parse().map_err(|_| format!("{text:?} is no number"))?;
    if (0.0..LATEST_START_S).contains(&seconds) {
        return Ok(seconds);
    }
    Err(format!("{seconds} is not between 0 and {LATEST_START_S}"))
}

/// The year 2286, the last time whose seconds have ten digits.
const LATEST_START_S: f64 = 1e10;

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

fn setting(text: &str) -> Result<(String, String), String> {
    let (key, value) = text
        .split_once('=')
        .ok_or("it has no \"=\"; write a key of the task file, \"=\" and its value")?;
    if key.trim().is_empty() {
        return Err("there is no key before \"=\"".to_owned());
    }
    Ok((key.trim().to_owned(), value.trim().to_owned()))
}

fn package(text: &str) -> Result<(String, PathBuf), String> {
    match text.split_once('=') {
        Some((name, folder)) if !name.trim().is_empty() && !folder.is_empty() => {
            Ok((name.trim().to_owned(), PathBuf::from(folder)))
        }
        _ => Err("write the package's name, \"=\" and its folder".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn a_setting_splits_at_its_first_equals_sign() {
        assert_eq!(
            setting("goal.literal = (a b=c)"),
            Ok(("goal.literal".to_owned(), "(a b=c)".to_owned()))
        );
        assert!(setting("seed").is_err());
        assert!(setting("=3").is_err());
    }
}
