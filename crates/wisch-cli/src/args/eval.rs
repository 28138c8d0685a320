//! Arguments of `eval`.

use super::values::{parse_setting, strategy_parser};
use clap::{Args, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;
use std::str::FromStr;
use wisch::plan::Strategy;
use wisch_eval::{Axis, TaskCase, Variant, WipingExtent};

/// The subcommands of `eval`.
#[derive(Debug, Subcommand)]
pub enum EvalCommand {
    /// Compare estimates with ground truth in many randomised simulated worlds
    #[command(after_help = "\
Examples:
  wisch eval calibration --worlds 27                       a demonstration on seeds 1 to 27
  wisch eval calibration --first-seed 1000 --worlds 500    the seeds for tuning constants
  wisch eval calibration --first-seed 10000 --worlds 1000 --senses sight --out out/published
  wisch eval calibration --variant 'law known:law_mu=0,law_sigma=0' --variant 'no heap:heap_depth=0' --variant 'one draw:members=1'
  wisch eval calibration --set execution.grains_resist=false    worlds whose dirt exerts no force on the tool
  wisch eval calibration --first-seed 10000 --worlds 1000 --shard 1/4 --out out/published --resume

Writes worlds-*.jsonl (a line per world), and from all worlds in the folder calibration.json, \
calibration.md and reliability.svg. Use seeds 1 to 999 for tests and demonstrations, 1000 to 4999 for \
tuning constants, and 10000 and above for published figures. See docs/evaluation.md.

Exit codes: 0 all worlds were evaluated, 1 some worlds failed, 2 an error.")]
    Calibration(CalibrationArgs),
    /// Run shipped scenarios or tasks over many seeds, each in the simulated world that it describes
    #[command(after_help = "\
Examples:
  wisch eval scenarios failure-human-push --worlds 20      quartiles of the true performance
  wisch eval scenarios solar-panel-wiper solar-panel-brush --rounds 1 --first-seed 11000 --worlds 50
  wisch eval scenarios chopping-board --touch-only --json

Writes scenarios.json and scenarios.md. The ranges of seeds are those of `wisch eval calibration`.

Exit codes: 0 all runs were evaluated, 1 some runs failed, 2 an error.")]
    Scenarios(ScenarioEvaluationArgs),
    /// Run a task whose goal has several parts over many seeds, each in the simulated world that it describes
    #[command(after_help = "\
Examples:
  wisch eval goals kitchen --worlds 20                     how many parts are claimed, and really reached
  wisch eval goals kitchen.toml --first-seed 1000 --worlds 100 --shard 1/2 --out out/tuned

Each run is a `wisch run` whose folder of results is removed afterwards. Writes goals.json, goals.md, and \
runs-*.jsonl, which --resume and other shards read. The ranges of seeds are those of `wisch eval calibration`.

Exit codes: 0 all runs were evaluated, 1 some runs failed, 2 an error.")]
    Goals(GoalEvaluationArgs),
    /// Reproduce the paper's Table 1: three surfaces, three actions, every strategy, over seeds
    #[command(after_help = "\
Examples:
  wisch eval table1                                        plan without a robot, seeds 1 to 5
  wisch eval table1 --follow --strategies kde,adaptive     also follow the plans with the humanoid
  wisch eval table1 --execute --cells board,table/absorb   run the whole loop in the simulated world
  wisch eval table1 --first-seed 1000 --seeds 20 --shard 2/4 --out out/tuned --resume

Writes table1.html (with pictures of the first seed), table1.md, table1.csv and table1.json with the paper's \
figures beside those of wisch, runs.csv (a row per run), and runs-*.jsonl, which --resume and other shards \
read. All results but computation_s are the same on any machine and for any number of threads and shards. \
The ranges of seeds are those of `wisch eval calibration`.

Exit codes: 0 all runs were evaluated, 1 some runs failed, 2 an error.")]
    Table1(Table1Args),
    /// Run a task with every combination of the given values of its keys, over seeds
    #[command(after_help = "\
Examples:
  wisch eval sweep chopping-board --set strategy=grid,kde,adaptive --set particles.count=50:200:50
  wisch eval sweep board.toml --set action=absorb,skim --set plan.bandwidth_m=0.02,0.04 --seeds 20
  wisch eval sweep table --execute --set 'perception.senses=[\"touch\"],[\"touch\", \"sight\"]'
  wisch eval sweep table --set plan.max_distance_m=1:4:0.5 --shard 1/2 --out out/ways --resume

Write values as in a task file, separated by commas; BEGINNING:END:STEP is a range. Writes sweep.md (median and \
quartiles of each combination), sweep.json, runs.csv (a row per run) and runs-*.jsonl, which --resume and \
other shards read. All results but computation_s are the same on any machine and for any number of threads \
and shards.

Exit codes: 0 all runs were evaluated, 1 some runs failed, 2 an error.")]
    Sweep(SweepArgs),
}

/// The part of an evaluation to do in this call.
#[derive(Debug, Args)]
pub struct JournalArgs {
    /// Evaluate only the I-th of N parts
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub shard: Shard,
    /// Resume an interrupted evaluation that had the same arguments
    #[arg(long)]
    pub resume: bool,
}

/// The evidence of an evaluation.
#[derive(Debug, Args)]
pub struct EvidenceArgs {
    /// When the evaluation is complete, also write its figures to this file, with the command, seeds, commit, date and
    /// machine; run the command at the root of a checkout of this repository
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub evidence: Option<PathBuf>,
}

/// The last stage to which tasks are taken.
#[derive(Debug, Clone, Copy, Args)]
pub struct ExtentArgs {
    /// Follow the plans with the task's robot
    #[arg(long)]
    follow: bool,
    /// Run the whole loop, round by round, in the simulated world that the task describes
    #[arg(long, conflicts_with = "follow")]
    execute: bool,
}

impl ExtentArgs {
    /// Returns the last stage.
    pub const fn extent(self) -> WipingExtent {
        match self {
            Self { execute: true, .. } => WipingExtent::Executed,
            Self { follow: true, .. } => WipingExtent::Followed,
            Self { .. } => WipingExtent::Planned,
        }
    }
}

/// The seeds of an evaluation.
#[derive(Debug, Args)]
pub struct SeedArgs {
    /// Number of seeds
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub seeds: u64,
    /// First seed; the next seeds count up from it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
}

/// Arguments of `eval table1`.
#[derive(Debug, Args)]
pub struct Table1Args {
    /// Cells of the table: surfaces (board, table, windshield), actions, or SURFACE/ACTION, such as board/absorb
    /// [default: all nine]
    #[arg(long, value_name = "CELL,…", value_delimiter = ',', value_parser = parse_cells)]
    pub cells: Vec<Cells>,
    /// Strategies that plan the strokes [default: all that suit these actions, thus not lanes]
    #[arg(long, value_name = "STRATEGY,…", value_delimiter = ',', value_parser = strategy_parser())]
    pub strategies: Vec<Strategy>,
    /// The seeds.
    #[command(flatten)]
    pub seeds: SeedArgs,
    /// The last stage.
    #[command(flatten)]
    pub extent: ExtentArgs,
    /// Also evaluate plans whose path is at most as long as the shortest path of the paper's three strategies
    #[arg(long, conflicts_with_all = ["follow", "execute"])]
    pub within_shortest: bool,
    /// Override a value of every task; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting)]
    pub settings: Vec<(String, String)>,
    /// The part to do.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/table1", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// The evidence.
    #[command(flatten)]
    pub evidence: EvidenceArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Cells of Table 1 that one word of the command line names.
#[derive(Debug, Clone)]
pub struct Cells(pub Vec<TaskCase>);

fn parse_cells(text: &str) -> Result<Cells, wisch_eval::UnknownCell> {
    TaskCase::parse(text).map(Cells)
}

/// Arguments of `eval sweep`.
#[derive(Debug, Args)]
pub struct SweepArgs {
    /// Name of a shipped scenario, or a task file
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: String,
    /// Key of the task and its values; repeatable, all combinations are run
    #[arg(long = "set", value_name = "KEY=VALUE,…", required = true)]
    pub axes: Vec<Axis>,
    /// The seeds.
    #[command(flatten)]
    pub seeds: SeedArgs,
    /// The last stage.
    #[command(flatten)]
    pub extent: ExtentArgs,
    /// The part to do.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/sweep", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// The evidence.
    #[command(flatten)]
    pub evidence: EvidenceArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `eval scenarios`.
#[derive(Debug, Args)]
pub struct ScenarioEvaluationArgs {
    /// Names of shipped scenarios, or task files
    #[arg(required = true, value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub tasks: Vec<String>,
    /// Number of worlds for each task; each world has its own seed
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub worlds: u64,
    /// Seed of the first world; the next worlds count up from it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
    /// Maximum number of rounds [default: the task's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100))]
    pub rounds: Option<u64>,
    /// Use no camera, even if the tasks have one
    #[arg(long)]
    pub touch_only: bool,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/scenarios", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// The evidence.
    #[command(flatten)]
    pub evidence: EvidenceArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `eval goals`.
#[derive(Debug, Args)]
pub struct GoalEvaluationArgs {
    /// Name of a shipped scenario whose goal has several parts, or such a task file
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: String,
    /// Number of worlds; each has its own seed
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub worlds: u64,
    /// Seed of the first world; the next worlds count up from it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
    /// Use no camera, even if the task has one
    #[arg(long)]
    pub touch_only: bool,
    /// The part to do.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/goals", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// The evidence.
    #[command(flatten)]
    pub evidence: EvidenceArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `eval calibration`.
#[derive(Debug, Args)]
pub struct CalibrationArgs {
    /// Number of worlds
    #[arg(long, value_name = "N", default_value_t = 27, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub worlds: u64,
    /// Seed of the first world; the next worlds count up from it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
    /// Senses with which the robot perceives the effect
    #[arg(long, value_name = "SENSES", default_value = "touch")]
    pub senses: SensesChoice,
    /// The part to do.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Also score the estimator with other uncertainties or fewer members of the belief, on the same
    /// rounds; repeatable
    #[arg(long, value_name = "NAME:FIELD=VALUE[,…]")]
    pub variant: Vec<Variant>,
    /// Override a value of every task, such as execution.grains_resist=false; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting)]
    pub settings: Vec<(String, String)>,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/calibration", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// The evidence.
    #[command(flatten)]
    pub evidence: EvidenceArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// The robot's senses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SensesChoice {
    /// Tool poses and forces
    Touch,
    /// Touch, and a camera that observes the dirt before the first round and after each round
    Sight,
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}-of-{}", self.index, self.count)
    }
}

/// One of `count` equal parts of an evaluation, as typed: `I/N`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Number of this part, from 1 to `count`.
    pub index: u64,
    /// Number of parts.
    pub count: u64,
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((index, count)) if (1..=count).contains(&index) => Ok(Self { index, count }),
            _ => Err("expected I/N with 1 <= I <= N, such as 2/4".to_owned()),
        }
    }
}
