//! The log: it states which files are valid. A commit is an object that is created only if its number is free. A writer
//! that loses the race reads the winner's commit and tries the next number.

use super::error::FleetError;
use super::place::{Created, StorePlace};
use crate::tables::file::VERSION;
use bytes::Bytes;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

/// Number of commits between checkpoints, so that nobody reads the whole log.
const CHECKPOINT_EVERY: u64 = 16;
const LATEST: &str = "checkpoint/latest";

/// A file of rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FileEntry {
    /// Name of the object.
    pub path: String,
    /// Name of the table.
    pub table: String,
    /// First and last robot, by name.
    pub robots: [String; 2],
    /// First and last day, such as `2026-11-22`.
    pub days: [String; 2],
    /// Number of rows.
    pub rows: u64,
    /// Length [bytes].
    pub bytes: u64,
    /// SHA-256 of its bytes.
    pub sha256: String,
    /// Version: major and minor.
    pub schema: [u32; 2],
    /// Start of its first episode and end of its last one [s since 1970].
    pub times: [f64; 2],
    /// Its episodes, if they are few.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub episodes: Option<Vec<String>>,
}

/// Changes that take effect together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Commit {
    /// Version: major and minor.
    pub version: [u32; 2],
    /// Unique token, by which a writer recognises its own commit.
    pub token: String,
    /// Time of the commit [s since 1970].
    pub time: f64,
    /// Purpose, such as `push`.
    pub what: String,
    /// Files that become valid.
    pub add: Vec<FileEntry>,
    /// Paths of files that become unused.
    pub remove: Vec<String>,
    /// First day whose telemetry is kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub telemetry_since: Option<String>,
}

/// An unused file, which earlier readers may still read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Removed {
    /// Name of the object.
    pub path: String,
    /// Time of its removal from the log [s since 1970].
    pub time: f64,
}

/// State after all commits up to a number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Version: major and minor.
    pub version: [u32; 2],
    /// Number of the next commit, which this state does not include.
    pub next: u64,
    /// Valid files, by path.
    pub files: BTreeMap<String, FileEntry>,
    /// Unused files that are not yet deleted.
    pub removed: Vec<Removed>,
    /// First day whose telemetry is kept.
    pub telemetry_since: Option<String>,
}

/// Result of a commit.
#[derive(Debug, Clone, PartialEq)]
pub enum Committed {
    /// It took effect.
    Done,
    /// Others committed first: these commits.
    Lost(Vec<Commit>),
}

/// Returns the current time [s since 1970]; no other function of this crate reads the clock.
pub fn read_clock() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_secs_f64()
}

impl Commit {
    /// Creates an empty commit.
    pub fn new(what: &str) -> Self {
        let time = read_clock();
        // Simultaneous processes have different ids, and commits of one process different times.
        let token = format!("{:x}-{:x}", std::process::id(), (time * 1e9) as u128);
        Self {
            version: VERSION,
            token,
            time,
            what: what.to_owned(),
            add: Vec::new(),
            remove: Vec::new(),
            telemetry_since: None,
        }
    }
}

impl Snapshot {
    /// Reads the present state of a fleet; empty for a new fleet.
    ///
    /// # Errors
    /// If the store or its log cannot be read.
    pub async fn read(place: &StorePlace) -> Result<Self, FleetError> {
        let mut snapshot = Self::checkpoint(place).await?.unwrap_or(Self {
            version: VERSION,
            next: 0,
            files: BTreeMap::new(),
            removed: Vec::new(),
            telemetry_since: None,
        });
        snapshot.refresh(place).await?;
        Ok(snapshot)
    }

    async fn checkpoint(place: &StorePlace) -> Result<Option<Self>, FleetError> {
        let Some(latest) = place.find(LATEST).await? else {
            return Ok(None);
        };
        // Only a hint: without it, the log is read from its beginning.
        let latest = String::from_utf8_lossy(&latest).trim().to_owned();
        let Ok(number) = latest.parse() else {
            return Ok(None);
        };
        let name = checkpoint_name(number);
        let Some(bytes) = place.find(&name).await? else {
            return Ok(None);
        };
        parse(place, &name, &bytes).map(Some)
    }

    /// Reads new commits, and returns them.
    ///
    /// # Errors
    /// If the store or its log cannot be read.
    pub async fn refresh(&mut self, place: &StorePlace) -> Result<Vec<Commit>, FleetError> {
        let mut newer = Vec::new();
        loop {
            let name = commit_name(self.next);
            let Some(bytes) = place.find(&name).await? else {
                return Ok(newer);
            };
            let commit: Commit = parse(place, &name, &bytes)?;
            self.apply(&commit);
            newer.push(commit);
        }
    }

    fn apply(&mut self, commit: &Commit) {
        for path in &commit.remove {
            self.files.remove(path);
            self.removed.push(Removed {
                path: path.clone(),
                time: commit.time,
            });
        }
        for file in &commit.add {
            // A file with the same bytes may become valid again.
            self.removed.retain(|removed| removed.path != file.path);
            let mut file = file.clone();
            // Writers that lost the race look up the episodes in the winner's commit.
            file.episodes = None;
            self.files.insert(file.path.clone(), file);
        }
        if commit.what == "purge" {
            // A purge deletes the files that it lists after its commit.
            self.removed
                .retain(|removed| !commit.remove.contains(&removed.path));
        }
        if let Some(since) = &commit.telemetry_since {
            self.telemetry_since = self.telemetry_since.take().max(Some(since.clone()));
        }
        self.next += 1;
    }

    /// Commits, unless another writer commits first.
    ///
    /// # Errors
    /// If the store cannot be read or written.
    pub async fn commit(
        &mut self,
        place: &StorePlace,
        commit: &Commit,
    ) -> Result<Committed, FleetError> {
        let name = commit_name(self.next);
        let created = place.create(&name, to_json(commit)).await?;
        if created == Created::There {
            let newer = self.refresh(place).await?;
            // The store's answer to this writer's own request may have been lost.
            let is_ours = |other: &Commit| other.token == commit.token;
            if !newer.iter().any(is_ours) {
                return Ok(Committed::Lost(newer));
            }
        } else {
            self.apply(commit);
        }
        if self.next.is_multiple_of(CHECKPOINT_EVERY) {
            place
                .put(&checkpoint_name(self.next), to_json(self))
                .await?;
            place
                .put(LATEST, Bytes::from(self.next.to_string()))
                .await?;
        }
        Ok(Committed::Done)
    }

    /// Returns the valid files of a table.
    pub fn files_of(&self, table: &str) -> impl Iterator<Item = &FileEntry> {
        self.files.values().filter(move |file| file.table == table)
    }
}

fn commit_name(number: u64) -> String {
    format!("log/{number:020}.json")
}

fn checkpoint_name(number: u64) -> String {
    format!("checkpoint/{number:020}.json")
}

fn to_json(value: &impl Serialize) -> Bytes {
    // Texts, finite numbers and lists of them always serialise to JSON.
    Bytes::from(serde_json::to_vec(value).unwrap_or_default())
}

/// Parses a commit or checkpoint, after checking its version.
fn parse<T: for<'a> Deserialize<'a>>(
    place: &StorePlace,
    name: &str,
    bytes: &[u8],
) -> Result<T, FleetError> {
    #[derive(Deserialize)]
    struct Versioned {
        version: [u32; 2],
    }
    let broken = |error: serde_json::Error| FleetError::Damaged {
        object: place.shown(name),
        what: error.to_string(),
    };
    let Versioned { version } = serde_json::from_slice(bytes).map_err(broken)?;
    if version[0] > VERSION[0] {
        return Err(FleetError::Version {
            object: place.shown(name),
            found: version,
            limit: VERSION[0],
        });
    }
    serde_json::from_slice(bytes).map_err(broken)
}
