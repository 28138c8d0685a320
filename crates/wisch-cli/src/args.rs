//! The command line: commands, arguments and help texts.

mod ask;
mod budget;
mod eval;
mod film;
mod fleet;
mod learn;
mod log;
mod memory;
mod present;
mod robot;
mod surface;
mod values;

pub use ask::{AskArgs, EngineChoice};
pub use budget::Budget;
pub use eval::{
    CalibrationArgs, EvalCommand, EvidenceArgs, GoalEvaluationArgs, JournalArgs,
    ScenarioEvaluationArgs, SensesChoice, SweepArgs, Table1Args,
};
pub use film::FilmArgs;
pub use fleet::{MemoryPullArgs, MemoryPushArgs, SelectionArgs};
pub use learn::LearnArgs;
pub use log::{InterpretArgs, LogArgs, LoggedArgs};
pub use memory::{
    DEFAULT_MEMORY, EpisodeArgs, ExportArgs, ImportArgs, KeepArgs, MemoryArgs, MemoryCommand,
    MemoryHealthArgs, MemoryListArgs, MemoryVerifyArgs,
};
pub use present::{options_for, suggest};
pub use robot::{
    RobotCheckArgs, RobotCommand, RobotDoctorArgs, RobotFakeArgs, RobotMapArgs, RobotPushTestArgs,
    RobotSetupArgs,
};
pub use surface::{SurfaceCheckArgs, SurfaceCommand, SurfaceMeshArgs, SurfaceSplitArgs};
use values::{
    action_parser, parse_compression_depth, parse_height, parse_package, parse_seconds,
    parse_setting, parse_share, strategy_parser,
};

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum, ValueHint};
use std::ffi::OsString;
use std::path::PathBuf;
use wisch::plan::Strategy;
use wisch::represent::Action;

/// Plan robotic wiping by its effect on the dirt, execute it, and estimate what was wiped.
///
/// A task file states what to wipe, where and with which tool. wisch plans strokes, and predicts how
/// they move the dirt particles. A robot, real or simulated, then follows the strokes: wisch places its
/// base, plans collision-free joint motion along the tool's path, and times it within the joint limits.
/// From the measured tool poses and forces wisch estimates what was wiped, and wipes again until the
/// goal is met.
///
/// wisch has no safety function: the robot's controller is responsible for emergency stops.
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
  wisch check board.toml        check it and print a summary of the task
  wisch run board.toml          wipe until the goal is met, and write out/<task>/report.html

Exit codes of run: 0 the goal is met, 1 it is not met or not shown to be met, 2 an error. Other commands: 0 success, 2 an error; the help of a command states its own codes."
)]
pub struct Cli {
    /// The command.
    #[command(subcommand)]
    pub command: Command,
    /// Options of every command.
    #[command(flatten)]
    pub global: GlobalArgs,
}

impl Cli {
    /// Parses the command line.
    ///
    /// # Errors
    /// Returns clap's error: a requested help or version text, or a message about an invalid argument.
    pub fn read(args: &[OsString]) -> Result<Self, clap::Error> {
        let command = Self::command().color(match find_color_choice(args.iter().cloned()) {
            ColorChoice::Auto => clap::ColorChoice::Auto,
            ColorChoice::Always => clap::ColorChoice::Always,
            ColorChoice::Never => clap::ColorChoice::Never,
        });
        let matches = command.try_get_matches_from(args)?;
        let read = Self::from_arg_matches(&matches)?;
        present::keep(matches);
        Ok(read)
    }
}

/// Options of every command.
#[derive(Debug, Args)]
#[command(next_help_heading = "Options of every command")]
pub struct GlobalArgs {
    /// Print only errors and the JSON object of --json
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Number of worker threads; results do not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// When to use colours; the environment variable NO_COLOR also turns them off
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
    /// If the output is a terminal.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Wipe: plan, predict, follow with the task's robot, execute in simulation or on a robot, estimate the dirt
    /// that is left, and repeat until the goal is met
    #[command(after_help = "\
Examples:
  wisch run board.toml
  wisch run board.toml --robot my_arm.urdf --rounds 2
  wisch run board.toml --set 'execution.surface_tilt_rad=[0.05, 0]' --seed 7
  wisch run board.toml --robot none         without a robot: plan and predict
  wisch run kitchen                         a goal of several parts: step by step, with several tools
  wisch run board.toml --on ur5e.toml --speed 0.25      on a ROS 2 robot; asks before each round
  wisch run board.toml --json | jq '.rounds[] | {predicted, estimated, true_performance}'

Writes report.html, plan.json and rounds.json; telemetry/: a bag for each round (round-1.mcap, for Foxglove, \
Rerun and ROS 2); trajectories/: joint trajectories and the tool's path; particles/: the estimate and \
the simulator's ground truth; figures/.

With --executor, --on or --live, Ctrl-C and SIGTERM stop the robot and keep the measurements. Without \
these options they end the run at once; --resume continues it after its last completed round.

Exit codes: 0 the goal is met (without a robot: the predicted performance reaches the target), 1 it is not met \
or not shown to be met, 2 an error.")]
    Run(WipeArgs),
    /// Follow a plan with a robot: plan collision-free joint trajectories and write them for ROS 2
    #[command(after_help = "\
Examples:
  wisch follow board.toml
  wisch follow board.toml --plan out/board/plan.json --robot my_arm.urdf --group manipulator
  wisch follow board.toml --json | jq '.execution_time_s, .abandoned_nodes'

Writes into trajectories/: trajectory.json (moveit_msgs/RobotTrajectory: a JointTrajectory, and a \
MultiDOFJointTrajectory for a mobile base; the file is also valid YAML), tcp-path.csv and following.json.

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not or the audit found a fault, \
2 an error.")]
    Follow(FollowArgs),
    /// Open a page in the browser to start runs, watch them live and query the episodes of the memory
    #[command(after_help = "\
Examples:
  wisch studio --open
  wisch studio --memory kitchen/episodes --port 8080
  wisch run chopping-board --live       start a run from a second terminal; the page shows it live

Prints the page's address, which contains a random token. Only this machine can open it unless --host is given. \
Ctrl-C ends the studio and the runs that were started on its page.")]
    Studio(StudioArgs),
    /// Write an episode, a folder of results or a log as one self-contained HTML page
    #[command(after_help = "\
Examples:
  wisch report out/chopping-board
  wisch report 20261122-005612-3f2a --out wiping.html
  wisch report wipe.mcap --task board.toml

The page of a run shows robot, dirt, forces and estimates on one timeline, as `wisch studio` does. The page of a log, \
or of an episode or folder that came from a log, shows the tool's path, the force, the fitted plane and the estimated \
dirt. Both pages open from disk, without a server.")]
    Report(Box<ReportArgs>),
    /// Record the scene of a run as a video
    #[command(after_help = "\
Examples:
  wisch film out/chopping-board
  wisch film 20261122-005612-3f2a --round 2 --speed 2 --out second-round.webm
  wisch film out/chopping-board --size 1920x1080 --browser /opt/chromium/chrome

Needs Chromium, Chrome or Edge, which draws the page of the report without a window. The recording takes as long as the \
film. The button Film of the page records the view that you choose there.")]
    Film(FilmArgs),
    /// Query the episodic memory in Prolog
    #[command(after_help = "\
Examples:
  wisch ask 'low_performance(Action, P)'
  wisch ask \"owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])\"
  wisch ask 'has_data_value(A, performance =< 0.8)' --json
  wisch ask                     interactive prompt with history and completion
  wisch ask --list              list the predicates that queries may call

Exit codes: 0 the query has an answer, 1 it has none, 2 an error.")]
    Ask(AskArgs),
    /// Plan the strokes of a task without predicting their effect
    #[command(after_help = "\
Examples:
  wisch plan board.toml
  wisch plan board.toml --strategy grid --out plans/board-grid
  wisch plan board.toml --explain           compare the plans of all strategies
  wisch plan board.toml --strategy adaptive --budget 2s
  wisch plan board.toml --json | jq .distance_in_contact_m")]
    Plan(PlanArgs),
    /// Predict the effect of a plan; without --plan, make a plan first
    #[command(after_help = "\
Examples:
  wisch predict board.toml
  wisch predict board.toml --plan out/board/plan.json --out out/board-again
  wisch predict board.toml --plan plan.json --json | jq .lost_share

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not, 2 an error.")]
    Predict(PredictArgs),
    /// Estimate the remaining dirt and the true surface pose from logged tool poses and forces
    #[command(after_help = "\
Examples:
  wisch interpret wipe.mcap --task board.toml
  wisch interpret wipe.mcap --task board.toml --json | jq '.estimated, .diagnosis'
  wisch interpret bag/ --task board.toml --pose-topic /tf:flange --wrench-topic /ft
  wisch interpret log.csv --task board.toml --csv-columns t=time,x=px --wrench-sign by-tool
  wisch interpret log.parquet --task board.toml --force-bias 0.3 -1.2 4 --payload-mass 1.1

A log is a ROS 2 bag (MCAP), a folder with the parts of a bag, or a table: text with a header line, \
Parquet or NumPy's npz, recognised by its first bytes. Builds with the feature arrow also read Arrow \
(Feather 2, or a stream). A bag that is still being written, or whose writer was killed \
(NAME.mcap.active), is read up to its last complete message. Writes interpretation.json and \
particles/particles-estimated.csv.

Exit codes: 0 the goal is met, 1 it is not met or not shown to be met, 2 an error.")]
    Interpret(Box<InterpretArgs>),
    /// Learn how tools move dirt from rounds with camera observations before and after wiping
    #[command(after_help = "\
Examples:
  wisch learn out/chopping-board                all rounds of a run
  wisch learn runs/*/telemetry/*.mcap --task board.toml --task table.toml
  wisch learn out/board-* --task board.toml --diff | patch -p1 -d my-knowledge
  wisch learn out/board-* --task board.toml --json | jq '.laws[] | .mu'
  wisch learn --memory episodes --task board.toml           all episodes with camera observations
  wisch learn --episode 20261122-005612-3f2a --task board.toml

Bags and episodes hold camera observations from before and after each round if the task's senses \
(perception.senses) include sight. The bags of a run and its episode hold the same data: give only one of \
them. Writes learned.toml: the interactions of the knowledge base with mu, sigma, their standard deviations, and \
the travel distance after which the model draws a particle's threshold again.

Exit codes: 0 at least one interaction was learned, 2 an error.")]
    Learn(LearnArgs),
    /// Show a tool's footprint: the area in which it touches the surface
    #[command(after_help = "\
Examples:
  wisch footprint sponge
  wisch footprint brush --svg brush.svg
  wisch footprint scraper.stl --compression-depth-m 0.002")]
    Footprint(FootprintArgs),
    /// Write a commented task file to start from
    #[command(after_help = "\
Examples:
  wisch new                     print the file
  wisch new board.toml          write it to board.toml
  wisch new goal.toml --goal    write a task with a goal of several parts
  wisch new board.toml --force  overwrite an existing board.toml")]
    New(NewArgs),
    /// List the shipped scenarios; commands accept their names in place of a task file
    #[command(after_help = "\
Examples:
  wisch scenarios
  wisch run chopping-board
  wisch scenarios chopping-board > board.toml    copy a scenario to edit it
  wisch scenarios car-door --out door            the same with the mesh that it names")]
    Scenarios(ScenariosArgs),
    /// Print the JSON Schema of task files, with which editors complete and check keys
    #[command(after_help = "\
Examples:
  wisch schema > wisch-task.schema.json
  wisch schema | jq '.properties | keys'

An editor with a TOML plug-in (Taplo, Even Better TOML) reads the schema named in a task file's first line:
  #:schema wisch-task.schema.json")]
    Schema(SchemaArgs),
    /// Print a shell completion script for wisch
    #[command(after_help = "\
Examples:
  wisch completions bash > ~/.local/share/bash-completion/completions/wisch
  wisch completions zsh > ~/.zfunc/_wisch
  wisch completions fish > ~/.config/fish/completions/wisch.fish")]
    Completions(CompletionsArgs),
    /// Write the manual pages into a folder
    #[command(after_help = "\
Examples:
  wisch man ~/.local/share/man/man1
  man wisch-run")]
    Man(ManArgs),
    /// Check a task and print a summary of it
    #[command(after_help = "\
Examples:
  wisch check board.toml
  wisch check board.toml --strategy kde --set plan.bandwidth_m=0.04
  wisch check board.toml --robot arm7 --set 'robot.position_m=[0, -0.45, 0.75]'

Exit codes: 0 the task is valid, 1 the score of its plan is below plan.min_score or the robot reaches no stroke, 2 an error.")]
    Check(CheckArgs),
    /// Set up, check and map a robot; test and simulate a robot that speaks ROS 2
    #[command(subcommand, arg_required_else_help = true)]
    Robot(RobotCommand),
    /// Check whether a mesh is usable as a curved surface, or divide it into patches
    #[command(subcommand, arg_required_else_help = true)]
    Surface(SurfaceCommand),
    /// Evaluate planning, wiping and estimation in many simulated worlds
    #[command(subcommand, arg_required_else_help = true)]
    Eval(EvalCommand),
    /// List, show, import, verify, export and exchange the episodes of the memory
    #[command(subcommand, arg_required_else_help = true)]
    Memory(MemoryCommand),
}

/// A task file and overrides of its values.
#[derive(Debug, Clone, Args)]
pub struct TaskArgs {
    /// Task file, or name of a shipped scenario
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// Strategy that plans the strokes: a coverage strategy (grid, rrt, kde), a search (adaptive), parallel strips
    /// for polish and dispense (lanes), or best, which keeps the plan with the highest score [default: the task's]
    #[arg(long, value_name = "STRATEGY", value_parser = strategy_parser())]
    pub strategy: Option<Strategy>,
    /// Wiping action [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser())]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Limit of the search of adaptive and best: a number of plans to try, such as 60000, which gives the same
    /// plan on every machine, or a time, such as 2s, which depends on this machine's speed [default: the task's
    /// plan.evaluations]
    #[arg(long, value_name = "N|TIME")]
    pub budget: Option<Budget>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting)]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
}

impl TaskArgs {
    /// Returns the same arguments with touch as the robot's only sense.
    pub fn touch_only(&self) -> Self {
        let mut args = self.clone();
        let senses = r#"["touch"]"#.to_owned();
        args.settings.push(("perception.senses".to_owned(), senses));
        args
    }
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
pub struct PlanArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// Compare the plans of all strategies by predicted effect, path length and the robot's execution time
    #[arg(long)]
    pub explain: bool,
    /// Plan for the task's particles as if their positions were known exactly, as `wisch eval table1` does. Otherwise
    /// adaptive, best and --explain plan for random draws of the uncertain dirt, as `wisch run` does; grid, rrt and kde
    /// alone always plan for the task's particles
    #[arg(long)]
    pub known_dirt: bool,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct WipeArgs {
    /// Task, plan, robot and results.
    #[command(flatten)]
    pub follow: FollowArgs,
    /// The rounds.
    #[command(flatten)]
    pub rounds: LoopArgs,
}

impl LoopArgs {
    /// Whether another program executes the motions, in place of the built-in simulator.
    pub const fn has_executor(&self) -> bool {
        self.executor.is_some() || self.on.is_some()
    }
}

/// Options of the closed loop.
#[derive(Debug, Args)]
#[command(next_help_heading = "Rounds")]
pub struct LoopArgs {
    /// Maximum number of rounds of wiping and estimating [default: the task's; with --greedy, ten times the
    /// task's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: Option<u16>,
    /// Wipe only the segment with the greatest predicted gain in each round, and estimate after it
    #[arg(long)]
    pub greedy: bool,
    /// Use no camera, even if the task has one: estimate the dirt from tool poses and forces only
    #[arg(long)]
    pub touch_only: bool,
    /// Resume a killed run from its last completed round
    #[arg(long)]
    pub resume: bool,
    /// Simulate in real time instead of as fast as possible
    #[arg(long)]
    pub realtime: bool,
    /// Command that starts an executor in place of the built-in simulator (see docs/executor-protocol.md)
    #[arg(long, value_name = "COMMAND", conflicts_with = "resume")]
    pub executor: Option<String>,
    /// Robot file of a ROS 2 robot that executes the motions (see docs/ros2.md). Needs the companion program wisch-ros2
    #[arg(long, value_name = "ROBOT.toml", value_hint = ValueHint::FilePath, conflicts_with_all = ["resume", "executor"])]
    pub on: Option<PathBuf>,
    /// With --on: share of the planned speed, above 0 and at most 1
    #[arg(long, value_name = "SHARE", requires = "on", default_value_t = 1.0, value_parser = parse_share)]
    pub speed: f64,
    /// With --on: move at this height above the surface [m], without force, in one round; keeps no episode
    #[arg(long, value_name = "METRES", requires = "on", conflicts_with_all = ["rounds", "greedy"], value_parser = parse_height)]
    pub air: Option<f64>,
    /// With --on: do not ask before each round whether the robot may move; the first stop then ends the run
    #[arg(long, requires = "on")]
    pub yes_every_round: bool,
    /// Stop waiting for the executor if for this many seconds it sends no message, makes no progress along its
    /// motion, or sends no "done" after its motion has ended or was stopped
    #[arg(long, value_name = "SECONDS", requires = "executor", default_value_t = 60.0, value_parser = parse_seconds)]
    pub timeout: f64,
    /// Publish the run so that `wisch studio` can show it live; needs a memory
    #[arg(long, conflicts_with = "no_memory")]
    pub live: bool,
    /// Write progress events as JSON lines to this file; "-" is standard output
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub events: Option<PathBuf>,
    /// The memory that keeps the run as an episode.
    #[command(flatten)]
    pub memory: KeepArgs,
}

/// Arguments of `follow`, which `run` shares.
#[derive(Debug, Args)]
pub struct FollowArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// Plan to follow: a plan.json of an earlier run [default: make a new plan]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["strategy"])]
    pub plan: Option<PathBuf>,
    /// The robot.
    #[command(flatten)]
    pub robot: RobotArgs,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Arguments of `studio`.
#[derive(Debug, Args)]
pub struct StudioArgs {
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Open the page in the browser
    #[arg(long)]
    pub open: bool,
    /// Port to listen on; 0 picks a free port
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Address to listen on; 0.0.0.0 listens on all addresses of this machine, so that other machines can connect
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub host: String,
}

/// Arguments of `report`.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Episode of the memory, folder of results, or log (a bag, a folder with a bag, or a table; needs --task)
    #[arg(value_name = "EPISODE|FOLDER|LOG", value_hint = ValueHint::AnyPath)]
    pub what: String,
    /// HTML file to write [default: the name of the episode, folder or log, with .html]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Task file that was executed when the log was recorded
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub task: Option<PathBuf>,
    /// Plan that was executed; its goal area applies if the task has no collect.goal_m
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "task")]
    pub plan: Option<PathBuf>,
    /// Wiping action that was executed [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser(), requires = "task")]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N", requires = "task")]
    pub seed: Option<u64>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting, requires = "task")]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath, requires = "task")]
    pub knowledge: Option<PathBuf>,
    /// Format of the log.
    #[command(flatten)]
    pub reading: LogArgs,
    /// Print one JSON object instead of the name of the file
    #[arg(long, help_heading = "Results")]
    pub json: bool,
}

/// The robot and its files.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Robot")]
pub struct RobotArgs {
    /// Robot: a shipped robot (humanoid, arm7, arm6), a URDF file, or "none" [default: the task's]
    #[arg(long, value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: Option<String>,
    /// SRDF planning group that holds the tool [default: the task's, or the first group]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Capability map for base placement [default: the file beside the URDF; without a map, placement is slow]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub map: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = parse_package)]
    pub packages: Vec<(String, PathBuf)>,
}

/// Options of the results.
#[derive(Debug, Args)]
#[command(next_help_heading = "Results")]
pub struct ResultArgs {
    /// Output folder; only another run may replace the folder of a run [default: out/TASK for a run with a robot,
    /// else out/TASK-planned, -predicted or -followed]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Also replace an output folder that holds a run's measurements
    #[arg(long)]
    pub force: bool,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `predict`.
#[derive(Debug, Args)]
pub struct PredictArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// Plan to predict: a plan.json of an earlier run [default: make a new plan]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["strategy"])]
    pub plan: Option<PathBuf>,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Arguments of `footprint`.
#[derive(Debug, Args)]
pub struct FootprintArgs {
    /// Tool of the knowledge base, or mesh file (.stl, .obj, .dae, .ply or .asc)
    #[arg(value_name = "TOOL")]
    pub tool: String,
    /// Compression depth under nominal force [m]; required for a mesh file [default: the tool's]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true, value_parser = parse_compression_depth)]
    pub compression_depth_m: Option<f64>,
    /// Draw the footprint into this .svg file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub svg: Option<PathBuf>,
    /// Knowledge base: folder with the tools [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub struct NewArgs {
    /// File to write [default: standard output]
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub file: Option<PathBuf>,
    /// Write a task with a goal of several parts: several surfaces and media, and tools in a rack
    #[arg(long)]
    pub goal: bool,
    /// Overwrite an existing file
    #[arg(long, requires = "file")]
    pub force: bool,
    /// Print one JSON object instead of the text
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `schema`.
#[derive(Debug, Args)]
pub struct SchemaArgs {
    /// Print the schema as one line; it is one JSON object either way
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `scenarios`.
#[derive(Debug, Args)]
pub struct ScenariosArgs {
    /// Print this scenario's task file [default: list all scenarios]
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
    /// Write the task file and the files that it names, such as a mesh, to this folder
    #[arg(long, value_name = "FOLDER", value_hint = ValueHint::DirPath, requires = "name")]
    pub out: Option<PathBuf>,
    /// Print one JSON object instead of the text
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// Shell to complete for
    pub shell: clap_complete::Shell,
}

/// Arguments of `man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// Folder to write the pages into
    #[arg(value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,
}

/// Arguments of `check`.
#[derive(Debug, Clone, Args)]
pub struct CheckArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// The robot.
    #[command(flatten)]
    pub robot: RobotArgs,
    /// Print one JSON object instead of the summary
    #[arg(long, help_heading = "Results")]
    pub json: bool,
}

/// Reads `--color` before the command line is parsed, because the parser's own messages need it.
fn find_color_choice(args: impl IntoIterator<Item = OsString>) -> ColorChoice {
    let mut args = args.into_iter().filter_map(|arg| arg.into_string().ok());
    let mut color = ColorChoice::Auto;
    while let Some(arg) = args.next() {
        let value = match arg.strip_prefix("--color") {
            Some("") => args.next(),
            Some(value) => value.strip_prefix('=').map(str::to_owned),
            None => None,
        };
        color = match value.as_deref() {
            Some("always") => ColorChoice::Always,
            Some("never") => ColorChoice::Never,
            _ => color,
        };
    }
    color
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn an_option_of_an_earlier_version_still_works() {
        let line = "wisch interpret log.csv --task board.toml --seen after.csv";
        let matches = Cli::command().try_get_matches_from(line.split(' '));
        let matches = matches.expect("arguments of version 0.2.0");
        let interpret = matches.subcommand_matches("interpret").expect("its name");
        let file = interpret.get_one::<PathBuf>("observation");
        assert_eq!(file, Some(&PathBuf::from("after.csv")));
    }
}
