//! `wisch eval`: evaluates planning, wiping and estimation in many simulated worlds.

mod calibration;
mod goals;
mod journal;
mod scenarios;
mod sweep;
mod table1;
mod wipings;

pub use calibration::calibration;
pub use goals::goals;
pub use scenarios::scenarios;
pub use sweep::sweep;
pub use table1::table1;

use crate::args::{EvidenceArgs, GlobalArgs, JournalArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, remark};
use serde::Serialize;
use std::path::Path;
use std::process::Command;
use wisch_eval::{EvidenceFile, PLANNING_CODE, PublishedFigure, SIMULATION_CODE, SeedUse};
use wisch_io::OutputFile;

/// The note about seeds from several ranges.
const MIXED: &str = "these seeds mix several ranges: use 1 to 999 for demonstrations, 1000 to 4999 for tuning constants, and 10000 and above for published figures";

/// Format, version and seeds of an evaluation.
#[derive(Debug, Serialize)]
struct Provenance {
    format: &'static str,
    schema: u32,
    /// Version of the program; the field `commit` is set in a checkout only.
    version: &'static str,
    commit: Option<String>,
    seeds: [u64; 2],
    seed_use: &'static str,
}

impl Provenance {
    /// Records the start of an evaluation, with the present commit. `first`: first seed. `worlds`: number of seeds.
    fn begin(format: &'static str, schema: u32, first: u64, worlds: u64) -> Self {
        let serves = SeedUse::classify(first, worlds);
        if serves == SeedUse::Mixed {
            remark(MIXED);
        }
        Self {
            format,
            schema,
            version: env!("CARGO_PKG_VERSION"),
            commit: commit(),
            seeds: [first, first.saturating_add(worlds - 1)],
            seed_use: serves.as_str(),
        }
    }

    fn in_words(&self, senses: &str) -> String {
        let [first, last] = self.seeds;
        let commit = self.commit.as_deref().unwrap_or("no checkout");
        let (seed_use, version) = (self.seed_use, self.version);
        format!("Seeds {first} to {last} ({seed_use}), {senses}, wisch {version} ({commit})")
    }
}

/// Begins the evidence file of an evaluation, if `--evidence` names one. `parts`: the folder of its results, and which part
/// is evaluated. `is_executed`: whether the figures depend on the simulation.
fn begin_evidence(
    args: &EvidenceArgs,
    parts: Option<(&Path, &JournalArgs)>,
    is_executed: bool,
) -> Result<Option<EvidenceFile>, Failure> {
    let simulated = is_executed.then_some(SIMULATION_CODE);
    begin_evidence_of(args, parts, simulated.as_slice())
}

/// Begins the evidence file of an evaluation that depends on the code of planning and on further `code`.
fn begin_evidence_of(
    args: &EvidenceArgs,
    parts: Option<(&Path, &JournalArgs)>,
    code: &[&str],
) -> Result<Option<EvidenceFile>, Failure> {
    let Some(path) = &args.evidence else {
        return Ok(None);
    };
    let code = [&PLANNING_CODE[..], code].concat();
    let name = parts.map_or_else(String::new, |(_, journal)| journal.shard.to_string());
    let journal = parts.map(|(out, _)| (out, &*name));
    EvidenceFile::begin(path, &code, journal)
        .map(Some)
        .map_err(Failure::new)
}

/// Writes the evidence file if the evaluation is complete. `cases`: number of results, and number of all cases. A case that
/// failed counts as such, unless it may belong to a part that is not yet evaluated.
fn finish_evidence(
    evidence: Option<EvidenceFile>,
    provenance: &Provenance,
    [results, all]: [usize; 2],
    journal: Option<&JournalArgs>,
    figures: &[PublishedFigure],
) -> Result<(), Failure> {
    let Some(evidence) = evidence else {
        return Ok(());
    };
    if results < all && journal.is_some_and(|journal| journal.shard.count > 1) {
        let missing = all - results;
        remark(&format!(
            "no evidence is written: {missing} of {all} results are missing"
        ));
        return Ok(());
    }
    let cases = [results, all - results];
    evidence
        .finish(provenance.seeds, cases, figures)
        .map_err(Failure::new)
}

fn file_failure(path: &Path, what: &str, error: &std::io::Error) -> Failure {
    Failure::new(format!("{}: cannot {what}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(OutputFile::begin(path)?.finish(text.as_bytes())?)
}

/// Writes an evaluation's record and table, and prints one of them.
fn conclude(
    out: &Path,
    stem: &str,
    record: &impl Serialize,
    table: &str,
    json: bool,
    global: &GlobalArgs,
) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(record).map_err(Failure::new)?;
    write(&out.join(format!("{stem}.json")), &(text + "\n"))?;
    write(&out.join(format!("{stem}.md")), table)?;
    if json {
        let line = serde_json::to_string(record).map_err(Failure::new)?;
        print(&(line + "\n"))?;
    } else if !global.quiet {
        print(table)?;
    }
    Ok(())
}

/// Returns the outcome of an evaluation. `failed`: number of failed cases.
const fn find_outcome(failed: usize) -> Outcome {
    if failed == 0 {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    }
}

/// Returns the commit of the checkout in the working directory, with a mark for uncommitted changes.
fn commit() -> Option<String> {
    let output = Command::new("git")
        .args([
            "describe",
            "--always",
            "--dirty",
            "--abbrev=12",
            "--exclude=*",
        ])
        .output()
        .ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

fn format_points(share: f64) -> String {
    // Rounded first, so that a small negative number is not written as -0.0.
    let tenths = (1000.0 * share).round() + 0.0;
    format!("{:.1}", tenths / 10.0)
}
