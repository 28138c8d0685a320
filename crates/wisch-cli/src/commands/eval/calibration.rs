//! `wisch eval calibration`: what is believed against what is so.

use super::super::words::{counted, percent};
use super::{Provenance, cannot, points, write};
use crate::args::{CalibrationArgs, GlobalArgs, SensesChoice};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use wisch_eval::{Calibration, GroupScores, MethodScores, Senses, WorldCase, WorldScore};
use wisch_report::{CalibrationCurve, CalibrationLevel, calibration_drawing};

/// The schema of what is written.
const SCHEMA: u32 = 1;

/// What is written of an evaluation.
#[derive(Debug, Serialize)]
struct CalibrationRecord {
    #[serde(flatten)]
    provenance: Provenance,
    senses: Senses,
    /// Keys that every task had set, with their values.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    settings: Vec<(String, String)>,
    #[serde(flatten)]
    calibration: Calibration,
}

/// Evaluates worlds, and sums up all in the folder.
pub fn calibration(args: &CalibrationArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let provenance = Provenance::begin("wisch calibration", SCHEMA, args.first_seed, args.worlds)?;
    let senses = match args.senses {
        SensesChoice::Touch => Senses::Touch,
        SensesChoice::Sight => Senses::TouchAndSight,
    };
    let (shard, out) = (args.shard, &args.out);
    fs::create_dir_all(out).map_err(|error| cannot(out, "write there", &error))?;
    let path = out.join(format!("worlds-{}-of-{}.jsonl", shard.index, shard.count));
    let [_, last] = provenance.seeds;
    let mut known = read_all(out)?;
    let is_other = |world: &&WorldScore| {
        world.senses != senses
            || world.variants != args.variant
            || world.settings != args.settings
            || !(args.first_seed..=last).contains(&world.case.seed)
    };
    if let Some(other) = known.values().find(is_other) {
        let seed = other.case.seed;
        return Err(Failure::new(format!(
            "{}: holds another evaluation, among others of seed {seed}",
            out.display()
        ))
        .with_help(
            "choose another folder with --out: figures of several evaluations are not mixed",
        ));
    }
    if !known.is_empty() && !args.resume {
        return Err(Failure::new(format!(
            "{}: holds {} already",
            out.display(),
            counted(known.len(), "world")
        ))
        .with_help("--resume goes on there; a published figure is not drawn twice"));
    }
    let seeds: Vec<u64> = (args.first_seed..=last)
        .filter(|seed| seed % shard.count == shard.index - 1 && !known.contains_key(seed))
        .collect();
    let file = begin_after_whole_lines(&path);
    let file = Mutex::new(file.map_err(|error| cannot(&path, "write there", &error))?);
    let progress = Progress::start(global);
    let (done, all) = (AtomicUsize::new(0), seeds.len());
    progress.say(format!("0 of {}", counted(all, "world")));
    let evaluated: Vec<Result<WorldScore, Failure>> = seeds
        .par_iter()
        .map(|&seed| {
            let score = WorldCase::of(seed)
                .evaluate(senses, &args.variant, &args.settings)
                .map_err(Failure::new)?;
            write_line(&file, &score).map_err(|error| cannot(&path, "write there", &error))?;
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.say(format!("{done} of {}", counted(all, "world")));
            Ok(score)
        })
        .collect();
    drop(progress);
    let mut failed = 0;
    for result in evaluated {
        match result {
            Ok(score) => {
                known.insert(score.case.seed, score);
            }
            Err(failure) => {
                failed += 1;
                remark(&failure.to_string());
            }
        }
    }
    let worlds: Vec<WorldScore> = known.into_values().collect();
    let record = CalibrationRecord {
        provenance,
        senses,
        settings: args.settings.clone(),
        calibration: Calibration::of(&worlds, &args.variant),
    };
    let table = in_words(&record);
    let text = serde_json::to_string_pretty(&record).map_err(Failure::new)?;
    write(&out.join("calibration.json"), &(text + "\n"))?;
    write(&out.join("calibration.md"), &table)?;
    write(&out.join("reliability.svg"), &drawing(&record))?;
    if args.json {
        let line = serde_json::to_string(&record).map_err(Failure::new)?;
        print(&(line + "\n"))?;
    } else if !global.quiet {
        print(&table)?;
    }
    Ok(if failed == 0 {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// A file to be gone on with; what a killed evaluation left of a line is cut off.
fn begin_after_whole_lines(path: &Path) -> std::io::Result<File> {
    let file = OpenOptions::new().create(true).append(true).open(path)?;
    let text = fs::read(path)?;
    let whole = text.iter().rposition(|&byte| byte == b'\n');
    file.set_len(whole.map_or(0, |end| end as u64 + 1))?;
    Ok(file)
}

/// A line at once, so that a killed evaluation leaves whole lines but for the last.
fn write_line(file: &Mutex<File>, score: &WorldScore) -> std::io::Result<()> {
    let mut line = serde_json::to_vec(score)?;
    line.push(b'\n');
    let mut file = file
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    file.write_all(&line)?;
    file.flush()
}

/// All worlds that the folder holds, by seed; a line that was not finished is passed over.
fn read_all(out: &Path) -> Result<BTreeMap<u64, WorldScore>, Failure> {
    let mut worlds = BTreeMap::new();
    let entries = fs::read_dir(out).map_err(|error| cannot(out, "read it", &error))?;
    for entry in entries {
        let path = entry
            .map_err(|error| cannot(out, "read it", &error))?
            .path();
        let name = path
            .file_name()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        if !(name.starts_with("worlds-") && name.ends_with(".jsonl")) {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| cannot(&path, "read it", &error))?;
        let mut lines = text.split_inclusive('\n').enumerate().peekable();
        while let Some((number, line)) = lines.next() {
            match serde_json::from_str::<WorldScore>(line) {
                Ok(score) => {
                    worlds.insert(score.case.seed, score);
                }
                Err(_) if lines.peek().is_none() && !line.ends_with('\n') => {}
                Err(error) => {
                    return Err(Failure::new(format!(
                        "{}:{}: {error}",
                        path.display(),
                        number + 1
                    )));
                }
            }
        }
    }
    Ok(worlds)
}

fn in_words(record: &CalibrationRecord) -> String {
    let calibration = &record.calibration;
    let senses = match record.senses {
        Senses::Touch => "touch alone",
        Senses::TouchAndSight => "touch and sight",
    };
    let mut text = format!(
        "{}{}: {} with {}.\n\n",
        record.provenance.in_words(senses),
        (record.settings.iter())
            .map(|(key, value)| format!(", {key} = {value}"))
            .collect::<String>(),
        counted(calibration.worlds, "world"),
        counted(calibration.rounds, "round"),
    );
    text +=
        "| way to believe | CRPS | error | bias | 50 % | 80 % | 90 % | 95 % | width of 90 % |\n";
    text += "|---|---|---|---|---|---|---|---|---|\n";
    for method in &calibration.methods {
        let _ = writeln!(text, "| {} |{}", method.name, method_cells(method));
    }
    let _ = writeln!(
        text,
        "\nCRPS, error, bias and width in points of performance; of intervals, the share of rounds that they held.\n"
    );
    text += "| worlds | | rounds | 90 % holds (95 % bounds) | width | CRPS | error | paper's error | end ≥ 90 % | claimed | met | false |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for group in &calibration.groups {
        let _ = writeln!(text, "{}", group_row(group));
    }
    let claims = &calibration.claims;
    let _ = writeln!(
        text,
        "\nGoals: {} claimed, {} met, {} claimed and met, {} claimed falsely by more than 10 points; {} unknowable by touch.",
        claims.claimed, claims.met, claims.claimed_and_met, claims.false_claims, claims.unknowable
    );
    let pushes = &calibration.pushes;
    let _ = writeln!(
        text,
        "Pushes: {} in {}, {} told, {} starts and {} ends within 50 ms; in {} in which nobody pushed, {} told where something was struck, {} invented.",
        pushes.pushes,
        counted(pushes.rounds, "round"),
        pushes.found,
        pushes.starts,
        pushes.ends,
        counted(pushes.undisturbed, "round"),
        pushes.obstructed,
        pushes.invented
    );
    text
}

fn method_cells(method: &MethodScores) -> String {
    let mut cells = format!(
        " {} | {} | {} |",
        points(method.crps),
        points(method.error),
        points(method.bias)
    );
    if method.coverage.is_empty() {
        return cells + " – | – | – | – | – |";
    }
    for level in &method.coverage {
        let _ = write!(cells, " {} |", percent(level.share));
    }
    let width = method.coverage.iter().find(|level| level.level == 0.9);
    let _ = write!(
        cells,
        " {} |",
        width.map_or_else(String::new, |level| points(level.width))
    );
    cells
}

fn group_row(group: &GroupScores) -> String {
    let at_90 = group
        .method
        .coverage
        .iter()
        .find(|level| level.level == 0.9);
    let (held, width) = at_90.map_or_else(Default::default, |level| {
        let [low, high] = level.bounds;
        let held = format!(
            "{} ({} to {})",
            percent(level.share),
            points(low),
            points(high)
        );
        (held, points(level.width))
    });
    format!(
        "| {} | {} | {} | {held} | {width} | {} | {} | {} | {} | {} | {} | {} |",
        group.name,
        group.worlds,
        group.rounds,
        points(group.method.crps),
        points(group.method.error),
        points(group.paper_error),
        percent(group.ended_at_90),
        group.claims.claimed,
        group.claims.met,
        group.claims.false_claims,
    )
}

fn drawing(record: &CalibrationRecord) -> String {
    let curve = |method: &MethodScores| CalibrationCurve {
        name: method.name.to_owned(),
        levels: (method.coverage.iter())
            .map(|level| CalibrationLevel {
                level: level.level,
                held: level.share,
                bounds: level.bounds,
                width: level.width,
            })
            .collect(),
    };
    let methods = record.calibration.methods.iter();
    let with_intervals = methods.filter(|method| !method.coverage.is_empty());
    let curves: Vec<CalibrationCurve> = with_intervals.map(curve).collect();
    let what = format!(
        "{} in {}, seeds {} to {}",
        counted(record.calibration.rounds, "round"),
        counted(record.calibration.worlds, "world"),
        record.provenance.seeds[0],
        record.provenance.seeds[1]
    );
    calibration_drawing("Reliability of the intervals", &what, &curves)
}
