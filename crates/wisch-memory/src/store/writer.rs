//! Writer of an episode.

use super::episode::{
    Episode, check_name, check_place, files_in, observations_file, telemetry_file,
};
use super::error::{MemoryError, at};
use super::sums::{FileSum, SUMS_FILE, Sums};
use super::{Memory, RECORD_FILE, remove_file, remove_folder, sync_folder};
use crate::observations::RoundObservations;
use crate::record::EpisodeRecord;
use crate::telemetry::{TelemetryHead, TelemetryWriter};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

/// An episode in progress. If dropped without a commit, it is removed; if killed, the next writer removes it.
#[derive(Debug)]
pub struct EpisodeWriter {
    memory: Memory,
    id: String,
    folder: PathBuf,
    /// Lock that is held until the episode is in place.
    _lock: File,
}

impl EpisodeWriter {
    pub(super) fn new(memory: Memory, id: &str, lock: File) -> Self {
        Self {
            folder: memory.new_place(id),
            memory,
            id: id.to_owned(),
            _lock: lock,
        }
    }

    /// Name of the episode in its memory.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Paths of the episode and its lock, which the commit removes. After a kill, the next writer removes them.
    pub fn unfinished_paths(&self) -> [PathBuf; 2] {
        [self.folder.clone(), self.memory.lock_place(&self.id)]
    }

    /// Begins the telemetry of a round, counted from 1, which must be finished before the commit.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn telemetry(
        &self,
        round: usize,
        head: TelemetryHead,
    ) -> Result<TelemetryWriter, MemoryError> {
        let path = self.folder.join(telemetry_file(round));
        Ok(TelemetryWriter::create(&path, head)?)
    }

    /// Begins the telemetry of a round with the columns of a log.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn telemetry_with_columns(
        &self,
        round: usize,
        head: TelemetryHead,
        columns: &[String],
    ) -> Result<TelemetryWriter, MemoryError> {
        let path = self.folder.join(telemetry_file(round));
        Ok(TelemetryWriter::with_columns(&path, head, columns)?)
    }

    /// Adds the observations before and after a round, counted from 1; does nothing without observations.
    ///
    /// # Errors
    /// If a number is not finite, a pose is invalid, or a file cannot be written.
    pub fn observations(
        &self,
        round: usize,
        observations: &RoundObservations,
    ) -> Result<(), MemoryError> {
        if !observations.is_any() {
            return Ok(());
        }
        let name = observations_file(round);
        let text = (observations.to_json()).map_err(|fault| MemoryError::Observations {
            path: self.folder.join(&name),
            fault,
        })?;
        self.attach(&name, text)
    }

    /// Adds a file, for example `task.toml` or `round-1/plan.json`.
    ///
    /// # Errors
    /// If the name leads out of the episode or is reserved, or the file cannot be written.
    pub fn attach(&self, name: &str, contents: impl AsRef<[u8]>) -> Result<(), MemoryError> {
        check_name(&self.id, name)?;
        let path = self.folder.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(at(parent))?;
        }
        write_lasting(&path, contents.as_ref())
    }

    /// Commits the episode with this record: moves it into the memory.
    ///
    /// # Errors
    /// If the record belongs to another episode or contradicts itself, telemetry is not finished, or a file cannot be
    /// written; then the memory does not hold the episode.
    pub fn commit(self, record: &EpisodeRecord) -> Result<(), MemoryError> {
        let path = self.folder.join(RECORD_FILE);
        let place = self.memory.folder.join(&self.id);
        if record.id != self.id {
            return Err(MemoryError::Other {
                path: place.join(RECORD_FILE),
                id: self.id.clone(),
                found: record.id.clone(),
            });
        }
        record.check().map_err(|fault| MemoryError::Record {
            path: place.join(RECORD_FILE),
            fault,
        })?;
        let text = serde_json::to_vec(record).map_err(|error| MemoryError::Json {
            path: path.clone(),
            what: error.to_string(),
        })?;
        write_lasting(&path, &text)?;
        let sums = self.sums()?;
        write_lasting(&self.folder.join(SUMS_FILE), sums.as_bytes())?;
        self.move_to_place(&place)
    }

    /// Adds a file of an episode that is copied from elsewhere, including its record and check sums.
    ///
    /// # Errors
    /// If the name leads out of the episode, or the file cannot be written.
    pub fn restore(&self, name: &str, contents: &[u8]) -> Result<(), MemoryError> {
        check_place(&self.id, name)?;
        let path = self.folder.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(at(parent))?;
        }
        write_lasting(&path, contents)
    }

    /// Commits an episode whose files were all [restored](Self::restore), after verifying each file against its check
    /// sum.
    ///
    /// # Errors
    /// If a file is missing or differs from what was written, or cannot be moved; then the memory does not hold the
    /// episode.
    pub fn commit_restored(self) -> Result<(), MemoryError> {
        let copied = Episode::new(&self.id, self.folder.clone());
        if let Some(error) = copied.faults().into_iter().next() {
            return Err(error);
        }
        let place = self.memory.folder.join(&self.id);
        self.move_to_place(&place)
    }

    /// Moves the episode into the memory by one rename, after all of it is on disk.
    fn move_to_place(&self, place: &Path) -> Result<(), MemoryError> {
        for folder in folders_in(&self.folder)? {
            sync_folder(&folder)?;
        }
        fs::rename(&self.folder, place).map_err(at(place))?;
        sync_folder(&self.memory.folder)
    }
}

impl EpisodeWriter {
    /// Returns the check sums of all files, by which later damage is found.
    fn sums(&self) -> Result<String, MemoryError> {
        let mut sums = Sums::new();
        for name in files_in(&self.folder)? {
            sums.insert(name.clone(), FileSum::of(&self.folder.join(name))?);
        }
        serde_json::to_string(&sums).map_err(|error| MemoryError::Json {
            path: self.folder.join(SUMS_FILE),
            what: error.to_string(),
        })
    }
}

impl Drop for EpisodeWriter {
    fn drop(&mut self) {
        // After a commit this folder is gone; the next writer removes what cannot be removed now.
        let lock = self.memory.lock_place(&self.id);
        let _ = remove_folder(&self.folder).and_then(|()| remove_file(&lock));
    }
}

fn write_lasting(path: &Path, contents: &[u8]) -> Result<(), MemoryError> {
    let written = File::create(path).and_then(|mut file| {
        file.write_all(contents)?;
        file.sync_all()
    });
    written.map_err(at(path))
}

/// Returns a folder and its subfolders. Unfinished telemetry is an error, because only part of it would be stored.
fn folders_in(folder: &Path) -> Result<BTreeSet<PathBuf>, MemoryError> {
    let mut folders = BTreeSet::from([folder.to_path_buf()]);
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let path = entry.map_err(at(folder))?.path();
        if path.is_dir() {
            folders.extend(folders_in(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "active") {
            return Err(MemoryError::Unfinished { path });
        }
    }
    Ok(folders)
}
