//! Live runs, from their files in the memory's `.live` folder.
//!
//! ```text
//! episodes/.live/
//!   ID.json    {"pid": 4711, "task": "chopping-board", "begun": "2026-11-22 00:56:12"}
//!   ID.jsonl   the recording so far, a piece per line
//! ```
//!
//! Both files disappear once the run's episode is in the memory.

use crate::process;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use wisch_memory::live_path;

/// Longest name of a run [characters].
const MAX_ID_LEN: usize = 120;
/// Size of a recording's end that is searched for its last piece [bytes].
const TAIL: u64 = 1 << 18;
/// Largest size of a sidecar file [bytes].
const LONGEST_SIDECAR: u64 = 1 << 16;

/// Runs of a memory that are live, or broke off.
#[derive(Debug, Clone)]
pub struct LiveFolder {
    memory: PathBuf,
    /// Name of the program that runs tasks.
    program: String,
}

/// Sidecar file of a run, beside its recording.
#[derive(Debug, Clone, Deserialize)]
pub struct Sidecar {
    pub pid: u32,
    #[serde(default)]
    pub task: String,
    #[serde(default)]
    pub begun: Option<String>,
}

/// Summary of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveRun {
    pub id: String,
    pub task: String,
    pub begun: Option<String>,
    pub pid: u32,
    pub state: RunState,
    /// The episode that the run became.
    pub episode: Option<String>,
}

/// State of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum RunState {
    /// Its process is running.
    Running,
    /// It has written its end.
    Ended,
    /// Its process is gone without writing its end.
    Lost,
}

impl LiveFolder {
    pub fn new(memory: &Path, program: &Path) -> Self {
        let program = program.file_stem().unwrap_or_default();
        Self {
            memory: memory.to_path_buf(),
            program: program.to_string_lossy().into_owned(),
        }
    }

    /// Returns the path of a run's recording so far, if the run exists.
    pub fn recording(&self, id: &str) -> Option<PathBuf> {
        let path = live_path(&self.memory, check_id(id)?, "jsonl");
        path.is_file().then_some(path)
    }

    /// Returns all runs, newest first, without those whose files are damaged.
    pub fn runs(&self) -> Vec<LiveRun> {
        let mut runs: Vec<LiveRun> = (self.ids().iter()).filter_map(|id| self.run(id)).collect();
        runs.sort_by(|a, b| b.begun.cmp(&a.begun).then_with(|| b.id.cmp(&a.id)));
        runs
    }

    /// Returns a run.
    pub fn run(&self, id: &str) -> Option<LiveRun> {
        let recording = self.recording(id)?;
        let sidecar = self.sidecar(id);
        let end = last_piece(&recording).filter(|piece| piece["piece"] == "ended");
        let pid = sidecar.as_ref().map_or(0, |sidecar| sidecar.pid);
        let state = match end {
            Some(_) => RunState::Ended,
            None if self.is_at_work(pid) => RunState::Running,
            None => RunState::Lost,
        };
        let (task, begun) = sidecar.map_or_else(
            || (id.to_owned(), None),
            |sidecar| (sidecar.task, sidecar.begun),
        );
        let episode = end.and_then(|piece| piece["episode"].as_str().map(str::to_owned));
        Some(LiveRun {
            id: id.to_owned(),
            task,
            begun,
            pid,
            state,
            episode,
        })
    }

    /// Returns the run of a process.
    pub fn of_process(&self, pid: u32) -> Option<String> {
        self.ids().into_iter().find(|id| {
            let sidecar = self.sidecar(id);
            sidecar.is_some_and(|sidecar| sidecar.pid == pid) && self.recording(id).is_some()
        })
    }

    /// Whether a run's recording may still grow.
    pub fn goes_on(&self, id: &str) -> bool {
        let pid = self.sidecar(id).map(|sidecar| sidecar.pid);
        self.recording(id).is_some() && pid.is_some_and(|pid| self.is_at_work(pid))
    }

    /// Whether a process exists and is one that runs tasks.
    pub fn is_at_work(&self, pid: u32) -> bool {
        process::is_alive(pid) && process::is_called(pid, &self.program)
    }

    /// Removes the files of a run that broke off. Returns whether there was one.
    pub fn clear(&self, id: &str) -> io::Result<bool> {
        let has_ended = |run: &LiveRun| run.state != RunState::Running;
        if self.run(id).filter(has_ended).is_none() {
            return Ok(false);
        }
        for ending in ["json", "jsonl"] {
            match fs::remove_file(live_path(&self.memory, id, ending)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
        Ok(true)
    }

    fn sidecar(&self, id: &str) -> Option<Sidecar> {
        let file = File::open(live_path(&self.memory, check_id(id)?, "json")).ok()?;
        let mut text = String::new();
        file.take(LONGEST_SIDECAR).read_to_string(&mut text).ok()?;
        serde_json::from_str(&text).ok()
    }

    fn ids(&self) -> Vec<String> {
        let any = live_path(&self.memory, "any", "jsonl");
        let Some(Ok(entries)) = any.parent().map(fs::read_dir) else {
            return Vec::new();
        };
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        let ids = names.filter_map(|name| Some(check_id(name.strip_suffix(".jsonl")?)?.to_owned()));
        ids.collect()
    }
}

/// Checks that a run's name does not lead out of the folder.
fn check_id(id: &str) -> Option<&str> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let is_plain = !id.is_empty() && id.len() <= MAX_ID_LEN && id.chars().all(plain);
    is_plain.then_some(id)
}

/// Returns the last complete piece, if it is short enough to end a run.
fn last_piece(recording: &Path) -> Option<Value> {
    let mut file = File::open(recording).ok()?;
    let len = file.metadata().ok()?.len();
    file.seek(SeekFrom::Start(len.saturating_sub(TAIL))).ok()?;
    let mut bytes = Vec::new();
    file.take(TAIL).read_to_end(&mut bytes).ok()?;
    let whole = bytes.strip_suffix(b"\n")?;
    let start = whole.iter().rposition(|byte| *byte == b'\n');
    serde_json::from_slice(&whole[start.map_or(0, |at| at + 1)..]).ok()
}
