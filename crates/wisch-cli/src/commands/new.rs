//! `wisch new`: a task file to start from.

use crate::args::{GlobalArgs, NewArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use wisch_io::TaskFile;

/// Writes the template.
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
            ErrorKind::AlreadyExists => Failure::new(format!("{shown}: there is a file already"))
                .with_help("choose another name, or write over it with --force"),
            _ => Failure::new(format!("{shown}: cannot write there: {error}")),
        })?;
    if !global.quiet {
        print(&format!(
            "wrote {shown}\nnext: wisch check {shown}, then wisch run {shown}\n"
        ))?;
    }
    Ok(Outcome::Done)
}
