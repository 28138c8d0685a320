//! The memory on disk: a folder with a folder for each episode.
//!
//! ```text
//! episodes/
//!   20261122-005612-3f2a/    an episode, whole
//!     episode.json           its record
//!     checksums.json         length and CRC-32 of each file
//!     round-1.parquet        telemetry
//!     round-1/               what belongs to a round
//!       observations.json    what a camera saw of the dirt before and after it; absent where nothing looked
//!       plan.json, …
//!     task.toml, robot.urdf, …
//!   .new/                    apart, so that finding what is left over there does not mean going through all
//!     20261122-010203-…/     an episode that is being written
//!     20261122-010203-….lock held by who writes it
//!     .lock                  held for moments: who begins, clears up or rewrites the catalogue
//!   .catalogue/              the graphs of all episodes in tables; may go at any time
//! ```
//!
//! An episode comes to its place by one rename, after all of it has reached the disk: it is there whole or not
//! at all. What a writer that died has left behind is cleared away by the next.

mod catalogue;
mod episode;
mod error;
mod sums;
mod verify;
mod writer;

pub use episode::Episode;
pub use error::MemoryError;
pub use verify::Fault;
pub use writer::EpisodeWriter;

use crate::told::forget_episode;
use error::at;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// An episode's record in its folder.
pub const RECORD_FILE: &str = "episode.json";
/// The robot of an episode.
pub(crate) const URDF_FILE: &str = "robot.urdf";

/// Longest name of an episode [characters]; file systems take 255 bytes.
const MAX_ID_LEN: usize = 80;

/// Where episodes are on their way into the memory, or out of it.
const NEW_FOLDER: &str = ".new";
const LOCK_ENDING: &str = ".lock";
const FORGOTTEN_ENDING: &str = ".forgotten";
const MEMORY_LOCK: &str = ".lock";
/// What is left of what was told, until it takes its place.
const TOLD_FILE: &str = ".told";

/// The recording of an episode, as `wisch studio` and reports show it: JSON lines, packed.
pub const RECORDING_FILE: &str = "recording.jsonl.gz";

/// Where a run that goes on lets others look on: in `jsonl` lines that grow, in `json` who writes them. There is nothing any
/// more once its episode, of this name, is in the memory.
pub fn live_place(memory: &Path, id: &str, ending: &str) -> PathBuf {
    memory.join(".live").join(format!("{id}.{ending}"))
}

/// A memory of episodes.
///
/// Any number of programs may read and write at the same time; each episode has one writer.
///
/// ```
/// use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin};
///
/// # let folder = tempfile::tempdir()?;
/// let memory = Memory::create(&folder.path().join("episodes"))?;
/// let writer = memory.begin("20261122-005612-3f2a")?;
/// writer.attach("task.toml", b"name = \"board\"")?;
/// writer.commit(&EpisodeRecord {
///     schema: EPISODE_SCHEMA,
///     id: "20261122-005612-3f2a".into(),
///     task: "board".into(),
///     interval: [0.0, 1.0],
///     origin: Origin::Simulated,
///     program: "wisch".into(),
///     seed: 0,
///     rounds: vec![0.0],
///     individuals: vec![Individual {
///         class: "semco:WipingEpisode".into(),
///         interval: Some([0.0, 1.0]),
///         parent: None,
///         relations: Default::default(),
///         values: Default::default(),
///     }],
/// })?;
///
/// assert_eq!(memory.episodes()?, ["20261122-005612-3f2a"]);
/// assert_eq!(memory.catalogue()?.of_class("semco:WipingEpisode").len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Memory {
    folder: PathBuf,
}

impl Memory {
    /// The memory in a folder.
    ///
    /// # Errors
    /// If there is no such folder.
    pub fn open(folder: &Path) -> Result<Self, MemoryError> {
        if !folder.is_dir() {
            return Err(MemoryError::NoMemory {
                path: folder.to_path_buf(),
            });
        }
        Ok(Self {
            folder: folder.to_path_buf(),
        })
    }

    /// The memory in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// What the system says.
    pub fn create(folder: &Path) -> Result<Self, MemoryError> {
        fs::create_dir_all(folder).map_err(at(folder))?;
        Self::open(folder)
    }

    /// Where it stands.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The names of its episodes, sorted.
    ///
    /// # Errors
    /// What the system says.
    pub fn episodes(&self) -> Result<Vec<String>, MemoryError> {
        let mut names: Vec<String> = entries(&self.folder)?;
        names.retain(|name| is_id(name));
        names.sort_unstable();
        Ok(names)
    }

    /// An episode.
    ///
    /// # Errors
    /// If there is none of this name.
    pub fn episode(&self, id: &str) -> Result<Episode, MemoryError> {
        let folder = self.folder.join(id);
        if is_id(id) && folder.is_dir() {
            return Ok(Episode::new(id, folder));
        }
        let likeness = |other: &String| strsim::jaro_winkler(id, other);
        let names = self.episodes()?.into_iter();
        let nearest = names.max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        Err(MemoryError::Unknown {
            path: self.folder.clone(),
            id: id.to_owned(),
            nearest: nearest.unwrap_or_default(),
        })
    }

    /// Begins an episode, after clearing away what dead writers have left.
    ///
    /// # Errors
    /// A name that is none or taken, or what the system says.
    pub fn begin(&self, id: &str) -> Result<EpisodeWriter, MemoryError> {
        check_id(id)?;
        let guard = self.lock()?;
        self.clear_up()?;
        let place = self.folder.join(id);
        let new = self.new_place(id);
        if place.exists() || new.exists() {
            return Err(MemoryError::Exists {
                path: self.folder.clone(),
                id: id.to_owned(),
            });
        }
        let lock_path = self.lock_place(id);
        let lock = File::create(&lock_path).map_err(at(&lock_path))?;
        lock.lock().map_err(at(&lock_path))?;
        fs::create_dir(&new).map_err(at(&new))?;
        drop(guard);
        Ok(EpisodeWriter::new(self.clone(), id, lock))
    }

    /// Forgets an episode for good.
    ///
    /// # Errors
    /// If there is none of this name, or what the system says.
    pub fn forget(&self, id: &str) -> Result<(), MemoryError> {
        let episode = self.episode(id)?;
        let guard = self.lock()?;
        self.note_forgotten(id)?;
        // By one rename, so that nobody meets half of it.
        let gone = (self.folder.join(NEW_FOLDER)).join(format!("{id}{FORGOTTEN_ENDING}"));
        remove_folder(&gone)?;
        fs::rename(episode.folder(), &gone).map_err(at(episode.folder()))?;
        sync_folder(&self.folder)?;
        // What was told of it is answered no more, as it is of no episode; now it is removed as well.
        let aside = self.folder.join(NEW_FOLDER).join(TOLD_FILE);
        forget_episode(&self.folder, id, &aside).map_err(at(&self.folder))?;
        // Under the lock still: another of this name may be forgotten next.
        remove_folder(&gone)?;
        drop(guard);
        Ok(())
    }

    /// Holds others off who begin an episode, clear up or rewrite the catalogue.
    fn lock(&self) -> Result<File, MemoryError> {
        let (path, file) = self.memory_lock()?;
        file.lock().map_err(at(&path))?;
        Ok(file)
    }

    /// The same, if nobody else does at this moment.
    fn try_lock(&self) -> Result<Option<File>, MemoryError> {
        let (path, file) = self.memory_lock()?;
        match file.try_lock() {
            Ok(()) => Ok(Some(file)),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(at(&path)(error)),
        }
    }

    fn memory_lock(&self) -> Result<(PathBuf, File), MemoryError> {
        let folder = self.folder.join(NEW_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let path = folder.join(MEMORY_LOCK);
        let file = File::create(&path).map_err(at(&path))?;
        Ok((path, file))
    }

    /// Where an episode stands while it is written.
    fn new_place(&self, id: &str) -> PathBuf {
        self.folder.join(NEW_FOLDER).join(id)
    }

    /// What its writer holds.
    fn lock_place(&self, id: &str) -> PathBuf {
        let folder = self.folder.join(NEW_FOLDER);
        folder.join(format!("{id}{LOCK_ENDING}"))
    }

    /// Clears away what dead writers have left. Only under the memory's lock: a writer that has just made its
    /// folder is not to be taken for dead.
    fn clear_up(&self) -> Result<(), MemoryError> {
        let folder = self.folder.join(NEW_FOLDER);
        for name in entries(&folder)? {
            if name.ends_with(FORGOTTEN_ENDING) {
                remove_folder(&folder.join(&name))?;
                continue;
            }
            if name == TOLD_FILE {
                remove_file(&folder.join(&name))?;
                continue;
            }
            let id = name.strip_suffix(LOCK_ENDING).unwrap_or(&name);
            // The memory's own lock is no episode's.
            if !is_id(id) {
                continue;
            }
            let lock_path = self.lock_place(id);
            // Without a lock to hold, nobody writes; with one that can be had, nobody does any more.
            let dead = match File::open(&lock_path) {
                Ok(file) => match file.try_lock() {
                    Ok(()) => true,
                    Err(TryLockError::WouldBlock) => false,
                    Err(TryLockError::Error(error)) => return Err(at(&lock_path)(error)),
                },
                Err(error) if error.kind() == io::ErrorKind::NotFound => true,
                Err(error) => return Err(at(&lock_path)(error)),
            };
            if dead {
                remove_folder(&self.new_place(id))?;
                remove_file(&lock_path)?;
            }
        }
        Ok(())
    }
}

/// The names of all that is in a folder.
fn entries(folder: &Path) -> Result<Vec<String>, MemoryError> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let entry = entry.map_err(at(folder))?;
        // Names of ours are plain; those that are no text are none of ours.
        names.extend(entry.file_name().into_string());
    }
    Ok(names)
}

/// Whether a folder of this name is an episode's.
fn is_id(name: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
    !name.is_empty() && name.len() <= MAX_ID_LEN && name.chars().all(plain)
}

fn check_id(id: &str) -> Result<(), MemoryError> {
    if is_id(id) {
        return Ok(());
    }
    Err(MemoryError::Id {
        id: id.to_owned(),
        limit: MAX_ID_LEN,
    })
}

/// Makes the names in a folder lasting, where the system can.
fn sync_folder(folder: &Path) -> Result<(), MemoryError> {
    if cfg!(unix) {
        let synced = File::open(folder).and_then(|folder| folder.sync_all());
        synced.map_err(at(folder))?;
    }
    Ok(())
}

/// Removes a folder with all that is in it, if it is there.
fn remove_folder(folder: &Path) -> Result<(), MemoryError> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(at(folder)(error)),
        _ => Ok(()),
    }
}

fn remove_file(file: &Path) -> Result<(), MemoryError> {
    match fs::remove_file(file) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(at(file)(error)),
        _ => Ok(()),
    }
}
