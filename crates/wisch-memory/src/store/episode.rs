//! An episode that is there.

use super::error::{MemoryError, at};
use super::sums::{FileSum, SUMS_FILE, Sums};
use super::{RECORD_FILE, URDF_FILE};
use crate::observations::RoundObservations;
use crate::record::EpisodeRecord;
use crate::telemetry::Telemetry;
use std::fs::{self, File};
use std::io::Seek;
use std::path::{Component, Path, PathBuf};

/// An episode of a memory; what is asked of it is read then.
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

    /// Its name.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Where it stands.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Its record.
    ///
    /// # Errors
    /// A record that cannot be read, is not what was written, or contradicts itself.
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

    /// The telemetry of a round, from 1. What is read of it is held against its check sums.
    ///
    /// # Errors
    /// If there is none, or it cannot be read.
    pub fn telemetry(&self, round: usize) -> Result<Telemetry, MemoryError> {
        let name = telemetry_file(round);
        let path = self.folder.join(&name);
        let sums = self.sums()?;
        let sums = sums.get(&name).map(|written| written.of_blocks(&path));
        Ok(Telemetry::open_checked(&path, sums.transpose()?)?)
    }

    /// Whether the telemetry of a round, from 1, was kept.
    ///
    /// # Errors
    /// An episode whose check sums cannot be read.
    pub fn has_telemetry(&self, round: usize) -> Result<bool, MemoryError> {
        Ok(self.sums()?.contains_key(&telemetry_file(round)))
    }

    /// Whether it holds the robot that wiped; a log does not.
    pub fn has_robot(&self) -> bool {
        self.folder.join(URDF_FILE).is_file()
    }

    /// Says that the telemetry of a round, from 1, was not kept, and why where that is known.
    pub fn without_telemetry(&self, round: usize) -> MemoryError {
        let record = self.record().ok();
        let why = record.and_then(|record| record.telemetry_lost(round));
        MemoryError::NoTelemetry {
            id: self.id.clone(),
            round,
            why: why.unwrap_or_default(),
        }
    }

    /// What was seen of the dirt before and after a round, from 1; `None` where nothing looked, and in episodes that were
    /// written when this was not kept.
    ///
    /// # Errors
    /// A file that is missing, is not what was written, or cannot be read.
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

    /// What each of its files was when it was written.
    pub(super) fn sums(&self) -> Result<Sums, MemoryError> {
        let path = self.folder.join(SUMS_FILE);
        let bytes = fs::read(&path).map_err(at(&path))?;
        serde_json::from_slice(&bytes).map_err(|error| MemoryError::Json {
            path,
            what: error.to_string(),
        })
    }

    /// The contents of a file, such as `task.toml` or `round-1/plan.json`.
    ///
    /// # Errors
    /// A name that leads out of the episode, or what the system says.
    pub fn attachment(&self, name: &str) -> Result<Vec<u8>, MemoryError> {
        check_name(&self.id, name)?;
        let path = self.folder.join(name);
        fs::read(&path).map_err(at(&path))
    }

    /// Opens a file after holding it against its check sum; nothing of it is kept in memory.
    ///
    /// # Errors
    /// The same, or a file that is not what was written.
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

    /// The names of all its files, sorted, with `/` between folder and file.
    ///
    /// # Errors
    /// What the system says.
    pub fn files(&self) -> Result<Vec<String>, MemoryError> {
        files_in(&self.folder)
    }
}

/// The names of all files in a folder and the folders in it, sorted.
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

/// What a round's telemetry is called.
pub(super) fn telemetry_file(round: usize) -> String {
    format!("round-{round}.parquet")
}

/// What a round's observations are called.
pub(super) fn observations_file(round: usize) -> String {
    format!("round-{round}/observations.json")
}

/// Whether a file of this name stands in the episode and is not written by the store itself.
pub(super) fn check_name(id: &str, name: &str) -> Result<(), MemoryError> {
    if [RECORD_FILE, SUMS_FILE].contains(&name) {
        return Err(MemoryError::Name {
            id: id.to_owned(),
            name: name.to_owned(),
        });
    }
    check_place(id, name)
}

/// Whether a file of this name stands in the episode.
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
