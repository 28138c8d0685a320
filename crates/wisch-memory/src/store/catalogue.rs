//! The catalogue of a memory: from its tables on disk, and from the folders of what is not in them.

use super::error::{MemoryError, at};
use super::{Memory, remove_folder, sync_folder};
use crate::catalogue::{Catalogue, cache};
use std::collections::HashSet;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::PathBuf;

const CATALOGUE_FOLDER: &str = ".catalogue";
/// Says which of the folders beside it is in force.
const CURRENT_FILE: &str = "current";
/// Names of episodes that are in the tables and have been forgotten since, one a line.
const FORGOTTEN_FILE: &str = "forgotten";
/// When so many episodes have to be read one by one, the tables are written anew.
const MAX_MISSING: usize = 100;

/// Whether the tables are to be written anew.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tables {
    Good,
    /// They are broken, or much is missing.
    Stale,
}

impl Memory {
    /// The graphs of all its episodes.
    ///
    /// Tables on disk hold most of them. They are written anew when they are broken or much is missing; where
    /// that fails, as in a folder that may only be read, the answer is the same, if later.
    ///
    /// Episodes that cannot be read are named in [`Catalogue::left_out`].
    ///
    /// # Errors
    /// If the folder cannot be listed.
    pub fn catalogue(&self) -> Result<Catalogue, MemoryError> {
        let forgotten = self.forgotten()?;
        let ids = self.episodes()?;
        let (mut catalogue, mut tables) = match self.read_tables() {
            Some(catalogue) => (catalogue, Tables::Good),
            None => (Catalogue::default(), Tables::Stale),
        };
        let there: HashSet<&str> = ids.iter().map(String::as_str).collect();
        let stays = |id: &str| there.contains(id) && !forgotten.contains(id);
        if !catalogue.episodes().iter().all(|row| stays(&row.id)) {
            catalogue = catalogue.retain(|row| stays(&row.id));
        }
        let known = catalogue.episodes().len();
        for id in &ids {
            if catalogue.episode(id).is_some() {
                continue;
            }
            match self.episode(id).and_then(|episode| episode.record()) {
                Ok(record) => catalogue.push(&record),
                // Forgotten meanwhile.
                Err(_) if !self.folder().join(id).exists() => {}
                Err(error) => catalogue.leave_out(format!("episode {id}: {error}")),
            }
        }
        let read = catalogue.episodes().len() - known;
        if read > MAX_MISSING || forgotten.len() > MAX_MISSING {
            tables = Tables::Stale;
        }
        if tables == Tables::Stale && !catalogue.is_empty() {
            // Only to be faster next time.
            let _ = self.write_tables(&catalogue, &forgotten);
        }
        Ok(catalogue)
    }

    /// Writes down that an episode in the tables is no more. Only under the memory's lock.
    pub(super) fn note_forgotten(&self, id: &str) -> Result<(), MemoryError> {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let path = folder.join(FORGOTTEN_FILE);
        let written = OpenOptions::new()
            .append(true)
            .create(true)
            .open(&path)
            .and_then(|mut file| {
                file.write_all(format!("{id}\n").as_bytes())?;
                file.sync_all()
            });
        written.map_err(at(&path))
    }

    /// What is in the tables, but no more.
    fn forgotten(&self) -> Result<HashSet<String>, MemoryError> {
        let path = self.folder().join(CATALOGUE_FOLDER).join(FORGOTTEN_FILE);
        match fs::read(&path) {
            Ok(bytes) => {
                let text = String::from_utf8_lossy(&bytes);
                Ok(text.lines().map(str::to_owned).collect())
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(HashSet::new()),
            Err(error) => Err(at(&path)(error)),
        }
    }

    /// The number of the tables in force; 0 where there are none.
    fn current(&self) -> u64 {
        let path = self.folder().join(CATALOGUE_FOLDER).join(CURRENT_FILE);
        let text = fs::read_to_string(path).unwrap_or_default();
        text.trim().parse().unwrap_or(0)
    }

    fn read_tables(&self) -> Option<Catalogue> {
        let mut number = self.current();
        loop {
            if number == 0 {
                return None;
            }
            if let Ok(catalogue) = cache::read(&self.tables(number)) {
                return Some(catalogue);
            }
            // They may have been replaced while they were read; if not, they are broken.
            let now = self.current();
            if now == number {
                return None;
            }
            number = now;
        }
    }

    fn tables(&self, number: u64) -> PathBuf {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        folder.join(number.to_string())
    }

    /// Writes the tables anew, unless somebody else does.
    fn write_tables(
        &self,
        catalogue: &Catalogue,
        applied: &HashSet<String>,
    ) -> Result<(), MemoryError> {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let Some(_guard) = self.try_lock()? else {
            return Ok(());
        };
        // What was forgotten meanwhile is still in what is to be written.
        if self.forgotten()? != *applied {
            return Ok(());
        }
        let current = self.current();
        self.remove_old_tables(current)?;
        let number = current + 1;
        let new = self.tables(number);
        fs::create_dir_all(&new).map_err(at(&new))?;
        cache::write(catalogue, &new).map_err(|error| at(&new)(io::Error::other(error)))?;
        sync_folder(&new)?;
        // Only then are they in force, at once.
        let next = folder.join("next");
        let written = File::create(&next).and_then(|mut file| {
            file.write_all(number.to_string().as_bytes())?;
            file.sync_all()
        });
        written.map_err(at(&next))?;
        let place = folder.join(CURRENT_FILE);
        fs::rename(&next, &place).map_err(at(&place))?;
        sync_folder(&folder)?;
        // Those names are not in the new tables. Killed before this, the episodes are read one by one.
        super::remove_file(&folder.join(FORGOTTEN_FILE))
    }

    /// Removes all tables but those in force, which somebody may be reading.
    fn remove_old_tables(&self, current: u64) -> Result<(), MemoryError> {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        for entry in fs::read_dir(&folder).map_err(at(&folder))? {
            let path = entry.map_err(at(&folder))?.path();
            let number = path
                .file_name()
                .and_then(|name| name.to_str()?.parse::<u64>().ok());
            if number.is_some_and(|number| number != current) {
                remove_folder(&path)?;
            }
        }
        Ok(())
    }
}
