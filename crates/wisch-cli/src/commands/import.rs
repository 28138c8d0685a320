//! `wisch memory import`: interprets a robot's log and stores it as an episode.

use super::PROGRAM;
use super::interpret::{Interpreted, goal, interpret_read, read_log, task_args};
use super::prepare;
use super::words::{format_count, json, percent};
use crate::args::{GlobalArgs, ImportArgs, LoggedArgs, suggest};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, remark};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;
use wisch::follow::Phase;
use wisch::geometry::flatten_pose;
use wisch::represent::Task;
use wisch_io::{
    FileDigest, INTERPRETATION_FILE, LoadedTask, PARTICLES_ESTIMATED_FILE, REPORT_FILE,
    particles_to_csv,
};
use wisch_memory::catalogue::entries;
use wisch_memory::{
    CUT_REMARK, Catalogue, EpisodeHeader, EpisodeRecord, EpisodeWriter, KnownRound, LOG_COLUMNS,
    Mark, Memory, MemoryError, Origin, RecordedMotion, RoundObservations, RoundScene, Value,
    is_date, local_date_and_time, remember_log,
};
use wisch_record::{RecordError, attach_task, begin_episode, unix_time};
use wisch_telemetry::{Log, LogOptions, read};

const NANOSECONDS_PER_SECOND: f64 = 1e9;
/// Attachment with the options of the command line that change the interpretation of the log.
const READING_FILE: &str = "reading.txt";
/// Time by which the clock of a robot may be ahead of this machine's [s].
const MOST_FAST_S: f64 = 3600.0;
/// Time from the origin of LabVIEW's times to 1970 [s].
const FROM_1904_TO_1970_S: f64 = 2_082_844_800.0;
/// Longest part of a log that an episode of it may lack without being incomplete [s].
const MOST_MISSING_S: f64 = 0.5;

/// Reads and interprets the log, and stores it as an episode.
pub fn import(args: &ImportArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    let source = &args.source;
    let task_args = task_args(source);
    progress.say("checking whether the memory has this log");
    let digest = compute_digest(&source.log)
        .map_err(|error| Failure::new(format!("{}: {error}", source.log.display())))?;
    let memory = Memory::create(&args.memory.memory).map_err(keep_failure)?;
    progress.say("reading the task");
    let mut prepared = prepare::read(&task_args)?;
    let reading = format_reading_options(args, &prepared);
    if let Some(id) = find_episode(&memory, &digest)? {
        drop(progress);
        return report_known(&memory, &id, &reading, args, global);
    }
    let goal = goal(source, &task_args, &mut prepared)?;
    progress.say("reading the log");
    let log = read_log(source, &prepared)?;
    progress.say("checking whether the memory has this round");
    if let Some(known) = find_known_round(&memory, source, &log)? {
        drop(progress);
        return report_known_round(&memory, &known, (&prepared, &reading, &log), args, global);
    }
    let interpreted = interpret_read(source, &prepared, (log, goal), None, &progress)?;
    progress.say("keeping the episode");
    // Another program may have imported the log meanwhile.
    let alone = memory.wait_for_imports().map_err(keep_failure)?;
    if let Some(id) = find_episode(&memory, &digest)? {
        drop((alone, progress));
        return report_known(&memory, &id, &reading, args, global);
    }
    if let Some(known) = find_known_round(&memory, source, &interpreted.log)? {
        drop((alone, progress));
        let read = (&prepared, &*reading, &interpreted.log);
        return report_known_round(&memory, &known, read, args, global);
    }
    let record = keep(args, &memory, digest, (&prepared, &reading), &interpreted)?;
    drop((alone, progress));

    let read = &interpreted.record;
    let remarks = &read.log.remarks;
    let doubts = (read.doubts.iter()).filter(|doubt| !remarks.contains(doubt));
    for what in remarks.iter().chain(doubts) {
        remark(what);
    }
    let start = start_of(args, &interpreted.log);
    if let Some(what) = describe_wrong_date(start, unix_time()) {
        let log = source.log.display();
        remark(&format!(
            "{log}: {what}; forget the episode, then import the log with --start-s SECONDS (since 1970, UTC)"
        ));
    }
    say(&record, args, global, |place| {
        let verdict = verdict_of(&record);
        let mean = interpreted.interpretation.performance.mean;
        let estimate = match is_estimated(&record) {
            true => format!("estimated performance {} ({verdict})", percent(mean)),
            false => verdict.to_owned(),
        };
        format!(
            "{}: {} in {:.1} s, {estimate}\n  episode  {place}\n",
            record.task,
            format_count(interpreted.log.samples.len(), "sample"),
            measure_duration(&interpreted.log),
        )
    })?;
    Ok(Outcome::Done)
}

/// States that a start is no date, or a date in the future, with the consequences. `start`, `now`: times [s since 1970].
fn describe_wrong_date(start: f64, now: f64) -> Option<String> {
    if !is_date(start) {
        return Some(format!(
            "its times begin at {start} s, which is no date, so the date of the episode is unknown"
        ));
    }
    if start <= now + MOST_FAST_S {
        return None;
    }
    let since_1904 = start - FROM_1904_TO_1970_S;
    let origin = match is_date(since_1904) && since_1904 <= now {
        true => format!(
            "; if they count from 1904, as in LabVIEW, they begin at {since_1904:.0} s, {}",
            local_date_and_time(since_1904)
        ),
        false => String::new(),
    };
    Some(format!(
        "its times begin at {}, which is in the future, so the episode stays the last one until then{origin}",
        local_date_and_time(start)
    ))
}

/// The time from the start of a log to its last sample [s].
fn measure_duration(log: &Log) -> f64 {
    log.samples.last().map_or(0.0, |sample| sample.time)
}

/// Returns the time at which a log starts, as the options or the log state it [s since 1970].
fn start_of(args: &ImportArgs, log: &Log) -> f64 {
    (args.start_s).unwrap_or(log.start as f64 / NANOSECONDS_PER_SECOND)
}

/// Stores the log and its interpretation in the memory, as one episode.
fn keep(
    args: &ImportArgs,
    memory: &Memory,
    digest: FileDigest,
    (prepared, reading): (&LoadedTask, &str),
    interpreted: &Interpreted,
) -> Result<EpisodeRecord, Failure> {
    let log = &interpreted.log;
    let start = start_of(args, log);
    // The name is derived from the log, so that two simultaneous imports of a log collide.
    let begun = begin_episode(memory, start, digest.last_bits());
    let (writer, unfinished) = begun.map_err(keep_failure)?;
    let believed = prepared.task.surface.world_from_surface;
    let seen = RoundObservations {
        round: log.round,
        world_from_surface: log.world_from_surface.unwrap_or(believed),
        observations: log.observations.clone(),
    };
    write_telemetry(&writer, log, prepared, &seen).map_err(keep_failure)?;
    (writer.observations(1, &seen)).map_err(keep_failure)?;
    attach(&writer, (prepared, reading), interpreted)?;
    let header = EpisodeHeader {
        id: writer.id().to_owned(),
        task: prepared.task.name.clone(),
        start,
        target: prepared.run.target,
        seed: prepared.run.plan.seed,
        program: PROGRAM.to_owned(),
    };
    let log_file = &args.source.log;
    let name = log_file.file_name().unwrap_or(log_file.as_os_str());
    let mut record = remember_log(
        &header,
        &name.to_string_lossy(),
        measure_duration(log),
        &prepared.task,
        &interpreted.goal,
        &interpreted.interpretation,
    );
    let digest = digest.to_string();
    set_text(
        &mut record,
        "semco:WipingEpisode",
        "semco:logDigest",
        digest,
    );
    let mut remarks = interpreted.record.log.remarks.clone();
    if log.is_unfinished {
        remarks.push(CUT_REMARK.to_owned());
    }
    if !remarks.is_empty() {
        let remarks = remarks.join("; ");
        set_text(&mut record, "semco:WipingRound", "semco:logRemark", remarks);
    }
    let placed = unfinished.place(|| writer.commit(&record));
    placed.map_err(keep_failure)?;
    Ok(record)
}

/// Attaches the task, the options of the log, and the results of the interpretation.
fn attach(
    writer: &EpisodeWriter,
    (prepared, reading): (&LoadedTask, &str),
    interpreted: &Interpreted,
) -> Result<(), Failure> {
    let attach = |name: &str, contents: &[u8]| {
        let attached = writer.attach(name, contents);
        attached.map_err(keep_failure)
    };
    attach_task(writer, prepared).map_err(attach_failure)?;
    attach(READING_FILE, reading.as_bytes())?;
    let estimated = interpreted.draw_estimate(prepared)?;
    let name = format!("round-1/{PARTICLES_ESTIMATED_FILE}");
    attach(&name, particles_to_csv(&estimated).as_bytes())?;
    let name = format!("round-1/{INTERPRETATION_FILE}");
    attach(&name, json(&interpreted.record)?.as_bytes())?;
    attach(REPORT_FILE, interpreted.page(prepared).as_bytes())
}

fn keep_failure(error: MemoryError) -> Failure {
    let help = match error.is_disk_full() {
        true => "free space on the disk, or choose another folder with --memory DIR",
        false => "choose another folder with --memory DIR",
    };
    Failure::new(RecordError::from(error)).with_help(help)
}

/// Returns the failure of an attachment: an import has no option to keep no episode.
fn attach_failure(error: RecordError) -> Failure {
    match error {
        RecordError::Memory(error) => keep_failure(error),
        error => error.into(),
    }
}

/// Formats all options that change the interpretation of a log; its file name is not among them.
fn format_reading_options(args: &ImportArgs, prepared: &LoadedTask) -> String {
    let source = &args.source;
    let options = (
        (&source.plan, source.action, source.seed),
        (&source.settings, &source.knowledge, args.start_s),
    );
    format!("{}\n{options:?}\n{:?}\n", prepared.text, source.reading)
}

fn set_text(record: &mut EpisodeRecord, class: &str, property: &str, text: String) {
    for individual in record
        .individuals
        .iter_mut()
        .filter(|one| one.class == class)
    {
        individual
            .values
            .insert(property.to_owned(), Value::Text(text.clone()));
    }
}

fn find_text<'a>(record: &'a EpisodeRecord, class: &str, property: &str) -> Option<&'a str> {
    let of_class = record.individuals.iter().find(|one| one.class == class);
    match of_class?.values.get(property) {
        Some(Value::Text(text)) => Some(text),
        _ => None,
    }
}

fn verdict_of(record: &EpisodeRecord) -> &str {
    find_text(record, "semco:WipingAction", "semco:verdict").unwrap_or_default()
}

fn is_estimated(record: &EpisodeRecord) -> bool {
    let action = (record.individuals.iter()).find(|one| one.class == "semco:WipingAction");
    action.is_some_and(|action| action.performance().is_some())
}

fn say(
    record: &EpisodeRecord,
    args: &ImportArgs,
    global: &GlobalArgs,
    words: impl Fn(&str) -> String,
) -> Result<(), Failure> {
    if args.json {
        print(&json(record)?)?;
    } else if !global.quiet {
        let place = args.memory.memory.join(&record.id);
        print(&words(&place.display().to_string()))?;
    }
    Ok(())
}

/// Reports a log that the memory has already, and adds nothing. Other options than at its import are an error, because
/// they would make a second episode of the same wiping.
fn report_known(
    memory: &Memory,
    id: &str,
    reading: &str,
    args: &ImportArgs,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let episode = memory.episode(id).map_err(keep_failure)?;
    let log = args.source.log.display();
    if episode.attachment(READING_FILE).ok().as_deref() != Some(reading.as_bytes()) {
        return Err(Failure::new(format!(
            "{log}: the memory has this log already, as episode {id}, imported with another task or other options"
        ))
        .with_help(format!(
            "remove that episode with {}, then import the log again",
            suggest(&format!("memory forget {id}"))
        )));
    }
    let record = episode.record().map_err(keep_failure)?;
    say(&record, args, global, |place| {
        format!(
            "{}: the memory has this log already; nothing was added\n  episode  {place}\n",
            record.task
        )
    })?;
    Ok(Outcome::Done)
}

/// Finds the round of the memory that holds the motion of a log. Options may move the samples of the bag of a run, so that
/// it is also compared as the run has recorded it.
fn find_known_round(
    memory: &Memory,
    source: &LoggedArgs,
    log: &Log,
) -> Result<Option<KnownRound>, Failure> {
    let find = |log: &Log| {
        let known = memory.find_round(&RecordedMotion {
            samples: &log.samples,
            is_cut: log.is_unfinished,
            task: log.task.as_deref(),
            observations: &log.observations,
        });
        known.map_err(keep_failure)
    };
    let known = find(log)?;
    if known.is_some() || log.round.is_none() {
        return Ok(known);
    }
    match read(&source.log, &LogOptions::default()) {
        Ok(recorded) if recorded.samples != log.samples => find(&recorded),
        _ => Ok(None),
    }
}

/// Reports a log whose round the memory has already, and adds nothing: a second episode of the same wiping would count
/// twice in every query and in `wisch learn`.
fn report_known_round(
    memory: &Memory,
    known: &KnownRound,
    (prepared, reading, log): (&LoadedTask, &str, &Log),
    args: &ImportArgs,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let KnownRound { episode: id, round } = known;
    let record = (memory.episode(id))
        .and_then(|episode| episode.record())
        .map_err(keep_failure)?;
    let file = args.source.log.display();
    let kept = record
        .rounds
        .get(*round)
        .copied()
        .unwrap_or(record.interval[1])
        - record.rounds[round - 1];
    if matches!(record.origin, Origin::Imported(_)) {
        // The part that a longer log adds would be lost.
        let missing = measure_duration(log) - kept;
        if missing > MOST_MISSING_S {
            return Err(Failure::new(format!(
                "{file}: the memory has the first {kept:.1} s of this log already, as episode {id}, of {:.1} s",
                measure_duration(log)
            ))
            .with_help(format!(
                "remove that episode with wisch memory forget {id}, then import the log again"
            )));
        }
        return report_known(memory, id, reading, args, global);
    }
    let task = &prepared.task.name;
    if record.task != *task {
        return Err(Failure::new(format!(
            "{file}: the memory has this round already, as round {round} of episode {id}, of task {:?}, not of {task:?}",
            record.task
        ))
        .with_help("read the log with another task by wisch interpret, which keeps no episode"));
    }
    say(&record, args, global, |place| {
        format!(
            "{}: the memory has this round already, as round {round} of the run {id}; nothing was added\n  episode  {place}\n",
            record.task
        )
    })?;
    Ok(Outcome::Done)
}

/// Finds the episode that was imported from a log with this digest.
fn find_episode(memory: &Memory, digest: &FileDigest) -> Result<Option<String>, Failure> {
    let catalogue: Catalogue = memory.catalogue().map_err(keep_failure)?;
    let digests = catalogue.texts("semco:logDigest");
    let wanted = digest.to_string();
    let found = (catalogue.episodes().iter()).find(|row| {
        let of_it = entries(digests, row.first);
        of_it.iter().any(|(_, text)| *text == wanted)
    });
    Ok(found.map(|row| row.id.clone()))
}

/// Computes the digest of a log: of a file, or of all files in a folder, sorted by name.
fn compute_digest(log: &Path) -> io::Result<FileDigest> {
    let mut digest = FileDigest::EMPTY;
    let mut files = Vec::new();
    if log.is_dir() {
        for entry in fs::read_dir(log)? {
            let path = entry?.path();
            files.extend(path.is_file().then_some(path));
        }
        files.sort();
    } else {
        files.push(log.to_path_buf());
    }
    let mut block = vec![0; 1 << 16];
    for file in files {
        let mut file = File::open(file)?;
        loop {
            let read = match file.read(&mut block) {
                Ok(0) => break,
                Ok(read) => read,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            };
            digest.add(&block[..read]);
        }
    }
    Ok(digest)
}

fn write_telemetry(
    writer: &EpisodeWriter,
    log: &Log,
    prepared: &LoadedTask,
    seen: &RoundObservations,
) -> Result<(), MemoryError> {
    let columns = LOG_COLUMNS.map(str::to_owned);
    let Task { tool, surface, .. } = &prepared.task;
    let scene = RoundScene::from_log(&tool.name, &surface.name, &seen.world_from_surface);
    let mut telemetry = writer.telemetry_with_columns(1, scene.head(Vec::new()), &columns)?;
    // A log does not state the robot's phases.
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for sample in &log.samples {
        let pose = flatten_pose(&sample.world_from_tool).into_iter();
        let row = pose.chain(<[f64; 3]>::from(sample.force));
        telemetry.push(sample.time, mark, row)?;
    }
    Ok(telemetry.finish()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_that_cannot_be_is_described() {
        let now = 1_790_000_000.0;
        assert_eq!(describe_wrong_date(now - 86_400.0, now), None);
        assert_eq!(describe_wrong_date(now + 600.0, now), None);
        let what = |start| describe_wrong_date(start, now).unwrap_or_default();
        assert!(what(12.0).contains("no date"));
        // 2092-06-01, which is 2026-06-01 counted from 1904.
        let found = what(1_780_300_800.0 + FROM_1904_TO_1970_S);
        assert!(
            found.contains("in the future") && found.contains("1780300800 s, 2026-0"),
            "{found}"
        );
        let found = what(now + 4e8);
        assert!(
            found.contains("in the future") && !found.contains("1904"),
            "{found}"
        );
    }
}
