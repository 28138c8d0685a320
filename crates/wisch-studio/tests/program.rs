//! The program as a process.

use crate::client::{Events, send};
use crate::place::{ID, OTHER, script, wait_until};
use flate2::Compression;
use flate2::write::GzEncoder;
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tempfile::TempDir;
use wisch_memory::Memory;

/// Maximum memory of the program for any recording [bytes]; without one it uses about 15 MB.
const MOST_MEMORY: u64 = 128 << 20;
/// Size of a decompressed recording [bytes].
const UNPACKED: usize = 256 << 20;

struct Program {
    folder: TempDir,
    child: Child,
    address: String,
    base: String,
}

impl Program {
    /// Starts the program on an empty memory; `xdg-open` logs its arguments.
    fn begin(options: &[&str]) -> Self {
        Self::begin_with(options, "/nowhere/wisch")
    }

    /// The same, with a program that runs tasks.
    fn begin_with(options: &[&str], wisch: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        fs::create_dir(path.join("bin")).unwrap();
        let opened = path.join("opened").display().to_string();
        let text = format!("#!/bin/sh\necho \"$@\" >{opened}.new && mv {opened}.new {opened}\n");
        script(&path.join("bin/xdg-open"), &text);
        let shipped = r#"[{"name":"board","about":""}]"#;
        fs::write(path.join("scenarios.json"), shipped).unwrap();
        let mut program = Command::new(env!("CARGO_BIN_EXE_wisch-studio"));
        program
            .args(options)
            .arg("--memory")
            .arg(path.join("episodes"));
        program
            .args(["--wisch", wisch, "--scenarios"])
            .arg(path.join("scenarios.json"));
        let found = format!("{}/bin:{}", path.display(), std::env::var("PATH").unwrap());
        program.env("PATH", found).stdout(Stdio::piped());
        let mut child = program.spawn().unwrap();
        let mut url = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut url)
            .unwrap();
        let (address, base) = url
            .trim()
            .strip_prefix("http://")
            .unwrap()
            .split_once('/')
            .unwrap();
        Self {
            child,
            address: address.to_owned(),
            base: format!("/{base}"),
            folder,
        }
    }

    fn live(&self) -> PathBuf {
        self.folder.path().join("episodes/.live")
    }

    /// Sends a signal and returns the exit code.
    fn end(&mut self, signal: Signal) -> Option<i32> {
        kill_process(Pid::from_child(&self.child), signal).unwrap();
        self.child.wait().unwrap().code()
    }

    /// Returns the peak memory of the program [bytes].
    fn peak_memory(&self) -> u64 {
        let status = fs::read_to_string(format!("/proc/{}/status", self.child.id())).unwrap();
        let line = status
            .lines()
            .find_map(|line| line.strip_prefix("VmHWM:"))
            .unwrap();
        line.trim().trim_end_matches(" kB").parse::<u64>().unwrap() * 1024
    }

    /// Stores an episode with a recording in its memory.
    fn keep(&self, id: &str, recording: &[u8]) {
        let memory = Memory::open(&self.folder.path().join("episodes")).unwrap();
        crate::place::keep(&memory, id, Some(recording));
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn signals_end_the_program_in_order() {
    for signal in [Signal::INT, Signal::TERM, Signal::HUP] {
        let mut program = Program::begin(&[]);
        // A follower does not delay the end.
        let path = format!("{}api/overview/events", program.base);
        let _follower = Events::open(&program.address, &path, &[]);
        assert_eq!(program.end(signal), Some(0), "{signal:?}");
        assert!(TcpStream::connect(&program.address).is_err());
    }
}

/// Imitates a run that needs two termination signals, and notes its process in a file beside it.
const STUBBORN: &str = r#"#!/bin/bash
while [ $# -gt 0 ]; do [ "$1" = --memory ] && memory=$2; shift; done
trap 'trap "touch \"$0.ended\"; exit 130" TERM' TERM
echo $$ > "$0.new" && mv "$0.new" "$0.pid"
mkdir -p "$memory/.live"
echo '{"piece":"head"}' > "$memory/.live/20261124-010000-0001.jsonl"
echo '{"pid":'$$',"task":"board"}' > "$memory/.live/20261124-010000-0001.json"
while :; do sleep 0.02; done
"#;

#[test]
fn no_run_outlives_the_studio() {
    // Only the kernel of Linux ends the runs of a studio that is killed.
    let signals: &[Signal] = if cfg!(target_os = "linux") {
        &[Signal::TERM, Signal::KILL]
    } else {
        &[Signal::TERM]
    };
    for &signal in signals {
        let place = tempfile::tempdir().unwrap();
        let wisch = place.path().join("wisch");
        script(&wisch, STUBBORN);
        let mut program = Program::begin_with(&[], wisch.to_str().unwrap());
        let path = format!("{}api/runs", program.base);
        let head = [("Content-Type", "application/json")];
        let order = r#"{"task":"board"}"#;
        let begun = send(&program.address, "POST", &path, &head, order);
        assert_eq!(begun.status, 201, "{}", begun.text());
        let run = fs::read_to_string(place.path().join("wisch.pid")).unwrap();
        let run = Pid::from_raw(run.trim().parse().unwrap()).unwrap();
        program.end(signal);
        let ended = place.path().join("wisch.ended");
        if signal == Signal::TERM {
            assert!(ended.is_file(), "the studio waits for its runs");
        } else {
            // The kernel has asked once. Without that, this request would be the first, and the run would go on.
            std::thread::sleep(Duration::from_millis(500));
            kill_process(run, Signal::TERM).unwrap();
        }
        wait_until("the run ends", || ended.is_file());
    }
}

#[test]
fn the_browser_is_called_without_the_token() {
    let mut program = Program::begin(&["--open"]);
    let opened = program.folder.path().join("opened");
    wait_until("the browser is called", || opened.is_file());
    let called = fs::read_to_string(&opened).unwrap();
    let token = program.base.trim_matches('/');
    assert_eq!(token.len(), 32);
    assert!(!called.contains(token), "{called}");
    let file = Path::new(called.trim());
    assert_eq!(
        fs::metadata(file).unwrap().permissions().mode() & 0o777,
        0o600
    );
    let url = format!("http://{}{}", program.address, program.base);
    assert!(
        fs::read_to_string(file)
            .unwrap()
            .contains(&format!("url={url}\""))
    );
    // Once the page was opened, the file is removed.
    assert_eq!(
        send(&program.address, "GET", &program.base, &[], "").status,
        200
    );
    assert!(!file.exists());
    assert_eq!(program.end(Signal::TERM), Some(0));
}

#[test]
fn an_unused_redirect_is_removed_with_the_program() {
    let mut program = Program::begin(&["--open"]);
    let opened = program.folder.path().join("opened");
    wait_until("the browser is called", || opened.is_file());
    assert_eq!(fs::read_dir(program.live()).unwrap().count(), 1);
    program.end(Signal::TERM);
    assert_eq!(fs::read_dir(program.live()).unwrap().count(), 0);
}

/// Compresses copies of a line, [`UNPACKED`] bytes in total.
fn packed(line: &str) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    let piece = line.repeat((1 << 20) / line.len());
    for _ in 0..UNPACKED / piece.len() {
        encoder.write_all(piece.as_bytes()).unwrap();
    }
    encoder.finish().unwrap()
}

#[test]
fn a_large_recording_needs_little_memory() {
    let program = Program::begin(&[]);
    let lines = packed(&format!(
        "{{\"piece\":\"samples\",\"n\":\"{}\"}}\n",
        "0".repeat(1000)
    ));
    program.keep(ID, &lines);
    program.keep(OTHER, &packed("0"));
    let mut plain = TcpStream::connect(&program.address).unwrap();
    let path = format!("{}api/episodes/{ID}/recording", program.base);
    let head = format!(
        "GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n",
        program.address
    );
    plain.write_all(head.as_bytes()).unwrap();
    let (mut all, mut piece) = (0, vec![0; 1 << 20]);
    loop {
        match plain.read(&mut piece).unwrap() {
            0 => break,
            read => all += read,
        }
    }
    assert!(all > UNPACKED * 9 / 10, "{all}");
    let took = program.peak_memory();
    assert!(took < MOST_MEMORY, "{took} bytes");
    // A line without an end is rejected.
    let path = format!("{}api/runs/{OTHER}/stream", program.base);
    let events: Vec<_> = Events::open(&program.address, &path, &[]).collect();
    assert_eq!(events.len(), 1);
    assert!(
        events[0].data.contains("longer than 16 MiB"),
        "{}",
        events[0].data
    );
    let took = program.peak_memory();
    assert!(took < MOST_MEMORY, "{took} bytes");
}
