//! Files that a command may replace: those that wisch has written.

use crate::failure::Failure;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use wisch_io::OutputFile;

/// First characters of every page.
const PAGE: &str = "<!DOCTYPE html>";
/// First characters of every file of events.
const EVENTS: &str = "{\"event\":";

/// Begins a page. `option`: the option that names its file.
///
/// # Errors
/// If the file exists and is no page, such as a log, or cannot be written.
pub(super) fn begin_page(file: &Path, option: &str) -> Result<OutputFile, Failure> {
    check_start(file, PAGE, "page", option)?;
    OutputFile::begin(file).map_err(|error| {
        Failure::from(error).with_help(format!("choose another file with {option}"))
    })
}

/// Checks that a file may be replaced by the events of a run.
///
/// # Errors
/// If the file exists and holds something else, such as a task.
pub(super) fn check_events(file: &Path) -> Result<(), Failure> {
    check_start(file, EVENTS, "file of events", "--events")
}

/// Checks that a file is missing, empty or begins with a text. A file that cannot be read has its error later.
fn check_start(file: &Path, start: &str, kind: &str, option: &str) -> Result<(), Failure> {
    let mut found = Vec::new();
    let is_regular = file.metadata().is_ok_and(|metadata| metadata.is_file());
    if is_regular && let Ok(opened) = File::open(file) {
        // What is read before an error decides.
        let _ = opened.take(start.len() as u64).read_to_end(&mut found);
    }
    if found.is_empty() || found == start.as_bytes() {
        return Ok(());
    }
    Err(Failure::new(format!(
        "{}: the file exists and is no {kind} that wisch wrote, so it is not replaced",
        file.display()
    ))
    .with_help(format!("choose another file with {option}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn only_files_of_wisch_are_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("file");
        for (contents, is_page, is_events) in [
            (None, true, true),
            (Some(""), true, true),
            (Some("<!DOCTYPE html>\n<html>"), true, false),
            (Some("{\"event\":\"planning\",\"schema\":2}\n"), false, true),
            (Some("{\"schema\":1}\n"), false, false),
            (Some("t,x,y,z\n0,1,2,3\n"), false, false),
            (Some("<"), false, false),
        ] {
            if let Some(contents) = contents {
                fs::write(&file, contents).expect("a file");
            }
            assert_eq!(begin_page(&file, "--out").is_ok(), is_page, "{contents:?}");
            assert_eq!(check_events(&file).is_ok(), is_events, "{contents:?}");
            let kept = fs::read_to_string(&file).ok();
            assert_eq!(kept.as_deref(), contents);
        }
        let error = begin_page(&file, "--out").map(drop).expect_err("no page");
        assert!(error.to_string().contains("is no page"), "{error}");
        assert!(begin_page(Path::new("/dev/null"), "--out").is_ok());
    }
}
