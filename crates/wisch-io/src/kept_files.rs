//! Copies of the files that a task file names, kept in an episode or beside the checkpoints of a run.

use crate::assets::read;
use crate::digest::FileDigest;
use crate::error::Error;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path};
use std::sync::Arc;

/// File that lists the copies.
const LIST_FILE: &str = "task-files.json";
/// Folder of the copies.
const FOLDER: &str = "task-files";

/// Contents of the files that a task file names, by their paths in it: meshes, particles, images.
///
/// ```
/// use wisch_io::KeptFiles;
/// let folder = tempfile::tempdir()?;
/// let mut kept = KeptFiles::default();
/// kept.add("parts/door.ply", b"ply");
/// kept.write_to(folder.path())?;
/// let read = KeptFiles::read_from(folder.path())?;
/// assert_eq!(read.get("parts/door.ply"), Some(&b"ply"[..]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct KeptFiles(BTreeMap<String, Arc<[u8]>>);

/// A file that is not as it was when a copy of it was kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChangedFile {
    /// Its path in the task file.
    pub path: String,
    /// Digest of the copy.
    pub kept: FileDigest,
    /// Digest of the file, or why it cannot be read.
    pub found: Result<FileDigest, String>,
}

/// An entry of the list.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    /// Path of the copy, relative to the list.
    file: String,
    digest: String,
}

impl KeptFiles {
    /// Adds the contents of a file. `path`: as the task file states it.
    pub fn add(&mut self, path: &str, contents: &[u8]) {
        self.0.insert(path.to_owned(), contents.into());
    }

    /// Returns the contents of a file by its path in the task file.
    pub fn get(&self, path: &str) -> Option<&[u8]> {
        self.0.get(path).map(AsRef::as_ref)
    }

    /// Returns the names and contents of the files that hold the copies and their list; none without copies.
    pub fn to_files(&self) -> Vec<(String, Arc<[u8]>)> {
        if self.0.is_empty() {
            return Vec::new();
        }
        let names = (1..).zip(self.0.keys()).map(|(number, path)| {
            let ending = Path::new(path)
                .extension()
                .and_then(|ending| ending.to_str());
            let ending = ending.filter(|ending| ending.chars().all(|c| c.is_ascii_alphanumeric()));
            match ending {
                Some(ending) => format!("{FOLDER}/{number}.{ending}"),
                None => format!("{FOLDER}/{number}"),
            }
        });
        let names: Vec<String> = names.collect();
        let list: BTreeMap<&String, Entry> = (self.0.iter().zip(&names))
            .map(|((path, contents), name)| {
                let entry = Entry {
                    file: name.clone(),
                    digest: FileDigest::from_contents(contents).to_string(),
                };
                (path, entry)
            })
            .collect();
        // Texts always serialise to JSON.
        let list = serde_json::to_vec_pretty(&list).unwrap_or_default();
        let copies = names.into_iter().zip(self.0.values().cloned());
        copies
            .chain([(LIST_FILE.to_owned(), list.into())])
            .collect()
    }

    /// Writes the copies and their list to a folder.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write_to(&self, folder: &Path) -> Result<(), Error> {
        for (name, contents) in self.to_files() {
            let path = folder.join(name);
            let parent = path.parent().unwrap_or(folder);
            fs::create_dir_all(parent).map_err(|error| Error::unusable(parent, error))?;
            fs::write(&path, contents).map_err(|error| Error::unusable(&path, error))?;
        }
        Ok(())
    }

    /// Reads the copies of a folder; none if it has no list, as episodes of earlier versions.
    ///
    /// # Errors
    /// If the list or a copy cannot be read, or a copy is not as it was written.
    pub fn read_from(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(LIST_FILE);
        if !path.is_file() {
            return Ok(Self::default());
        }
        let list: BTreeMap<String, Entry> =
            serde_json::from_slice(&read(&path)?).map_err(|error| Error::unusable(&path, error))?;
        let mut kept = Self::default();
        for (named, entry) in list {
            let copy = Path::new(&entry.file);
            if !copy
                .components()
                .all(|part| matches!(part, Component::Normal(_)))
            {
                let problem = format!("{:?} leads out of the folder", entry.file);
                return Err(Error::unusable(&path, problem));
            }
            let copy = folder.join(copy);
            let contents = read(&copy)?;
            let found = FileDigest::from_contents(&contents).to_string();
            if found != entry.digest {
                let written = entry.digest;
                let problem = format!(
                    "the copy of {named:?} has the digest {found}, but was written with {written}"
                );
                return Err(Error::unusable(&copy, problem));
            }
            kept.add(&named, &contents);
        }
        Ok(kept)
    }

    /// Lists the files that are not as they were when the copies were kept. `files`: reads a file by its path in the task
    /// file.
    pub fn find_changes(
        &self,
        files: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Vec<ChangedFile> {
        let changed = self.0.iter().filter_map(|(path, contents)| {
            let kept = FileDigest::from_contents(contents);
            let found = files(path).map(|contents| FileDigest::from_contents(&contents));
            (found != Ok(kept)).then(|| ChangedFile {
                path: path.clone(),
                kept,
                found,
            })
        });
        changed.collect()
    }
}
