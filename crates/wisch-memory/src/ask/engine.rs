//! A Prolog engine in a separate process, and the lines exchanged with it.

use super::definitions::definitions;
use super::error::AskError;
use super::term::Term;
use std::env::consts::EXE_SUFFIX;
use std::io::{BufRead, BufReader, Read, Write};
#[cfg(unix)]
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tempfile::{NamedTempFile, TempPath};

/// Number of lines that an engine may be ahead of this program.
const LINES_AHEAD: usize = 1024;
/// Largest part of an engine's standard error that is read [bytes].
const LONGEST_ERROR: u64 = 1 << 20;

/// Memory of SWI-Prolog in addition to the stacks of queries: code, atoms, facts, stacks of its
/// threads [bytes].
const SWI_ITSELF: u64 = 1 << 30;
/// Interval between checks for an interrupt.
const INTERRUPT_CHECK: Duration = Duration::from_millis(50);
/// Processor time in addition to that of queries: start, and reading of the predicates [s].
const PROCESSOR_SPARE_S: u64 = 30;

/// Predicates that differ between Prolog systems.
const SCRYER: &str = include_str!("../../prolog/engine_scryer.pl");
const SWI: &str = include_str!("../../prolog/engine_swi.pl");
/// Predicates that are the same for every engine.
const PORTABLE: [&str; 11] = [
    include_str!("../../prolog/host.pl"),
    include_str!("../../prolog/guard.pl"),
    include_str!("../../prolog/plan.pl"),
    include_str!("../../prolog/facts.pl"),
    include_str!("../../prolog/intervals.pl"),
    include_str!("../../prolog/limits.pl"),
    include_str!("../../prolog/knowrob.pl"),
    include_str!("../../prolog/poses.pl"),
    include_str!("../../prolog/views.pl"),
    include_str!("../../prolog/queries.pl"),
    include_str!("../../prolog/listing.pl"),
];

/// Limits of a query on time, memory and answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskLimits {
    /// Wall-clock time of a query.
    pub time: Duration,
    /// Memory of the engine [bytes].
    pub memory: u64,
    /// Number of answers.
    pub answers: usize,
}

impl Default for AskLimits {
    /// A minute, 4 GiB and 10,000 answers.
    fn default() -> Self {
        Self {
            time: Duration::from_secs(60),
            memory: 4 << 30,
            answers: 10_000,
        }
    }
}

/// A Prolog system, by the path of its program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EngineCommand {
    /// Scryer Prolog: the companion program `wisch-prolog`.
    Scryer(PathBuf),
    /// SWI-Prolog: `swipl`.
    Swi(PathBuf),
}

impl EngineCommand {
    /// Finds an installed system: Scryer Prolog, else SWI-Prolog.
    ///
    /// ```
    /// use wisch_memory::ask::EngineCommand;
    /// match EngineCommand::find() {
    ///     Some(EngineCommand::Scryer(path) | EngineCommand::Swi(path)) => println!("{}", path.display()),
    ///     None => println!("no Prolog system is installed"),
    /// }
    /// ```
    pub fn find() -> Option<Self> {
        Self::find_scryer().or_else(Self::find_swi)
    }

    /// Finds Scryer Prolog: `wisch-prolog` beside this program, in the parent folder (for cargo's examples), or in
    /// `PATH`.
    pub fn find_scryer() -> Option<Self> {
        let program = std::env::current_exe().unwrap_or_default();
        let folders = program.ancestors().skip(1).take(2).map(Path::to_path_buf);
        find("wisch-prolog", folders.chain(search_path())).map(Self::Scryer)
    }

    /// Finds SWI-Prolog: the program `swipl` in `PATH`.
    pub fn find_swi() -> Option<Self> {
        find("swipl", search_path()).map(Self::Swi)
    }

    /// Returns the command that starts the process with the predicates in a file.
    fn process(&self, predicates: &Path, limits: &AskLimits) -> Command {
        match self {
            Self::Scryer(program) => {
                let mut process = Command::new(program);
                process.arg(limits.memory.to_string()).arg(predicates);
                process
            }
            Self::Swi(program) => {
                let mut process = command_ended_with_parent(program, "KILL");
                process
                    .arg(format!("--stack-limit={}", limits.memory))
                    .args(["-q", "-f", "none", "-g", "main", "-t", "halt"])
                    .arg(predicates);
                process
            }
        }
    }

    /// Whether the system writes `...` for a cyclic term, which has no finite text.
    pub(super) fn cuts_short(&self) -> bool {
        matches!(self, Self::Scryer(_))
    }

    /// Largest address space of the process [bytes]: the query's limit and the system's own needs.
    fn address_space(&self, limits: &AskLimits) -> u64 {
        match self {
            Self::Scryer(_) => limits.memory,
            Self::Swi(_) => limits.memory.saturating_add(SWI_ITSELF),
        }
    }

    /// Returns the predicates in this system's syntax.
    fn predicates(&self) -> String {
        let dialect = match self {
            Self::Scryer(_) => SCRYER,
            Self::Swi(_) => SWI,
        };
        let definitions = definitions(&PORTABLE);
        [&[dialect], PORTABLE.as_slice(), &[&definitions]]
            .concat()
            .join("\n")
    }
}

/// Returns a command to which the kernel sends a signal, such as "TERM", when the thread that started it ends; without
/// util-linux's `setpriv`, a plain command.
pub fn command_ended_with_parent(program: &Path, signal: &str) -> Command {
    const SIGNAL: &str = "--pdeathsig";
    static SETPRIV: LazyLock<Option<PathBuf>> = LazyLock::new(|| {
        let setpriv = find("setpriv", search_path()).filter(|_| cfg!(target_os = "linux"))?;
        // Other systems' `setpriv` lacks this option.
        let mut tried = Command::new(&setpriv);
        tried
            .args([SIGNAL, "KILL"])
            .arg(&setpriv)
            .arg("--version")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let is_known = tried.status().is_ok_and(|status| status.success());
        is_known.then_some(setpriv)
    });
    match &*SETPRIV {
        Some(setpriv) => {
            let mut process = Command::new(setpriv);
            process.args([SIGNAL, signal]).arg(program);
            process
        }
        None => Command::new(program),
    }
}

fn find(name: &str, folders: impl IntoIterator<Item = PathBuf>) -> Option<PathBuf> {
    let name = format!("{name}{EXE_SUFFIX}");
    let programs = folders.into_iter().map(|folder| folder.join(&name));
    programs.into_iter().find(|program| program.is_file())
}

fn search_path() -> Vec<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).collect()
}

/// A running engine. It ends when dropped, and also by itself when its standard input closes.
#[derive(Debug)]
pub struct Engine {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
    /// Its standard error, complete when it ends.
    errors: Option<JoinHandle<String>>,
    /// File of predicates, until the engine has read it.
    program: Option<TempPath>,
    /// Processor time that all its queries may take together [s].
    processor_s: u64,
}

impl Engine {
    /// Starts the process of the Prolog engine.
    ///
    /// # Errors
    /// If it cannot be started.
    pub fn start(command: &EngineCommand, limits: &AskLimits) -> Result<Self, AskError> {
        let mut program = NamedTempFile::with_suffix(".pl").map_err(AskError::CannotStart)?;
        let written = program.write_all(command.predicates().as_bytes());
        written.map_err(AskError::CannotStart)?;
        let program = program.into_temp_path();
        let mut process = command.process(&program, limits);
        process
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        // A terminal interrupts only this program, which decides about its engine.
        #[cfg(unix)]
        process.process_group(0);
        let mut child = process.spawn().map_err(AskError::CannotStart)?;
        limit(&child, Resource::Memory, command.address_space(limits));
        let (Some(input), Some(output), Some(errors)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(AskError::EngineEnded {
                words: "its standard streams are not available".to_owned(),
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
        let errors = std::thread::spawn(move || {
            let mut text = Vec::new();
            let _ = errors.take(LONGEST_ERROR).read_to_end(&mut text);
            String::from_utf8_lossy(&text).into_owned()
        });
        Ok(Self {
            child,
            input,
            lines,
            errors: Some(errors),
            program: Some(program),
            processor_s: PROCESSOR_SPARE_S,
        })
    }

    /// Sends a query with a limit on its time.
    ///
    /// # Errors
    /// If the engine has ended.
    pub fn begin_query(&mut self, order: &str, time: Duration) -> Result<(), AskError> {
        // A limit by the kernel, in case this program is killed. A query keeps one core busy, and SWI-Prolog's garbage
        // collection another.
        let most = time.as_secs().saturating_mul(2).saturating_add(1);
        self.processor_s = self.processor_s.saturating_add(most);
        limit(&self.child, Resource::Processor, self.processor_s);
        self.send(order)
    }

    /// Sends a line to the engine.
    ///
    /// # Errors
    /// If the engine has ended.
    pub fn send(&mut self, line: &str) -> Result<(), AskError> {
        let sent = self
            .input
            .write_all(line.as_bytes())
            .and_then(|()| self.input.write_all(b".\n"))
            .and_then(|()| self.input.flush());
        sent.map_err(|_| self.end_error())
    }

    /// Returns the next term from the engine; `None` if there is none before the deadline.
    ///
    /// # Errors
    /// If the engine has ended, or the query is interrupted.
    pub fn receive(
        &mut self,
        deadline: Instant,
        interrupt: &AtomicBool,
    ) -> Result<Option<Term>, AskError> {
        loop {
            if interrupt.swap(false, Ordering::Relaxed) {
                return Err(AskError::Interrupted);
            }
            let left = deadline.saturating_duration_since(Instant::now());
            match self.lines.recv_timeout(left.min(INTERRUPT_CHECK)) {
                Ok(line) if line.trim().is_empty() => {}
                Ok(line) => {
                    self.program = None;
                    return Ok(Some(Term::parse(&line)?));
                }
                Err(RecvTimeoutError::Timeout) if left > INTERRUPT_CHECK => {}
                Err(RecvTimeoutError::Timeout) => return Ok(None),
                Err(RecvTimeoutError::Disconnected) => return Err(self.end_error()),
            }
        }
    }

    fn end_error(&mut self) -> AskError {
        let status = self.child.wait().map(|status| status.to_string());
        let errors = self.errors.take().map(JoinHandle::join);
        let words = errors.and_then(Result::ok).unwrap_or_default();
        let first = words.lines().find(|line| !line.trim().is_empty());
        AskError::EngineEnded {
            words: match (first, status) {
                (Some(first), _) if words.contains("allocation") || words.contains("memory") => {
                    format!("it ran out of memory ({})", first.trim())
                }
                (Some(first), _) => first.trim().to_owned(),
                (None, Ok(status)) => status,
                (None, Err(error)) => error.to_string(),
            },
        }
    }
}

/// A resource of a process.
#[derive(Debug, Clone, Copy)]
enum Resource {
    /// Address space [bytes].
    Memory,
    /// Processor time [s].
    Processor,
}

/// Limits a process's resource, where the system can. This is a second safeguard, so a failure is not an error.
#[cfg(target_os = "linux")]
fn limit(child: &Child, of: Resource, most: u64) {
    use rustix::process::{Pid, Resource as Of, Rlimit, prlimit};
    let of = match of {
        Resource::Memory => Of::As,
        Resource::Processor => Of::Cpu,
    };
    let limit = Rlimit {
        current: Some(most),
        maximum: None,
    };
    let _ = prlimit(Some(Pid::from_child(child)), of, limit);
}

#[cfg(not(target_os = "linux"))]
fn limit(_: &Child, _: Resource, _: u64) {}

impl Drop for Engine {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
