//! Runs that the studio starts as child processes.

use crate::live::LiveFolder;
use crate::process;
use crate::refusal::Refusal;
use axum::http::StatusCode;
use serde::Deserialize;
use std::collections::HashMap;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tokio::process::{Child, Command};
use wisch_memory::ask::command_ended_with_parent;

/// Largest number of simultaneous runs that the studio starts.
const MOST_RUNS: usize = 4;
/// Longest time until a run announces its start.
const BEGINNING: Duration = Duration::from_secs(20);
/// Interval of the checks whether it has.
const CHECK_INTERVAL: Duration = Duration::from_millis(25);
/// Longest time until a run ends after a request.
const ENDING: Duration = Duration::from_secs(15);
/// Longest time until a run ends after a second request, which ends it at once.
const ENDING_AT_ONCE: Duration = Duration::from_secs(2);
/// Size of the end of a run's standard error that is kept [bytes].
const MESSAGE_BYTES: u64 = 4096;

/// Request to start a run.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StartOrder {
    /// Name of a shipped task, or path of a task file on this machine.
    task: String,
    #[serde(default)]
    seed: Option<u64>,
    #[serde(default)]
    strategy: Option<String>,
}

/// Child processes of the studio.
#[derive(Debug)]
pub struct Runs {
    wisch: PathBuf,
    memory: PathBuf,
    live: LiveFolder,
    state: Arc<Mutex<State>>,
}

#[derive(Debug, Default)]
struct State {
    /// Names of live runs, by process.
    children: HashMap<u32, Option<String>>,
    /// Final messages of runs that failed.
    last_words: HashMap<String, String>,
}

/// Result of a child process.
#[derive(Debug)]
struct Ended {
    code: Option<i32>,
    words: String,
}

impl Runs {
    pub fn new(wisch: &Path, memory: &Path, live: LiveFolder) -> Self {
        Self {
            wisch: wisch.to_path_buf(),
            memory: memory.to_path_buf(),
            live,
            state: Arc::default(),
        }
    }

    /// Starts a run, and returns its name once it can be watched.
    pub async fn begin(&self, order: &StartOrder, shipped: &[String]) -> Result<String, Refusal> {
        let task = task(&order.task, shipped)?;
        let strategy = order.strategy.as_deref().map(strategy).transpose()?;
        if self.state().children.len() >= MOST_RUNS {
            let why = format!("{MOST_RUNS} runs are live already; stop one, or wait");
            return Err(Refusal::new(StatusCode::TOO_MANY_REQUESTS, why));
        }
        if self.wisch.components().count() > 1 && !self.wisch.is_file() {
            let program = self.wisch.display();
            return Err(Refusal::failed(format!(
                "{program} cannot be started: there is no such file"
            )));
        }
        let out = TempDir::with_prefix("wisch-studio-").map_err(Refusal::failed)?;
        let errors = tempfile::tempfile().map_err(Refusal::failed)?;
        // The threads of the runtime live as long as the studio: if it is killed, its runs stop too.
        let mut command = Command::from(command_ended_with_parent(&self.wisch, "TERM"));
        command.args(["run", "--live", "--quiet", "--color", "never", "--memory"]);
        command.arg(&self.memory).arg("--out");
        command.arg(out.path().join("run"));
        if let Some(seed) = order.seed {
            command.args(["--seed", &seed.to_string()]);
        }
        if let Some(strategy) = strategy {
            command.args(["--strategy", strategy]);
        }
        command.arg("--").arg(&task);
        command.stdin(Stdio::null()).stdout(Stdio::null());
        command.stderr(errors.try_clone().map_err(Refusal::failed)?);
        // A terminal interrupts only this program, which stops its runs.
        #[cfg(unix)]
        command.process_group(0);
        let child = command.spawn().map_err(|error| {
            Refusal::failed(format!(
                "{} cannot be started: {error}",
                self.wisch.display()
            ))
        })?;
        let pid = child.id();
        let pid = pid.ok_or_else(|| Refusal::failed("the run has no process"))?;
        self.state().children.insert(pid, None);
        let (sender, mut ended) = tokio::sync::oneshot::channel();
        tokio::spawn(await_exit(
            child,
            pid,
            errors,
            out,
            Arc::clone(&self.state),
            sender,
        ));
        let deadline = Instant::now() + BEGINNING;
        loop {
            let live = self.live.clone();
            let begun = tokio::task::spawn_blocking(move || live.of_process(pid)).await?;
            if let Some(id) = begun {
                if let Some(name) = self.state().children.get_mut(&pid) {
                    *name = Some(id.clone());
                }
                return Ok(id);
            }
            match ended.try_recv() {
                Ok(ended) => return Err(ended.refusal()),
                Err(_) if Instant::now() > deadline => {
                    let _ = process::terminate(pid);
                    return Err(Refusal::failed(
                        "the run did not announce its start; check that the program wisch has the same version as the studio",
                    ));
                }
                Err(_) => tokio::time::sleep(CHECK_INTERVAL).await,
            }
        }
    }

    /// Asks a run to stop; for a run that another program started, only if its process is one that runs tasks.
    pub fn stop(&self, id: &str) -> Result<(), Refusal> {
        let run = self.live.run(id);
        let run = run.ok_or_else(|| Refusal::unknown(format!("there is no run {id:?}")))?;
        let is_own = self.is_own(id);
        if !is_own && !self.live.is_at_work(run.pid) {
            let why = format!("run {id:?} has ended already");
            return Err(Refusal::new(StatusCode::CONFLICT, why));
        }
        process::terminate(run.pid)
            .map_err(|error| Refusal::failed(format!("run {id:?} cannot be stopped: {error}")))
    }

    /// Whether the studio started this run, and it is still live.
    pub fn is_own(&self, id: &str) -> bool {
        let state = self.state();
        (state.children.values()).any(|name| name.as_deref() == Some(id))
    }

    /// Returns the final message of a run that failed.
    pub fn last_words(&self, id: &str) -> Option<String> {
        self.state().last_words.get(id).cloned()
    }

    /// Asks all runs of the studio to stop, and waits until they have. A run that is asked again ends at once.
    pub async fn stop_all(&self) {
        for patience in [ENDING, ENDING_AT_ONCE] {
            let pids: Vec<u32> = self.state().children.keys().copied().collect();
            for pid in pids {
                let _ = process::terminate(pid);
            }
            let deadline = Instant::now() + patience;
            while !self.state().children.is_empty() && Instant::now() < deadline {
                tokio::time::sleep(CHECK_INTERVAL).await;
            }
        }
    }

    fn state(&self) -> std::sync::MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Waits until a child has ended, and removes its files.
async fn await_exit(
    mut child: Child,
    pid: u32,
    mut errors: std::fs::File,
    out: TempDir,
    state: Arc<Mutex<State>>,
    sender: tokio::sync::oneshot::Sender<Ended>,
) {
    let status = child.wait().await;
    let code = status.ok().and_then(|status| status.code());
    let len = errors.metadata().map_or(0, |metadata| metadata.len());
    let mut words = Vec::new();
    let begin = SeekFrom::Start(len.saturating_sub(MESSAGE_BYTES));
    if errors.seek(begin).is_ok() {
        let _ = errors.read_to_end(&mut words);
    }
    let ended = Ended {
        code,
        words: String::from_utf8_lossy(&words).trim().to_owned(),
    };
    {
        let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
        let name = state.children.remove(&pid).flatten();
        if let Some(id) = name
            && !ended.words.is_empty()
        {
            state.last_words.insert(id, ended.words.clone());
        }
    }
    let _ = sender.send(ended);
    let _ = tokio::task::spawn_blocking(move || drop(out)).await;
}

impl Ended {
    fn refusal(&self) -> Refusal {
        let code = self.code.map_or_else(
            || "by a signal".to_owned(),
            |code| format!("with exit code {code}"),
        );
        let words = self
            .words
            .strip_prefix("error: ")
            .unwrap_or(self.words.as_str());
        Refusal::wrong(match words {
            "" => format!("the run ended {code} before it could be watched"),
            words => words.to_owned(),
        })
    }
}

/// Returns the task argument for the program.
fn task(named: &str, shipped: &[String]) -> Result<PathBuf, Refusal> {
    let named = named.trim();
    if shipped.iter().any(|known| known == named) {
        return Ok(PathBuf::from(named));
    }
    let path = Path::new(named);
    if path.extension().is_none_or(|ending| ending != "toml") {
        return Err(Refusal::wrong(format!(
            "{named:?} is neither a shipped task nor a task file (.toml)"
        )));
    }
    match std::fs::canonicalize(path) {
        Ok(path) if path.is_file() => Ok(path),
        Ok(_) => Err(Refusal::wrong(format!("{named}: it is not a file"))),
        Err(error) => Err(Refusal::wrong(format!("{named}: {error}"))),
    }
}

/// Checks that a strategy is a word and not an option.
fn strategy(named: &str) -> Result<&str, Refusal> {
    let plain = |c: char| c.is_ascii_lowercase() || c == '-';
    let is_plain = !named.is_empty() && !named.starts_with('-') && named.chars().all(plain);
    if is_plain {
        return Ok(named);
    }
    Err(Refusal::wrong(format!("{named:?} is not a strategy")))
}
