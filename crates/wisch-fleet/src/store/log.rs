//! The log: which files count. A commit is one object, created if nobody else has; who loses reads what won and tries the next
//! number.

use super::error::FleetError;
use super::place::{Created, StorePlace};
use crate::tables::file::VERSION;
use bytes::Bytes;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

/// After so many commits what they come to is written down, so that nobody reads the whole log.
const CHECKPOINT_EVERY: u64 = 16;
const LATEST: &str = "checkpoint/latest";

/// A file of rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FileEntry {
    /// The object.
    pub path: String,
    /// The table.
    pub table: String,
    /// First and last robot by name.
    pub robots: [String; 2],
    /// First and last day, as `2026-11-22`.
    pub days: [String; 2],
    /// How many rows.
    pub rows: u64,
    /// Its length.
    pub bytes: u64,
    /// Of its bytes.
    pub sha256: String,
    /// Version: major and minor.
    pub schema: [u32; 2],
    /// When the first of its episodes began and the last ended [s since 1970].
    pub times: [f64; 2],
    /// The episodes in it, where they are few.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub episodes: Option<Vec<String>>,
}

/// What is done at once.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Commit {
    /// Version: major and minor.
    pub version: [u32; 2],
    /// Tells it from every other, so that who wrote it knows it again.
    pub token: String,
    /// When [s since 1970].
    pub time: f64,
    /// What for, such as `push`.
    pub what: String,
    /// Files that count from now on.
    pub add: Vec<FileEntry>,
    /// Files that do not any more, by path.
    pub remove: Vec<String>,
    /// Telemetry is kept of this day and later ones only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub telemetry_since: Option<String>,
}

/// A file that does not count any more, but may be read by who began before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Removed {
    /// The object.
    pub path: String,
    /// When it was taken out of the log [s since 1970].
    pub time: f64,
}

/// What all commits up to one come to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Version: major and minor.
    pub version: [u32; 2],
    /// The next commit's number; what all before it did is in here.
    pub next: u64,
    /// The files that count, by path.
    pub files: BTreeMap<String, FileEntry>,
    /// Files that do not any more, until they are deleted.
    pub removed: Vec<Removed>,
    /// Telemetry is kept of this day and later ones only.
    pub telemetry_since: Option<String>,
}

/// What came of a commit.
#[derive(Debug, Clone, PartialEq)]
pub enum Committed {
    /// It counts.
    Done,
    /// Others were faster: these.
    Lost(Vec<Commit>),
}

/// The time of the clock [s since 1970]: nothing else of this crate looks at it.
pub fn now() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_secs_f64()
}

impl Commit {
    /// One that does nothing yet.
    pub fn new(what: &str) -> Self {
        let time = now();
        // Two processes at the same moment have different numbers, two commits of one process different times.
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
    /// As the fleet is now; empty where there is none yet.
    ///
    /// # Errors
    /// What the store says, or a log that cannot be read.
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
        parsed(place, &name, &bytes).map(Some)
    }

    /// Reads what was committed since: those commits.
    ///
    /// # Errors
    /// What the store says, or a log that cannot be read.
    pub async fn refresh(&mut self, place: &StorePlace) -> Result<Vec<Commit>, FleetError> {
        let mut newer = Vec::new();
        loop {
            let name = commit_name(self.next);
            let Some(bytes) = place.find(&name).await? else {
                return Ok(newer);
            };
            let commit: Commit = parsed(place, &name, &bytes)?;
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
            // A file of the same bytes may come back.
            self.removed.retain(|removed| removed.path != file.path);
            let mut file = file.clone();
            // Whose commit lost the race looks them up in the winner's commit.
            file.episodes = None;
            self.files.insert(file.path.clone(), file);
        }
        if commit.what == "purge" {
            // What a purge names was deleted after it.
            self.removed
                .retain(|removed| !commit.remove.contains(&removed.path));
        }
        if let Some(since) = &commit.telemetry_since {
            self.telemetry_since = self.telemetry_since.take().max(Some(since.clone()));
        }
        self.next += 1;
    }

    /// Commits, if nobody was faster.
    ///
    /// # Errors
    /// What the store says.
    pub async fn commit(
        &mut self,
        place: &StorePlace,
        commit: &Commit,
    ) -> Result<Committed, FleetError> {
        let name = commit_name(self.next);
        let created = place.create(&name, to_json(commit)).await?;
        if created == Created::There {
            let newer = self.refresh(place).await?;
            // The store's answer to our own request may have been lost on the way.
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

    /// The files of a table.
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
    // Texts, finite numbers and lists of them always have a form in JSON.
    Bytes::from(serde_json::to_vec(value).unwrap_or_default())
}

/// A commit or a checkpoint; its version is looked at first, as what else it says may have changed.
fn parsed<T: for<'a> Deserialize<'a>>(
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
