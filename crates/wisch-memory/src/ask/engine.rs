//! A Prolog engine in a process of its own, and the lines that go to and fro.

use super::term::Term;
use super::{AskError, EngineKind, Limits};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex};
use std::time::Instant;
use tempfile::NamedTempFile;

/// Lines that an engine may be ahead of the program.
const LINES_AHEAD: usize = 1024;
/// What is kept of what an engine says of its end [bytes].
const LAST_WORDS: usize = 2000;

/// How an engine's process is begun.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EngineCommand {
    /// Scryer Prolog within this program: the program itself, begun with these arguments and the memory that it
    /// may use [bytes].
    Own(PathBuf, Vec<String>),
    /// SWI-Prolog, by its command.
    Swi(PathBuf),
}

impl EngineCommand {
    /// Which engine it is.
    pub fn kind(&self) -> EngineKind {
        match self {
            Self::Own(..) => EngineKind::Scryer,
            Self::Swi(_) => EngineKind::Swi,
        }
    }
}

/// A running engine. Dropped, it ends.
#[derive(Debug)]
pub struct Engine {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
    last_words: Arc<Mutex<String>>,
    _program: Option<NamedTempFile>,
}

impl Engine {
    /// Begins the process.
    ///
    /// # Errors
    /// If it cannot be begun.
    pub fn start(command: &EngineCommand, limits: &Limits) -> Result<Self, AskError> {
        let (mut process, program) = match command {
            EngineCommand::Own(program, arguments) => {
                let mut process = Command::new(program);
                process.args(arguments).arg(limits.memory.to_string());
                (process, None)
            }
            EngineCommand::Swi(program) => {
                let mut file = NamedTempFile::with_suffix(".pl").map_err(AskError::cannot_start)?;
                let text = super::worker::program(EngineKind::Swi);
                file.write_all(text.as_bytes())
                    .map_err(AskError::cannot_start)?;
                let mut process = Command::new(program);
                process
                    .arg(format!("--stack-limit={}", limits.memory))
                    .args(["-q", "-f", "none", "-g", "main", "-t", "halt"])
                    .arg(file.path());
                (process, Some(file))
            }
        };
        process
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = process.spawn().map_err(AskError::cannot_start)?;
        let (Some(input), Some(output), Some(errors)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(AskError::EngineEnded {
                words: "it has no streams".to_owned(),
            });
        };
        let (sender, lines) = sync_channel(LINES_AHEAD);
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let last_words = Arc::new(Mutex::new(String::new()));
        let heard = Arc::clone(&last_words);
        std::thread::spawn(move || {
            let mut text = Vec::new();
            let _ = errors.take(1 << 20).read_to_end(&mut text);
            let text = String::from_utf8_lossy(&text);
            let kept: String = text.chars().take(LAST_WORDS).collect();
            if let Ok(mut words) = heard.lock() {
                *words = kept;
            }
        });
        Ok(Self {
            child,
            input,
            lines,
            last_words,
            _program: program,
        })
    }

    /// Sends a line.
    ///
    /// # Errors
    /// If the engine has ended.
    pub fn send(&mut self, line: &str) -> Result<(), AskError> {
        let sent = self
            .input
            .write_all(line.as_bytes())
            .and_then(|()| self.input.write_all(b".\n"))
            .and_then(|()| self.input.flush());
        sent.map_err(|_| self.ended())
    }

    /// The next thing that it says; `None` if it says nothing until the deadline.
    ///
    /// # Errors
    /// If the engine has ended.
    pub fn hear(&mut self, deadline: Instant) -> Result<Option<Term>, AskError> {
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.lines.recv_timeout(left) {
                Ok(line) if line.trim().is_empty() => {}
                Ok(line) => return Ok(Some(Term::parse(&line)?)),
                Err(RecvTimeoutError::Timeout) => return Ok(None),
                Err(RecvTimeoutError::Disconnected) => return Err(self.ended()),
            }
        }
    }

    fn ended(&mut self) -> AskError {
        let status = self.child.wait().map(|status| status.to_string());
        // The thread that listens has a moment to hear the last words.
        std::thread::sleep(std::time::Duration::from_millis(20));
        let words = self.last_words.lock().map(|words| words.clone());
        let words = words.unwrap_or_default();
        let told = words.lines().find(|line| !line.trim().is_empty());
        AskError::EngineEnded {
            words: match (told, status) {
                (Some(told), _) if words.contains("allocation") || words.contains("memory") => {
                    format!("it ran out of memory ({})", told.trim())
                }
                (Some(told), _) => told.trim().to_owned(),
                (None, Ok(status)) => status,
                (None, Err(error)) => error.to_string(),
            },
        }
    }
}

impl Drop for Engine {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
