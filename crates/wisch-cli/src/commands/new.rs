//! `wisch new` and `wisch schema`: a commented task file, and the JSON Schema with which editors check it.

use crate::args::{GlobalArgs, NewArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use wisch_io::{TaskFile, shell_word};

/// The schema's file name, which the template's first line points editors to.
const SCHEMA_FILE: &str = "wisch-task.schema.json";

/// Prints the schema of task files.
pub fn schema() -> Result<Outcome, Failure> {
    print(&TaskFile::json_schema())?;
    Ok(Outcome::Done)
}

/// Writes the template, and the schema beside it.
pub fn new(args: &NewArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let Some(path) = &args.file else {
        print(TaskFile::TEMPLATE)?;
        return Ok(Outcome::Done);
    };
    let shown = path.display();
    let mut options = OpenOptions::new();
    options.write(true);
    if args.force {
        options.create(true).truncate(true);
    } else {
        options.create_new(true);
    }
    options
        .open(path)
        .and_then(|mut file| file.write_all(TaskFile::TEMPLATE.as_bytes()))
        .map_err(|error| match error.kind() {
            ErrorKind::AlreadyExists => Failure::new(format!("{shown}: the file exists already"))
                .with_help("choose another name, or overwrite it with --force"),
            _ => Failure::new(format!("{shown}: cannot write there: {error}")),
        })?;
    let schema = path.with_file_name(SCHEMA_FILE);
    std::fs::write(&schema, TaskFile::json_schema()).map_err(|error| {
        Failure::new(format!("{}: cannot write there: {error}", schema.display()))
    })?;
    if !global.quiet {
        let word = shell_word(&shown.to_string());
        print(&format!(
            "wrote {shown} and its schema for editors, {}\nnext: wisch check {word}, then wisch run {word}\n",
            schema.display()
        ))?;
    }
    Ok(Outcome::Done)
}
