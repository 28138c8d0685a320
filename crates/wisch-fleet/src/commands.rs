//! Commands of the program.

use crate::Outcome;
use crate::args::{
    CompactArgs, ForgetArgs, ListArgs, PullArgs, PushArgs, RetainArgs, SqlArgs, VerifyArgs,
};
use crate::clusters;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::{self, IsTerminal, Read, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use wisch_fleet::ask::{Form, LimitWatch, SqlLimits, SqlSession, SqlSource, views, write};
use wisch_fleet::moves::{self, Filter, Local, Part, PushOptions};
use wisch_fleet::store::{FleetError, StorePlace, read_clock};
use wisch_fleet::tables::all_tables;
use wisch_memory::Memory;

/// Answers statements.
pub async fn sql(args: &SqlArgs) -> Result<Outcome, FleetError> {
    if args.fleet.is_empty() && args.memory.is_empty() {
        return Err(FleetError::Asked(
            "no source of episodes; give --fleet URL or --memory FOLDER".to_owned(),
        ));
    }
    if let Some(url) = &args.cluster {
        clusters::check(url)?;
    }
    let form = match (&args.parquet, args.csv, args.json) {
        (Some(file), ..) => Form::Parquet(file.clone()),
        (None, true, _) => Form::Csv,
        (None, _, true) => Form::Json,
        _ => Form::Table,
    };
    let at_prompt = args.statement.is_none() && io::stdin().is_terminal();
    let text = match &args.statement {
        Some(statement) => statement.clone(),
        None if at_prompt => String::new(),
        None => {
            let mut text = String::new();
            io::stdin()
                .read_to_string(&mut text)
                .map_err(at("standard input"))?;
            text
        }
    };
    let part = match at_prompt || text.to_lowercase().contains("telemetry") {
        true => Part::Telemetry,
        false => Part::Facts,
    };
    let mut sources = Vec::new();
    for url in &args.fleet {
        sources.push(SqlSource::open(StorePlace::open(url)?).await?);
    }
    // Kept until the end: the rows of a read-only memory are in a temporary folder.
    let mut locals: Vec<Local> = Vec::new();
    for folder in &args.memory {
        let mut local = moves::open_local(&Memory::open(folder)?, part).await?;
        for why in &local.left_out {
            eprintln!("{why}: left out; see wisch memory verify");
        }
        sources.append(&mut local.sources);
        locals.push(local);
    }
    let limits = SqlLimits {
        time: Duration::from_secs(args.timeout.into()),
        memory: (args.memory_limit as usize) << 20,
    };
    let session = match &args.cluster {
        Some(url) => clusters::session(&sources, url, limits).await?,
        None => SqlSession::with_limits(&sources, limits).await?,
    };
    let watch = LimitWatch::begin(limits);
    watch.remove_at_end(session.spill().to_path_buf());
    if session.shared() > 0 {
        let count = session.shared();
        eprintln!("{count} episodes are in several sources; each counts once");
    }
    if at_prompt {
        return prompt(&session, &watch, &form).await;
    }
    for statement in statements(&text) {
        let begun = Instant::now();
        answer(&session, &watch, statement, &form).await?;
        if args.timing {
            eprintln!("{:.4} s", begun.elapsed().as_secs_f64());
        }
    }
    Ok(Outcome::Done)
}

/// Splits a text into statements at each `;` outside texts, names and comments.
fn statements(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let (mut begin, mut within) = (0, None);
    let bytes = text.as_bytes();
    for (place, &byte) in bytes.iter().enumerate() {
        match (within, byte) {
            (None, b'\'' | b'"') => within = Some(byte),
            (None, b'-') if bytes.get(place + 1) == Some(&b'-') => within = Some(b'\n'),
            (Some(end), byte) if byte == end => within = None,
            (None, b';') => {
                found.push(&text[begin..place]);
                begin = place + 1;
            }
            _ => {}
        }
    }
    found.push(&text[begin..]);
    let has_code = |part: &&str| {
        let lines = part.lines().map(str::trim);
        lines
            .into_iter()
            .any(|line| !line.is_empty() && !line.starts_with("--"))
    };
    found.retain(has_code);
    found
}

async fn answer(
    session: &SqlSession,
    watch: &LimitWatch,
    statement: &str,
    form: &Form,
) -> Result<(), FleetError> {
    let written = watch.within(async {
        let answer = session.plan(statement).await?;
        let written = write(answer, form, &mut io::stdout()).await;
        written.map_err(|error| session.cluster_error(error))
    });
    let rows = written.await?;
    if let Form::Parquet(file) = form {
        eprintln!("{}: {rows} rows", file.display());
    }
    Ok(())
}

async fn prompt(
    session: &SqlSession,
    watch: &LimitWatch,
    form: &Form,
) -> Result<Outcome, FleetError> {
    let broken = |error: rustyline::error::ReadlineError| {
        at("terminal")(io::Error::other(error.to_string()))
    };
    let mut editor = rustyline::DefaultEditor::new().map_err(broken)?;
    println!("SQL, ended by ; — SHOW TABLES lists tables and views, Ctrl-D ends");
    let mut text = String::new();
    loop {
        let mark = if text.is_empty() {
            "fleet> "
        } else {
            "     > "
        };
        match editor.readline(mark) {
            Ok(line) => {
                text += &line;
                text.push('\n');
                if !line.trim_end().ends_with(';') {
                    continue;
                }
                let _ = editor.add_history_entry(text.trim());
                for statement in statements(&text) {
                    if let Err(error) = answer(session, watch, statement, form).await {
                        eprintln!("error: {error}");
                    }
                }
                text.clear();
            }
            Err(rustyline::error::ReadlineError::Interrupted) => text.clear(),
            Err(rustyline::error::ReadlineError::Eof) => return Ok(Outcome::Done),
            Err(error) => return Err(broken(error)),
        }
    }
}

/// Lists the views.
pub fn views(args: &ListArgs) -> Result<Outcome, FleetError> {
    let mut text = String::new();
    for view in views::all() {
        let (name, meaning) = (view.name, view.meaning());
        if args.json {
            text += &json(
                &serde_json::json!({ "view": name, "meaning": meaning, "sql": view.statement }),
            );
        } else {
            text += &format!("{name}\n    {meaning}\n");
        }
    }
    print(&text)
}

/// Lists the tables and their columns.
pub fn columns(args: &ListArgs) -> Result<Outcome, FleetError> {
    let mut text = String::new();
    for table in all_tables() {
        if !args.json {
            text += &format!("{}: {}\n", table.name, table.about);
        }
        for column in table.columns {
            let kind = column.kind.name();
            if args.json {
                text += &json(&serde_json::json!({
                    "table": table.name, "column": column.name, "type": kind, "unit": column.unit, "meaning": column.about,
                }));
            } else {
                text += &format!(
                    "  {:<24} {kind:<8} {:<5} {}\n",
                    column.name, column.unit, column.about
                );
            }
        }
    }
    print(&text)
}

/// Pushes a memory.
pub async fn push(args: &PushArgs) -> Result<Outcome, FleetError> {
    let (memory, place) = (Memory::open(&args.memory)?, StorePlace::open(&args.url)?);
    let options = PushOptions {
        robot: args.robot.clone(),
    };
    let bar = bar("pushing");
    let pushed = moves::push(&memory, &place, &options, &mut |done, of| {
        step(&bar, done, of)
    })
    .await;
    bar.finish_and_clear();
    let pushed = pushed?;
    let summary = format!(
        "{}: {} episodes pushed ({}), {} already present\n",
        place.url(),
        pushed.episodes,
        bytes(pushed.bytes),
        pushed.there
    );
    print(&if args.json { json(&pushed) } else { summary })
}

/// Pulls episodes.
pub async fn pull(args: &PullArgs) -> Result<Outcome, FleetError> {
    if let (Some(since), Some(until)) = (args.since, args.until)
        && until < since
    {
        let problem = "--until is before --since, so that no episode matches; exchange them";
        return Err(FleetError::Asked(problem.to_owned()));
    }
    let place = StorePlace::open(&args.url)?;
    let memory = Memory::create(&args.memory)?;
    let filter = Filter {
        since: args.since,
        until: args.until,
        robots: args.robot.clone(),
        classes: args.class.clone(),
        episodes: args.episode.clone(),
        condition: args.condition.clone(),
    };
    let bar = bar("pulling");
    let pulled = moves::pull(&place, &memory, &filter, &mut |done, of| {
        step(&bar, done, of)
    })
    .await;
    bar.finish_and_clear();
    let pulled = pulled?;
    let mut summary = format!(
        "{}: {} of {} episodes selected, {} pulled ({}), {} already present\n",
        place.url(),
        pulled.ids.len(),
        pulled.of,
        pulled.episodes,
        bytes(pulled.bytes),
        pulled.there
    );
    if pulled.thinned > 0 {
        summary += &format!(
            "{} of them without telemetry, which the fleet no longer keeps\n",
            pulled.thinned
        );
    }
    for why in &pulled.left_out {
        eprintln!("{why}: left out");
    }
    if !pulled.left_out.is_empty() {
        let count = pulled.left_out.len();
        summary += &format!("{count} of them left out; see wisch-fleet verify\n");
    }
    print(&if args.json { json(&pulled) } else { summary })?;
    Ok(match pulled.left_out.is_empty() {
        true => Outcome::Done,
        false => Outcome::FaultsFound,
    })
}

/// Removes episodes.
pub async fn forget(args: &ForgetArgs) -> Result<Outcome, FleetError> {
    let place = StorePlace::open(&args.url)?;
    let forgotten = moves::forget(&place, &args.ids).await?;
    let noun = match forgotten.episodes {
        1 => "episode",
        _ => "episodes",
    };
    let summary = format!(
        "{}: {} {noun} removed from {} files of rows; wisch-fleet compact deletes the old files\n",
        place.url(),
        forgotten.episodes,
        forgotten.files
    );
    print(&if args.json { json(&forgotten) } else { summary })
}

/// Compacts.
pub async fn compact(args: &CompactArgs) -> Result<Outcome, FleetError> {
    let place = StorePlace::open(&args.url)?;
    let mut compacted = moves::compact(&place).await?;
    let purged = moves::purge(&place, read_clock() - args.older_than).await?;
    compacted.deleted = purged;
    let summary = format!(
        "{}: {} files became {}, {} objects deleted\n",
        place.url(),
        compacted.before,
        compacted.after,
        compacted.deleted
    );
    print(&if args.json { json(&compacted) } else { summary })
}

/// Removes old telemetry.
pub async fn retain(args: &RetainArgs) -> Result<Outcome, FleetError> {
    let place = StorePlace::open(&args.url)?;
    let retained = moves::retain(&place, read_clock() - args.keep_telemetry).await?;
    let summary = format!(
        "{}: telemetry before {} is now unused ({} files, {}); wisch-fleet compact deletes it\n",
        place.url(),
        retained.since,
        retained.files,
        bytes(retained.bytes)
    );
    print(&if args.json { json(&retained) } else { summary })
}

/// Verifies a fleet.
pub async fn verify(args: &VerifyArgs) -> Result<Outcome, FleetError> {
    let place = StorePlace::open(&args.url)?;
    let bar = bar("reading");
    let verified = moves::verify(&place, &mut |done, of| step(&bar, done, of)).await;
    bar.finish_and_clear();
    let verified = verified?;
    let mut summary: String = verified
        .faults
        .iter()
        .map(|fault| format!("{fault}\n"))
        .collect();
    let found = match verified.faults.len() {
        0 => "no faults".to_owned(),
        count => format!("{count} faults"),
    };
    summary += &format!(
        "{} files, {} episodes: {found}\n",
        verified.files, verified.episodes
    );
    print(&if args.json { json(&verified) } else { summary })?;
    Ok(match verified.faults.is_empty() {
        true => Outcome::Done,
        false => Outcome::FaultsFound,
    })
}

fn bar(what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {bar:40} {pos} of {len}, {eta} left");
    let bar = ProgressBar::new(0).with_message(what);
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

fn step(bar: &ProgressBar, done: usize, of: usize) {
    bar.set_length(of as u64);
    bar.set_position(done as u64);
}

fn bytes(count: u64) -> String {
    indicatif::DecimalBytes(count).to_string()
}

fn json(value: &impl Serialize) -> String {
    // Texts, finite numbers and lists of them always serialise to JSON.
    serde_json::to_string(value).unwrap_or_default() + "\n"
}

fn print(text: &str) -> Result<Outcome, FleetError> {
    match io::stdout().write_all(text.as_bytes()) {
        // The reader has closed the pipe.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(Outcome::Done),
        Err(error) => Err(at("standard output")(error)),
        Ok(()) => Ok(Outcome::Done),
    }
}

fn at(name: &str) -> impl FnOnce(io::Error) -> FleetError {
    let path = PathBuf::from(name);
    |error| FleetError::File { path, error }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_end_at_semicolons_outside_quotes() {
        let text = "SELECT ';' -- a; b\n; ; SELECT 2;\n-- the end\n";
        let found: Vec<&str> = statements(text).into_iter().map(str::trim).collect();
        assert_eq!(found, ["SELECT ';' -- a; b", "SELECT 2"]);
    }
}
