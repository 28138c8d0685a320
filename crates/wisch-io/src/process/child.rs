//! A child process with its own process group: its lines, and its end.

use super::backlog::{Backlog, NoLine};
use super::printable::{printable, printed};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Maximum length of a line [bytes].
pub(super) const MAX_LINE: u64 = 1 << 20;
/// Maximum size of a piece of a child's standard error that is copied at once [bytes].
const MAX_ERROR_LINE: u64 = 1 << 14;
/// Largest part of a child's standard error that is copied in a second [bytes].
const MAX_ERROR_RATE: usize = 1 << 18;
/// Period at which a silent child is checked.
const POLL: Duration = Duration::from_millis(20);
/// Time to wait for the last output of a child that has ended.
const LAST_WORDS: Duration = Duration::from_millis(200);
/// Time for a process group to end after SIGTERM.
const TERMINATION: Duration = Duration::from_millis(300);

/// The next output of a child.
pub(super) enum Heard {
    /// A line, and the time of its reception.
    Line(String, Instant),
    /// The output has ended, with the reason.
    Over(String),
    /// Nothing until the deadline.
    Nothing,
}

/// The running process groups of this program.
static GROUPS: Mutex<Vec<u32>> = Mutex::new(Vec::new());

/// Kills (SIGKILL) all executors of this program with their child processes. Call it before an exit that skips destructors.
pub fn kill_executors() {
    let groups = GROUPS.lock().map(|groups| groups.clone());
    for group in groups.unwrap_or_default() {
        signal_group(group, true);
    }
}

#[cfg(unix)]
fn signal_group(group: u32, is_kill: bool) {
    use rustix::process::{Pid, Signal, kill_process_group};
    let signal = if is_kill { Signal::KILL } else { Signal::TERM };
    if let Some(pid) = i32::try_from(group).ok().and_then(Pid::from_raw) {
        let _ = kill_process_group(pid, signal);
    }
}

#[cfg(not(unix))]
fn signal_group(_group: u32, _is_kill: bool) {}

/// A child process with its process group.
#[derive(Debug)]
pub(super) struct ChildGroup {
    child: Child,
    /// `None` after the last request.
    input: Option<Sender<Vec<u8>>>,
    lines: Backlog,
    /// Closed when all of its standard error is copied.
    errors: Option<Receiver<()>>,
    ended: Option<ExitStatus>,
}

impl ChildGroup {
    pub fn start(program: &str, arguments: &[String]) -> io::Result<Self> {
        let mut command = Command::new(program);
        command
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        // Ctrl-C then reaches this program alone, which tells the child to stop. Ending the group
        // also ends the program that a wrapper script runs.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        if let Ok(mut groups) = GROUPS.lock() {
            groups.push(child.id());
        }
        let lines = Backlog::default();
        if let Some(output) = child.stdout.take() {
            let lines = lines.clone();
            std::thread::spawn(move || {
                read_lines(BufReader::new(output), &lines);
                lines.end();
            });
        }
        let (input, messages) = channel();
        if let Some(stdin) = child.stdin.take() {
            std::thread::spawn(move || write_lines(stdin, &messages));
        }
        let errors = child.stderr.take().map(|stderr| {
            let (open, copied) = channel::<()>();
            std::thread::spawn(move || {
                copy_errors(stderr, |text| {
                    // Standard error may be closed.
                    let _ = writeln!(io::stderr().lock(), "{text}");
                });
                drop(open);
            });
            copied
        });
        Ok(Self {
            child,
            input: Some(input),
            lines,
            errors,
            ended: None,
        })
    }

    /// Sends a line. Errors are ignored; if the child has ended, the next read reports it.
    pub fn say(&self, line: Vec<u8>) {
        let _ = self.input.as_ref().map(|input| input.send(line));
    }

    /// The received lines that wait to be taken.
    pub const fn backlog(&self) -> &Backlog {
        &self.lines
    }

    /// Begins to watch a motion for silence, in a thread of its own, which sends `stop` to a child that fails.
    pub fn watch(&self, silence: Duration, stop: Vec<u8>) -> MotionWatch {
        self.lines.begin_watch(silence);
        let (lines, input) = (self.lines.clone(), self.input.clone());
        MotionWatch {
            lines: self.lines.clone(),
            thread: Some(std::thread::spawn(move || {
                if lines.wait_for_fault() {
                    let _ = input.map(|input| input.send(stop));
                }
            })),
        }
    }

    /// Takes a line that has arrived already, or the reason why further lines are ignored; `None`
    /// if there is neither.
    pub fn take_unasked(&self) -> Option<Result<String, String>> {
        let taken = self.lines.take(Instant::now()).ok();
        taken.map(|(_, line)| line)
    }

    /// Waits for a line and checks meanwhile for an interruption.
    pub fn hear(&mut self, deadline: Instant, mut goes_on: impl FnMut() -> bool) -> Heard {
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.lines.take(Instant::now() + left.min(POLL)) {
                Ok((received, Ok(line))) => return Heard::Line(line, received),
                Ok((_, Err(problem))) => return Heard::Over(problem),
                Err(NoLine::Ended) => {
                    let since = Instant::now();
                    while !self.has_ended() && since.elapsed() < LAST_WORDS {
                        std::thread::sleep(POLL);
                    }
                    return Heard::Over(self.end_in_words());
                }
                // A process that the child has started may keep the standard output open.
                Err(NoLine::TimedOut) if self.has_ended() => {
                    return match self.lines.take(Instant::now() + LAST_WORDS) {
                        Ok((received, Ok(line))) => Heard::Line(line, received),
                        Ok((_, Err(problem))) => Heard::Over(problem),
                        Err(_) => Heard::Over(self.end_in_words()),
                    };
                }
                Err(NoLine::TimedOut) if left.is_zero() || !goes_on() => {
                    return Heard::Nothing;
                }
                Err(NoLine::TimedOut) => {}
            }
        }
    }

    fn has_ended(&mut self) -> bool {
        if self.ended.is_none() {
            self.ended = self.child.try_wait().ok().flatten();
        }
        self.ended.is_some()
    }

    fn end_in_words(&self) -> String {
        match self.ended {
            Some(status) => format!("it ended while wisch waited for a message ({status})"),
            None => "it closed its standard output while wisch waited for a message".to_owned(),
        }
    }

    /// Closes the child's input, which tells it to end, and waits for the group to end by itself; then sends SIGTERM, then
    /// SIGKILL.
    pub fn end(&mut self, patience: Duration) {
        self.input = None;
        self.wait(patience, Self::has_ended);
        if !self.is_gone() {
            self.signal(false);
            self.wait(TERMINATION, Self::is_gone);
        }
        if !self.is_gone() {
            self.signal(true);
            // A killed process disappears after a short time.
            self.wait(LAST_WORDS, Self::is_gone);
        }
        self.lines.close();
        let group = self.child.id();
        if let Ok(mut groups) = GROUPS.lock() {
            groups.retain(|known| *known != group);
        }
        if let Some(errors) = self.errors.take() {
            let _ = errors.recv_timeout(LAST_WORDS);
        }
    }

    fn wait(&mut self, patience: Duration, is_over: impl Fn(&mut Self) -> bool) {
        let since = Instant::now();
        while !is_over(self) && since.elapsed() < patience {
            // A child with a full output pipe ends only after its output is read.
            while self.lines.take(since).is_ok() {}
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Whether the child and its whole group have ended.
    #[cfg(unix)]
    fn is_gone(&mut self) -> bool {
        use rustix::process::{Pid, test_kill_process_group};
        self.has_ended() && test_kill_process_group(Pid::from_child(&self.child)).is_err()
    }

    #[cfg(not(unix))]
    fn is_gone(&mut self) -> bool {
        self.has_ended()
    }

    fn signal(&mut self, is_kill: bool) {
        if cfg!(unix) {
            signal_group(self.child.id(), is_kill);
        } else {
            let _ = self.child.kill();
        }
    }
}

/// A watch over a motion, which stops a child that falls silent, however long its lines wait to be taken.
pub(super) struct MotionWatch {
    lines: Backlog,
    thread: Option<JoinHandle<()>>,
}

impl MotionWatch {
    /// Ends the watch before the motion ends. Returns whether it has stopped the child.
    pub fn end(&self) -> bool {
        self.lines.end_watch()
    }
}

impl Drop for MotionWatch {
    fn drop(&mut self) {
        self.lines.end_watch();
        let _ = self.thread.take().map(JoinHandle::join);
        // A silence during this motion is no fault of the next request.
        self.lines.forget_fault();
    }
}

/// Writes lines to the child until there are no more or the pipe closes. A child that does not read blocks only this
/// thread.
fn write_lines(mut stdin: ChildStdin, messages: &Receiver<Vec<u8>>) {
    for message in messages {
        if stdin
            .write_all(&message)
            .and_then(|()| stdin.flush())
            .is_err()
        {
            return;
        }
    }
}

/// Forwards lines until the child or the receiver has ended.
fn read_lines(mut output: impl BufRead, lines: &Backlog) {
    loop {
        let mut line = Vec::new();
        let read = Read::take(&mut output, MAX_LINE + 1).read_until(b'\n', &mut line);
        let line = match read {
            Ok(0) => return,
            Ok(_) if line.len() as u64 > MAX_LINE => Err(format!(
                "it sent a line above the limit of {MAX_LINE} bytes"
            )),
            Ok(_) => String::from_utf8(line)
                .map_err(|_| "it sent a line that is not UTF-8 text".to_owned()),
            Err(error) => Err(error.to_string()),
        };
        let is_over = line.is_err();
        if !lines.push(line) || is_over {
            return;
        }
    }
}

/// Copies a child's standard error to this program's, line by line, so that no control character reaches a terminal. What
/// exceeds [`MAX_ERROR_RATE`] is left out, and stated.
fn copy_errors(stderr: impl Read, print: impl Fn(&str)) {
    let mut stderr = BufReader::new(stderr);
    let (mut since, mut shown, mut left_out) = (Instant::now(), 0, 0);
    let state = |left_out: usize| {
        if left_out > 0 {
            print(&format!(
                "wisch: {left_out} bytes of the executor's standard error are left out, because it wrote more than {MAX_ERROR_RATE} bytes in a second"
            ));
        }
    };
    loop {
        let mut line = Vec::new();
        match Read::take(&mut stderr, MAX_ERROR_LINE).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return state(left_out),
            Ok(length) => {
                if since.elapsed() >= Duration::from_secs(1) {
                    state(std::mem::take(&mut left_out));
                    (since, shown) = (Instant::now(), 0);
                }
                if shown + length > MAX_ERROR_RATE {
                    left_out += length;
                    continue;
                }
                shown += length;
                let text = String::from_utf8_lossy(&line);
                print(&printed(text.trim_end_matches(['\n', '\r'])));
            }
        }
    }
}

/// Returns the part of a line that ends soon after a column, or its beginning if that holds the column, for messages.
/// `column`: from 1, in bytes.
pub(super) fn shortened(line: &str, column: usize) -> String {
    let mut start = column.saturating_sub(60).min(line.len());
    while !line.is_char_boundary(start) {
        start += 1;
    }
    let (before, start) = if column <= 80 {
        ("", 0)
    } else {
        ("…", start)
    };
    let part = line.get(start..).unwrap_or_default();
    format!("\"{before}{}\"", printable(part.trim_end(), 80))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    #[test]
    fn a_flood_on_standard_error_is_cut_and_its_size_stated() {
        let printed = RefCell::new(Vec::new());
        let flood = ["x".repeat(99), "\n".to_owned()].concat().repeat(100_000);
        copy_errors(flood.as_bytes(), |text| {
            printed.borrow_mut().push(text.to_owned());
        });
        let printed = printed.into_inner();
        let (stated, lines): (Vec<_>, Vec<_>) =
            printed.iter().partition(|line| line.starts_with("wisch: "));
        assert!(
            lines.len() < 100_000 && stated.len() < 100,
            "{}",
            lines.len()
        );
        let count = |line: &&String| line[7..].split(' ').next()?.parse::<usize>().ok();
        let left_out: usize = stated.iter().filter_map(count).sum();
        assert_eq!(100 * lines.len() + left_out, flood.len());
    }
}
