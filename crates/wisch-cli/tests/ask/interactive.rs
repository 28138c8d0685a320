//! `wisch ask` at a terminal: what Ctrl-C does.

use super::{build_engine, memory, program};
use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::os::unix::ffi::OsStrExt;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Far longer than anything here takes.
const PATIENCE: Duration = Duration::from_secs(60);

/// The program at a terminal.
struct Terminal {
    keys: File,
    screen: Receiver<Vec<u8>>,
    seen: String,
    program: Child,
}

impl Terminal {
    fn new(command: &mut Command) -> Self {
        let ours = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&ours).unwrap();
        unlockpt(&ours).unwrap();
        let name = ptsname(&ours, Vec::new()).unwrap();
        let name = std::path::Path::new(std::ffi::OsStr::from_bytes(name.as_bytes()));
        let theirs = || {
            OpenOptions::new()
                .read(true)
                .write(true)
                .open(name)
                .unwrap()
        };
        let program = command
            .env("TERM", "xterm")
            .stdin(Stdio::from(theirs()))
            .stdout(Stdio::from(theirs()))
            .stderr(Stdio::from(theirs()))
            .spawn()
            .unwrap();
        let keys = File::from(ours);
        let mut output = keys.try_clone().unwrap();
        let (sender, screen) = channel();
        std::thread::spawn(move || {
            let mut bytes = [0; 4096];
            while let Ok(read @ 1..) = output.read(&mut bytes) {
                if sender.send(bytes[..read].to_vec()).is_err() {
                    break;
                }
            }
        });
        Self {
            keys,
            screen,
            seen: String::new(),
            program,
        }
    }

    fn press(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).unwrap();
    }

    /// Waits until this appears after what was waited for last.
    fn wait_for(&mut self, text: &str) {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(place) = self.seen.find(text) {
                self.seen.drain(..place + text.len());
                return;
            }
            let left = end.saturating_duration_since(Instant::now());
            match self.screen.recv_timeout(left) {
                Ok(bytes) => self.seen.push_str(&String::from_utf8_lossy(&bytes)),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {
                    panic!("{text:?} does not appear after {:?}", self.seen)
                }
            }
        }
    }
}

#[test]
fn ctrl_c_ends_the_query_or_the_line_and_ctrl_d_the_program() {
    build_engine();
    let folder = memory();
    let mut command = Command::new(program());
    let mut terminal = Terminal::new(command.current_dir(folder.path()).arg("ask"));
    terminal.wait_for("?- ");
    terminal.press("X = begun\r");
    terminal.wait_for("X = begun\r\n");
    terminal.wait_for("?- ");
    terminal.press("forall(between(1, 1000000000000, X), X > 0)\r");
    // The editor has given the terminal back, and the query goes on.
    terminal.wait_for("X > 0)");
    terminal.wait_for("\r\n");
    std::thread::sleep(Duration::from_millis(500));
    // As the terminal does at Ctrl-C to the program that it belongs to.
    kill_process(Pid::from_child(&terminal.program), Signal::INT).unwrap();
    terminal.wait_for("interrupted");
    terminal.wait_for("?- ");
    terminal.press("Y = half a line\x03");
    terminal.wait_for("?- ");
    terminal.press("Z = after\r");
    terminal.wait_for("Z = after\r\n");
    terminal.wait_for("?- ");
    terminal.press("\x04");
    assert_eq!(terminal.program.wait().unwrap().code(), Some(0));
}
