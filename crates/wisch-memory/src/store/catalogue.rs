//! The catalogue of a memory: from its tables on disk, and from the folders of episodes that the tables lack.

use super::error::{MemoryError, at};
use super::{MAX_ID_LEN, Memory, RECORD_FILE, is_id, remove_folder, sync_folder};
use crate::catalogue::{Catalogue, cache};
use crate::statements::append;
use std::collections::HashSet;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::SystemTime;

const CATALOGUE_FOLDER: &str = ".catalogue";
/// File that names the current folder of tables.
const CURRENT_FILE: &str = "current";
/// File with the names of deleted episodes that are still in the tables, one per line.
const FORGOTTEN_FILE: &str = "forgotten";
/// Number of episodes outside the tables above which the tables are rewritten.
const MAX_MISSING: usize = 100;

/// Whether the tables must be rewritten.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tables {
    Good,
    /// The tables are damaged, or lack many episodes.
    Stale,
}

impl Memory {
    /// Returns the graphs of all its episodes.
    ///
    /// Tables on disk hold most of them. The tables are rewritten if they are damaged or lack many episodes. If that
    /// fails, for example in a read-only folder, the result is the same but slower.
    ///
    /// [`Catalogue::omitted_episodes`] lists episodes that cannot be read.
    ///
    /// # Errors
    /// If the folder cannot be listed.
    pub fn catalogue(&self) -> Result<Catalogue, MemoryError> {
        // Before anything is read: what changes while it is read is read again by the next call.
        let (begun, written) = (SystemTime::now(), self.time_of_tables());
        let forgotten = self.read_forgotten()?;
        let ids = self.episodes()?;
        let (mut catalogue, mut tables) = match self.read_tables() {
            Some(catalogue) => (catalogue, Tables::Good),
            None => (Catalogue::default(), Tables::Stale),
        };
        let there: HashSet<&str> = ids.iter().map(String::as_str).collect();
        let changed: HashSet<String> = (catalogue.episodes().iter())
            .filter(|row| there.contains(row.id.as_str()) && !forgotten.contains(&row.id))
            .filter(|row| self.has_changed(&row.id, written))
            .map(|row| row.id.clone())
            .collect();
        // Tables that are written now are older than a record from the future, and would be written by every call.
        let is_past = |id: &String| self.time_of_record(id).is_none_or(|time| time <= begun);
        if changed.iter().any(is_past) {
            tables = Tables::Stale;
        }
        let stays =
            |id: &str| there.contains(id) && !forgotten.contains(id) && !changed.contains(id);
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
                // Deleted meanwhile.
                Err(_) if !self.folder().join(id).exists() => {}
                Err(error) => catalogue.leave_out(format!("episode {id}: {error}")),
            }
        }
        for name in self.ignored_episodes()? {
            catalogue.leave_out(name);
        }
        let read = catalogue.episodes().len() - known;
        if read > MAX_MISSING || forgotten.len() > MAX_MISSING {
            tables = Tables::Stale;
        }
        if tables == Tables::Stale && !catalogue.is_empty() {
            // A failure only makes the next call slower.
            let _ = self.write_tables(&catalogue, &forgotten, begun);
        }
        Ok(catalogue)
    }

    /// Returns a sentence for each folder that holds the record of an episode but whose name is not
    /// a valid name of an episode; such folders are ignored.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn ignored_episodes(&self) -> Result<Vec<String>, MemoryError> {
        let mut ignored = Vec::new();
        for entry in fs::read_dir(self.folder()).map_err(at(self.folder()))? {
            let name = entry.map_err(at(self.folder()))?.file_name();
            let text = name.to_string_lossy();
            let is_hidden = text.starts_with('.');
            if is_hidden || is_id(&text) || !self.folder().join(&name).join(RECORD_FILE).is_file() {
                continue;
            }
            ignored.push(format!(
                "folder {text:?}: it holds an episode, but its name is none (letters a to z, digits and \"-\", at most {MAX_ID_LEN}); rename it"
            ));
        }
        ignored.sort_unstable();
        Ok(ignored)
    }

    /// Time at which the tables were written; `None` without tables.
    fn time_of_tables(&self) -> Option<SystemTime> {
        let current = self.folder().join(CATALOGUE_FOLDER).join(CURRENT_FILE);
        fs::metadata(current).and_then(|file| file.modified()).ok()
    }

    /// Time at which the record of an episode was written; `None` if it is missing.
    fn time_of_record(&self, id: &str) -> Option<SystemTime> {
        let record = fs::metadata(self.folder().join(id).join(RECORD_FILE));
        record.and_then(|file| file.modified()).ok()
    }

    /// Whether the record of an episode is missing, or not older than the tables.
    fn has_changed(&self, id: &str, tables: Option<SystemTime>) -> bool {
        let time = self.time_of_record(id);
        time.is_none() || time >= tables
    }

    /// Records that an episode in the tables was deleted. The caller must hold the memory's lock.
    pub(super) fn note_forgotten(&self, id: &str) -> Result<(), MemoryError> {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let path = folder.join(FORGOTTEN_FILE);
        append(&path, &format!("{id}\n")).map_err(at(&path))
    }

    /// Names of deleted episodes that are still in the tables.
    fn read_forgotten(&self) -> Result<HashSet<String>, MemoryError> {
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

    /// Number of the current tables; 0 without tables.
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
            // They may have been replaced while they were read; if not, they are damaged.
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

    /// Rewrites the tables, unless another process does.
    fn write_tables(
        &self,
        catalogue: &Catalogue,
        applied: &HashSet<String>,
        begun: SystemTime,
    ) -> Result<(), MemoryError> {
        let folder = self.folder().join(CATALOGUE_FOLDER);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let Some(_guard) = self.try_lock()? else {
            return Ok(());
        };
        // An episode that was deleted meanwhile is still in the data to be written.
        if self.read_forgotten()? != *applied {
            return Ok(());
        }
        let current = self.current();
        self.remove_old_tables(current)?;
        let number = current + 1;
        let new = self.tables(number);
        fs::create_dir_all(&new).map_err(at(&new))?;
        cache::write(catalogue, &new).map_err(|error| at(&new)(io::Error::other(error)))?;
        sync_folder(&new)?;
        // From here on, the new tables are current.
        let next = folder.join("next");
        let written = File::create(&next).and_then(|mut file| {
            file.write_all(number.to_string().as_bytes())?;
            file.set_modified(begun)?;
            file.sync_all()
        });
        written.map_err(at(&next))?;
        let place = folder.join(CURRENT_FILE);
        fs::rename(&next, &place).map_err(at(&place))?;
        sync_folder(&folder)?;
        // The new tables lack these names. If the program is killed before this line, episodes are read one by one.
        super::remove_file(&folder.join(FORGOTTEN_FILE))
    }

    /// Removes all tables except the current ones, which another process may be reading.
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
