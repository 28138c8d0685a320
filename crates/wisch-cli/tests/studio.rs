//! `wisch studio` and the program that is its server, for which a script stands in here.

use crate::program::path;
use rustix::process::{Pid, Signal, kill_process, test_kill_process};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Plays the server: writes its number down, and ends in order on request.
const SERVER: &str = r#"#!/bin/sh
trap 'echo ended >"$MARK.ended"; exit 0' TERM
echo $$ >"$MARK.new" && mv "$MARK.new" "$MARK.pid"
while :; do sleep 0.02; done
"#;

/// The program with the server beside it, in a folder of the file system on which the program lies.
fn with_server(folder: &Path) -> Command {
    let program = folder.join("wisch");
    if fs::hard_link(path(), &program).is_err() {
        fs::copy(path(), &program).unwrap();
    }
    // By a process of its own: a file that this one holds open for writing cannot be run.
    let mut write = Command::new("sh");
    write.args(["-c", "printf %s \"$1\" > \"$0\" && chmod 755 \"$0\""]);
    write.arg(folder.join("wisch-studio")).arg(SERVER);
    assert!(write.status().unwrap().success());
    let mut program = Command::new(program);
    program
        .current_dir(folder)
        .env("MARK", folder.join("server"));
    program.arg("studio").stdout(Stdio::null());
    program
}

fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let deadline = Instant::now() + Duration::from_secs(30);
    while !holds() {
        assert!(Instant::now() < deadline, "{what}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_signal_ends_the_server_in_order() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let mut studio = with_server(folder.path()).spawn().unwrap();
    let mark = folder.path().join("server.pid");
    wait_until("the server begins", || mark.is_file());
    kill_process(Pid::from_child(&studio), Signal::TERM).unwrap();
    assert_eq!(studio.wait().unwrap().code(), Some(0));
    let server: i32 = fs::read_to_string(&mark).unwrap().trim().parse().unwrap();
    let gone = || test_kill_process(Pid::from_raw(server).unwrap()).is_err();
    wait_until("the server ends", gone);
    assert!(folder.path().join("server.ended").is_file());
}

#[test]
fn a_studio_that_is_killed_leaves_no_server() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let mut studio = with_server(folder.path()).spawn().unwrap();
    let mark = folder.path().join("server.pid");
    wait_until("the server begins", || mark.is_file());
    studio.kill().unwrap();
    studio.wait().unwrap();
    let server: i32 = fs::read_to_string(&mark).unwrap().trim().parse().unwrap();
    let gone = || test_kill_process(Pid::from_raw(server).unwrap()).is_err();
    wait_until("the server ends", gone);
}
