//! The memory on disk: a folder with a subfolder for each episode.
//!
//! ```text
//! episodes/
//!   20261122-005612-3f2a/    a complete episode
//!     episode.json           its record
//!     checksums.json         length and CRC-32 of each file
//!     round-1.parquet        telemetry
//!     round-1/               files of a round
//!       observations.json    camera observations of the dirt before and after it; absent without a camera
//!       plan.json, …
//!     task.toml, robot.urdf, …
//!   .new/                    separate, so that cleaning up need not search the whole memory
//!     20261122-010203-…/     an episode that is being written
//!     20261122-010203-….lock held by its writer
//!     .lock                  held briefly to begin an episode, clean up or rewrite the catalogue
//!     .import.lock           held while an interpreted log becomes an episode
//!   .catalogue/              the graphs of all episodes in tables; may be deleted at any time
//! ```
//!
//! An episode reaches its path by one rename, after all of it is on disk: it is there completely or not at all. The
//! next writer cleans up after a writer that was killed.

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

use crate::statements::forget_episode;
use error::at;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// Name of the file with an episode's record.
pub const RECORD_FILE: &str = "episode.json";
/// File of an episode's robot.
pub(crate) const URDF_FILE: &str = "robot.urdf";

/// Largest length of an episode's name [characters]; file systems allow 255 bytes.
const MAX_ID_LEN: usize = 80;

/// Folder of episodes on their way into or out of the memory.
const NEW_FOLDER: &str = ".new";
const LOCK_ENDING: &str = ".lock";
const FORGOTTEN_ENDING: &str = ".forgotten";
const MEMORY_LOCK: &str = ".lock";
const IMPORT_LOCK: &str = ".import.lock";
/// Temporary file for the remaining statements, until it replaces the old one.
const TOLD_FILE: &str = ".told";

/// Recording of an episode, which `wisch studio` and reports show: JSON lines, compressed.
pub const RECORDING_FILE: &str = "recording.jsonl.gz";

/// Returns the path of a file by which a run publishes its progress. `ending`: `jsonl` for the
/// recording so far, one JSON object per line; `json` for process, task and start of the run. Both
/// files disappear once the episode with this name is in the memory.
pub fn live_path(memory: &Path, id: &str, ending: &str) -> PathBuf {
    memory.join(".live").join(format!("{id}.{ending}"))
}

/// A memory of episodes in a folder.
///
/// Any number of programs may read and write simultaneously; each episode has one writer.
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
/// assert_eq!(memory.catalogue()?.individuals_of_class("semco:WipingEpisode").len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Memory {
    folder: PathBuf,
}

impl Memory {
    /// Opens the memory in a folder.
    ///
    /// # Errors
    /// If the folder does not exist.
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

    /// Opens the memory in a folder, creating the folder if necessary.
    ///
    /// # Errors
    /// If the folder cannot be created.
    pub fn create(folder: &Path) -> Result<Self, MemoryError> {
        fs::create_dir_all(folder).map_err(at(folder))?;
        Self::open(folder)
    }

    /// Path of the folder that holds the memory.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the names of its episodes, sorted.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn episodes(&self) -> Result<Vec<String>, MemoryError> {
        let mut names: Vec<String> = entries(&self.folder)?;
        names.retain(|name| is_id(name));
        names.sort_unstable();
        Ok(names)
    }

    /// Opens an episode. `id`: its name.
    ///
    /// # Errors
    /// If no episode has this name.
    pub fn episode(&self, id: &str) -> Result<Episode, MemoryError> {
        let folder = self.folder.join(id);
        if is_id(id) && folder.is_dir() {
            return Ok(Episode::new(id, folder));
        }
        // The beginning of a name is usually what was meant.
        let likeness =
            |other: &String| f64::from(other.starts_with(id)) + strsim::jaro_winkler(id, other);
        let names = self.episodes()?.into_iter();
        let nearest = names.max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        Err(MemoryError::Unknown {
            path: self.folder.clone(),
            id: id.to_owned(),
            nearest: nearest.unwrap_or_default(),
        })
    }

    /// Begins an episode, after cleaning up after writers that were killed.
    ///
    /// # Errors
    /// If the name is invalid or taken, or a file cannot be written.
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

    /// Deletes an episode from the memory. `id`: its name.
    ///
    /// # Errors
    /// If no episode has this name, or a file cannot be removed.
    pub fn forget(&self, id: &str) -> Result<(), MemoryError> {
        let episode = self.episode(id)?;
        let guard = self.lock()?;
        // On a full disk, the note fails until the episode is removed.
        let noted = self.note_forgotten(id);
        if noted.as_ref().is_err_and(|error| !error.is_disk_full()) {
            return noted;
        }
        // By one rename, so that no reader meets a partial episode.
        let removed = (self.folder.join(NEW_FOLDER)).join(format!("{id}{FORGOTTEN_ENDING}"));
        remove_folder(&removed)?;
        fs::rename(episode.folder(), &removed).map_err(at(episode.folder()))?;
        sync_folder(&self.folder)?;
        // Still under the lock: another episode with this name may be deleted next.
        remove_folder(&removed)?;
        if noted.is_err() {
            self.note_forgotten(id)?;
        }
        // Statements about the episode answer no queries any more, as their subject is gone; remove them as well.
        let aside = self.folder.join(NEW_FOLDER).join(TOLD_FILE);
        forget_episode(&self.folder, id, &aside).map_err(at(&self.folder))?;
        drop(guard);
        Ok(())
    }

    /// Locks the memory against other processes that begin an episode, clean up or rewrite the catalogue.
    fn lock(&self) -> Result<File, MemoryError> {
        let (path, file) = self.memory_lock()?;
        file.lock().map_err(at(&path))?;
        Ok(file)
    }

    /// Waits until no other process imports a log into this memory, and keeps them waiting until the file is dropped. Without
    /// it, processes that import one log at once would each keep it.
    ///
    /// # Errors
    /// If the lock cannot be created.
    pub fn wait_for_imports(&self) -> Result<File, MemoryError> {
        let folder = self.folder.join(NEW_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let path = folder.join(IMPORT_LOCK);
        let file = File::create(&path).map_err(at(&path))?;
        file.lock().map_err(at(&path))?;
        Ok(file)
    }

    /// Locks the memory if no other process holds the lock.
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

    /// Path of an episode while it is written.
    fn new_place(&self, id: &str) -> PathBuf {
        self.folder.join(NEW_FOLDER).join(id)
    }

    /// Path of the lock that its writer holds.
    fn lock_place(&self, id: &str) -> PathBuf {
        let folder = self.folder.join(NEW_FOLDER);
        folder.join(format!("{id}{LOCK_ENDING}"))
    }

    /// Removes what killed writers have left. The caller must hold the memory's lock, because a new writer's folder
    /// must not count as abandoned.
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
            // The memory's own lock belongs to no episode.
            if !is_id(id) {
                continue;
            }
            let lock_path = self.lock_place(id);
            // An episode whose lock is missing or free has no writer any more.
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

/// Returns the names of all entries in a folder.
fn entries(folder: &Path) -> Result<Vec<String>, MemoryError> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let entry = entry.map_err(at(folder))?;
        // Names by this program are plain text; entries with other names are ignored.
        names.extend(entry.file_name().into_string());
    }
    Ok(names)
}

/// Whether a folder's name can be an episode's.
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

/// Syncs the entries of a folder to disk, where the system can.
fn sync_folder(folder: &Path) -> Result<(), MemoryError> {
    if cfg!(unix) {
        let synced = File::open(folder).and_then(|folder| folder.sync_all());
        synced.map_err(at(folder))?;
    }
    Ok(())
}

/// Removes a folder with its contents, if it exists.
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
