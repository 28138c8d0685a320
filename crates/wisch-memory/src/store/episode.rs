//! A stored episode.

use super::error::{MemoryError, at};
use super::sums::{FileSum, SUMS_FILE, Sums};
use super::{RECORD_FILE, URDF_FILE};
use crate::observations::RoundObservations;
use crate::record::EpisodeRecord;
use crate::telemetry::Telemetry;
use std::fs::{self, File};
use std::io::Seek;
use std::path::{Component, Path, PathBuf};

/// An episode of a memory, whose parts are read on demand.
#[derive(Debug, Clone)]
pub struct Episode {
    id: String,
    folder: PathBuf,
}

impl Episode {
    pub(super) fn new(id: &str, folder: PathBuf) -> Self {
        Self {
            id: id.to_owned(),
            folder,
        }
    }

    /// Name of the episode in its memory.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Path of the folder that holds the episode.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Reads the record of the episode.
    ///
    /// # Errors
    /// If the record cannot be read, differs from what was written, or contradicts itself.
    pub fn record(&self) -> Result<EpisodeRecord, MemoryError> {
        let path = self.folder.join(RECORD_FILE);
        if let Some(written) = self.sums()?.get(RECORD_FILE)
            && let Some(what) = written.difference(&FileSum::of(&path)?)
        {
            return Err(MemoryError::Changed { path, what });
        }
        let bytes = fs::read(&path).map_err(at(&path))?;
        let record: EpisodeRecord =
            serde_json::from_slice(&bytes).map_err(|error| MemoryError::Json {
                path: path.clone(),
                what: error.to_string(),
            })?;
        if record.id != self.id {
            return Err(MemoryError::Other {
                path,
                id: self.id.clone(),
                found: record.id,
            });
        }
        match record.check() {
            Ok(()) => Ok(record),
            Err(fault) => Err(MemoryError::Record { path, fault }),
        }
    }

    /// Returns the telemetry of a round, counted from 1. It is verified against its check sums as it is read.
    ///
    /// # Errors
    /// If the round has no telemetry, or it cannot be read.
    pub fn telemetry(&self, round: usize) -> Result<Telemetry, MemoryError> {
        let name = telemetry_file(round);
        let path = self.folder.join(&name);
        let sums = self.sums()?;
        let sums = sums.get(&name).map(|written| written.of_blocks(&path));
        Ok(Telemetry::open_checked(&path, sums.transpose()?)?)
    }

    /// Whether a round, counted from 1, has telemetry.
    ///
    /// # Errors
    /// If the check sums cannot be read.
    pub fn has_telemetry(&self, round: usize) -> Result<bool, MemoryError> {
        Ok(self.sums()?.contains_key(&telemetry_file(round)))
    }

    /// Whether it holds the robot; the episode of an imported log does not.
    pub fn has_robot(&self) -> bool {
        self.folder.join(URDF_FILE).is_file()
    }

    /// Returns the error that a round, counted from 1, has no telemetry, with the reason if known.
    pub fn without_telemetry(&self, round: usize) -> MemoryError {
        let record = self.record().ok();
        let why = record.and_then(|record| record.telemetry_lost(round));
        MemoryError::NoTelemetry {
            id: self.id.clone(),
            round,
            why: why.unwrap_or_default(),
        }
    }

    /// Returns the observations of the dirt before and after a round, counted from 1; `None` without a camera, and for
    /// episodes from before observations were stored.
    ///
    /// # Errors
    /// If the file is missing, differs from what was written, or cannot be read.
    pub fn observations(&self, round: usize) -> Result<Option<RoundObservations>, MemoryError> {
        let name = observations_file(round);
        let sums = self.sums()?;
        let Some(written) = sums.get(&name) else {
            return Ok(None);
        };
        let path = self.folder.join(&name);
        if let Some(what) = written.difference(&FileSum::of(&path)?) {
            return Err(MemoryError::Changed { path, what });
        }
        let bytes = fs::read(&path).map_err(at(&path))?;
        match RoundObservations::from_json(&bytes) {
            Ok(observations) => Ok(Some(observations)),
            Err(fault) => Err(MemoryError::Observations { path, fault }),
        }
    }

    /// Returns length and check sum of each of its files when it was written.
    pub(super) fn sums(&self) -> Result<Sums, MemoryError> {
        let path = self.folder.join(SUMS_FILE);
        let bytes = fs::read(&path).map_err(at(&path))?;
        serde_json::from_slice(&bytes).map_err(|error| MemoryError::Json {
            path,
            what: error.to_string(),
        })
    }

    /// Returns the contents of a file, for example `task.toml` or `round-1/plan.json`.
    ///
    /// # Errors
    /// If the name leads out of the episode, or the file cannot be read.
    pub fn attachment(&self, name: &str) -> Result<Vec<u8>, MemoryError> {
        check_name(&self.id, name)?;
        let path = self.folder.join(name);
        fs::read(&path).map_err(at(&path))
    }

    /// Opens a file after verifying it against its check sum, without keeping it in memory.
    ///
    /// # Errors
    /// As [`Self::attachment`]; also if the file differs from what was written.
    pub fn open_checked(&self, name: &str) -> Result<File, MemoryError> {
        check_name(&self.id, name)?;
        let path = self.folder.join(name);
        let mut file = File::open(&path).map_err(at(&path))?;
        if let Some(written) = self.sums()?.get(name)
            && let Some(what) = written.difference(&FileSum::of_opened(&mut file, &path)?)
        {
            return Err(MemoryError::Changed { path, what });
        }
        file.rewind().map_err(at(&path))?;
        Ok(file)
    }

    /// Returns the names of all its files, sorted, with `/` between folder and file.
    ///
    /// # Errors
    /// If a folder cannot be read.
    pub fn files(&self) -> Result<Vec<String>, MemoryError> {
        files_in(&self.folder)
    }
}

/// Returns the names of all files in a folder and its subfolders, sorted.
pub(super) fn files_in(folder: &Path) -> Result<Vec<String>, MemoryError> {
    let mut names = Vec::new();
    list(folder, "", &mut names)?;
    names.sort_unstable();
    Ok(names)
}

fn list(folder: &Path, before: &str, names: &mut Vec<String>) -> Result<(), MemoryError> {
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let entry = entry.map_err(at(folder))?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            list(&entry.path(), &format!("{name}/"), names)?;
        } else {
            names.push(name);
        }
    }
    Ok(())
}

/// Name of a round's telemetry file.
pub(super) fn telemetry_file(round: usize) -> String {
    format!("round-{round}.parquet")
}

/// Name of a round's observations file.
pub(super) fn observations_file(round: usize) -> String {
    format!("round-{round}/observations.json")
}

/// Checks that a name stays in the episode and is not reserved for the store.
pub(super) fn check_name(id: &str, name: &str) -> Result<(), MemoryError> {
    if [RECORD_FILE, SUMS_FILE].contains(&name) {
        return Err(MemoryError::Name {
            id: id.to_owned(),
            name: name.to_owned(),
        });
    }
    check_place(id, name)
}

/// Checks that a name stays in the episode.
pub(super) fn check_place(id: &str, name: &str) -> Result<(), MemoryError> {
    let mut parts = Path::new(name).components();
    let stays = parts.clone().next().is_some()
        && parts.all(|part| matches!(part, Component::Normal(_)))
        && !name.contains('\\');
    if stays {
        return Ok(());
    }
    Err(MemoryError::Name {
        id: id.to_owned(),
        name: name.to_owned(),
    })
}
