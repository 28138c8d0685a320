//! `wisch eval`: the method in many worlds.

mod calibration;
mod scenarios;

pub use calibration::calibration;
pub use scenarios::scenarios;

use crate::failure::Failure;
use std::path::Path;
use std::process::Command;
use wisch_io::OutputFile;

fn cannot(path: &Path, what: &str, error: &std::io::Error) -> Failure {
    Failure::new(format!("{}: cannot {what}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(OutputFile::begin(path)?.finish(text.as_bytes())?)
}

/// The commit of the checkout that the program runs in, with a mark if anything there differs from it.
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

fn points(share: f64) -> String {
    format!("{:.1}", 100.0 * share)
}
