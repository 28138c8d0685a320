//! Arguments of `eval`.

use super::{setting, strategy_parser};
use clap::{Args, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;
use std::str::FromStr;
use wisch::plan::Strategy;
use wisch_eval::{Axis, TaskCase, Variant, WipingExtent};

/// What is evaluated.
#[derive(Debug, Subcommand)]
pub enum EvalCommand {
    /// Hold what is believed of the effect against what is so, in many simulated worlds that differ from the belief
    #[command(after_help = "\
Examples:
  wisch eval calibration --worlds 27                       a demonstration on seeds 1 to 27
  wisch eval calibration --first-seed 1000 --worlds 500    to choose constants
  wisch eval calibration --first-seed 10000 --worlds 1000 --senses sight --out out/published
  wisch eval calibration --variant 'law known:law_mu=0,law_sigma=0' --variant 'no heap:heap_depth=0' --variant 'one draw:members=1'
  wisch eval calibration --set execution.grains_resist=false    worlds whose grains the tool does not feel
  wisch eval calibration --first-seed 10000 --worlds 1000 --shard 1/4 --out out/published --resume

Writes worlds-*.jsonl (a line per world), and of all the worlds in the folder calibration.json,
calibration.md and reliability.svg. Seeds 1 to 999 are for tests and demonstrations, 1000 to 4999 for
choosing constants, those from 10000 on for figures that are published. See docs/evaluation.md.

Exit codes: 0 all worlds were evaluated, 1 some could not be, 2 an error.")]
    Calibration(CalibrationArgs),
    /// Wipe shipped scenarios, or tasks, over many seeds, each in the world that it describes
    #[command(after_help = "\
Examples:
  wisch eval scenarios failure-human-push --worlds 20      quartiles of what is so after the rounds
  wisch eval scenarios solar-panel-wiper solar-panel-brush --rounds 1 --first-seed 11000 --worlds 50
  wisch eval scenarios chopping-board --touch-only --json

Writes scenarios.json and scenarios.md. Seeds serve what they serve in `wisch eval calibration`.

Exit codes: 0 all runs were evaluated, 1 some could not be, 2 an error.")]
    Scenarios(ScenarioEvaluationArgs),
    /// Make the paper's Table 1 anew: three surfaces, three actions, every strategy, over seeds
    #[command(after_help = "\
Examples:
  wisch eval table1                                        planned without a robot, seeds 1 to 5
  wisch eval table1 --follow --strategies kde,adaptive     and followed by the humanoid
  wisch eval table1 --execute --cells board,table/absorb   through the loop, in the simulated world
  wisch eval table1 --first-seed 1000 --seeds 20 --shard 2/4 --out out/tuned --resume

Writes table1.html (with pictures of the first seed), table1.md, table1.csv and table1.json with the paper's
figures beside ours, runs.csv (a row per run), and runs-*.jsonl, from which --resume and other shards go
on. All but computation_s is the same on any machine, number of threads and shards. Seeds serve what they
serve in `wisch eval calibration`.

Exit codes: 0 all runs were evaluated, 1 some could not be, 2 an error.")]
    Table1(Table1Args),
    /// Wipe a task with each combination of some values of its keys, over seeds
    #[command(after_help = "\
Examples:
  wisch eval sweep chopping-board --set strategy=grid,kde,adaptive --set particles.count=50:200:50
  wisch eval sweep board.toml --set action=absorb,skim --set plan.bandwidth_m=0.02,0.04 --seeds 20
  wisch eval sweep table --execute --set 'perception.senses=[\"touch\"],[\"touch\", \"sight\"]'
  wisch eval sweep table --set plan.max_distance_m=1:4:0.5 --shard 1/2 --out out/ways --resume

Values are as in a task file, apart by commas; BEGINNING:END:STEP is a range. Writes sweep.md (median and
quartiles of each combination), sweep.json, runs.csv (a row per run) and runs-*.jsonl, from which --resume
and other shards go on. All but computation_s is the same on any machine, number of threads and shards.

Exit codes: 0 all runs were evaluated, 1 some could not be, 2 an error.")]
    Sweep(SweepArgs),
}

/// Which part of an evaluation is done now.
#[derive(Debug, Args)]
pub struct JournalArgs {
    /// Evaluate only the I-th of N parts
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub shard: Shard,
    /// Go on where an earlier evaluation of the same ended
    #[arg(long)]
    pub resume: bool,
}

/// How far tasks are taken.
#[derive(Debug, Clone, Copy, Args)]
pub struct ExtentArgs {
    /// Let the task's robot follow the plans
    #[arg(long)]
    follow: bool,
    /// Execute in the simulated world that the task describes, round by round
    #[arg(long, conflicts_with = "follow")]
    execute: bool,
}

impl ExtentArgs {
    /// How far.
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
    /// First seed; the others follow
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
}

/// Arguments of `eval table1`.
#[derive(Debug, Args)]
pub struct Table1Args {
    /// Cells: surfaces (board, table, windshield), actions, or both, such as board/absorb [default: all nine]
    #[arg(long, value_name = "CELL,…", value_delimiter = ',', value_parser = cells)]
    pub cells: Vec<Cells>,
    /// How strokes are found [default: by every strategy]
    #[arg(long, value_name = "STRATEGY,…", value_delimiter = ',', value_parser = strategy_parser())]
    pub strategies: Vec<Strategy>,
    /// The seeds.
    #[command(flatten)]
    pub seeds: SeedArgs,
    /// How far.
    #[command(flatten)]
    pub extent: ExtentArgs,
    /// Also predict plans whose way is no longer than the shortest of the paper's three
    #[arg(long, conflicts_with_all = ["follow", "execute"])]
    pub within_shortest: bool,
    /// Override a value of every task; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Which part.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/table1", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// Print one machine-readable result
    #[arg(long)]
    pub json: bool,
}

/// Cells of Table 1 that one word names.
#[derive(Debug, Clone)]
pub struct Cells(pub Vec<TaskCase>);

fn cells(text: &str) -> Result<Cells, wisch_eval::UnknownCell> {
    TaskCase::named(text).map(Cells)
}

/// Arguments of `eval sweep`.
#[derive(Debug, Args)]
pub struct SweepArgs {
    /// Name of a shipped scenario, or a task file
    #[arg(value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub task: String,
    /// A key of the task and its values; repeatable: all combinations are run
    #[arg(long = "set", value_name = "KEY=VALUE,…", required = true)]
    pub axes: Vec<Axis>,
    /// The seeds.
    #[command(flatten)]
    pub seeds: SeedArgs,
    /// How far.
    #[command(flatten)]
    pub extent: ExtentArgs,
    /// Which part.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/sweep", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// Print one machine-readable result
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `eval scenarios`.
#[derive(Debug, Args)]
pub struct ScenarioEvaluationArgs {
    /// Names of shipped scenarios, or task files
    #[arg(required = true, value_name = "TASK", value_hint = ValueHint::FilePath)]
    pub tasks: Vec<String>,
    /// Number of worlds of each: one for every seed
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub worlds: u64,
    /// Seed of the first world; the others follow
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
    /// Most rounds [default: the task's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100))]
    pub rounds: Option<u64>,
    /// Do not look, whatever senses the tasks have
    #[arg(long)]
    pub touch_only: bool,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/scenarios", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// Print one machine-readable result
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `eval calibration`.
#[derive(Debug, Args)]
pub struct CalibrationArgs {
    /// Number of worlds
    #[arg(long, value_name = "N", default_value_t = 27, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub worlds: u64,
    /// Seed of the first world; the others follow
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub first_seed: u64,
    /// What the robot perceives the effect by
    #[arg(long, value_name = "SENSES", default_value = "touch")]
    pub senses: SensesChoice,
    /// Which part.
    #[command(flatten)]
    pub journal: JournalArgs,
    /// Also score the method with other uncertainties or fewer members, on the same rounds; may be repeated
    #[arg(long, value_name = "NAME:FIELD=VALUE[,…]")]
    pub variant: Vec<Variant>,
    /// Override a value of every task, such as execution.grains_resist=false; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Folder for the results
    #[arg(long, value_name = "DIR", default_value = "out/calibration", value_hint = ValueHint::DirPath)]
    pub out: PathBuf,
    /// Print one machine-readable result
    #[arg(long)]
    pub json: bool,
}

/// What the robot perceives the effect by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SensesChoice {
    /// Poses and forces
    Touch,
    /// These, and a camera that looks before the first round and after each
    Sight,
}

/// A part of the worlds: the `index`-th of `count`, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1.
    pub index: u64,
    /// How many parts there are.
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
