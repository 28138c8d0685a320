//! File of statements by people, beside the episodes: one statement per line.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Name of the file in the memory's folder.
pub const FILE: &str = "told.jsonl";

/// A statement: subject, property, and a name or a value.
pub type Statement = (String, String, serde_json::Value);

/// Removes all statements about an episode from a memory. `aside` is the path of the temporary file.
///
/// # Errors
/// If a file cannot be read or written; then nothing is removed.
pub fn forget_episode(memory: &Path, id: &str, aside: &Path) -> io::Result<()> {
    let path = memory.join(FILE);
    if !path.exists() {
        return Ok(());
    }
    let held = open_locked(&path)?;
    let text = fs::read_to_string(&path)?;
    let is_of_it = |name: &str| {
        let episode = individual_of(name).and_then(|local| {
            let (_, rest) = local.split_once('_')?;
            Some(rest.rsplit_once('-')?.0)
        });
        episode == Some(id)
    };
    let whole = &text[..complete_length(text.as_bytes())];
    let stays = |line: &&str| match parse(line) {
        Ok((subject, _, object)) => !is_of_it(&subject) && !object.as_str().is_some_and(is_of_it),
        // A line that cannot be parsed is reported when it is read, so it stays.
        Err(_) => true,
    };
    let left: String = whole
        .lines()
        .filter(stays)
        .map(|line| format!("{line}\n"))
        .collect();
    if left.len() == whole.len() {
        return Ok(());
    }
    // The new file replaces the old one in one step. A process that waits for the old file's lock then opens the new
    // file.
    let mut new = File::create(aside)?;
    new.write_all(left.as_bytes())?;
    new.set_permissions(held.metadata()?.permissions())?;
    new.sync_all()?;
    fs::rename(aside, &path)
}

/// Returns the local name if it has the form of an episode's individual: `Class_episode-place`.
pub fn individual_of(name: &str) -> Option<&str> {
    let local = name.strip_prefix("semco:")?;
    let (class, rest) = local.split_once('_')?;
    let (episode, place) = rest.rsplit_once('-')?;
    let is_one = class.starts_with(|c: char| c.is_ascii_uppercase())
        && !episode.is_empty()
        && !place.is_empty()
        && place.chars().all(|c| c.is_ascii_digit());
    is_one.then_some(local)
}

/// Parses a statement from its line.
///
/// # Errors
/// A description of the fault.
pub fn parse(line: &str) -> Result<Statement, String> {
    // The caller names the line; serde_json would count from this one.
    let in_line = |error: serde_json::Error| match error.is_eof() {
        true => "it ends too early".to_owned(),
        false => {
            let text = error.to_string();
            let what = text
                .rsplit_once(" at line ")
                .map_or(text.as_str(), |(what, _)| what);
            format!("{what}, column {}", error.column())
        }
    };
    let statement: Statement = serde_json::from_str(line).map_err(in_line)?;
    let (subject, property, object) = &statement;
    match object {
        serde_json::Value::String(_) | serde_json::Value::Number(_) => Ok(statement),
        other => Err(format!(
            "{property} of {subject} is {other}; expected a name, a text or a finite number"
        )),
    }
}

/// Returns the length of the complete lines [bytes]: a killed program may leave part of a line behind.
pub fn complete_length(text: &[u8]) -> usize {
    text.iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |place| place + 1)
}

/// Appends lines to a file, all or none.
pub fn append(file: &Path, lines: &str) -> io::Result<()> {
    let mut open = open_locked(file)?;
    let mut before = Vec::new();
    open.read_to_end(&mut before)?;
    let whole = complete_length(&before) as u64;
    open.set_len(whole)?;
    open.seek(SeekFrom::Start(whole))?;
    let written = open
        .write_all(lines.as_bytes())
        .and_then(|()| open.sync_all());
    written.inspect_err(|_| {
        // A reader would skip part of a line, but not part of the lines, so the file is cut to its old length.
        let _ = open.set_len(whole);
    })
}

/// Opens the file, creating it if necessary, and locks it: several programs may add statements at once.
fn open_locked(file: &Path) -> io::Result<File> {
    loop {
        let mut options = OpenOptions::new();
        let open: File = options
            .create(true)
            .truncate(false)
            .read(true)
            .write(true)
            .open(file)?;
        open.lock()?;
        // Another file may have replaced it meanwhile.
        if is_still(&open, file)? {
            return Ok(open);
        }
    }
}

#[cfg(unix)]
fn is_still(open: &File, file: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let identity = |meta: &fs::Metadata| (meta.dev(), meta.ino());
    match fs::metadata(file) {
        Ok(now) => Ok(identity(&now) == identity(&open.metadata()?)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(not(unix))]
fn is_still(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
}
