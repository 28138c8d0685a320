//! What the user may type.

mod ask;
mod budget;
mod eval;
mod fleet;
mod learn;
mod log;
mod memory;
mod robot;

pub use ask::{AskArgs, EngineChoice};
pub use budget::Budget;
pub use eval::{
    CalibrationArgs, EvalCommand, JournalArgs, ScenarioEvaluationArgs, SensesChoice, SweepArgs,
    Table1Args,
};
pub use fleet::{MemoryPullArgs, MemoryPushArgs, SelectionArgs};
pub use learn::LearnArgs;
pub use log::{InterpretArgs, LogArgs, LoggedArgs};
pub use memory::{
    DEFAULT_MEMORY, EpisodeArgs, ExportArgs, ImportArgs, KeepArgs, MemoryArgs, MemoryCommand,
    MemoryListArgs, MemoryVerifyArgs,
};
pub use robot::{RobotCheckArgs, RobotCommand, RobotMapArgs};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum, ValueHint};
use std::ffi::OsString;
use std::path::PathBuf;
use wisch::plan::Strategy;
use wisch::represent::Action;

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
    /// Reads the command line.
    ///
    /// # Errors
    /// Help that was asked for, or what is wrong with the command line.
    pub fn read(args: &[OsString]) -> Result<Self, clap::Error> {
        let command = Self::command().color(match color_asked_for(args.iter().cloned()) {
            ColorChoice::Auto => clap::ColorChoice::Auto,
            ColorChoice::Always => clap::ColorChoice::Always,
            ColorChoice::Never => clap::ColorChoice::Never,
        });
        let matches = command.try_get_matches_from(args)?;
        Self::from_arg_matches(&matches)
    }
}

/// Options of every command.
#[derive(Debug, Args)]
#[command(next_help_heading = "Options of every command")]
pub struct GlobalArgs {
    /// Print errors only, and the object of --json
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Number of worker threads; results do not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// When to use colours; NO_COLOR in the environment turns them off as well
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
    /// Wipe: plan, predict, follow with the task's robot, execute in simulation, estimate by touch what was
    /// wiped, and wipe again until the goal is met
    #[command(after_help = "\
Examples:
  wisch run board.toml
  wisch run board.toml --robot my_arm.urdf --rounds 2
  wisch run board.toml --set 'execution.surface_tilt_rad=[0.05, 0]' --seed 7
  wisch run board.toml --robot none         without a robot: plan and predict
  wisch run board.toml --json | jq '.rounds[] | {predicted, estimated, true_performance}'

Writes report.html, plan.json and rounds.json; telemetry/: a bag per round (round-1.mcap, for Foxglove,
Rerun and ROS 2); trajectories/: joint trajectories and the tool's path; particles/: as estimated and
as they really are; figures/.

Exit codes: 0 the estimated performance reaches the task's target (without a robot: the predicted one),
1 it does not, 2 an error.")]
    Run(WipeArgs),
    /// Follow a plan with a robot: collision-free joint trajectories for ROS 2
    #[command(after_help = "\
Examples:
  wisch follow board.toml
  wisch follow board.toml --plan out/board/plan.json --robot my_arm.urdf --group manipulator
  wisch follow board.toml --json | jq '.execution_time_s, .abandoned_nodes'

Writes into trajectories/: trajectory.json (moveit_msgs/RobotTrajectory: a JointTrajectory, and a
MultiDOFJointTrajectory for a base that moves; it is YAML too), tcp-path.csv and following.json.

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not, 2 an error.")]
    Follow(FollowArgs),
    /// Begin runs, watch them, and ask about any in the memory, on one page in the browser
    #[command(after_help = "\
Examples:
  wisch studio --open
  wisch studio --memory kitchen/episodes --port 8080
  wisch run chopping-board --live       a run elsewhere, which the page shows while it goes on

Prints the page's address, which holds a random token; only this machine reaches it, unless --host says otherwise.
Ends with Ctrl-C, and the runs that were begun on it with it.")]
    Studio(StudioArgs),
    /// Write an episode, a folder of results, or a log as one page that needs nothing but itself
    #[command(after_help = "\
Examples:
  wisch report out/chopping-board
  wisch report 20261122-005612-3f2a --out wiping.html
  wisch report wipe.mcap --task board.toml

The page of a run shows robot, dirt, forces and estimates on one clock, as `wisch studio` does. The page of a log, and of
what `wisch interpret` and `wisch memory import` made of one, shows path, force, plane and what was wiped. Both open from
a file.")]
    Report(Box<ReportArgs>),
    /// Query the episodic memory in Prolog
    #[command(after_help = "\
Examples:
  wisch ask 'low_performance(Action, P)'
  wisch ask \"owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])\"
  wisch ask 'has_data_value(A, performance =< 0.8)' --json
  wisch ask                     line by line, with history and completion
  wisch ask --list              what queries may use

Exit codes: 0 there is an answer, 1 there is none, 2 an error.")]
    Ask(AskArgs),
    /// Plan the strokes of a task, without predicting their effect
    #[command(after_help = "\
Examples:
  wisch plan board.toml
  wisch plan board.toml --strategy grid --out plans/board-grid
  wisch plan board.toml --explain           the plans of all strategies side by side
  wisch plan board.toml --strategy adaptive --budget 2s
  wisch plan board.toml --json | jq .distance_in_contact_m")]
    Plan(PlanArgs),
    /// Predict the effect of a plan; without --plan, plan first
    #[command(after_help = "\
Examples:
  wisch predict board.toml
  wisch predict board.toml --plan out/board/plan.json --out out/board-again
  wisch predict board.toml --plan plan.json --json | jq .lost_share

Exit codes: 0 the predicted performance reaches the task's target, 1 it does not, 2 an error.")]
    Predict(PredictArgs),
    /// Estimate from logged tool poses and forces what was wiped and where the surface really is
    #[command(after_help = "\
Examples:
  wisch interpret wipe.mcap --task board.toml
  wisch interpret wipe.mcap --task board.toml --json | jq '.estimated, .diagnosis'
  wisch interpret bag/ --task board.toml --pose-topic /tf:flange --wrench-topic /ft
  wisch interpret log.csv --task board.toml --csv-columns t=time,x=px --wrench-sign by-tool
  wisch interpret log.parquet --task board.toml --force-bias 0.3 -1.2 4 --payload-mass 1.1

A log is a ROS 2 bag (MCAP), a folder with the parts of one, or a table: text with a line of names,
Parquet or NumPy's npz, recognised by its first bytes; builds with the feature arrow also read Arrow
(Feather 2, or a stream). A bag that is being written, or whose writer was killed
(NAME.mcap.active), is read as far as it goes. Writes interpretation.json and
particles/particles-estimated.csv.

Exit codes: 0 the estimated performance reaches the task's target, 1 it does not, 2 an error.")]
    Interpret(Box<InterpretArgs>),
    /// Learn how tools move dirt from rounds that were looked at before and after
    #[command(after_help = "\
Examples:
  wisch learn out/chopping-board                the rounds of a run
  wisch learn runs/*/telemetry/*.mcap --task board.toml --task table.toml
  wisch learn out/board-* --task board.toml --diff | patch -p1 -d my-knowledge
  wisch learn out/board-* --task board.toml --json | jq '.laws[] | .mu'
  wisch learn --memory episodes --task board.toml           every episode that was looked at
  wisch learn --episode 20261122-005612-3f2a --task board.toml

A bag and an episode hold what a camera saw before and after each round if the task's robot looks
(perception.senses). The bags of a run and its episode tell the same: give one of them.
Writes learned.toml: the interactions of the knowledge base with mu, sigma, how well they are known, and
the travel after which a grain draws anew.

Exit codes: 0 something was learned, 2 an error.")]
    Learn(LearnArgs),
    /// Show a tool's footprint: where it touches the surface
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
    /// List the shipped scenarios, which every command takes by name in place of a task file
    #[command(after_help = "\
Examples:
  wisch scenarios
  wisch run chopping-board
  wisch scenarios chopping-board > board.toml    to change it")]
    Scenarios(ScenariosArgs),
    /// Print the JSON Schema of task files, by which editors complete and check keys
    #[command(after_help = "\
Examples:
  wisch schema > wisch-task.schema.json
  wisch schema | jq '.properties | keys'

An editor with a TOML plug-in (Taplo, Even Better TOML) follows the first line of a task file:
  #:schema wisch-task.schema.json")]
    Schema,
    /// Print what makes a shell complete the commands and options of wisch
    #[command(after_help = "\
Examples:
  wisch completions bash > ~/.local/share/bash-completion/completions/wisch
  wisch completions zsh > ~/.zfunc/_wisch
  wisch completions fish > ~/.config/fish/completions/wisch.fish")]
    Completions(CompletionsArgs),
    /// Write the manual pages
    #[command(after_help = "\
Examples:
  wisch man ~/.local/share/man/man1
  man wisch-run")]
    Man(ManArgs),
    /// Check a task and say in words what it asks for
    #[command(after_help = "\
Examples:
  wisch check board.toml
  wisch check board.toml --strategy kde --set plan.bandwidth_m=0.04
  wisch check board.toml --robot arm7 --set 'robot.position_m=[0, -0.45, 0.75]'")]
    Check(CheckArgs),
    /// Check a robot's description, and map what it can reach
    #[command(subcommand, arg_required_else_help = true)]
    Robot(RobotCommand),
    /// Evaluate the method over many simulated worlds
    #[command(subcommand, arg_required_else_help = true)]
    Eval(EvalCommand),
    /// List, show, import, verify and export the episodes of the memory
    #[command(subcommand, arg_required_else_help = true)]
    Memory(MemoryCommand),
}

/// Which task, and what to change about it.
#[derive(Debug, Clone, Args)]
pub struct TaskArgs {
    /// The task file
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: PathBuf,
    /// How strokes are found: by a coverage strategy (grid, rrt, kde), by search, or whichever is worth most
    /// [default: the task's]
    #[arg(long, value_name = "STRATEGY", value_parser = strategy_parser())]
    pub strategy: Option<Strategy>,
    /// Wiping action [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser())]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// What the search of adaptive and best may take: a number of plans to try, such as 60000, which makes the
    /// same plan everywhere, or a time, such as 2s, for which the pace here is measured first [default: the
    /// task's plan.evaluations]
    #[arg(long, value_name = "N|TIME")]
    pub budget: Option<Budget>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub knowledge: Option<PathBuf>,
}

impl TaskArgs {
    /// The same of a robot that does not look.
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
    /// List the plan of every strategy: its predicted effect, its way, and how long the task's robot takes
    #[arg(long)]
    pub explain: bool,
    /// Plan for the task's particles as if they were known to lie just there, as `wisch eval table1` does. Without, as `wisch run`
    /// does, the plan is for all places where the dirt may lie: it is longer, and predicted to do less for the one draw
    #[arg(long)]
    pub known_dirt: bool,
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
    /// Maximum number of rounds of wiping and estimating [default: the task's, with --greedy ten times as
    /// many]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: Option<u16>,
    /// Estimate after every stroke, and next wipe the stroke with the greatest predicted gain
    #[arg(long)]
    pub greedy: bool,
    /// Do not look: estimate by touch alone what was wiped, whatever senses the task has
    #[arg(long)]
    pub touch_only: bool,
    /// Resume a killed run from its last completed round
    #[arg(long)]
    pub resume: bool,
    /// Execute in real time instead of as fast as possible
    #[arg(long)]
    pub realtime: bool,
    /// Command that starts an executor (docs/executor-protocol.md), in place of the built-in simulator
    #[arg(long, value_name = "COMMAND", conflicts_with = "resume")]
    pub executor: Option<String>,
    /// Seconds after which an executor is given up that says nothing, makes no progress, or goes on after its end or a stop
    #[arg(long, value_name = "SECONDS", requires = "executor", default_value_t = 60.0, value_parser = seconds)]
    pub timeout: f64,
    /// Let others look on while it runs, as `wisch studio` does; needs a memory. Ctrl-C and SIGTERM end it in order
    #[arg(long, conflicts_with = "no_memory")]
    pub live: bool,
    /// Write progress events as JSON lines to a file, or with "-" to standard output
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub events: Option<PathBuf>,
    /// Where the episode is kept.
    #[command(flatten)]
    pub memory: KeepArgs,
}

/// Arguments of `follow`, and of `run` in part.
#[derive(Debug, Args)]
pub struct FollowArgs {
    /// The task.
    #[command(flatten)]
    pub task: TaskArgs,
    /// Plan to follow, a plan.json of an earlier run [default: plan anew]
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
    /// Port to listen at; 0 takes any that is free
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Address to listen at; 0.0.0.0 listens at all addresses of this machine, where other machines reach it, and prints them
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub host: String,
}

/// Arguments of `report`.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// An episode of the memory, a folder of results, or a log (a bag, a folder with one, or a table; with --task)
    #[arg(value_name = "EPISODE|FOLDER|LOG", value_hint = ValueHint::AnyPath)]
    pub what: String,
    /// The page [default: the name of the episode, folder or log, with .html]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Task file of what was executed, for a log
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub task: Option<PathBuf>,
    /// Plan that was executed; its goal is used if the task names none
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "task")]
    pub plan: Option<PathBuf>,
    /// Wiping action that was executed [default: the task's]
    #[arg(long, value_name = "ACTION", value_parser = action_parser(), requires = "task")]
    pub action: Option<Action>,
    /// Random seed [default: the task's]
    #[arg(long, value_name = "N", requires = "task")]
    pub seed: Option<u64>,
    /// Override a value of the task file; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting, requires = "task")]
    pub settings: Vec<(String, String)>,
    /// Knowledge base: folder with tools, media, surfaces, interactions and PDDL domain [default: built in]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath, requires = "task")]
    pub knowledge: Option<PathBuf>,
    /// How a log is to be understood.
    #[command(flatten)]
    pub reading: LogArgs,
}

/// Which robot, and what is known of it.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Robot")]
pub struct RobotArgs {
    /// Robot: a shipped one (humanoid, arm7, arm6), a URDF, or "none" [default: the task's]
    #[arg(long, value_name = "ROBOT", value_hint = ValueHint::FilePath)]
    pub robot: Option<String>,
    /// Planning group of the SRDF that holds the tool [default: the task's, or the first]
    #[arg(long, value_name = "NAME")]
    pub group: Option<String>,
    /// Capability map for base placement [default: beside the URDF; without one, placement is slow]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub map: Option<PathBuf>,
    /// Folder to which package://NAME resolves; repeatable
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package)]
    pub packages: Vec<(String, PathBuf)>,
}

/// Where the results go.
#[derive(Debug, Args)]
pub struct ResultArgs {
    /// Output folder; that of a run is replaced by a run only [default: out/NAME-OF-THE-TASK, and for less
    /// than a run with a robot out/NAME-planned, -predicted or -followed]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Replace an output folder that holds what a run measured, too
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
    /// Plan to predict, a plan.json of an earlier run [default: plan anew]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["strategy"])]
    pub plan: Option<PathBuf>,
    /// The results.
    #[command(flatten)]
    pub results: ResultArgs,
}

/// Arguments of `footprint`.
#[derive(Debug, Args)]
pub struct FootprintArgs {
    /// Tool of the knowledge base, or a mesh file (.stl, .obj or .dae)
    #[arg(value_name = "TOOL")]
    pub tool: String,
    /// Compression depth under nominal force [m]; required for a mesh file [default: the tool's]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub compression_depth_m: Option<f64>,
    /// Draw the footprint to this .svg file
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
    /// Overwrite an existing file
    #[arg(long, requires = "file")]
    pub force: bool,
}

/// Arguments of `scenarios`.
#[derive(Debug, Args)]
pub struct ScenariosArgs {
    /// Print the task file of this one [default: list them all]
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell
    pub shell: clap_complete::Shell,
}

/// Arguments of `man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// The folder to write them into
    #[arg(value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,
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

fn strategy_parser() -> impl TypedValueParser<Value = Strategy> {
    PossibleValuesParser::new(Strategy::ALL.map(Strategy::as_str)).try_map(|name| name.parse())
}

fn action_parser() -> impl TypedValueParser<Value = Action> {
    PossibleValuesParser::new(Action::ALL.map(Action::as_str)).try_map(|name| name.parse())
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

fn seconds(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "it is no number".to_owned())?;
    if (0.001..=86_400.0).contains(&number) {
        return Ok(number);
    }
    Err("it is not within 0.001 to 86400 s".to_owned())
}

fn package(text: &str) -> Result<(String, PathBuf), String> {
    match text.split_once('=') {
        Some((name, folder)) if !name.trim().is_empty() && !folder.is_empty() => {
            Ok((name.trim().to_owned(), PathBuf::from(folder)))
        }
        _ => Err("write the package's name, \"=\" and its folder".to_owned()),
    }
}

/// What `--color` says, read before the command line is parsed, for the parser's own messages.
fn color_asked_for(args: impl IntoIterator<Item = OsString>) -> ColorChoice {
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
    fn a_setting_splits_at_its_first_equals_sign() {
        assert_eq!(
            setting("goal.literal = (a b=c)"),
            Ok(("goal.literal".to_owned(), "(a b=c)".to_owned()))
        );
        assert!(setting("seed").is_err());
        assert!(setting("=3").is_err());
    }
}
