//! Opens the page in a browser.
//!
//! Every user of the machine can read the arguments of a program, and the page's address holds the token. The browser
//! is therefore started with a file that only its owner can read, and which redirects to the page.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempPath;

/// Writes a file into `folder` that redirects a browser to `url`. Only its owner can read it; it is removed when
/// dropped.
///
/// # Errors
/// If the file cannot be written.
pub fn redirect_file(folder: &Path, url: &str) -> io::Result<TempPath> {
    std::fs::create_dir_all(folder)?;
    let mut builder = tempfile::Builder::new();
    // Files of `tempfile` have mode 0600 by default.
    let mut file = builder
        .prefix("open-")
        .suffix(".html")
        .tempfile_in(folder)?;
    write!(
        file,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"referrer\" content=\"no-referrer\">\n\
         <meta http-equiv=\"refresh\" content=\"0; url={url}\">\n<title>wisch studio</title>\n<a href=\"{url}\">Open the \
         studio</a>\n</html>\n"
    )?;
    Ok(file.into_temp_path())
}

/// Opens a file in the browser.
///
/// # Errors
/// If the system has no program that opens it.
pub fn open(file: &Path) -> io::Result<()> {
    let (program, before): (_, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("cmd", &["/c", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(before).arg(file);
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let mut child = command
        .spawn()
        .map_err(|error| io::Error::new(error.kind(), format!("{program}: {error}")))?;
    // Waiting for the child keeps it from becoming a zombie.
    std::thread::spawn(move || child.wait());
    Ok(())
}
