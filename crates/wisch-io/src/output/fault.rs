//! Errors of outputs: what failed, and what the user can do.

use crate::error::Error;
use std::io;
use std::path::Path;

pub(super) const OTHER_FILE: &str = "choose another file";
pub(super) const OTHER_FOLDER: &str = "choose another folder with --out";
pub(super) const MOVE_AWAY: &str = "choose another folder with --out, or move this one away";

pub(super) fn refused(path: &Path, problem: impl ToString, help: &'static str) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem: problem.to_string(),
        help,
    }
}

pub(super) fn cannot_write_file(path: &Path, error: &io::Error) -> Error {
    refused(path, format!("cannot write there: {error}"), OTHER_FILE)
}

pub(super) fn cannot_write(path: &Path, error: &io::Error) -> Error {
    refused(path, format!("cannot write there: {error}"), OTHER_FOLDER)
}
