//! A Prolog engine in a process of its own, and the lines that go to and fro.

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

/// Lines that an engine may be ahead of the program.
const LINES_AHEAD: usize = 1024;
/// What is read of an engine's standard error [bytes].
const LONGEST_ERROR: u64 = 1 << 20;

/// What SWI-Prolog maps beside the stacks of queries: code, atoms, facts, stacks of its threads [bytes].
const SWI_ITSELF: u64 = 1 << 30;
/// Between two looks whether the query is interrupted.
const LOOK_UP: Duration = Duration::from_millis(50);
/// Processor time for what is no query: beginning, reading the predicates [s].
const PROCESSOR_SPARE_S: u64 = 30;

/// What differs between Prolog systems.
const SCRYER: &str = include_str!("../../prolog/engine_scryer.pl");
const SWI: &str = include_str!("../../prolog/engine_swi.pl");
/// The predicates, the same for every engine.
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

/// What a query may use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskLimits {
    /// Time for a query.
    pub time: Duration,
    /// Memory of the engine [bytes].
    pub memory: u64,
    /// Answers.
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

/// A Prolog system, by its program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EngineCommand {
    /// Scryer Prolog: `wisch-prolog`, the program of the crate of that name.
    Scryer(PathBuf),
    /// SWI-Prolog: `swipl`.
    Swi(PathBuf),
}

impl EngineCommand {
    /// Whichever can be had: Scryer Prolog, else SWI-Prolog.
    pub fn find() -> Option<Self> {
        Self::scryer().or_else(Self::swi)
    }

    /// Scryer Prolog, if `wisch-prolog` lies beside this program, in the folder above (as of cargo's examples), or in
    /// `PATH`.
    pub fn scryer() -> Option<Self> {
        let program = std::env::current_exe().unwrap_or_default();
        let folders = program.ancestors().skip(1).take(2).map(Path::to_path_buf);
        find("wisch-prolog", folders.chain(search_path())).map(Self::Scryer)
    }

    /// SWI-Prolog, if `swipl` lies in `PATH`.
    pub fn swi() -> Option<Self> {
        find("swipl", search_path()).map(Self::Swi)
    }

    /// The process, as it is begun with the predicates in a file.
    fn process(&self, predicates: &Path, limits: &AskLimits) -> Command {
        match self {
            Self::Scryer(program) => {
                let mut process = Command::new(program);
                process.arg(limits.memory.to_string()).arg(predicates);
                process
            }
            Self::Swi(program) => {
                let mut process = ended_with_this(program);
                process
                    .arg(format!("--stack-limit={}", limits.memory))
                    .args(["-q", "-f", "none", "-g", "main", "-t", "halt"])
                    .arg(predicates);
                process
            }
        }
    }

    /// Whether it writes `...` for what it cannot write down, a term that contains itself.
    pub(super) fn cuts_short(&self) -> bool {
        matches!(self, Self::Scryer(_))
    }

    /// What its process may map of memory [bytes]: what queries may use, and what the system itself takes.
    fn address_space(&self, limits: &AskLimits) -> u64 {
        match self {
            Self::Scryer(_) => limits.memory,
            Self::Swi(_) => limits.memory.saturating_add(SWI_ITSELF),
        }
    }

    /// The predicates, as this system reads them.
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

/// A program that knows nothing of its parent, as a process that the kernel ends when the thread ends that began it; as
/// any process where the system has no `setpriv` of util-linux.
fn ended_with_this(program: &Path) -> Command {
    const END_WITH_PARENT: [&str; 2] = ["--pdeathsig", "KILL"];
    static SETPRIV: LazyLock<Option<PathBuf>> = LazyLock::new(|| {
        let setpriv = find("setpriv", search_path()).filter(|_| cfg!(target_os = "linux"))?;
        // That of other systems has no such option.
        let mut tried = Command::new(&setpriv);
        tried
            .args(END_WITH_PARENT)
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
            process.args(END_WITH_PARENT).arg(program);
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

/// A running engine. Dropped, it ends; it also ends by itself when its standard input does, with whoever began it.
#[derive(Debug)]
pub struct Engine {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
    /// What it writes to its standard error until it ends.
    errors: Option<JoinHandle<String>>,
    /// The predicates, until it has read them.
    program: Option<TempPath>,
    /// Processor time that its queries may take, all of them together [s].
    processor_s: u64,
}

impl Engine {
    /// Begins the process.
    ///
    /// # Errors
    /// If it cannot be begun.
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
        // What a terminal interrupts is the program, which knows what to do about its engine.
        #[cfg(unix)]
        process.process_group(0);
        let mut child = process.spawn().map_err(AskError::CannotStart)?;
        limit(&child, Resource::Memory, command.address_space(limits));
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

    /// Sends a query, which may take so much time.
    ///
    /// # Errors
    /// If the engine has ended.
    pub fn begin_query(&mut self, order: &str, time: Duration) -> Result<(), AskError> {
        // In case nobody is left to end it. A query keeps one core busy, and SWI-Prolog's collection of garbage another.
        let most = time.as_secs().saturating_mul(2).saturating_add(1);
        self.processor_s = self.processor_s.saturating_add(most);
        limit(&self.child, Resource::Processor, self.processor_s);
        self.send(order)
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

    /// The next term that it writes; `None` if it writes nothing until the deadline.
    ///
    /// # Errors
    /// If the engine has ended, or somebody says so.
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
            match self.lines.recv_timeout(left.min(LOOK_UP)) {
                Ok(line) if line.trim().is_empty() => {}
                Ok(line) => {
                    self.program = None;
                    return Ok(Some(Term::parse(&line)?));
                }
                Err(RecvTimeoutError::Timeout) if left > LOOK_UP => {}
                Err(RecvTimeoutError::Timeout) => return Ok(None),
                Err(RecvTimeoutError::Disconnected) => return Err(self.ended()),
            }
        }
    }

    fn ended(&mut self) -> AskError {
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

/// What a process uses.
#[derive(Debug, Clone, Copy)]
enum Resource {
    /// Address space [bytes].
    Memory,
    /// Processor time [s].
    Processor,
}

/// Limits what a process may use, where the system can. It is a second line: a process that has just ended, or cannot
/// be limited, is no error.
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
