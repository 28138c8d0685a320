//! Evidence files: published figures, with what is needed to measure them again and to see whether they still hold.

use crate::protocol::SeedUse;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use wisch_io::OutputFile;

/// Schema number of evidence files.
const SCHEMA: u32 = 1;

/// Options that do not change a result; `true` if a value follows.
const LEFT_OUT: [(&str, bool); 9] = [
    ("--evidence", true),
    ("--out", true),
    ("--shard", true),
    ("--threads", true),
    ("--color", true),
    ("--resume", false),
    ("--json", false),
    ("--quiet", false),
    ("-q", false),
];

/// Paths of the repository on which figures of planning and following depend.
pub const PLANNING_CODE: [&str; 8] = [
    "Cargo.lock",
    "crates/wisch/src",
    "crates/wisch-robot/src",
    "crates/wisch-io/src",
    "crates/wisch-eval/src",
    "knowledge",
    "robots",
    "scenarios",
];

/// The path on which figures of execution depend in addition to [`PLANNING_CODE`].
pub const SIMULATION_CODE: &str = "crates/wisch-sim/src";

/// The failure to begin or to write an evidence file.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {message}")]
pub struct EvidenceError {
    /// The file or folder.
    pub path: String,
    /// The problem, with what helps.
    pub message: String,
}

/// A published figure: one cell of a table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PublishedFigure {
    /// Name of the table.
    pub table: String,
    /// Heading of the row.
    pub row: String,
    /// Heading of the column.
    pub column: String,
    /// The value in its unit; not finite, and thus null in the file, if nothing was measured.
    pub value: f64,
    /// The unit, such as `%` or `m`; empty for a count.
    pub unit: &'static str,
    /// Number of decimals that tables show.
    pub decimals: usize,
    /// The interval of the value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval: Option<PublishedInterval>,
    /// Number of measurements behind the value, and their noun in the plural.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub count: Option<(usize, &'static str)>,
    /// The target.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<PublishedTarget>,
}

/// An interval of a published figure, in the unit of its value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PublishedInterval {
    /// What the interval is, such as `quartiles`.
    pub kind: &'static str,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// The target of a published figure, in the unit of its value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PublishedTarget {
    /// Smallest value that meets the target.
    pub at_least: Option<f64>,
    /// Largest value that meets the target.
    pub at_most: Option<f64>,
    /// Who set the target: the paper or the project.
    pub source: &'static str,
    /// Whether the value misses the target; `None` if nothing was measured.
    pub is_missed: Option<bool>,
}

impl PublishedFigure {
    /// Creates a figure in a unit. `place`: table, row and column.
    pub fn from_value(place: [&str; 3], value: f64, unit: &'static str, decimals: usize) -> Self {
        let [table, row, column] = place.map(str::to_owned);
        Self {
            table,
            row,
            column,
            value,
            unit,
            decimals,
            interval: None,
            count: None,
            target: None,
        }
    }

    /// Creates a figure without a unit that counts something.
    pub fn from_count(place: [&str; 3], count: usize) -> Self {
        Self::from_value(place, count as f64, "", 0)
    }

    /// Adds an interval of a kind, given by its two ends in the unit of the value.
    pub fn with_interval(self, kind: &'static str, [low, high]: [f64; 2]) -> Self {
        Self {
            interval: Some(PublishedInterval { kind, low, high }),
            ..self
        }
    }

    /// Adds the number of measurements behind the value, and their noun in the plural.
    pub fn with_count(self, count: usize, noun: &'static str) -> Self {
        Self {
            count: Some((count, noun)),
            ..self
        }
    }

    /// Adds a target: the smallest and the largest value that meet it, and who set it.
    pub fn with_target(self, [at_least, at_most]: [Option<f64>; 2], source: &'static str) -> Self {
        let is_below = at_least.is_some_and(|least| self.value < least);
        let is_above = at_most.is_some_and(|most| self.value > most);
        let is_missed = self.value.is_finite().then_some(is_below || is_above);
        Self {
            target: Some(PublishedTarget {
                at_least,
                at_most,
                source,
                is_missed,
            }),
            ..self
        }
    }
}

/// The code and the machine with which a part of a measurement was made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct MeasuredPart {
    code: CodeState,
    machine: BTreeMap<String, String>,
}

/// The code on which figures depend.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct CodeState {
    commit: String,
    /// Whether all files of the paths were as in the commit.
    is_committed: bool,
    /// Identifiers of the paths in Git: trees of folders, blobs of files.
    paths: BTreeMap<String, String>,
}

/// An evidence file of a measurement that has begun.
pub struct EvidenceFile {
    file: OutputFile,
    name: String,
    code: CodeState,
    machines: BTreeSet<BTreeMap<String, String>>,
}

/// What an evidence file contains.
#[derive(Serialize)]
struct EvidenceRecord<'a> {
    format: &'static str,
    schema: u32,
    name: &'a str,
    /// The program and its arguments, to run at the root of the repository.
    command: Vec<String>,
    seeds: [u64; 2],
    seed_use: &'static str,
    /// Number of cases that were measured, and that failed.
    cases: [usize; 2],
    version: &'static str,
    date: String,
    code: &'a CodeState,
    machines: &'a BTreeSet<BTreeMap<String, String>>,
    figures: &'a [PublishedFigure],
}

impl EvidenceFile {
    /// Begins the evidence file of a measurement. The working directory must be the root of a checkout.
    ///
    /// `code`: the paths on which the figures depend. `journal`: the folder in which a measurement keeps its results, and
    /// the name of the part. Its folder then also keeps the code of each part, so that results of different code are not
    /// mixed.
    ///
    /// # Errors
    /// If the file cannot be written, the working directory is no checkout, the program is older than the code, or the
    /// folder has results of other code.
    pub fn begin(
        path: &Path,
        code: &[&str],
        journal: Option<(&Path, &str)>,
    ) -> Result<Self, EvidenceError> {
        let code = CodeState::read(path, code)?;
        let part = MeasuredPart {
            code: code.clone(),
            machine: describe_machine(),
        };
        let mut machines = BTreeSet::from([part.machine.clone()]);
        if let Some((folder, name)) = journal {
            machines.extend(join_part(folder, name, &part)?);
        }
        Ok(Self {
            file: OutputFile::begin(path).map_err(|e| evidence_error(path, &e.to_string()))?,
            name: path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into(),
            code,
            machines,
        })
    }

    /// Writes the file. `seeds`: first and last seed. `cases`: number of cases that were measured, and that failed.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(
        self,
        seeds: [u64; 2],
        cases: [usize; 2],
        figures: &[PublishedFigure],
    ) -> Result<(), EvidenceError> {
        let [first, last] = seeds;
        let record = EvidenceRecord {
            format: "wisch evidence",
            schema: SCHEMA,
            name: &self.name,
            command: build_command_line(std::env::args()),
            seeds,
            seed_use: SeedUse::classify(first, last - first + 1).as_str(),
            cases,
            version: env!("CARGO_PKG_VERSION"),
            date: jiff::Timestamp::now().strftime("%Y-%m-%d").to_string(),
            code: &self.code,
            machines: &self.machines,
            figures,
        };
        let path = Path::new(&self.name);
        let text = serde_json::to_string_pretty(&record);
        let text = text.map_err(|error| evidence_error(path, &error.to_string()))? + "\n";
        let written = self.file.finish(text.as_bytes());
        written.map_err(|error| evidence_error(path, &error.to_string()))
    }
}

impl CodeState {
    /// Reads the state of paths from the checkout in the working directory.
    fn read(file: &Path, paths: &[&str]) -> Result<Self, EvidenceError> {
        let git = |arguments: &[&str]| {
            let output = Command::new("git").args(arguments).output().ok()?;
            let text = String::from_utf8(output.stdout).ok()?;
            output.status.success().then(|| text.trim().to_owned())
        };
        let no_checkout = || {
            let help = "the working directory is not the root of a checkout of this repository; run the command there";
            evidence_error(file, help)
        };
        if git(&["rev-parse", "--show-prefix"]).is_none_or(|prefix| !prefix.is_empty()) {
            return Err(no_checkout());
        }
        let mut states = BTreeMap::new();
        for path in paths {
            let state = git(&["rev-parse", "--verify", "--quiet", &format!("HEAD:{path}")]);
            states.insert((*path).to_owned(), state.ok_or_else(no_checkout)?);
        }
        let changes = git(&[&["status", "--porcelain", "--"], paths].concat());
        let files = git(&[&["ls-files", "--"], paths].concat()).unwrap_or_default();
        if let Some(newer) = files.lines().find(|file| is_newer_than_program(file)) {
            let message =
                format!("the program is older than {newer}; build it, so that it has this code");
            return Err(evidence_error(file, &message));
        }
        Ok(Self {
            commit: git(&["rev-parse", "--short=12", "HEAD"]).ok_or_else(no_checkout)?,
            is_committed: changes.is_some_and(|changes| changes.is_empty()),
            paths: states,
        })
    }
}

/// Whether a file changed after the program was built. Unit tests and the lock file are no part of the program.
fn is_newer_than_program(file: &str) -> bool {
    let is_apart = file.ends_with("tests.rs") || file.contains("/tests/") || file == "Cargo.lock";
    let changed = |path: &Path| fs::metadata(path).and_then(|of| of.modified()).ok();
    let program = std::env::current_exe().ok().and_then(|path| changed(&path));
    !is_apart && program.is_some_and(|built| changed(Path::new(file)) > Some(built))
}

/// Records the code of a part in the folder of its results, and returns the machines of all parts there.
fn join_part(
    folder: &Path,
    name: &str,
    part: &MeasuredPart,
) -> Result<Vec<BTreeMap<String, String>>, EvidenceError> {
    let failed = |error: &dyn std::fmt::Display| evidence_error(folder, &error.to_string());
    fs::create_dir_all(folder).map_err(|error| failed(&error))?;
    let entries = fs::read_dir(folder).map_err(|error| failed(&error))?;
    let paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    let named = |begin: &str, end: &str| {
        let is_named = |path: &&PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(begin) && name.ends_with(end)
        };
        paths.iter().filter(is_named).cloned().collect::<Vec<_>>()
    };
    let (known, results) = (named("code-", ".json"), named("", ".jsonl"));
    let mut machines = Vec::new();
    for path in &known {
        let text = fs::read_to_string(path).map_err(|error| failed(&error))?;
        let known: MeasuredPart = serde_json::from_str(&text).map_err(|error| failed(&error))?;
        let is_same = known.code.paths == part.code.paths;
        if !(is_same && known.code.is_committed && part.code.is_committed) {
            let message = "the folder has results of other code, or of code that is not committed; choose another folder with --out";
            return Err(evidence_error(folder, message));
        }
        machines.push(known.machine);
    }
    if known.is_empty() && !results.is_empty() {
        let message =
            "the folder has results whose code is unknown; choose another folder with --out";
        return Err(evidence_error(folder, message));
    }
    if !machines.contains(&part.machine) {
        let number = known.len() + 1;
        let path = folder.join(format!("code-{name}-{number}.json"));
        let text = serde_json::to_string_pretty(part).map_err(|error| failed(&error))? + "\n";
        let written = OutputFile::begin(&path).and_then(|file| file.finish(text.as_bytes()));
        written.map_err(|error| failed(&error))?;
    }
    Ok(machines)
}

/// Returns the command line that repeats the measurement: without options that do not change the result.
fn build_command_line(arguments: impl Iterator<Item = String>) -> Vec<String> {
    let mut kept = Vec::new();
    let mut arguments = arguments.peekable();
    if let Some(program) = arguments.next() {
        let path = Path::new(&program);
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let is_example = path
            .parent()
            .is_some_and(|folder| folder.ends_with("examples"));
        let folder = if is_example {
            "target/release/examples/"
        } else {
            ""
        };
        kept.push(format!("{folder}{name}"));
    }
    while let Some(argument) = arguments.next() {
        let (option, value) = argument.split_once('=').unzip();
        let option = option.unwrap_or(&argument);
        match LEFT_OUT.iter().find(|(left_out, _)| *left_out == option) {
            Some((_, true)) if value.is_none() => drop(arguments.next()),
            Some(_) => {}
            None => kept.push(argument),
        }
    }
    kept
}

/// Describes the machine: processor, cores, worker threads and system. Unknown properties are missing.
fn describe_machine() -> BTreeMap<String, String> {
    let cores = std::thread::available_parallelism();
    let processors = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let mut lines = processors.lines();
    let model = lines.find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let kernel = fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let (system, kind) = (std::env::consts::OS, std::env::consts::ARCH);
    let of = [
        ("processor", model.map(|(_, model)| model.to_owned())),
        ("cores", cores.ok().map(|cores| cores.to_string())),
        ("threads", Some(rayon::current_num_threads().to_string())),
        ("system", Some(format!("{system} {} {kind}", kernel.trim()))),
    ];
    let known = of
        .into_iter()
        .filter_map(|(name, value)| Some((name.to_owned(), value?)));
    known.collect()
}

fn evidence_error(path: &Path, message: &str) -> EvidenceError {
    EvidenceError {
        path: path.display().to_string(),
        message: message.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_has_what_changes_the_result() {
        let typed = "/a/wisch eval table1 --out=o --resume --set plan.variants=2 --evidence e.json --seeds=2 -q";
        let kept = build_command_line(typed.split(' ').map(str::to_owned));
        assert_eq!(
            kept.join(" "),
            "wisch eval table1 --set plan.variants=2 --seeds=2"
        );
    }

    #[test]
    fn what_was_not_measured_misses_no_target() {
        let of = |value| {
            let figure = PublishedFigure::from_value(["t", "r", "c"], value, "%", 1);
            figure
                .with_target([Some(87.0), Some(93.0)], "the project")
                .target
        };
        let missed = [86.9, 87.0, 93.1, f64::NAN].map(|value| of(value).unwrap().is_missed);
        assert_eq!(missed, [Some(true), Some(false), Some(true), None]);
    }
}
